"""What the figures show, by the text and the colours of their SVG files."""
import math
import os
import re
import tempfile
import unittest

import made_results
from report_tools.bars import draw_gains, draw_seconds
from report_tools.curves import BY_CONFIDENCE, BY_U, draw_curves, mean_lines, scene_lines
from report_tools.figures import drawing
from report_tools.read_results import read_results
from report_tools.style import shorten, variant_styles

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


class FiguresTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        style = drawing()
        style.__enter__()
        self.addCleanup(style.__exit__, None, None, None)

    def read(self, content):
        made_results.write(self.folder, content, pictures=False)
        return read_results(self.folder)

    def file(self, name):
        with open(os.path.join(self.folder, "figures", name), "rb") as file:
            return file.read()

    def texts(self, name):
        """In the order in which they were drawn."""
        return re.findall(r"<text [^>]*>([^<]*)</text>", self.file(name + ".svg").decode())

    def test_bars_stand_in_the_order_of_the_gain_of_epi(self):
        results = self.read(made_results.document(
            ["aloe", "room", "fence"], ["sgm", "epi"],
            [made_results.result(scene, variant, error, 1.0)
             for scene, variant, error in (("aloe", "sgm", 10), ("aloe", "epi", 5),
                                           ("room", "sgm", 10), ("room", "epi", 11),
                                           ("fence", "sgm", 10), ("fence", "epi", 9))]))
        self.assertTrue(draw_gains(results, results.bad("raw", 2), "gains"))
        texts = self.texts("gains")
        self.assertEqual([text for text in texts if text in ("aloe", "room", "fence")],
                         ["room", "fence", "aloe"])
        self.assertIn("SGM-EPi", texts)
        self.assertNotIn("SGM", texts)
        self.assertTrue(self.file("gains.png").startswith(_SIGNATURE))

    def test_bars_far_below_say_their_value(self):
        results = self.read(made_results.document(["aloe"], ["sgm", "other"], [
            made_results.result("aloe", "sgm", 10, 1.0),
            made_results.result("aloe", "other", 33, 1.0)]))
        draw_gains(results, results.bad("raw", 2), "gains")
        self.assertIn("-230", self.texts("gains"))

    def test_small_gains_are_not_dwarfed_by_far_worse_methods(self):
        results = self.read(made_results.document(["aloe"], ["sgm", "epi", "other"], [
            made_results.result("aloe", "sgm", 10, 1.0), made_results.result("aloe", "epi", 8, 1.0),
            made_results.result("aloe", "other", 13, 1.0)]))
        draw_gains(results, results.bad("raw", 2), "gains")
        texts = self.texts("gains")
        self.assertIn("-30", texts)  # is cut at -10
        self.assertNotIn("\u221230", texts)  # on the axis

    def test_no_gains_without_sgm(self):
        results = self.read(made_results.plausible(["aloe"], ["epi", "gs"]))
        self.assertFalse(draw_gains(results, results.bad("raw", 2), "gains"))

    def test_run_times_and_overhead(self):
        results = self.read(made_results.plausible(["aloe"], ["sgm", "epi", "gnv"]))
        self.assertTrue(draw_seconds(results, "seconds"))
        texts = self.texts("seconds")
        for text in ("0.50 s", "0.60 s  +20 %", "1.30 s  +160 %", "SGM-GNv"):
            self.assertIn(text, texts)

    def test_no_run_times(self):
        content = made_results.plausible(["aloe"], ["sgm"])
        content["results"][0]["seconds"] = None
        self.assertFalse(draw_seconds(self.read(content), "seconds"))

    def test_curves_have_a_plot_per_scene_and_the_mean(self):
        results = self.read(made_results.plausible(["aloe", "room"], ["sgm", "epi"]))
        self.assertTrue(draw_curves(results, BY_U))
        texts = self.texts("curves_u")
        self.assertEqual([text for text in texts if text in ("aloe", "room", "mean of 2 scenes")],
                         ["aloe", "room", "mean of 2 scenes"])
        self.assertIn("bad 2, %", texts)
        self.assertIn("SGM-EPi", texts)

    def test_one_scene_has_no_mean(self):
        results = self.read(made_results.plausible(["aloe"], ["sgm", "epi"]))
        draw_curves(results, BY_CONFIDENCE)
        self.assertFalse([text for text in self.texts("curves_confidence") if "mean" in text])

    def test_no_curves(self):
        content = made_results.plausible(["aloe"], ["sgm"])
        content["results"][0]["curve"] = None
        self.assertFalse(draw_curves(self.read(content), BY_U))

    def test_lines_are_in_percent_with_gaps(self):
        content = made_results.plausible(["aloe"], ["sgm"])
        content["results"][0]["curve"] = {"completeness": [0.5, 1.0], "error_u": [None, 3.0],
                                          "error_confidence": [None, None]}
        results = self.read(content)
        line = scene_lines(results, "aloe", BY_U)["sgm"]
        self.assertEqual(line.completeness, (50.0, 100.0))
        self.assertTrue(math.isnan(line.error[0]))
        self.assertEqual(line.error[1], 3.0)
        self.assertEqual(scene_lines(results, "aloe", BY_CONFIDENCE), {})

    def test_mean_is_of_the_scenes_that_all_drawn_variants_have(self):
        results = self.read(made_results.document(["aloe", "room", "fence"], ["sgm", "epi", "gs"], [
            made_results.result("aloe", "sgm", 10, 1), made_results.result("aloe", "epi", 8, 1),
            made_results.result("room", "sgm", 20, 1), made_results.result("room", "epi", 12, 1),
            made_results.result("fence", "sgm", 90, 1)]))
        lines, count = mean_lines(results, BY_U)
        self.assertEqual(count, 2)
        self.assertEqual(list(lines), ["sgm", "epi"])
        self.assertAlmostEqual(lines["sgm"].error[-1], 15.0)
        self.assertAlmostEqual(lines["epi"].error[-1], 10.0)

    def test_every_variant_keeps_its_colour(self):
        few, many = variant_styles(["sgm", "gs"]), variant_styles(["x", "epi", "gs", "sgm", "y"])
        self.assertEqual(few["gs"], many["gs"])
        self.assertEqual(len({style.color for style in many.values()}), 5)
        results = self.read(made_results.plausible(["aloe", "room"], ["sgm", "gs"]))
        draw_curves(results, BY_U)
        draw_gains(results, results.bad("raw", 2), "gains")
        for name in ("curves_u.svg", "gains.svg"):
            self.assertIn(few["gs"].color, self.file(name).decode())

    def test_thirty_scenes_with_long_names(self):
        scenes = ["a_scene_with_quite_a_long_name_%02d" % index for index in range(30)]
        results = self.read(made_results.plausible(scenes, ["sgm", "epi", "epv", "gs", "mw"]))
        self.assertTrue(draw_gains(results, results.bad("raw", 2), "gains"))
        names = [text for text in self.texts("gains") if text.startswith("a_scene")]
        self.assertEqual(len(set(names)), 30)

    def test_the_same_numbers_make_the_same_files(self):
        results = self.read(made_results.plausible(["aloe"], ["sgm", "epi"]))
        draw_gains(results, results.bad("raw", 2), "gains")
        first = self.file("gains.svg"), self.file("gains.png")
        draw_gains(results, results.bad("raw", 2), "gains")
        self.assertEqual((self.file("gains.svg"), self.file("gains.png")), first)

    def test_shortened_names_keep_both_ends(self):
        self.assertEqual(shorten("corridor", 8), "corridor")
        self.assertEqual(shorten("corridor_12", 8), "cor…r_12")


if __name__ == "__main__":
    unittest.main()
