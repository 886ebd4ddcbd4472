"""The measurements of all sizes, and the ratios between them."""
import statistics
from typing import Dict, NamedTuple

from bench_tools.plan import REFERENCE


class Row(NamedTuple):
    """One subject at one size."""
    subject: str
    threads: int
    ms: float               # median
    fastest_ms: float
    slowest_ms: float
    of_reference: float     # ratio to StereoSGBM with 3 paths, measured in turns; None without
    mde_per_second: float   # million disparity evaluations, W x H x D, per second
    first_ms: float         # the first run, in cold memory; None where it was not measured
    peak_bytes: float       # that the subject adds to the process; None likewise
    stages: Dict[str, float]  # medians, ms


def row_of(measurement, reference, first, size):
    evaluations = size.width * size.height * size.disparities
    stages = {name[len("ms "):]: value for name, value in measurement.counters.items()
              if name.startswith("ms ")}
    return Row(measurement.subject, measurement.threads, measurement.median_ms,
               min(measurement.ms), max(measurement.ms),
               measurement.median_ms / reference.median_ms if reference else None,
               evaluations / measurement.median_ms * 1e-3,
               first.median_ms if first else None,
               first.counters["peak_bytes"] if first else None, stages)


def rows_of_group(measurements, first, size):
    """The rows of subjects that took turns. Each is compared with the reference of its own
    number of threads; `first` holds what was measured from cold memory."""
    return {name: row_of(measurement, measurements.get("%s/%d" % (REFERENCE, measurement.threads)),
                         first.get("first/" + name), size)
            for name, measurement in measurements.items()}


def merged(groups):
    """The rows of all groups of a size. What several groups have (the reference) is the median
    of them."""
    by_name = {}
    for group in groups:
        for name, row in group.items():
            by_name.setdefault(name, []).append(row)
    return {name: rows[0]._replace(ms=statistics.median(row.ms for row in rows),
                                   mde_per_second=statistics.median(row.mde_per_second
                                                                    for row in rows),
                                   fastest_ms=min(row.fastest_ms for row in rows),
                                   slowest_ms=max(row.slowest_ms for row in rows))
            for name, rows in by_name.items()}
