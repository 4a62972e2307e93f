"""The command `gt2003`: jobs of experiments, tournaments and studies, on this machine or on a Ray cluster; what teams learn from matches."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import jobs, study, tournament, values
from ._error import Error
from ._run import run, workers
from ._signals import EndSignals, Interrupted, quietly


def _add_workers(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--address",
        metavar="ADDRESS",
        help="of a Ray cluster; auto: the one of this machine or of RAY_ADDRESS, and if there is none, "
        "Ray on this machine alone, as with local; by default processes without Ray",
    )
    parser.add_argument("--processes", type=int, metavar="N", help="on this machine; by default one a CPU")
    parser.add_argument(
        "--retries", type=int, default=3, help="times a job is done again whose worker died (default: 3)"
    )


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="gt2003", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    running = commands.add_parser("run", help="does jobs and merges their results")
    running.add_argument("what", help="experiments, tournament, or a file with jobs, one a line")
    running.add_argument("teams", nargs="*", help="of a tournament: folders, names of the folder teams, GT2003, or commit:REVISION")
    running.add_argument("--seeds", default="1..10", help="a range like 101..110, or one (default: 1..10)")
    running.add_argument("--only", default="", help="experiments or groups, separated by commas")
    running.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="of a parameter")
    running.add_argument(
        "--out", type=Path, default=Path("out/run"), metavar="FOLDER",
        help="for jobs, results.jsonl, and experiments.json and .html, or tournament.json and .html; what "
        "is there is not done again (default: out/run)",
    )
    running.add_argument(
        "--format", choices=["jsonl", "parquet"], default="jsonl",
        help="parquet: when all are done, the results as results.parquet, too",
    )
    _add_workers(running)
    studying = commands.add_parser("study", help="finds better parameters, as a file of the folder studies says")
    studying.add_argument("file", type=Path, help="a study, such as studies/walk.toml")
    studying.add_argument(
        "--out", type=Path, metavar="FOLDER",
        help="for results.jsonl, study.html, study.json and config; what is measured there is not measured "
        "again (default: out/studies/NAME)",
    )
    _add_workers(studying)
    learning = commands.add_parser("values", help="learns from matches what a ball is worth and where supporters help")
    learning.add_argument("matches", type=Path, nargs="+", help="files match.json")
    learning.add_argument("--out", type=Path, required=True, metavar="FILE", help="values.cfg of a team")
    return parser


def _jobs_of(given: argparse.Namespace) -> list[str]:
    if given.what != "tournament" and given.teams:
        raise Error("only a tournament has teams", field=given.teams[0])
    if given.what == "experiments":
        return jobs.select(given.seeds, [name for name in given.only.split(",") if name], given.set)
    if given.what == "tournament":
        if given.only:
            raise Error("is of experiments; a tournament plays matches", field="--only")
        return tournament.jobs(given.teams, given.seeds, given.set)
    return jobs.read(given.what)


def _perform(given: argparse.Namespace) -> int:
    signals = EndSignals()
    failed = 0
    try:
        if given.command == "values":
            values.learn(given.matches, given.out)
            return 0
        if given.command == "study":
            studied = study.load(given.file)
        else:
            todo = _jobs_of(given)
        who = workers(given.address, given.processes, given.retries)
        signals.install()  # Ray has taken some
        try:
            if given.command == "study":
                out = given.out or Path("out/studies") / given.file.stem
                study.run(studied, out, who)
                print(f"{out}/study.html, {out}/config")
            else:
                merge = tournament.merge if given.what == "tournament" else None
                failed = run(todo, given.out, who, merge, given.format == "parquet")
        finally:
            who.close()
    except Error as error:
        print(f"gt2003: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:
        raise
    except OSError as error:
        what = error.strerror or str(error)
        print(f"gt2003: {error.filename}: {what}" if error.filename else f"gt2003: {what}", file=sys.stderr)
        return 2
    except MemoryError:
        print("gt2003: not enough memory", file=sys.stderr)
        return 2
    except Interrupted as interrupted:
        print("gt2003: interrupted; the same command goes on", file=sys.stderr)
        return interrupted.status
    if failed:
        print(f"gt2003: {failed} jobs failed", file=sys.stderr)
    return 2 if failed else 0


def main() -> int:
    """Run the command; return its exit status: 2 if something was wrong or a job failed, 128 more than a signal."""
    return quietly(lambda: _perform(_parser().parse_args()))


if __name__ == "__main__":
    sys.exit(main())
