"""The tables of the report, as rows of text."""
from typing import NamedTuple, Tuple

from report_tools.gains import (
    WORSE, gains_over_baseline, means, overhead_text, read_seconds, rivals, scenes_by_gain)
from report_tools.results import BASELINE, KINDS
from report_tools.style import variant_styles


class Table(NamedTuple):
    """The first column holds names, the others numbers."""
    head: Tuple[str, ...]
    rows: Tuple[Tuple[str, ...], ...]
    foot: Tuple[Tuple[str, ...], ...] = ()  # rows that sum up


def number(value, digits=2, sign=False):
    """ "-" for what is not known."""
    if value is None:
        return "-"
    return ("%+.*f" if sign else "%.*f") % (digits, value)


def _labels(variants):
    styles = variant_styles(variants)
    return [styles[variant].label for variant in variants]


def _mean_caption(count):
    return "mean of %d scene%s" % (count, "" if count == 1 else "s")


def per_scene(results, read):
    """A row per scene, a column per variant, and the mean of the scenes that all have."""
    rows = tuple((scene.name, *(number(results.value(scene.name, variant, read))
                                for variant in results.variants)) for scene in results.scenes)
    of_variants, count = means(results, read)
    foot = (_mean_caption(count), *(number(of_variants.get(variant))
                                    for variant in results.variants))
    return Table(("scene", *_labels(results.variants)), rows, (foot,))


def _measures(results):
    """Caption, and what reads it out of a score."""
    measures = [("%s bad %g" % (kind, threshold), results.bad(kind, threshold))
                for kind in KINDS for threshold in results.thresholds]
    return measures + [("invalid, %", lambda score: score.invalid),
                       ("average error, px", lambda score: score.average_error),
                       ("area by U", lambda score: score.area_u),
                       ("area by confidence", lambda score: score.area_confidence),
                       ("area of the best order", lambda score: score.area_oracle)]


def summary(results):
    """The means: a row per variant, a column per measure, and the number of scenes of each."""
    measures = _measures(results)
    columns = [means(results, read) for _, read in measures]
    rows = tuple((label, *(number(of_variants.get(variant)) for of_variants, _ in columns))
                 for variant, label in zip(results.variants, _labels(results.variants)))
    foot = ("scenes in the mean", *(str(count) for _, count in columns))
    return Table(("variant", *(caption for caption, _ in measures)), rows, (foot,))


def gains(results, read):
    """The error of SGM and the gains of the others, percent, scenes by rising gain."""
    variants = rivals(results)
    by_variant = [gains_over_baseline(results, variant, read) for variant in variants]
    rows = tuple((name, number(results.value(name, BASELINE, read)),
                  *(number(of.by_scene.get(name), 1, sign=True) for of in by_variant))
                 for name in scenes_by_gain(results, read))
    foot = (("mean of gains", "", *(number(of.mean_of_gains, 1, sign=True) for of in by_variant)),
            ("gain of means", "", *(number(of.gain_of_means, 1, sign=True) for of in by_variant)),
            ("scenes worse by more than %g %%" % WORSE, "",
             *("%d of %d" % (len(of.worse), len(of.by_scene)) if of.by_scene else "-"
               for of in by_variant)))
    return Table(("scene", "errors of SGM, %", *_labels(variants)), rows, foot)


def gain_summary(results):
    """Mean of gains / gain of means / scenes that get worse, of each map and threshold."""
    head = ["variant"]
    columns = []
    for kind in ("raw", "dense"):
        for threshold in results.thresholds:
            head.append("%s bad %g" % (kind, threshold))
            read = results.bad(kind, threshold)
            columns.append({variant: gains_over_baseline(results, variant, read)
                            for variant in rivals(results)})
    rows = tuple((label, *(_gain_cell(column[variant]) for column in columns))
                 for variant, label in zip(rivals(results), _labels(rivals(results))))
    return Table(tuple(head), rows)


def _gain_cell(of_variant):
    if not of_variant.by_scene:
        return "-"
    return "%s / %s / %d" % (number(of_variant.mean_of_gains, 1, sign=True),
                             number(of_variant.gain_of_means, 1, sign=True),
                             len(of_variant.worse))


def seconds(results):
    """Run times per scene; below, their mean and that of the time over SGM's."""
    table = per_scene(results, read_seconds)
    overhead = ("mean overhead over SGM", *(overhead_text(results, variant)
                                            for variant in results.variants))
    names = tuple("%s (%d x %d, %d)" % (scene.name, scene.width, scene.height, scene.disparities)
                  for scene in results.scenes)
    rows = tuple((name, *row[1:]) for name, row in zip(names, table.rows))
    return Table(("scene (size, disparities)", *table.head[1:]), rows, table.foot + (overhead,))


def _flat(options, prefix=""):
    for name, value in options.items():
        if isinstance(value, dict):
            yield from _flat(value, prefix + name + "/")
        else:
            yield prefix + name, value


def options_table(results):
    """The options of the run by their path names."""
    return Table(("option", "value"), tuple(
        (name, _option_text(value)) for name, value in _flat(results.options)))


def _option_text(value):
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        return ", ".join(map(_option_text, value))
    return "%g" % value if isinstance(value, float) else str(value)
