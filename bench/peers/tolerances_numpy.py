#!/usr/bin/python3
"""Linkages made with errors in numpy: the peer that the sampling of tolerances is measured against.

A planar four-bar with a point of its coupler in the positions of a body: lengths, pivots and the point off by normal
errors, each sample assembled by the triangle of coupler, output and diagonal, vectorised over blocks that stay in the
cache. Reads what `linkwright_bench --dump-tolerances SAMPLES` writes, and checks its own deviations against the engine's.

usage: tolerances_numpy.py DUMP.json [REPETITIONS]
"""

import json
import sys
import time

import numpy as np

SAMPLES_PER_BLOCK = 4000


def block(dump, random, count):
    """Squares of the errors, by position and sample; NaN where it does not assemble."""
    sigma = dump["tolerance"] / 3
    off = sigma * random.standard_normal((9, count))
    input_link, coupler, output = (dump[key] + off[i] for i, key in enumerate(("input", "coupler", "output")))
    a0 = complex(*dump["input_center"]) + off[3] + 1j * off[4]
    b0 = complex(*dump["output_center"]) + off[5] + 1j * off[6]
    arm = complex(*dump["arm"]) + off[7] + 1j * off[8]
    squares = np.empty((len(dump["positions"]), count))
    for j, position in enumerate(dump["positions"]):
        a = a0 + input_link * complex(*position["input_direction"])
        diagonal = b0 - a
        inverse = 1 / (diagonal.real**2 + diagonal.imag**2)
        along = 0.5 + 0.5 * (coupler**2 - output**2) * inverse
        across = position["assembly"] * np.sqrt(coupler**2 * inverse - along**2)
        turn = diagonal * (along + 1j * across) / coupler
        point = a + arm * turn - complex(*position["point"])
        chord = turn - complex(*position["coupler_direction"])
        angle = 2 * np.arcsin(0.5 * np.abs(chord))
        squares[j] = point.real**2 + point.imag**2 + (dump["turning_length"] * angle) ** 2
    return squares


def sampled(dump, seed):
    random, sums, count = np.random.default_rng(seed), 0, 0
    while count < dump["samples"]:
        squares = block(dump, random, min(SAMPLES_PER_BLOCK, dump["samples"] - count))
        sums, count = sums + squares.sum(1), count + squares.shape[1]
    return np.sqrt(sums / count)


def measure(dump, repetitions):
    """Nanoseconds of the processor a sample and position, by repetition; the deviations are the engine's, or this raises."""
    taken = []
    for repetition in range(repetitions):
        begin = time.process_time()
        ours = sampled(dump, repetition + 1)
        taken.append(1e9 * (time.process_time() - begin) / (dump["samples"] * len(dump["positions"])))
        off = np.abs(ours / np.array(dump["deviations"]) - 1).max()
        if not off < 0.02:
            raise SystemExit(f"deviations are off by {off:.1%}")
    return taken


def main(path, repetitions="5"):
    with open(path, encoding="utf-8") as file:
        taken = measure(json.load(file), int(repetitions))
    print("ns a sample and position:", ", ".join(f"{ns:.0f}" for ns in taken))


if __name__ == "__main__":
    main(*sys.argv[1:])
