"""Measures the figures of measured.toml and compares them with those that are kept in docs/figures.json (docs/experiments.md).

measure.py --build build/release [--only PREFIX,...] [--core] [--seeds 101..104] [--keep | --recheck]

Exit status 1 if a figure is worse, 2 if something cannot be measured or read. --keep writes what was measured into the file, and into
config/calibrated.cfg that the files of which the figures tell fit. --recheck measures on few seeds whether they still do.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import kept
from gt2003 import Error, _json
from kept import Kept, Measured, Measurement
from verdicts import Sample, chances, comparable, fits, verdicts

ROOT = Path(__file__).resolve().parents[2]
LIST = Path(__file__).with_name("measured.toml")
FILE = ROOT / "docs/figures.json"
FILL_PAGES = ROOT / "scripts/fill-pages"


@dataclass(frozen=True)
class Row:
    """A figure that was measured, and what the file had."""

    now: Kept
    before: Kept | None
    tolerance: float


def git(*arguments: str, root: Path = ROOT) -> str:
    done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Error(done.stderr.strip().splitlines()[-1], field="git")
    return done.stdout.rstrip("\n")


def quoted_by_pages() -> set[str]:
    """Return the names of all figures that pages quote."""
    pages = git("ls-files", "docs/*.md").splitlines()
    done = subprocess.run([FILL_PAGES, "--names", *pages], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        raise Error(done.stderr.strip().splitlines()[-1], field="scripts/fill-pages --names")
    return set(done.stdout.split())


def refuse_changes(file: Path, root: Path = ROOT) -> None:
    """Raise an Error if the tree has changes besides the file of figures itself."""
    changed = [line[3:] for line in git("status", "--porcelain", "--untracked-files=all", root=root).splitlines() if (root / line[3:]).resolve() != file.resolve()]
    if changed:
        others = f" and {len(changed) - 1} others" if len(changed) > 1 else ""
        raise Error(f"commit your changes first: {changed[0]}{others}", field="KEEP=1")


def begins(name: str, starts: Sequence[str]) -> bool:
    """Whether a name begins with the words of one of some names; of none, each does."""
    return not starts or any(f"{name}.".startswith(f"{start}.") for start in starts)


def selected(listed: Sequence[Measurement], only: Sequence[str], core: bool, quoted: Iterable[str] = ()) -> list[Measurement]:
    """Return the measurements that give figures which begin with one of some names (all, if there are none), with these of their figures.

    quoted: names of figures besides those of the list.
    """
    chosen = []
    for measurement in listed:
        figures = tuple(figure for figure in measurement.figure if begins(figure.name, only))
        quotes = any(begins(name, only) and measurement.gives(name) for name in quoted)
        if (figures or quotes) and (measurement.core or not core):
            chosen.append(replace(measurement, figure=figures))
    if not chosen:
        raise Error("no figures begin with this", field=f"ONLY={','.join(only)}")
    return chosen


def of_jobs(text: str, file: str, commit: str) -> dict[str, tuple[str, Sample]]:
    """Return units and values of the figures that results of jobs have."""
    units: dict[str, str] = {}
    runs: dict[str, dict[int, float]] = {}
    for line in text.splitlines():
        result = _json.parse(line, file)
        words = dict(word.split("=", 1) for word in result["job"].split()[1:])
        if commit and not words["commit"].startswith(commit):
            raise Error(f"the program was built from {words['commit']}, not from {commit}", field="KEEP=1")
        for value in result["values"]:
            units[value["name"]] = value["unit"]
            runs.setdefault(value["name"], {})[int(words["seed"])] = value["value"]
    return {name: (units[name], Sample(tuple(r for _, r in sorted(v.items())), tuple(sorted(v)))) for name, v in runs.items()}


def results(file: Path, commit: str) -> dict[str, tuple[str, Sample]]:
    """Return what a command has written: of experiments the results of their jobs, whose seeds they name; else the figures themselves."""
    jobs = file.with_suffix(".jsonl")
    if jobs.exists():
        return of_jobs(jobs.read_text(), str(jobs), commit)
    figures = _json.parse(file.read_text(), str(file))
    return {f["name"]: (f["unit"], Sample(tuple(f["runs"]), tuple(f.get("seeds", ())))) for f in figures if f.get("runs")}


def execute(command: Sequence[str], root: Path) -> float:
    """Return the processor time that a command takes in a folder, in seconds; an Error with its last line if it fails."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, cwd=root, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
    except OSError as error:
        raise Error(error.strerror or "cannot be executed", field=command[0]) from None
    if done.returncode:
        raise Error((done.stderr.strip().splitlines() or [f"status {done.returncode}"])[-1], field=" ".join(command))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def write(command: str, chance: Sequence[str], build: Path, file: Path, root: Path) -> float:
    """Execute a command of the list in a tree, with arguments for its seeds; return its processor time in seconds."""
    program, *arguments = command.replace("{build}", str(build)).split()
    own = root / program
    start = [sys.executable, str(own)] if program.endswith(".py") else [str(own if own.is_file() else build / "bin" / program)]
    file.parent.mkdir(parents=True, exist_ok=True)
    for old in (file, file.with_suffix(".jsonl")):
        old.unlink(missing_ok=True)
    return execute([*start, *arguments, *chance, "--json", str(file)], root)


def chance_of(measurement: Measurement, given: argparse.Namespace) -> list[str]:
    if given.recheck and measurement.recheck:
        return measurement.recheck.split()
    return ["--seeds", given.seeds or measurement.seeds] if measurement.seeds else []


def measure(measurement: Measurement, given: argparse.Namespace, file: Path, commit: str, quoted: set[str]) -> list[Kept]:
    """Execute a command and return its figures, and those of its figures that pages quote."""
    seconds = write(measurement.command, chance_of(measurement, given), given.build.resolve(), file, ROOT)
    written = results(file, commit if given.keep else "")
    for figure in measurement.figure:
        if figure.name not in written:
            raise Error(f"is not measured by: {measurement.command}", field=figure.name)
    figures = {figure.name: figure.worse for figure in measurement.figure}
    figures |= {name: kept.NOTHING for name in sorted(quoted & written.keys()) if measurement.gives(name)}
    return [kept.keep(name, unit, worse, measurement.command, seconds, commit, sample) for name, worse in figures.items() for unit, sample in [written[name]]]


def measure_all(chosen: Sequence[Measurement], file: Mapping[str, Kept], given: argparse.Namespace, commit: str, quoted: set[str]) -> list[Row]:
    rows = []
    for i, measurement in enumerate(chosen, 1):
        print(f"{i}/{len(chosen)} {measurement.command}", file=sys.stderr, flush=True)
        tolerances = {figure.name: figure for figure in measurement.figure}
        for now in measure(measurement, given, (given.out / f"{i}.json").resolve(), commit, quoted):
            before = file.get(now.name)
            rows.append(Row(now, before, tolerances[now.name].tolerated(before.value) if before and now.name in tolerances else 0))
    return rows


def judge(rows: Sequence[Row]) -> list[str]:
    """Return for each figure: better, same, worse; quoted if it is not judged; new if the file has none; few if one of both has a single run."""
    said = ["quoted" if row.now.worse == kept.NOTHING else "few" if row.before else "new" for row in rows]
    tested = [i for i, row in enumerate(rows) if row.before and row.now.worse != kept.NOTHING and comparable(row.before.sample, row.now.sample)]
    tests = [chances(row.before.sample, row.now.sample, row.now.worse, row.tolerance) for i in tested if (row := rows[i]).before]
    for i, verdict in zip(tested, verdicts(tests), strict=True):
        said[i] = verdict
    return said


def shown(figure: Kept | None) -> str:
    if not figure:
        return ""
    half = (figure.interval[1] - figure.interval[0]) / 2 if figure.interval else None
    return f"{figure.value:.4g}" + (f" ± {half:.2g}" if half is not None else "")


def report(rows: Sequence[Row], said: Sequence[str]) -> None:
    width = max(len(row.now.name) for row in rows)
    print(f"{'figure':{width}} {'before':>18} {'now':>18} {'unit':9} n  verdict")
    for row, verdict in zip(rows, said, strict=True):
        print(f"{row.now.name:{width}} {shown(row.before):>18} {shown(row.now):>18} {row.now.unit:9} {row.now.n:<2} {verdict}")
    counts = ", ".join(f"{said.count(v)} {v}" for v in ("better", "same", "worse", "new", "few", "quoted") if v in said)
    seconds = {row.now.command: row.now.seconds for row in rows}
    print(f"{len(rows)} figures: {counts}; {sum(seconds.values()):.0f} s of the processor")


def recheck(listed: Sequence[Measurement], file: Mapping[str, Kept], given: argparse.Namespace) -> int:
    """Print for each figure that is measured again whether the calibrated files still fit; return the exit status."""
    status = 0
    for i, measurement in enumerate((m for m in listed if m.calibrated), 1):
        path = (given.out / f"recheck-{i}.json").resolve()
        write(measurement.command, chance_of(measurement, given), given.build.resolve(), path, ROOT)
        written = results(path, "")
        figures = [figure for figure in measurement.figure if figure.name in written]
        if not figures:
            raise Error(f"measures no figure of the list: {measurement.command} {measurement.recheck}", str(given.list), field="recheck")
        for figure in figures:
            before, (unit, now) = file.get(figure.name), written[figure.name]
            if not before or not set(now.seeds) <= set(before.seeds):
                raise Error(f"is not kept on the seeds of: {measurement.command} {measurement.recheck}".rstrip(), str(given.file), field=figure.name)
            good = fits(before.sample, now, figure.worse, figure.tolerated(before.value))
            status = status if good else 1
            old = [run for seed, run in zip(before.seeds, before.runs) if seed in now.seeds] or before.runs
            print(
                f"{', '.join(measurement.calibrated)}: {figure.name} {sum(old) / len(old):.4g} -> {sum(now.runs) / len(now.runs):.4g} {unit}: "
                + ("fits" if good else "no longer fits; simgt check tells what has changed, and how it is made anew")
            )
    return status


def keep_fits(chosen: Sequence[Measurement], given: argparse.Namespace) -> None:
    """Write into config/calibrated.cfg which files were measured to fit."""
    for file in sorted({file for measurement in chosen for file in measurement.calibrated}):
        execute([str(given.build.resolve() / "bin/simgt"), "check", "--fits", file], ROOT)


def run(given: argparse.Namespace) -> int:
    if given.keep:
        refuse_changes(given.file)
    commit = git("rev-parse", "--short=12", "HEAD")
    listed, file = kept.measurements(given.list), kept.read(given.file)
    known = {figure.name for measurement in listed for figure in measurement.figure}
    for name, figure in file.items():
        if name not in known and figure.worse != kept.NOTHING:
            raise Error(f"is not in {given.list}", str(given.file), field=name)
    if given.recheck:
        return recheck(listed, file, given)
    only = [name for name in given.only.split(",") if name]
    quoted = quoted_by_pages()
    chosen = selected(listed, only, given.core, quoted - known)
    rows = measure_all(chosen, file, given, commit, {name for name in quoted - known if begins(name, only)})
    said = judge(rows)
    report(rows, said)
    if given.keep:
        file = kept.read(given.file)  # others may have kept figures meanwhile
        dropped = {name for name, figure in file.items() if figure.worse == kept.NOTHING and name not in quoted}
        file |= {row.now.name: row.now for row in rows}
        kept.write(given.file, [figure for name, figure in file.items() if name not in dropped])
        keep_fits(chosen, given)
        return 0
    return 1 if "worse" in said else 0


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--only", default="", help="figures that begin with one of these names")
    parser.add_argument("--core", action="store_true", help="the core set only")
    parser.add_argument("--seeds", default="", help="other seeds than those of the list")
    parser.add_argument("--keep", action="store_true", help="write what was measured into the file")
    parser.add_argument("--recheck", action="store_true", help="measure again, on few seeds, whether calibrated files fit")
    parser.add_argument("--file", type=Path, default=FILE, help="the figures that are kept")
    parser.add_argument("--list", type=Path, default=LIST, help="what is measured")
    parser.add_argument("--out", type=Path, default=Path("out/figures"), help="folder for what the commands write")
    try:
        return run(parser.parse_args(arguments))
    except Error as error:
        print(f"figures: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
