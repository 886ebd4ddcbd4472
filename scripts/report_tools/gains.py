"""How much better than plain SGM, and what it costs in time."""
import math
from typing import NamedTuple, Optional

from report_tools.results import BASELINE

WORSE = 0.5  # percent more errors than SGM that count as worse


class Gains(NamedTuple):
    """Of one variant over SGM; percent fewer errors, below 0 for more."""
    by_scene: dict  # on the scenes of which both errors are known and SGM makes any
    mean_of_gains: Optional[float]
    gain_of_means: Optional[float]
    worse: tuple  # names of the scenes with more than WORSE percent more errors


def mean(values):
    """None without values."""
    values = list(values)
    return math.fsum(values) / len(values) if values else None


def percent_less(value, base):
    """How many percent `value` lies below `base`; None where that cannot be said."""
    if value is None or not base:
        return None
    return 100.0 * (base - value) / base


def gains_over_baseline(results, variant, read):
    """`read` takes the error out of a score."""
    base = results.values(BASELINE, read)
    errors = results.values(variant, read)
    common = [name for name in errors if name in base]
    by_scene = {name: percent_less(errors[name], base[name]) for name in common if base[name]}
    return Gains(
        by_scene, mean(by_scene.values()),
        percent_less(mean(errors[name] for name in common), mean(base[name] for name in common)),
        tuple(name for name, gain in by_scene.items() if gain < -WORSE))


def rivals(results):
    """The variants that are compared with SGM."""
    return [variant for variant in results.variants if variant != BASELINE]


def sorting_variant(results, read):
    """The one by whose gains scenes are sorted: SGM-EPi as in the paper, or the next one."""
    for variant in ["epi", "epv"] + rivals(results):
        if variant in results.variants and gains_over_baseline(results, variant, read).by_scene:
            return variant
    return None


def scenes_by_gain(results, read):
    """Names of the scenes by rising gain of the sorting variant; those without one last."""
    variant = sorting_variant(results, read)
    by_scene = gains_over_baseline(results, variant, read).by_scene if variant else {}
    names = [scene.name for scene in results.scenes]
    return sorted(names, key=lambda name: by_scene.get(name, math.inf))


def means(results, read):
    """By variant, over the scenes that all variants with such a value have; their number."""
    variants, scenes = results.known(read)
    return {variant: mean(results.value(scene, variant, read) for scene in scenes)
            for variant in variants}, len(scenes)


def read_seconds(score):
    return score.seconds


def mean_seconds(results):
    """By variant; empty where there is no scene of which all variants with times have one."""
    times, count = means(results, read_seconds)
    return times if count else {}


def overhead_text(results, variant):
    """The mean of the overheads over SGM, like "+12 %"; "-" where it cannot be said."""
    less = gains_over_baseline(results, variant, read_seconds).mean_of_gains
    return "-" if less is None or variant == BASELINE else "%+.0f %%" % -less
