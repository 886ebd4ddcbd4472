"""The numbers of the tables."""
import tempfile
import unittest

import made_results
from report_tools import tables
from report_tools.gains import gains_over_baseline, percent_less, scenes_by_gain
from report_tools.read_results import read_results


def read(content):
    with tempfile.TemporaryDirectory() as folder:
        made_results.write(folder, content, pictures=False)
        return read_results(folder)


def example():
    """Gains of epi: aloe 20 %, room -1 %, fence -0.4 %; gs lacks the fence."""
    return made_results.document(["aloe", "room", "fence"], ["sgm", "epi", "gs"], [
        made_results.result("aloe", "sgm", 10.0, 1.0),
        made_results.result("aloe", "epi", 8.0, 1.5),
        made_results.result("aloe", "gs", 5.0, 1.1),
        made_results.result("room", "sgm", 30.0, 3.0),
        made_results.result("room", "epi", 30.3, 3.5),
        made_results.result("room", "gs", 6.0, 3.3),
        made_results.result("fence", "sgm", 5.0, 1.0),
        made_results.result("fence", "epi", 5.02, 2.0)])


class GainsTest(unittest.TestCase):
    def test_percent_less(self):
        self.assertEqual(percent_less(8.0, 10.0), 20.0)
        self.assertEqual(percent_less(12.0, 10.0), -20.0)
        self.assertIsNone(percent_less(None, 10.0))
        self.assertIsNone(percent_less(8.0, None))
        self.assertIsNone(percent_less(8.0, 0.0))

    def test_means_are_of_the_scenes_that_both_have(self):
        results = read(example())
        gains = gains_over_baseline(results, "gs", results.bad("raw", 2))
        self.assertEqual(gains.by_scene, {"aloe": 50.0, "room": 80.0})
        self.assertEqual(gains.mean_of_gains, 65.0)
        self.assertEqual(gains.gain_of_means, 72.5)  # 11 in place of 40 errors

    def test_worse_scenes_are_those_with_half_a_percent_more(self):
        results = read(example())
        self.assertEqual(gains_over_baseline(results, "epi", results.bad("raw", 2)).worse,
                         ("room",))

    def test_scenes_by_gain_of_epi_whatever_the_others(self):
        results = read(example())
        self.assertEqual(scenes_by_gain(results, results.bad("raw", 2)), ["room", "fence", "aloe"])

    def test_scenes_without_gain_come_last(self):
        content = example()
        del content["results"][4]
        results = read(content)
        self.assertEqual(scenes_by_gain(results, results.bad("raw", 2)), ["fence", "aloe", "room"])

    def test_without_epi_the_next_variant_sorts(self):
        content = example()
        content["variants"].remove("epi")
        content["results"] = [r for r in content["results"] if r["variant"] != "epi"]
        results = read(content)
        self.assertEqual(scenes_by_gain(results, results.bad("raw", 2)), ["aloe", "room", "fence"])


class TablesTest(unittest.TestCase):
    def test_errors_per_scene(self):
        results = read(example())
        table = tables.per_scene(results, results.bad("raw", 2))
        self.assertEqual(table.head, ("scene", "SGM", "SGM-EPi", "SGM-GS"))
        self.assertEqual(table.rows, (("aloe", "10.00", "8.00", "5.00"),
                                      ("room", "30.00", "30.30", "6.00"),
                                      ("fence", "5.00", "5.02", "-")))
        self.assertEqual(table.foot, (("mean of 2 scenes", "20.00", "19.15", "5.50"),))

    def test_summary(self):
        table = tables.summary(read(example()))
        self.assertEqual(table.head[:7], ("variant", "raw bad 0.5", "raw bad 1", "raw bad 2",
                                          "dense bad 0.5", "dense bad 1", "dense bad 2"))
        self.assertEqual(table.rows[1][:7],
                         ("SGM-EPi", "57.45", "30.64", "19.15", "45.96", "24.51", "15.32"))
        self.assertEqual(table.rows[1][7:], ("22.98", "12.26", "7.66", "8.00", "3.83", "6.38",
                                             "4.79", "2.13"))
        self.assertEqual(table.foot[0][1:], ("2",) * 14)

    def test_gains(self):
        results = read(example())
        table = tables.gains(results, results.bad("raw", 2))
        self.assertEqual(table.rows, (("room", "30.00", "-1.0", "+80.0"),
                                      ("fence", "5.00", "-0.4", "-"),
                                      ("aloe", "10.00", "+20.0", "+50.0")))
        self.assertEqual(table.foot, (
            ("mean of gains", "", "+6.2", "+65.0"),
            ("gain of means", "", "+3.7", "+72.5"),
            ("scenes worse by more than 0.5 %", "", "1 of 3", "0 of 2")))

    def test_gain_summary(self):
        table = tables.gain_summary(read(example()))
        self.assertEqual(table.head, ("variant", "raw bad 0.5", "raw bad 1", "raw bad 2",
                                      "dense bad 0.5", "dense bad 1", "dense bad 2"))
        self.assertEqual(table.rows[0], ("SGM-EPi",) + ("+6.2 / +3.7 / 1",) * 6)

    def test_gains_without_sgm(self):
        content = example()
        content["variants"].remove("sgm")
        content["results"] = [r for r in content["results"] if r["variant"] != "sgm"]
        table = tables.gain_summary(read(content))
        self.assertEqual([row[1] for row in table.rows], ["-", "-"])

    def test_seconds_and_overhead(self):
        table = tables.seconds(read(example()))
        self.assertEqual(table.rows[0], ("aloe (640 x 480, 70)", "1.00", "1.50", "1.10"))
        self.assertEqual(table.foot, (("mean of 2 scenes", "2.00", "2.50", "2.20"),
                                      ("mean overhead over SGM", "-", "+56 %", "+10 %")))

    def test_no_scene_that_all_variants_have(self):
        content = example()
        content["results"] = [content["results"][0], content["results"][4]]
        results = read(content)
        self.assertEqual(tables.per_scene(results, results.bad("raw", 2)).foot,
                         (("mean of 0 scenes", "-", "-", "-"),))
        self.assertEqual(tables.seconds(results).foot[1],
                         ("mean overhead over SGM", "-", "-", "-"))

    def test_options_by_their_paths(self):
        content = example()
        content["options"] = {"a": {"b": True, "c": {"d": 0.25}}, "e": None, "f": [1, "x"]}
        self.assertEqual(tables.options_table(read(content)).rows,
                         (("a/b", "true"), ("a/c/d", "0.25"), ("e", "-"), ("f", "1, x")))


if __name__ == "__main__":
    unittest.main()
