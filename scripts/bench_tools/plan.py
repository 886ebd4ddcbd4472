"""What is measured: sizes, and groups of subjects that take turns in one process."""
from typing import NamedTuple, Tuple


class Size(NamedTuple):
    width: int
    height: int
    disparities: int

    def __str__(self):
        return "%dx%dx%d" % self


def parse_size(text):
    parts = text.split("x")
    if len(parts) != 3 or not all(part.isdigit() for part in parts):
        raise ValueError("'%s' is no size; expected WIDTHxHEIGHTxDISPARITIES, as 640x480x128" %
                         text)
    return Size(*map(int, parts))


VGA_64 = Size(640, 480, 64)
VGA = Size(640, 480, 128)
HD = Size(1280, 720, 128)
HALF = Size(1440, 994, 256)
FULL = Size(2880, 1980, 290)
SIZES = (VGA_64, VGA, HD, HALF, FULL)
QUICK_SIZES = (VGA, HALF)

THREADS = (1, 2)
REFERENCE = "opencv/sgbm_3way"
FRAMES = ("frame/default", "frame/default_avx2", "frame/default_sgm", "frame/default_epi",
          "frame/census_sgm", "frame/quality", "frame/paper")
LEAN = "frame/default_lean"  # within 1000 MB, which matters for large images alone
OPENCV = ("opencv/sgbm", "opencv/hh4", "opencv/hh")
STAGES = ("stage/images", "stage/alignment_fit", "stage/alignment_warp", "stage/coarse_pass",
          "stage/prior_epi", "stage/prior_epv", "stage/cost", "stage/aggregation_none",
          "stage/aggregation_offset_image", "stage/aggregation_3d_prior", "stage/refinement")
FIRST = ("frame/default", "frame/quality", "frame/paper", REFERENCE) + OPENCV

# Above this, subjects are measured a few at a time: all of them at once would not fit in memory.
_LARGE = 5e8  # pixels x disparities


class Group(NamedTuple):
    """Subjects that take turns; each with its numbers of threads."""
    subjects: Tuple[Tuple[str, int], ...]
    repetitions: int


class Plan(NamedTuple):
    groups: Tuple[Group, ...]
    first: Tuple[Tuple[str, int], ...]  # measured from cold memory, each in a process of its own


def _with(threads, *subjects):
    return tuple((subject, count) for count in threads for subject in subjects)


def repetitions(size):
    """More of those that are short."""
    volume = size.width * size.height * size.disparities
    return 21 if volume < 5e7 else 11 if volume < 2e8 else 7 if volume < _LARGE else 5


def full_plan(size):
    count = repetitions(size)
    if size.width * size.height * size.disparities < _LARGE:
        groups = (Group(_with(THREADS, REFERENCE, *FRAMES, *OPENCV, *STAGES), count),)
    else:
        groups = tuple(Group(_with(THREADS, REFERENCE, subject), count) for subject in FRAMES)
        groups += (Group(_with((2,), "frame/default", LEAN), count),
                   Group(_with((2,), REFERENCE, *STAGES), count))
        groups += tuple(Group(_with((2,), REFERENCE, subject), 2) for subject in OPENCV)
    large = (LEAN,) if size.width * size.height * size.disparities >= _LARGE else ()
    return Plan(groups, _with((2,), *FIRST, *large))


def quick_plan(size):
    if size == VGA:
        return Plan((Group(_with((2,), REFERENCE, *FRAMES), 7),), ())
    aggregation = (stage for stage in STAGES if "aggregation" in stage)
    subjects = _with((2,), REFERENCE, "opencv/hh", *FRAMES, *aggregation)
    return Plan((Group(subjects + _with((1,), "frame/default"), 3),), ())
