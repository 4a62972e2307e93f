"""The figures that are kept: verdicts by statistics, the file, and what `make figures` does with commands that only write figures."""

from __future__ import annotations

import json
import math
import random
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gt2003 import Error
from gt2003._intervals import outside

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python/benchmarks"))

import cost  # noqa: E402
import kept  # noqa: E402
import measure  # noqa: E402
import spoiled  # noqa: E402
from against import Cost  # noqa: E402
from verdicts import Chances, Sample, chances, verdicts  # noqa: E402

SEEDS = tuple(range(1, 11))
Draw = Callable[[random.Random], float]


def sample(draw: Draw, chance: random.Random, n: int, first: int = 1) -> Sample:
    return Sample(tuple(draw(chance) for _ in range(n)), tuple(range(first, first + n)))


def normal(chance: random.Random) -> float:
    return chance.gauss(50, 5)


def skewed(chance: random.Random) -> float:
    return chance.lognormvariate(3, 0.7)


def counted(chance: random.Random) -> float:
    return sum(chance.random() < 0.1 for _ in range(10)) * 10.0


def pair(draw: Draw, chance: random.Random, kind: int) -> tuple[Sample, Sample]:
    """The same figure twice, on the same seeds or on others."""
    n = (4, 6, 10)[kind % 3]
    before = sample(draw, chance, n)
    if kind % 2:
        return before, sample(draw, chance, n)
    return before, sample(draw, chance, (6, 10)[kind % 4 // 2], 101)


def set_of(chance: random.Random, spoil: int = -1) -> list[str]:
    """Verdicts on forty figures that are what they were, but for one."""
    tests = []
    for i in range(40):
        draw = (normal, skewed, counted, normal)[i % 4]
        before, now = pair(draw, chance, i)
        if i == spoil:
            now = Sample(tuple(run + 40 for run in now.runs), now.seeds)
        tests.append(chances(before, now, "greater" if i % 5 else "different", 10 if draw is counted else 0))
    return verdicts(tests)


def test_false_alarms_are_at_most_one_in_twenty_sets() -> None:
    chance = random.Random(7)
    alarms = sum("worse" in set_of(chance) for _ in range(1000))
    assert 0 < alarms <= 50


def test_a_figure_that_is_spoiled_is_found_and_no_other() -> None:
    chance = random.Random(8)
    found = [set_of(chance, spoil=8) for _ in range(50)]
    assert sum(said[8] == "worse" for said in found) >= 48
    assert sum(said.count("worse") for said in found) <= 55


def test_the_same_seeds_show_what_others_do_not() -> None:
    chance = random.Random(9)
    before = sample(lambda c: c.gauss(100, 20), chance, 10)
    worse = tuple(run + chance.gauss(3, 0.5) for run in before.runs)
    assert verdicts([chances(before, Sample(worse, before.seeds), "greater")]) == ["worse"]
    assert verdicts([chances(before, Sample(worse[::-1], before.seeds[::-1]), "greater")]) == ["worse"]
    assert verdicts([chances(before, Sample(worse, tuple(range(21, 31))), "greater")]) == ["same"]
    assert verdicts([chances(before, Sample(worse), "greater")]) == ["same"]


@pytest.mark.parametrize(
    ("kind", "said"), [("greater", ["worse", "better"]), ("less", ["better", "worse"]), ("different", ["worse", "worse"])]
)
def test_what_counts_as_worse(kind: str, said: list[str]) -> None:
    before = Sample((10, 11, 12, 10.5), (1, 2, 3, 4))
    more = Sample((20, 22, 22, 21), (1, 2, 3, 4))
    assert verdicts([chances(before, more, kind), chances(more, before, kind)]) == said
    assert verdicts([chances(before, before, kind)]) == ["same"]


def test_differences_up_to_the_tolerance_do_not_matter() -> None:
    before, now = Sample((0,) * 4, (1, 2, 3, 4)), Sample((0.4,) * 4, (1, 2, 3, 4))
    for tolerance, said in ((0, "worse"), (0.3, "worse"), (0.4, "same"), (0.5, "same")):
        assert verdicts([chances(before, now, "greater", tolerance)]) == [said]
    assert verdicts([chances(Sample((1000,)), Sample((1099,)), "greater", 100)]) == ["same"]
    assert verdicts([chances(Sample((1000,)), Sample((1101,)), "greater", 100)]) == ["worse"]


def test_chances_are_those_of_the_tables() -> None:
    # Student's test: mean 1, standard error 1/3, nine degrees of freedom: t = 3.
    runs = (0, 2) * 5
    paired = chances(Sample((0,) * 10, SEEDS), Sample(runs, SEEDS), "greater")
    assert paired.worse == pytest.approx(0.00748, abs=2e-5) and paired.worse + paired.better == pytest.approx(1)
    # Welch's of as many runs and equal variances is Student's with 18 degrees; of one variance alone with 9. Quantiles of 97.5 %.
    for before, error, quantile in ((runs, math.sqrt(2) / 3, 2.10092), ((7,) * 5, 1 / 3, 2.26216)):
        shift = sum(before) / len(before) - 1 + quantile * error
        now = tuple(run + shift for run in runs)
        assert chances(Sample(before), Sample(now), "different").worse == pytest.approx(0.05, abs=1e-5)


@pytest.mark.parametrize(("t", "degrees"), [(0.3, 1), (2, 2.5), (1, 3), (7, 4.3), (2.5, 77.7), (30, 3.3)])
def test_chances_are_integrals_of_the_density(t: float, degrees: float) -> None:
    scale = math.exp(math.lgamma((degrees + 1) / 2) - math.lgamma(degrees / 2)) / math.sqrt(degrees * math.pi)
    steps = 20_000
    angles = [math.atan(t / math.sqrt(degrees)) * (i + 0.5) / steps for i in range(steps)]
    inside = sum(math.cos(angle) ** (degrees - 1) for angle in angles) * 2 * scale * math.sqrt(degrees) * angles[-1] / (steps - 0.5)
    assert outside(t, degrees) == pytest.approx(1 - inside, rel=1e-3, abs=1e-9)


def test_holm_goes_on_where_bonferroni_ends() -> None:
    tests = [Chances(p, 1.0) for p in (0.03, 0.012, 0.2, 0.014, 0.9)]
    assert verdicts([*tests[:2], tests[3]]) == ["worse", "worse", "worse"]
    assert verdicts(tests) == ["same"] * 5
    assert verdicts([Chances(0.009, 1.0), Chances(0.0125, 1.0), *[Chances(0.5, 1.0)] * 3]) == ["worse", "worse", "same", "same", "same"]


def entry(name: str = "walk.speed", runs: tuple[float, ...] = (100, 104, 99, 101), first: int = 1) -> kept.Kept:
    return kept.keep(name, "mm/s", "less", "experiment --only walk", 1.25, "0123456789ab", Sample(runs, tuple(range(first, first + len(runs)))))


def test_the_file_is_ordered_and_can_be_read_again(tmp_path: Path) -> None:
    file = tmp_path / "figures.json"
    one, other = entry("b", (1 / 3, 2 / 3, 1e9)), entry("a", (5,))
    kept.write(file, [one, other])
    assert kept.read(file) == {"a": other, "b": one}
    assert [figure["name"] for figure in json.loads(file.read_text())] == ["a", "b"]
    assert len(file.read_text().splitlines()) == 2 + 2 * 3
    assert '"runs": [0.333333, 0.666667, 1000000000]}' in file.read_text()
    assert one.interval[0] < one.value < one.interval[1] and other.interval == ()
    assert kept.read(tmp_path / "none.json") == {}


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("worse", "more", "walk.speed.worse: expected one of: different, greater, less"),
        ("value", 7, "walk.speed.value: is not that of the runs: 101"),
        ("value", "7", "walk.speed.value: expected float"),
        ("value", math.nan, ""),
        ("interval", [1, 2], "walk.speed.interval: is not that of the runs: 97.5"),
        ("interval", [], "walk.speed.interval: is not"),
        ("n", 3, "walk.speed.n: there are 4 runs"),
        ("runs", [1, True], "walk.speed.runs 2: expected float"),
        ("seeds", [1, 2, 3], "walk.speed.seeds: expected one for each run"),
        ("seeds", [1, 2, 3, 3], "walk.speed.seeds: expected one for each run"),
        ("seconds", -1, "walk.speed.seconds: expected 0 or more"),
        ("commit", "main", "walk.speed.commit: expected a commit"),
        ("sedes", [], "walk.speed.sedes: is unknown"),
        ("unit", None, "walk.speed.unit: is missing"),
    ],
)
def test_a_mistake_in_the_file_is_told_in_one_line(field: str, value: object, said: str, tmp_path: Path) -> None:
    file = tmp_path / "figures.json"
    figure = json.loads(kept.text([entry()]))[0] | {field: value}
    file.write_text(json.dumps([{name: v for name, v in figure.items() if v is not None}]))
    with pytest.raises(Error) as raised:
        kept.read(file)
    assert str(raised.value).startswith(f"{file}: {said}" if said else str(file))
    assert "\n" not in str(raised.value)


def test_what_is_no_file_of_figures_is_told(tmp_path: Path) -> None:
    file = tmp_path / "figures.json"
    for wrong in ("", "{}", "[1]", "[{}]", "[[]]", "[" * 100_000, kept.text([entry()])[:-3]):
        file.write_text(wrong)
        with pytest.raises(Error):
            kept.read(file)
    file.write_text("[" + json.dumps(json.loads(kept.text([entry()]))[0]) + "," + kept.text([entry()])[1:])
    with pytest.raises(Error, match="walk.speed: is there twice"):
        kept.read(file)


def test_broken_bytes_are_errors_or_figures(tmp_path: Path) -> None:
    file, chance = tmp_path / "figures.json", random.Random(3)
    sound = kept.text([entry(), entry("other")]).encode()
    refused = 0
    for _ in range(600):
        broken = bytearray(sound)
        for _ in range(chance.randint(1, 3)):
            at = chance.randrange(len(broken))
            broken[at : at + chance.randint(0, 4)] = chance.choice([b"", b"9", b'"', b"]", b"-1e9", b"\xff", b"null"])
        file.write_bytes(broken)
        try:
            kept.read(file)
        except Error:
            refused += 1
    assert refused > 400


FAKE = """#!/usr/bin/env python3
import json, os, sys
options = dict(zip(sys.argv[1::2], sys.argv[2::2]))
open({calls!r}, "a").write(" ".join(sys.argv[1:-2]) + chr(10))
first, last = map(int, options["--seeds"].split(".."))
lines = []
for seed in range(first, last + 1):
    values = [{{"name": n, "unit": "mm/s", "value": v + seed % 3 + shift * (n == "walk.speed")}} for n, v in (("walk.speed", 100), ("walk.falls", 0))
              for shift in [float(open({shift!r}).read())]]
    lines.append(json.dumps({{"job": f"walk seed={{seed}} commit={commit}+ab", "values": values}}))
open(options["--json"].replace(".json", ".jsonl"), "w").write(chr(10).join(lines))
"""
LINES = """#!/bin/sh
echo '[{{"name": "size", "unit": "lines", "runs": [{size}]}}, {{"name": "ratio"}}]' >"$2"
"""
LIST = """
[[measurement]]
command = "walker --only walk"
seeds = "1..6"
core = true
calibrated = ["config/gait.cfg"]
recheck = "--seeds 2..3"
figure = [{name = "walk.speed", worse = "less", tolerance = 1}, {name = "walk.falls", worse = "greater"}]

[[measurement]]
command = "sizes"
calibrated = ["config/sizes.cfg"]
figure = [{name = "size", worse = "greater", share = 0.1}]
"""


class Project:
    """A small project with two commands, under git."""

    def __init__(self, folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.capsys = folder, capsys
        self.file = folder / "docs/figures.json"
        self.list = folder / "measured.toml"
        self.bin = folder / "build/bin"
        for made in (self.bin, self.file.parent):
            made.mkdir(parents=True)
        (folder / ".gitignore").write_text("build\n")
        self.list.write_text(LIST)
        self.shift(0)
        self.git("init", "--quiet")
        self.commit()
        self.program("sizes", LINES.format(size=1000))
        self.program("simgt", f"#!/bin/sh\necho $* >>{folder}/build/kept\n")
        monkeypatch.setattr(measure, "ROOT", folder)
        monkeypatch.setattr(measure.git, "__kwdefaults__", {"root": folder})
        monkeypatch.setattr(measure.refuse_changes, "__defaults__", (folder,))

    def shift(self, by: float) -> None:
        (self.folder / "build/shift").write_text(str(by))

    def git(self, *arguments: str) -> str:
        return subprocess.run(["git", *arguments], cwd=self.folder, check=True, capture_output=True, text=True).stdout

    def commit(self) -> None:
        """Commit all, and have the walker be of this commit."""
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@a", "commit", "--quiet", "--message", "small")
        self.head = self.git("rev-parse", "--short=12", "HEAD").strip()
        self.program("walker", FAKE.format(calls=str(self.folder / "build/calls"), shift=str(self.folder / "build/shift"), commit=self.head))

    def program(self, name: str, text: str) -> None:
        (self.bin / name).write_text(text)
        (self.bin / name).chmod(0o755)

    def calls(self) -> list[str]:
        return (self.folder / "build/calls").read_text().splitlines()

    def figures(self, *arguments: str) -> tuple[int, str, str]:
        options = ["--build", self.folder / "build", "--file", self.file, "--list", self.list, "--out", self.folder / "build/out"]
        status = measure.main([*map(str, options), *arguments])
        printed = self.capsys.readouterr()
        return status, printed.out, printed.err.splitlines()[-1] if printed.err else ""


@pytest.fixture
def project(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Project:
    return Project(tmp_path, capsys, monkeypatch)


def verdict_of(printed: str, name: str) -> str:
    return next(line for line in printed.splitlines() if line.startswith(name + " ")).split()[-1]


def test_what_is_kept_is_compared_from_then_on(project: Project) -> None:
    status, printed, _ = project.figures()
    assert status == 0 and verdict_of(printed, "walk.speed") == "new" and not project.file.exists()
    assert project.figures("--keep")[0] == 0
    figures = kept.read(project.file)
    assert set(figures) == {"walk.speed", "walk.falls", "size"}
    speed = figures["walk.speed"]
    assert (speed.value, speed.seeds, speed.commit, speed.command) == (101, (1, 2, 3, 4, 5, 6), project.head, "walker --only walk")
    assert figures["size"].seeds == () and figures["size"].runs == (1000,)
    assert len(project.calls()) == 2  # once for both of its figures

    status, printed, _ = project.figures()
    assert status == 0 and {verdict_of(printed, name) for name in figures} == {"same"}
    project.shift(-10)
    status, printed, _ = project.figures()
    assert status == 1 and [verdict_of(printed, n) for n in ("walk.speed", "walk.falls", "size")] == ["worse", "same", "same"]
    assert project.figures("--seeds", "101..106")[0] == 1
    project.shift(10)
    status, printed, _ = project.figures()
    assert status == 0 and verdict_of(printed, "walk.speed") == "better"
    assert kept.read(project.file) == figures  # nothing is written unless asked for


PAGE = """<!-- figures: {walk.*}
speed
falls
-->
| | |
| --- | --- |
| speed | |
| falls | |
"""


def test_what_pages_quote_is_kept_and_not_judged(project: Project) -> None:
    project.list.write_text('[[measurement]]\ncommand = "walker"\nseeds = "1..6"\nquoted = "walk"\nfigure = [{name = "walk.speed", worse = "less"}]\n')
    page = project.folder / "docs/page.md"
    page.write_text(PAGE)
    project.commit()
    assert project.figures("--keep")[0] == 0
    figures = kept.read(project.file)
    assert {name: figure.worse for name, figure in figures.items()} == {"walk.speed": "less", "walk.falls": "nothing"}
    assert figures["walk.falls"].n == 6
    status, printed, _ = project.figures("--only", "walk.falls")
    assert status == 0 and verdict_of(printed, "walk.falls") == "quoted" and "walk.speed" not in printed
    assert project.figures("--only", "walk.other")[2].endswith("no figures begin with this")
    assert project.figures("--only", "other")[2].endswith("no figures begin with this")

    page.write_text("Nothing.\n")
    project.commit()
    assert project.figures("--keep", "--only", "walk.speed")[0] == 0
    assert set(kept.read(project.file)) == {"walk.speed"}  # of no page, of no list


def test_calibrated_files_fit_until_a_figure_is_worse(project: Project) -> None:
    assert project.figures("--recheck")[2] == f"figures: {project.file}: walk.speed: is not kept on the seeds of: walker --only walk --seeds 2..3"
    project.figures("--keep")
    assert (project.folder / "build/kept").read_text() == "check --fits config/gait.cfg\ncheck --fits config/sizes.cfg\n"
    spread = math.sqrt(0.8)  # of 102, 100, 101 and so on; less than the tolerance
    for shift, status, said in ((0, 0, "fits"), (-0.9 * spread, 0, "fits"), (-1.1, 1, "no longer fits"), (50, 0, "fits")):
        project.shift(shift)
        found, printed, _ = project.figures("--recheck")
        assert found == status and f"config/gait.cfg: walk.speed 101 -> {101 + shift:.4g} mm/s: {said}" in printed
        assert "config/gait.cfg: walk.falls 1 -> 1 mm/s: fits" in printed and "config/sizes.cfg: size 1000 -> 1000 lines: fits" in printed
    assert project.calls()[-1] == "--only walk --seeds 2..3"
    for size, status in ((1100, 0), (1101, 1)):
        project.program("sizes", LINES.format(size=size))
        assert project.figures("--recheck")[0] == status


def test_other_seeds_are_no_alarm(project: Project) -> None:
    project.figures("--keep")
    status, printed, _ = project.figures("--seeds", "101..106")
    assert status == 0 and verdict_of(printed, "walk.speed") == "same" and "--seeds 101..106" in project.calls()[-1]


def test_a_share_of_what_is_kept_is_a_tolerance(project: Project) -> None:
    project.figures("--keep")
    for size, said in ((1100, "same"), (1101, "worse")):
        project.program("sizes", LINES.format(size=size))
        assert verdict_of(project.figures("--only", "size")[1], "size") == said


def test_a_single_run_says_nothing_beside_several(project: Project) -> None:
    project.figures("--keep")
    project.shift(-50)
    status, printed, _ = project.figures("--seeds", "7..7")
    assert status == 0 and verdict_of(printed, "walk.speed") == "few"


def test_only_what_was_looked_at_is_measured_and_kept(project: Project) -> None:
    project.figures("--keep")
    before = kept.read(project.file)
    project.shift(-10)
    project.program("sizes", LINES.format(size=2000))
    calls = len(project.calls())
    assert project.figures("--only", "size", "--keep")[0] == 0
    after = kept.read(project.file)
    assert after["size"].value == 2000 and after["walk.speed"] == before["walk.speed"] and len(project.calls()) == calls
    assert project.figures("--only", "walk.falls")[0] == 0
    assert project.figures("--only", "walk")[0] == 1 == project.figures("--core")[0]
    assert "size" not in project.figures("--core")[1] and "walk.falls" not in project.figures("--only", "walk.speed,size")[1]
    assert project.figures("--only", "wal") == (2, "", "figures: ONLY=wal: no figures begin with this")


def test_what_others_keep_meanwhile_stays(project: Project) -> None:
    project.figures("--keep")
    other = kept.read(project.file)["size"]
    sizes = project.file.read_text().replace("1000", "2000")
    (project.folder / "build/meanwhile").write_text(sizes)
    walker = (project.bin / "walker").read_text()
    project.program("walker", walker + f"open({str(project.file)!r}, 'w').write(open({str(project.folder / 'build/meanwhile')!r}).read())\n")
    assert project.figures("--only", "walk", "--keep")[0] == 0
    assert other.value == 1000 and kept.read(project.file)["size"].value == 2000


def test_a_tree_with_changes_is_not_kept(project: Project) -> None:
    project.figures("--keep")  # which changes the file of figures
    assert project.figures("--keep")[0] == 0
    before = project.file.read_text()
    (project.folder / "new").touch()
    project.list.write_text(LIST + "\n")
    assert project.figures("--keep") == (2, "", "figures: KEEP=1: commit your changes first: measured.toml and 1 others")
    assert project.file.read_text() == before
    assert project.figures()[0] == 0


def test_a_program_of_another_commit_is_not_kept(project: Project) -> None:
    project.git("-c", "user.name=a", "-c", "user.email=a@a", "commit", "--quiet", "--allow-empty", "--message", "later")
    status, _, error = project.figures("--keep")
    assert status == 2 and error.startswith(f"figures: KEEP=1: the program was built from {project.head}+ab, not from ")
    assert not project.file.exists() and project.figures()[0] == 0


def test_what_cannot_be_measured_is_told_in_one_line(project: Project) -> None:
    project.program("sizes", "#!/bin/sh\necho one >&2; echo two >&2; exit 3\n")
    assert project.figures("--only", "size")[2].endswith(": two")
    project.program("sizes", "#!/bin/sh\necho '[]' >\"$2\"\n")
    assert project.figures("--only", "size")[2] == "figures: size: is not measured by: sizes"
    (project.bin / "sizes").unlink()
    status, _, error = project.figures("--only", "size")
    assert status == 2 and error.endswith("sizes: No such file or directory")


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ('worse = "less"', 'worse = "lesser"', "walk.speed.worse: expected one of"),
        ("tolerance = 1", "tolerance = -1", "walk.speed.tolerance: expected 0 or more"),
        ("share = 0.1", "share = 10", "size.share: expected 0 to 1"),
        ('name = "size"', 'name = "walk.falls"', "walk.falls: is measured twice"),
        ('"sizes"', '""', "measurement 2.command: expected a program"),
        ("core", "cor", "measurement 1.cor: is unknown"),
        ('name = "size", ', "", "measurement 2.figure 1.name: is missing"),
        ('calibrated = ["config/gait.cfg"]\n', "", "measurement 1.recheck: names no files of config/calibrated.cfg"),
        ("[[measurement]]", "[[measurement]", "Expected ']]'"),
    ],
)
def test_a_mistake_in_the_list_is_told(right: str, wrong: str, said: str, project: Project) -> None:
    project.list.write_text(LIST.replace(right, wrong, 1))
    status, _, error = project.figures()
    assert status == 2 and error.startswith(f"figures: {project.list}: {said}")


def test_a_figure_that_is_not_measured_any_more_is_told(project: Project) -> None:
    kept.write(project.file, [entry("gone")])
    assert project.figures()[2] == f"figures: {project.file}: gone: is not in {project.list}"


def test_the_projects_own_files_can_be_read() -> None:
    listed = kept.measurements(measure.LIST)
    names = {figure.name: figure for m in listed for figure in m.figure}
    commands = {m.command: m for m in listed}
    quoted = measure.quoted_by_pages()
    for figure in kept.read(measure.FILE).values():
        if figure.name in names:
            assert figure.worse == names[figure.name].worse
        else:
            assert figure.worse == kept.NOTHING and figure.name in quoted and commands[figure.command].gives(figure.name)
        assert figure.commit and replace(figure, n=0) != figure


def test_all_is_measured_in_an_hour_and_the_core_set_in_a_quarter() -> None:
    slower = 1.25  # A machine may be, while something was measured.
    seconds = {figure.command: figure.seconds for figure in kept.read(measure.FILE).values()}
    core = {m.command for m in kept.measurements(measure.LIST) if m.core}
    assert sum(seconds.values()) < slower * 2 * 3600  # of two processors
    assert sum(s for command, s in seconds.items() if command in core) < slower * 2 * 900


@pytest.mark.parametrize("name", spoiled.SPOILS)
def test_what_is_spoiled_is_there(name: str, tmp_path: Path) -> None:
    what = spoiled.SPOILS[name]
    listed = [figure.name for measurement in kept.measurements(measure.LIST) for figure in measurement.figure]
    assert any(measure.begins(figure, [what.only]) for figure in listed)
    file = spoiled.ROOT / what.file
    before = file.read_bytes() if file.exists() else b""
    copy = tmp_path / what.file
    copy.parent.mkdir(parents=True)
    copy.write_bytes(before)
    spoiled.spoil(tmp_path, what)
    assert copy.read_bytes() != before


def test_a_match_is_measured_in_fixed_pieces() -> None:
    pieces = iter([Cost(1, 8), Cost(3, 8), Cost(9, 2), Cost(9, 4)] * 2)

    class Played:
        def play(self, seed: int, minutes: float, threads: int) -> Cost:
            return Cost(seed * minutes, 10 * minutes)

    one, two = cost.measure({"kinematic": Played()}, [3, 4], 2, lambda threads: next(pieces))  # type: ignore[dict-item]
    assert (one["name"], one["runs"], one["seeds"]) == ("speed.cost.kinematic.threads1", [1.5, 2], [3, 4])
    assert two["runs"] == pytest.approx([10 / 3, 10 / 3])
    assert cost.seeds_of("3") == [3] and cost.seeds_of("3..5") == [3, 4, 5]
