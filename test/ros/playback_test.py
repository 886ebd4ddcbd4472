#!/usr/bin/python3
"""Bags made by make_bag, played through the launch files."""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np
import rosbag
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from stereo_msgs.msg import DisparityImage
from stereo_sgmp.msg import Priors

import stereo_rig as rig

FRAMES, START = 20, 100.0

CALIB = """cam0=[{f} 0 {cx0}; 0 {f} {cy}; 0 0 1]
cam1=[{f} 0 {cx1}; 0 {f} {cy}; 0 0 1]
doffs={doffs}
baseline={baseline}
width={width}
height={height}
ndisp=48
""".format(f=rig.FOCAL_LENGTH, cx0=rig.CX_LEFT, cx1=rig.CX_RIGHT, cy=rig.CY,
           doffs=rig.CX_RIGHT - rig.CX_LEFT, baseline=1000 * rig.BASELINE, width=rig.WIDTH,
           height=rig.HEIGHT)


def write_picture(path, gray):
    """A colour picture (binary PPM) in shades of orange, whose gray values vary with `gray`."""
    rgb = np.stack([gray, gray // 2 + 64, gray // 4], axis=2)
    with open(path, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (gray.shape[1], gray.shape[0]))
        file.write(rgb.tobytes())


def mosaic_of(message):
    """A bgr8 or rgb8 image as a sensor with a Bayer filter sees it."""
    pixels = np.frombuffer(message.data, np.uint8).reshape(message.height, message.width, 3)
    red, blue = (0, 2) if message.encoding == "rgb8" else (2, 0)
    mosaic = pixels[:, :, 1].copy()
    mosaic[::2, ::2] = pixels[::2, ::2, red]
    mosaic[1::2, 1::2] = pixels[1::2, 1::2, blue]
    return rig.image_message(mosaic, "bayer_rggb8", message.header.stamp,
                             message.header.frame_id)


def has_colour(messages):
    """Whether the latest cloud is as orange as the pictures."""
    if not messages:
        return False
    b, _, r = np.frombuffer(messages[-1].data, np.uint8).reshape(-1, 32)[:, 16:19].T
    return r.mean() > 2 * b.mean()


class Collector:
    """The messages of an output as they come."""

    def __init__(self, topic, kind):
        self._arrived = threading.Condition()
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, kind, self._add, queue_size=50)

    def _add(self, message):
        with self._arrived:
            self.messages.append(message)
            self._arrived.notify_all()

    def wait_until(self, condition):
        with self._arrived:
            return self._arrived.wait_for(lambda: condition(self.messages), 2 * rig.TIMEOUT)

    def close(self):
        self._subscriber.unregister()


class PlaybackTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        left, right = rig.make_pair()
        write_picture(cls.path("left.ppm"), left)
        write_picture(cls.path("right.ppm"), right)
        for name, text in (("calib.txt", CALIB),
                           ("options.yaml", "num_disparities: 48\nprior: {variant: epi}\n")):
            with open(cls.path(name), "w") as file:
                file.write(text)
        subprocess.check_call([rig.program("stereo_sgmp", "make_bag"), cls.path("pair.bag"),
                               "--left", cls.path("left.ppm"), "--right", cls.path("right.ppm"),
                               "--calib", cls.path("calib.txt"), "--frames", str(FRAMES),
                               "--rate", "10", "--start", str(START), "--raw",
                               "--frame-id", rig.FRAME_ID])

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def play(self, *arguments):
        process = subprocess.Popen(
            ["roslaunch", "stereo_sgmp", "demo.launch", "bag:=" + self.path("pair.bag"),
             "options:=" + self.path("options.yaml"), "loop:=true"] + list(arguments))

        def stop():
            process.send_signal(signal.SIGINT)
            process.wait(rig.TIMEOUT)
        self.addCleanup(stop)

    def collect(self, topic, kind):
        collector = Collector("/stereo/" + topic, kind)
        self.addCleanup(collector.close)
        return collector

    def test_demo(self):
        disparity = self.collect("disparity", DisparityImage)
        cloud = self.collect("points2", PointCloud2)
        priors = self.collect("priors", Priors)
        self.play("preset:=indoor")
        self.assertTrue(disparity.wait_until(len))
        rig.check_disparity(self, disparity.messages[0])
        self.assertEqual(rospy.get_param("/stereo/disparity/min_depth"), 0.4)
        self.assertAlmostEqual(disparity.messages[0].T, rig.BASELINE, places=5)
        self.assertEqual(disparity.messages[0].header.frame_id, rig.FRAME_ID)
        self.assertTrue(priors.wait_until(len))
        self.assertEqual(priors.messages[0].variant, "epi")
        self.assertTrue(cloud.wait_until(has_colour))

    def test_goes_on_when_the_bag_starts_again(self):
        disparity = self.collect("disparity", DisparityImage)
        self.play()

        def started_again(messages):
            stamps = [message.header.stamp for message in messages]
            return any(later < earlier for earlier, later in zip(stamps, stamps[1:]))
        self.assertTrue(disparity.wait_until(started_again))
        rig.check_disparity(self, disparity.messages[-1])

    def test_rectifies(self):
        """With the raw images alone: what image_proc makes of them is the same pair."""
        filtered = self.path("raw.bag")
        subprocess.check_call(["rosbag", "filter", self.path("pair.bag"), filtered,
                               "'rect' not in topic"])
        disparity = self.collect("disparity", DisparityImage)
        self.play("rectify:=true", "bag:=" + filtered)
        self.assertTrue(disparity.wait_until(len))
        rig.check_disparity(self, disparity.messages[0])

    def test_a_pair_plays_as_a_camera_and_its_latency_is_measured(self):
        # Pictures are told apart by their content, not by their names.
        shutil.copy(self.path("left.ppm"), self.path("im0.png"))
        shutil.copy(self.path("right.ppm"), self.path("im1.png"))
        camera = subprocess.Popen([rig.program("stereo_sgmp", "play_pair"), self.folder,
                                   "--rate", "20", "--namespace", "desk"])
        self.addCleanup(camera.wait)
        self.addCleanup(camera.terminate)
        topics = ["/desk/left/image_rect", "/desk/left/image_rect_color",
                  "/desk/right/camera_info"]
        lines = subprocess.check_output(
            [rig.program("stereo_sgmp", "message_latency"), "--seconds", "2", "--warm-up", "0.2"]
            + topics, text=True).splitlines()[1:]
        self.assertEqual([line.partition(": ")[0] for line in lines], topics)
        for line in lines:
            rate, median, most = (float(number)
                                  for number in re.findall(r"(-?[\d.]+) (?:Hz|ms)", line))
            self.assertAlmostEqual(rate, 20.0, delta=2.0)
            self.assertGreater(median, 0.0)
            self.assertLess(median, 500.0)
            self.assertGreaterEqual(most, median)
        left = rospy.wait_for_message(topics[1], Image, rig.TIMEOUT)
        with open(self.path("left.ppm"), "rb") as file:
            rgb = np.frombuffer(file.read()[-3 * rig.WIDTH * rig.HEIGHT:], np.uint8).reshape(-1, 3)
        self.assertEqual(left.data, rgb[:, ::-1].tobytes())
        info = rospy.wait_for_message(topics[2], CameraInfo, rig.TIMEOUT)
        self.assertAlmostEqual(-info.P[3] / info.P[0], rig.BASELINE, places=5)

    def test_a_topic_without_messages_is_named(self):
        tool = subprocess.run(
            [rig.program("stereo_sgmp", "message_latency"), "/nobody", "--patience", "0.2"],
            stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(tool.returncode, 1)
        self.assertIn("nothing arrived on /nobody within 0.2 s", tool.stderr)

    def test_bayer_images(self):
        mosaics = self.path("bayer.bag")
        with rosbag.Bag(self.path("pair.bag")) as bag, rosbag.Bag(mosaics, "w") as out:
            for topic, message, time in bag:
                if topic.endswith("image_raw"):
                    message = mosaic_of(message)
                if "rect" not in topic:
                    out.write(topic, message, time)
        disparity = self.collect("disparity", DisparityImage)
        cloud = self.collect("points2", PointCloud2)
        self.play("rectify:=true", "bag:=" + mosaics)
        self.assertTrue(disparity.wait_until(len))
        rig.check_disparity(self, disparity.messages[0])
        self.assertTrue(cloud.wait_until(has_colour))


if __name__ == "__main__":
    rospy.init_node("playback_test")
    rostest.rosrun("stereo_sgmp", "playback_test", PlaybackTest, sys.argv)
