#!/usr/bin/python3
"""Burmester points of five poses by PHCpack (`phc -b`): the peer of burmester_points_of_all.

Each task is written as four equations in z, z̄, c, c̄ taken for independent unknowns: no term but those that the conditions
have, so that the root count of the polyhedral homotopy is the true one, four. Compares root by root (unit vectors) with what
`linkwright_bench --dump-five COUNT` writes.

usage, in bench: python3 -m peers.burmester_phc DUMP.json
"""

import cmath
import json
import math
import sys

from peers import phc
from peers.phc import apart, unit

NAMES = ("z", "zz", "c", "cc")
REAL = 1e-8  # |z̄ − conj z| of unit size below which a root stands for a real dyad


def written(value):
    return f"({value.real:+.17e}{value.imag:+.17e}*i)"


def system_of(task):
    """The conditions of the poses 2 … 5, in the working frame, as phc reads them."""
    x0, y0, theta0 = task["poses"][0]
    equations = []
    for x, y, theta in task["poses"][1:]:
        a = complex(x - x0, y - y0) / task["unit"]
        half = (theta - theta0) / 2
        r, q = cmath.exp(2j * half), -2j * math.sin(half) * cmath.exp(1j * half)
        b = r * a.conjugate()
        terms = [("*z", b), ("*zz", b.conjugate()), ("*cc", -a), ("*c", -a.conjugate()), ("*z*cc", q), ("*zz*c", q.conjugate())]
        equations.append("+".join(written(value) + name for name, value in terms) + f"+{abs(a) ** 2:.17e};")
    return "4\n" + "\n".join(equations) + "\n"


def is_real(root):
    z, zz, c, cc = root
    return abs(zz - z.conjugate()) < REAL * (1 + abs(z)) and abs(cc - c.conjugate()) < REAL * (1 + abs(c))


def worst_difference(task, roots):
    """Of the real roots, each with the nearest of ours; None where the counts differ."""
    real = [root for root in roots if is_real(root)]
    if len(real) != len(task["real"]) or len(roots) - len(real) != task["complex"]:
        return None
    pairs = [(unit((1, z.real, z.imag)), unit((1, c.real, c.imag))) for z, _, c, _ in real]
    return max((min(apart(z, circle) + apart(c, center) for z, c in pairs) for circle, center in task["real"]), default=0)


def measure(tasks):
    return phc.measure(tasks, system_of, NAMES, worst_difference)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        print(json.dumps(measure(json.load(file)), indent=1))


if __name__ == "__main__":
    main()
