"""Curves of error against completeness, in the manner of the paper's ROC plots."""
import math
from typing import NamedTuple

from report_tools.figures import Sheet
from report_tools.gains import mean
from report_tools.style import is_known, shorten, variant_styles

_COLUMNS = (4, 5, 3)  # of which the one that leaves the fewest places empty is taken
_PLOT_WIDTH = 2.5  # inches
_PLOT_HEIGHT = 2.1
_TITLE_LENGTH = 26
_HEADROOM = 1.5  # times the highest line of SGM and the priors; far worse methods leave the plot


class Order(NamedTuple):
    """What the pixels are sorted by."""
    name: str  # of the files
    field: str  # of Curve
    caption: str


BY_U = Order("curves_u", "error_u", "uncertainty U")
BY_CONFIDENCE = Order("curves_confidence", "error_confidence", "published confidence")


class Line(NamedTuple):
    """A curve in percent; NaN where the error is not known."""
    completeness: tuple
    error: tuple


def _line(score, order):
    errors = getattr(score.curve, order.field)
    known = [(100.0 * share, math.nan if error is None else error)
             for share, error in zip(score.curve.completeness, errors) if share is not None]
    if all(math.isnan(error) for _, error in known):
        return None
    return Line(*zip(*known))


def scene_lines(results, scene, order):
    """The lines of a scene by variant, of those that have one."""
    lines = {variant: results.value(scene, variant, lambda score: _line(score, order))
             for variant in results.variants}
    return {variant: line for variant, line in lines.items() if line is not None}


def mean_lines(results, order):
    """The mean over those scenes of which every drawn variant has a line, and their number.

    The lines have to be given at the same shares of the pixels; others have no mean.
    """
    variants, scenes = results.known(lambda score: _line(score, order))
    by_variant = {variant: [results.value(scene, variant, lambda score: _line(score, order))
                            for scene in scenes] for variant in variants}
    shares = {line.completeness for lines in by_variant.values() for line in lines}
    if len(shares) != 1:
        return {}, 0
    (completeness,) = shares
    return {variant: Line(completeness, tuple(map(mean, zip(*(line.error for line in lines)))))
            for variant, lines in by_variant.items()}, len(scenes)


def _panels(results, order):
    """Title and lines of each plot."""
    panels = [(shorten(scene.name, _TITLE_LENGTH), scene_lines(results, scene.name, order))
              for scene in results.scenes]
    panels = [panel for panel in panels if panel[1]]
    lines, count = mean_lines(results, order)
    if count > 1:
        panels.append(("mean of %d scenes" % count, lines))
    return panels


def _draw_panel(axes, title, lines, styles):
    for variant, line in lines.items():
        style = styles[variant]
        axes.plot(line.completeness, line.error, color=style.color, linestyle=style.line,
                  linewidth=1.4)
        # The error of the whole map.
        axes.plot(line.completeness[-1:], line.error[-1:], ".", color=style.color, markersize=5)
    axes.set_title(title)
    axes.set_xlim(0, 102)
    axes.set_xticks(range(0, 101, 25))
    axes.set_ylim(0, _top(lines))


def _top(lines):
    highest = {variant: max((e for e in line.error if not math.isnan(e)), default=0.0)
               for variant, line in lines.items()}
    own = max((top for variant, top in highest.items() if is_known(variant)), default=0.0)
    top = max(highest.values())
    return 1.05 * min(top, _HEADROOM * own or top) or 1.0


def _grid(count):
    """Rows and columns for `count` plots."""
    columns = min(_COLUMNS, key=lambda width: -count % width) if count > max(_COLUMNS) else count
    return -(-count // columns), columns


def draw_curves(results, order):
    """Writes the figure of all scenes and their mean; False where there is no curve."""
    panels = _panels(results, order)
    if not panels:
        return False
    styles = variant_styles(results.variants)
    drawn = [styles[variant] for variant in results.variants
             if any(variant in lines for _, lines in panels)]
    rows, columns = _grid(len(panels))
    # One plot alone is drawn larger.
    scale = 2 if len(panels) == 1 else 1
    sheet = Sheet(scale * columns * _PLOT_WIDTH, scale * rows * _PLOT_HEIGHT, drawn, rows, columns,
                  lines=True)
    for index, axes in enumerate(sheet.plots):
        if index >= len(panels):
            axes.set_axis_off()
            continue
        _draw_panel(axes, *panels[index], styles)
        if index + columns >= len(panels):
            axes.set_xlabel("completeness, %")
        if index % columns == 0:
            axes.set_ylabel("bad %g, %%" % results.report_threshold)
    if panels[-1][0].startswith("mean of"):
        _emphasise(sheet.plots[len(panels) - 1])
    sheet.save(results.folder, order.name)
    return True


def _emphasise(axes):
    axes.title.set_fontweight("bold")
    axes.set_facecolor("#f5f5f0")
