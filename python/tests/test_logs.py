"""Logs: arrays and frames hold what the messages hold, and broken files are one error."""

from __future__ import annotations

import itertools
import random
import struct
import warnings
import zlib
from pathlib import Path

import numpy as np
import pytest

import gt2003
from gt2003.representations import FrameInfo, Record


class Fails:
    """A locator that fails at once, so that the log has a warning."""

    def update(self, frame_info: FrameInfo) -> gt2003.representations.BallModel:
        raise ZeroDivisionError("told in the log")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("logs")
    match = gt2003.Match(seed=3, logs=str(folder), threads=2)
    match.run(1)
    match.robots["red2"].solve("BallLocator", Fails)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        match.run(5)
    match.close()
    return folder


@pytest.fixture(scope="module")
def log(folder: Path) -> gt2003.Log:
    return gt2003.Log(folder / "red2.mcap")


def compare(recorded: object, value: object, path: str) -> None:
    """Compare a value of an array with the attribute of an object."""
    if getattr(getattr(recorded, "dtype", None), "names", None) == ("values",):
        recorded = recorded["values"]  # type: ignore[index] # an array in an array, which ROS does not know
    if isinstance(value, Record):
        for field in value.fields:
            name = gt2003._core._input_name(field.name)
            compare(recorded[name], getattr(value, field.name), f"{path}.{name}")  # type: ignore[index]
    elif isinstance(value, list):
        assert len(recorded) == len(value), path  # type: ignore[arg-type]
        for i, element in enumerate(value):
            compare(recorded[i], element, f"{path}.{i}")  # type: ignore[index]
    elif isinstance(value, np.ndarray):
        plain = np.asarray(recorded)
        if plain.dtype.names:  # vectors and pixels are records in the log
            plain = np.stack([plain[name] for name in plain.dtype.names], -1)
        np.testing.assert_array_equal(plain, value, path)
    else:
        assert recorded == value, path


def test_arrays_hold_what_the_messages_hold(log: gt2003.Log) -> None:
    compared = 0
    for topic in log:
        if topic == "/camera":  # of a type that has no class
            continue
        array, messages = log[topic], log.messages(topic)
        assert len(array) == len(messages) > 0
        for row, (time, name, message) in zip(array, messages, strict=True):
            assert (row["log_time"], topic) == (time, name)
            compare(row, message, topic)
            compared += 1
    assert compared > 4000


def test_arrays_have_the_types_of_the_schema(log: gt2003.Log) -> None:
    pose = log["RobotPose"]
    assert pose["pose"]["translation"]["x"].dtype == np.float64
    assert pose["log_time"][0] >= 0 and np.all(np.diff(pose["log_time"]) > 0)
    assert log["/BallPercept"]["seen"].dtype == bool
    assert log["GameControlData"]["state"].dtype == np.uint8
    assert log.names("GameControlData")["state"][0] == "INITIAL"
    joints = log["input/SensorData"]["joints"]
    assert joints.shape[1] == len(log.names("input/SensorData")["joints"]) == 20
    assert isinstance(log["BehaviorTrace"]["text"][0], str)
    players = log["PlayersPercept"]["players"][0]
    assert log.metadata["gt2003"]["robot"] == "red2" and log.damage is None
    assert players is not None and "RobotPose" in log and "Nothing" not in log
    assert any(name.endswith("modules.cfg") for name in log.attachments)


def test_frames_have_a_column_for_each_number(log: gt2003.Log) -> None:
    frame = log.frame("RobotPose")
    assert frame.index.name == "log_time" and len(frame) == len(log["RobotPose"])
    assert list(frame.columns) == [
        *("pose.rotation", "pose.translation.x", "pose.translation.y", "validity"),
    ]
    np.testing.assert_array_equal(
        frame["pose.translation.x"], log["RobotPose"]["pose"]["translation"]["x"]
    )
    state = log.frame("GameControlData")["state"]
    assert state.dtype == "category" and state.iloc[0] == "INITIAL"
    sensors = log.frame("input/SensorData")
    np.testing.assert_array_equal(
        sensors["joints.head_pan"], log["input/SensorData"]["joints"][:, 1]
    )
    for topic in log:
        assert len(log.frame(topic)) == len(log[topic])


def test_images_are_arrays(log: gt2003.Log) -> None:
    images = log.images()
    assert len(images) == len(log["camera"]) > 2
    for time, image in images:
        assert image.shape == (144, 176, 3) and image.dtype == np.uint8 and time > 0
    assert images[-1][1].std() > 5
    with pytest.raises(gt2003.Error, match="/RobotPose: has no images"):
        log.images("RobotPose")


def test_a_log_plays_through_a_module(log: gt2003.Log) -> None:
    """Until the robot's own solution was replaced, the module does the same again."""
    locator = gt2003.modules.BallLocator("PIDSmoothed")
    percepts = {time: percept for time, _, percept in log.messages("BallPercept")}
    inputs: dict[str, object] = {}
    played = 0
    for time, topic, message in log.messages("OdometryData", "BallModel"):
        if topic == "/OdometryData":
            inputs["odometry_data"] = message
        elif time < 900:
            inputs["ball_percept"] = percepts[time]
            assert locator.update(**inputs, frame_info={"time": int(time)}) == message
            played += 1
    assert played > 15


def test_a_failed_solution_is_in_the_log(log: gt2003.Log) -> None:
    (warning,) = (row["text"] for row in log["Text"] if "failed" in row["text"])
    assert warning.startswith("BallLocator: Fails failed, now PIDSmoothed: Traceback")
    assert "ZeroDivisionError: told in the log" in warning


def test_broken_logs_are_one_error(folder: Path, tmp_path: Path) -> None:
    whole = (folder / "red1.mcap").read_bytes()
    file = tmp_path / "broken.mcap"
    chance = random.Random(1)
    for length in [0, 1, 8, 100, *(chance.randrange(len(whole) // 2) for _ in range(5))]:
        file.write_bytes(whole[:length])
        with pytest.raises(gt2003.Error) as caught:
            gt2003.Log(file)
        assert str(caught.value).startswith(str(file))
    cut = gt2003.Log(file, strict=False)
    assert cut.damage and "the log is cut off" in cut.damage
    read = cut.read()
    full = gt2003.Log(folder / "red1.mcap").read()
    for topic, array in read.items():
        assert len(array) <= len(full[topic])
        np.testing.assert_array_equal(array["log_time"], full[topic]["log_time"][: len(array)])
    for _ in range(40):
        broken = bytearray(whole)
        for _ in range(3):
            broken[chance.randrange(len(whole))] = chance.randrange(256)
        file.write_bytes(broken)
        for strict in (True, False):
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    broken_log = gt2003.Log(file, strict=strict)
                    assert broken_log.damage is None or str(file) in broken_log.damage
                    broken_log.read()
            except gt2003.Error as error:
                assert str(error).startswith(str(file))


def test_unknown_topics_and_files_are_told(log: gt2003.Log, tmp_path: Path) -> None:
    with pytest.raises(gt2003.Error, match="/Nothing: the log has no such topic"):
        log["Nothing"]
    with pytest.raises(gt2003.Error, match="no class CompressedImage"):
        log.messages("camera")
    for path, message in ((tmp_path, "is a folder"), (__file__, "is not an MCAP file")):
        with pytest.raises(gt2003.Error, match=message):
            gt2003.Log(path)


def cdr(number: int) -> bytes:
    return b"\0\1\0\0" + struct.pack("<i", number)


class ForeignLog:
    """Writes logs of one content in forms that the MCAP format allows."""

    features = ("chunks", "index", "statistics", "schemas", "channels", "outside", "pads")

    def __init__(self, features: frozenset[str]) -> None:
        self.on = features

    @staticmethod
    def text(text: str) -> bytes:
        return struct.pack("<I", len(text.encode())) + text.encode()

    def record(self, opcode: int, content: bytes) -> bytes:
        if "pads" in self.on and opcode not in (2, 5):
            content += b"pad"
        return struct.pack("<BQ", opcode, len(content)) + content

    def descriptions(self, schemas: bool, channels: bool) -> bytes:
        made = b""
        if schemas:
            made += self.record(
                3,
                struct.pack("<H", 3)
                + self.text("own/Number")
                + self.text("ros2msg")
                + self.text("int32 data\n"),
            )
        if channels:
            for id, schema, topic, encoding in ((0, 3, "/a", "cdr"), (5, 0, "/json", "json")):
                made += self.record(
                    4,
                    struct.pack("<HH", id, schema)
                    + self.text(topic)
                    + self.text(encoding)
                    + struct.pack("<I", 0),
                )
        return made

    def messages(self, i: int) -> bytes:
        time = 2**64 - 1 if i == 3 else 1_000_000_000 * (i + 1)
        return self.record(5, struct.pack("<HIQQ", 0, i, time, 1) + cdr(i)) + self.record(
            5, struct.pack("<HIQQ", 5, i, time, 1) + b"{}"
        )

    def write(self) -> bytes:
        magic = b"\x89MCAP0\r\n"
        out = magic + self.record(1, self.text("profile") + self.text("library"))
        descriptions = self.descriptions(True, True)
        if "chunks" not in self.on:
            out += descriptions
        entries = self.text("k") + self.text("v")
        out += self.record(12, self.text("about") + struct.pack("<I", len(entries)) + entries)
        chunks = b""
        count = 0
        for i in range(4):
            if "chunks" not in self.on or ("outside" in self.on and i == 1):
                out += self.messages(i)
                continue
            records = (descriptions if i == 0 else b"") + self.messages(i)
            time = 2**64 - 1 if i == 3 else 1_000_000_000 * (i + 1)
            head = struct.pack("<QQQII", time, time, len(records), zlib.crc32(records), 0)
            chunk = self.record(6, head + struct.pack("<Q", len(records)) + records)
            chunks += self.record(
                8,
                struct.pack("<QQQQ", time, time, len(out), len(chunk))
                + struct.pack("<IQIQQ", 0, 0, 0, len(records), len(records)),
            )
            count += 1
            out += chunk
        attachment = struct.pack("<QQ", 1, 2) + self.text("note") + self.text("text")
        attachment += struct.pack("<Q", 2) + b"hi"
        out += self.record(9, attachment + struct.pack("<I", zlib.crc32(attachment)))
        out += self.record(15, struct.pack("<I", 0))
        index = self.descriptions("schemas" in self.on, "channels" in self.on)
        if "statistics" in self.on:
            counts = struct.pack("<QHIIIIQQ", 8, 1, 2, 1, 1, count, 1_000_000_000, 2**64 - 1)
            index += self.record(11, counts + struct.pack("<IHQHQ", 20, 0, 4, 5, 4))
        if "index" in self.on:
            index += chunks
        footer = struct.pack("<BQQQI", 2, 20, len(out) if index else 0, 0, 0)
        return out + index + footer + magic


def test_logs_in_all_forms_hold_the_same(tmp_path: Path) -> None:
    file = tmp_path / "foreign.mcap"
    names = ForeignLog.features
    for count in range(len(names) + 1):
        for features in itertools.combinations(names, count):
            file.write_bytes(ForeignLog(frozenset(features)).write())
            for strict in (True, False):
                log = gt2003.Log(file, strict=strict)
                assert log.damage is None, features
                assert list(log.unreadable) == ["/json"]
                with pytest.warns(UserWarning, match="/json: is left out: the encoding is json"):
                    read = log.read()
                assert list(read) == ["/a"], features
                np.testing.assert_array_equal(read["/a"]["data"], [0, 1, 2, 3])
                assert read["/a"]["log_time"].tolist() == [1000, 2000, 3000, (2**64 - 1) / 1e6]
                assert log.metadata == {"about": {"k": "v"}} and log.attachments == {"note": b"hi"}
                with pytest.raises(gt2003.Error, match="/json: the encoding is json"):
                    log["/json"]


def test_records_of_one_name_are_all_there(tmp_path: Path) -> None:
    whole = ForeignLog(frozenset({"index"})).write()
    writer = ForeignLog(frozenset())
    entries = writer.text("k") + writer.text("second")
    twice = writer.record(12, writer.text("about") + struct.pack("<I", len(entries)) + entries)
    attachment = struct.pack("<QQ", 1, 2) + writer.text("note") + writer.text("text")
    attachment += struct.pack("<Q", 3) + b"you"
    twice += writer.record(9, attachment + struct.pack("<I", zlib.crc32(attachment)))
    at = whole.index(writer.record(15, struct.pack("<I", 0)))
    file = tmp_path / "twice.mcap"
    file.write_bytes(whole[:at] + twice + whole[at:])
    log = gt2003.Log(file)
    assert list(log.metadata) == ["about"] and log.metadata["about"] == {"k": "v"}
    assert log.metadata.all() == [("about", {"k": "v"}), ("about", {"k": "second"})]
    assert log.metadata.all("about") == log.metadata.all() and log.metadata.all("other") == []
    assert list(log.attachments) == ["note"] and log.attachments["note"] == b"hi"
    assert log.attachments.all("note") == [("note", b"hi"), ("note", b"you")]
    with pytest.raises(KeyError):
        log.metadata["other"]


def test_damage_loses_itself_only(tmp_path: Path) -> None:
    """It is told with the lost time, before and after reading."""
    features = frozenset({"chunks", "index", "statistics", "schemas", "channels"})
    whole = ForeignLog(features).write()
    file = tmp_path / "bad.mcap"
    file.write_bytes(whole.replace(cdr(1), cdr(7)))
    told = f"{file}: 2.000 s: the chunk's checksum is wrong; its messages are lost"
    log = gt2003.Log(file, strict=False)
    assert log.damage == told
    np.testing.assert_array_equal(log["a"]["data"], [0, 2, 3])
    assert log.damage == told
    with pytest.raises(gt2003.Error, match="the chunk's checksum is wrong"):
        gt2003.Log(file)["a"]
    plain = ForeignLog(frozenset()).write()
    file.write_bytes(plain.replace(cdr(2), b"\0\0\0\0\2\0\0\0"))
    log = gt2003.Log(file, strict=False)
    np.testing.assert_array_equal(log["a"]["data"], [0, 1, 3])
    assert log.damage and "/a: 1 message at 3.000 s cannot be read" in log.damage
    with pytest.raises(gt2003.Error, match="expected little endian CDR"):
        gt2003.Log(file)["a"]


def test_topics_are_read_by_either_name(log: gt2003.Log) -> None:
    read = log.read("BallModel")
    assert list(read) == ["/BallModel"]
    assert read["BallModel"] is read["/BallModel"]
    assert "BallModel" in read and "/BallPercept" not in read
    with pytest.raises(KeyError):
        read["BallPercept"]
    with pytest.raises(gt2003.Error, match="the log has no such topic; did you mean '/BallModel'"):
        log["BalModel"]
