#!/usr/bin/python3
"""Makes the seeds of the fuzz targets: make_corpus.py FOLDER."""
import os
import struct
import sys
import zlib

CALIB = """cam0=[300 0 2; 0 300 1.5; 0 0 1]
cam1=[300 0 3; 0 300 1.5; 0 0 1]
doffs=1
baseline=100
width=4
height=3
ndisp=8
"""

OPTIONS = {
    "flat": "num_disparities: 48\nmin_disparity: -3\n",
    "parts": "preset: paper\nprior: {variant: sgm}\nfilter:\n  speckle_size: 20\n",
    "numbers": "aggregation: {p1: 55}\nfilter: {lr_tolerance: 1.5e0, min_confidence: .2}\n",
    "choices": "alignment:\n  mode: off\nrefinement: {subpixel: none}\ncost: {kind: census}\n",
    "anchor": "prior: &p {variant: epi}\n",
    "itself": "prior: &p {variant: *p}\n",
    "text": "num_disparities: many\n",
}


def pfm(kind, values, scale=-1.0, width=4, height=3):
    order = "<" if scale < 0 else ">"
    header = "%s\n%d %d\n%g\n" % (kind, width, height, scale)
    return header.encode() + struct.pack("%s%df" % (order, len(values)), *values)


def png(bits, color, rows):
    """A PNG file; `color` 0 is gray, 2 RGB; `rows` are bytes."""
    def chunk(name, data):
        body = name + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    samples = {0: 1, 2: 3}[color]
    width = len(rows[0]) * 8 // (bits * samples)
    header = struct.pack(">IIBBBBB", width, len(rows), bits, color, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) +
            chunk(b"IEND", b""))


def gray(bits):
    return png(bits, 0, [bytes(range(y, y + 4 * bits // 8)) for y in range(3)])


def pnm(magic, samples):
    return b"%s\n4 3\n255\n" % magic + bytes(range(12 * samples))


DISPARITIES = [1.0, 2.5, float("inf"), float("nan")] * 3
NORMALS = [0.0, 0.0, -1.0, 0.6, 0.0, -0.8, 0.0, 0.0, 0.0] * 4
RGB = png(8, 2, [bytes(range(y, y + 12)) for y in range(3)])


def volume(form, text, values):
    return bytes([form]) + text + b"\n" + struct.pack("<%df" % len(values), *values)


def scene(layout, *files):
    """As FuzzedDataProvider takes it apart: numbers from the end, bytes from the front."""
    numbers = bytes([layout]) + b"".join(struct.pack("<H", len(data))[::-1] for data in files)
    return b"".join(files) + numbers[::-1]


def seeds():
    """Bytes by target and name."""
    truth = pfm("Pf", DISPARITIES)
    return {
        "calib": {"all": CALIB.encode(), "least": "\n".join(
            line for line in CALIB.split("\n") if line[:3] in ("cam", "bas")).encode()},
        "options": {name: text.encode() for name, text in OPTIONS.items()},
        "pfm": {"little": truth, "big": pfm("Pf", DISPARITIES, 1.0), "color": pfm("PF", NORMALS)},
        "normals": {"unit": pfm("PF", NORMALS), "long": pfm("PF", [2.0] * 36)},
        "disparity": {"pfm": b"\0" + truth, "png8": b"\1" + gray(8), "png16": b"\1" + gray(16),
                      "depth_pfm": b"\2" + truth, "depth_png16": b"\3" + gray(16),
                      "scaled": b"\5" + gray(8), "rgb": b"\1" + RGB},
        "cost_volume": {"dim": volume(0, b"1 2 3 4", [0.5, float("nan")] * 12),
                        "cosine": volume(1, b"4 3 2 -1", [-0.5, float("nan")] * 12),
                        "acrt": volume(2, b"4 3 2 0", [1.0, 0.0] * 12)},
        "dataset": {"v3": scene(0, RGB, RGB, truth, gray(8), pfm("PF", NORMALS), CALIB.encode()),
                    "2003": scene(1, pnm(b"P6", 3), pnm(b"P6", 3), pnm(b"P5", 1), pnm(b"P5", 1)),
                    "2006": scene(2, RGB, RGB, gray(8), gray(8)),
                    "kitti": scene(3, RGB, RGB, gray(16))},
        # Numbers whose meaning the targets make up as they read: a start, not a form.
        "images": {"ramp": bytes(range(64)), "zeros": bytes(48)},
        "camera_info": {"ramp": bytes(range(250)), "zeros": bytes(128)},
        "synchronizer": {"ramp": bytes(range(128)), "zeros": bytes(64), "fours": b"\4\1" * 32},
    }


def main():
    for target, files in seeds().items():
        folder = os.path.join(sys.argv[1], target)
        os.makedirs(folder, exist_ok=True)
        for name, data in files.items():
            with open(os.path.join(folder, name), "wb") as file:
                file.write(data)


if __name__ == "__main__":
    main()
