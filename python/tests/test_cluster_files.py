"""The files that start jobs on schedulers: Slurm's arrays done as Slurm does them, the others read."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
import yaml

import gt2003

BUILD = Path(os.environ["GT_BUILD"])
FOLDER = Path(__file__).resolve().parents[1] / "cluster"


@pytest.mark.parametrize("file", sorted(FOLDER.glob("*.sh")), ids=lambda file: file.name)
def test_scripts_are_bash(file: Path) -> None:
    subprocess.run(["bash", "-n", file], check=True)
    lines = file.read_text().splitlines()
    assert lines[0] == "#!/bin/bash" and lines[1].startswith("#SBATCH --")


def test_the_tasks_of_an_array_do_all_jobs_once(tmp_path: Path) -> None:
    settings = ["trouble=none", "minutes=0.1"]
    todo = gt2003.jobs.select("1..10", ["localization.robustness.bench"], settings)
    (tmp_path / "jobs").write_text("\n".join(todo) + "\n")
    environment = {**os.environ, "PATH": f"{BUILD / 'bin'}:{os.environ['PATH']}"}
    for task in (1, 2, 3, 2):  # the second one is started again
        numbers = {"SLURM_ARRAY_TASK_ID": str(task), "SLURM_ARRAY_TASK_COUNT": "3"}
        subprocess.run(
            [FOLDER / "slurm-array.sh", tmp_path / "jobs", tmp_path / "out"],
            env={**environment, **numbers},
            check=True,
            capture_output=True,
        )
    files = sorted((tmp_path / "out").glob("results-*.jsonl"))
    lines = [line for file in files for line in file.read_text().splitlines()]
    assert len(files) == 3 and sorted(lines) == sorted(map(gt2003.jobs.measure, todo))
    assert gt2003.jobs.merge(files, tmp_path / "experiments.json", todo) == []


def test_the_ray_job_is_one_of_kuberay() -> None:
    job = yaml.safe_load((FOLDER / "kuberay-job.yaml").read_text())
    assert (job["apiVersion"], job["kind"]) == ("ray.io/v1", "RayJob")
    spec = job["spec"]
    assert spec["entrypoint"].startswith("gt2003 run ") and "--address auto" in spec["entrypoint"]
    pinned = (FOLDER.parent / "requirements.txt").read_text()
    assert f"ray=={spec['rayClusterSpec']['rayVersion']} " in pinned
    groups = [spec["rayClusterSpec"]["headGroupSpec"], *spec["rayClusterSpec"]["workerGroupSpecs"]]
    for group in groups:
        (container,) = group["template"]["spec"]["containers"]
        assert container["image"] and container["resources"]["requests"]["cpu"]
