#!/usr/bin/python3
"""What the nodelet says of its own state: reports, warnings with the fix, diagnostics, load."""
import sys
import threading

import numpy as np
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from sensor_msgs.msg import Image

import stereo_rig as rig
from nodelet_case import NodeletCase


class StatusListener:
    """The latest status of each part of the nodelet."""

    def __init__(self):
        self._arrived = threading.Condition()
        self._parts = {}
        self._subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, self._add)

    def _add(self, message):
        with self._arrived:
            for status in message.status:
                self._parts[status.name.split(": ")[-1]] = status
            self._arrived.notify_all()

    def wait_until(self, part, condition):
        def holds():
            return part in self._parts and condition(self._parts[part])
        with self._arrived:
            if not self._arrived.wait_for(holds, rig.TIMEOUT):
                raise AssertionError("%s is still %s" % (part, self._parts.get(part)))
            return self._parts[part]

    def close(self):
        self._subscriber.unregister()


def values(status):
    return {pair.key: pair.value for pair in status.values}


class HealthTest(NodeletCase):
    def diagnostics(self):
        listener = StatusListener()
        self.addCleanup(listener.close)
        return listener

    def test_calibration_report(self):
        self.listen("disparity")
        self.reconfigure(max_depth=11.0)
        self.match_good_frame()
        self.log.wait_for("stereo camera of 320 x 240 pixels: baseline 0.1 m, focal length 300 px")
        self.log.wait_for(" to 15 m (disparities -3 to 44)")
        self.log.wait_for("at 1 m: 0.00")
        self.log.wait_for("at 10 m: ")
        self.log.wait_for(" MB, threads ")

    def test_rows_that_differ(self):
        self.listen("disparity", "statistics")
        self.reconfigure(alignment_refresh_interval=1)

        # The rig is learnt from some frames.
        def learn(shift, is_learnt):
            for _ in range(30):
                frame = self.camera.next_frame()
                rows = np.frombuffer(frame.right.data, np.uint8).reshape(rig.HEIGHT, rig.WIDTH)
                frame.right.data = np.roll(rows, shift, axis=0).tobytes()
                statistics = self.match(frame)["statistics"]
                if is_learnt(statistics.alignment_median_offset):
                    return
            self.fail("rows differ by %g" % statistics.alignment_median_offset)
        learn(3, lambda offset: offset > 2)
        self.log.wait_for("the rows of the left and the right image differ by 3")
        learn(0, lambda offset: offset < 0.5)
        self.match_good_frame()

    def test_swapped_images(self):
        self.listen("disparity")
        # The order is looked at now and then.
        for _ in range(30):
            frame = self.camera.next_frame()
            frame.left.data, frame.right.data = frame.right.data, frame.left.data
            self.match(frame)
        self.log.wait_for("match only with left and right exchanged; expected the left camera on")
        self.match_good_frame()

    def test_says_what_to_do_when_nothing_arrives(self):
        decoy = rospy.Publisher("/other/left/image_rect", Image, queue_size=1)
        self.addCleanup(decoy.unregister)
        self.listen("disparity")
        self.log.wait_for("nothing arrives; expected messages on 4 topics")
        self.log.wait_for("/stereo/left/image_rect (")
        self.log.wait_for("its publisher is connected but sends nothing")
        self.match_good_frame()

    def test_diagnostics(self):
        status = self.diagnostics()
        idle = status.wait_until("inputs", lambda s: s.message == "idle: nobody listens")
        self.assertEqual(idle.level, DiagnosticStatus.OK)
        self.listen("disparity")
        status.wait_until("inputs", lambda s: s.level == DiagnosticStatus.ERROR and
                          "nothing arrives on /stereo/left/image_rect" in s.message)
        for _ in range(3):
            self.match_good_frame()
        frames = status.wait_until("frames", lambda s: values(s).get("matched", "0.0") != "0.0 Hz")
        keys = values(frames)
        for key in ("dropped", "latency, arrival to disparity", "age, stamp to disparity",
                    "stage aggregation", "stage refinement", "frames matched", "given up"):
            self.assertIn(key, keys)
        result = values(status.wait_until("result", lambda s: "planes" in values(s)))
        self.assertGreater(int(result["planes"]), 0)
        self.assertGreater(float(result["valid pixels"].split()[0]), 70)
        self.assertIn("invalid: left-right", result)
        memory = status.wait_until("memory", lambda s: True)
        self.assertGreater(float(memory.message.split()[0]), 10)

    def test_diagnostics_tell_of_refused_frames(self):
        status = self.diagnostics()
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.right_info.P = [0.0] * 12
        self.camera.send(frame)
        status.wait_until("frames", lambda s: s.level == DiagnosticStatus.ERROR and
                          "right P[0] is 0" in s.message)
        self.match_good_frame()

    def test_gives_up_resolution_to_keep_the_rate_and_returns(self):
        status = self.diagnostics()
        self.listen("disparity", "statistics")
        self.assertEqual(self.match(self.camera.next_frame())["statistics"].load, "nothing")
        client, _ = self.reconfigurer()
        client.update_configuration({"target_rate": 1000})
        levels = [self.match(self.camera.next_frame())["statistics"].load_level
                  for _ in range(16)]
        self.assertEqual(levels, sorted(levels))
        self.assertEqual(levels[-1], 6)
        results = self.match(self.camera.next_frame())
        self.assertEqual(results["statistics"].load, "resolution: 1/4")
        self.assertEqual(results["disparity"].image.width, rig.WIDTH)
        valid = rig.disparity_array(results["disparity"]) > results["disparity"].min_disparity
        wrong = np.abs(rig.disparity_array(results["disparity"]) - rig.true_disparity()) > 2
        self.assertGreater(valid.mean(), 0.6)
        self.assertLess(wrong[valid].mean(), 0.15)
        status.wait_until("frames", lambda s: "gives up resolution" in s.message)
        client.update_configuration({"target_rate": 0.2})  # fits under sanitizers, too
        for _ in range(80):
            statistics = self.match(self.camera.next_frame())["statistics"]
            if statistics.load_level == 0:
                break
        self.assertEqual(statistics.load, "nothing")
        self.match_good_frame()


if __name__ == "__main__":
    rospy.init_node("health_test")
    rostest.rosrun("stereo_sgmp", "health_test", HealthTest, sys.argv)
