"""Calls everything that the extension exports with random arguments; no call may end the interpreter.

fuzz_bindings.py [--seed SEED] [--calls CALLS] [--seconds SECONDS]

The calls are typed: what the stub of the extension says of an argument is given mostly, anything else now and then.
Before each call its number and name are written to the file `last-call` in a new folder, which is named at the
start: so a crash is repeated with the same seed. Exceptions are fine, but for SystemError.
"""

from __future__ import annotations

import argparse
import ast
import collections
import faulthandler
import math
import os
import random
import tempfile
import time
import warnings
from pathlib import Path
from typing import Any

import numpy as np

import gt2003
from gt2003 import _core, modules, representations
from gt2003.representations import BallModel, BallPercept, FrameInfo, Record

AGENTS = """
include "options.xabsl";
namespace symbols("symbols") {
  enum mode { slow, fast };
  bool input seen;
  float input twice(float of;);
  enum mode output drive_mode;
}
namespace behaviors("behaviors") { behavior walk { float x; } }
agent player("player", root);
"""
OPTIONS = """
option root {
  initial state first {
    decision { if (seen && twice(of = 1) > 0) goto second; else stay; }
    action { walk(x = 1 / twice(of = 2)); drive_mode = slow; }
  }
  state second { decision { if (true) goto first; else stay; } action { drive_mode = fast; } }
}
"""
# Only what is called by its own maker below.
MADE_APART = {"Match.__init__", "Match.run", "Match.until", "Match.load"}


class Chance(random.Random):
    """Random values of any kind."""

    def number(self) -> float:
        usual = [0.0, -0.0, 1.0, -1.0, 0.5, 1e-300, 1e9, 1e308, -1e308, self.uniform(-10, 10)]
        return self.choice([*usual, self.gauss(0, 1000)])

    def whole(self) -> int:
        return self.choice([0, 1, 2, -1, 7, 255, 256, 2**31, -(2**31), 2**63, self.randrange(1000)])

    def text(self) -> str:
        known = ["", "\0", "a" * 3000, "ß\ud800", "red1", "ball", "match", "BallLocator", "disabled"]
        known += ["PIDSmoothed", "RobotPose", "RobotPose.pose.translation.x", "seen", "twice", "walk"]
        known += ["drive_mode", "slow", "root", "player", "JointData.angles.3", "state", "log.mcap"]
        known += ["/RobotPose", "camera", "a.c64", "gt2003", "BallLocator.proportional", "GT2003"]
        return self.choice([*known, *representations.__all__])

    def array(self) -> np.ndarray:
        shape = self.choice([(0,), (3,), (4, 3), (2, 3, 3), (4, 4), (64, 64, 64), (1, 0, 3)])
        dtype = self.choice(["u1", "i4", "f8", "f4", "?", "O", "U3"])
        made = np.zeros(shape, dtype)
        if dtype in ("u1", "i4", "f8", "f4"):
            made += np.asarray(self.randrange(12)).astype(dtype)
        return made[::-1] if self.random() < 0.2 else made

    def junk(self) -> Any:
        return self.choice(
            [
                *(None, True, self.whole(), self.number(), math.nan, math.inf, self.text(), b"x", []),
                *([[]], [1, 2], ["a", None], {}, {"x": 1}, {1: 2}, object(), self.array(), print),
                *((1, 2), representations.ColorClass.orange, representations.Pose2D, 2**200),
                representations.BallPercept(),
            ]
        )

    def record(self, name: str, depth: int = 0) -> Any:
        """A representation whose fields are random, and mostly of the right types."""
        made = getattr(representations, name)()
        for field in getattr(made, "fields", ()):
            if self.random() < 0.4:
                setattr(made, field.name, self.like(getattr(made, field.name), depth))
        return made

    def like(self, value: Any, depth: int) -> Any:
        if self.random() < 0.03:
            return self.junk()
        if isinstance(value, Record):
            return self.record(type(value).__name__, depth + 1) if depth < 4 else value
        if isinstance(value, bool):
            return self.random() < 0.5
        if hasattr(value, "_member_map_"):
            return self.choice(list(type(value)))
        if isinstance(value, int):
            return self.whole()
        if isinstance(value, float):
            return self.number()
        if isinstance(value, str):
            return self.text()
        if isinstance(value, list):
            return [self.like(element, depth + 1) for element in value]
        if isinstance(value, np.ndarray) and value.size < 10000:
            if value.dtype.kind == "f":
                return np.array([self.number() for _ in range(value.size)]).reshape(value.shape)
            return self.choice([value, value[:0], np.concatenate([value, value])])
        return value


class LastSeen:
    """A solution that works."""

    def update(self, frame_info: FrameInfo) -> BallModel:
        return BallModel()


class Wrong:
    """A solution that returns something else."""

    def update(self, frame_info: FrameInfo) -> BallModel:
        return Fuzzer.current.chance.junk()


class Meddles:
    """A solution that keeps its inputs and parts of them, and changes them."""

    def __init__(self) -> None:
        self.kept: list[Any] = []

    def update(self, ball_percept: BallPercept, frame_info: FrameInfo) -> BallModel:
        chance = Fuzzer.current.chance
        for _ in range(3):
            try:
                self.meddle(chance, ball_percept, chance.choice(ball_percept.fields).name)
            except Exception:
                pass
        del self.kept[:-20]
        return BallModel()

    def meddle(self, chance: Chance, percept: BallPercept, name: str) -> None:
        value = getattr(percept, name)
        match chance.randrange(8):
            case 0:
                self.kept += [percept]
            case 1:
                self.kept += [value, value[1:]]
            case 2:
                setattr(percept, name, chance.choice([chance.junk(), self, percept, *self.kept]))
            case 3:
                delattr(percept, name)
            case 4:
                value.shape = chance.choice([(2, 1), (1, 2), (2,)])
            case 5:
                value.dtype = chance.choice(["i8", "u1", "f8"])
            case 6:
                value.data = np.zeros(chance.choice([2, 3]))
            case 7:
                value.flags.writeable = False


class Fuzzer:
    """Objects of all classes, and what can be called of them."""

    current: Fuzzer

    def __init__(self, seed: int) -> None:
        Fuzzer.current = self
        self.chance = Chance(seed)
        self.called: collections.Counter[str] = collections.Counter()
        self.raised = 0
        self.objects: dict[str, list[Any]] = collections.defaultdict(list)
        self.calls = self._read_stub()
        self._prepare()

    def _read_stub(self) -> list[tuple[str, str, ast.FunctionDef | None]]:
        """All functions, methods and properties: class, name, and what the stub says of it."""
        stub = ast.parse(Path(_core.__file__).with_name("_core.pyi").read_text())
        found: dict[tuple[str, str], ast.FunctionDef | None] = {}
        for node in stub.body:
            if isinstance(node, ast.FunctionDef):
                found["", node.name] = node
            elif isinstance(node, ast.ClassDef):
                for part in node.body:
                    if isinstance(part, ast.FunctionDef):
                        found[node.name, part.name] = part
        # What makes classes at the import must not be called again.
        return [(c, n, f) for (c, n), f in found.items() if n != "_adopt"]

    def _prepare(self) -> None:
        match = gt2003.Match(minutes=0.02, logs=".", labels=True)
        match.run(0.1)
        match.save("a.state")
        match.close()
        os.replace("red1.mcap", "log.mcap")
        files = {"a.xabsl": AGENTS, "options.xabsl": OPTIONS}
        behavior, wrong = _core._compile_xabsl("a.xabsl", files)
        assert behavior is not None, wrong
        for made in (match, match.robots["red1"], behavior, _core.LogFile("log.mcap", False)):
            self.keep(made)
        for made in (_core.Engine(behavior), _core.ColorStatistics(), _core.ColorTableEditor(), _core._OutputLock("locked")):
            self.keep(made)
        self.keep(modules.BallLocator())

    def keep(self, made: Any) -> None:
        """Have an object used from now on, in place of an older one."""
        if type(made).__module__.startswith("gt2003"):
            name = next(c.__name__ for c in type(made).__mro__ if c.__module__ == "gt2003._core")
            known = self.objects[name]
            known.append(made)
            del known[: max(0, len(known) - 3)]

    def argument(self, name: str, annotation: str) -> Any:
        chance = self.chance
        if chance.random() < 0.15:
            return chance.junk()
        if name in ("seconds", "minutes"):
            return chance.choice([0, 0.01, 0.05, -1, math.nan, 1e300])
        if name in ("file", "path") and chance.random() < 0.5:
            return chance.choice(["a.state", "log.mcap", "a.c64", "a.xabsl", "RobotPose.pose", "/", ""])
        if name == "threads":
            return chance.choice([1, 2, 0, -1, 2**40])
        if name in ("functions", "solutions"):
            return chance.choice([{}, {"walk": print}, {"seen": chance.junk}, {"twice": 3}])
        if name == "solution" and chance.random() < 0.5:
            return chance.choice([LastSeen, Wrong, Meddles, object, chance.junk])
        if name == "files":
            cut = AGENTS[: chance.randrange(len(AGENTS))], OPTIONS[: chance.randrange(len(OPTIONS))]
            return chance.choice([None, {"a.xabsl": cut[0], "options.xabsl": OPTIONS},
                                  {"a.xabsl": AGENTS, "options.xabsl": cut[1]}])
        for kind, made in (
            ("Behavior", lambda: chance.choice(self.objects["Behavior"])),
            ("NDArray", chance.array),
            ("ndarray", chance.array),
            ("str", lambda: [chance.text()] if "Sequence" in annotation else chance.text()),
            ("float", chance.number),
            ("bool", lambda: chance.random() < 0.5),
            ("int", chance.whole),
            ("Callable", lambda: chance.junk),
        ):
            if kind in annotation:
                return made()
        return chance.junk()

    def call(self) -> None:
        """One call."""
        chance = self.chance
        if chance.random() < 0.3:
            return self.update_module()
        owner, name, function = chance.choice(self.calls)
        whole = f"{owner}.{name}" if owner else name
        if whole in MADE_APART:
            return self.match_call(whole)
        given: dict[str, Any] = {}
        positional: list[Any] = []
        arguments = function.args if function else None
        for argument in arguments.args + arguments.kwonlyargs if arguments else []:
            if argument.arg == "self":
                continue
            annotation = ast.unparse(argument.annotation) if argument.annotation else ""
            value = self.argument(argument.arg, annotation)
            if argument in arguments.kwonlyargs:  # type: ignore[union-attr]
                given[argument.arg] = value
            else:
                positional.append(value)
        if chance.random() < 0.03:
            positional.append(chance.junk())
        self.note(whole)
        if not owner:
            self.keep(getattr(_core, name)(*positional, **given))
        elif name == "__init__":
            self.keep(getattr(_core, owner)(*positional, **given))
        elif function and any("property" in ast.unparse(d) for d in function.decorator_list):
            self.keep(getattr(chance.choice(self.objects[owner]), name))
        else:
            self.keep(getattr(chance.choice(self.objects[owner]), name)(*positional, **given))

    def match_call(self, whole: str) -> None:
        """What would run for long with an argument that is right."""
        chance = self.chance
        match = chance.choice(self.objects["Match"])
        self.note(whole)
        if whole == "Match.__init__":
            given = {
                name: self.argument(name, kind)
                for name, kind in (
                    *(("seed", "int"), ("threads", "int"), ("profile", "str"), ("labels", "bool")),
                    *(("root", "str"), ("solutions", ""), ("scene", "str")),
                )
                if chance.random() < 0.3
            }
            self.keep(gt2003.Match(minutes=chance.choice([0.01, 0.02]), **given))
            self.objects["Robot"] = list(self.objects["Match"][-1].robots.values())
        elif whole == "Match.load":
            self.keep(gt2003.Match.load(self.argument("file", "str")))
        elif whole == "Match.run":
            match.run(self.argument("seconds", "float"))
        else:
            match.until(chance.choice([lambda: True, lambda: False, chance.junk]), 0.02)

    def update_module(self) -> None:
        """Runs a module on random inputs."""
        chance = self.chance
        known = _core._solutions()
        task = chance.choice([task for task in known if known[task]])
        solution = chance.choice(list(known[task]))
        self.note(f"{task}.{solution}")
        module = modules.Module(task, solution, seed=chance.randrange(10))
        names = [name for name in known[task][solution][0] if name != "ColorTable64"]
        for _ in range(3):
            chosen = chance.sample(names, chance.randint(0, min(4, len(names))))
            inputs = {_core._input_name(name): chance.record(name) for name in chosen}
            if "Image" in names:
                inputs["image"] = self.image()
            try:
                module.update(**inputs)
            except gt2003.Error:
                self.raised += 1

    def image(self) -> Any:
        made = Fuzzer.current.chance.choice(self.objects["Robot"]).get("Image")
        if len(made.pixels) == 0:
            made.info.width, made.info.height = 8, 6
            made.pixels = np.zeros((48, 4), np.uint8)
        if self.chance.random() < 0.3:
            made.pixels = np.roll(made.pixels, self.chance.randrange(len(made.pixels)), axis=0)
        if self.chance.random() < 0.2:
            made.info.openingAngle = self.chance.like(made.info.openingAngle, 0)
        return made

    def note(self, what: str) -> None:
        self.called[what] += 1
        Path("last-call").write_text(f"{self.called.total()} {what}\n")

    def run(self, calls: int, seconds: float) -> None:
        end = time.monotonic() + seconds
        while self.called.total() < calls and time.monotonic() < end:
            try:
                self.call()
            except SystemError:
                raise
            except Exception:
                self.raised += 1


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--calls", type=int, default=10**9)
    parser.add_argument("--seconds", type=float, default=60)
    given = parser.parse_args()
    faulthandler.enable()
    warnings.simplefilter("ignore")
    folder = tempfile.mkdtemp(prefix="fuzz-bindings-")
    print(f"calls are noted in {folder}/last-call", flush=True)
    os.chdir(folder)
    fuzzer = Fuzzer(given.seed)
    fuzzer.run(given.calls, given.seconds)
    print(f"{fuzzer.called.total()} calls of {len(fuzzer.called)} names, {fuzzer.raised} exceptions")
    names = {f"{owner}.{name}" if owner else name for owner, name, _ in fuzzer.calls}
    print("not called:", " ".join(sorted(names - set(fuzzer.called))) or "none")


if __name__ == "__main__":
    main()
