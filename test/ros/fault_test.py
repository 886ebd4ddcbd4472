#!/usr/bin/python3
"""What goes wrong in robots while the nodelet runs: the output comes back by itself."""
import ast
import io
import os
import random
import socket
import sys
import unittest
import xmlrpc.client

import rosgraph
import rosgraph.network
import rospy
import rostest
from dynamic_reconfigure.client import Client
from stereo_msgs.msg import DisparityImage
from stereo_sgmp.msg import Priors

import stereo_rig as rig


def open_files(pid):
    return len(os.listdir("/proc/%d/fd" % pid))


def connect_and_leave(node, topic):
    """As a listener of DisparityImage does, but faster than rospy."""
    service = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode(node))
    _, _, (_, host, port) = service.requestTopic(rospy.get_name(), topic, [["TCPROS"]])
    with socket.create_connection((host, port), rig.TIMEOUT) as connection:
        rosgraph.network.write_ros_handshake_header(
            connection, {"callerid": rospy.get_name(), "topic": topic,
                         "type": DisparityImage._type, "md5sum": DisparityImage._md5sum})
        rosgraph.network.read_ros_handshake_header(connection, io.BytesIO(), 4096)


def ends_of(parameter):
    """The extremes of a parameter of dynamic_reconfigure, or all of its choices."""
    if parameter["type"] == "bool":
        return [False, True]
    if parameter["type"] in ("int", "double"):
        return [parameter["min"], parameter["max"]]
    return [choice["value"] for choice in ast.literal_eval(parameter["edit_method"])["enum"]]


class FaultTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.camera = rig.Camera()
        cls.log = rig.LogListener()
        cls.log.wait_for_node("/stereo/manager")

    def setUp(self):
        self.listeners = []
        self.cameras = {self.camera}

    def tearDown(self):
        for listener in self.listeners:
            listener.close()
        for camera in self.cameras:
            camera.wait_for_matcher(connected=False)

    def listen(self, topic="/stereo/disparity", kind=DisparityImage, camera=None):
        camera = camera or self.camera
        listener = rig.Listener(topic, kind)
        self.listeners.append(listener)
        self.cameras.add(camera)
        camera.wait_for_matcher()
        rig.match_first(camera, [listener])
        return listener

    def match(self, listener, frame=None, camera=None):
        """Sends a frame and returns its disparity."""
        camera = camera or self.camera
        frame = frame or camera.next_frame()
        camera.send(frame)
        return listener.wait_for(frame.left.header.stamp)

    def test_a_camera_stops_and_comes_back(self):
        listener = self.listen()
        for side in ("right", "left"):
            self.match(listener)
            sentence = ("nothing arrives on %s/image_rect, %s/camera_info while the other inputs "
                        "do; expected all four of the pair" % (side, side))

            def send_one_side():
                self.camera.send(self.camera.next_frame(), without=[side])
                return self.log.has(sentence)
            rig.wait_until(send_one_side, "nobody says '%s'" % sentence)
            rig.check_disparity(self, self.match(listener))

    def test_a_third_of_the_images_is_lost(self):
        listener = self.listen()
        chance = random.Random(1)
        lost = 0
        for _ in range(60):
            if chance.random() < 0.3:
                self.camera.send(self.camera.next_frame(), without=["right/image_rect"])
                lost += 1
            else:
                rig.check_disparity(self, self.match(listener))
        self.assertGreater(lost, 10)

    def test_calibration_changes(self):
        listener = self.listen()
        self.match(listener)
        frame = self.camera.next_frame()
        for info in (frame.left_info, frame.right_info):
            info.P = [1.1 * entry for entry in info.P]
            info.P[2] -= 16.0
        message = self.match(listener, frame)
        self.assertAlmostEqual(message.f, 1.1 * rig.FOCAL_LENGTH, places=3)
        self.assertAlmostEqual(message.T, rig.BASELINE, places=5)
        message = self.match(listener)
        self.assertAlmostEqual(message.f, rig.FOCAL_LENGTH, places=3)
        rig.check_disparity(self, message)

    def test_size_changes(self):
        listener = self.listen()
        for width, height in ((240, 200), (rig.WIDTH, rig.HEIGHT), (200, 160)):
            frame = self.camera.next_frame()
            frame.crop(width, height)
            message = self.match(listener, frame)
            self.assertEqual((message.image.width, message.image.height), (width, height))
            rig.check_disparity(self, message)
        rig.check_disparity(self, self.match(listener))

    def test_both_sides_differ_in_encoding(self):
        listener = self.listen()
        frame = self.camera.next_frame("mono16")
        frame.right = self.camera_image(frame, "bgr8")
        rig.check_disparity(self, self.match(listener, frame))

    def test_big_endian_images(self):
        listener = self.listen()
        frame = self.camera.next_frame("mono16")
        for image, gray in ((frame.left, 0), (frame.right, 1)):
            pixels = rig.encode(rig.make_pair()[gray], "mono16")
            image.data = pixels.astype(">u2").tobytes()
            image.is_bigendian = 1
        rig.check_disparity(self, self.match(listener, frame))

    @staticmethod
    def camera_image(frame, encoding):
        return rig.image_message(rig.encode(rig.make_pair()[1], encoding), encoding,
                                 frame.right.header.stamp)

    def test_clocks_that_are_far_apart(self):
        listener = self.listen()
        frame = self.camera.next_frame()
        for message in (frame.right, frame.right_info):
            message.header.stamp = rospy.Time(4294967295)
        self.camera.send(frame)
        # In each topic, the stamps after the odd one start afresh.
        message, = rig.match_first(self.camera, [listener])
        rig.check_disparity(self, message)

    def test_a_thousand_listeners_come_and_go(self):
        def come_and_go(times):
            for _ in range(times):
                connect_and_leave("/stereo/manager", "/stereo/disparity")
                self.camera.send(self.camera.next_frame())

        manager = rig.process_of("/stereo/manager")
        come_and_go(20)
        before = open_files(manager)
        come_and_go(980)
        self.camera.wait_for_matcher(connected=False)
        rig.check_disparity(self, self.match(self.listen()))
        self.assertLess(open_files(manager), before + 20)

    def test_storm_of_parameters(self):
        listener = self.listen()
        client = Client("/stereo/matcher", timeout=rig.TIMEOUT)
        before = client.update_configuration({})
        self.addCleanup(client.close)
        extremes = {parameter["name"]: ends_of(parameter)
                    for parameter in client.get_parameter_descriptions(timeout=rig.TIMEOUT)}
        chance = random.Random(2)
        choices = [lambda ends: ends[0], lambda ends: ends[-1]] + 28 * [chance.choice]
        for choose in choices:
            client.update_configuration({name: choose(ends) for name, ends in extremes.items()})
            self.camera.send(self.camera.next_frame())
        client.update_configuration(before)
        rig.check_disparity(self, self.match(listener))

    def test_two_cameras_in_one_manager(self):
        rear = rig.Camera("/rear")
        front_disparity = self.listen()
        rear_disparity = self.listen("/rear/disparity", camera=rear)
        rear_priors = self.listen("/rear/priors", Priors, camera=rear)
        for _ in range(10):
            frames = self.camera.next_frame(), rear.next_frame()
            self.camera.send(frames[0])
            rear.send(frames[1])
            front = front_disparity.wait_for(frames[0].left.header.stamp)
            behind = rear_disparity.wait_for(frames[1].left.header.stamp)
            rig.check_disparity(self, front)
            rig.check_disparity(self, behind)
            self.assertGreater(front.max_disparity, behind.max_disparity)
            self.assertEqual(rear_priors.wait_for(frames[1].left.header.stamp).variant, "sgm")


if __name__ == "__main__":
    rospy.init_node("fault_test")
    rostest.rosrun("stereo_sgmp", "fault_test", FaultTest, sys.argv)
