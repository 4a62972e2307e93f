"""Values by path: every one there and back, and what is refused."""

from __future__ import annotations

import copy
import enum
import math
import pickle
from typing import Any

import numpy as np
import pytest

import gt2003
from gt2003 import representations
from gt2003.representations import BallPercept, GameState, Pose2D, Record, RobotPose


@pytest.fixture(scope="module")
def match() -> gt2003.Match:
    match = gt2003.Match(seed=4)
    match.run(12)
    return match


@pytest.fixture
def robot(match: gt2003.Match) -> gt2003.Robot:
    return match.robots["blue3"]


def test_every_class_has_defaults_and_equals_its_copy() -> None:
    for name in representations.__all__:
        made = getattr(representations, name)
        if issubclass(made, enum.IntEnum):
            assert [value.value for value in made] == list(range(len(made))), name
            continue
        value = made()
        assert value == made() and value == copy.deepcopy(value), name
        assert pickle.loads(pickle.dumps(value)) == value, name
        assert made.__doc__ and all(field.name in made.__doc__ for field in made.fields), name


def test_every_representation_is_its_class_and_all_its_paths_lead_to_its_parts(
    robot: gt2003.Robot,
) -> None:
    def compare(path: str, value: Any) -> None:
        assert not isinstance(value, Record) or value == robot.get(path), path
        if isinstance(value, Record):
            for field in value.fields:
                compare(f"{path}.{field.name}", getattr(value, field.name))
        elif isinstance(value, list):
            for i, element in enumerate(value[:3]):
                compare(f"{path}.{i}", element)
        elif isinstance(value, np.ndarray):
            np.testing.assert_array_equal(value, robot.get(path), path)
        else:
            assert value == robot.get(path) or value != value, path

    assert len(robot.representations) > 30
    for name in robot.representations:
        value = robot.get(name)
        assert type(value).__name__ == name
        compare(name, value)


def test_types_are_those_of_the_fields(robot: gt2003.Robot) -> None:
    pose = robot.get("RobotPose")
    assert isinstance(pose, RobotPose) and isinstance(pose.pose, Pose2D)
    assert isinstance(pose.validity, float)
    assert pose.pose.translation.dtype == np.float64 and pose.pose.translation.shape == (2,)
    joints = robot.get("JointData.angles")
    assert joints.ndim == 1 and joints.dtype == np.float64
    assert robot.get("JointData.angles.headPan") in joints
    assert isinstance(robot.get("GameControlData.state"), GameState)
    assert robot.get("FrameInfo.time") > 11_000
    (validity,) = (field for field in RobotPose.fields if field.name == "validity")
    assert validity.annotation == "float"
    (pixels,) = (f for f in representations.Image.fields if f.name == "pixels")
    assert pixels.annotation == "numpy.typing.NDArray[numpy.uint8]"
    assert robot.get("Image.pixels").shape[1] == 4
    assert robot.get("ColorTable64.classes").shape == (64**3,)


def test_a_value_is_a_copy(match: gt2003.Match, robot: gt2003.Robot) -> None:
    pose = robot.get("RobotPose")
    pose.pose.translation[0] = 1e6
    assert robot.get("RobotPose").pose.translation[0] != 1e6


def test_values_that_nobody_provides_stay_as_they_were_set(robot: gt2003.Robot) -> None:
    robot.solve("SelfLocator", "disabled")
    assert robot.solutions["SelfLocator"] == "disabled"
    wanted = RobotPose(pose=Pose2D(rotation=0.1, translation=np.array([1.5, -2])), validity=0.25)
    robot.set("RobotPose", wanted)
    assert robot.get("RobotPose") == wanted
    robot.set("RobotPose.pose.translation", (3, np.float32(0.5)))
    np.testing.assert_array_equal(robot.get("RobotPose.pose.translation"), [3, 0.5])
    robot.set("RobotPose.pose.translation.y", np.int16(-7))
    assert robot.get("RobotPose.pose.translation.y") == -7
    robot.solve("SelfLocator", "Kalman")
    assert robot.solutions["SelfLocator"] == "Kalman"


def test_parameters_are_read_and_set_with_their_types(robot: gt2003.Robot) -> None:
    parameters = robot.parameters("BallLocator")
    assert parameters["outliersBelieved"] == 3 and isinstance(parameters["outliersBelieved"], int)
    robot.set("BallLocator.proportional", 0.5)
    robot.set("BallLocator.PIDSmoothed.outliersBelieved", 4)
    assert robot.get("BallLocator.proportional") == 0.5
    assert robot.get("BallLocator.PIDSmoothed.proportional") == 0.5
    assert robot.parameters("BallLocator")["outliersBelieved"] == 4
    assert robot.parameters("SelfLocator", "GT2003") != robot.parameters("SelfLocator", "Kalman")
    for task in robot.solutions:
        for solution in gt2003.modules.solutions()[task]:
            for path, value in robot.parameters(task, solution).items():
                assert np.array_equal(robot.get(f"{task}.{solution}.{path}"), value)


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        ("Nothing", 1, "no such representation or task"),
        ("BallModl.position", 1, "no such representation or task; did you mean 'BallModel'?"),
        ("BallLocater.proportional", 1, "no such representation or task; did you mean 'BallLocator'?"),
        ("BallLocator.proportionl", 1, "there is no such parameter; did you mean 'proportional'?"),
        ("RobotPose.validty", 1, "RobotPose has no field validty; did you mean 'validity'?"),
        ("RobotPose.place", 1, "RobotPose has no field place"),
        ("RobotPose.pose.rotation.x", 1, "a single value has no field x"),
        ("JointData.angles.tail", 1, "there is no element tail"),
        ("JointData.angles.99", 1, "there is no element 99"),
        ("BallLocator.gain", 1, "there is no such parameter"),
        ("RobotPose.pose.rotation", "north", "expected a number, got str"),
        ("RobotPose.pose.rotation", True, "expected a number, got bool"),
        ("RobotPose.pose.rotation", math.nan, "expected a finite number"),
        ("RobotPose.pose.rotation", None, "expected a number, got NoneType"),
        ("RobotPose.pose.translation", [1, 2, 3], "expected 2 elements, got 3"),
        ("RobotPose.pose.translation", 5, "expected an array, got int"),
        ("RobotPose.pose.translation", "ab", "expected an array, got str"),
        ("RobotPose", Pose2D(), "expected a RobotPose"),
        ("RobotPose.validity", 2.0, "RobotPose.validity: must be from 0 to 1"),
        ("BallPercept.seen", 1, "expected a bool, got int"),
        ("BallPercept.time", 1.5, "expected a whole number, got float"),
        ("BallPercept.time", 2**70, "out of the range"),
        ("GameControlData.state", "paused", "expected initial | "),
        ("GameControlData.state", 1, "expected a GameState or its name, got int"),
        ("BallLocator.proportional", 1e9, "must be from"),
        ("BallLocator.proportional", "much", "expected a number, got str"),
    ],
)
def test_what_does_not_fit_is_one_error_and_changes_nothing(
    robot: gt2003.Robot, path: str, value: object, message: str
) -> None:
    before = {name: robot.get(name) for name in ("RobotPose", "JointData", "BallPercept")}
    parameters = robot.parameters("BallLocator")
    with pytest.raises(gt2003.Error) as caught:
        robot.set(path, value)
    assert message in str(caught.value)
    assert caught.value.field.startswith(path.split(".")[0])
    assert {name: robot.get(name) for name in before} == before
    assert robot.parameters("BallLocator") == parameters


def test_fields_have_the_spelling_of_logs_too(robot: gt2003.Robot) -> None:
    robot.solve("BallLocator", "disabled")
    robot.set("BallModel.consecutive_time_seen", 40)
    assert robot.get("BallModel.consecutiveTimeSeen") == robot.get("BallModel.consecutive_time_seen") == 40
    robot.solve("BallLocator", "PIDSmoothed")


def test_unknown_tasks_and_solutions_are_told(robot: gt2003.Robot) -> None:
    for task, solution in (("BallFinder", "Kalman"), ("BallLocator", "Best"), ("", "")):
        with pytest.raises(gt2003.Error):
            robot.solve(task, solution)
    with pytest.raises(gt2003.Error, match="no solution 'Best'"):
        robot.parameters("BallLocator", "Best")
    with pytest.raises(gt2003.Error, match="no solution 'PIDSmooth'.*; did you mean 'PIDSmoothed'?"):
        robot.solve("BallLocator", "PIDSmooth")


def test_records_refuse_unknown_fields() -> None:
    with pytest.raises(TypeError, match="BallPercept has no field hue"):
        BallPercept(hue=3)
    percept = BallPercept()
    with pytest.raises(AttributeError):
        percept.hue = 3
    assert math.isfinite(percept.angle[0])
