#!/usr/bin/python3
"""Camera, matcher and listener on three hosts: network namespaces that a bridge joins."""
import os
import socket
import subprocess
import sys
import unittest

import rospy
import rostest
from stereo_msgs.msg import DisparityImage

import stereo_rig as rig

HOSTS = {"camera": "10.77.0.1", "matcher": "10.77.0.2", "listener": "10.77.0.3"}
BRIDGE, ROUTER = "sgmp0", "10.77.0.254"
MASTER_PORT = 11977
FRAMES = 20


def ip(*arguments):
    subprocess.check_output(("ip",) + arguments, stderr=subprocess.STDOUT)


def name_of(host):
    return "%s-%s" % (BRIDGE, host)


def add_hosts():
    ip("link", "add", BRIDGE, "type", "bridge")
    ip("addr", "add", ROUTER + "/24", "dev", BRIDGE)
    ip("link", "set", BRIDGE, "up")
    for number, (host, address) in enumerate(HOSTS.items(), 1):
        space, cable = name_of(host), "%sv%d" % (BRIDGE, number)
        ip("netns", "add", space)
        ip("link", "add", cable, "type", "veth", "peer", "name", "eth0", "netns", space)
        ip("link", "set", cable, "master", BRIDGE, "up")
        for command in (("link", "set", "lo", "up"), ("link", "set", "eth0", "up"),
                        ("addr", "add", address + "/24", "dev", "eth0")):
            ip("-n", space, *command)


def remove_hosts():
    for command in [("netns", "del", name_of(host)) for host in HOSTS] + [("link", "del", BRIDGE)]:
        subprocess.call(("ip",) + command, stderr=subprocess.DEVNULL)


def run_camera():
    rospy.init_node("camera")
    camera = rig.Camera()
    while not rospy.is_shutdown():
        camera.send(camera.next_frame())
        rospy.sleep(0.1)


def run_listener():
    """Ends well when enough disparities came that are right."""
    rospy.init_node("listener")
    test = unittest.TestCase()
    for _ in range(FRAMES):
        message = rospy.wait_for_message("/stereo/disparity", DisparityImage, rig.TIMEOUT)
        rig.check_disparity(test, message)


class NetworkTest(unittest.TestCase):
    def setUp(self):
        remove_hosts()
        self.addCleanup(remove_hosts)
        try:
            add_hosts()
        except (OSError, subprocess.CalledProcessError) as error:
            self.skipTest("no network namespaces here: %s" % (getattr(error, "output", error)))

    def start(self, host, *command):
        environment = dict(os.environ, ROS_IP=HOSTS[host],
                           ROS_MASTER_URI="http://%s:%d" % (HOSTS["matcher"], MASTER_PORT))
        environment.pop("ROS_HOSTNAME", None)
        process = subprocess.Popen(("ip", "netns", "exec", name_of(host)) + command,
                                   env=environment)

        def stop():
            process.terminate()
            process.wait(rig.TIMEOUT)
        self.addCleanup(stop)
        return process

    def test_three_hosts(self):
        self.start("matcher", "roscore", "-p", str(MASTER_PORT))
        address = (HOSTS["matcher"], MASTER_PORT)
        rig.wait_until(lambda: answers(address), "no master")
        self.start("matcher", rig.program("stereo_sgmp", "stereo_sgmp"), "__ns:=/stereo",
                   "__name:=matcher", "_num_disparities:=48")
        self.start("camera", sys.executable, __file__, "camera")
        listener = self.start("listener", sys.executable, __file__, "listener")
        self.assertEqual(listener.wait(2 * rig.TIMEOUT), 0)


def answers(address):
    with socket.socket() as connection:
        connection.settimeout(1)
        return connection.connect_ex(address) == 0


if __name__ == "__main__":
    if sys.argv[1:2] == ["camera"]:
        run_camera()
    elif sys.argv[1:2] == ["listener"]:
        run_listener()
    else:
        rospy.init_node("network_test")
        rostest.rosrun("stereo_sgmp", "network_test", NetworkTest, sys.argv)
