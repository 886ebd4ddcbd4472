"""What the stages have to compute and to move at least, against what the machine can do."""
import math
from typing import NamedTuple, Optional

# Operations on single bytes for each pixel and disparity; one on two bytes counts twice.
# Mixed cost: 5 census bytes (xor, bits, sum), absolute difference (2 saturating, or, limit),
# gradient (2 differences of 3, sum, limit), the terms into one byte (11).
_COST = 14 + 4 + 8 + 11
# A path: predecessor's neighbours (minimum, sum with P1), itself, P2 (2 minima), less the
# smallest, plus the cost, running minimum, its share of the sum. Eight of them; then both halves of
# the sum (two minima, two differences, the sum), the winner (minimum, comparison), the right image's
# (mean with the base, minimum, comparison, choice of the index), the second best (choice, minimum).
_AGGREGATION = 8 * 8 + 13
_SWEEPS = 2  # each asks for the costs
# The sum of the first four paths, written and read.
_AGGREGATION_BYTES = 2


class Work(NamedTuple):
    """Of one stage, for the whole image."""
    operations: float
    bytes: float


class Line(NamedTuple):
    stage: str
    work: Work
    per: float                      # pixels x disparities
    ms: float
    operations_ms: float            # at the machine's ceiling
    memory_ms: float

    @property
    def share(self):
        return max(self.operations_ms, self.memory_ms) / self.ms


def coarse_factor(size):
    """Of the coarse pass, as PriorOptions::coarse_factor = 0 chooses it."""
    return min(4, max(2, math.ceil(math.sqrt(size.width * size.height / 0.12e6))))


def work_of(stage, size) -> Optional[Work]:
    """None where neither operations nor bytes are what binds the stage."""
    pixels = size.width * size.height
    volume = pixels * size.disparities
    aggregation = Work(volume * (_AGGREGATION + _SWEEPS * _COST), volume * _AGGREGATION_BYTES)
    coarse = coarse_factor(size) ** -3
    return {
        "stage/images": Work(0.0, pixels * 8),  # two colour images in, two gray ones out
        "stage/alignment_warp": Work(0.0, pixels * 2),
        "stage/coarse_pass": Work(aggregation.operations * coarse,
                                  aggregation.bytes * coarse + pixels * 5),
        "stage/cost": Work(volume * _COST, 0.0),
        "stage/aggregation_none": aggregation,
        "stage/aggregation_offset_image": aggregation,
        "stage/aggregation_3d_prior": aggregation,
        # The winners, 7 values of 16 bits, in; four maps of floats and the reasons out.
        "stage/refinement": Work(0.0, pixels * (14 + 17)),
    }.get(stage)


def lines(rows, size, ceilings, threads):
    """`ceilings`: 10^9 per second, by the name of the benchmark."""
    volume = size.width * size.height * size.disparities
    per_ms = {what: ceilings["ceiling/%s/%d" % (what, threads)] * 1e6
              for what in ("byte_operations", "memory_read", "memory_stream")}
    memory = (per_ms["memory_read"] + per_ms["memory_stream"]) / 2
    result = []
    for row in rows.values():
        work = work_of(row.subject, size)
        if row.threads != threads or work is None:
            continue
        result.append(Line(row.subject, work, volume, row.ms,
                           work.operations / per_ms["byte_operations"], work.bytes / memory))
    return result
