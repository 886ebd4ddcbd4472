#!/usr/bin/python3
"""A stereo camera: camera.py SCENE RATE publishes its pair, stamped with the time of sending."""
import os
import sys

import numpy as np
from PIL import Image
import rospy
import sensor_msgs.msg

FRAME_ID = "left_camera_optical_frame"


def image_message(pixels, encoding):
    message = sensor_msgs.msg.Image(height=pixels.shape[0], width=pixels.shape[1],
                                    encoding=encoding, step=pixels[0].nbytes)
    message.data = pixels.tobytes()
    return message


def read_calibration(path):
    """Focal length, principal point, difference of the principal points, baseline in metres."""
    with open(path) as file:
        values = dict(line.strip().split("=", 1) for line in file if "=" in line)
    numbers = [float(word) for word in values["cam0"].strip("[]").replace(";", " ").split()]
    return (numbers[0], numbers[2], numbers[5], float(values["doffs"]),
            float(values["baseline"]) / 1000)


def info_message(size, f, cx, cy, offset):
    message = sensor_msgs.msg.CameraInfo(width=size[0], height=size[1],
                                         distortion_model="plumb_bob", D=[0.0] * 5)
    message.K = [f, 0, cx, 0, f, cy, 0, 0, 1]
    message.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    message.P = [f, 0, cx, -f * offset, 0, f, cy, 0, 0, 0, 1, 0]
    return message


def read_messages(scene):
    """The messages of a frame by topic."""
    left, right = (Image.open(os.path.join(scene, name)) for name in ("im0.png", "im1.png"))
    f, cx, cy, doffs, baseline = read_calibration(os.path.join(scene, "calib.txt"))
    return {
        "left/image_rect": image_message(np.asarray(left.convert("L")), "mono8"),
        "left/image_rect_color": image_message(np.asarray(left.convert("RGB")), "rgb8"),
        "left/camera_info": info_message(left.size, f, cx, cy, 0.0),
        "right/image_rect": image_message(np.asarray(right.convert("L")), "mono8"),
        "right/camera_info": info_message(right.size, f, cx + doffs, cy, baseline)}


def main():
    rospy.init_node("camera")
    messages = read_messages(sys.argv[1])
    publishers = {topic: rospy.Publisher("/stereo/" + topic, type(message), queue_size=2,
                                         tcp_nodelay=True)
                  for topic, message in messages.items()}
    rate = rospy.Rate(float(sys.argv[2]))
    while not rospy.is_shutdown():
        stamp = rospy.Time.now()
        for topic, message in messages.items():
            message.header.stamp = stamp
            message.header.frame_id = FRAME_ID
            publishers[topic].publish(message)
        rate.sleep()


if __name__ == "__main__":
    try:
        main()
    except rospy.ROSInterruptException:
        pass
