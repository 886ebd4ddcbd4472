"""scripts/report as users run it."""
import json
import os
import re
import subprocess
import tempfile
import unittest
from urllib.parse import unquote

import made_results
import report_tools

_SCRIPT = os.path.join(os.path.dirname(os.path.dirname(report_tools.__file__)), "report")


def run_script(folder, *arguments):
    return subprocess.run([_SCRIPT, folder, *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, check=False)


def read_text(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


class CompleteReportTest(unittest.TestCase):
    """The report of a folder that has everything."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = cls.temporary.name
        content = made_results.plausible(["aloe", "my room"], ["sgm", "epi"])
        content["min_error_share"] = 0.05
        made_results.write(cls.folder, content)
        cls.done = run_script(cls.folder, "--command", "scripts/reproduce a b")
        cls.markdown = read_text(cls.folder, "report.md")
        cls.page = read_text(cls.folder, "report.html")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_says_where_the_report_lies(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(self.done.stdout.split(), [os.path.join(self.folder, "report.md"),
                                                    os.path.join(self.folder, "report.html")])

    def test_both_have_all_sections(self):
        sections = ["Means", "Error against completeness", "Gains over SGM", "Errors per scene",
                    "Run times", "Error maps", "Options"]
        self.assertEqual(re.findall(r"^## (.*)$", self.markdown, re.MULTILINE), sections)
        self.assertEqual(re.findall(r"<h2>(.*)</h2>", self.page), sections)

    def test_all_links_exist(self):
        links = re.findall(r"!\[[^]]*\]\(([^)]*)\)", self.markdown)
        links += re.findall(r"(?:src|href)=\"([^\"]*)\"", self.page)
        self.assertGreater(len(links), 30)
        for link in links:
            self.assertTrue(os.path.isfile(os.path.join(self.folder, unquote(link))), link)

    def test_head_says_what_was_run(self):
        head = self.markdown.split("## Means")[0]
        for line in ("- Scenes: 2", "- Variants: SGM, SGM-EPi", "- Threads: 4",
                     "- Thresholds: 0.5, 1, 2 px; curves and gains at 2 px",
                     "- Errors up to 5 % of the true disparity do not count",
                     "    scripts/reproduce a b"):
            self.assertIn(line + "\n", head)
        self.assertIn("| prior/min\\_support | 0.2 |", self.markdown)

    def test_disparities_stand_above_errors(self):
        rows = self.markdown.split("### aloe\n\n")[1].split("\n")[:4]
        self.assertEqual(rows[0], "| left image, truth | SGM | SGM-EPi |")
        self.assertEqual(re.findall(r"\((.*?)\)", rows[2]),
                         ["maps/aloe_left.png", "maps/aloe_sgm_disparity.png",
                          "maps/aloe_epi_disparity.png"])
        self.assertEqual(re.findall(r"\((.*?)\)", rows[3]),
                         ["maps/aloe_truth.png", "maps/aloe_sgm_error.png",
                          "maps/aloe_epi_error.png"])


class IncompleteReportTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_what_is_missing_is_said(self):
        content = made_results.plausible(["aloe", "room"], ["epi", "other"])
        for result in content["results"]:
            result.update(curve=None, seconds=None, bad_dense=None)
        made_results.write(self.folder, content, pictures=False)
        done = run_script(self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        markdown = read_text(self.folder, "report.md")
        for sentence in ("There are no curves by the uncertainty U.",
                         "They need results of SGM", "There are no pictures in maps/.",
                         "There is no scene on which the times of all variants are known."):
            self.assertIn(sentence, markdown)
        self.assertNotIn("![", markdown)
        dense = markdown.split("### Bad 2, dense map, percent\n\n")[1].split("\n")
        self.assertEqual(dense[2], "| aloe | - | - |")

    def test_bad_input_is_one_sentence(self):
        content = made_results.plausible(["aloe"], ["sgm"])
        content["results"][0]["seconds"] = "long"
        made_results.write(self.folder, content)
        done = run_script(self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, "report: %s/results.json.results[0].seconds: expected a "
                         "number or null, found \"long\"\n" % self.folder)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "report.md")))

    def test_missing_results_are_one_sentence(self):
        done = run_script(self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\Areport: .*results.json: there is no such file; .*\n\Z")

    def test_folder_that_cannot_be_written(self):
        made_results.write(self.folder, made_results.plausible(["aloe"], ["sgm"]))
        with open(os.path.join(self.folder, "figures"), "w") as file:
            json.dump("not a folder", file)
        done = run_script(self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"\Areport: .*figures: .*\n\Z")


if __name__ == "__main__":
    unittest.main()
