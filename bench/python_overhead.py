"""What a call from Python costs above the same call from C++ (docs/performance.md).

The calls from C++ are those of linkwright_bench (session/hover); the same here. Run it by
script/bench's rules: a shared machine tells ratios and medians, not absolute figures.

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_overhead.py
"""

from __future__ import annotations

import json
import statistics
import subprocess
import time
from pathlib import Path
from typing import Callable

import linkwright as lw

TREE = Path(__file__).parents[1]
PLACE = 1.3125, 1.1125  # of session_bench.cpp
TURNS, CALLS = 25, 400


def microseconds(call: Callable[[], object]) -> float:
    """Of one call, the best of several rounds."""
    found = []
    for _ in range(TURNS):
        begun = time.perf_counter()
        for _ in range(CALLS):
            call()
        found.append((time.perf_counter() - begun) / CALLS * 1e6)
    return min(found)


def hover_in_cpp() -> float:
    words = ["--benchmark_filter=session/hover", "--benchmark_format=json", f"--benchmark_repetitions=7"]
    done = subprocess.run([TREE / "build/release/bin/linkwright_bench", *words], capture_output=True, text=True, check=True)
    runs = [run for run in json.loads(done.stdout)["benchmarks"] if run["run_type"] == "iteration"]
    return min(run["real_time"] for run in runs) * 1e3


def main() -> None:
    session = lw.Session(TREE / "examples/tailgate.json")
    session.explore()
    bare = lw.Session(TREE / "examples/tailgate.json")._session
    in_cpp = statistics.median(hover_in_cpp() for _ in range(3))
    compiled = microseconds(lambda: session._session.linkage(*PLACE))
    whole = microseconds(lambda: session.linkage(*PLACE))
    empty = microseconds(lambda: bare.exported(-1, -1, "csv"))
    print(f"session/hover from C++                     {in_cpp:8.1f} µs")
    print(f"  the same through the compiled module     {compiled:8.1f} µs   {compiled - in_cpp:+.1f}")
    print(f"  as a Record with arrays                  {whole:8.1f} µs   {whole - in_cpp:+.1f}")
    print(f"a call that does next to nothing           {empty:8.1f} µs")


if __name__ == "__main__":
    main()
