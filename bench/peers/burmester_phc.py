#!/usr/bin/python3
"""Burmester points of five poses by PHCpack (`phc -b`): the peer of burmester_points_of_all.

Each task is written as four equations in z, z̄, c, c̄ taken for independent unknowns: no term but those that the conditions
have, so that the root count of the polyhedral homotopy is the true one, four. Compares root by root (unit vectors) with what
`linkwright_bench --dump-five COUNT` writes.

usage: burmester_phc.py DUMP.json
"""

import cmath
import json
import math
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile

NUMBER = r"\s*([-+]?\d\.\d+[Ee][-+]\d+)"
SOLUTION = re.compile(r"^solution \d+.*?(?=^==)", re.MULTILINE | re.DOTALL)
AGREEMENT = 1e-12
REAL = 1e-8  # |z̄ − conj z| of unit size below which a root stands for a real dyad


def is_installed():
    return shutil.which("phc") is not None


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


def roots_in(text):
    """(z, z̄, c, c̄) of the solutions that phc writes last."""
    last = text[text.rindex("THE SOLUTIONS"):]
    roots = []
    for solution in SOLUTION.findall(last):
        values = [re.search(rf"^ {name} :{NUMBER}{NUMBER}", solution, re.MULTILINE).groups() for name in ("z", "zz", "c", "cc")]
        roots.append([complex(float(re_part), float(im_part)) for re_part, im_part in values])
    return roots


def is_real(root):
    z, zz, c, cc = root
    return abs(zz - z.conjugate()) < REAL * (1 + abs(z)) and abs(cc - c.conjugate()) < REAL * (1 + abs(c))


def unit(vector):
    length = math.hypot(*vector)
    return [v / length for v in vector]


def apart(u, v):
    """Sine of the angle between two unit vectors."""
    return math.hypot(u[0] * v[1] - u[1] * v[0], u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2])


def worst_difference(task, roots):
    """Of the real roots, each with the nearest of ours; None where the counts differ."""
    real = [root for root in roots if is_real(root)]
    if len(real) != len(task["real"]) or len(roots) - len(real) != task["complex"]:
        return None
    pairs = [(unit((1, z.real, z.imag)), unit((1, c.real, c.imag))) for z, _, c, _ in real]
    return max((min(apart(z, circle) + apart(c, center) for z, c in pairs) for circle, center in task["real"]), default=0)


def children_time():
    """Processor's time of the programs that were run, seconds."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def solve(task, folder, option="-b"):
    """What phc writes, and the milliseconds of processor time it took, its start included."""
    given, answer = os.path.join(folder, "in"), os.path.join(folder, "out")
    with open(given, "w", encoding="ascii") as file:
        file.write(system_of(task))
    if os.path.exists(answer):
        os.remove(answer)  # phc would ask
    begin = children_time()
    subprocess.run(["phc", option, given, answer], check=True, capture_output=True)
    taken = 1e3 * (children_time() - begin)
    with open(answer, encoding="ascii") as file:
        return file.read(), taken


def median(values):
    return sorted(values)[len(values) // 2] if values else None


def measure(tasks):
    """Milliseconds a task (with and without starting the program), roots found, worst difference, tasks that differ.

    Where the roots differ by more than 1e-12, phc is asked again in double-double precision: who is off?
    """
    taken, inside, roots_found, differences, again = [], [], 0, [], 0
    with tempfile.TemporaryDirectory() as folder:
        for task in tasks:
            text, ms = solve(task, folder)
            taken.append(ms)
            inside.append(1e3 * float(re.findall(r"User time in seconds was\s+([\d.]+)", text)[-1]))
            roots = roots_in(text)
            roots_found += len(roots)
            difference = worst_difference(task, roots)
            if difference is None or difference > AGREEMENT:
                again += 1
                difference = worst_difference(task, roots_in(solve(task, folder, "-b2")[0]))
            differences.append(difference)
    same = [d for d in differences if d is not None]
    return {
        "tasks": len(tasks),
        "ms_per_task": median(taken),
        "ms_per_task_inside": median(inside),
        "roots_found": roots_found,
        "tasks_whose_counts_differ": len(differences) - len(same),
        "asked_again_in_double_double": again,
        "median_difference": median(same),
        "worst_difference": max(same, default=None),
    }


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        print(json.dumps(measure(json.load(file)), indent=1))


if __name__ == "__main__":
    main()
