"""Portable float maps of one channel."""
import numpy as np


def read_pfm(path):
    """Returns a float32 array of which row 0 is the top of the picture."""
    with open(path, "rb") as file:
        if file.readline().strip() != b"Pf":
            raise ValueError("%s: expected a PFM file of one channel (Pf)" % path)
        width, height = map(int, file.readline().split())
        byte_order = "<" if float(file.readline()) < 0 else ">"
        values = np.frombuffer(file.read(4 * width * height), byte_order + "f4")
    return np.flipud(values.reshape(height, width)).astype(np.float32)


def write_pfm(path, image):
    height, width = image.shape
    with open(path, "wb") as file:
        file.write(b"Pf\n%d %d\n-1\n" % (width, height))
        file.write(np.flipud(image).astype("<f4").tobytes())
