"""Studies: better parameters by CMA-ES over jobs of experiments (docs/studies.md).

A file names a job, parameters of the configuration with ranges, and figures to improve. Candidates
of a generation are measured on the same seeds, those of the next one on others; how many, pycma's
noise handling finds. Every result is kept, so a study that was stopped goes on where it was.
"""

from __future__ import annotations

import json
import math
import os
import re
import warnings
from collections.abc import Iterable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from . import _core, _files, _json, _tables, jobs, modules
from ._error import Error
from ._run import Results, do
from ._intervals import mean_interval
from ._study_page import write_page
from ._workers import Processes, Ray

FAILED = 1e6  # the cost of parameters with which a job fails


@dataclass(frozen=True)
class StudyParameter:
    """A parameter TASK.SOLUTION.PATH, or a value motions.MOTION.NAME, between two bounds."""

    path: str
    low: float
    high: float
    scale: str = "linear"
    whole: bool = False

    def value(self, x: float) -> float:
        """Return the value at a place between 0 (low) and 1 (high)."""
        if self.scale == "log":
            value = self.low * (self.high / self.low) ** x
        else:
            value = self.low + (self.high - self.low) * x
        return round(value) if self.whole else float(f"{value:.5g}")

    def place(self, value: float) -> float:
        """Return where a value lies: the inverse of `value`, between 0 and 1."""
        bounded = min(max(value, self.low), self.high)
        if self.scale == "log":
            return math.log(bounded / self.low) / math.log(self.high / self.low)
        return (bounded - self.low) / (self.high - self.low)

    def old(self, root: str = "") -> float:
        """Return the value of a root's configuration, or of its motion, as it is."""
        if self.path.startswith("motions."):
            return self._of_motion(root or _core._data_path(""))
        task, _, rest = self.path.partition(".")
        solution, _, path = rest.partition(".")
        if task not in modules.solutions() or solution not in modules.solutions()[task]:
            raise Error("expected TASK.SOLUTION.PATH of a parameter", field=self.path)
        value = getattr(modules, task)(solution, root=root).get(path)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise Error("is not a number", field=self.path)
        return float(value)

    def _of_motion(self, root: str) -> float:
        _, motion, value = (*self.path.split(".", 2), "", "")[:3]
        for file in Path(root, "motions").rglob(f"{motion}.mof"):
            found = re.search(rf"^value\s+{re.escape(value)}\s+=\s+(-?\d+)", file.read_text(), re.MULTILINE)
            if found:
                return float(found[1])
        raise Error("expected a value motions.MOTION.NAME", field=self.path)


@dataclass(frozen=True)
class StudyFigure:
    """A figure of the job that should be high or low; the cost has weight times figure over unit."""

    name: str
    aim: str
    unit: float = 1
    weight: float = 1


@dataclass(frozen=True)
class StudyTest:
    """What old and new parameters are compared in: the job with other settings, NAME=VALUE."""

    name: str
    settings: tuple[str, ...] = ()


@dataclass(frozen=True)
class Study:
    """A study's file. Seeds are ranges as in 1..10; those of the tests must be others."""

    title: str
    job: str
    seeds: str
    test_seeds: str
    generations: int
    parameter: tuple[StudyParameter, ...]
    figure: tuple[StudyFigure, ...]
    test: tuple[StudyTest, ...]
    population: int = 12
    repetitions: int = 4  # seeds of a candidate, at first
    most_repetitions: int = 12
    step: float = 0.2  # first standard deviation, as a share of the ranges
    seed: int = 1
    file: str = field(default="", compare=False)

    def changed(self, values: Mapping[str, float]) -> _core._ChangedRoot:
        """Return the files of the project, or of the job's team, with other values."""
        teams = [word.removeprefix("team=") for word in self.job.split() if word.startswith("team=")]
        text = ",".join(f"{path}={value:g}" for path, value in values.items())
        return _core._changed_root(text, teams[-1] if teams else "GT2003")

    def old(self) -> dict[str, float]:
        """Return the values of the parameters as they are."""
        root = self.changed({})
        return {p.path: p.old(root.path) for p in self.parameter}


def load(path: str | os.PathLike[str]) -> Study:
    """Read a study's file; an Error says what is wrong with it."""
    file = os.fspath(path)
    study: Study = replace(_tables.made(Study, _tables.load(file), file), file=file)

    def check(good: bool, name: str, what: str) -> None:
        if not good:
            raise Error(what, file, field=name)

    for p in study.parameter:
        check(p.scale in ("linear", "log"), p.path, "its scale is neither linear nor log")
        check(p.low < p.high, p.path, "expected low below high")
        check(p.scale == "linear" or p.low > 0, p.path, "expected bounds above 0 for scale log")
    check(len({p.path for p in study.parameter}) == len(study.parameter), "parameter", "one is given twice")
    for f in study.figure:
        check(f.aim in ("high", "low"), f.name, "its aim is neither high nor low")
        check(f.unit > 0 and f.weight > 0, f.name, "expected unit and weight above 0")
    check(1 <= study.generations <= 10_000, "generations", "expected 1 to 10000")
    check(4 <= study.population <= 1000, "population", "expected 4 to 1000")
    check(1 <= study.repetitions <= study.most_repetitions, "repetitions", "expected 1 to most_repetitions")
    check(0 < study.step <= 1, "step", "expected a share of the ranges")
    try:
        for seeds in (study.seeds, study.test_seeds):
            jobs.select(seeds, [study.job.split()[0]])
        tests = tuple(replace(test, settings=tuple(_fixed(test.settings))) for test in study.test)
        study = replace(study, job=" ".join(_fixed(study.job.split())), test=tests)
        for test in study.test:
            _job(study, 1, {}, test.settings)
        study.old()
    except (Error, IndexError) as error:
        where = getattr(error, "file", "") and f"{error.file}: "
        what = where + getattr(error, "what", "expected a job")
        raise Error(what, file, field=getattr(error, "field", "") or "job") from None
    overlap = set(_seeds(study.seeds)) & set(_seeds(study.test_seeds))
    check(not overlap, "test_seeds", "are among the others")
    check(len(_seeds(study.seeds)) >= 2 * study.most_repetitions, "seeds", "are too few for two sets of most_repetitions")
    return study


def _seeds(text: str) -> range:
    first, _, last = text.partition("..")
    return range(int(first), int(last or first) + 1)


def _fixed(settings: Iterable[str]) -> list[str]:
    """Return settings whose teams have their files' fingerprints: results are those of these files."""
    fixed = []
    for setting in settings:
        name, _, value = setting.partition("=")
        is_team = name in ("team", "red", "blue") and "@" not in value
        fixed.append(f"{name}={_core._team_version(value)}" if is_team else setting)
    return fixed


def _job(study: Study, seed: int, values: Mapping[str, float], settings: Sequence[str] = ()) -> str:
    """Return the study's job on a seed with values of parameters; none: those of the configuration."""
    changed = {setting.partition("=")[0] for setting in settings}
    words = [w for w in study.job.split() if w.partition("=")[0] not in changed]
    text = ",".join(f"{path}={value:g}" for path, value in values.items()) or "none"
    return jobs.complete(" ".join([*words, *settings, f"values={text}", f"seed={seed}"]))


class _Laboratory:
    """Measures candidates; what was measured once is kept in a file."""

    def __init__(self, study: Study, out: Path, who: Processes | Ray) -> None:
        self._study, self._who = study, who
        self._results = Results(out / "results.jsonl")
        self._values: dict[str, dict[str, float]] = {}
        self.units: dict[str, str] = {}
        self.jobs = 0
        commit = _job(study, 1, {}).rpartition(" ")[2]
        for job in self._results.done:
            if not job.endswith(commit):
                raise Error(f"holds results of another commit than {commit}", str(self._results.path), field=job)

    def measure(self, todo: Sequence[str]) -> list[dict[str, float] | None]:
        """Return the figures of jobs by name; None of those that failed."""
        do(todo, self._results, self._who, quiet=True)
        self.jobs += len(todo)
        if any(job not in self._values for job in todo):
            self._read()
        return [self._values.get(job) for job in todo]

    def _read(self) -> None:
        for line in self._results.path.read_text(encoding="utf-8-sig").splitlines():
            try:
                result = _json.parse(line)
            except Error:
                continue  # half a line, of a study that was killed
            self._values[result["job"]] = {v["name"]: v["value"] for v in result["values"]}
            self.units.update((v["name"], v["unit"]) for v in result["values"])

    def cost(self, figures: Mapping[str, float] | None) -> float:
        """Return what the study makes small."""
        if figures is None:
            return FAILED
        total = 0.0
        for f in self._study.figure:
            if f.name not in figures and f.name in self.units:
                return FAILED  # such as the spread of kicks that all miss
            if f.name not in figures:
                known = ", ".join(figures)
                raise Error(f"is not measured by the job; there are: {known}", self._study.file, field=f.name)
            total += (-1 if f.aim == "high" else 1) * f.weight * figures[f.name] / f.unit
        return total

    def costs(self, candidates: Sequence[Mapping[str, float]], seeds: Sequence[int]) -> list[float]:
        """Return each candidate's mean cost over the same seeds."""
        todo = [_job(self._study, seed, c) for c in candidates for seed in seeds]
        measured = self.measure(todo)
        if not any(measured):
            raise Error("all jobs failed, as told above", self._study.file, field=todo[0])
        costs = [self.cost(figures) for figures in measured]
        return [float(np.mean(costs[i : i + len(seeds)])) for i in range(0, len(costs), len(seeds))]


@dataclass
class Generation:
    """What a generation was like: its costs, step and the seeds of each candidate."""

    best: float
    median: float
    step: float
    repetitions: int


@dataclass
class Comparison:
    """A figure with the old and the new parameters on unseen seeds, with a 95 % interval of the change,
    if there is more than one seed."""

    test: str
    name: str
    unit: str
    old: float
    new: float
    low: float | None
    high: float | None


@dataclass
class Importance:
    """By how much the cost grows if a parameter alone has its old value again (95 % interval)."""

    path: str
    old: float
    new: float
    change: float
    low: float | None
    high: float | None


def interval(differences: Sequence[float]) -> tuple[float | None, float | None]:
    """Return the 95 % interval of a mean of paired differences by Student's t; None of a single one."""
    return mean_interval(list(differences)) or (None, None)


def _values(study: Study, place: Sequence[float]) -> dict[str, float]:
    return {p.path: p.value(float(x)) for p, x in zip(study.parameter, place, strict=True)}


def _search(study: Study, laboratory: _Laboratory) -> tuple[dict[str, float], list[Generation]]:
    try:
        with warnings.catch_warnings(action="ignore"):  # that it cannot draw
            import cma
    except ModuleNotFoundError:
        raise Error("a study needs pycma: pip install 'gt2003[study]'") from None
    old = study.old()
    start = [p.place(old[p.path]) for p in study.parameter]
    options = {"seed": study.seed, "popsize": study.population, "bounds": [0, 1], "verbose": -9, "verb_log": 0}
    search = cma.CMAEvolutionStrategy(start, study.step, options)
    noise = cma.NoiseHandler(
        len(start), maxevals=[study.repetitions, study.repetitions, study.most_repetitions], epsilon=0
    )
    seeds = _seeds(study.seeds)
    history: list[Generation] = []
    for number in range(study.generations):
        count = max(1, round(noise.evaluations))
        first = 2 * study.most_repetitions * number

        def block(offset: int, first: int = first, count: int = count) -> list[int]:
            return [seeds[(first + offset + i) % len(seeds)] for i in range(count)]

        places = search.ask()
        costs = laboratory.costs([_values(study, place) for place in places], block(0))

        def again(place: Sequence[float], others: Sequence[int] = tuple(block(study.most_repetitions))) -> float:
            return laboratory.costs([_values(study, place)], others)[0]

        search.tell(places, costs)
        search.sigma *= noise(places, costs, again)
        history.append(Generation(min(costs), float(np.median(costs)), float(search.sigma), count))
        print(
            f"generation {number + 1}/{study.generations}: cost {min(costs):.4g} (best), "
            f"{np.median(costs):.4g} (median), step {search.sigma:.3g}, {count} seeds",
            flush=True,
        )
    return _values(study, search.result.xfavorite), history


def _compare(study: Study, laboratory: _Laboratory, new: Mapping[str, float]) -> list[Comparison]:
    comparisons = []
    for test in study.test:
        todo = [_job(study, seed, v, test.settings) for v in ({}, new) for seed in _seeds(study.test_seeds)]
        measured = laboratory.measure(todo)
        half = len(todo) // 2
        both = [(a, b) for a, b in zip(measured[:half], measured[half:]) if a and b]
        if len(both) < half:
            raise Error(f"{half - len(both)} jobs of the test failed", study.file, field=test.name)
        for name in dict.fromkeys(name for pair in both for figures in pair for name in figures):
            pairs = [(a[name], b[name]) for a, b in both if name in a and name in b]
            if len(pairs) < 2:
                continue  # there is no interval
            old, new_ = zip(*pairs)
            low, high = interval(np.subtract(new_, old))
            unit = laboratory.units[name]
            comparisons.append(
                Comparison(test.name, name, unit, float(np.mean(old)), float(np.mean(new_)), low, high)
            )
    return comparisons


def _weigh(study: Study, laboratory: _Laboratory, new: Mapping[str, float]) -> list[Importance]:
    seeds = _seeds(study.test_seeds)
    old = study.old()
    versions = [new] + [{**new, path: value} for path, value in old.items()]
    measured = laboratory.measure([_job(study, seed, v) for v in versions for seed in seeds])
    costs = np.reshape([laboratory.cost(figures) for figures in measured], (len(versions), len(seeds)))
    weighed = []
    for (path, value), row in zip(old.items(), costs[1:], strict=True):
        low, high = interval(row - costs[0])
        weighed.append(Importance(path, value, new[path], float(np.mean(row - costs[0])), low, high))
    return sorted(weighed, key=lambda w: -w.change)


def run(study: Study, out: Path, who: Processes | Ray) -> list[Comparison]:
    """Do a study; write its page, study.json and the configuration found into a folder.

    An Error if another study or run works in the folder.
    """
    with closing(_core._OutputLock(os.fspath(out))):
        return _run(study, out, who)


def _run(study: Study, out: Path, who: Processes | Ray) -> list[Comparison]:
    laboratory = _Laboratory(study, out, who)
    new, history = _search(study, laboratory)
    comparisons = _compare(study, laboratory, new)
    importance = _weigh(study, laboratory, new)
    changed = study.changed(new)
    for name in changed.files:
        file = out / name
        file.parent.mkdir(parents=True, exist_ok=True)
        _files.write(file, Path(changed.path, name).read_text())
    told = {
        "title": study.title,
        "jobs": laboratory.jobs,
        "new": new,
        "generations": [vars(g) for g in history],
        "comparisons": [vars(c) for c in comparisons],
        "importance": [vars(i) for i in importance],
    }
    _files.write(out / "study.json", json.dumps(told, indent=1) + "\n")
    write_page(study, out / "study.html", laboratory.jobs, history, comparisons, importance, len(_seeds(study.test_seeds)))
    return comparisons
