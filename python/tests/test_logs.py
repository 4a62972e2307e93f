"""Logs: arrays and frames hold what the messages hold, and broken files are one error."""

from __future__ import annotations

import random
import warnings
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
    inputs: dict[str, object] = {}
    played = 0
    topics = ("BallPercept", "OdometryData", "RobotPose", "CameraMatrix", "BallModel")
    for time, topic, message in log.messages(*topics):
        if topic == "/BallModel" and time < 900:
            assert locator.update(**inputs, frame_info={"time": int(time)}) == message
            played += 1
        elif topic in ("/BallPercept", "/OdometryData"):
            inputs[gt2003._core._input_name(topic[1:])] = message
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
    assert cut.damage and "the log ends within a record" in cut.damage
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
                gt2003.Log(file, strict=strict).read()
            except gt2003.Error as error:
                assert str(error).startswith(str(file))


def test_unknown_topics_and_files_are_told(log: gt2003.Log, tmp_path: Path) -> None:
    with pytest.raises(gt2003.Error, match="/Nothing: the log has no such topic"):
        log["Nothing"]
    with pytest.raises(gt2003.Error, match="no class CompressedImage"):
        log.messages("camera")
    for path, message in ((tmp_path, "there is no such file"), (__file__, "is not an MCAP file")):
        with pytest.raises(gt2003.Error, match=message):
            gt2003.Log(path)
