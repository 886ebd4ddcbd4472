#!/usr/bin/python3
"""Makes the overview pictures and the report of scripts/demo from the files of each scene."""
import argparse
import csv
import json
import os
import sys

import numpy as np

from overview import write_overview
from pfm import read_pfm

_THRESHOLDS = ("0.5", "1", "2")

# Where each cloud is looked at from: degrees to the right and above.
_VIEWS = {"motorcycle": (22, 14), "aloe": (24, 12), "corridor": (60, 35)}

_HEAD = """# Demonstration

Each pair went through the nodelet by a bag, and through the command-line tool with and without
orientation prior. Errors are percentages of the pixels that both cameras see and whose true
disparity is known. In Motorcycle and Aloe, which pixels both see is worked out from the left
ground truth.
"""


def read_scores(path):
    with open(path) as file:
        return next(csv.DictReader(file))


def error_table(scores):
    lines = ["| bad pixels, % | " + " | ".join("> %s px" % t for t in _THRESHOLDS) + " |",
             "|---|" + "---:|" * len(_THRESHOLDS)]
    for map_name, caption in (("raw", "unfiltered"), ("dense", "holes filled")):
        for variant, row in scores.items():
            values = ["%.2f" % float(row["%s_bad_%s" % (map_name, t)]) for t in _THRESHOLDS]
            lines.append("| %s, %s | %s |" % (variant, caption, " | ".join(values)))
    return lines


def nodelet_lines(folder):
    published = read_pfm(os.path.join(folder, "disparity.pfm"))
    ground_truth = read_pfm(os.path.join(folder, "ground_truth.pfm"))
    with open(os.path.join(folder, "statistics.json")) as file:
        statistics = json.load(file)
    valid = np.isfinite(published)
    known = valid & np.isfinite(ground_truth)
    wrong = np.abs(published[known] - ground_truth[known]) > 2.0
    return [
        "The nodelet took %.0f ms for the frame with %d planes. It published disparities at "
        "%.1f %% of the pixels, of which %.2f %% are wrong by more than 2 px." %
        (statistics["frame_ms"], statistics["planes"], 100 * valid.mean(), 100 * wrong.mean()),
    ]


def scene_section(name, folder):
    scores = {caption: read_scores(os.path.join(folder, file))
              for caption, file in (("SGM", "scores_sgm.csv"), ("SGM-P", "scores.csv"))}
    return ["", "## %s" % name, "", *error_table(scores), "", *nodelet_lines(folder), "",
            "![%s](%s/overview.jpg)" % (name, name)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", help="holds a folder for each scene")
    parser.add_argument("scenes", nargs="+", help="names of those folders")
    arguments = parser.parse_args()
    lines = []
    for name in arguments.scenes:
        folder = os.path.join(arguments.folder, name)
        write_overview(folder, _VIEWS[name])
        lines += scene_section(name, folder)
    with open(os.path.join(arguments.folder, "report.md"), "w") as file:
        file.write(_HEAD + "\n".join(lines) + "\n")
    print("\n".join(line for line in lines if not line.startswith("![")))


if __name__ == "__main__":
    sys.exit(main())
