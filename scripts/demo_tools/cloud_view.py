"""A picture of a point cloud, from a viewpoint aside of the camera's."""
import numpy as np
from PIL import Image

_BACKGROUND = 24


def _rotation(yaw, pitch):
    """Degrees: yaw > 0 looks from the right, pitch > 0 from above; y points down."""
    yaw, pitch = np.radians([-yaw, -pitch])
    about_y = np.array([[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]])
    about_x = np.array([[1, 0, 0], [0, np.cos(pitch), -np.sin(pitch)],
                        [0, np.sin(pitch), np.cos(pitch)]])
    return about_x @ about_y


class View:
    """A perspective that turns about `center` and shows the box of `points` in full."""

    def __init__(self, points, size, yaw, pitch):
        self.size = size
        self._low, self._high = np.percentile(points, [2, 98], axis=0)
        self._center = (self._low + self._high) / 2
        self._turn = _rotation(yaw, pitch)
        turned = self._turned(np.clip(points, self._low, self._high))
        self._distance = 1.5 * np.linalg.norm(self._high - self._low)
        x, y = self._directions(turned)
        self._middle = (x.min() + x.max()) / 2, (y.min() + y.max()) / 2
        self._scale = 0.94 * min(size[0] / np.ptp(x), size[1] / np.ptp(y))

    def _turned(self, points):
        return (points - self._center) @ self._turn.T

    def _directions(self, turned):
        depth = turned[:, 2] + self._distance
        return turned[:, 0] / depth, turned[:, 1] / depth

    def project(self, points):
        """Columns, rows (not rounded) and depths of points."""
        turned = self._turned(points)
        x, y = self._directions(turned)
        width, height = self.size
        return ((x - self._middle[0]) * self._scale + width / 2,
                (y - self._middle[1]) * self._scale + height / 2, turned[:, 2])


def _coordinates(cloud):
    return np.stack([cloud["x"], cloud["y"], cloud["z"]], axis=1).astype(np.float64)


def render(cloud, reference, size, yaw, pitch):
    """Draws the structured array `cloud`; the viewpoint is chosen for the cloud `reference`."""
    view = View(_coordinates(reference), size, yaw, pitch)
    columns, rows, depths = view.project(_coordinates(cloud))
    colors = np.stack([cloud["red"], cloud["green"], cloud["blue"]], axis=1)
    picture = np.full((size[1], size[0], 3), _BACKGROUND, np.uint8)
    # From back to front: what is written last stays.
    order = np.argsort(-depths)
    columns, rows = columns[order].astype(int), rows[order].astype(int)
    colors = colors[order]
    inside = (columns >= 0) & (columns < size[0]) & (rows >= 0) & (rows < size[1])
    picture[rows[inside], columns[inside]] = colors[inside]
    return Image.fromarray(picture)
