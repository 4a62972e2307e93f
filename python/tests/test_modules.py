"""Modules by themselves: all of them, with what a robot's modules read, and with junk."""

from __future__ import annotations

import random

import numpy as np
import pytest

import gt2003
from gt2003 import modules, representations
from gt2003.representations import BallModel, BallPercept, Image, LandmarksPercept, RobotPose

ALL = [(task, name) for task, known in modules.solutions().items() for name in known]


@pytest.fixture(scope="module")
def match() -> gt2003.Match:
    match = gt2003.Match(seed=6)
    match.run(15)
    return match


def make(task: str, solution: str) -> modules.Module:
    return getattr(modules, task)(solution)


def input_names(task: str, solution: str) -> list[str]:
    return gt2003._core._solutions()[task][solution][0]


def output_names(task: str, solution: str) -> list[str]:
    return gt2003._core._solutions()[task][solution][1]


def given_by(robot: gt2003.Robot, task: str, solution: str) -> dict[str, object]:
    """Return the inputs of a solution as a robot has them."""
    return {
        gt2003._core._input_name(name): robot.get(name) for name in input_names(task, solution)
    }


@pytest.mark.parametrize(("task", "solution"), ALL)
def test_every_solution_runs_alone(match: gt2003.Match, task: str, solution: str) -> None:
    inputs = given_by(match.robots["red2"], task, solution)
    one, other = make(task, solution), make(task, solution)
    assert (one.task, one.solution) == (task, solution)
    for _ in range(3):
        outputs = one.update(**inputs)
        assert outputs == other.update(**inputs)  # the same seed, the same bits
    names = output_names(task, solution)
    listed = outputs if len(names) > 1 else (outputs,)
    assert [type(output).__name__ for output in listed] == names
    assert one.parameters.keys() == other.parameters.keys()


def test_the_image_processor_sees_what_the_robots_sees() -> None:
    match = gt2003.Match(seed=6)
    robot = match.robots["blue2"]
    alone = modules.ImageProcessor("GT2003")
    compared = seen = 0
    while compared < 100:  # from the first image on: it learns the light
        before = robot.get("Image.time")
        match.step()
        if robot.get("Image.time") == before:
            continue
        inputs = given_by(robot, "ImageProcessor", "GT2003")
        ball, landmarks, lines, players, obstacles = alone.update(**inputs)
        assert ball == robot.get("BallPercept")
        truth = robot.get("LandmarksPercept")
        count = landmarks.numberOfFlags
        assert count == truth.numberOfFlags and landmarks.flags[:count] == truth.flags[:count]
        assert obstacles == robot.get("ObstaclesPercept")
        seen += ball.seen + count
        compared += 1
    assert seen > 0


def test_a_ball_locator_finds_where_the_percepts_are() -> None:
    locator = modules.BallLocator()
    assert locator.solution == "PIDSmoothed"
    for i in range(20):
        ball = locator.update(
            ball_percept=BallPercept(time=40 * i, seen=True, offset=np.array([500.0, 100.0])),
            frame_info={"time": 40 * i},
        )
    assert isinstance(ball, BallModel)
    np.testing.assert_allclose(ball.position, [500, 100], atol=10)


def test_inputs_that_are_not_given_keep_their_values() -> None:
    locator = modules.SelfLocator("Oracled")
    pose = locator.update(oracled_world_state={"robotPose": {"rotation": 0.5}})
    assert pose.pose.rotation == 0.5
    pose = locator.update(oracled_world_state={"robotPose": {"translation": [1, 2]}})
    assert pose.pose.rotation == 0.5
    np.testing.assert_array_equal(pose.pose.translation, [1, 2])


def test_seeds_count_where_there_is_chance(match: gt2003.Match) -> None:
    inputs = given_by(match.robots["red2"], "SelfLocator", "MonteCarlo")
    poses = [
        modules.SelfLocator("MonteCarlo", seed=seed).update(**inputs).pose.translation
        for seed in (1, 1, 2)
    ]
    np.testing.assert_array_equal(poses[0], poses[1])
    assert not np.array_equal(poses[0], poses[2])


def test_parameters_change_what_it_does() -> None:
    locator = modules.BallLocator("PIDSmoothed")
    locator.set("proportional", 0.5)
    assert locator.get("proportional") == 0.5 == locator.parameters["proportional"]
    for path, value, message in (
        ("proportional", "x", "expected a number, got str"),
        ("proportional", 1e9, "must be from"),
        ("speed", 1, "no such parameter"),
    ):
        with pytest.raises(gt2003.Error, match=message):
            locator.set(path, value)
    assert locator.get("proportional") == 0.5


@pytest.mark.parametrize(
    ("inputs", "message"),
    [
        ({"landmarks": LandmarksPercept()}, "landmarks: Kalman has no such input, only landmarks_"),
        ({"landmarks_percept": 3}, "landmarks_percept: expected a LandmarksPercept, got int"),
        ({"landmarks_percept": RobotPose()}, "expected a LandmarksPercept, got RobotPose"),
        ({"landmarks_percept": {"flag": []}}, "flag: LandmarksPercept has no field flag; did you mean 'flags'?"),
        ({"landmarks_percept": {"flags": 6 * [1]}}, "landmarks_percept.flags.0: expected a "),
        ({"odometry_data": {"pose": {"translation": [1, 2, 3]}}}, "expected an array of shape (2)"),
        ({"odometry_data": {"pose": {"translation": ["a", "b"]}}}, "expected an array of float64"),
        ({"odometry_data": {"pose": {"rotation": []}}}, "odometry_data.pose.rotation: expected a n"),
        ({"odometry_data": {"pose": {"rotation": float("inf")}}}, "expected a finite number"),
        ({"odometry_data": {"pose": {"translation": [0, float("nan")]}}}, "expected finite numbers"),
    ],
)
def test_wrong_inputs_are_one_error(inputs: dict[str, object], message: str) -> None:
    locator = modules.SelfLocator("Kalman")
    before = locator.update()
    with pytest.raises(gt2003.Error) as caught:
        locator.update(**inputs)
    assert message in str(caught.value)
    assert locator.update() == before


def test_unknown_names_are_told() -> None:
    with pytest.raises(gt2003.Error, match="there is no solution 'Best', only PIDSmoothed | "):
        modules.BallLocator("Best")
    with pytest.raises(gt2003.Error, match="there is no such task"):
        modules.Module("BallFinder", "Kalman")
    with pytest.raises(gt2003.Error, match="did you mean 'PIDSmoothed'"):
        modules.BallLocator("PidSmoothed")
    with pytest.raises(gt2003.Error, match="BallLocater: there is no such task; did you mean 'BallLocator'"):
        modules.Module("BallLocater", "Kalman")
    with pytest.raises(gt2003.Error, match="image: GT2003 needs one"):
        modules.ImageProcessor().update()


def test_an_image_has_as_many_pixels_as_it_says() -> None:
    processor = modules.ImageProcessor()
    image = Image(pixels=np.zeros((10, 4), np.uint8))
    with pytest.raises(gt2003.Error, match="its pixels are not as many as its size says"):
        processor.update(image=image)
    with pytest.raises(gt2003.Error, match="shape"):
        processor.update(image={"pixels": np.zeros((10, 3), np.uint8)})


def junk(chance: random.Random) -> object:
    """Return an object that hardly anything expects."""
    return chance.choice(
        [
            None,
            True,
            -1,
            2**80,
            1e308,
            float("nan"),
            "",
            "\0",
            "x" * 1000,
            b"x",
            [],
            [[]],
            [1, 2],
            ["a", None],
            {},
            {"x": 1},
            {1: 2},
            object(),
            np.zeros(0),
            np.zeros((3, 4, 5)),
            np.array(["a"]),
            np.array([None]),
            np.float64("inf"),
            np.zeros((2, 2))[:, ::2],
            representations.BallPercept(),
            representations.ColorClass.orange,
            representations.Pose2D,
        ]
    )


def test_junk_ends_in_exceptions(match: gt2003.Match) -> None:
    chance = random.Random(1)
    robot = match.robots["red4"]
    caught = 0
    for _ in range(3000):
        name = chance.choice(robot.representations)
        field = chance.choice(getattr(representations, name).fields or (None,))
        path = f"{name}.{field.name}" if field and chance.random() < 0.8 else name
        task, solution = chance.choice(ALL)
        record = getattr(representations, name)()
        if field:
            setattr(record, field.name, junk(chance))
        try:
            if chance.random() < 0.5:
                robot.set(path, chance.choice([junk(chance), record]))
            else:
                inputs = {gt2003._core._input_name(name): chance.choice([record, junk(chance)])}
                make(task, solution).update(**inputs)
        except (gt2003.Error, TypeError, ValueError):
            caught += 1
    assert caught > 1000
