"""What scripts/bench makes of the times that the benchmark program reports."""
import json
import unittest

from bench_tools import main, roofline, tables
from bench_tools.bars import BARS, check, check_all
from bench_tools.measure import measurements_of
from bench_tools.plan import FULL, HALF, QUICK_SIZES, SIZES, full_plan, parse_size, quick_plan
from bench_tools.results import merged, rows_of_group


def run(name, ms, **counters):
    return {"name": name + "/iterations:1/real_time", "run_type": "iteration", "real_time": ms,
            "cpu_time": ms, "iterations": 1, "time_unit": "ms", "repetitions": 1, "threads": 1,
            "repetition_index": 0, "run_name": "", "family_index": 0,
            "per_family_instance_index": 0, **counters}


def rows(*runs, first=(), size=HALF):
    return rows_of_group(measurements_of({"benchmarks": list(runs)}),
                         measurements_of({"benchmarks": list(first)}), size)


def bar(case, size=HALF):
    return next(bar for bar in BARS if bar.case == case and bar.size == size)


class RowsTest(unittest.TestCase):
    def test_medians_of_runs_and_of_stages(self):
        row = rows(run("frame/default/2", 10.0, **{"ms cost": 3.0}),
                   run("frame/default/2", 12.0, **{"ms cost": 5.0}),
                   run("frame/default/2", 90.0, **{"ms cost": 4.0}))["frame/default/2"]
        self.assertEqual((row.subject, row.threads), ("frame/default", 2))
        self.assertEqual((row.fastest_ms, row.ms, row.slowest_ms), (10.0, 12.0, 90.0))
        self.assertEqual(row.stages, {"cost": 4.0})
        self.assertAlmostEqual(row.mde_per_second, 1440 * 994 * 256 / 12e-3 * 1e-6)

    def test_ratio_to_the_reference_with_as_many_threads(self):
        of = rows(run("frame/default/1", 30.0), run("frame/default/2", 15.0),
                  run("opencv/sgbm_3way/1", 20.0), run("opencv/sgbm_3way/2", 12.0))
        self.assertEqual(of["frame/default/1"].of_reference, 1.5)
        self.assertEqual(of["frame/default/2"].of_reference, 1.25)

    def test_the_first_run_and_its_memory(self):
        of = rows(run("frame/default/2", 15.0),
                  first=[run("first/frame/default/2", 45.0, peak_bytes=7e8)])
        self.assertEqual(of["frame/default/2"].first_ms, 45.0)
        self.assertEqual(of["frame/default/2"].peak_bytes, 7e8)

    def test_groups_keep_the_ratio_of_the_runs_that_took_turns(self):
        slow = rows(run("frame/default/2", 30.0), run("opencv/sgbm_3way/2", 20.0))
        quick = rows(run("frame/paper/2", 30.0), run("opencv/sgbm_3way/2", 10.0))
        of = merged([slow, quick])
        self.assertEqual(of["frame/default/2"].of_reference, 1.5)
        self.assertEqual(of["frame/paper/2"].of_reference, 3.0)
        self.assertEqual(of["opencv/sgbm_3way/2"].ms, 15.0)


class BarsTest(unittest.TestCase):
    def test_met_missed_and_not_measured(self):
        of = {HALF: rows(run("frame/default/2", 10.0), run("opencv/sgbm_3way/2", 10.0),
                         run("opencv/hh/2", 100.0))}
        self.assertEqual(check(bar("default / StereoSGBM 3WAY"), of).verdict, "met")
        self.assertEqual(check(bar("default / StereoSGBM HH"), of).verdict, "MISSED")
        self.assertEqual(check(bar("default with EPi / without prior"), of).verdict,
                         "not measured")

    def test_a_bar_that_more_is_better_for(self):
        of = {HALF: rows(run("frame/default/1", 18.0), run("frame/default/2", 10.0))}
        self.assertEqual(check(bar("default with 1 thread / with 2"), of).verdict, "met")
        of = {HALF: rows(run("frame/default/1", 17.0), run("frame/default/2", 10.0))}
        self.assertEqual(check(bar("default with 1 thread / with 2"), of).verdict, "MISSED")

    def test_the_first_frame_against_the_warm_one(self):
        of = {FULL: rows(run("frame/default/2", 10.0), size=FULL,
                         first=[run("first/frame/default/2", 25.0, peak_bytes=1.0)])}
        self.assertEqual(check(bar("first frame of default / warm frame", FULL), of).ratio, 2.5)


class PlanTest(unittest.TestCase):
    def test_the_plans_measure_what_the_bars_need(self):
        for sizes, make_plan in ((SIZES, full_plan), (QUICK_SIZES, quick_plan)):
            for size in sizes:
                plan = make_plan(size)
                names = {"%s/%d" % subject for group in plan.groups for subject in group.subjects}
                names |= {"first/%s/%d" % subject for subject in plan.first}
                for of_size in BARS:
                    if of_size.size == size:
                        self.assertIn(of_size.ours, names)
                        self.assertIn(of_size.reference, names)

    def test_sizes_are_read(self):
        self.assertEqual(parse_size("1440x994x256"), HALF)
        with self.assertRaisesRegex(ValueError, "'640x480' is no size"):
            parse_size("640x480")


class RooflineTest(unittest.TestCase):
    CEILINGS = {"ceiling/byte_operations/2": 500.0, "ceiling/memory_read/2": 22.0,
                "ceiling/memory_stream/2": 18.0}

    def test_the_nearer_ceiling_counts(self):
        of = rows(run("stage/aggregation_none/2", 400.0), run("stage/images/2", 1.0),
                  run("stage/prior_epv/2", 9.0), run("stage/images/1", 1.0))
        aggregation, images = roofline.lines(of, HALF, self.CEILINGS, 2)
        volume = 1440 * 994 * 256
        self.assertAlmostEqual(aggregation.memory_ms, 2 * volume / 20e6)
        self.assertAlmostEqual(aggregation.share, aggregation.operations_ms / 400.0)
        self.assertAlmostEqual(images.share, images.memory_ms)
        self.assertIn("| stage/images | 0.0 | 0.03 | 1.0 |",
                      tables.roofline_section(self.CEILINGS, {HALF: [images]}))


class OutputTest(unittest.TestCase):
    def test_page_and_json_hold_the_bars_and_rows(self):
        of = {HALF: rows(run("frame/default/2", 10.0, **{"ms cost": 3.0}),
                         run("opencv/sgbm_3way/2", 20.0))}
        checks = check_all(of)
        page = tables.page({"cores": 2}, checks, of, "## Roofline")
        self.assertIn("| default / StereoSGBM 3WAY | 1440x994x256 | 10.0 | 20.0 | 0.500 | ≤ 1 | "
                      "met |", page)
        self.assertIn("| frame/default | 2 | 10.0 |", page)
        document = json.loads(main.as_json({"cores": 2}, checks, of, {}))
        self.assertEqual(document["sizes"]["1440x994x256"][0]["ms"], 10.0)
        self.assertEqual(document["bars"][0]["verdict"], "met")


if __name__ == "__main__":
    unittest.main()
