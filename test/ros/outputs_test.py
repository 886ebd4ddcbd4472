#!/usr/bin/python3
"""Depth, errors, pictures, markers, the baseline, and the options of the cloud and the range."""
import os
import re
import sys

import numpy as np
import rosgraph
import rospkg
import rospy
import rostest
from visualization_msgs.msg import Marker

import stereo_rig as rig
from nodelet_case import NodeletCase

DEPTH = rig.FOCAL_LENGTH * rig.BASELINE


def float_array(message):
    return np.frombuffer(message.data, np.float32).reshape(message.height, message.width)


def is_valid(disparity_message):
    return rig.disparity_array(disparity_message) > disparity_message.min_disparity


def documented_topics():
    """Type by topic, of the table of published topics."""
    path = os.path.join(rospkg.RosPack().get_path("stereo_sgmp"), "docs", "topics.md")
    with open(path) as file:
        section = file.read().split("## Published topics")[1].split("\n## ")[0]
    return {topic: kind for names, kind in re.findall(r"^\| (.*?) \| `(.*?)` \|", section, re.M)
            for topic in re.findall("`(.*?)`", names)}


class OutputsTest(NodeletCase):
    def test_docs_name_the_topics(self):
        master = rosgraph.Master("/outputs_test")
        publishers, _, _ = master.getSystemState()
        types = dict(master.getTopicTypes())
        # Compressed images and the like come with the plugins that are installed.
        common = re.compile("parameter_|/rosout|/bond|/[^/]*/(compressed|theora)")
        advertised = {topic: types[topic] for topic, nodes in publishers
                      if "/stereo/manager" in nodes and not common.search(topic)}
        documented = {topic if topic.startswith("/") else "/stereo/" + topic: kind
                      for topic, kind in documented_topics().items()}
        self.assertEqual(advertised, documented)

    def test_depth(self):
        self.listen("disparity", "depth")
        results = self.match(self.camera.next_frame())
        self.assert_same_frame(results["depth"].header, results["disparity"].header)
        self.assertEqual(results["depth"].encoding, "32FC1")
        depth, valid = float_array(results["depth"]), is_valid(results["disparity"])
        np.testing.assert_array_equal(np.isfinite(depth), valid)
        self.assertTrue(np.isnan(depth[~valid]).all())
        disparity = rig.disparity_array(results["disparity"])
        np.testing.assert_allclose(depth[valid], DEPTH / disparity[valid], rtol=1e-5)

    def test_errors(self):
        """About two thirds of the pixels are within one sigma."""
        self.listen("disparity", "error_disparity", "error_depth")
        results = self.match(self.camera.next_frame())
        disparity, valid = rig.disparity_array(results["disparity"]), is_valid(results["disparity"])
        sigma = float_array(results["error_disparity"])
        np.testing.assert_array_equal(np.isfinite(sigma), valid)
        within = (np.abs(disparity - rig.true_disparity()) <= sigma)[valid].mean()
        self.assertGreater(within, 0.6)
        np.testing.assert_allclose(float_array(results["error_depth"])[valid],
                                   (DEPTH / disparity ** 2 * sigma)[valid], rtol=1e-4)

    def test_pictures(self):
        topics = ("disparity_color", "confidence_color", "priors_color",
                  "disparity_baseline_color")
        self.listen(*topics)
        for message in self.match(self.camera.next_frame()).values():
            self.assertEqual(message.encoding, "bgr8")
            self.assertEqual((message.width, message.height), (rig.WIDTH, rig.HEIGHT))
            self.assertGreater(np.frombuffer(message.data, np.uint8).std(), 5)

    def test_markers(self):
        """Triangles and lines on the planes of the message beside them."""
        self.listen("priors", "priors_markers")
        results = self.match(self.camera.next_frame())
        fill, outline = results["priors_markers"].markers
        self.assert_same_frame(fill.header, results["priors"].header)
        self.assertEqual((fill.type, outline.type), (Marker.TRIANGLE_LIST, Marker.LINE_LIST))
        self.assertEqual((fill.action, outline.action), (Marker.ADD, Marker.ADD))
        self.assertGreater(len(fill.points), 0)
        self.assertEqual(len(fill.points) % 3, 0)
        self.assertEqual(len(outline.points) % 2, 0)
        for marker in (fill, outline):
            self.assertEqual(len(marker.colors), len(marker.points))
        self.assertTrue(all(0 < color.a < 1 for color in fill.colors))
        for point in fill.points:
            away = min(abs(np.dot(plane.normal, (point.x, point.y, point.z)) - plane.distance)
                       for plane in results["priors"].planes)
            self.assertLess(away, 1e-6)
            self.assertGreater(point.z, 0)

    def test_no_markers_without_prior(self):
        self.reconfigure(prior_variant="sgm")
        self.listen("priors_markers")
        for marker in self.match(self.camera.next_frame())["priors_markers"].markers:
            self.assertEqual(marker.action, Marker.DELETE)

    def test_baseline_is_the_frame_without_prior(self):
        self.listen("disparity", "disparity_baseline")
        baseline = self.match(self.camera.next_frame())["disparity_baseline"]
        self.reconfigure(prior_variant="sgm")
        without = self.match(self.camera.next_frame())["disparity"]
        self.assertEqual(baseline.image.data, without.image.data)
        rig.check_disparity(self, baseline)

    def test_compact_cloud(self):
        self.listen("points2")
        cloud = self.match(self.camera.next_frame())["points2"]
        self.reconfigure(cloud_compact=True)
        compact = self.match(self.camera.next_frame())["points2"]
        self.assertEqual((compact.point_step, compact.row_step), (20, 20 * rig.WIDTH))
        self.assertEqual([field.name for field in compact.fields],
                         [field.name for field in cloud.fields])
        points = np.frombuffer(cloud.data, np.float32).reshape(-1, 8)[:, [0, 1, 2, 4, 5]]
        np.testing.assert_array_equal(points.view(np.uint32),
                                      np.frombuffer(compact.data, np.uint32).reshape(-1, 5))

    def test_dense_cloud(self):
        self.reconfigure(cloud_dense=True)
        self.listen("disparity", "points2")
        results = self.match(self.camera.next_frame())
        cloud = results["points2"]
        self.assertTrue(cloud.is_dense)
        self.assertEqual((cloud.height, cloud.width), (1, is_valid(results["disparity"]).sum()))
        self.assertTrue(np.isfinite(np.frombuffer(cloud.data, np.float32)
                                    .reshape(-1, 8)[:, :3]).all())

    def test_filtered_cloud(self):
        self.reconfigure(cloud_voxel_size=0.1, cloud_outlier_neighbors=10)
        self.listen("points2")
        cloud = self.match(self.camera.next_frame())["points2"]
        self.assertTrue(cloud.is_dense)
        self.assertEqual(cloud.height, 1)
        self.assertGreater(cloud.width, 50)
        self.assertLess(cloud.width, rig.WIDTH * rig.HEIGHT / 20)

    def test_range_in_metres(self):
        """Nearer than the board and farther than the wall, and then the board is too near."""
        near, far = DEPTH / (rig.BOARD + 5), DEPTH / (rig.WALL + 5)
        self.listen("disparity")
        self.reconfigure(min_depth=0.9 * near, max_depth=1.2 * far)
        message = self.match(self.camera.next_frame())["disparity"]
        rig.check_disparity(self, message)
        self.assertLess(abs(message.min_disparity - DEPTH / (1.2 * far)), 2)
        self.assertLess(abs(message.max_disparity - DEPTH / (0.9 * near)), 2)
        self.reconfigure(min_depth=0.7 * far)
        message = self.match(self.camera.next_frame())["disparity"]
        self.assertLess(message.max_disparity, rig.BOARD + 5)

    def test_range_that_can_not_be_searched(self):
        self.listen("disparity")
        self.reconfigure(min_depth=0.01)
        message = self.match(self.camera.next_frame())["disparity"]
        self.log.wait_for("min_depth 0.01 m takes")
        self.assertLess(message.max_disparity, rig.WIDTH + 5)

    def test_depths_in_the_wrong_order_are_refused(self):
        after = self.reconfigure(min_depth=3.0, max_depth=2.0)
        self.assertEqual((after["min_depth"], after["max_depth"]), (0, 0))
        self.log.wait_for("min_depth is 3 m and max_depth 2 m; expected the first to be less")


if __name__ == "__main__":
    rospy.init_node("outputs_test")
    rostest.rosrun("stereo_sgmp", "outputs_test", OutputsTest, sys.argv)
