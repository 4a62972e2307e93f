"""The page of figures over commits, of commits that need no compiler."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python/benchmarks"))

import history  # noqa: E402
import kept  # noqa: E402
from against import Failure  # noqa: E402

WALKER = """#!/usr/bin/env python3
import json, sys
options = dict(zip(sys.argv[1::2], sys.argv[2::2]))
open("calls", "a").write(options["--only"] + chr(10))
if options["--only"] not in {known!r}:
    sys.exit("walker: there is no experiment " + options["--only"])
first, last = map(int, options["--seeds"].split(".."))
lines = [json.dumps({{"job": f"walk seed={{seed}} commit=abc", "values": [{{"name": options["--only"] + ".speed", "unit": "mm/s", "value": {speed} + seed}}]}})
         for seed in range(first, last + 1)]
open(options["--json"].replace(".json", ".jsonl"), "w").write(chr(10).join(lines))
"""
LIST = """
[[measurement]]
command = "walker --only walk"
seeds = "1..3"
core = true
figure = [{name = "walk.speed", worse = "less"}]

[[measurement]]
command = "walker --only trot"
seeds = "1..3"
figure = [{name = "trot.speed", worse = "less"}]
"""


class Trees:
    """A repository with two commits, and a tree of each with a program."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "measured.toml").write_text(LIST)
        self.git("init", "--quiet")
        self.names = []
        for subject, known, speed in (("Walk <slowly>", ["walk"], 100), ("Trot", ["walk", "trot"], 200)):
            self.git("-c", "user.name=a", "-c", "user.email=a@a", "commit", "--quiet", "--allow-empty", "--message", subject)
            self.names.append(self.git("rev-parse", "--short=12", "HEAD"))
            program = self.tree(self.names[-1]) / "build/release/bin/walker"
            program.parent.mkdir(parents=True)
            program.write_text(WALKER.format(known=known, speed=speed))
            program.chmod(0o755)

    def git(self, *arguments: str) -> str:
        return subprocess.run(["git", *arguments], cwd=self.folder, check=True, capture_output=True, text=True).stdout.strip()

    def tree(self, name: str) -> Path:
        return self.folder / "build/against" / name

    def tree_of(self, commit: str, root: Path, targets: Sequence[str]) -> Path:
        assert root == self.folder and "experiment" in targets
        if commit == "nowhere":
            raise Failure("nowhere: there is no such commit")
        return self.tree(self.git("rev-parse", "--short=12", commit))

    def show(self, *arguments: str) -> int:
        return history.main([*arguments, "--list", str(self.folder / "measured.toml"), "--out", str(self.folder / "out")], self.folder)

    def page(self) -> str:
        return (self.folder / "out/index.html").read_text()

    def calls(self, name: str) -> list[str]:
        return (self.tree(name) / "calls").read_text().split()


@pytest.fixture
def trees(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Trees:
    made = Trees(tmp_path)
    monkeypatch.setattr(history, "tree_of", made.tree_of)
    return made


def test_each_figure_is_drawn_at_each_commit(trees: Trees, capsys: pytest.CaptureFixture[str]) -> None:
    old, new = trees.names
    assert trees.show("HEAD~1", "HEAD") == 0
    page = trees.page()
    assert page.count("<circle") == 3 and ">102</text>" in page and ">202</text>" in page
    assert "Walk &lt;slowly&gt;" in page and f"mm/s; less is worse; not measured at {old[:7]}" in page
    assert page.index("walk.speed") < page.index("trot.speed")
    assert f"is not measured at {old}: walker: there is no experiment trot" in capsys.readouterr().err
    figure = kept.read(trees.folder / f"out/{new}.json")["trot.speed"]
    assert (figure.value, figure.commit, figure.seeds) == (202, new, (1, 2, 3))


def test_what_was_measured_is_not_measured_again(trees: Trees) -> None:
    _, new = trees.names
    assert trees.show("HEAD", "--only", "walk") == 0
    assert "trot.speed" not in trees.page()
    assert trees.show("HEAD") == 0 and trees.show("HEAD", "--core") == 0
    assert trees.calls(new) == ["walk", "trot"]
    assert "trot.speed" not in trees.page()


def test_what_is_wrong_is_told_in_one_line(trees: Trees, capsys: pytest.CaptureFixture[str]) -> None:
    assert trees.show("nowhere") == 2 and capsys.readouterr().err == "history: nowhere: there is no such commit\n"
    assert trees.show("HEAD", "--only", "run") == 2 and capsys.readouterr().err == "history: ONLY=run: no figures begin with this\n"
    (trees.folder / "out").mkdir()
    (trees.folder / f"out/{trees.names[1]}.json").write_text("[")
    assert trees.show("HEAD") == 2 and capsys.readouterr().err.count("\n") == 1
