"""The bounds that the measurements are checked against."""
from typing import NamedTuple, Optional

from bench_tools.plan import FULL, HALF, HD, VGA


class Bar(NamedTuple):
    case: str
    size: object
    ours: str       # benchmark names
    reference: str
    bound: float
    at_least: bool = False


class Check(NamedTuple):
    bar: Bar
    ours_ms: Optional[float] = None
    reference_ms: Optional[float] = None
    ratio: Optional[float] = None

    @property
    def verdict(self):
        if self.ratio is None:
            return "not measured"
        met = (self.ratio >= self.bar.bound if self.bar.at_least else
               self.ratio <= self.bar.bound)
        return "met" if met else "MISSED"


_WAY3 = "opencv/sgbm_3way/2"
# The first frame of a subject stands beside its warm ones.
FIRST = "first/frame/default/2"

BARS = (
    *(Bar("default / StereoSGBM 3WAY", size, "frame/default/2", _WAY3, 1.0)
      for size in (VGA, HD, HALF, FULL)),
    Bar("default / StereoSGBM HH", HALF, "frame/default/2", "opencv/hh/2", 0.09),
    *(Bar("quality / StereoSGBM 3WAY", size, "frame/quality/2", _WAY3, 3.0)
      for size in (VGA, HD, HALF)),
    Bar("census without prior / StereoSGBM 3WAY", HALF, "frame/census_sgm/2", _WAY3, 0.65),
    *(Bar("paper / StereoSGBM 3WAY", size, "frame/paper/2", _WAY3, 2.0)
      for size in (VGA, HD, HALF)),
    Bar("default with AVX2 only / StereoSGBM 3WAY", HALF, "frame/default_avx2/2", _WAY3, 1.4),
    Bar("aggregation with offset image / without prior", HALF, "stage/aggregation_offset_image/2",
        "stage/aggregation_none/2", 1.08),
    Bar("aggregation with 3D prior / without prior", HALF, "stage/aggregation_3d_prior/2",
        "stage/aggregation_none/2", 1.35),
    Bar("default with EPi / without prior", HALF, "frame/default_epi/2", "frame/default_sgm/2",
        1.12),
    Bar("default with 1 thread / with 2", HALF, "frame/default/1", "frame/default/2", 1.75, True),
    Bar("default within 1000 MB / without limit", FULL, "frame/default_lean/2", "frame/default/2",
        1.35),
    Bar("first frame of default / warm frame", FULL, FIRST, "frame/default/2", 2.0),
)


def _ms(rows, name):
    if name == FIRST:
        row = rows.get(name[len("first/"):])
        return row.first_ms if row else None
    return rows[name].ms if name in rows else None


def check(bar, rows_by_size):
    rows = rows_by_size.get(bar.size, {})
    ours, reference = _ms(rows, bar.ours), _ms(rows, bar.reference)
    if ours is None or reference is None:
        return Check(bar, ours, reference)
    # Against 3WAY, of the runs that took turns.
    ratio = rows[bar.ours].of_reference if bar.reference == _WAY3 else ours / reference
    return Check(bar, ours, reference, ratio)


def check_all(rows_by_size):
    return tuple(check(bar, rows_by_size) for bar in BARS if bar.size in rows_by_size)
