#!/usr/bin/python3
"""stereo_image_proc's nodelets and this package's on one bag of raw images, behind image_proc."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from PIL import Image as Picture
import rosbag
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, Image, PointCloud2
from stereo_msgs.msg import DisparityImage

import stereo_rig as rig

WIDTH, HEIGHT, DISPARITIES = 480, 320, 64
INPUTS = {"left/image_raw": Image, "left/camera_info": CameraInfo,
          "right/image_raw": Image, "right/camera_info": CameraInfo}
OUTPUTS = {"/stereo/disparity": DisparityImage, "/stereo/points2": PointCloud2,
           "/stereo/points2_of_stereo_image_proc": PointCloud2,
           "/reference/disparity": DisparityImage, "/reference/points2": PointCloud2}


def read_pfm(path):
    with open(path, "rb") as file:
        file.readline()
        width, height = (int(word) for word in file.readline().split())
        kind = "<f4" if float(file.readline()) < 0 else ">f4"
        return np.frombuffer(file.read(), kind).reshape(height, width)[::-1]


def xyz(cloud):
    offsets = {field.name: field.offset for field in cloud.fields}
    layout = np.dtype({"names": ["x", "y", "z"], "formats": ["<f4"] * 3,
                       "offsets": [offsets[name] for name in ("x", "y", "z")],
                       "itemsize": cloud.point_step})
    points = np.frombuffer(cloud.data, layout).reshape(cloud.height, cloud.width)
    return np.stack([points[name] for name in ("x", "y", "z")], axis=2)


def colors(cloud):
    offset = {field.name: field.offset for field in cloud.fields}["rgb"]
    data = np.frombuffer(cloud.data, np.uint8)
    return data.reshape(cloud.height, cloud.width, cloud.point_step)[:, :, offset:offset + 3]


def is_gray(cloud):
    """As without a colour image in time."""
    b, g, r = np.moveaxis(colors(cloud), 2, 0)
    return (b == g).all() and (g == r).all()


def is_valid(disparity_message):
    """As consumers decide it."""
    disparity = rig.disparity_array(disparity_message)
    return ((disparity > disparity_message.min_disparity) &
            (disparity < disparity_message.max_disparity))


class DropInTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.mkdtemp()
        try:
            scene, bag = os.path.join(folder, "scene"), os.path.join(folder, "scene.bag")
            subprocess.check_call([rig.program("stereo_sgmp", "render_scene"), "room", scene,
                                   "--width", str(WIDTH), "--height", str(HEIGHT),
                                   "--disparities", str(DISPARITIES)])
            subprocess.check_call([rig.program("stereo_sgmp", "make_bag"), bag, scene, "--raw",
                                   "--frame-id", rig.FRAME_ID])
            cls.truth = read_pfm(os.path.join(scene, "disp0GT.pfm"))
            # Seen by both cameras: what the right one does not see has no match.
            cls.seen = np.array(Picture.open(os.path.join(scene, "mask0nocc.png"))) == 255
            with rosbag.Bag(bag) as file:
                cls.inputs = {topic: message for topic, message, _ in file.read_messages()}
        finally:
            shutil.rmtree(folder)
        cls.outputs = cls.match()

    @classmethod
    def match(cls):
        """Sends the frame of the bag, with growing stamps, until all outputs have one of it."""
        publishers = {topic: rospy.Publisher("/stereo/" + topic, kind, queue_size=5)
                      for topic, kind in INPUTS.items()}
        listeners = {topic: rig.Listener(topic, kind) for topic, kind in OUTPUTS.items()}
        stamp = rospy.Time(1000)
        sent = []

        def is_complete(stamp):
            return (all(listener.has(stamp) for listener in listeners.values()) and
                    not is_gray(listeners["/stereo/points2"].wait_for(stamp)))

        def complete():
            return next((stamp for stamp in sent if is_complete(stamp)), None)

        def send_and_look():
            nonlocal stamp
            stamp += rospy.Duration.from_sec(0.1)
            sent.append(stamp)
            for topic, publisher in publishers.items():
                message = cls.inputs["/stereo/" + topic]
                message.header.stamp = stamp
                publisher.publish(message)
            rospy.sleep(0.2)
            return complete()
        rig.wait_until(send_and_look, "some outputs are missing")
        outputs = {topic: listener.wait_for(complete()) for topic, listener in listeners.items()}
        for listener in listeners.values():
            listener.close()
        return outputs

    def pair(self, topic):
        return self.outputs["/stereo/" + topic], self.outputs["/reference/" + topic]

    def test_disparity_message(self):
        ours, theirs = self.pair("disparity")
        for field in ("header.stamp", "header.frame_id", "image.header.stamp",
                      "image.header.frame_id", "image.width", "image.height", "image.encoding",
                      "image.step", "image.is_bigendian"):
            values = [ours, theirs]
            for name in field.split("."):
                values = [getattr(value, name) for value in values]
            self.assertEqual(*values, field)
        self.assertAlmostEqual(ours.f, theirs.f, places=3)
        self.assertAlmostEqual(ours.T, theirs.T, places=6)
        self.assertAlmostEqual(ours.delta_d, theirs.delta_d, places=6)

    def test_limits(self):
        """The same range, but for the step by which the limits lie outside of all disparities."""
        ours, theirs = self.pair("disparity")
        self.assertAlmostEqual(ours.min_disparity, theirs.min_disparity, delta=1)
        self.assertAlmostEqual(ours.max_disparity, theirs.max_disparity, delta=1)
        for message in (ours, theirs):
            self.assertGreater(is_valid(message).mean(), 0.5)

    def test_valid_window(self):
        """Within the image, and around all valid pixels."""
        ours, _ = self.pair("disparity")
        window = ours.valid_window
        self.assertLessEqual(window.x_offset + window.width, WIDTH)
        self.assertLessEqual(window.y_offset + window.height, HEIGHT)
        rows, columns = np.nonzero(is_valid(ours))
        self.assertGreaterEqual(columns.min(), window.x_offset)
        self.assertLess(columns.max(), window.x_offset + window.width)
        self.assertGreaterEqual(rows.min(), window.y_offset)
        self.assertLess(rows.max(), window.y_offset + window.height)

    def test_cloud_layout(self):
        ours, theirs = self.pair("points2")
        for field in ("width", "height", "is_bigendian", "is_dense"):
            self.assertEqual(getattr(ours, field), getattr(theirs, field), field)
        self.assertEqual(ours.header.stamp, theirs.header.stamp)
        self.assertEqual(ours.header.frame_id, theirs.header.frame_id)
        our_fields = {f.name: (f.offset, f.datatype, f.count) for f in ours.fields}
        for field in theirs.fields:
            self.assertEqual(our_fields[field.name][1:], (field.datatype, field.count), field.name)
        for axis in ("x", "y", "z"):
            self.assertEqual(our_fields[axis][0], {"x": 0, "y": 4, "z": 8}[axis])

    def test_their_cloud_of_our_disparities_is_our_cloud(self):
        ours = self.outputs["/stereo/points2"]
        theirs = self.outputs["/stereo/points2_of_stereo_image_proc"]
        seen = [np.isfinite(xyz(cloud)[:, :, 2]) for cloud in (ours, theirs)]
        np.testing.assert_array_equal(*seen)
        np.testing.assert_allclose(xyz(ours)[seen[0]], xyz(theirs)[seen[0]], rtol=1e-4, atol=1e-5)
        np.testing.assert_array_equal(colors(ours)[seen[0]], colors(theirs)[seen[0]])

    def score(self, message):
        """Shares of the pixels: with a disparity, of those that are wrong, and of all that are right."""
        valid = is_valid(message)[self.seen]
        right = np.abs(rig.disparity_array(message) - self.truth)[self.seen] <= 1
        return valid.mean(), (~right)[valid].mean(), (valid & right).mean()

    def test_accuracy_and_density(self):
        (density, wrong, right), (their_density, their_wrong, their_right) = (
            self.score(message) for message in self.pair("disparity"))
        print("density %.3f, wrong %.4f, right %.3f; stereo_image_proc: %.3f, %.4f, %.3f" %
              (density, wrong, right, their_density, their_wrong, their_right))
        self.assertGreater(density, their_density)
        self.assertLess(wrong, their_wrong)
        self.assertGreater(right, their_right)


if __name__ == "__main__":
    rospy.init_node("drop_in_test")
    rostest.rosrun("stereo_sgmp", "drop_in_test", DropInTest, sys.argv)
