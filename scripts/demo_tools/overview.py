"""One picture of all results of a scene."""
import os

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from cloud_view import render
from pfm import read_pfm
from ply import read_ply

_TILE_WIDTH = 400
_CAPTION_HEIGHT = 24
_SEEN = 255  # in the mask: by both cameras
_FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def error_picture(left, estimate, ground_truth, seen, threshold):
    """The left image in dim gray; over it in red the pixels wrong by more than `threshold`.

    Pixels that are not evaluated (not `seen` by both cameras or not known) are darker.
    """
    gray = np.asarray(left.convert("L")).astype(np.float32)
    picture = np.repeat((gray * 0.55)[:, :, np.newaxis], 3, axis=2)
    evaluated = np.isfinite(ground_truth) & seen
    picture[~evaluated] *= 0.4
    picture[evaluated & ~(np.abs(estimate - ground_truth) <= threshold)] = (235, 60, 40)
    return Image.fromarray(picture.astype(np.uint8))


class Overview:
    """Tiles with captions, in rows."""

    def __init__(self, columns, tile_height):
        self._columns = columns
        self._tile_height = tile_height
        self._tiles = []
        self._font = ImageFont.truetype(_FONT, 14)

    def add(self, caption, picture):
        self._tiles.append((caption, picture.convert("RGB")))

    def save(self, path):
        cell_height = self._tile_height + _CAPTION_HEIGHT
        rows = -(-len(self._tiles) // self._columns)
        canvas = Image.new("RGB", (self._columns * _TILE_WIDTH, rows * cell_height), "white")
        draw = ImageDraw.Draw(canvas)
        for index, (caption, picture) in enumerate(self._tiles):
            x = index % self._columns * _TILE_WIDTH
            y = index // self._columns * cell_height
            tile = picture.resize((_TILE_WIDTH - 4, self._tile_height), Image.LANCZOS)
            canvas.paste(tile, (x + 2, y + _CAPTION_HEIGHT))
            draw.text((x + 4, y + 4), caption, "black", self._font)
        canvas.save(path, quality=75)


def write_overview(folder, view, threshold=2.0):
    """From the files of `folder`, into its overview.jpg; `view` is (yaw, pitch) in degrees."""

    def path(name):
        return os.path.join(folder, name)

    left = Image.open(path("left.png"))
    ground_truth = read_pfm(path("ground_truth.pfm"))
    seen = np.asarray(Image.open(path("mask.png"))) == _SEEN
    sgmp_cloud = read_ply(path("cloud.ply"))
    tile_height = round(_TILE_WIDTH * left.height / left.width)
    overview = Overview(3, tile_height)
    overview.add("left image", left)
    overview.add("disparity, SGM", Image.open(path("disparity_sgm.png")))
    overview.add("disparity, SGM-P", Image.open(path("disparity.png")))
    overview.add("plane priors", Image.open(path("priors.png")))
    for name, caption in (("dense_sgm.pfm", "SGM"), ("dense.pfm", "SGM-P")):
        picture = error_picture(left, read_pfm(path(name)), ground_truth, seen,
                                threshold)
        overview.add("errors > %g px, %s, holes filled" % (threshold, caption), picture)
    overview.add("confidence", Image.open(path("confidence.png")))
    # Twice the size of a tile, so that single points blend into surfaces.
    size = (2 * _TILE_WIDTH, 2 * tile_height)
    for name, caption in (("cloud_sgm.ply", "SGM"), ("cloud.ply", "SGM-P")):
        cloud = read_ply(path(name))
        overview.add("point cloud, %s" % caption, render(cloud, sgmp_cloud, size, *view))
    overview.save(path("overview.jpg"))
