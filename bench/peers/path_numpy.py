#!/usr/bin/python3
"""Arms of a path in numpy: the peer of the map over arms from a given pivot.

At each place of the map all 32 patterns of elbows are laid, those that meet the points in order are kept, and the further
dyads of each are solved for: elimination, then the trigonometric cubic (docs/theory/path.md), all places at once. Verdicts
and the choice of the best are left out, which the program does, too. Reads what `linkwright_bench --dump-path SAMPLES` writes,
and checks its own numbers of linkages against the program's.

usage: path_numpy.py DUMP.json [REPETITIONS]
"""

import json
import sys
import time

import numpy as np

PLACES_AT_ONCE = 500
SIDES = np.array([[1 - 2 * (bits >> j & 1) for j in range(5)] for bits in range(32)], float)


def arms_in_order(points, pivot, u, v):
    """By arm that meets the points in order: place, moving pivot by point, turn of the body by point."""
    away = points - pivot
    rho = np.abs(away)
    total, difference = rho.max() / u, v * rho.min()
    link, reach = (total - difference) / 2, (total + difference) / 2
    x = (rho**2 + (link**2 - reach**2)[:, None]) / (2 * rho**2)
    y = np.sqrt(np.maximum((link[:, None] / rho) ** 2 - x**2, 0))
    moving = away * (x[:, None, :] + 1j * SIDES[None] * y[:, None, :])  # place, pattern, point
    turned = np.angle(moving[..., 1:] / moving[..., :1]) % (2 * np.pi)
    steps = np.diff(turned, axis=-1)
    place, pattern = np.nonzero((steps > 0).all(-1) | (steps < 0).all(-1))
    moving = pivot + moving[place, pattern]
    carried = (points - moving) / (points[0] - moving[:, :1])
    return place, moving, carried


def numbers_of_dyads(points, pivot, moving, carried):
    """How many further dyads each arm has."""
    a, r = points[1:] - points[0], carried[:, 1:]
    q, b = 1 - r, r * np.conj(a)
    rows = np.stack([q.real, -q.imag, b.real, -b.imag], -1)
    right = np.stack([-np.abs(a) ** 2 / 2, a.real, a.imag], -1)
    solved = np.linalg.solve(rows, np.broadcast_to(right, (*rows.shape[:2], 3)))
    zc, z = solved[:, 0] + 1j * solved[:, 1], solved[:, 2] + 1j * solved[:, 3]
    kappa, kappa_2 = (z[:, 1] - 1j * z[:, 2]) / 2, (z[:, 1] + 1j * z[:, 2]) / 2
    nu, nu_2 = (zc[:, 1] - 1j * zc[:, 2]) / 2, (zc[:, 1] + 1j * zc[:, 2]) / 2
    z0, c0 = moving[:, 0] - points[0], pivot - points[0]
    s, s_2 = np.conj(c0) * kappa - nu, z0 + np.conj(c0) * kappa_2 - nu_2
    g = s * np.conj(kappa_2)
    h = s * np.conj(kappa) + s_2 * np.conj(kappa_2) - np.conj(s_2) * kappa
    cubic = np.stack([h.real - g.real, h.imag - 3 * g.imag, h.real + 3 * g.real, h.imag + g.imag], -1)
    real = roots(cubic)
    psi = np.exp(1j * np.arctan(real))
    e = kappa[:, None] * psi + kappa_2[:, None] * np.conj(psi)
    n = -np.real((s[:, None] * psi**2 + s_2[:, None]) * np.conj(e))
    center = c0 + n / np.abs(e) ** 2 * psi
    circle = z[:, :1] + z[:, 1:2] * center.real + z[:, 2:] * center.imag
    return (np.isfinite(center) & np.isfinite(circle)).sum(-1)


def roots(cubic):
    """The real roots of cubics, NaN where there is none."""
    p = cubic[:, 1:] / cubic[:, :1]
    shift = p[:, 0] / 3
    m, k = shift**2 - p[:, 1] / 3, shift**3 - shift * p[:, 1] / 2 + p[:, 2] / 2
    alone = k**2 > m**3
    with np.errstate(invalid="ignore"):
        third = np.arccos(np.clip(k / m**1.5, -1, 1)) / 3
        three = -2 * np.sqrt(m)[:, None] * np.cos(third[:, None] + 2 * np.pi / 3 * np.arange(3))
        big = -np.sign(k) * np.cbrt(np.abs(k) + np.sqrt(np.maximum(k**2 - m**3, 0)))
        one = big + np.where(big != 0, m / np.where(big != 0, big, 1), 0)
    found = np.where(alone[:, None], np.nan, three)
    found[alone, 0] = one[alone]
    return found - shift[:, None]


def count(dump):
    """By place."""
    points = np.array([complex(*p) for p in dump["points"]])
    pivot, places = complex(*dump["pivot"]), np.array(dump["places"])
    counts = np.zeros(len(places), int)
    for begin in range(0, len(places), PLACES_AT_ONCE):
        here = places[begin:begin + PLACES_AT_ONCE]
        place, moving, carried = arms_in_order(points, pivot, here[:, 0], here[:, 1])
        np.add.at(counts[begin:begin + PLACES_AT_ONCE], place, numbers_of_dyads(points, pivot, moving, carried))
    return counts


def measure(dump, repetitions):
    """Nanoseconds of the processor a place, and the share of places whose numbers of linkages differ from the program's."""
    taken = []
    for _ in range(repetitions):
        begin = time.process_time()
        counts = count(dump)
        taken.append(1e9 * (time.process_time() - begin) / len(counts))
    return taken, float(np.mean(counts != np.array(dump["counts"])))


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        taken, differ = measure(json.load(file)["arms"], int(sys.argv[2]) if len(sys.argv) > 2 else 3)
    print(f"{min(taken):.0f} ns a place; numbers of linkages differ at {100 * differ:.2f} % of the places")


if __name__ == "__main__":
    main()
