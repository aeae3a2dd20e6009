"""What the tests share: examples, the program, answers that several look at."""

from __future__ import annotations

import json
import os
import subprocess
from functools import lru_cache
from pathlib import Path

import matplotlib
import pytest

import linkwright as lw

matplotlib.use("Agg")
TREE = Path(__file__).parents[2]
EXAMPLES = TREE / "examples"
CLI = os.environ.get("LINKWRIGHT_CLI", str(TREE / "build/release/bin/linkwright"))


def run(*words: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, check=False, timeout=1200)


def problem_of(name: str) -> dict:
    """An example as a dict (the reader of the standard library knows no comments; the library's does)."""
    return lw.read_problem(EXAMPLES / f"{name}.json")


@lru_cache(maxsize=None)
def solved(name: str, samples: int | None = None) -> lw.Answer:
    return lw.solve(EXAMPLES / f"{name}.json", samples=samples)


@pytest.fixture(scope="session")
def tailgate() -> lw.Answer:
    return solved("tailgate")


@pytest.fixture(scope="session")
def result_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The tailgate's result as the program writes it."""
    path = tmp_path_factory.mktemp("results") / "tailgate.result.json"
    done = run("solve", EXAMPLES / "tailgate.json", "-o", path)
    assert done.returncode == 0, done.stderr
    json.loads(path.read_text())
    return path
