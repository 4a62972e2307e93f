"""Solutions written in Python: they play, alone and with others, and fail without harm."""

from __future__ import annotations

import copy
import gc
import threading
import time
import warnings
import weakref
from pathlib import Path

import numpy as np
import pytest

import gt2003
from gt2003 import Previous
from gt2003.representations import (
    BallModel,
    BallPercept,
    FrameInfo,
    MotionRequest,
    OdometryData,
    RobotPose,
)


class LastSeen:
    """The ball is where it was seen last."""

    def __init__(self) -> None:
        self.model = BallModel()
        self.calls = 0

    def update(self, ball_percept: BallPercept, frame_info: FrameInfo) -> BallModel:
        self.calls += 1
        if ball_percept.seen:
            self.model.position = ball_percept.offset
            self.model.lastSeen = frame_info.time
        return self.model


class Keeps:
    """Keeps what it gets, and parts of it, and changes the rest."""

    def __init__(self) -> None:
        self.seen: list[BallPercept] = []
        self.kept: list[tuple[object, object]] = []
        self.mine = np.zeros(3)

    def update(self, ball_percept: BallPercept, frame_info: FrameInfo) -> BallModel:
        self.seen.append(copy.deepcopy(ball_percept))
        parts = [ball_percept, ball_percept.offset, ball_percept.angle[1:], ball_percept.centerInImage]
        kind = len(self.seen) % 7
        if kind < 4:
            self.kept.append((parts[kind], copy.deepcopy(parts[kind])))
        elif kind == 4:
            ball_percept.offset = self.mine[:2]
            ball_percept.angle.shape = (2, 1)
        elif kind == 5:
            ball_percept.centerInImage.dtype = "i8"
            del ball_percept.angle
        return BallModel()


class Noisy:
    """Draws its results."""

    def update(
        self, random: np.random.Generator, ball_model: Previous[BallModel], odometry_data: OdometryData
    ) -> BallModel:
        return BallModel(position=ball_model.position / 2 + random.normal(size=2))


class Fails(LastSeen):
    """Fails in its tenth cycle."""

    def update(self, ball_percept: BallPercept, frame_info: FrameInfo) -> BallModel:
        if self.calls == 9:
            raise ZeroDivisionError("the tenth")
        return super().update(ball_percept, frame_info)


def everything(match: gt2003.Match) -> list[object]:
    return [
        [robot.get(name) for name in robot.representations] for robot in match.robots.values()
    ]


def test_a_solution_that_waits_changes_nothing() -> None:
    match, other = gt2003.Match(seed=3), gt2003.Match(seed=3)
    for _ in range(2):
        match.run(1)
        other.run(1)
        match.robots["red1"].solve("BallLocator", LastSeen)
        match.robots["red1"].solve("BallLocator", "PIDSmoothed")
    match.run(1)
    other.run(1)
    assert everything(match) == everything(other)


def test_it_plays_and_is_replaced() -> None:
    match = gt2003.Match(seed=3)
    robot = match.robots["red2"]
    made = robot.solve("BallLocator", LastSeen)
    assert isinstance(made, LastSeen) and robot.solutions["BallLocator"] == "LastSeen"
    match.place("red2", 0, 0, 0)
    match.place("ball", 400, 0)
    assert match.until(lambda: bool(robot.get("BallPercept.seen")), 10)
    assert robot.get("BallModel") == made.model
    np.testing.assert_array_equal(robot.get("BallModel.position"), robot.get("BallPercept.offset"))
    assert robot.times["BallLocator"].count == made.calls
    assert robot.times["BallLocator"].totalMs > 0
    assert "BallLocator" in {part.part for part in match.times}
    calls = made.calls
    robot.solve("BallLocator", "Probabilistic")
    match.run(0.2)
    assert made.calls == calls and robot.solutions["BallLocator"] == "Probabilistic"
    assert "LastSeen" in match.console("sr BallLocator ?", robot="red2")
    match.console("sr BallLocator LastSeen", robot="red2")
    match.run(0.2)
    assert made.calls > calls
    with pytest.raises(gt2003.Error, match="there is no solution 'LastSeen'"):
        match.console("sr BallLocator LastSeen", robot="red3")
    robot.solve("BallLocator", "LastSeen")
    assert robot.solve("BallLocator", LastSeen) is not made  # another object of the same name
    assert match.failures == []


def test_its_inputs_are_its_own() -> None:
    match = gt2003.Match(seed=3)
    robot = match.robots["red2"]
    made = robot.solve("BallLocator", Keeps)
    match.place("red2", 0, 0, 0)
    match.place("ball", 400, 0)
    percepts = []
    while len(made.seen) < 60:
        before = len(made.seen)
        match.step()
        if len(made.seen) > before:
            percepts.append(robot.get("BallPercept"))
    assert made.seen == percepts and len({percept.offset[0] for percept in percepts}) > 10
    assert len(made.kept) > 20
    for kept, copied in made.kept:
        np.testing.assert_equal(kept, copied)
    assert not made.mine.any()
    assert match.failures == []


@pytest.mark.parametrize("profile", ["perfect", "rough"])
def test_threads_do_not_change_what_happens(profile: str) -> None:
    tasks = {"BallLocator": Noisy}
    solutions = {"red1": tasks, "red2": {"BallLocator": LastSeen}, "blue3": tasks}
    results = []
    for threads in (1, 2, 4):
        match = gt2003.Match(seed=8, threads=threads, profile=profile, solutions=solutions)
        match.run(4)
        results.append(everything(match))
    assert results[0] == results[1] == results[2]
    positions = [match.robots[name].get("BallModel.position") for name in ("red1", "blue3")]
    assert not np.array_equal(*positions)  # each robot has its own chance


def test_an_exception_is_told_and_the_robot_goes_on() -> None:
    match = gt2003.Match(seed=3, solutions={"red3": {"BallLocator": Fails}})
    robot = match.robots["red3"]
    with pytest.warns(RuntimeWarning, match="red3's BallLocator Fails failed at") as told:
        match.run(1)
    assert len(told) == 1
    (failure,) = match.failures
    assert (failure.robot, failure.task, failure.solution) == ("red3", "BallLocator", "Fails")
    assert "test_solutions.py" in failure.trace and "ZeroDivisionError: the tenth" in failure.trace
    assert 0 < failure.time < 1000
    assert robot.solutions["BallLocator"] == "PIDSmoothed"
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert match.run(1)
    robot.solve("BallLocator", Fails)
    with warnings.catch_warnings(), pytest.raises(RuntimeWarning, match="the tenth"):
        warnings.simplefilter("error")
        match.run(1)
    assert len(match.failures) == 2 and match.run(0.1)


def test_a_failed_solution_gives_way_to_the_compiled_one() -> None:
    match = gt2003.Match()
    robot = match.robots["red1"]
    robot.solve("BallLocator", "Probabilistic")
    robot.solve("BallLocator", LastSeen)
    robot.solve("BallLocator", Fails)
    with pytest.warns(RuntimeWarning):
        match.run(1)
    assert robot.solutions["BallLocator"] == "Probabilistic"


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (None, "expected a BallModel, got NoneType"),
        (RobotPose(), "expected a BallModel, got RobotPose"),
        ({"position": [1, np.nan]}, "expected finite numbers"),
        ({"place": 1}, "BallModel.place: BallModel has no field place"),
    ],
)
def test_what_does_not_fit_is_a_failure(returned: object, message: str) -> None:
    class Returns:
        def update(self, frame_info: FrameInfo) -> BallModel:
            return returned  # type: ignore[return-value]

    match = gt2003.Match(solutions={"blue1": {"BallLocator": Returns}})
    before = match.robots["blue1"].get("BallModel")
    match.robots["blue1"].solve("BallLocator", "disabled")
    match.robots["blue1"].solve("BallLocator", Returns)
    with pytest.warns(RuntimeWarning):
        match.run(0.1)
    assert message in match.failures[0].trace
    assert match.robots["blue1"].solutions["BallLocator"] == "disabled"
    assert match.robots["blue1"].get("BallModel") == before


class Untyped:
    def update(self, ball_percept) -> BallModel: ...  # type: ignore[no-untyped-def, empty-body]


class Misnamed:
    def update(self, ball: BallPercept) -> BallModel: ...  # type: ignore[empty-body]


class OfAnotherClass:
    def update(self, ball_percept: RobotPose) -> BallModel: ...  # type: ignore[empty-body]


class ReturnsNothing:
    def update(self, ball_percept: BallPercept): ...  # type: ignore[no-untyped-def]


class ReturnsAnother:
    def update(self, ball_percept: BallPercept) -> RobotPose: ...  # type: ignore[empty-body]


class TakesAll:
    def update(self, **inputs: BallPercept) -> BallModel: ...  # type: ignore[empty-body]


class Unresolved:
    def update(self, ball_percept: Percept) -> BallModel: ...  # type: ignore[empty-body, name-defined] # noqa: F821


class Circle:
    def update(self, motion_request: MotionRequest) -> BallModel: ...  # type: ignore[empty-body]


@pytest.mark.parametrize(
    ("task", "solution", "message"),
    [
        ("BallLocator", Untyped, "Untyped.update.ball_percept: must be annotated as BallPercept"),
        ("BallLocator", Misnamed, "Misnamed.update.ball: there is no representation of this name"),
        ("BallLocator", OfAnotherClass, "ball_percept: must be annotated as BallPercept"),
        ("BallLocator", ReturnsNothing, "must be annotated to return BallModel"),
        ("BallLocator", ReturnsAnother, "must be annotated to return BallModel"),
        ("BallLocator", TakesAll, "inputs: an input has to be named"),
        ("BallLocator", Unresolved, "NameError: name 'Percept' is not defined"),
        ("BallLocator", object, "object: has no method `update`"),
        ("BallLocator", 3, "expected a solution's name, or a class"),
        ("BallLocator", LastSeen(), "expected a solution's name, or a class"),
        ("BallLocator", "Best", "no solution 'Best'"),
        ("BallFinder", LastSeen, "BallFinder: there is no such task"),
        ("BallLocator", Circle, "a circle of tasks that wait for each other"),
        ("ImageProcessor", LastSeen, "must be annotated to return tuple[BallPercept, Landm"),
    ],
)
def test_what_does_not_fit_is_refused_before_it_plays(
    task: str, solution: object, message: str
) -> None:
    match = gt2003.Match()
    robot = match.robots["red1"]
    before = robot.solutions
    with pytest.raises(gt2003.Error) as caught:
        robot.solve(task, solution)  # type: ignore[arg-type]
    assert message in str(caught.value)
    with pytest.raises(gt2003.Error):
        gt2003.Match(solutions={"red1": {task: solution}})  # type: ignore[dict-item]
    assert robot.solutions == before and match.run(0.1)


def test_errors_tell_file_and_line() -> None:
    with pytest.raises(gt2003.Error) as caught:
        gt2003.Match().robots["red1"].solve("BallLocator", Misnamed)
    assert caught.value.file == __file__
    assert "Misnamed" in Path(__file__).read_text().splitlines()[caught.value.line - 2]
    with pytest.raises(gt2003.Error, match="no robot 'green1'"):
        gt2003.Match(solutions={"green1": {}})


def test_names_of_compiled_solutions_are_taken() -> None:
    taken = type("Kalman", (LastSeen,), {})
    robot = gt2003.Match().robots["red1"]
    taken_here = type("PIDSmoothed", (LastSeen,), {})
    with pytest.raises(gt2003.Error, match="has a solution 'PIDSmoothed' already"):
        robot.solve("BallLocator", taken_here)
    robot.solve("BallLocator", taken)


def test_it_cannot_be_saved(tmp_path: Path) -> None:
    match = gt2003.Match(solutions={"red1": {"BallLocator": LastSeen}})
    with pytest.raises(gt2003.Error, match="red1 has a solution that is written in Python"):
        match.save(str(tmp_path / "a.state"))


def test_it_must_not_use_its_match() -> None:
    class Nosy(LastSeen):
        def update(self, frame_info: FrameInfo) -> BallModel:  # type: ignore[override]
            return match.robots["red1"].get("BallModel")

    match = gt2003.Match(solutions={"red1": {"BallLocator": Nosy}})
    with pytest.warns(RuntimeWarning, match="it runs"):
        match.run(0.1)


def test_it_cannot_join_a_match_that_runs() -> None:
    match = gt2003.Match()
    robot = match.robots["red1"]
    started = []

    def runs() -> bool:
        try:
            robot.get("RobotPose")
        except gt2003.Error as error:
            return "another thread" in str(error)
        return False

    class Starts(LastSeen):
        def __init__(self) -> None:
            super().__init__()
            started.append(threading.Thread(target=match.run, args=(20,)))
            started[0].start()
            while started[0].is_alive() and not runs():
                time.sleep(0.001)

    with pytest.raises(gt2003.Error, match="runs in another thread"):
        robot.solve("BallLocator", Starts)
    started[0].join()
    assert robot.solutions["BallLocator"] == "PIDSmoothed" and match.run(0.1)


def test_a_match_that_its_solution_knows_is_freed() -> None:
    class Knows(LastSeen):
        def __init__(self) -> None:
            super().__init__()
            self.robot = robots["red1"]

    robots: dict[str, gt2003.Robot] = {}
    match = gt2003.Match()
    robots.update(match.robots)
    made = weakref.ref(match.robots["red1"].solve("BallLocator", Knows))
    match.run(0.1)
    del match
    gc.collect()
    assert made() is not None
    robots.clear()
    gc.collect()
    assert made() is None


def test_matches_with_solutions_run_beside_python() -> None:
    solutions = {name: {"BallLocator": LastSeen} for name in ("red1", "red2", "blue1")}
    matches = [gt2003.Match(seed=i, threads=2, solutions=solutions) for i in range(2)]
    runs = [threading.Thread(target=match.run, args=(2,)) for match in matches]
    for run in runs:
        run.start()
    end = time.monotonic() + 60
    while any(run.is_alive() for run in runs) and time.monotonic() < end:
        sum(range(1000))
    assert all(match.time == 2000 for match in matches)
