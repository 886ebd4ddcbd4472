"""Binary PLY files of coloured points."""
import numpy as np

# What write_ply writes; read_ply accepts any vertex with x, y, z, red, green and blue.
POINT = np.dtype([("x", "<f4"), ("y", "<f4"), ("z", "<f4"),
                  ("red", "u1"), ("green", "u1"), ("blue", "u1"), ("confidence", "<f4")])
_FROM_PLY = {"float": "<f4", "float32": "<f4", "double": "<f8", "uchar": "u1", "uint8": "u1",
             "int": "<i4", "uint": "<u4"}
_TO_PLY = {"<f4": "float", "|u1": "uchar"}


def read_ply(path):
    """Returns the vertices as a structured array."""
    with open(path, "rb") as file:
        fields, count = _read_header(path, file)
        return np.frombuffer(file.read(count * np.dtype(fields).itemsize), fields)


def _read_header(path, file):
    fields, count, element = [], 0, ""
    for line in file:
        words = line.decode("ascii").split()
        if words[0] == "format" and words[1] != "binary_little_endian":
            raise ValueError("%s: expected binary_little_endian, not %s" % (path, words[1]))
        if words[0] == "element":
            element = words[1]
            if element == "vertex":
                count = int(words[2])
        if words[0] == "property" and element == "vertex":
            fields.append((words[2], _FROM_PLY[words[1]]))
        if words[0] == "end_header":
            return fields, count
    raise ValueError("%s: the PLY header has no end" % path)


def write_ply(path, points):
    with open(path, "wb") as file:
        file.write(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(points))
        for name in POINT.names:
            file.write(b"property %s %s\n" % (_TO_PLY[POINT[name].str].encode(), name.encode()))
        file.write(b"end_header\n")
        file.write(points.astype(POINT).tobytes())
