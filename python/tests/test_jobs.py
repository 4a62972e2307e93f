"""Jobs of experiments: the same bytes as the program, by processes, by Ray, after a stop."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
import threading
import time
from contextlib import closing
from html import escape
from pathlib import Path

import pandas
import pytest

import gt2003
from gt2003 import jobs
from gt2003._run import Results, run
from gt2003._workers import Outcome, Processes, Ray

BUILD = Path(os.environ["GT_BUILD"])
SHORT = ["trouble=none", "minutes=0.05"]


def some(seeds: str) -> list[str]:
    return jobs.select(seeds, ["localization.robustness.bench"], SHORT)


def experiment(*arguments: str | Path) -> str:
    program = [BUILD / "bin/experiment", *arguments]
    return subprocess.run(program, check=True, capture_output=True, text=True).stdout


def command(*arguments: str | Path, **options: object) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, "-m", "gt2003", *map(str, arguments)]
    return subprocess.run(line, capture_output=True, text=True, **options)  # type: ignore[call-overload]


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The figures of twelve jobs by the program `experiment`."""
    folder = tmp_path_factory.mktemp("expected")
    (folder / "jobs").write_text("\n".join(some("1..12")))
    experiment("run", folder / "jobs", "--out", folder / "results.jsonl")
    experiment("merge", folder / "results.jsonl", "--json", folder / "experiments.json")
    return folder


def test_experiments_and_jobs_are_those_of_the_program() -> None:
    names = [experiment.name for experiment in jobs.experiments()]
    assert names == sorted(names) and "match" in names
    match = next(e for e in jobs.experiments() if e.name == "match")
    minutes = next(p for p in match.parameters if p.name == "minutes")
    assert (minutes.kind, minutes.values) == ("number", ("10",))
    assert jobs.select("3..4") == experiment("list", "--seeds", "3..4").splitlines()


def test_results_and_figures_are_the_programs_bytes(expected: Path, tmp_path: Path) -> None:
    results = [jobs.measure(job) for job in some("1..12")]
    assert sorted(results) == sorted((expected / "results.jsonl").read_text().splitlines())
    (tmp_path / "a.jsonl").write_text("\n".join(results[:5]) + "\n")
    (tmp_path / "b.jsonl").write_text("\n".join(results[5:]) + "\n")
    files = [tmp_path / "b.jsonl", tmp_path / "a.jsonl"]
    assert jobs.merge(files, tmp_path / "merged.json", some("1..13")) == [
        some("13")[0] + ": has no result"
    ]
    for name in ("json", "html"):
        merged = (tmp_path / "merged").with_suffix(f".{name}").read_bytes()
        assert merged == (expected / "experiments").with_suffix(f".{name}").read_bytes()


def test_the_interpreter_runs_while_a_job_does() -> None:
    job = jobs.select("1", ["localization.robustness.bench"], ["trouble=none", "minutes=1"])[0]
    worker = threading.Thread(target=jobs.measure, args=(job,))
    worker.start()
    turns = 0
    while worker.is_alive():
        turns += 1
    assert turns > 100  # with the lock held there would be none or one


@pytest.mark.parametrize("way", [["--processes", "2"], ["--address", "local"]], ids=["processes", "ray"])
def test_a_run_gives_the_programs_bytes(way: list[str], expected: Path, tmp_path: Path) -> None:
    told = command("run", expected / "jobs", "--out", tmp_path, *way)
    assert told.returncode == 0, told.stderr
    assert "12/12 jobs" in told.stderr
    figures = (tmp_path / "experiments.json").read_bytes()
    assert figures == (expected / "experiments.json").read_bytes()
    assert (tmp_path / "experiments.html").exists()
    page = (tmp_path / "run.html").read_text()
    assert all(figure["name"] in page for figure in json.loads(figures)) and "<svg" in page
    before = (tmp_path / "results.jsonl").read_bytes()
    assert len(before.splitlines()) == 12
    told = command("run", expected / "jobs", "--out", tmp_path)
    assert "12 of 12 jobs are done" in told.stderr
    assert (tmp_path / "results.jsonl").read_bytes() == before


def test_jobs_over_ray_are_as_nice_as_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RAY_worker_niceness", raising=False)
    workers = Ray("local", 1)
    nice = workers._ray.get(workers._ray.remote(lambda: os.nice(0)).remote())
    workers.close()
    assert nice == os.nice(0)  # by default Ray adds 15


def test_a_run_goes_on_behind_half_a_line(expected: Path, tmp_path: Path) -> None:
    lines = (expected / "results.jsonl").read_text().splitlines(keepends=True)
    (tmp_path / "results.jsonl").write_text("".join(lines[:4]) + lines[4][:100])
    told = command("run", expected / "jobs", "--out", tmp_path)
    assert told.returncode == 0, told.stderr
    assert "4 of 12 jobs are done" in told.stderr
    assert "results.jsonl:5: is not a whole result" in told.stderr
    figures = (tmp_path / "experiments.json").read_bytes()
    assert figures == (expected / "experiments.json").read_bytes()


def test_results_become_parquet_and_back(expected: Path, tmp_path: Path) -> None:
    told = command("run", expected / "jobs", "--out", tmp_path, "--format", "parquet")
    assert told.returncode == 0, told.stderr
    file = tmp_path / "results.parquet"
    lines = sorted((expected / "results.jsonl").read_text().splitlines())
    assert sorted(jobs.results(file)) == lines == sorted(jobs.results(expected / "results.jsonl"))
    jobs.convert(file, tmp_path / "again.jsonl")
    assert sorted((tmp_path / "again.jsonl").read_text().splitlines()) == lines
    assert jobs.merge([file], tmp_path / "merged.json", some("1..12")) == []
    assert (tmp_path / "merged.json").read_bytes() == (expected / "experiments.json").read_bytes()
    frame = pandas.read_parquet(file)
    assert set(frame["seed"]) == set(range(1, 13)) and set(frame["experiment"]) == {"localization.robustness.bench"}
    first = json.loads(jobs.measure(some("5")[0]))["values"][0]
    row = frame[(frame["seed"] == 5) & (frame["name"] == first["name"])]
    assert list(row["value"]) == [first["value"]] and dict(row["parameters"].iloc[0])["minutes"] == "0.05"


def test_files_are_read_as_other_machines_write_them(expected: Path, tmp_path: Path) -> None:
    def rewritten(name: str) -> Path:
        text = (expected / name).read_bytes().replace(b"\n", b"\r\n")
        (tmp_path / name).write_bytes(b"\xef\xbb\xbf" + text)
        return tmp_path / name

    assert jobs.read(rewritten("jobs")) == jobs.read(expected / "jobs")
    assert jobs.results(rewritten("results.jsonl")) == jobs.results(expected / "results.jsonl")


def test_wrong_parquet_is_told(expected: Path, tmp_path: Path) -> None:
    file = tmp_path / "results.parquet"
    with pytest.raises(gt2003.Error, match="results.parquet: there is no such file"):
        jobs.results(file)
    jobs.convert(expected / "results.jsonl", file)
    whole = file.read_bytes()
    file.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(gt2003.Error, match="results.parquet: is no whole Parquet file"):
        jobs.results(file)
    import pyarrow
    import pyarrow.parquet

    pyarrow.parquet.write_table(pyarrow.table({"job": ["match seed=1"]}), file)
    with pytest.raises(gt2003.Error, match="experiment: is not a table of results"):
        jobs.results(file)
    with pytest.raises(gt2003.Error, match="nowhere"):
        jobs.convert(expected / "results.jsonl", tmp_path / "nowhere/results.parquet")


def test_a_worker_that_dies_loses_no_job() -> None:
    workers = Processes(2)
    outcomes = {}
    for outcome in workers.results(some("1..30")):
        assert outcome.job not in outcomes
        outcomes[outcome.job] = outcome
        if len(outcomes) in (2, 8):
            workers._all[-1].send_signal(signal.SIGKILL)
    workers.close()
    assert len(workers._all) == 4
    assert [json.loads(outcomes[job].result)["job"] for job in some("1..30")] == some("1..30")


def test_a_job_that_kills_its_workers_fails_alone() -> None:
    class Deadly(Processes):
        @staticmethod
        def _ask(process: subprocess.Popen[str], job: str) -> object:
            if job == deadly:
                process.kill()
            return Processes._ask(process, job)

    deadly = some("1..3")[1]
    workers = Deadly(1, retries=1)
    errors = {outcome.job: outcome.error for outcome in workers.results(some("1..3"))}
    workers.close()
    assert errors.pop(deadly) == "its worker died 2 times"
    assert list(errors.values()) == ["", ""]


def test_what_a_job_prints_is_no_answer(capfd: pytest.CaptureFixture[str]) -> None:
    class Talking(Processes):
        program = (
            "import os, gt2003._workers as w; w.jobs.measure = lambda job: "
            "(print('hello'), os.write(1, b'from C\\n'), '{}')[2]; w.serve()"
        )

    workers = Talking(1)
    outcomes = list(workers.results(["a", "b"]))
    workers.close()
    assert [(o.job, o.result, o.error) for o in outcomes] == [("a", "{}", ""), ("b", "{}", "")]
    assert capfd.readouterr().err.count("hello") == 2


@pytest.mark.parametrize(
    ("program", "error"),
    [
        ("for job in open(0): print('what', flush=True)", "its worker answered 'what'"),
        ("for job in open(0): print('[1]', flush=True)", "its worker answered '[1]'"),
        ("import os\nfor job in open(0): os.write(1, b'\\xff\\n')", "its worker answered '\ufffd'"),
        ("import gt2003._workers as w\ndef fail(job): raise MemoryError('too large')\nw.jobs.measure = fail; w.serve()", "MemoryError: too large"),
    ],
    ids=["garbage", "JSON", "bytes", "exception"],
)
def test_what_a_worker_answers_or_raises_is_an_error_of_its_job(program: str, error: str) -> None:
    class Odd(Processes):
        pass

    Odd.program = program
    workers = Odd(2)
    outcomes = {outcome.job: outcome.error for outcome in workers.results(["a", "b", "c"])}
    workers.close()
    assert outcomes == {"a": error, "b": error, "c": error}


def test_a_run_without_workers_ends() -> None:
    class Refused(Processes):
        def _start(self) -> subprocess.Popen[str]:
            raise OSError(24, "Too many open files")

    with pytest.raises(gt2003.Error, match="no worker can be started: .*Too many open files"):
        list(Refused(3).results(["a", "b", "c", "d"]))

    class One(Processes):
        def _start(self) -> subprocess.Popen[str]:
            if self._all:
                raise OSError(24, "Too many open files")
            return super()._start()

    workers = One(3)
    assert [outcome.error for outcome in workers.results(some("1..5"))] == [""] * 5
    workers.close()


def test_a_run_without_descriptors_ends(expected: Path, tmp_path: Path) -> None:
    limited = "import resource, sys\nfrom gt2003.__main__ import main\nresource.setrlimit(resource.RLIMIT_NOFILE, (9, 9))\nsys.exit(main())"
    line = [sys.executable, "-c", limited, "run", expected / "jobs", "--out", tmp_path / "r"]
    told = subprocess.run(line, capture_output=True, text=True, timeout=300)
    assert told.returncode == 2 and "Too many open files" in told.stderr
    assert len(told.stderr.splitlines()) == 1, told.stderr


def started(*arguments: str | Path, **options: object) -> subprocess.Popen[str]:
    """Start the command, with signals as they are by default."""
    def reset() -> None:
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            signal.signal(number, signal.SIG_DFL)

    line = [sys.executable, "-m", "gt2003", *map(str, arguments)]
    return subprocess.Popen(line, text=True, preexec_fn=reset, **options)  # type: ignore[call-overload]


def await_results(folder: Path, process: subprocess.Popen[str]) -> None:
    """Wait until a job is done."""
    while process.poll() is None and not (folder.exists() and (folder / "results.jsonl").exists() and (folder / "results.jsonl").stat().st_size):
        time.sleep(0.01)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_ends_a_run_with_the_figures_of_what_is_done(number: signal.Signals, tmp_path: Path) -> None:
    (tmp_path / "list").write_text("\n".join(some("1..1000")))
    process = started("run", tmp_path / "list", "--out", tmp_path / "out", stderr=subprocess.PIPE)
    await_results(tmp_path / "out", process)
    process.send_signal(number)
    _, told = process.communicate()
    assert process.returncode == 128 + number, told
    assert "gt2003: interrupted; the same command goes on" in told and "has no result" not in told
    assert json.loads((tmp_path / "out/experiments.json").read_text())
    for name in ("run.html", "experiments.html"):
        assert " of 1000 jobs are done." in (tmp_path / "out" / name).read_text()
    assert (tmp_path / "out/results.jsonl").read_text().endswith("}\n")
    assert not (tmp_path / "out/.lock").exists()


def test_failures_are_named_on_the_page(tmp_path: Path) -> None:
    class Failing(Processes):
        @staticmethod
        def _ask(process: subprocess.Popen[str], job: str) -> Outcome | None:
            return Outcome(job, "", "<it failed>", 0) if "seed=2" in job.split() else Processes._ask(process, job)

    todo = some("1..3")
    with closing(Failing(1)) as workers:
        assert run(todo, tmp_path, workers) == 1
    note = f"1 of 3 jobs failed, the first of them: {todo[1]}: <it failed>"
    assert escape(note) in (tmp_path / "run.html").read_text()
    assert "1 of 3 jobs failed" in (tmp_path / "experiments.html").read_text()


@pytest.mark.parametrize("words", [["gt2003", "run", "--help"], ["gt2003.envs"]])
def test_nobody_who_reads_ends_programs_quietly(words: list[str]) -> None:
    line = [sys.executable, "-m", *words]
    process = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout and process.stderr
    process.stdout.close()
    assert process.stderr.read() == ""
    assert process.wait() == 128 + signal.SIGPIPE


def test_a_closed_terminal_ends_a_run(tmp_path: Path) -> None:
    (tmp_path / "list").write_text("\n".join(some("1..1000")))
    child, terminal = os.forkpty()
    if child == 0:
        signal.signal(signal.SIGHUP, signal.SIG_DFL)
        os.execv(sys.executable, [sys.executable, "-m", "gt2003", "run", str(tmp_path / "list"), "--out", str(tmp_path / "out")])
    os.read(terminal, 1)  # a line is printed once a second
    os.close(terminal)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 128 + signal.SIGHUP
    assert "Interrupted: " in (tmp_path / "out/run.html").read_text()


def test_two_runs_do_not_share_a_folder(tmp_path: Path) -> None:
    (tmp_path / "list").write_text("\n".join(some("1..1000")))
    first = started("run", tmp_path / "list", "--out", tmp_path / "out", stderr=subprocess.DEVNULL)
    await_results(tmp_path / "out", first)
    second = command("run", tmp_path / "list", "--out", tmp_path / "out")
    first.terminate()
    assert first.wait() == 128 + signal.SIGTERM
    assert second.returncode == 2
    assert second.stderr == f"gt2003: {tmp_path / 'out'}: is being written by another program or match\n"
    jobs_done = [json.loads(line)["job"] for line in (tmp_path / "out/results.jsonl").read_text().splitlines()]
    assert len(set(jobs_done)) == len(jobs_done)


def test_results_that_cannot_be_written_end_a_run_with_status_2(expected: Path, tmp_path: Path) -> None:
    (tmp_path / "results.jsonl").write_text(300_000 * "x" + "\n")  # larger than the pages
    limit = 300_001 + len((expected / "results.jsonl").read_bytes()) // 2  # of each file, as if the disk were full

    def fill() -> None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    told = command("run", expected / "jobs", "--out", tmp_path, preexec_fn=fill)
    assert told.returncode == 2
    error = f"gt2003: {tmp_path}/results.jsonl: cannot be written: File too large"
    assert told.stderr.splitlines()[-1] == error  # why the status is 2
    assert told.stderr.count(error) == 2  # and as soon as it happened
    assert json.loads((tmp_path / "experiments.json").read_text())
    assert "Stopped by an error: " in (tmp_path / "run.html").read_text()


def test_a_result_is_written_once(tmp_path: Path) -> None:
    results = Results(tmp_path / "results.jsonl")
    line = jobs.measure(some("1")[0])
    results.add(some("1")[0], line)
    results.add(some("1")[0], line)
    assert (tmp_path / "results.jsonl").read_text() == line + "\n"


def test_what_is_wrong_is_told_in_one_line(expected: Path, tmp_path: Path) -> None:
    def wrong(*arguments: str | Path) -> str:
        told = command("run", *arguments)
        assert told.returncode == 2 and told.stdout == ""
        assert len(told.stderr.splitlines()) == 1, told.stderr
        return told.stderr

    file = tmp_path / "jobs"
    assert "nowhere: No such file" in wrong("nowhere")
    file.write_text("match minutes=1\n\n# more\nmatch minuets=1\n")
    assert f"{file}:4: minuets: is not a parameter of match" in wrong(file)
    file.write_text("match commit=0\n")
    assert "is another commit than this program's" in wrong(file)
    assert "--seeds: '3..1' are not" in wrong("experiments", "--seeds", "3..1")
    assert "nothing: is neither an experiment" in wrong("experiments", "--only", "nothing")
    others = tmp_path / "others"
    others.mkdir()
    (others / "results.jsonl").write_bytes((expected / "results.jsonl").read_bytes())
    file.write_text(some("1")[0])
    assert "holds results of other jobs" in wrong(file, "--out", others)
    other = some("1")[0].partition(" commit=")[0] + " commit=0123456789ab"
    (others / "results.jsonl").write_text(json.dumps({"job": other, "values": []}) + "\n")
    assert "results of these jobs by another program, or of other files of the project" in wrong(file, "--out", others)
    assert "1.2.3.4:x: there is no Ray cluster" in wrong(file, "--out", tmp_path / "a", "--address", "1.2.3.4:x")


def test_errors_are_exceptions() -> None:
    with pytest.raises(gt2003.Error, match="there is no such experiment") as raised:
        jobs.complete("nothing seed=1")
    assert raised.value.field == "nothing"
    with pytest.raises(gt2003.Error, match="expected NAME=VALUE"):
        jobs.measure("match minutes")
    with pytest.raises(gt2003.Error, match="there is no such file"):
        jobs.merge(["nowhere"], "out.json")
