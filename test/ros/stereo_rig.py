"""A stereo camera made in code, and what tests need to talk to the nodelet."""
import os
import threading
import time
import xmlrpc.client

import numpy as np
import rosgraph
import roslib.packages
import rospy
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import CameraInfo, Image

WIDTH, HEIGHT = 320, 240
FOCAL_LENGTH, BASELINE = 300.0, 0.1
CX_LEFT, CX_RIGHT, CY = 160.0, 165.0, 120.0
FRAME_ID = "left_optical"

# Disparities x_left - x_right of the wall and of the board in front of it, and where the board is.
WALL, BOARD = 12, 28
BOARD_ROWS, BOARD_COLUMNS = slice(60, 180), slice(120, 220)

# Generous: the machine may be slow and busy.
TIMEOUT = 60.0


def program(package, name):
    """Its path. Unlike rosrun, this finds the programs of a build folder inside the package; of
    several such folders, in the one whose environment is set."""
    build = os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep)[0]
    return min(roslib.packages.find_node(package, name),
               key=lambda path: not path.startswith(build + os.sep))


def texture(height, width, seed):
    """Gray noise, smoothed a little, as bytes."""
    noise = np.random.RandomState(seed).uniform(0, 255, (height + 2, width + 2))
    smooth = sum(noise[dy:dy + height, dx:dx + width] for dy in range(3) for dx in range(3)) / 9
    return np.clip((smooth - 127.5) * 2.5 + 127.5, 0, 255).astype(np.uint8)


def make_pair():
    """Left and right gray image of the wall and the board."""
    wall = texture(HEIGHT, WIDTH + WALL, 1)
    left, right = wall[:, :WIDTH].copy(), wall[:, WALL:].copy()
    rows = BOARD_ROWS.stop - BOARD_ROWS.start
    columns = BOARD_COLUMNS.stop - BOARD_COLUMNS.start
    board = texture(rows, columns, 2)
    left[BOARD_ROWS, BOARD_COLUMNS] = board
    right[BOARD_ROWS, BOARD_COLUMNS.start - BOARD:BOARD_COLUMNS.stop - BOARD] = board
    return left, right


def true_disparity():
    """The published disparities: adjusted for the principal points."""
    disparity = np.full((HEIGHT, WIDTH), float(WALL))
    disparity[BOARD_ROWS, BOARD_COLUMNS] = BOARD
    return disparity - (CX_LEFT - CX_RIGHT)


def encode(gray, encoding):
    """The pixels of a gray picture in another encoding."""
    if encoding == "mono16":
        return gray.astype(np.uint16) * 257
    channels = {"mono8": 1, "bgr8": 3, "rgb8": 3, "bgra8": 4, "rgba8": 4}.get(encoding, 1)
    return gray if channels == 1 else np.repeat(gray[:, :, None], channels, axis=2)


def image_message(pixels, encoding, stamp, frame_id=FRAME_ID):
    message = Image(height=pixels.shape[0], width=pixels.shape[1], encoding=encoding)
    message.header.stamp = stamp
    message.header.frame_id = frame_id
    message.step = pixels[0].nbytes
    message.data = pixels.tobytes()
    return message


def info_message(cx, offset, stamp, frame_id=FRAME_ID):
    f = FOCAL_LENGTH
    message = CameraInfo(height=HEIGHT, width=WIDTH, distortion_model="plumb_bob", D=[0.0] * 5)
    message.header.stamp = stamp
    message.header.frame_id = frame_id
    message.K = [f, 0, cx, 0, f, CY, 0, 0, 1]
    message.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    message.P = [f, 0, cx, -f * offset, 0, f, CY, 0, 0, 0, 1, 0]
    return message


class Frame:
    """The four messages of a frame, to be spoilt before they are sent."""

    def __init__(self, stamp, encoding="mono8"):
        left, right = make_pair()
        self.left = image_message(encode(left, encoding), encoding, stamp)
        self.right = image_message(encode(right, encoding), encoding, stamp)
        self.left_info = info_message(CX_LEFT, 0.0, stamp)
        self.right_info = info_message(CX_RIGHT, BASELINE, stamp)

    def crop(self, width, height):
        """To the upper left corner, as cameras of a smaller size would see it."""
        left, right = (image[:height, :width] for image in make_pair())
        stamp = self.left.header.stamp
        self.left = image_message(left, "mono8", stamp)
        self.right = image_message(right, "mono8", stamp)
        for info in (self.left_info, self.right_info):
            info.width, info.height = width, height

    def messages(self):
        return {"left/image_rect": self.left, "left/camera_info": self.left_info,
                "right/image_rect": self.right, "right/camera_info": self.right_info}


class Camera:
    """Publishes frames in a namespace, with stamps that grow."""

    def __init__(self, namespace="/stereo", images=("left/image_rect", "right/image_rect")):
        names = {name: Image for name in images}
        names.update({"left/camera_info": CameraInfo, "right/camera_info": CameraInfo})
        self.publishers = {name: rospy.Publisher(namespace + "/" + name, kind, queue_size=50)
                           for name, kind in names.items()}
        self.stamp = rospy.Time(1000)

    def next_frame(self, encoding="mono8"):
        self.stamp += rospy.Duration.from_sec(0.1)
        return Frame(self.stamp, encoding)

    def wait_for_matcher(self, connected=True):
        """Until the nodelet listens to all topics, or to none."""
        def listens(publisher):
            return publisher.get_num_connections() > 0
        wait_until(lambda: all(listens(p) == connected for p in self.publishers.values()),
                   "the nodelet %s listen" % ("does not" if connected else "still does"))

    def send(self, frame, without=()):
        """Publishes the messages, but for topics that start with one of `without`."""
        for name, message in frame.messages().items():
            if not name.startswith(tuple(without)):
                self.publishers[name].publish(message)


class Listener:
    """Keeps the messages of an output by their stamps."""

    def __init__(self, topic, kind):
        self._topic = topic
        self._arrived = threading.Condition()
        self._messages = {}
        self._subscriber = rospy.Subscriber(topic, kind, self._add, queue_size=50)

    def _add(self, message):
        with self._arrived:
            # An array of markers has a header in each of them.
            header = message.header if hasattr(message, "header") else message.markers[0].header
            self._messages[header.stamp] = message
            self._arrived.notify_all()

    def wait_for(self, stamp):
        if not self.has(stamp, TIMEOUT):
            raise AssertionError("no message on %s for %s" % (self._topic, stamp))
        return self._messages[stamp]

    def has(self, stamp, within=0.0):
        with self._arrived:
            return self._arrived.wait_for(lambda: stamp in self._messages, within)

    def close(self):
        self._subscriber.unregister()


def match_first(camera, listeners, make_frame=None):
    """Sends frames until one comes through to all listeners, and returns what they have of the
    last. Connections are made in no certain order, and one that ended is noticed late: as with any
    camera, the first frames may be lost. From then on, none is."""
    sent = []

    def comes_through():
        frame = make_frame() if make_frame else camera.next_frame()
        sent.append(frame.left.header.stamp)
        camera.send(frame)
        for listener in listeners:
            listener.has(sent[-1], within=0.2)
        return any(all(listener.has(stamp) for listener in listeners) for stamp in sent)
    wait_until(comes_through, "no frame comes through")
    return [listener.wait_for(sent[-1]) for listener in listeners]


class LogListener:
    """What nodes say on /rosout."""

    def __init__(self):
        self._arrived = threading.Condition()
        self._texts = []
        self._subscriber = rospy.Subscriber("/rosout", Log, self._add, queue_size=200)
        wait_until(lambda: self._subscriber.get_num_connections() > 0, "nobody logs")

    def _add(self, message):
        with self._arrived:
            self._texts.append(message.msg)
            self._arrived.notify_all()

    def wait_for_node(self, node):
        """Until nothing is missed of what the node says."""
        wait_until(lambda: is_sent_to_us(node, "/rosout"), "%s does not log" % node)

    def count(self):
        with self._arrived:
            return len(self._texts)

    def since(self, count):
        """What was said after so many texts."""
        with self._arrived:
            return self._texts[count:]

    def has(self, part):
        with self._arrived:
            return any(part in text for text in self._texts)

    def wait_for(self, part):
        with self._arrived:
            if not self._arrived.wait_for(lambda: self.has(part), TIMEOUT):
                raise AssertionError("nobody said '%s' but %s" % (part, self._texts[-5:]))


def is_sent_to_us(node, topic):
    """Whether what the node publishes on the topic comes to this process."""
    try:
        address = rosgraph.Master(rospy.get_name()).lookupNode(node)
    except rosgraph.MasterError:
        return False
    links = xmlrpc.client.ServerProxy(address).getBusInfo(rospy.get_name())[2]
    return any(link[1:5] == [rospy.get_name(), "o", "TCPROS", topic] for link in links)


def node_like(beginning):
    """The node whose name begins so; of several, any."""
    names = {name for topics in rosgraph.Master(rospy.get_name()).getSystemState()
             for _, nodes in topics for name in nodes}
    return next(name for name in sorted(names) if name.startswith(beginning))


def process_of(node):
    """The process id of a node."""
    address = rosgraph.Master(rospy.get_name()).lookupNode(node)
    return xmlrpc.client.ServerProxy(address).getPid(rospy.get_name())[2]


def resident_bytes(pid):
    """Memory of a process that is in RAM."""
    with open("/proc/%d/statm" % pid) as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def processor_seconds(pid):
    """Time of all cores that a process has taken."""
    with open("/proc/%d/stat" % pid) as file:
        fields = file.read().rpartition(")")[2].split()
    user, system = fields[11:13]
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


def wait_until(condition, problem):
    """Polls in wall time, since simulated time may stand still."""
    end = time.monotonic() + TIMEOUT
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(problem)
        time.sleep(0.02)


def disparity_array(message):
    image = message.image
    return np.frombuffer(image.data, np.float32).reshape(image.height, image.width)


def check_disparity(test, message):
    """Asserts that a DisparityImage shows the wall and the board."""
    disparity = disparity_array(message)
    valid = disparity > message.min_disparity
    test.assertGreater(valid.mean(), 0.7)
    error = np.abs(disparity - true_disparity()[:disparity.shape[0], :disparity.shape[1]])
    test.assertLess((error > 1.0)[valid].mean(), 0.06)
    test.assertLess(np.median(error[valid]), 0.1)
