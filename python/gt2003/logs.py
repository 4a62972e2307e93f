"""Logs (MCAP) as NumPy arrays, pandas frames, and objects."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
import numpy.typing as npt

from . import _core
from ._error import Error

if TYPE_CHECKING:
    import pandas

__all__ = ["Log", "Records", "Topics"]

T = TypeVar("T")

_SPAN = np.dtype(("i8", 2))
_MOST_COLUMNS = 64  # of an array in a frame


class Records(Mapping[str, T]):
    """Records of a log by name. Of several with one name this mapping has the first; `all` returns each of them."""

    def __init__(self, pairs: Iterable[tuple[str, T]]) -> None:
        self._pairs = list(pairs)
        self._first = dict(reversed(self._pairs))

    def all(self, name: str | None = None) -> list[tuple[str, T]]:
        """Return all records, or those of a name, in the log's order: pairs of name and content."""
        return [pair for pair in self._pairs if name in (None, pair[0])]

    def __getitem__(self, name: str) -> T:
        return self._first[name]

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys(name for name, _ in self._pairs))

    def __len__(self) -> int:
        return len(self._first)

    def __repr__(self) -> str:
        return f"Records({self._pairs})"


class Topics(dict[str, np.ndarray]):
    """Arrays by their topics; `BallModel` stands for `/BallModel`, as wherever a topic is named."""

    def __missing__(self, name: str) -> np.ndarray:
        if name.startswith("/"):
            raise KeyError(name)
        return self[_topic(name)]

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and super().__contains__(_topic(name))


class Log:
    """A log: any MCAP file of messages in CDR with schemas of ROS 2, as robots write it.

    `log["RobotPose"]` has all messages of the topic /RobotPose as a structured array, with a field
    for each of the schema's (their names are those of ROS: `last_seen`), before which `log_time`
    stands (float64: ms since the robot's start). Records in a message are records in the array;
    lists, whose lengths vary, are arrays as objects, texts `str` as objects, enumerations uint8.

    A log that is damaged or cut off raises an `Error`. With `strict=False` what is whole is read,
    and `damage` tells what is wrong. Topics of other encodings are in `unreadable`; `read()` leaves
    them out with a warning.
    """

    def __init__(self, path: str | os.PathLike[str], *, strict: bool = True) -> None:
        self.path = os.fspath(path)
        self._file = _core.LogFile(self.path, strict)
        self._arrays: dict[str, np.ndarray] = {}
        self._rows: dict[str, dict[str, Any]] = {}
        self._warned: set[str] = set()

    @property
    def damage(self) -> str | None:
        """What is wrong with the file, if anything is: a line for each damage, with its time.

        To find that all of the file is read once.
        """
        return self._file.damage

    @property
    def topics(self) -> dict[str, str]:
        """The topics, and the names of their schemas; of a topic with several, all of them: `"A, B"`."""
        schemas: dict[str, dict[str, None]] = {}
        for topic, schema, _ in self._file.channels():
            schemas.setdefault(topic, {})[schema] = None
        return {topic: ", ".join(schemas[topic]) for topic in sorted(schemas)}

    @property
    def unreadable(self) -> dict[str, str]:
        """The topics of which a channel cannot be read, and why."""
        return {topic: why for topic, _, why in self._file.channels() if why}

    @property
    def metadata(self) -> Records[dict[str, str]]:
        """The metadata by name: of a match's log, under "gt2003", scene, seed and robot."""
        return Records(self._file.metadata())

    @property
    def attachments(self) -> Records[bytes]:
        """The files in the log by name: of a match's log, the robot's configuration."""
        return Records(self._file.attachments())

    def read(self, *topics: str) -> Topics:
        """Return the arrays of some topics (or of all) by name, read together."""
        readable = {topic for topic, _, why in self._file.channels() if not why}
        wanted = [_topic(topic) for topic in topics] or sorted(readable)
        for topic, why in self.unreadable.items():
            if (topic in wanted or not topics) and topic not in self._warned:
                self._warned.add(topic)
                warnings.warn(f"{self.path}: {topic}: is left out: {why}", stacklevel=2)
        unread = [topic for topic in dict.fromkeys(wanted) if topic not in self._arrays]
        for topic, (row, rows, pools, times) in self._file.read(unread).items():
            self._rows[topic] = row
            self._arrays[topic] = _table(row, rows, pools, times)
        return Topics({topic: self._arrays[topic] for topic in wanted})

    def __getitem__(self, topic: str) -> np.ndarray:
        return self.read(topic)[_topic(topic)]

    def __contains__(self, topic: str) -> bool:
        return _topic(topic) in self.topics

    def __iter__(self) -> Iterator[str]:
        return iter(self.topics)

    def names(self, topic: str) -> dict[str, tuple[str, ...]]:
        """Return the names that a topic's schema has, by the path of the field.

        Those of an enumeration's values, and those of the elements of an array (of joints).
        """
        self.read(topic)
        return dict(_names(self._rows[_topic(topic)], ""))

    def frame(self, topic: str) -> pandas.DataFrame:
        """Return a topic as a frame of pandas, whose index is the time of the log in ms.

        Columns are named by paths (`pose.translation.x`). Enumerations are categories. An array of
        up to 64 elements has a column for each, named by its number or name.
        """
        pandas = _pandas()
        array = self[topic]
        row = self._rows[_topic(topic)]
        index = pandas.Index(array["log_time"], name="log_time")
        columns: dict[str, Any] = {}
        for field in row["fields"]:
            _add_columns(field, field["name"], array[field["name"]], columns, pandas)
        return pandas.DataFrame(columns, index=index)

    def images(self, topic: str = "camera") -> list[tuple[float, npt.NDArray[np.uint8]]]:
        """Return a topic's images, with their times (ms): (height, width, 3), uint8, YCbCr.

        Of JPEG images (/camera), or of whole ones (/input/Image, of logs with inputs).
        """
        array = self[topic]
        names = array.dtype.names or ()
        if "pixels" in names:
            sizes = array["info"][["width", "height"]]
            made = [
                _whole(self, topic, pixels, int(width), int(height))
                for pixels, (width, height) in zip(array["pixels"], sizes, strict=True)
            ]
        elif "data" in names:
            made = [self._unpacked(topic, data) for data in array["data"]]
        else:
            raise Error("has no images", self.path, field=_topic(topic))
        return list(zip(array["log_time"].tolist(), made, strict=True))

    def _unpacked(self, topic: str, data: np.ndarray) -> npt.NDArray[np.uint8]:
        try:
            return _core._decode_jpeg(np.ascontiguousarray(data))
        except Error as error:
            raise Error(error.what, self.path, field=_topic(topic)) from None

    def messages(self, *topics: str) -> list[tuple[float, str, Any]]:
        """Return messages in the log's order: time (ms), topic, and an object of its class.

        The classes are those of `gt2003.representations`; a message that was recorded with another
        version of its type is read field by field. So a log can be played through a module.
        """
        read = self._file.messages([_topic(topic) for topic in topics])
        return [(time / 1e6, topic, value) for time, topic, value in read]


def _topic(name: str) -> str:
    return name if name.startswith("/") else "/" + name


def _pandas() -> ModuleType:
    try:
        import pandas
    except ImportError:
        raise Error("frames need pandas: pip install gt2003[logs]") from None
    return pandas


def _raw(element: dict[str, Any]) -> np.dtype:
    """The type of an element as it lies in a row."""
    if element["fields"] is None:
        return _SPAN if element["letters"] is not None else np.dtype(element["dtype"])
    return np.dtype([(field["name"], _raw_field(field)) for field in element["fields"]])


def _raw_field(field: dict[str, Any]) -> np.dtype:
    if field["list"] is not None:
        return _SPAN
    raw = _raw(field)
    return raw if field["count"] is None else np.dtype((raw, (field["count"],)))


def _final(element: dict[str, Any]) -> np.dtype:
    """The type of an element as users get it."""
    if element["fields"] is None:
        return np.dtype(object if element["letters"] is not None else element["dtype"])
    return np.dtype([(field["name"], _final_field(field)) for field in element["fields"]])


def _final_field(field: dict[str, Any]) -> np.dtype:
    if field["list"] is not None:
        return np.dtype(object)
    final = _final(field)
    return final if field["count"] is None else np.dtype((final, (field["count"],)))


def _elements(element: dict[str, Any], raw: np.ndarray, pools: list[np.ndarray]) -> np.ndarray:
    """Make of elements as they lie in rows what users get."""
    if element["letters"] is not None:
        letters = pools[element["letters"]].tobytes()
        texts = [letters[a:b].decode(errors="replace") for a, b in raw.reshape(-1, 2).tolist()]
        return _objects(texts, raw.shape[:-1])
    final = _final(element)
    if not final.hasobject:
        return raw
    made = np.empty(raw.shape, final)
    _fill(made, element, raw, pools)
    return made


def _fill(
    made: np.ndarray, record: dict[str, Any], raw: np.ndarray, pools: list[np.ndarray]
) -> None:
    for field in record["fields"]:
        part = raw[field["name"]]
        if field["list"] is None:
            made[field["name"]] = _elements(field, part, pools)
            continue
        content = _elements(field, _pooled(field, pools[field["list"]]), pools)
        slices = [content[a:b] for a, b in part.reshape(-1, 2).tolist()]
        made[field["name"]] = _objects(slices, part.shape[:-1])


def _pooled(element: dict[str, Any], pool: np.ndarray) -> np.ndarray:
    """The elements of a list that lie in a pool."""
    if element["letters"] is not None:
        return pool.view("i8").reshape(-1, 2)
    raw = _raw(element)
    return pool.view(raw) if raw.itemsize > 0 else np.zeros(len(pool), raw)


def _objects(values: list[Any], shape: tuple[int, ...]) -> np.ndarray:
    array = np.empty(len(values), object)
    for i, value in enumerate(values):
        array[i] = value
    return array.reshape(shape)


def _table(
    row: dict[str, Any], rows: np.ndarray, pools: list[np.ndarray], times: np.ndarray
) -> np.ndarray:
    fields = row["fields"]
    final = np.dtype([("log_time", "f8")] + [(f["name"], _final_field(f)) for f in fields])
    made = np.empty(len(times), final)
    made["log_time"] = times / 1e6
    if fields:
        _fill(made, row, rows.view(_raw(row)), pools)
    return made


def _names(record: dict[str, Any], path: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    for field in record["fields"]:
        name = path + field["name"]
        if found := field["names"] or field["index_names"]:
            yield name, tuple(found)
        if field["fields"] is not None:
            yield from _names(field, name + ".")


def _add_columns(
    field: dict[str, Any], path: str, values: np.ndarray, columns: dict[str, Any], pandas: ModuleType
) -> None:
    if field["list"] is not None:
        columns[path] = values
    elif field["count"] is not None:
        if field["count"] > _MOST_COLUMNS:
            columns[path] = _objects(list(values), (len(values),))
            return
        element = {**field, "count": None}
        names = field["index_names"] or range(field["count"])
        for i, name in zip(range(field["count"]), names, strict=False):
            _add_columns(element, f"{path}.{name}", values[:, i], columns, pandas)
    elif field["fields"] is not None:
        for part in field["fields"]:
            _add_columns(part, f"{path}.{part['name']}", values[part["name"]], columns, pandas)
    elif field["names"]:
        codes = np.where(values < len(field["names"]), values.astype(np.int16), -1)
        columns[path] = pandas.Categorical.from_codes(codes, field["names"])
    else:
        columns[path] = values


def _whole(log: Log, topic: str, pixels: np.ndarray, width: int, height: int) -> np.ndarray:
    if len(pixels) != width * height:
        raise Error("an image has not as many pixels as its size says", log.path, field=_topic(topic))
    channels = pixels.view(np.uint8).reshape(height, width, -1)
    return channels[:, :, :3]
