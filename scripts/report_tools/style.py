"""Names, colours and settings that all figures share."""
from typing import NamedTuple

SETTINGS = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "savefig.dpi": 150,
    "savefig.bbox": "tight",
    "svg.fonttype": "none",  # text stays text: searchable, and editable in a drawing program
    "svg.hashsalt": "stereo_sgmp",  # the same file for the same numbers
}


class VariantStyle(NamedTuple):
    """How a variant looks in every figure."""
    label: str
    color: str
    line: str


# The colours of Okabe and Ito, which the colour-blind tell apart, with a darker yellow that is
# dash-dotted besides; 3D priors are dashed.
_KNOWN = {
    "sgm": VariantStyle("SGM", "#000000", "-"),
    "epi": VariantStyle("SGM-EPi", "#0072b2", "-"),
    "epv": VariantStyle("SGM-EPv", "#56b4e9", "--"),
    "gs": VariantStyle("SGM-GS", "#009e73", "-"),
    "gp": VariantStyle("SGM-GP", "#e69f00", "-"),
    "gni": VariantStyle("SGM-GNi", "#c9b800", "-."),
    "gnv": VariantStyle("SGM-GNv", "#d55e00", "--"),
    "mw": VariantStyle("SGM-MW", "#cc79a7", "--"),
}

# OpenCV's StereoSGBM is gray; other methods are brown and blue-gray in the order in which they
# come. All of them are dotted.
_OPENCV = {
    "sgbm": VariantStyle("OpenCV SGBM", "#777777", ":"),
    "sgbm_3way": VariantStyle("OpenCV 3WAY", "#b5b5b5", ":"),
    "hh": VariantStyle("OpenCV HH", "#444444", ":"),
}
_OTHERS = ("#7f5539", "#b08968", "#4b5d67", "#8fa3b3")

_LONGEST = 26


def shorten(text, longest=_LONGEST):
    """With the middle left out where `text` is too long: names often differ at their ends."""
    if len(text) <= longest:
        return text
    head = (longest - 1) // 2
    return text[:head] + "…" + text[len(text) - (longest - 1 - head):]


def is_known(variant):
    """Whether it is SGM or one of the paper's priors, not another method."""
    return variant in _KNOWN


def variant_styles(variants):
    """Of each variant by its name."""
    named = {**_KNOWN, **_OPENCV}
    styles = {variant: named[variant] for variant in variants if variant in named}
    others = [variant for variant in variants if variant not in named]
    for index, variant in enumerate(others):
        styles[variant] = VariantStyle(variant, _OTHERS[index % len(_OTHERS)], ":")
    return styles
