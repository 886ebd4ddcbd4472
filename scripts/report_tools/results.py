"""What `evaluate --report` measured, as plain values.

Errors and areas are percentages of the evaluated pixels; None stands for what is not known.
"""
import os
from typing import Dict, NamedTuple, Optional, Tuple

BASELINE = "sgm"
KINDS = ("raw", "dense", "published")  # of disparity maps

Numbers = Tuple[Optional[float], ...]


class Curve(NamedTuple):
    """Percent of bad pixels among the most certain ones."""
    completeness: Numbers  # shares of the pixels, 0 to 1
    error_u: Numbers  # the most certain ones by the paper's uncertainty U
    error_confidence: Numbers  # by the published confidence


class Score(NamedTuple):
    """One variant on one scene."""
    bad_raw: Numbers  # percent of wrong pixels at each threshold, unfiltered map
    bad_dense: Numbers  # the same of the filled map
    bad_published: Numbers  # of the filtered map: valid, but wrong
    invalid: Optional[float]  # percent of pixels that the published map leaves out
    average_error: Optional[float]  # pixels
    area_u: Optional[float]
    area_confidence: Optional[float]
    area_oracle: Optional[float]
    seconds: Optional[float]
    curve: Curve


class Scene(NamedTuple):
    """Size in pixels and number of disparities searched."""
    name: str
    width: int
    height: int
    disparities: int


class Results(NamedTuple):
    """All that was measured."""
    folder: str
    thresholds: Tuple[float, ...]
    report_threshold: float  # of the curves and gains; one of `thresholds`
    min_error_share: Optional[float]  # errors below this share of the true disparity are none
    options: dict
    threads: Optional[float]
    scenes: Tuple[Scene, ...]
    variants: Tuple[str, ...]
    scores: Dict[Tuple[str, str], Score]  # by scene and variant; some may be missing

    def value(self, scene, variant, read):
        """`read` of a score, and None where there is no score."""
        score = self.scores.get((scene, variant))
        return None if score is None else read(score)

    def values(self, variant, read):
        """Of all scenes, by their names, without those that are not known."""
        found = {scene.name: self.value(scene.name, variant, read) for scene in self.scenes}
        return {name: value for name, value in found.items() if value is not None}

    def known(self, read):
        """The variants that have `read` on any scene, and the scenes on which all of those do."""
        variants = [variant for variant in self.variants if self.values(variant, read)]
        scenes = [scene.name for scene in self.scenes
                  if all(self.value(scene.name, variant, read) is not None
                         for variant in variants)]
        return variants, scenes if variants else []

    def bad(self, kind, threshold):
        """What reads the errors above `threshold` out of a score; `kind` is one of KINDS."""
        index = self.thresholds.index(threshold)
        return lambda score: getattr(score, "bad_" + kind)[index]

    def map_path(self, name):
        """Relative path of a picture, or None where there is none."""
        path = os.path.join("maps", name + ".png")
        return path if os.path.isfile(os.path.join(self.folder, path)) else None
