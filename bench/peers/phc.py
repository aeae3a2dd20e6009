"""What the peers that ask PHCpack have in common: running `phc`, reading its roots, comparing them with ours."""

import math
import os
import re
import resource
import shutil
import subprocess
import tempfile

NUMBER = r"\s*([-+]?\d\.\d+[Ee][-+]\d+)"
SOLUTION = re.compile(r"^solution \d+.*?(?=^==)", re.MULTILINE | re.DOTALL)
AGREEMENT = 1e-12


def is_installed():
    return shutil.which("phc") is not None


def roots_in(text, names):
    """The values of the unknowns in each of the solutions that phc writes last."""
    last = text[text.rindex("THE SOLUTIONS"):]
    roots = []
    for solution in SOLUTION.findall(last):
        values = [re.search(rf"^ {name} :{NUMBER}{NUMBER}", solution, re.MULTILINE).groups() for name in names]
        roots.append([complex(float(re_part), float(im_part)) for re_part, im_part in values])
    return roots


def unit(vector):
    length = math.hypot(*vector)
    return [v / length for v in vector]


def apart(u, v):
    """Sine of the angle between two unit vectors."""
    return math.hypot(u[0] * v[1] - u[1] * v[0], u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2])


def children_time():
    """Processor's time of the programs that were run, seconds."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def solve(system, folder, option="-b"):
    """What phc writes about a system of equations, and the milliseconds of processor time it took, its start included."""
    given, answer = os.path.join(folder, "in"), os.path.join(folder, "out")
    with open(given, "w", encoding="ascii") as file:
        file.write(system)
    if os.path.exists(answer):
        os.remove(answer)  # phc would ask
    begin = children_time()
    subprocess.run(["phc", option, given, answer], check=True, capture_output=True)
    taken = 1e3 * (children_time() - begin)
    with open(answer, encoding="ascii") as file:
        return file.read(), taken


def median(values):
    return sorted(values)[len(values) // 2] if values else None


def measure(tasks, system_of, names, worst_difference):
    """By the peer's own system_of(task), names of its unknowns and worst_difference(task, roots), None where the counts
    differ: milliseconds a task (with and without starting the program), roots found, worst difference, tasks that differ.

    Where the roots differ by more than 1e-12, phc is asked again in double-double precision: who is off?
    """
    taken, inside, roots_found, differences, again = [], [], 0, [], 0
    with tempfile.TemporaryDirectory() as folder:
        for task in tasks:
            text, ms = solve(system_of(task), folder)
            taken.append(ms)
            inside.append(1e3 * float(re.findall(r"User time in seconds was\s+([\d.]+)", text)[-1]))
            roots = roots_in(text, names)
            roots_found += len(roots)
            difference = worst_difference(task, roots)
            if difference is None or difference > AGREEMENT:
                again += 1
                difference = worst_difference(task, roots_in(solve(system_of(task), folder, "-b2")[0], names))
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
