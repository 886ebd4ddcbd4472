"""What tests of one nodelet, loaded as /stereo/matcher, share."""
import unittest

import rospy
from dynamic_reconfigure.client import Client
from sensor_msgs.msg import Image, PointCloud2
from stereo_msgs.msg import DisparityImage
from stereo_sgmp.msg import Priors, Statistics
from visualization_msgs.msg import MarkerArray

import stereo_rig as rig

OUTPUTS = {"disparity": DisparityImage, "points2": PointCloud2, "depth": Image,
           "confidence": Image, "error_disparity": Image, "error_depth": Image,
           "disparity_color": Image, "confidence_color": Image, "priors_color": Image,
           "disparity_baseline": DisparityImage, "disparity_baseline_color": Image,
           "priors": Priors, "priors_markers": MarkerArray, "statistics": Statistics}


class NodeletCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.camera = rig.Camera()
        cls.log = rig.LogListener()
        cls.log.wait_for_node("/stereo/manager")

    def setUp(self):
        self.listeners = {}

    def tearDown(self):
        for listener in self.listeners.values():
            listener.close()
        self.camera.wait_for_matcher(connected=False)

    def listen(self, *topics):
        for topic in topics:
            self.listeners[topic] = rig.Listener("/stereo/" + topic, OUTPUTS[topic])
        self.camera.wait_for_matcher()
        rig.match_first(self.camera, self.listeners.values())

    def match(self, frame):
        """Sends a frame, returns what comes out by topic."""
        self.camera.send(frame)
        stamp = frame.left.header.stamp
        return {topic: listener.wait_for(stamp) for topic, listener in self.listeners.items()}

    def match_good_frame(self):
        results = self.match(self.camera.next_frame())
        rig.check_disparity(self, results["disparity"])

    def assert_same_frame(self, header, other):
        self.assertEqual((header.stamp, header.frame_id), (other.stamp, other.frame_id))

    def reconfigurer(self):
        """A client, and the configuration, which is restored at the end of the test."""
        client = Client("/stereo/matcher", timeout=rig.TIMEOUT)
        before = client.update_configuration({})

        def restore():
            client.update_configuration(before)
            client.close()
        self.addCleanup(restore)
        return client, before

    def reconfigure(self, **values):
        client, _ = self.reconfigurer()
        return client.update_configuration(values)
