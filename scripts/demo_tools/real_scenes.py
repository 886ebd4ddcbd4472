#!/usr/bin/python3
"""Makes scenes in Middlebury's layout of the stereo pairs that Debian packages carry."""
import argparse
import io
import os
import sys

import numpy as np
from PIL import Image

from package_files import read_package_files
from pfm import write_pfm

_MOTORCYCLE = "/usr/lib/python3/dist-packages/skimage/data/motorcycle_"
_ALOE = "/usr/share/doc/opencv-doc/examples/data/aloe"

_SEEN, _OCCLUDED, _UNKNOWN = 255, 128, 0


def decode_picture(content):
    return Image.open(io.BytesIO(content))


def visibility(disparity):
    """Mask of the pixels that the right camera sees too.

    A pixel is occluded when another one with a larger disparity comes to lie on the same pixel
    of the right image, or when that lies outside.
    """
    height, width = disparity.shape
    known = np.isfinite(disparity)
    rows, columns = np.nonzero(known)
    values = disparity[known]
    targets = np.rint(columns - values).astype(int)
    inside = targets >= 0
    nearest = np.zeros((height, width), np.float32)
    np.maximum.at(nearest, (rows[inside], targets[inside]), values[inside])
    seen = inside.copy()
    seen[inside] = values[inside] > nearest[rows[inside], targets[inside]] - 1.5
    mask = np.full((height, width), _UNKNOWN, np.uint8)
    mask[known] = np.where(seen, _SEEN, _OCCLUDED)
    return mask


def write_scene(folder, left, right, disparity, camera):
    os.makedirs(folder, exist_ok=True)
    left.save(os.path.join(folder, "im0.png"))
    right.save(os.path.join(folder, "im1.png"))
    write_pfm(os.path.join(folder, "disp0GT.pfm"), disparity)
    Image.fromarray(visibility(disparity)).save(os.path.join(folder, "mask0nocc.png"))
    # Last: a folder with this file is complete.
    with open(os.path.join(folder, "calib.txt"), "w") as file:
        file.write("cam0=[{f} 0 {cx}; 0 {f} {cy}; 0 0 1]\n"
                   "cam1=[{f} 0 {cx1:.6f}; 0 {f} {cy}; 0 0 1]\n"
                   "doffs={doffs}\nbaseline={baseline}\n"
                   "width={width}\nheight={height}\nndisp={ndisp}\n".format(
                       cx1=camera["cx"] + camera["doffs"], width=left.width, height=left.height,
                       **camera))


def make_motorcycle(folder):
    """Motorcycle (Scharstein et al., GCPR 2014) as in scikit-image, with its documented camera."""
    left, right, ground_truth = read_package_files(
        "python3-skimage", [_MOTORCYCLE + name for name in ("left.png", "right.png", "disp.npz")])
    disparity = np.load(io.BytesIO(ground_truth))["arr_0"].astype(np.float32)
    disparity[~np.isfinite(disparity)] = np.inf
    camera = {"f": 994.978, "cx": 311.193, "cy": 254.877, "doffs": 31.086, "baseline": 193.001,
              "ndisp": 70}
    write_scene(folder, decode_picture(left), decode_picture(right), disparity, camera)


def make_aloe(folder):
    """Aloe (Scharstein and Pal, CVPR 2007) as in OpenCV's examples."""
    left, right, ground_truth = read_package_files(
        "opencv-doc", [_ALOE + name for name in ("L.jpg", "R.jpg", "GT.png")])
    levels = np.asarray(decode_picture(ground_truth).convert("L"))
    disparity = np.where(levels > 0, levels, np.inf).astype(np.float32)
    # Focal length and baseline of the 2006 data sets; the images are cropped by 270 pixels
    # against each other. The principal point is not published: the centre of the left image.
    camera = {"f": 3740.0, "cx": 640.5, "cy": 554.5, "doffs": 270.0, "baseline": 160.0,
              "ndisp": 224}
    write_scene(folder, decode_picture(left), decode_picture(right), disparity, camera)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", help="where motorcycle/ and aloe/ come to lie")
    folder = parser.parse_args().folder
    for name, make in (("motorcycle", make_motorcycle), ("aloe", make_aloe)):
        scene = os.path.join(folder, name)
        if not os.path.exists(os.path.join(scene, "calib.txt")):
            make(scene)


if __name__ == "__main__":
    sys.exit(main())
