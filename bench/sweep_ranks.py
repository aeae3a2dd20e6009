#!/usr/bin/python3
"""What ranks cost a sweep: measured here with 1, 2 and 4 of them, and played through for clusters (docs/sweeps.md).

    bench/sweep_ranks.py [build/release/bin]

Three costs are measured and then played through, block by block: a fetch from the counter, what a block costs beside
its samples, and merging. The blocks of the play are drawn from the measured ones.
"""

from __future__ import annotations

import heapq
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TREE = Path(__file__).parents[1]
SETTINGS = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
            "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_mpi_yield_when_idle": "1"}
BY_MESSAGES = ["--mca", "osc", "pt2pt", "--mca", "btl", "tcp,self"]
CHAINS = TREE / "examples/sweeps/loader_bucket_effort.json"


def read_with_comments(path: Path) -> dict:
    return json.loads("\n".join(line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("//")))


def cheap(samples: int) -> dict:
    """Five precision points: the cheapest samples that there are."""
    problem = read_with_comments(TREE / "examples/log_generator.json")
    return {"linkwright": 1, "problem": problem, "sampling": {"method": "sobol", "samples": samples},
            "vary": [{"name": "pivots", "at": "/task/ground_pivots/output/0", "from": 40, "to": 80}]}


def unequal() -> dict:
    """Searches for six-bars whose dearest sample costs 64 times the cheapest, the dearest last."""
    sweep = read_with_comments(CHAINS)
    sweep["vary"][1] = {"name": "seed", "at": "/options/seed", "from": 1, "to": 24, "count": 24}
    return sweep


class Bench:
    def __init__(self, binaries: Path, folder: Path) -> None:
        self.binaries, self.folder = binaries, folder

    def seconds(self, sweep: dict, ranks: int | None, settings: list[str] = []) -> tuple[float, float]:
        """Of a sweep: all of it, and of that what comes after the last block is kept. One thread a rank."""
        file, output = self.folder / "sweep.json", self.folder / "out.h5"
        file.write_text(json.dumps(sweep), encoding="utf-8")
        launcher = ["mpirun", "-n", str(ranks), *settings, self.binaries / "linkwright-mpi"] if ranks else [self.binaries / "linkwright"]
        begun = time.perf_counter()
        process = subprocess.Popen([*launcher, "sweep", file, "-o", output, "--threads", "1", "--overwrite"],
                                   env={**os.environ, **SETTINGS}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        kept, size = begun, -1
        while process.poll() is None:
            journals = sum(path.stat().st_size for path in Path(f"{output}.partial").glob("*.journal") if path.exists())
            if journals > size:
                kept, size = time.perf_counter(), journals
            time.sleep(0.002)
        if process.returncode:
            raise SystemExit(f"{launcher} ends with {process.returncode}")
        return time.perf_counter() - begun, time.perf_counter() - kept

    def fetch_microseconds(self, ranks: int, settings: list[str] = []) -> float:
        command = ["mpirun", "-n", str(ranks), *settings, self.binaries / "linkwright_mpi_bench", "2000"]
        return float(subprocess.run(command, env={**os.environ, **SETTINGS}, capture_output=True, text=True, check=True).stdout)


def median_of(turns: int, measure) -> float:
    return statistics.median(measure() for _ in range(turns))


def play(ranks: int, blocks: list[float], fetch: float, serve: float, merge: float) -> float:
    """Seconds of a sweep: the counter serves one rank after another, a fetch is under way for `fetch` and keeps it busy
    for `serve`; then rank 0 merges."""
    free, server, end = [0.0] * ranks, 0.0, 0.0
    for cost in blocks:
        asked = heapq.heappop(free)
        server = max(server, asked) + serve
        done = max(server, asked + fetch) + cost
        end = max(end, done)
        heapq.heappush(free, done)
    return end + merge


def measure_ranks(bench: Bench) -> None:
    print("Six-bars, blocks of very unequal cost (168 samples, the dearest last), seconds:")
    alone = median_of(2, lambda: bench.seconds(unequal(), None)[0])
    print(f"  linkwright, one thread {alone:6.2f}")
    for ranks in (1, 2, 4):
        taken = median_of(2, lambda: bench.seconds(unequal(), ranks)[0])
        print(f"  linkwright-mpi, {ranks} {'ranks' if ranks > 1 else 'rank '} {taken:5.2f}   {alone / taken:.2f} times as fast")


def measure_overhead(bench: Bench) -> tuple[float, float]:
    """Seconds a sample costs and seconds that merging it costs, of cheap ones; prints the overhead of a block."""
    few, many = cheap(1280), cheap(14080)
    slopes, merges = {}, []
    for ranks in (None, 1):
        first, last = [], []
        for _ in range(3):
            first.append(bench.seconds(few, ranks)[0])
            whole, merge = bench.seconds(many, ranks)
            last.append(whole)
            merges.append(merge)
        slopes[ranks] = (statistics.median(last) - statistics.median(first)) / 12800
        print(f"  {'one rank' if ranks else 'linkwright, one thread'}: {slopes[ranks] * 1e6:.1f} µs a sample, "
              f"{statistics.median(first) - 1280 * slopes[ranks]:.2f} s to begin and end")
    print(f"  ranks add {(slopes[1] - slopes[None]) * 64e6:+.0f} µs to a block of 64 samples")
    merge = statistics.median(merges) / 14080
    print(f"  merging costs rank 0 {merge * 1e6:.2f} µs a sample")
    return slopes[None] - merge, merge


def play_clusters(sample: float, merge: float, fetch: float) -> None:
    chance = random.Random(1)
    serve = 0.5e-6  # of a network card that adds by itself, or a core that answers
    print("\nPlayed through, 64 samples a block; share of the ideal speed:")
    cases = (("precision points", 10_000_000, lambda: 64 * sample),
             ("maps of 400 × 400, 20 ms", 10_000_000, lambda: 64 * 0.020 * chance.uniform(0.7, 1.3)),
             ("six-bars, 4 to 270 ms", 10_000_000, lambda: 64 * 0.0042 * 64 ** chance.random()))
    for title, samples, cost in cases:
        blocks = [cost() for _ in range(samples // 64)]
        work = sum(blocks)
        line = []
        for ranks in (1, 64, 4096):
            taken = play(ranks, blocks, fetch, serve, merge * samples)
            computing = play(ranks, blocks, fetch, serve, 0)
            line.append(f"{ranks}: {taken:,.0f} s, {work / ranks / taken:.0%} (before merging {work / ranks / computing:.0%})")
        print(f"  {title:26} {'; '.join(line)}")


def main() -> None:
    binaries = Path(sys.argv[1] if len(sys.argv) > 1 else TREE / "build/release/bin")
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(binaries, Path(folder))
        measure_ranks(bench)
        print("Precision points, cheap samples:")
        sample, merge = measure_overhead(bench)
        print("A fetch from the counter, µs:")
        shared = median_of(3, lambda: bench.fetch_microseconds(2))
        print(f"  in shared memory {shared:.2f}; three ranks at a time {median_of(3, lambda: bench.fetch_microseconds(4)):.2f}")
        messages = median_of(3, lambda: bench.fetch_microseconds(2, BY_MESSAGES))
        print(f"  by messages, which rank 0 answers once a millisecond {messages:.1f}")
        play_clusters(sample, merge, messages * 1e-6)


if __name__ == "__main__":
    main()
