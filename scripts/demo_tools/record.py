#!/usr/bin/python3
"""Waits for one frame of all that the nodelet publishes and writes it to files.

disparity.pfm (x_left - x_right; inf where invalid), confidence.pfm, cloud.ply, disparity.png,
confidence.png, priors.png and statistics.json.
"""
import argparse
import json
import os
import sys
import threading
import time

import numpy as np
from PIL import Image
import rospy
import sensor_msgs.msg
import stereo_msgs.msg

import stereo_sgmp.msg
from pfm import write_pfm
from ply import POINT, write_ply

_TOPICS = {
    "disparity": stereo_msgs.msg.DisparityImage,
    "confidence": sensor_msgs.msg.Image,
    "points2": sensor_msgs.msg.PointCloud2,
    "disparity_color": sensor_msgs.msg.Image,
    "priors_color": sensor_msgs.msg.Image,
    "statistics": stereo_sgmp.msg.Statistics,
}
# Frames of which some topics are still missing; more would be a sign that they never come.
_KEPT_FRAMES = 8


class FrameCollector:
    """Puts the messages of all topics together by their stamps."""

    def __init__(self, namespace):
        self._frames = {}
        self._counts = dict.fromkeys(_TOPICS, 0)
        self._lock = threading.Lock()
        self._complete = threading.Event()
        self._frame = None
        self._subscribers = [
            rospy.Subscriber(namespace + "/" + topic, message_type, self._add, topic, queue_size=2,
                             buff_size=1 << 26)
            for topic, message_type in _TOPICS.items()]

    def _add(self, message, topic):
        with self._lock:
            self._counts[topic] += 1
            frame = self._frames.setdefault(message.header.stamp.to_nsec(), {})
            frame[topic] = message
            if len(frame) == len(_TOPICS):
                self._frame = frame
                self._complete.set()
            while len(self._frames) > _KEPT_FRAMES:
                del self._frames[min(self._frames)]

    def wait(self, seconds, launch_pid):
        """Gives up after that time, or when the process `launch_pid` (None: none) has ended."""
        deadline = time.monotonic() + seconds
        while not self._complete.wait(0.5):
            counts = ", ".join("%s %d" % item for item in self._counts.items())
            if launch_pid is not None and not os.path.exists("/proc/%d" % launch_pid):
                raise TimeoutError("roslaunch has ended; messages so far: " + counts)
            if time.monotonic() > deadline:
                raise TimeoutError("no complete frame within %g s; messages so far: %s" %
                                   (seconds, counts))
        for subscriber in self._subscribers:
            subscriber.unregister()
        return self._frame


def float_image(message):
    byte_order = ">" if message.is_bigendian else "<"
    rows = np.frombuffer(message.data, np.uint8).reshape(message.height, message.step)
    return rows[:, :4 * message.width].copy().view(byte_order + "f4").astype(np.float32)


def color_image(message):
    if message.encoding != "bgr8":
        raise ValueError("expected a picture in bgr8, not %s" % message.encoding)
    rows = np.frombuffer(message.data, np.uint8).reshape(message.height, message.step)
    bgr = rows[:, :3 * message.width].reshape(message.height, message.width, 3)
    return Image.fromarray(np.ascontiguousarray(bgr[:, :, ::-1]))


def disparities(message, doffs):
    """x_left - x_right: a DisparityImage has the difference of the principal points taken off."""
    image = float_image(message.image)
    valid = (image > message.min_disparity) & (image < message.max_disparity)
    return np.where(valid, image - np.float32(doffs), np.float32(np.inf))


def cloud_points(message):
    offsets = {field.name: field.offset for field in message.fields}
    names = ["x", "y", "z", "rgb", "confidence"]
    layout = np.dtype({"names": names, "formats": ["<f4", "<f4", "<f4", "<u4", "<f4"],
                       "offsets": [offsets[name] for name in names],
                       "itemsize": message.point_step})
    source = np.frombuffer(message.data, layout)
    source = source[np.isfinite(source["z"])]
    points = np.empty(len(source), POINT)
    for name in ("x", "y", "z", "confidence"):
        points[name] = source[name]
    for name, shift in (("red", 16), ("green", 8), ("blue", 0)):
        points[name] = source["rgb"] >> shift & 255
    return points


def statistics(message):
    return {
        "variant": message.variant,
        "frame_ms": message.frame_ms,
        "latency_ms": message.latency_ms,
        "stages_ms": {stage.name: stage.ms for stage in message.stages},
        "planes": message.planes,
        "density": message.density,
        "alignment_applied": message.alignment_applied,
        "alignment_median_offset": message.alignment_median_offset,
    }


def write_frame(frame, doffs, folder):
    os.makedirs(folder, exist_ok=True)

    def path(name):
        return os.path.join(folder, name)

    write_pfm(path("disparity.pfm"), disparities(frame["disparity"], doffs))
    confidence = float_image(frame["confidence"])
    write_pfm(path("confidence.pfm"), confidence)
    Image.fromarray(np.rint(255 * confidence).astype(np.uint8)).save(path("confidence.png"))
    color_image(frame["disparity_color"]).save(path("disparity.png"))
    color_image(frame["priors_color"]).save(path("priors.png"))
    write_ply(path("cloud.ply"), cloud_points(frame["points2"]))
    with open(path("statistics.json"), "w") as file:
        json.dump(statistics(frame["statistics"]), file, indent=2)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("namespace", help="of the stereo camera, such as /stereo")
    parser.add_argument("folder", help="folder to write to")
    parser.add_argument("--doffs", type=float, default=0.0,
                        help="difference of the principal points, cx_right - cx_left, pixels")
    parser.add_argument("--launch-pid", type=int, help="process that has to run meanwhile")
    parser.add_argument("--timeout", type=float, default=60.0, help="seconds")
    arguments = parser.parse_args()
    rospy.init_node("record_frame", anonymous=True)
    try:
        frame = FrameCollector(arguments.namespace).wait(arguments.timeout,
                                                          arguments.launch_pid)
    except TimeoutError as error:
        return "%s: %s" % (sys.argv[0], error)
    write_frame(frame, arguments.doffs, arguments.folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
