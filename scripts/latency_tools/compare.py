#!/usr/bin/python3
"""Latency, rate and processor time of stereo nodelets: compare.py SCENE LOG_FOLDER."""
import argparse
import contextlib
import os
import struct
import subprocess
import sys
import time

import numpy as np
import roslib.packages
import rosgraph
import rospy
import yaml

SCRIPTS = os.path.dirname(os.path.abspath(__file__))
NAMESPACE = "/stereo"
PATIENCE = 30.0  # seconds until the first frame
WARM_UP = 3.0    # seconds that are not counted
IDLE = 5.0       # seconds without listeners
DISPARITIES = 64

BLOCK_MATCHER, SEMI_GLOBAL = 0, 1  # of stereo_image_proc's stereo_algorithm


def stereo_image_proc(algorithm):
    """Its nodelets by name, and their parameters."""
    return ({"disparity": "stereo_image_proc/disparity",
             "point_cloud2": "stereo_image_proc/point_cloud2"},
            {"disparity/stereo_algorithm": algorithm, "disparity/disparity_range": DISPARITIES,
             "disparity/min_disparity": 0})


METHODS = {
    "stereo_sgmp": ({"matcher": "stereo_sgmp/stereo_sgmp"},
                    {"matcher/num_disparities": DISPARITIES}),
    "stereo_image_proc, SGBM": stereo_image_proc(SEMI_GLOBAL),
    "stereo_image_proc, BM": stereo_image_proc(BLOCK_MATCHER),
}


def processor_seconds(pid):
    """That a process has used so far."""
    with open("/proc/%d/stat" % pid) as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Latencies:
    """From the stamp to the arrival of each message, without taking the messages apart."""

    def __init__(self, topic):
        self.seconds = []
        self._subscriber = rospy.Subscriber(NAMESPACE + "/" + topic, rospy.AnyMsg, self._add,
                                            queue_size=10, buff_size=1 << 25, tcp_nodelay=True)

    def _add(self, message):
        arrival = time.time()
        _, seconds, nanoseconds = struct.unpack_from("<III", message._buff)
        self.seconds.append(arrival - seconds - 1e-9 * nanoseconds)

    def close(self):
        self._subscriber.unregister()


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


def measure(manager, seconds):
    """Shares of a core with and without listeners, and the latencies of both topics."""
    for topic in ("disparity", "points2"):
        wait_until(lambda: is_advertised(topic), "%s is not advertised" % topic)
    listeners = [Latencies("disparity"), Latencies("points2")]
    wait_until(lambda: all(listener.seconds for listener in listeners), "no disparity and cloud")
    time.sleep(WARM_UP)
    for listener in listeners:
        listener.seconds.clear()
    before = processor_seconds(manager)
    time.sleep(seconds)
    busy = (processor_seconds(manager) - before) / seconds
    latencies = [np.array(listener.seconds) for listener in listeners]
    for listener in listeners:
        listener.close()
    time.sleep(1)
    before = processor_seconds(manager)
    time.sleep(IDLE)
    return busy, (processor_seconds(manager) - before) / IDLE, latencies


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
        for name, kind in nodelets.items():
            stack.enter_context(running([nodelet, "load", kind, "manager", in_namespace,
                                         "__name:=" + name],
                                        os.path.join(arguments.logs, name + ".log")))
        return measure(manager.pid, arguments.seconds)


def row(name, seconds, busy, idle, latencies):
    cells = [name]
    for latency in latencies:
        milliseconds = np.percentile(1e3 * latency, (50, 99))
        cells += ["%.1f" % (len(latency) / seconds)] + ["%.1f" % value for value in milliseconds]
    return cells + ["%.0f %%" % (100 * busy), "%.1f %%" % (100 * idle)]


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
    with running([sys.executable, os.path.join(SCRIPTS, "camera.py"), arguments.scene,
                  str(arguments.rate)], os.path.join(arguments.logs, "camera.log")):
        for name in arguments.methods:
            busy, idle, latencies = run(*METHODS[name], arguments)
            print("| " + " | ".join(row(name, arguments.seconds, busy, idle, latencies)) + " |",
                  flush=True)


if __name__ == "__main__":
    main()
