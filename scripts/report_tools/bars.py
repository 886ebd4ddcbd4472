"""Bars: the gains over SGM per scene, and the run times."""
from report_tools.figures import Sheet
from report_tools.gains import (
    gains_over_baseline, mean_seconds, overhead_text, rivals, scenes_by_gain)
from report_tools.results import BASELINE
from report_tools.style import is_known, shorten, variant_styles

_WIDTH = 10.0  # inches, at most
_BAR_WIDTH = 0.3  # at most
_ROW_HEIGHT = 2.4  # with the names, by so much more for each letter:
_LETTER_HEIGHT = 0.05
_NAME_LENGTH = 20
_BARS_PER_ROW = 96
_GAP = 1.0  # between the groups, in bars
_LOWEST = -50.0  # percent, where bars are cut at the latest


def _rows(names, per_group):
    """The groups in rows of about the same length."""
    longest = max(2, int(_BARS_PER_ROW / (per_group + _GAP)))
    count = -(-len(names) // longest)
    length = -(-len(names) // count)
    return [names[start:start + length] for start in range(0, len(names), length)]


def _gains_of(variants, gains):
    return [gain for variant in variants for gain in gains[variant].by_scene.values()]


def _lowest_bar(gains):
    """Where bars are cut: beside those of far worse methods, small gains would not be seen."""
    own = _gains_of(filter(is_known, gains), gains)
    if not own:
        return _LOWEST
    return max(_LOWEST, min(own + [-0.5 * max(own), -5.0]))


def _draw_group(axes, position, gains, styles, lowest):
    """The bars of one scene, from `position` on; those cut at `lowest` say their value."""
    for offset, (variant, gain) in enumerate(gains.items()):
        if gain is None:
            continue
        axes.bar(position + offset, max(gain, lowest), width=1.0, align="edge",
                 color=styles[variant].color, edgecolor="white", linewidth=0.4)
        if gain < lowest:
            axes.annotate("%.0f" % gain, (position + offset + 0.5, lowest), (0, -2),
                          textcoords="offset points", rotation=90, ha="center", va="top",
                          fontsize=7)


def _draw_row(axes, names, gains, styles, length, lowest):
    """One row of groups; `gains` by variant, `length` the groups of the longest row."""
    step = len(gains) + _GAP
    for index, name in enumerate(names):
        of_scene = {variant: of_variant.by_scene.get(name) for variant, of_variant in gains.items()}
        _draw_group(axes, index * step, of_scene, styles, lowest)
    for variant, of_variant in gains.items():
        if of_variant.mean_of_gains >= lowest:
            axes.axhline(of_variant.mean_of_gains, color=styles[variant].color, linestyle="--",
                         linewidth=0.9, zorder=0.8)
    axes.axhline(0, color="black", linewidth=0.8)
    axes.set_xticks([index * step + len(gains) / 2 for index in range(len(names))])
    axes.set_xticklabels([shorten(name, _NAME_LENGTH) for name in names], rotation=30, ha="right",
                         rotation_mode="anchor")
    axes.tick_params(axis="x", length=0)
    axes.grid(axis="x", visible=False)
    axes.set_xlim(-_GAP, length * step)
    axes.set_ylabel("fewer errors than SGM, %")


def _limits(gains, lowest):
    values = _gains_of(gains, gains)
    bottom, top = min(values + [0.0]), max(values + [0.0])
    below = 0.05 if bottom < 0 else 0.0
    if bottom < lowest:
        bottom, below = lowest, 0.2  # room for the values
    extent = max(top - bottom, 1.0)
    return bottom - below * extent, top + 0.05 * extent


def draw_gains(results, read, name):
    """Writes the figure of the gains by what `read` takes from a score; False without gains."""
    gains = {variant: gains_over_baseline(results, variant, read) for variant in rivals(results)}
    gains = {variant: of_variant for variant, of_variant in gains.items() if of_variant.by_scene}
    if not gains:
        return False
    styles = variant_styles(results.variants)
    scenes = [scene for scene in scenes_by_gain(results, read)
              if any(scene in of_variant.by_scene for of_variant in gains.values())]
    rows = _rows(scenes, len(gains))
    longest_name = max(len(shorten(scene, _NAME_LENGTH)) for scene in scenes)
    bars = (len(gains) + _GAP) * len(rows[0])
    sheet = Sheet(min(_WIDTH, 3.0 + _BAR_WIDTH * bars),
                  (_ROW_HEIGHT + _LETTER_HEIGHT * longest_name) * len(rows),
                  [styles[variant] for variant in gains], len(rows))
    lowest = _lowest_bar(gains)
    for axes, row in zip(sheet.plots, rows):
        _draw_row(axes, row, gains, styles, len(rows[0]), lowest)
        axes.set_ylim(_limits(gains, lowest))
    sheet.save(results.folder, name)
    return True


def draw_seconds(results, name):
    """Writes the figure of the mean run times; False without times."""
    times = mean_seconds(results)
    if not times:
        return False
    styles = variant_styles(results.variants)
    sheet = Sheet(7.0, 0.7 + 0.28 * len(times), [])
    (axes,) = sheet.plots
    for position, (variant, seconds) in enumerate(times.items()):
        axes.barh(position, seconds, color=styles[variant].color, height=0.75)
        text = "%.2f s" % seconds
        if variant != BASELINE and BASELINE in times:
            text += "  " + overhead_text(results, variant)
        axes.annotate(text, (seconds, position), (4, 0), textcoords="offset points", va="center")
    axes.set_yticks(range(len(times)))
    axes.set_yticklabels([shorten(styles[variant].label) for variant in times])
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    # Room for the text behind the longest bar.
    axes.set_xlim(0, 1.4 * max(times.values()) or 1.0)
    axes.set_xlabel("seconds per frame, mean")
    sheet.save(results.folder, name)
    return True
