#!/usr/bin/python3
"""Dyads of five orientations by PHCpack (`phc -b`): the peer of five_orientation_dyads_of_all.

Each task is written as its four conditions, bilinear in the fixed axis (u, v, 1) and the moving axis (s, t, 1), so that the
root count of the polyhedral homotopy is the true one, six. Compares root by root (unit vectors) with what
`linkwright_bench --dump-five-orientations COUNT` writes.

usage, in bench: python3 -m peers.five_orientations_phc DUMP.json
"""

import json
import math
import sys

from peers import phc
from peers.phc import apart, unit

NAMES = ("u", "v", "s", "t")
REAL = 1e-8  # imaginary part of unit size below which a root stands for a real dyad


def condition_matrix(first, there):
    """(A − E) / |A − E| of the turn A from the first orientation to the other: (w [v]× + [v]×²) / √2 |v|."""
    (w1, *v1), (w2, *v2) = first, there
    w = w2 * w1 + sum(a * b for a, b in zip(v1, v2))
    x, y, z = (w1 * v2[i] - w2 * v1[i] + v1[(i + 1) % 3] * v2[(i + 2) % 3] - v1[(i + 2) % 3] * v2[(i + 1) % 3] for i in range(3))
    scale = 1 / math.sqrt(2 * (x * x + y * y + z * z))
    rows = ((-y * y - z * z, x * y - w * z, z * x + w * y),
            (x * y + w * z, -z * z - x * x, y * z - w * x),
            (z * x - w * y, y * z + w * x, -x * x - y * y))
    return [[scale * value for value in row] for row in rows]


def system_of(task):
    """The conditions of the orientations 2 … 5, as phc reads them."""
    first, *others = task["orientations"]
    equations = []
    for there in others:
        matrix = condition_matrix(first, there)
        terms = [f"{value:+.17e}{of_fixed}{of_moving}"
                 for row, of_fixed in zip(matrix, ("*u", "*v", "")) for value, of_moving in zip(row, ("*s", "*t", ""))]
        equations.append("".join(terms) + ";")
    return "4\n" + "\n".join(equations) + "\n"


def is_real(root):
    return all(abs(value.imag) < REAL * (1 + abs(value)) for value in root)


def worst_difference(task, roots):
    """Of the real roots, each with the nearest of ours; None where the counts differ."""
    real = [root for root in roots if is_real(root)]
    if len(real) != len(task["real"]) or len(roots) - len(real) != task["complex"]:
        return None
    pairs = [(unit((u.real, v.real, 1)), unit((s.real, t.real, 1))) for u, v, s, t in real]
    return max((min(apart(g, fixed) + apart(w, moving) for g, w in pairs) for fixed, moving in task["real"]), default=0)


def measure(tasks):
    return phc.measure(tasks, system_of, NAMES, worst_difference)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        print(json.dumps(measure(json.load(file)), indent=1))


if __name__ == "__main__":
    main()
