#!/usr/bin/python3
"""Forces of the hand in numpy: the peer that the map of loads is measured against.

Four-bars in the positions of a body that weighs: the hand's force by virtual work over the projective twist, largest over
the positions, vectorised over blocks that stay in the cache. Reads what `linkwright_bench --dump-loads SAMPLES` writes, and
checks its own forces against the engine's, which are those at the positions where no parabola stands above them.

usage: loads_numpy.py DUMP.json [REPETITIONS]
"""

import json
import sys
import time

import numpy as np

LINKAGES_PER_BLOCK = 4000


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def largest_forces(dump, linkages):
    """At the positions, by linkage."""
    input_fixed, output_fixed, input_1, output_1, sense = linkages
    x_1, y_1, angle_1 = dump["poses"][0]
    center, handle = complex(*dump["center"]), complex(*dump["handle"])
    largest = np.full(len(sense), -np.inf)
    twist_sense = None
    for x, y, angle in dump["poses"]:
        turn = np.exp(1j * (angle - angle_1))
        origin = complex(x, y)
        a = origin + turn * (input_1 - complex(x_1, y_1))
        alpha, h = a - input_fixed, turn * (output_1 - input_1)
        beta = a + h - output_fixed
        if twist_sense is None:
            twist_sense = sense * np.sign(cross(beta, h))
        input_rate, coupler_rate = twist_sense * cross(beta, h), twist_sense * cross(alpha, beta)
        axes = np.exp(1j * angle)
        power = -dump["weight"] * (input_rate * alpha + coupler_rate * (origin + center * axes - a)).real
        way = input_rate * alpha + coupler_rate * (origin + handle * axes - a)
        np.maximum(largest, -power / np.sqrt(way.real**2 + way.imag**2), out=largest)
    return largest


def measure(dump, repetitions):
    """Nanoseconds of the processor a linkage, by repetition; the forces are the engine's, or this raises."""
    table = np.array([[complex(*link[k]) for link in dump["linkages"]] for k in range(4)])
    sense = np.array([link[4] for link in dump["linkages"]], float)
    taken = []
    for _ in range(repetitions):
        begin = time.process_time()
        ours = np.concatenate([largest_forces(dump, [*table[:, k:k + LINKAGES_PER_BLOCK], sense[k:k + LINKAGES_PER_BLOCK]])
                               for k in range(0, len(sense), LINKAGES_PER_BLOCK)])
        taken.append(1e9 * (time.process_time() - begin) / len(sense))
        # The engine's parabola may stand above the stations, never below them.
        off = np.array(dump["forces"]) - ours
        if not off.min() > -1e-3 or not np.median(np.abs(off)) < 1e-3:
            raise SystemExit(f"forces are off by {off.min():.3g} … {off.max():.3g} N")
    return taken


def main(path, repetitions="5"):
    with open(path, encoding="utf-8") as file:
        taken = measure(json.load(file), int(repetitions))
    print("ns a linkage:", ", ".join(f"{ns:.1f}" for ns in taken))


if __name__ == "__main__":
    main(*sys.argv[1:])
