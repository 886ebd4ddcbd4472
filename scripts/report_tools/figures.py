"""What all figures have in common: the sheet, its legend, and the files."""
import os

import matplotlib.style
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from report_tools.style import SETTINGS, shorten

FOLDER = "figures"  # in the folder of the report
_LEGEND_COLUMN = 1.3  # inches
_LONG_LABEL = 12  # characters that fit into it; longer ones take two columns
_LEGEND_ROW = 0.2


def drawing():
    """Context in which figures are drawn and saved: the same on every machine."""
    return matplotlib.style.context(["default", SETTINGS])


class Sheet:
    """A figure of a grid of plots with one legend above them."""

    def __init__(self, width, plots_height, styles, rows=1, columns=1, lines=False):
        """Sizes in inches; `styles` are those of the legend, as lines or as areas."""
        labels = [shorten(style.label) for style in styles]
        long = any(len(label) > _LONG_LABEL for label in labels)
        per_row = max(1, int(width / (_LEGEND_COLUMN * (2 if long else 1))))
        legend_rows = -(-len(styles) // per_row)
        self._legend_height = _LEGEND_ROW * (legend_rows + 0.6) if styles else 0.0
        self._height = plots_height + self._legend_height
        self.figure = Figure(figsize=(width, self._height))
        FigureCanvasAgg(self.figure)
        self.plots = self.figure.subplots(rows, columns, squeeze=False).ravel()
        if styles:
            handles = [Line2D([], [], color=style.color, linestyle=style.line, linewidth=1.6)
                       if lines else Patch(color=style.color) for style in styles]
            self.figure.legend(handles, labels, loc="upper center",
                               ncol=min(per_row, len(styles)))

    def save(self, folder, name):
        """Writes FOLDER/name.png and .svg below `folder`."""
        self.figure.tight_layout(rect=(0, 0, 1, 1 - self._legend_height / self._height))
        base = os.path.join(folder, FOLDER, name)
        os.makedirs(os.path.dirname(base), exist_ok=True)
        self.figure.savefig(base + ".png", metadata={"Software": None})
        self.figure.savefig(base + ".svg", metadata={"Date": None})
