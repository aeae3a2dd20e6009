#!/usr/bin/python3
"""Paths near points by scipy: the peer of fit_curve().

Least squares from random four-bars, with the crank's angle at each point an unknown beside the nine dimensions (trust-region
reflective, sparse Jacobian left to finite differences in groups), until a time is over; where the crank's angles are given, with
their datum the tenth unknown. The best sum of squares that it finds is told; that the linkage can be driven along the points is not
asked of it.

usage: fit_scipy.py TARGET.json [SECONDS]
"""

import json
import sys
import time

import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import lil_matrix


def coupler_points(x, turns):
    """Points of the coupler at angles of the crank, NaN where the loop does not close. x: A0, B0, a, h, b, p."""
    a0, b0, p = x[0] + 1j * x[1], x[2] + 1j * x[3], x[7] + 1j * x[8]
    moving = a0 + x[4] * np.exp(1j * turns)
    across = b0 - moving
    length = np.abs(across)
    along = (length**2 + x[5] ** 2 - x[6] ** 2) / (2 * length)
    with np.errstate(invalid="ignore"):
        height = np.sqrt(x[5] ** 2 - along**2)
    coupler = (along + 1j * height) * across / length / x[5]
    return moving + p * coupler


def residuals(unknowns, points):
    off = coupler_points(unknowns[:9], unknowns[9:]) - points
    return np.nan_to_num(np.concatenate([off.real, off.imag]), nan=10.0)


def pattern(count):
    sparsity = lil_matrix((2 * count, 9 + count), dtype=int)
    sparsity[:, :9] = 1
    for j in range(count):
        sparsity[[j, count + j], 9 + j] = 1
    return sparsity


def fitted(points, seconds, input_deg=None, seed=1):
    """Least sum of squares found in the time, user's unit, and the number of starts. `input_deg`: turns of the crank to each point,
    whose datum and sense are free."""
    middle = points.mean()
    size = np.sqrt(np.mean(np.abs(points - middle) ** 2))
    scaled, random = (points - middle) / size, np.random.default_rng(seed)
    best, starts, until = np.inf, 0, time.process_time() + seconds
    sparsity = None if input_deg else pattern(len(points))
    turns = np.radians(input_deg) if input_deg else np.arange(len(points)) * 2 * np.pi / len(points)
    while time.process_time() < until:
        starts += 1
        start = np.concatenate([random.normal(0, 2, 4), np.exp(random.normal(0, 0.7, 3)), random.normal(0, 1.5, 2)])
        datum, sense = random.uniform(0, 2 * np.pi), random.choice([-1, 1])
        if input_deg:
            of = lambda x, points, sense=sense: residuals(np.append(x[:9], x[9] + sense * turns), points)
            begin = np.append(start, datum)
        else:
            of, begin = residuals, np.append(start, datum + sense * turns)
        try:
            found = least_squares(of, begin, args=(scaled,), jac_sparsity=sparsity, max_nfev=120)
        except ValueError:
            continue
        best = min(best, 2 * found.cost * size**2)
    return best, starts


def measure(path, seconds):
    of = json.load(open(path, encoding="utf-8"))
    return fitted(np.array([complex(*point) for point in of["points"]]), seconds, of.get("input_deg"))


if __name__ == "__main__":
    print(*measure(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 10.0))
