#!/usr/bin/python3
"""Four-bars through five points between two ground pivots by PHCpack (`phc -b`): the peer of five_point_four_bars.

Unknowns are both moving pivots in position 1, numbers and conjugates taken apart, and the turns T of the coupler: two equations
to each of four points. Each real four-bar of what `linkwright_bench --dump-path SAMPLES` writes is looked for among phc's roots.

usage, in bench: python3 -m peers.path_phc DUMP.json
"""

import json
import sys
import tempfile

from peers import phc

NAMES = ("x", "xx", "y", "yy", "t1", "t2", "t3", "t4")


def written(value):
    return f"({value.real:+.17e}{value.imag:+.17e}*i)"


def equation(pivot, place, x, xx, t):
    """|d + xT − a|² = |x − a|², times T: a row of the link on the pivot a."""
    a, d = pivot, place
    p, q = a.conjugate() - d.conjugate(), a - d
    constant = 2 * (d * a.conjugate()).real - abs(d) ** 2
    return (f"{written(p)}*{x}*{t}^2-{written(p)}*{x}*{t}+{written(q)}*{xx}-{written(q)}*{xx}*{t}"
            f"-{written(d)}*{xx}*{t}-{written(d.conjugate())}*{x}*{t}+{written(complex(constant))}*{t};")


def unit_of(dump):
    points = [complex(*p) for p in dump["points"] + dump["pivots"]]
    return (sum(abs(p - points[0]) ** 2 for p in points) / len(points)) ** 0.5


def system_of(dump):
    points, pivots = ([complex(*p) for p in dump[key]] for key in ("points", "pivots"))
    unit, origin = unit_of(dump), points[0]
    rows = [equation((pivot - origin) / unit, (place - origin) / unit, x, xx, f"t{j + 1}")
            for j, place in enumerate(points[1:])
            for pivot, x, xx in zip(pivots, ("x", "y"), ("xx", "yy"))]
    return f"{len(rows)}\n" + "\n".join(rows) + "\n"


def worst_difference(dump, roots):
    """Of the program's four-bars, each from the nearest root, as a share of the task's size."""
    unit, origin = unit_of(dump), complex(*dump["points"][0])
    return max(min(abs(root[0] - (complex(*x) - origin) / unit) + abs(root[2] - (complex(*y) - origin) / unit) for root in roots)
               for x, y in dump["real"])


def measure(dump, repetitions=3):
    """Milliseconds of the processor, its start included; the worst difference."""
    taken = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(repetitions):
            text, ms = phc.solve(system_of(dump), folder)
            taken.append(ms)
    return {"ms": taken, "worst_difference": worst_difference(dump, phc.roots_in(text, NAMES))}


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        print(json.dumps(measure(json.load(file)["between"]), indent=1))


if __name__ == "__main__":
    main()
