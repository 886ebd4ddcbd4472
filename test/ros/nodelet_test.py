#!/usr/bin/python3
"""The nodelet with images made in code: values, fields, laziness, bad input, reconfigure."""
import re
import subprocess
import sys
import unittest

import numpy as np
import rospy
import rostest
from sensor_msgs.msg import Image, PointField
from stereo_sgmp.msg import Statistics

import stereo_rig as rig
from nodelet_case import NodeletCase, OUTPUTS

OPENCV = tuple(int(number) for number in re.findall(
    r"\d+", subprocess.check_output(["pkg-config", "--modversion", "opencv4"], text=True))[:3])


class NodeletTest(NodeletCase):
    def test_disparity(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        message = self.match(frame)["disparity"]
        rig.check_disparity(self, message)
        self.assertEqual(message.header.stamp, frame.left.header.stamp)
        self.assertEqual(message.header.frame_id, rig.FRAME_ID)
        self.assert_same_frame(message.image.header, message.header)
        self.assertEqual(message.image.encoding, "32FC1")
        self.assertEqual((message.image.width, message.image.height), (rig.WIDTH, rig.HEIGHT))
        self.assertAlmostEqual(message.f, rig.FOCAL_LENGTH, places=3)
        self.assertAlmostEqual(message.T, rig.BASELINE, places=5)

    def test_disparity_limits(self):
        self.listen("disparity")
        message = self.match(self.camera.next_frame())["disparity"]
        disparity = rig.disparity_array(message)
        valid = disparity > message.min_disparity
        self.assertTrue(np.isfinite(disparity).all())
        self.assertTrue((disparity[~valid] == np.float32(message.min_disparity - 1)).all())
        self.assertLess(disparity[valid].max(), message.max_disparity)
        shift = rig.CX_RIGHT - rig.CX_LEFT
        self.assertAlmostEqual(message.min_disparity, shift, delta=1)
        self.assertAlmostEqual(message.max_disparity, 47 + shift, delta=1)
        self.assertGreater(message.delta_d, 0)
        self.assertLess(message.delta_d, 1)
        window = message.valid_window
        inside = np.zeros_like(valid)
        inside[window.y_offset:window.y_offset + window.height,
               window.x_offset:window.x_offset + window.width] = True
        self.assertFalse((valid & ~inside).any())

    def test_cloud(self):
        self.listen("disparity", "points2")
        results = self.match(self.camera.next_frame())
        cloud = results["points2"]
        self.assertEqual((cloud.width, cloud.height), (rig.WIDTH, rig.HEIGHT))
        self.assert_same_frame(cloud.header, results["disparity"].header)
        self.assertEqual((cloud.point_step, cloud.row_step), (32, 32 * rig.WIDTH))
        self.assertFalse(cloud.is_dense)
        self.assertEqual([(f.name, f.offset, f.datatype, f.count) for f in cloud.fields],
                         [(name, offset, PointField.FLOAT32, 1) for name, offset in
                          (("x", 0), ("y", 4), ("z", 8), ("rgb", 16), ("confidence", 20))])
        floats = np.frombuffer(cloud.data, np.float32).reshape(rig.HEIGHT, rig.WIDTH, 8)
        disparity = rig.disparity_array(results["disparity"])
        valid = disparity > results["disparity"].min_disparity
        self.assertTrue(np.isnan(floats[~valid, 0:3]).all())
        z = rig.FOCAL_LENGTH * rig.BASELINE / disparity
        y, x = np.mgrid[0:rig.HEIGHT, 0:rig.WIDTH]
        np.testing.assert_allclose(floats[valid, 2], z[valid], rtol=1e-4)
        np.testing.assert_allclose(floats[valid, 0],
                                   ((x - rig.CX_LEFT) * z / rig.FOCAL_LENGTH)[valid],
                                   rtol=1e-4, atol=1e-5)
        np.testing.assert_allclose(floats[valid, 1],
                                   ((y - rig.CY) * z / rig.FOCAL_LENGTH)[valid],
                                   rtol=1e-4, atol=1e-5)

    def cloud_colors(self, cloud):
        """b, g, r of each point."""
        return np.frombuffer(cloud.data, np.uint8).reshape(rig.HEIGHT, rig.WIDTH, 32)[:, :, 16:19]

    def test_cloud_is_gray_without_colour_images(self):
        self.listen("points2")
        colors = self.cloud_colors(self.match(self.camera.next_frame())["points2"])
        left, _ = rig.make_pair()
        np.testing.assert_array_equal(colors, np.repeat(left[:, :, None], 3, axis=2))

    def test_cloud_takes_colours_of_the_same_stamp(self):
        publisher = rospy.Publisher("/stereo/left/image_rect_color", Image, queue_size=5)
        self.listen("points2")
        rig.wait_until(lambda: publisher.get_num_connections() > 0, "nobody takes colour images")
        frame = self.camera.next_frame()
        rgb = np.zeros((rig.HEIGHT, rig.WIDTH, 3), np.uint8)
        rgb[:] = (200, 100, 50)
        publisher.publish(rig.image_message(rgb, "rgb8", frame.left.header.stamp))
        # The colour image comes by a connection of its own: frames until it has arrived.
        expected = rgb[:, :, ::-1]
        for _ in range(50):
            cloud = self.match(frame)["points2"]
            if (self.cloud_colors(cloud) == expected).all():
                break
            frame = self.camera.next_frame()
            publisher.publish(rig.image_message(rgb, "rgb8", frame.left.header.stamp))
        np.testing.assert_array_equal(self.cloud_colors(cloud), expected)
        publisher.unregister()

    def test_confidence(self):
        self.listen("confidence")
        message = self.match(self.camera.next_frame())["confidence"]
        self.assertEqual(message.encoding, "32FC1")
        confidence = np.frombuffer(message.data, np.float32)
        self.assertEqual(confidence.size, rig.WIDTH * rig.HEIGHT)
        self.assertGreaterEqual(confidence.min(), 0)
        self.assertLessEqual(confidence.max(), 1)
        self.assertGreater(np.median(confidence), 0.2)

    def test_priors(self):
        self.listen("priors")
        message = self.match(self.camera.next_frame())["priors"]
        self.assertEqual(message.variant, "epv")
        self.assertGreaterEqual(len(message.planes), 1)
        self.assertEqual(message.labels.encoding, "16SC1")
        labels = np.frombuffer(message.labels.data, np.int16)
        self.assertGreaterEqual(labels.min(), -1)
        self.assertLess(labels.max(), len(message.planes))
        wall = max(message.planes, key=lambda plane: plane.support)
        at_center = wall.a * rig.CX_LEFT + wall.b * rig.CY + wall.c
        self.assertAlmostEqual(at_center, rig.WALL, delta=2)
        self.assertAlmostEqual(np.linalg.norm(wall.normal), 1, places=6)
        depth = rig.FOCAL_LENGTH * rig.BASELINE / (at_center + rig.CX_RIGHT - rig.CX_LEFT)
        self.assertAlmostEqual(wall.distance / wall.normal[2], depth, delta=1e-3 * depth)

    def test_statistics(self):
        self.listen("statistics")
        before = self.match(self.camera.next_frame())["statistics"]
        message = self.match(self.camera.next_frame())["statistics"]
        self.assertEqual(message.frames, before.frames + 1)
        self.assertEqual(message.variant, "epv")
        self.assertGreater(message.frame_ms, 0)
        self.assertGreaterEqual(message.latency_ms, message.frame_ms)
        self.assertEqual(message.cloud_latency_ms, 0)
        self.listen("points2")
        message = self.match(self.camera.next_frame())["statistics"]
        self.assertGreater(message.cloud_latency_ms, message.latency_ms)
        self.assertAlmostEqual(sum(stage.ms for stage in message.stages), message.frame_ms,
                               delta=0.05 * message.frame_ms + 0.5)
        self.assertEqual(sum(message.reasons), rig.WIDTH * rig.HEIGHT)
        self.assertAlmostEqual(message.density,
                               message.reasons[Statistics.VALID] / sum(message.reasons), places=6)

    def test_each_output_alone_wakes_the_nodelet(self):
        for topic in OUTPUTS:
            self.listen(topic)
            self.match(self.camera.next_frame())
            self.listeners.pop(topic).close()
            self.camera.wait_for_matcher(connected=False)

    def test_encodings(self):
        self.listen("disparity")
        for encoding in ("mono8", "mono16", "bgr8", "rgb8", "bgra8", "rgba8"):
            frame = self.camera.next_frame(encoding)
            rig.check_disparity(self, self.match(frame)["disparity"])

    def test_works_on_the_newest_frame(self):
        self.listen("disparity")
        frames = [self.camera.next_frame() for _ in range(20)]
        for frame in frames:
            self.camera.send(frame)
        rig.check_disparity(self,
                            self.listeners["disparity"].wait_for(frames[-1].left.header.stamp))

    def check_refused(self, frame, sentence):
        """A bad frame is told of and yields nothing, the next good one works."""
        self.camera.send(frame)
        self.log.wait_for(sentence)
        self.match_good_frame()
        self.assertFalse(self.listeners["disparity"].has(frame.left.header.stamp))

    def test_zero_projection(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.right_info.P = [0.0] * 12
        self.check_refused(frame, "right P[0] is 0; expected the focal length")

    def test_zero_baseline(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.right_info.P[3] = 0.0
        self.check_refused(frame, "right P[3] is 0; expected -fx*B")

    def test_swapped_cameras(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.left_info.P, frame.right_info.P = frame.right_info.P, frame.left_info.P
        self.check_refused(frame, "seem to be swapped")

    def test_infinite_calibration(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.left_info.P[0] = float("inf")
        self.check_refused(frame, "left P[0] is inf; expected a finite number")

    def test_unequal_sizes(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.right = rig.image_message(rig.texture(100, 200, 3), "mono8",
                                        frame.left.header.stamp)
        self.check_refused(frame, "right/image_rect of 200 x 100")

    def test_size_of_camera_info(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.left_info.width = 640
        self.check_refused(frame, "left camera_info is of 640 x 240 pixels, the image of 320 x 240")

    def test_unknown_encoding(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.left.encoding = "bayer_rggb8"
        self.check_refused(frame, "left/image_rect has encoding 'bayer_rggb8'; expected one of")

    def test_truncated_image(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.right.data = frame.right.data[:-1]
        self.check_refused(frame, "76799 bytes; expected")

    def test_image_without_pixels(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.left.width = frame.left.height = frame.left.step = 0
        frame.left.data = b""
        self.check_refused(frame, "left/image_rect has 0 x 0 pixels")

    def test_frame_ids(self):
        self.listen("disparity")
        frame = self.camera.next_frame()
        frame.right_info.header.frame_id = "right_optical"
        message = self.match(frame)["disparity"]
        self.log.wait_for("frame_id 'left_optical', the right one 'right_optical'; expected")
        rig.check_disparity(self, message)
        self.match_good_frame()

    def test_unequal_stamps(self):
        self.listen("disparity")
        sentence = "expected equal stamps; trigger the cameras together or set"

        def send_unequal():
            frame = self.camera.next_frame()
            for message in (frame.right, frame.right_info):
                message.header.stamp += rospy.Duration.from_sec(0.05)
            self.camera.send(frame)
            return self.log.has(sentence)
        rig.wait_until(send_unequal, "nobody says '%s'" % sentence)
        self.match_good_frame()

    def test_time_going_back(self):
        self.listen("disparity")
        self.match_good_frame()
        self.camera.stamp -= rospy.Duration.from_sec(500)
        # The frame at the jump may be lost; the ones after it are not.
        self.camera.send(self.camera.next_frame())
        self.log.wait_for("went back in time")
        for _ in range(2):
            self.camera.send(self.camera.next_frame())
        self.match_good_frame()

    def test_reconfigure_variant(self):
        self.listen("priors")
        client, _ = self.reconfigurer()
        for variant in ("sgm", "epi", "epv"):
            client.update_configuration({"prior_variant": variant})
            message = self.match(self.camera.next_frame())["priors"]
            self.assertEqual(message.variant, variant)
            self.assertEqual(len(message.planes) > 0, variant != "sgm")

    def test_reconfigure_clamps(self):
        client, _ = self.reconfigurer()
        after = client.update_configuration({"min_disparity": -100000, "filter_min_confidence": 2})
        self.assertEqual(after["min_disparity"], -4096)
        self.assertEqual(after["filter_min_confidence"], 1)

    def test_reconfigure_refuses_unknown_choices(self):
        client, before = self.reconfigurer()
        after = client.update_configuration({"prior_variant": "best"})
        self.assertEqual(after["prior_variant"], before["prior_variant"])
        self.log.wait_for("prior_variant is 'best'; expected one of sgm, epi, epv, mw")

    def test_reconfigure_refuses_variants_that_need_more_than_a_stream(self):
        client, before = self.reconfigurer()
        after = client.update_configuration({"prior_variant": "gnv"})
        self.assertEqual(after["prior_variant"], before["prior_variant"])
        self.log.wait_for("prior/variant gnv needs given normals, which a stream does not have")

    @unittest.skipIf(OPENCV < (4, 5, 1), "this OpenCV has no line detector")
    def test_manhattan_world(self):
        self.listen("priors", "statistics")
        client, _ = self.reconfigurer()
        client.update_configuration({"prior_variant": "mw"})
        messages = self.match(self.camera.next_frame())
        # The rig's picture is texture without lines.
        self.assertEqual(messages["priors"].variant, "epv")
        self.assertEqual(messages["statistics"].variant, "epv")
        self.log.wait_for("show no three orthogonal directions; the prior is that of epv")

    def test_reconfigure_extremes(self):
        self.listen("disparity")
        client, before = self.reconfigurer()
        for parameter in client.get_parameter_descriptions(timeout=rig.TIMEOUT):
            if parameter["type"] not in ("int", "double"):
                continue
            for end in ("min", "max"):
                client.update_configuration({parameter["name"]: parameter[end]})
                # May be refused (more disparities than columns), must not bring anything down.
                self.camera.send(self.camera.next_frame())
            client.update_configuration({parameter["name"]: before[parameter["name"]]})
        self.match_good_frame()


if __name__ == "__main__":
    rospy.init_node("nodelet_test")
    rostest.rosrun("stereo_sgmp", "nodelet_test", NodeletTest, sys.argv)
