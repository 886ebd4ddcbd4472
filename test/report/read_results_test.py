"""Reading and checking results.json."""
import json
import os
import tempfile
import unittest

import made_results
from report_tools.read_results import ReportError, read_results


class ResultsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.content = made_results.document(["aloe", "room"], ["sgm", "epi"], [
            made_results.result("aloe", "sgm", 10.0, 1.0),
            made_results.result("aloe", "epi", 8.0, 1.5),
            made_results.result("room", "sgm", 20.0, 2.0)])

    def read(self):
        made_results.write(self.folder, self.content, pictures=False)
        return read_results(self.folder)

    def sentence(self):
        with self.assertRaises(ReportError) as context:
            self.read()
        return str(context.exception)

    def test_values_by_scene_and_variant(self):
        results = self.read()
        self.assertEqual(results.value("aloe", "epi", results.bad("raw", 2)), 8.0)
        self.assertAlmostEqual(results.value("aloe", "epi", results.bad("dense", 1)), 10.24)
        self.assertIsNone(results.value("room", "epi", results.bad("raw", 2)))

    def test_known_scenes_are_those_of_all_variants(self):
        results = self.read()
        self.assertEqual(results.known(results.bad("raw", 2)), (["sgm", "epi"], ["aloe"]))

    def test_variant_without_any_value_does_not_shrink_the_known_scenes(self):
        self.content["results"][1]["area_u"] = None
        results = self.read()
        self.assertEqual(results.known(lambda score: score.area_u), (["sgm"], ["aloe", "room"]))

    def test_null_lists_and_numbers_that_are_not_finite_are_not_known(self):
        self.content["results"][0]["bad_raw"] = None
        self.content["results"][0]["seconds"] = float("nan")
        self.content["results"][1]["seconds"] = 10**400
        self.content["results"][1]["curve"] = None
        results = self.read()
        self.assertEqual(results.scores["aloe", "sgm"].bad_raw, (None, None, None))
        self.assertEqual(results.values("sgm", lambda score: score.seconds), {"room": 2.0})
        self.assertEqual(results.values("epi", lambda score: score.seconds), {})
        self.assertEqual(results.scores["aloe", "epi"].curve.error_u, ())

    def test_missing_file_says_how_to_make_it(self):
        with self.assertRaisesRegex(ReportError, "results.json: there is no such file.*evaluate"):
            read_results(self.folder)

    def test_not_json(self):
        for text in ("", "{", "\x00", "[" * 100000):
            with open(os.path.join(self.folder, "results.json"), "w") as file:
                file.write(text)
            with self.assertRaisesRegex(ReportError, "results.json: not a JSON file"):
                read_results(self.folder)

    def test_other_format(self):
        self.content["format"] = 2
        self.assertIn("results.json.format: expected 1, found 2", self.sentence())

    def test_not_a_map(self):
        self.content = [1, 2]
        self.assertIn("results.json: expected a map, found [1, 2]", self.sentence())

    def test_every_key_is_needed(self):
        complete = json.dumps(self.content)
        for key in self.content:
            self.content = json.loads(complete)
            del self.content[key]
            self.assertIn("has no \"%s\"" % key, self.sentence())

    def test_every_key_of_a_result_is_needed_but_those_worked_out_here(self):
        complete = json.dumps(self.content)
        for key in set(self.content["results"][0]) - {"gain", "overhead"}:
            self.content = json.loads(complete)
            del self.content["results"][1][key]
            self.assertIn("results[1]: has no \"%s\"" % key, self.sentence())

    def test_wrong_number_of_errors(self):
        self.content["results"][2]["bad_raw"] = [1.0]
        self.assertIn("results[2].bad_raw: expected a list of 3 numbers, found [1.0]",
                      self.sentence())

    def test_wrong_types(self):
        complete = json.dumps(self.content)
        for path, value in ((("results", 0, "seconds"), "1"), (("results", 0, "bad_raw"), 5),
                            (("results", 0, "invalid"), True), (("results", 0, "curve"), 3),
                            (("results", 0), None), (("scenes", 1, "width"), -3),
                            (("scenes", 1, "name"), ""), (("variants",), {}),
                            (("variants",), [1]), (("options",), []), (("machine",), None),
                            (("thresholds",), [0]), (("thresholds",), []),
                            (("report_threshold",), None), (("results", 0, "scene"), ["aloe"])):
            self.content = json.loads(complete)
            parent = self.content
            for step in path[:-1]:
                parent = parent[step]
            parent[path[-1]] = value
            self.assertRegex(self.sentence(), "expected .*, found .", path)

    def test_curves_of_different_lengths(self):
        self.content["results"][0]["curve"]["error_u"].pop()
        self.assertIn("results[0].curve.error_u: expected a list of 100 numbers", self.sentence())

    def test_report_threshold_is_one_of_the_thresholds(self):
        self.content["report_threshold"] = 3
        self.assertIn("report_threshold: expected one of the thresholds, found 3", self.sentence())

    def test_unknown_names_and_repetitions(self):
        self.content["results"][0]["scene"] = "piano"
        self.assertIn("expected one of the scenes, found \"piano\"", self.sentence())
        self.content["results"][0]["scene"] = "room"
        self.assertIn("sgm on room occurs twice", self.sentence())
        self.content["variants"].append("sgm")
        self.assertIn("variants: \"sgm\" occurs twice", self.sentence())

    def test_no_results(self):
        self.content["results"] = []
        self.assertIn("holds no results", self.sentence())


if __name__ == "__main__":
    unittest.main()
