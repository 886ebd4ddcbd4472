#!/usr/bin/python3
"""Times frames and stages beside OpenCV's StereoSGBM; writes results.json and report.md."""
import argparse
import json
import os
import subprocess
import sys

repo = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(repo, "scripts"))

# pylint: disable=wrong-import-position
from bench_tools import plan, roofline, tables
from bench_tools.bars import check_all
from bench_tools.measure import BenchError, run_benchmarks
from bench_tools.results import merged, rows_of_group

PROGRAM = os.path.join(repo, "build/bench/bin/stereo_benchmark")
CEILINGS = os.path.join(repo, "build/bench/bin/ceiling_benchmark")
RENDER = os.path.join(repo, "build/devel/lib/stereo_sgmp/render_scene")
SCENES = os.path.join(repo, "build/bench/scenes")


def parse_arguments():
    parser = argparse.ArgumentParser(prog="scripts/bench", description=__doc__)
    parser.add_argument("--quick", action="store_true",
                        help="two sizes and the subjects of the bars only, in about a minute")
    parser.add_argument("--pair", nargs=2, metavar=("LEFT", "RIGHT"),
                        help="resize these images to the sizes, instead of generated ones")
    parser.add_argument("--sizes", help="such as 640x480x128,1440x994x256")
    parser.add_argument("--out", default=os.path.join(repo, "build/bench/results"),
                        help="folder to write to (build/bench/results)")
    return parser.parse_args()


def generated_pair(size):
    folder = os.path.join(SCENES, "room_" + str(size))
    pair = tuple(os.path.join(folder, name) for name in ("im0.png", "im1.png"))
    if not all(map(os.path.exists, pair)):
        subprocess.run([RENDER, "room", folder, "--width", str(size.width), "--height",
                        str(size.height), "--disparities", str(size.disparities)],
                       check=True, stdout=subprocess.DEVNULL)
    return pair


def measure_size(size, the_plan, pair, machine):
    arguments = [*(pair or generated_pair(size)), *map(str, size)]
    first = {}
    for subject, threads in the_plan.first:
        name = "first/%s/%d" % (subject, threads)
        first.update(run_benchmarks(PROGRAM, arguments, [name], 1)[0])
    groups = []
    for number, group in enumerate(the_plan.groups, 1):
        print("%s: group %d of %d" % (size, number, len(the_plan.groups)), flush=True)
        names = ["%s/%d" % subject for subject in group.subjects]
        measurements, context = run_benchmarks(PROGRAM, arguments, names, group.repetitions)
        machine.update({"cores": context["num_cpus"], "SIMD": context["simd_target"],
                        "OpenCV": context["opencv"], "compiler": context["compiler"]})
        groups.append(rows_of_group(measurements, first, size))
    return merged(groups)


def measure_ceilings():
    """10^9 bytes or operations per second, of the best run, by the name of the benchmark."""
    print("ceilings of the machine", flush=True)
    measurements, _ = run_benchmarks(CEILINGS, [], ["ceiling/.*"], 5)
    return {name: of.counters["G/s"] * of.median_ms / min(of.ms)
            for name, of in measurements.items()}


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return next((line.split(":", 1)[1].strip() for line in file
                     if line.startswith("model name")), "unknown")


def save(out, name, text):
    path = os.path.join(out, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    print(path)


def as_json(machine, checks, rows_by_size, ceilings):
    return json.dumps({
        "machine": machine,
        "ceilings": ceilings,
        "bars": [{**check.bar._asdict(), "size": str(check.bar.size), "ours_ms": check.ours_ms,
                  "reference_ms": check.reference_ms, "ratio": check.ratio,
                  "verdict": check.verdict} for check in checks],
        "sizes": {str(size): [row._asdict() for row in rows.values()]
                  for size, rows in rows_by_size.items()}}, indent=1) + "\n"


def main():
    arguments = parse_arguments()
    make_plan = plan.quick_plan if arguments.quick else plan.full_plan
    sizes = plan.QUICK_SIZES if arguments.quick else plan.SIZES
    if arguments.sizes:
        sizes = [plan.parse_size(text) for text in arguments.sizes.split(",")]
    machine = {"processor": processor(),
               "images": "given pair, resized" if arguments.pair else "generated room"}
    rows_by_size = {size: measure_size(size, make_plan(size), arguments.pair, machine)
                    for size in sizes}
    ceilings = measure_ceilings()
    lines = {size: roofline.lines(rows, size, ceilings, 2) for size, rows in rows_by_size.items()}
    checks = check_all(rows_by_size)
    print(tables.checks_table(checks))
    os.makedirs(arguments.out, exist_ok=True)
    save(arguments.out, "report.md", tables.page(
        machine, checks, rows_by_size, tables.roofline_section(ceilings, lines)))
    save(arguments.out, "results.json", as_json(machine, checks, rows_by_size, ceilings))


if __name__ == "__main__":
    try:
        main()
    except (BenchError, ValueError, subprocess.CalledProcessError) as error:
        sys.exit("bench: %s" % error)
