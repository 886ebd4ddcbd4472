#!/usr/bin/python3
"""A stream for a while: memory stays where it is, and no output stops."""
import sys
import time
import unittest

import rospy
import rostest
from sensor_msgs.msg import Image, PointCloud2
from stereo_msgs.msg import DisparityImage

import stereo_rig as rig

PERIOD = 1 / 30


class SoakTest(unittest.TestCase):
    def stream(self, camera, seconds):
        """Frames at the camera's pace; how many there were."""
        end = time.monotonic() + seconds
        due = time.monotonic()
        frames = 0
        while due < end:
            camera.send(camera.next_frame())
            frames += 1
            due += PERIOD
            time.sleep(max(0, due - time.monotonic()))
        return frames

    def test_memory_is_flat(self):
        seconds = rospy.get_param("~seconds")
        camera = rig.Camera()
        counts = {"disparity": 0, "points2": 0, "confidence": 0}

        def counter(topic):
            def count(_):
                counts[topic] += 1
            return count
        listeners = [rospy.Subscriber("/stereo/" + topic, kind, counter(topic), queue_size=5)
                     for topic, kind in zip(counts, (DisparityImage, PointCloud2, Image))]
        camera.wait_for_matcher()
        manager = rig.process_of("/stereo/manager")
        # Buffers grow to their sizes in the first frames.
        warm_up = min(60, 0.3 * seconds)
        frames = self.stream(camera, warm_up)
        before = rig.resident_bytes(manager)
        frames += self.stream(camera, seconds - warm_up)
        after = rig.resident_bytes(manager)
        print("%d frames, %s; resident memory %.1f MB after %.0f s, %.1f MB after %.0f s"
              % (frames, counts, before / 1e6, warm_up, after / 1e6, seconds))
        self.assertLess(after, before + 10e6)
        for topic, count in counts.items():
            self.assertGreater(count, frames / 4, topic)
        for listener in listeners:
            listener.unregister()
        camera.wait_for_matcher(connected=False)
        self.check_idle(camera, manager)

    def check_idle(self, camera, manager):
        """While the cameras go on, a manager that nobody listens to takes next to no time."""
        before = rig.processor_seconds(manager)
        self.stream(camera, 2.0)
        self.assertLess(rig.processor_seconds(manager) - before, 0.05 * 2.0)


if __name__ == "__main__":
    rospy.init_node("soak_test")
    rostest.rosrun("stereo_sgmp", "soak_test", SoakTest, sys.argv)
