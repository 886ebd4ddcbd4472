#!/usr/bin/python3
"""Latency, rate and processor time of stereo nodelets: compare.py SCENE LOG_FOLDER."""
import argparse
import collections
import contextlib
import os
import re
import subprocess
import sys
import time

import roslib.packages
import rosgraph
import rospy
import yaml

NAMESPACE = "/stereo"
PATIENCE = 30.0  # seconds until the topics are there
IDLE = 5.0       # seconds without listeners
TOPICS = ["disparity", "points2"]
DISPARITIES = 64

BLOCK_MATCHER, SEMI_GLOBAL = 0, 1  # of stereo_image_proc's stereo_algorithm


Nodelet = collections.namedtuple("Nodelet", "name type topic")


def stereo_image_proc(algorithm):
    """Its nodelets, and their parameters."""
    return ([Nodelet("disparity", "stereo_image_proc/disparity", "disparity"),
             Nodelet("point_cloud2", "stereo_image_proc/point_cloud2", "points2")],
            {"disparity/stereo_algorithm": algorithm, "disparity/disparity_range": DISPARITIES,
             "disparity/min_disparity": 0})


METHODS = {
    "stereo_sgmp": ([Nodelet("matcher", "stereo_sgmp/stereo_sgmp", "points2")],
                    {"matcher/num_disparities": DISPARITIES}),
    "stereo_image_proc, SGBM": stereo_image_proc(SEMI_GLOBAL),
    "stereo_image_proc, BM": stereo_image_proc(BLOCK_MATCHER),
}


def processor_seconds(pid):
    """That a process has used so far."""
    with open("/proc/%d/stat" % pid) as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


@contextlib.contextmanager
def running(command, log):
    with open(log, "w") as file:
        process = subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT)
    try:
        yield process
    finally:
        process.terminate()
        process.wait(PATIENCE)


def program(package, name):
    (path,) = roslib.packages.find_node(package, name)
    return path


def wait_until(condition, problem):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            sys.exit("%s within %g s" % (problem, PATIENCE))
        time.sleep(0.05)


def is_advertised(topic):
    publishers, _, _ = rosgraph.Master(rospy.get_name()).getSystemState()
    return any(name == NAMESPACE + "/" + topic for name, _ in publishers)


def numbers_of(line):
    """Rate, median and 99 % as message_latency prints them."""
    found = re.search(r": ([\d.]+) Hz, median ([-\d.]+) ms, 99 % ([-\d.]+) ms", line)
    return list(found.groups()) if found else ["0", "-", "-"]


def measure(manager, seconds):
    """Shares of a core with and without listeners, and the numbers of each topic."""
    command = [program("stereo_sgmp", "message_latency"), "--seconds", str(seconds)]
    command += [NAMESPACE + "/" + topic for topic in TOPICS]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as listener:
        listener.stdout.readline()  # that it measures from now on
        before = processor_seconds(manager)
        lines = listener.stdout.read().splitlines()
        busy = (processor_seconds(manager) - before) / seconds
    if listener.returncode != 0:
        sys.exit("message_latency failed")
    time.sleep(1)
    before = processor_seconds(manager)
    time.sleep(IDLE)
    return busy, (processor_seconds(manager) - before) / IDLE, [numbers_of(line) for line in lines]


def run(nodelets, parameters, arguments):
    """Loads the nodelets into a manager of their own and measures them."""
    if rospy.has_param(NAMESPACE):
        rospy.delete_param(NAMESPACE)
    for name, value in parameters.items():
        rospy.set_param(NAMESPACE + "/" + name, value)
    nodelet = program("nodelet", "nodelet")
    in_namespace = "__ns:=" + NAMESPACE
    with contextlib.ExitStack() as stack:
        manager = stack.enter_context(
            running([nodelet, "manager", in_namespace, "__name:=manager"],
                    os.path.join(arguments.logs, "manager.log")))
        # One after the other: two that load image_transport at once can bring a manager down.
        for name, kind, topic in nodelets:
            stack.enter_context(running([nodelet, "load", kind, "manager", in_namespace,
                                         "__name:=" + name],
                                        os.path.join(arguments.logs, name + ".log")))
            wait_until(lambda: is_advertised(topic), "%s is not advertised" % topic)
        return measure(manager.pid, arguments.seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene")
    parser.add_argument("logs")
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--rate", type=float, default=30, help="frames per second")
    parser.add_argument("--methods", nargs="+", default=list(METHODS), choices=list(METHODS))
    parser.add_argument("--set", nargs="+", default=[], metavar="NAME=VALUE",
                        help="parameters of stereo_sgmp, such as prior/variant=sgm")
    arguments = parser.parse_args()
    rospy.init_node("compare_latency")
    for assignment in arguments.set:
        name, _, value = assignment.partition("=")
        METHODS["stereo_sgmp"][1]["matcher/" + name] = yaml.safe_load(value)
    print("| method | disparities/s | median ms | 99 % ms | clouds/s | median ms | 99 % ms "
          "| of a core | idle |")
    print("|---|" + 8 * "---:|")
    camera = [program("stereo_sgmp", "play_pair"), arguments.scene, "--rate", str(arguments.rate)]
    with running(camera, os.path.join(arguments.logs, "camera.log")):
        for name in arguments.methods:
            busy, idle, topics = run(*METHODS[name], arguments)
            cells = [name] + topics[0] + topics[1] + ["%.0f %%" % (100 * busy),
                                                      "%.1f %%" % (100 * idle)]
            print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
