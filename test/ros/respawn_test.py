#!/usr/bin/python3
"""A manager that is killed: with respawn, as the launch file offers it, the output comes back."""
import os
import signal
import subprocess
import sys
import unittest

import rospy
import rostest
from stereo_msgs.msg import DisparityImage

import stereo_rig as rig


class RespawnTest(unittest.TestCase):
    def start(self):
        launch = subprocess.Popen(["roslaunch", "stereo_sgmp", "stereo_sgmp.launch",
                                   "rectify:=false", "respawn:=true"],
                                  env=dict(os.environ, ROS_NAMESPACE="/stereo"))

        def stop():
            launch.send_signal(signal.SIGINT)
            launch.wait(rig.TIMEOUT)
        self.addCleanup(stop)

    def test_manager_is_killed(self):
        camera = rig.Camera()
        listener = rig.Listener("/stereo/disparity", DisparityImage)

        def check_works():
            camera.wait_for_matcher()
            message, = rig.match_first(camera, [listener])
            rig.check_disparity(self, message)

        def manager():
            return rig.process_of(rig.node_like("/stereo_sgmp_manager"))
        self.start()
        check_works()
        killed = manager()
        os.kill(killed, signal.SIGKILL)
        check_works()
        self.assertNotEqual(manager(), killed)


if __name__ == "__main__":
    rospy.init_node("respawn_test")
    rostest.rosrun("stereo_sgmp", "respawn_test", RespawnTest, sys.argv)
