"""Studies: found parameters, the same after a stop, and files with mistakes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import gt2003
from gt2003 import jobs, study

STUDIES = Path(__file__).resolve().parents[2] / "studies"
TEXT = """
title = "A short one"
job = "localization.robustness.bench locators=kalman trouble=none minutes=0.2"
seeds = "1..20"
test_seeds = "31..33"
generations = 2
population = 4
repetitions = 2
most_repetitions = 3

[[parameter]]
path = "SelfLocator.Kalman.slip"
low = 0.1
high = 10
scale = "log"

[[parameter]]
path = "SelfLocator.Kalman.points"
low = 1
high = 16
whole = true

[[figure]]
name = "localization.kalman.error.mean"
aim = "low"

[[test]]
name = "other"
settings = ["minutes=0.1"]
"""


def command(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, "-m", "gt2003", "study", *map(str, arguments)]
    return subprocess.run(line, capture_output=True, text=True)


def test_a_study_finds_a_configuration_and_goes_on_after_a_stop(tmp_path: Path) -> None:
    file = tmp_path / "short.toml"
    file.write_text(TEXT)
    told = command(file, "--out", tmp_path / "a")
    assert told.returncode == 0, told.stderr
    assert "generation 2/2" in told.stdout
    written = tmp_path / "a/config/modules/SelfLocator.Kalman.cfg"
    found = json.loads((tmp_path / "a/study.json").read_text())
    assert f"points {found['new']['SelfLocator.Kalman.points']:g}" in written.read_text()
    assert [c["test"] for c in found["comparisons"]] == ["other"] * len(found["comparisons"])
    assert {i["path"] for i in found["importance"]} == set(found["new"])
    page = (tmp_path / "a/study.html").read_text()
    assert "A short one" in page and "SelfLocator.Kalman.slip" in page
    assert page.count("<figure>") == 3  # the change of the figure, importance, convergence
    assert page.count("<circle") == 1 + 2 + 2 * 2  # the figure; importances; old and new in the ranges

    # Stopped in the middle of a line: no job is done again, and all is as without the stop.
    lines = (tmp_path / "a/results.jsonl").read_text().splitlines(keepends=True)
    (tmp_path / "b").mkdir()
    (tmp_path / "b/results.jsonl").write_text("".join(lines[:9]) + lines[9][:50])
    told = command(file, "--out", tmp_path / "b")
    assert told.returncode == 0, told.stderr
    for name in ("study.json", "study.html", "config/modules/SelfLocator.Kalman.cfg"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    again = (tmp_path / "b/results.jsonl").read_text().splitlines()
    assert len(again) == len(lines) + 1  # and the half one


def test_values_change_a_job() -> None:
    def mean(values: str) -> float:
        job = f"localization.robustness.bench locators=kalman trouble=none minutes=0.2 values={values}"
        result = json.loads(jobs.measure(job))["values"]
        return next(v["value"] for v in result if v["name"] == "localization.kalman.error.mean")

    slip = gt2003.modules.SelfLocator("Kalman").get("slip")
    assert mean(f"SelfLocator.Kalman.slip={slip}") == mean("none") != mean("SelfLocator.Kalman.slip=5")
    with pytest.raises(gt2003.Error, match="SelfLocator.Kalman.slop"):
        mean("SelfLocator.Kalman.slop=1")


KICK = """
title = "A team's kick"
job = "motion.kick kick=tap team={team} x=140 y=-60 direction=0 balls=1"
seeds = "1..8"
test_seeds = "31"
generations = 1
population = 4
repetitions = 1
most_repetitions = 1

[[parameter]]
path = "motions.tap.lift-frames"
low = 10
high = 60
whole = true

[[figure]]
name = "motion.kick.tap.ahead"
aim = "high"

[[test]]
name = "as it is"
"""


def test_a_study_changes_the_kick_of_a_team(tmp_path: Path) -> None:
    team = tmp_path / "tapping"
    (team / "motions/kicks").mkdir(parents=True)
    kick = team / "motions/kicks/tap.mof"
    kick.write_text(
        "motion_id = tap\nvalue lift-frames = 25\nlabel start\n"
        "posture stand 1 lift-frames\ntransition allMotions extern start\n"
    )
    file = tmp_path / "tap.toml"
    file.write_text(KICK.format(team=team))
    assert study.load(file).old() == {"motions.tap.lift-frames": 25}
    told = command(file, "--out", tmp_path / "out")
    assert told.returncode == 0, told.stderr
    found = json.loads((tmp_path / "out/study.json").read_text())["new"]["motions.tap.lift-frames"]
    assert f"value lift-frames = {found:g}\n" in (tmp_path / "out/motions/kicks/tap.mof").read_text()
    assert "value lift-frames = 25\n" in kick.read_text(), "the team's own file is as it was"

    # Results are those of the team's files as they were.
    before = study.load(file).job
    assert f" team={team}@" in before
    assert before.split()[2] in (tmp_path / "out/results.jsonl").read_text()
    kick.write_text(kick.read_text().replace("stand 1", "stand 2"))
    assert study.load(file).job != before

    file.write_text(KICK.format(team="nobody"))
    with pytest.raises(gt2003.Error, match="nobody: is no team"):
        study.load(file)


@pytest.mark.parametrize("file", sorted(STUDIES.glob("*.toml")), ids=lambda file: file.name)
def test_the_studies_of_the_project_can_be_read(file: Path) -> None:
    loaded = study.load(file)
    for parameter in loaded.parameter:
        old = parameter.old()
        assert parameter.low <= old <= parameter.high
        assert parameter.value(parameter.place(old)) == pytest.approx(old, rel=1e-4)


@pytest.mark.parametrize(
    ("wrong", "right", "field", "what"),
    [
        ("generatoins = 2", "generations = 2", "generatoins", "is unknown"),
        ("", "seeds = \"1..20\"", "seeds", "is missing"),
        ("generations = 2.5", "generations = 2", "generations", "expected int"),
        ("population = 1", "population = 4", "population", "expected 4 to 1000"),
        ("low = 20", "low = 0.1", "SelfLocator.Kalman.slip", "low below high"),
        ("low = 0", "low = 0.1", "SelfLocator.Kalman.slip", "above 0"),
        ('aim = "lower"', 'aim = "low"', "localization.kalman.error.mean", "neither high nor low"),
        ("Kalman.slop", "Kalman.slip", "slop", "no such parameter"),
        ("SelfLocater", "SelfLocator", "SelfLocater.Kalman.slip", "expected TASK"),
        ('"31..33"', '"31', "", ""),
        ("test_seeds = \"20..33\"", "test_seeds = \"31..33\"", "test_seeds", "among the others"),
        ("minuets=0.4", "minutes=0.1", "minuets", "not a parameter"),
        ("job = \"lokalization", "job = \"localization", "lokalization", "neither an experiment"),
    ],
)
def test_a_mistake_in_a_file_is_told(wrong: str, right: str, field: str, what: str, tmp_path: Path) -> None:
    file = tmp_path / "wrong.toml"
    if not field:
        wrong, right, what = right, wrong, "at line"
    assert right in TEXT
    file.write_text(TEXT.replace(right, wrong, 1))
    with pytest.raises(gt2003.Error) as raised:
        study.load(file)
    assert raised.value.file == str(file)
    assert what in raised.value.what, raised.value
    assert field in raised.value.field


def test_a_figure_that_is_not_measured_is_told(tmp_path: Path) -> None:
    file = tmp_path / "wrong.toml"
    file.write_text(TEXT.replace("kalman.error.mean", "kalman.error.maen"))
    told = command(file, "--out", tmp_path / "out")
    assert told.returncode == 2
    assert "kalman.error.maen: is not measured by the job" in told.stderr.splitlines()[-1]


def test_a_figure_that_is_missing_on_some_seeds_fails_there(tmp_path: Path) -> None:
    (tmp_path / "short.toml").write_text(TEXT)
    found = study.load(tmp_path / "short.toml")
    laboratory = study._Laboratory(found, tmp_path, study.Processes(1))
    name = found.figure[0].name
    laboratory.units[name] = "mm"  # another job has measured it
    assert laboratory.cost({name: 2.0}) == pytest.approx(2.0 * found.figure[0].weight / found.figure[0].unit)
    assert laboratory.cost({"another": 1.0}) == study.FAILED
    assert laboratory.cost(None) == study.FAILED


def test_results_of_another_program_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "short.toml"
    file.write_text(TEXT)
    job = jobs.select("1", ["localization.robustness.bench"], ["trouble=none"])[0]
    other = job.partition(" commit=")[0] + " commit=0123456789ab"
    (tmp_path / "results.jsonl").write_text(json.dumps({"job": other, "values": []}) + "\n")
    told = command(file, "--out", tmp_path)
    assert told.returncode == 2 and len(told.stderr.splitlines()) == 1
    assert "results.jsonl: " in told.stderr and "holds results of another commit than" in told.stderr


def test_intervals_hold_the_mean() -> None:
    differences = np.random.default_rng(3).normal(5, 2, 40)
    low, high = study.interval(differences)
    assert low is not None and high is not None
    assert low < differences.mean() < high
    assert high - low == pytest.approx(2 * 1.96 * differences.std() / 40**0.5, rel=0.1)
    assert study.interval([1.0]) == (None, None)
