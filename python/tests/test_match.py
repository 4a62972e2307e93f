"""Matches: the same bits as `simgt play`, saved and loaded, stopped and asked meanwhile."""

from __future__ import annotations

import copy
import gc
import math
import os
import pickle
import signal
import subprocess
import threading
from collections.abc import Callable
from pathlib import Path

import cloudpickle
import numpy as np
import pytest

import gt2003
from gt2003.representations import ColorClass, MotionRequest

BUILD = Path(os.environ["GT_BUILD"])
# Robots are put to their places after two seconds.
SHORT = str(Path(__file__).parents[2] / "tests/support/short.scene")


def all_values(match: gt2003.Match) -> dict[str, dict[str, object]]:
    """Return every representation of every robot."""
    return {
        name: {representation: robot.get(representation) for representation in robot.representations}
        for name, robot in match.robots.items()
    }


def test_plays_the_same_bytes_as_simgt(tmp_path: Path) -> None:
    simgt, python = tmp_path / "simgt", tmp_path / "python"
    subprocess.run(
        [BUILD / "bin/simgt", "play", SHORT, "--seed", "3", "--minutes", "0.15", "--out", simgt],
        check=True,
        capture_output=True,
    )
    match = gt2003.Match(SHORT, seed=3, minutes=0.15, threads=2, logs=str(python))
    assert match.run() is False
    match.close()
    match.write_summary(str(python / "match.json"))
    written = sorted(file.name for file in python.iterdir())
    assert "match.json" in written and "red1.mcap" in written
    for name in written:
        assert (python / name).read_bytes() == (simgt / name).read_bytes(), name


def test_steps_are_as_good_as_a_run() -> None:
    stepped, run = gt2003.Match(seed=5), gt2003.Match(seed=5)
    for _ in range(125):
        assert stepped.step()
    assert run.run(1)
    assert stepped.time == run.time == 1000
    assert all_values(stepped) == all_values(run)


def test_ends_when_the_game_is_over() -> None:
    match = gt2003.Match(SHORT, minutes=0.02)
    assert match.run() is False
    assert match.finished and match.game_state == "finished"
    assert match.step() is False
    assert match.events[-1].kind == "gameOver"
    assert match.summary().duration == match.time


def test_runs_until_a_condition_holds() -> None:
    match = gt2003.Match(seed=1)
    assert match.until(lambda: match.game_state == "ready", 30)
    at = match.time
    assert not match.until(lambda: False, 0.5)
    assert match.time == at + 504  # the first step that is not before


def test_a_predicate_that_raises_ends_until() -> None:
    match = gt2003.Match()

    def fail() -> bool:
        raise KeyError("why")

    with pytest.raises(KeyError, match="why"):
        match.until(fail)
    assert match.step()


def test_places_robots_and_balls() -> None:
    match = gt2003.Match()
    match.place("red2", -500, 300, 1)
    match.place("ball", 100.5, -200)
    pose = match.robots["red2"].true_pose
    np.testing.assert_array_equal(pose.translation, [-500, 300])
    assert pose.rotation == pytest.approx(1, abs=1e-12)
    np.testing.assert_array_equal(match.ball_position, [100.5, -200])
    np.testing.assert_array_equal(match.ball_speed, [0, 0])
    match.place("red2", 0, 0)
    assert match.robots["red2"].true_pose.rotation == pose.rotation


def test_a_loaded_state_goes_on_with_the_same_bits(tmp_path: Path) -> None:
    file = str(tmp_path / "a.state")
    match = gt2003.Match(seed=9, profile="rough", threads=2)
    match.run(3)
    match.place("ball", 300, 100)
    match.place("blue1", 500, 200, -math.pi / 3)
    red = match.robots["red1"]
    red.set("BallLocator.trustedDistance", 700)
    red.solve("SelfLocator", "GT2003")
    match.run(1)
    match.save(file)
    loaded = gt2003.Match.load(file)
    assert loaded.time == match.time
    assert all_values(loaded) == all_values(match)
    match.run(2)
    loaded.run(2)
    assert all_values(loaded) == all_values(match)
    assert loaded.summary() == match.summary()
    assert loaded.robots["red1"].solutions["SelfLocator"] == "GT2003"


@pytest.mark.parametrize("way", [copy.copy, copy.deepcopy, pickle.dumps, cloudpickle.dumps])
def test_copies_are_refused_with_the_way_to_have_one(way: Callable[[object], object]) -> None:
    match = gt2003.Match("one-robot")
    for thing in (match, match.robots["red3"]):
        with pytest.raises(gt2003.Error, match="Match.save writes its state to a file, which Match.load reads"):
            way(thing)


def test_a_state_that_was_changed_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "a.state"
    match = gt2003.Match(seed=9)
    match.run(0.5)
    match.save(str(file))
    file.write_text(file.read_text().replace('"seed": 9', '"seed": 8'))
    with pytest.raises(gt2003.Error, match="another way") as caught:
        gt2003.Match.load(str(file))
    assert caught.value.file == str(file) and caught.value.field == "fingerprint"
    file.write_text("{")
    with pytest.raises(gt2003.Error, match="JSON"):
        gt2003.Match.load(str(file))


def test_only_robots_that_are_given_the_truth_may_ask_for_it() -> None:
    match = gt2003.Match(SHORT, seed=4, minutes=0.05, truth=["red2"])
    match.robots["red2"].solve("SelfLocator", "Oracled")
    with pytest.raises(gt2003.Error, match="'Oracled' reads OracledWorldState, which this robot does not get"):
        match.robots["red1"].solve("SelfLocator", "Oracled")
    match.run()
    assert match.summary().truth == ["red2"]


def test_what_always_holds_is_checked_if_asked() -> None:
    match = gt2003.Match(SHORT, seed=4, minutes=0.05, check=True)
    match.robots["red2"].solve("SelfLocator", "disabled")
    match.run()
    assert [(b.invariant, b.who, b.severity.name) for b in match.summary().broken] == [("solved", "red2", "warning")]
    assert gt2003.Match(SHORT, seed=4, minutes=0.05).summary().broken == []


def test_requests_move_a_robot() -> None:
    match = gt2003.Match(seed=2)
    match.until(lambda: match.game_state == "playing", 60)
    red = match.robots["red1"]
    red.solve("BehaviorControl", "disabled")
    before = red.true_pose
    request = red.get("MotionRequest")
    assert isinstance(request, MotionRequest)
    red.set("MotionRequest.type", "walk")
    red.set("MotionRequest.walk.translation", [100, 0])
    for _ in range(20):
        red.set("MotionRequest.time", match.time)
        match.run(0.1)
    walked = np.linalg.norm(red.true_pose.translation - before.translation)
    assert 50 < walked < 300


def test_images_are_views_that_keep_the_match() -> None:
    match = gt2003.Match()
    robot = match.robots["red1"]
    assert robot.image is None
    match.run(0.1)
    image = robot.image
    assert image is not None
    info = robot.get("Image.info")
    assert image.shape == (info.height, info.width, 3) and image.dtype == np.uint8
    assert np.shares_memory(image, robot.image)
    np.testing.assert_array_equal(
        image.reshape(-1, 3), robot.get("Image.pixels")[:, :3]
    )
    with pytest.raises(ValueError, match="read-only"):
        image[0, 0, 0] = 1
    copy = image.copy()
    del match, robot
    gc.collect()
    np.testing.assert_array_equal(image, copy)


def test_labels_are_those_of_the_image() -> None:
    match = gt2003.Match(labels=True, profile="perfect")
    red = match.robots["red1"]
    assert red.labels is None
    match.place("red1", 0, 0, 0)
    match.place("ball", 400, 0)
    bodies = np.array(match.geom_bodies)
    ball = [i for i, body in enumerate(bodies) if body.startswith("ball0")]

    def sees_ball() -> bool:
        return red.labels is not None and np.isin(red.labels[1], ball).sum() > 30

    assert match.until(sees_ball, 5)
    classes, geoms = red.labels
    assert classes.shape == geoms.shape == red.image.shape[:2]
    shown = np.isin(geoms, ball)
    assert set(classes[shown]) == {ColorClass.orange}
    assert red.image[shown][:, 2].mean() > red.image[~shown][:, 2].mean() + 30  # Cr
    with pytest.raises(gt2003.Error, match="labels=True"):
        gt2003.Match().robots["red1"].labels


def test_runs_without_the_lock_and_refuses_others_meanwhile() -> None:
    match = gt2003.Match()
    robot = match.robots["red1"]
    runs = threading.Thread(target=match.run, args=(20,))
    runs.start()
    refused = 0
    while runs.is_alive():
        try:
            robot.get("RobotPose")
        except gt2003.Error as error:
            assert "another thread" in str(error)
            refused += 1
    runs.join()
    assert refused > 0
    assert match.time == 20_000
    assert robot.get("RobotPose") is not None


def test_matches_in_several_threads_do_not_disturb_each_other() -> None:
    matches = [gt2003.Match(seed=seed) for seed in (1, 2)]
    runs = [threading.Thread(target=match.run, args=(2,)) for match in matches]
    for thread in runs:
        thread.start()
    for thread in runs:
        thread.join()
    for seed, match in zip((1, 2), matches, strict=True):
        alone = gt2003.Match(seed=seed)
        alone.run(2)
        assert all_values(match) == all_values(alone)


def test_ctrl_c_ends_a_run_and_the_match_goes_on() -> None:
    match = gt2003.Match()
    threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        match.run(3600)
    at = match.time
    assert match.step() and match.time == at + 8


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"scene": "nowhere"}, "nowhere.scene: there is no such file"),
        ({"scene": "mach"}, "mach.scene: there is no such file; did you mean 'match'?"),
        ({"profile": "perfekt"}, 'profile: unknown: "perfekt"'),
        ({"minutes": 0}, "minutes: must be from 0.01 to 10000"),
        ({"minutes": math.nan}, "minutes: must be from 0.01 to 10000"),
        ({"threads": 0}, "threads: must be from 1 to 256"),
        ({"root": "/proc"}, "/proc: --root: is no data root"),
        ({"logs": "/proc/logs"}, "/proc/logs: "),
    ],
)
def test_wrong_arguments_are_told(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(gt2003.Error) as caught:
        gt2003.Match(**arguments)
    assert message in str(caught.value)


def test_wrong_types_are_type_errors() -> None:
    for arguments in ({"seed": "one"}, {"scene": 3}, {"lens": 1}):
        with pytest.raises(TypeError):
            gt2003.Match(**arguments)
    match = gt2003.Match()
    for seconds in (-1, math.nan, 1e300):
        with pytest.raises(gt2003.Error, match="seconds"):
            match.run(seconds)
    with pytest.raises(gt2003.Error, match="no robot of this name"):
        match.place("green1", 0, 0)
    with pytest.raises(gt2003.Error):
        match.place("red1", math.nan, 0)
    with pytest.raises(KeyError):
        match.robots["green1"]


def test_the_console_prints_to_python() -> None:
    match = gt2003.Match(SHORT, seed=3)
    assert "PIDSmoothed" in match.console("sr BallLocator ?", robot="red1")
    before = match.time
    match.console("run 400 ms")
    assert match.time == before + 400
    match.console("sr BallLocator BallChallenge", robot="red2")
    assert match.robots["red2"].solutions["BallLocator"] == "BallChallenge"
    assert match.robots["red1"].solutions["BallLocator"] == "PIDSmoothed"
    assert match.console("") == ""


@pytest.mark.parametrize(
    ("line", "robot", "message"),
    [
        ("reset", "", "reset: is not for a match of Python"),
        ("call script", "", "call: is not for a match of Python"),
        ("robot red1", "", "name it: match.console"),
        ("get time", "red9", "there is no 'red9'; did you mean 'red1'?"),
        ("pictur field a.png", "", "did you mean 'picture'?"),
        ('echo "', "", "a quote is not closed"),
    ],
)
def test_the_console_refuses_what_would_end_the_match(line: str, robot: str, message: str) -> None:
    match = gt2003.Match(SHORT)
    with pytest.raises(gt2003.Error) as raised:
        match.console(line, robot=robot)
    assert message in str(raised.value)
    assert match.run(0.1)


def test_console_lines_are_saved_with_the_match(tmp_path: Path) -> None:
    match = gt2003.Match(SHORT, seed=3)
    match.console("sr BallLocator BallChallenge", robot="red2")
    match.run(1)
    match.save(str(tmp_path / "a.state"))
    again = gt2003.Match.load(str(tmp_path / "a.state"))
    assert all_values(again) == all_values(match)


def test_pictures_are_arrays_and_files(tmp_path: Path) -> None:
    match = gt2003.Match(SHORT, seed=3)
    match.run(1)
    field = match.picture("field", file=str(tmp_path / "field.png"))
    assert field.dtype == np.uint8 and field.ndim == 3 and field.shape[2] == 3
    assert (tmp_path / "field.png").read_bytes().startswith(b"\x89PNG")
    assert len(np.unique(field.reshape(-1, 3), axis=0)) > 5, "a field has several colors"
    left, ahead = (match.picture("robot", robot="red2", numbers=[angle]) for angle in (90, 0))
    assert not np.array_equal(left, ahead)
    assert np.array_equal(left, match.picture("robot", robot="red2", numbers=[90]))
    with pytest.raises(gt2003.Error, match="view: there is no 'feild'; did you mean 'field'?"):
        match.picture("feild")


def test_films_end_with_their_block(tmp_path: Path) -> None:
    match = gt2003.Match(SHORT, seed=3)
    with match.film(str(tmp_path / "a b.mp4"), "field") as film:
        match.run(0.4)
    assert film.path.stat().st_size > 500
    assert film.end() == film.path, "has ended before"
    with pytest.raises(gt2003.Error, match="none is being made"):
        match.console("film stop")
