"""The package as others get it: as a wheel, with types, and its examples."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import gt2003

BUILD = Path(os.environ["GT_BUILD"])
PYTHON = Path(__file__).resolve().parents[1]


def run(*command: str | Path, cwd: Path, path: str = "") -> str:
    environment = {**os.environ, "PYTHONPATH": path}
    done = subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_wheel_runs_in_a_fresh_environment(tmp_path: Path) -> None:
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    run(
        *pip,
        *("wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", tmp_path),
        *("--config-settings", f"cmake.define.GT_BUILD={BUILD}", PYTHON),
        cwd=tmp_path,
    )
    (wheel,) = tmp_path.glob("gt2003-*.whl")
    run(sys.executable, "-m", "venv", "--without-pip", tmp_path / "fresh", cwd=tmp_path)
    python = tmp_path / "fresh/bin/python"
    run(*pip, "--python", python, "install", "--no-deps", wheel, cwd=tmp_path)
    # What it depends on is NumPy, which need not be fetched again.
    numpy = sysconfig.get_path("purelib")
    code = (
        f"import sys; sys.path.append({numpy!r}); import gt2003; "
        "m = gt2003.Match(); m.run(1); print(gt2003.__file__, m.score)"
    )
    told = run(python, "-c", code, cwd=tmp_path)
    assert told.startswith(str(tmp_path / "fresh")) and told.endswith("(0, 0)\n")


def test_the_first_match_is_played(tmp_path: Path) -> None:
    path = os.environ["PYTHONPATH"]
    told = run(
        sys.executable, PYTHON / "examples/first_match.py", "--minutes", "0.2", cwd=tmp_path, path=path
    )
    assert "red 0 : 0 blue" in told
    assert "red1" in told


def test_stubs_are_there_for_all() -> None:
    folder = Path(gt2003.__file__).parent
    assert (folder / "py.typed").exists()
    for module, names in (
        ("_core", ["Match", "Robot", "Module"]),
        ("representations", gt2003.representations.__all__),
        ("modules", [name for name in gt2003.modules.__all__ if name not in ("Module", "solutions")]),
    ):
        text = (folder / f"{module}.pyi").read_text()
        compile(text, f"{module}.pyi", "exec")
        for name in names:
            assert f"class {name}" in text, name
