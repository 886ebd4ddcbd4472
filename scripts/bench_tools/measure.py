"""Runs the benchmark programs and reads what they measured."""
import json
import os
import statistics
import subprocess
import tempfile
from typing import Dict, NamedTuple, Tuple


class BenchError(Exception):
    pass


class Measurement(NamedTuple):
    subject: str
    threads: int
    ms: Tuple[float, ...]             # of each run
    counters: Dict[str, float]        # medians

    @property
    def median_ms(self):
        return statistics.median(self.ms)


def run_benchmarks(program, arguments, names, repetitions):
    """The measurements of the benchmarks of these names, taking turns, and Google Benchmark's
    description of the machine."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "result.json")
        command = [program, *arguments, "--benchmark_filter=^(%s)/iterations" % "|".join(names),
                   "--benchmark_repetitions=%d" % repetitions,
                   "--benchmark_enable_random_interleaving=true",
                   "--benchmark_out=" + path, "--benchmark_out_format=json"]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, check=False)
        if done.returncode != 0:
            raise BenchError("%s failed with status %d:\n%s" %
                             (program, done.returncode, done.stdout[-2000:]))
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
    return measurements_of(document), document["context"]


# What Google Benchmark itself says of each run; the rest are counters.
_KNOWN = {"name", "family_index", "per_family_instance_index", "run_name", "run_type",
          "repetitions", "repetition_index", "threads", "iterations", "real_time", "cpu_time",
          "time_unit"}


def measurements_of(document):
    """By the name of the benchmark."""
    runs = {}
    for run in document["benchmarks"]:
        if run["run_type"] == "iteration":
            runs.setdefault(run["name"].split("/iterations")[0], []).append(run)
    measurements = {}
    for name, of_name in runs.items():
        subject, threads = name.rsplit("/", 1)
        keys = set().union(*of_name) - _KNOWN
        counters = {key: statistics.median(run[key] for run in of_name if key in run)
                    for key in sorted(keys)}
        measurements[name] = Measurement(subject, int(threads),
                                         tuple(run["real_time"] for run in of_name), counters)
    return measurements
