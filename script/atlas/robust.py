#!/usr/bin/python3
"""The gallery's tasks over grades of tolerance: which linkage forgives most, which transmits best among those that come
out right often enough, and how far their pivots move from one grade to the next.

usage: script/atlas/robust.py [--tasks NAME…] [--samples N] [-o FILE.csv]"""

from pathlib import Path

import numpy

from swept import ATLAS, arguments, example, linkages_with, swept, write_table

GALLERY = ["tailgate", "drawer_hinge", "dump_bucket", "landing_gear", "folding_table", "lift_platform", "hood_hinge", "corner_drawer",
           "latch", "airtight_hatch", "footrest"]
GRADES = {"IT8": 25, "IT9": 40, "IT10": 64, "IT11": 100, "IT12": 160, "IT13": 250, "IT14": 400}  # tolerance units, ISO 286-1
QUESTIONS = {"least_error": {"objective": "tolerance_error"}, "best_angle": {"objective": "min_transmission_angle"}}
LEAST_YIELD = 0.9
PIVOTS = [f"{link}.{point}_point[{k}]" for link in ("input", "output") for point in ("center", "circle") for k in (0, 1)]
KEPT = ["type", "min_transmission_angle_deg", "link_ratio", "tolerance.error", "tolerance.yield", *PIVOTS]
COLUMNS = ["task", "question", "grade", "half_tolerance", "limit", "moved", *KEPT]


def tolerance_unit(size):
    """i of ISO 286-1 for a dimension in mm, in mm."""
    return (0.45 * size ** (1 / 3) + 0.001 * size) / 1000


def size_of(problem):
    """The dimension whose grade is meant, in mm: the longest link allowed."""
    return problem["requirements"]["max_length"]


def limit_of(problem):
    """How far a pose may be off: three half tolerances of IT11."""
    return float(f"{3 * 50 * tolerance_unit(size_of(problem)):.3g}")


def as_made(task, question, samples):
    """A task of the gallery with all lengths to a tolerance and two hundredths of play."""
    problem = example(task)
    problem["tolerances"] = {"length": 0.1, "clearance": 0.02, "limit": {"position": limit_of(problem)}, "samples": 2000}
    problem["options"] = {**problem.get("options", {}), "region_samples": samples, **QUESTIONS[question]}
    if question == "best_angle":
        problem["requirements"]["min_yield"] = LEAST_YIELD
    return problem


def tolerances_of(task):
    return {grade: float(f"{units / 2 * tolerance_unit(size_of(example(task))):.4g}") for grade, units in GRADES.items()}


def moved(row, other):
    """Root mean square distance of the four pivots from those of another linkage, to a tenth of a micrometre."""
    return round(float(numpy.sqrt(sum((row[name] - other[name]) ** 2 for name in PIVOTS) / 4)), 4)


def over_grades(options, task, question):
    tolerances = tolerances_of(task)
    table = swept(options, f"robust_{task}_{question}", as_made(task, question, options.samples), {"method": "grid"},
                  [{"name": "half_tolerance", "at": "/tolerances/length", "values": list(tolerances.values())}],
                  {"linkages": 1, "columns": KEPT})
    of = {row["half_tolerance"]: row for row in linkages_with(table, "half_tolerance")}
    first, rows = None, []
    for grade, half in tolerances.items():
        row = of.get(half, {"type": "none", **{name: float("nan") for name in KEPT[1:]}})
        first = first or row
        rows.append({**row, "task": task, "question": question, "grade": grade, "half_tolerance": half,
                     "limit": limit_of(example(task)), "moved": moved(row, first)})
    return rows


def main():
    parser = arguments(__doc__)
    parser.add_argument("--tasks", nargs="+", default=GALLERY, choices=GALLERY)
    parser.add_argument("--samples", type=int, default=120, help="of the map, to a side")
    parser.add_argument("-o", "--output", type=Path, default=ATLAS / "robust.csv")
    options = parser.parse_args()
    write_table(options.output, COLUMNS, [row for task in options.tasks for question in QUESTIONS
                                          for row in over_grades(options, task, question)])


if __name__ == "__main__":
    main()
