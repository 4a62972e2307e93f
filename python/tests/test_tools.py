"""XABSL, motion nets and color tables."""

from __future__ import annotations

import gc
import subprocess
import os
import resource
import warnings
import weakref
from pathlib import Path

import numpy as np
import pytest

import gt2003
from gt2003 import colors, motions, xabsl
from gt2003.representations import ColorClass, JointData

BUILD = Path(os.environ["GT_BUILD"])
ROOT = Path(__file__).resolve().parents[2]

AGENTS = """
include "options.xabsl";
namespace symbols("symbols") {
  float input ball.distance;
  bool input ball.seen;
  enum mode { slow, fast };
  enum mode input wanted_mode;
  enum mode output drive_mode;
  float output speed;
  float input twice(float of;);
}
namespace behaviors("behaviors") {
  behavior walk { float x; }
  behavior stand { }
}
"""
OPTIONS = """
option root {
  initial state search {
    decision { if (ball.seen && twice(of = ball.distance) > 100) goto run; else stay; }
    action { stand(); speed = 0; drive_mode = slow; }
  }
  state run {
    decision { if (!ball.seen) goto search; else stay; }
    action { walk(x = ball.distance / 2); speed = 7.5; drive_mode = wanted_mode; }
  }
}
"""


def small() -> xabsl.Behavior:
    files = {"agents.xabsl": AGENTS + 'agent player("player", root);\n', "options.xabsl": OPTIONS}
    compiled = xabsl.compile("agents.xabsl", files)
    assert compiled.behavior is not None, [str(d) for d in compiled.diagnostics]
    return compiled.behavior


def test_xabsl_compiles_the_robots_behavior() -> None:
    compiled = xabsl.compile(ROOT / "behavior/GT2003.xabsl")
    assert compiled.checked().options and compiled.behavior is not None
    assert not [d for d in compiled.diagnostics if d.severity == "error"]
    assert "ball.seen" in " ".join(compiled.behavior.inputs) or compiled.behavior.inputs


def test_xabsl_tells_what_is_wrong_and_where() -> None:
    files = {"agents.xabsl": AGENTS.replace("bool input ball.seen;", "bool input ball.lost;")
             + 'agent player("player", root);\n', "options.xabsl": OPTIONS}
    compiled = xabsl.compile("agents.xabsl", files)
    assert compiled.behavior is None
    first = next(d for d in compiled.diagnostics if d.severity == "error")
    assert first.file.endswith("options.xabsl") and first.line == 4 and "ball.seen" in first.source
    assert str(first).startswith(f"{first.file}:4:{first.column}: ")
    with pytest.raises(gt2003.Error) as caught:
        compiled.checked()
    assert caught.value.line == 4
    nothing = xabsl.compile("/nowhere.xabsl")
    assert nothing.behavior is None and nothing.diagnostics


def test_xabsl_runs_on_symbols_of_python() -> None:
    behavior = small()
    assert behavior.agents == ["player"] and behavior.basic_behaviors == ["walk", "stand"]
    assert behavior.enumerations["mode"] == ["slow", "fast"]
    told: list[object] = []
    engine = xabsl.Engine(
        behavior,
        {
            "twice": lambda **given: 2 * next(iter(given.values())),
            "walk": lambda **given: told.append(given),
            "speed": told.append,
            "wanted_mode": lambda: "fast",
        },
    )
    engine.execute(0)
    assert told == [0.0] and engine.get("drive_mode") == "slow"
    assert [(a.kind, a.name, a.state) for a in engine.activations] == [
        ("option", "root", "search"),
        ("behavior", "stand", ""),
    ]
    engine.set("ball.seen", True)
    engine.set("ball.distance", 60)
    told.clear()
    engine.execute(8)
    assert engine.activations[0].state == "run" and engine.get("drive_mode") == "fast"
    assert 7.5 in told and any(isinstance(t, dict) and 30.0 in t.values() for t in told)
    engine.select_behavior("stand")
    engine.execute(16)
    assert [a.name for a in engine.activations] == ["stand"]
    assert engine.agent == "player"


def test_xabsl_raises_what_a_function_raises() -> None:
    def fail() -> float:
        raise KeyError("why")

    engine = xabsl.Engine(small(), {"ball.seen": fail})
    with pytest.raises(KeyError, match="why"):
        engine.execute(0)
    engine.set("ball.distance", 5)
    with pytest.raises(KeyError, match="why"):
        engine.get("ball.seen")
    for result, message in ((3, "expected a bool"), (None, "expected a bool")):
        with pytest.raises(gt2003.Error, match=f"ball.seen: {message}"):
            xabsl.Engine(small(), {"ball.seen": lambda result=result: result}).execute(0)


def test_xabsl_refuses_what_does_not_fit() -> None:
    engine = xabsl.Engine(small())
    for name, value, message in (
        ("ball.size", 1, "no such input symbol"),
        ("ball.distance", "far", "expected a finite number"),
        ("ball.distance", float("nan"), "expected a finite number"),
        ("ball.seen", 1, "expected a bool"),
        ("wanted_mode", "turbo", "mode has no element turbo"),
    ):
        with pytest.raises(gt2003.Error, match=message):
            engine.set(name, value)
    with pytest.raises(gt2003.Error, match="no such agent"):
        engine.select_agent("nobody")
    with pytest.raises(gt2003.Error, match="no such symbol and no such basic behavior"):
        xabsl.Engine(small(), {"fly": print})
    with pytest.raises(gt2003.Error, match="something to call"):
        xabsl.Engine(small(), {"walk": 3})  # type: ignore[dict-item]

    def reenter() -> bool:
        engines[0].execute(1)
        return True

    engines = [xabsl.Engine(small(), {"ball.seen": reenter})]
    with pytest.raises(gt2003.Error, match="runs already"):
        engines[0].execute(0)


def test_xabsl_engines_that_know_their_owner_are_freed() -> None:
    class Player:
        def __init__(self) -> None:
            self.engine = xabsl.Engine(small(), {"stand": self.stand})

        def stand(self) -> None:
            pass

    player = weakref.ref(Player())
    gc.collect()
    assert player() is None


def test_motions_are_those_of_the_robots() -> None:
    net = motions.compile().checked()
    all_names = motions.names(net)
    assert "pushStrong" in all_names and "getupFromSide" in all_names
    told = subprocess.run([BUILD / "bin/motionnet", "list"], cwd=ROOT, capture_output=True, text=True)
    assert told.returncode == 0 and motions.listing(net) == told.stdout
    match = gt2003.Match()
    robots_net = match.robots["red1"].get("MotionNet")
    assert robots_net.nodes == net.nodes and robots_net.entry == net.entry
    assert [motion.name for motion in robots_net.motions] == [motion.name for motion in net.motions]
    assert any(len(motion.kick.places) for motion in robots_net.motions)  # of the table of kicks


def test_motions_play_as_on_a_robot() -> None:
    net = motions.compile(ROOT / "motions").checked()
    played = motions.play(net, "pushStrong")
    assert played.complete and played.joints.shape[1] == len(JointData().angles)
    assert 30 < len(played.joints) < 1000
    assert np.ptp(played.joints, axis=0).max() > 0.3
    assert not motions.play(net, "pushStrong", seconds=0.1).complete
    for name in motions.names(net):
        assert len(motions.play(net, name, seconds=0.5).joints) > 0
    for motion, seconds, message in (("fly", 1, "no motion fly"), ("sit", -1, "seconds")):
        with pytest.raises(gt2003.Error, match=message):
            motions.play(net, motion, seconds=seconds)


def test_motions_tell_what_is_wrong() -> None:
    compiled = motions.compile(files={"a.mof": "motion_id = a\nlabel start\n1 2 3\n"})
    assert compiled.net is None
    assert compiled.diagnostics[0].file == "a.mof" and compiled.diagnostics[0].line == 3
    with pytest.raises(gt2003.Error, match="a.mof:3"):
        compiled.checked()
    assert motions.compile("/nowhere").net is None


def test_color_tables_there_and_back(tmp_path: Path) -> None:
    table = colors.read(ROOT / "config/coltable.c64")
    assert table.shape == (64, 64, 64) and table.dtype == np.uint8
    colors.write(tmp_path / "a.c64", table)
    assert (tmp_path / "a.c64").read_bytes() == (ROOT / "config/coltable.c64").read_bytes()
    np.testing.assert_array_equal(colors.read(tmp_path / "a.c64"), table)
    match = gt2003.Match()
    np.testing.assert_array_equal(match.robots["red1"].get("ColorTable64.classes"), table.ravel())


def test_files_are_written_whole_or_not_at_all(tmp_path: Path) -> None:
    table = colors.read(ROOT / "config/coltable.c64")
    file = tmp_path / "a.c64"
    file.write_text("what was there")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))
    try:
        with pytest.raises(gt2003.Error, match="a.c64: cannot be written: File too large"):
            colors.write(file, table)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert file.read_text() == "what was there" and list(tmp_path.iterdir()) == [file]


def test_the_order_of_a_color_table_is_doubted_without_colors_of_a_field(tmp_path: Path) -> None:
    nao = tmp_path / "nao.c64"
    nao.write_bytes(b"\1\0\0\0\4" + (64**3 - 1).to_bytes(4, "little") + bytes(5))
    with pytest.warns(UserWarning, match="nao.c64: has no green, white and gray, .* a robot of 2009: order=.nao2009."):
        assert colors.read(nao)[0, 0, 0] == ColorClass.pink
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert colors.read(nao, "nao2009")[0, 0, 0] == ColorClass.white


def test_colors_are_learnt_from_labels(tmp_path: Path) -> None:
    match = gt2003.Match(labels=True, profile="perfect")
    statistics = colors.ColorStatistics()
    match.until(lambda: match.robots["red1"].labels is not None, 1)
    for _ in range(40):
        match.run(0.08)
        for robot in match.robots.values():
            statistics.add(robot.image.copy(), robot.labels[0])
    table = statistics.table(growth=2)
    right = total = 0
    for robot in match.robots.values():
        labels = robot.labels[0]
        known = labels != ColorClass.noColor
        right += (colors.classify(table, robot.image) == labels)[known].sum()
        total += known.sum()
    assert right > 0.8 * total > 0
    for kind, text in (("hsi", statistics.hsi(0.9)), ("tsl", statistics.tsl(0.9))):
        (tmp_path / f"a.{kind}").write_text(text)
        learnt = colors.read(tmp_path / f"a.{kind}")
        assert (learnt == ColorClass.green).any()


def test_color_tables_are_edited() -> None:
    editor = colors.ColorTableEditor()
    editor.set(100, 100, 200, ColorClass.orange)
    assert editor.table[25, 25, 50] == ColorClass.orange
    assert (editor.table != 0).sum() == 1
    editor.remove_isolated()
    assert (editor.table == 0).all()
    assert editor.undo() and editor.table[25, 25, 50] == ColorClass.orange
    editor.median(neighbors=1, color_class=ColorClass.orange)
    assert (editor.table == ColorClass.orange).sum() == 7
    editor.clear(ColorClass.orange)
    assert (editor.table == 0).all()
    assert editor.undo() and editor.undo() and editor.undo() and not editor.undo()
    table = colors.read(ROOT / "config/coltable.c64")
    np.testing.assert_array_equal(colors.ColorTableEditor(table).table, table)


def test_wrong_colors_are_told(tmp_path: Path) -> None:
    broken = tmp_path / "a.c64"
    broken.write_bytes(b"\1\0")
    with pytest.raises(gt2003.Error, match="a.c64"):
        colors.read(broken)
    with pytest.raises(gt2003.Error, match="ends with"):
        colors.read("a.png")
    with pytest.raises(gt2003.Error, match="order: must be"):
        colors.read(broken, "nao2010")  # type: ignore[arg-type]
    table = np.zeros((64, 64, 64), np.uint8)
    with pytest.raises(gt2003.Error, match="/nowhere/a.c64: cannot be written: No such file"):
        colors.write("/nowhere/a.c64", table)
    with pytest.raises(gt2003.Error, match="none of this number: 11"):
        colors.write(broken, table + np.uint8(11))
    with pytest.raises(gt2003.Error, match="shape"):
        colors.classify(table, np.zeros((2, 2), np.uint8))
    statistics = colors.ColorStatistics()
    with pytest.raises(gt2003.Error, match="height and width"):
        statistics.add(np.zeros((4, 4, 3), np.uint8), np.zeros((4, 3), np.uint8))
    with pytest.raises(gt2003.Error, match="share"):
        statistics.hsi(0)
