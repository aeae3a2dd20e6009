#!/usr/bin/python3
"""Six-bars of all eleven rows for the loader bucket: many searches of each, the best of all with their maps.

usage: script/atlas/six_bars.py [--searches N] [--effort CHAINS] [-o FOLDER]; 11 · N · CHAINS chains in all, 22 million
of them where nothing is said: 110 times the effort of one search"""

import json
from pathlib import Path

from swept import ATLAS, arguments, example, linkages_with, run, swept, write_table

ROWS = ["0-2 0-3", "0-2 1-3", "0-2 4-3", "1-3 0-3", "1-3 0-2", "1-3 0-4", "0-3 0-2", "0-3 1-3", "0-3 1-4", "0-3 2-4", "0-3 0-3"]
JOINTS = [f"joints.{joint}[{k}]" for joint in ("a", "b", "d", "c4", "z4", "c5", "z5") for k in (0, 1)]
PLACE = ["added[0].coordinate", "added[1].coordinate"]
KEPT = ["topology", "type", "drive", "driver_sweep_deg", "min_transmission_angle_deg", "link_ratio", *JOINTS, *PLACE]


def search(row, effort):
    """The loader bucket with the links of a row."""
    problem = example("loader_bucket")
    problem["task"]["added"] = row.split()
    problem["options"].update(effort=effort, seed=1)
    return problem


def map_of(found, at=None):
    """The problem in which the chain of a six-bar found is given; with `at` its place of the map alone."""
    problem = search(found["row"], 1)
    box = problem.pop("options")["box"]
    problem["title"] = f"Loader bucket, {found['row'].replace(' ', ' and ')}"
    problem["task"]["chain"] = {name: [float(found[f"joints.{name}[{k}]"]) for k in (0, 1)] for name in "abd"}
    problem["requirements"]["moving_pivots_within"] = box
    if at:
        problem["options"] = {"at": at, "region_samples": 8}
    return problem


def alike(one, other):
    """All hinges within 5 mm: the same six-bar, found twice."""
    return all(abs(one[name] - other[name]) < 5 for name in JOINTS)


def best_of(rows, count):
    kept = []
    for row in sorted(rows, key=lambda row: -row["min_transmission_angle_deg"]):
        if len(kept) < count and not any(alike(row, other) for other in kept):
            kept.append(row)
    return kept


def searched(options, row):
    """(the summary of a row, its best six-bars)"""
    table = swept(options, f"six_bars_{row.replace(' ', '_')}", search(row, options.effort), {"method": "grid"},
                  [{"name": "seed", "at": "/options/seed", "from": 1, "to": options.searches, "count": options.searches, "whole": True}],
                  {"linkages": 3, "columns": KEPT})
    found = [{"row": row, **linkage} for linkage in linkages_with(table, "seed")]
    with_any = len(set(table["linkages"]["sample"]))
    angles = [linkage["min_transmission_angle_deg"] for linkage in found]
    summary = {"row": row, "searches": options.searches, "chains": options.searches * options.effort,
               "searches_with_six_bars": with_any, "six_bars": len(found), "best_angle_deg": max(angles, default=float("nan"))}
    return summary, best_of(found, options.best)


def draw(options, folder, found):
    """The map of a six-bar's chain: the problem, and the program's picture of its answer."""
    path = folder / f"{found['row'].replace(' ', '_')}.json"
    path.write_text(json.dumps(map_of(found), indent=1) + "\n", encoding="utf-8")
    run(options.program, "solve", path, "--samples", 60, "--svg", path.with_suffix(".svg"))


def main():
    parser = arguments(__doc__)
    parser.add_argument("--searches", type=int, default=10)
    parser.add_argument("--effort", type=int, default=200_000)
    parser.add_argument("--best", type=int, default=5)
    parser.add_argument("-o", "--output", type=Path, default=ATLAS)
    options = parser.parse_args()
    answers = [searched(options, row) for row in ROWS]
    maps = options.output / "six_bar_maps"
    maps.mkdir(parents=True, exist_ok=True)
    write_table(options.output / "six_bar_rows.csv", list(answers[0][0]), [summary for summary, _ in answers])
    best = [row for _, rows in answers for row in rows]
    write_table(options.output / "six_bars.csv", ["row", "seed", *KEPT], best)
    for _, rows in answers:
        for found in rows[:1]:
            draw(options, maps, found)


if __name__ == "__main__":
    main()
