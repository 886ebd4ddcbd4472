#!/usr/bin/python3
"""The nodelet loaded, unloaded and loaded again, its presets, and the node of its own."""
import glob
import os
import signal
import subprocess
import sys
import unittest

import rosgraph
import roslaunch.config
import rospkg
import rospy
import rostest
import yaml
from stereo_msgs.msg import DisparityImage

import stereo_rig as rig

PRESETS = os.path.join(rospkg.RosPack().get_path("stereo_sgmp"), "launch", "config")
IN_NAMESPACE = ["__ns:=/stereo", "__name:=matcher"]


def is_advertised():
    publishers, _, _ = rosgraph.Master("/reload_test").getSystemState()
    return any(topic == "/stereo/disparity" for topic, _ in publishers)


def parameters_of_launch(*arguments):
    """What stereo_sgmp.launch with these arguments sets for the nodelet."""
    launch_file = os.path.join(rospkg.RosPack().get_path("stereo_sgmp"), "launch",
                               "stereo_sgmp.launch")
    config = roslaunch.config.load_config_default([(launch_file, list(arguments))], None)
    return {name[len("/disparity/"):]: parameter.value
            for name, parameter in config.params.items() if name.startswith("/disparity/")}


class ReloadTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.camera = rig.Camera()
        cls.log = rig.LogListener()
        cls.log.wait_for_node("/stereo/manager")

    def setUp(self):
        # What dynamic_reconfigure left of the test before.
        if rospy.has_param("/stereo/matcher"):
            rospy.delete_param("/stereo/matcher")
        rospy.set_param("/stereo/matcher/num_disparities", 48)

    def start(self, *command):
        self.assertFalse(is_advertised())
        process = subprocess.Popen(list(command) + IN_NAMESPACE)
        self.addCleanup(self.stop_if_running, process)
        rig.wait_until(is_advertised, "the disparity is not advertised")
        return process

    def stop(self, process):
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(rig.TIMEOUT), 0)
        rig.wait_until(lambda: not is_advertised(), "the disparity is still advertised")

    def stop_if_running(self, process):
        if process.poll() is None:
            self.stop(process)

    def check_works(self, baseline=rig.BASELINE):
        def frame():
            frame = self.camera.next_frame()
            frame.right_info.P[3] = -rig.FOCAL_LENGTH * baseline
            return frame
        listener = rig.Listener("/stereo/disparity", DisparityImage)
        self.check_matches(listener, frame)
        listener.close()

    def check_matches(self, listener, make_frame=None):
        self.camera.wait_for_matcher()
        message, = rig.match_first(self.camera, [listener], make_frame)
        rig.check_disparity(self, message)

    def check_preset(self, path):
        """It loads without complaint, says what it should, and matches."""
        rospy.delete_param("/stereo/matcher")
        name = os.path.splitext(os.path.basename(path))[0]
        for parameter, value in parameters_of_launch("preset:=" + name).items():
            rospy.set_param("/stereo/matcher/" + parameter, value)
        with open(path) as file:
            wanted = yaml.safe_load(file)
        heard = self.log.count()
        process = self.load()
        # Puts the board, 2.7 m away, and the wall into the depths of every preset.
        self.check_works(baseline=0.3)
        wanted.pop("preset")
        for name, value in wanted.items():
            for part, of_part in (value.items() if isinstance(value, dict) else [("", value)]):
                name_there = name + ("_" + part if part else "")
                self.assertEqual(rospy.get_param("/stereo/matcher/" + name_there), of_part,
                                 name_there)
        for text in self.log.since(heard):
            self.assertNotIn("parameter", text)
        self.stop(process)

    def test_presets(self):
        paths = glob.glob(os.path.join(PRESETS, "*.yaml"))
        names = {os.path.splitext(os.path.basename(path))[0] for path in paths}
        self.assertEqual(names, {"default", "quality", "paper", "indoor", "outdoor", "driving",
                                 "high_resolution", "low_power"})
        for path in sorted(paths):
            print(path)  # rosunit swallows what subTest says
            self.check_preset(path)

    def load(self):
        return self.start(rig.program("nodelet", "nodelet"), "load", "stereo_sgmp/stereo_sgmp",
                          "/stereo/manager")

    def test_reload(self):
        for _ in range(3):
            process = self.load()
            self.check_works()
            self.stop(process)

    def test_unload_with_listener_and_work(self):
        process = self.load()
        listener = rig.Listener("/stereo/disparity", DisparityImage)
        self.check_matches(listener)
        for _ in range(5):
            self.camera.send(self.camera.next_frame())
        self.stop(process)
        process = self.load()
        self.check_matches(listener)
        listener.close()
        self.stop(process)

    def test_node(self):
        process = self.start(rig.program("stereo_sgmp", "stereo_sgmp"))
        self.check_works()
        self.stop(process)

    def test_parameters(self):
        names = {"preset": "paper", "queue_size": 0, "disparity_range": 40, "uniqueness_ratio": 12,
                 "P1": 200, "P2": 800, "texture_threshold": 10, "disp12MaxDiff": 0, "alignment/mode": False, "prior/variant": "best",
                 "prior_variant": "gs",
                 "filter/speckle_range": 1000.0}
        for name, value in names.items():
            rospy.set_param("/stereo/matcher/" + name, value)
        process = self.load()
        # The last one that is written at the start, after dynamic_reconfigure's own defaults.
        rig.wait_until(
            lambda: rospy.get_param("/stereo/matcher/filter_speckle_range", 0) == 100,
            "filter/speckle_range is not clamped")
        for name, value in {"num_disparities": 40, "filter_uniqueness_ratio": 12.0,
                            "filter_lr_tolerance": -1.0, "alignment_mode": "off",
                            "prior_variant": "epi", "cost_kind": "ncc", "aggregation_p1": 100,
                            "filter_speckle_range": 100.0}.items():
            self.assertEqual(rospy.get_param("/stereo/matcher/" + name), value, name)
        for sentence in ("queue_size is 0; expected at least 1",
                         "ignored in /stereo/matcher: P1, P2, texture_threshold",
                         "a P2 / P1 of 4 would be aggregation/alpha 3",
                         "prior/variant is best; expected one of sgm, epi, epv, mw",
                         "prior/variant gs needs a given surface, which a stream does not have",
                         "filter/speckle_range is 1000; expected a number from 0 to 100 px"):
            self.log.wait_for(sentence)
        self.check_works()
        self.stop(process)


if __name__ == "__main__":
    rospy.init_node("reload_test")
    rostest.rosrun("stereo_sgmp", "reload_test", ReloadTest, sys.argv)
