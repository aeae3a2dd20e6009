#!/usr/bin/python3
"""Labelled data for learning: four random poses and a four-bar through them, with its type, defects and transmission
angle; as many of each of eight types. Some are wherever chance points on the map, most of them with a defect; the others
are the best of their type and free of defects.

usage: script/atlas/learning.py [--rows N] [--free SHARE] [--seed S] [-o FILE.csv|FILE.h5] [--card FILE.md]"""

import collections
import itertools
import time
from pathlib import Path

from swept import ATLAS, arguments, is_free, linkages_with, swept, write_table

TYPES = ["crank_rocker", "rocker_crank", "double_crank", "double_rocker",
         "triple_rocker_ground", "triple_rocker_input", "triple_rocker_coupler", "triple_rocker_output"]
POSES = [f"{name}{k}" for k in (2, 3, 4) for name in ("x", "y", "theta")]
LABELS = ["type", "defects.order", "defects.branch", "defects.circuit", "min_transmission_angle_deg"]
LINKAGE = [f"lengths.{link}" for link in ("ground", "input", "coupler", "output")] + [
    f"{link}.{point}_point[{k}]" for link in ("input", "output") for point in ("center", "circle") for k in (0, 1)]
PLACE = ["input.coordinate", "output.coordinate"]
COLUMNS = ["origin", *POSES, *LABELS, *LINKAGE, *PLACE]
SIDE = {"place": 8, "best": 24}  # samples of the map, to a side
WORDS = {
    "origin": "`place`: where chance points on the map; `best`: the best of its type on the map, free of defects",
    "x2 … theta4": "poses 2 to 4, x and y in units, theta in degrees; pose 1 is (0, 0, 0°)",
    "type": "Barker's type of the four-bar", "defects.*": "1 has it, 0 has not, 255 not known",
    "min_transmission_angle_deg": "over the task, degrees; empty where a defect leaves none",
    "lengths.*": "of the links, units", "*.center_point, *.circle_point": "fixed and moving pivots in position 1, units",
    "*.coordinate": "place of input and output on the map",
}


def problem(poses=None, at=None, wanted=None):
    """A task of four poses, at a place of its map or for the best linkage of a type."""
    poses = poses or [(0.5, 0, 10), (1, 0.5, 20), (0.5, 1, 30)]
    options = {"region_samples": SIDE["place" if at else "best"], "best": 1}
    return {"linkwright": 1, "title": "Four poses", "length_unit": "units",
            "task": {"kind": "motion", "mechanism": "four_bar",
                     "poses": [{"x": x, "y": y, "theta_deg": theta} for x, y, theta in [(0, 0, 0), *poses]]},
            **({"requirements": {"types": [wanted]}} if wanted else {}), "options": {**options, **({"at": at} if at else {})}}


def chance():
    """What is drawn: x and y within one unit, turns within a right angle."""
    return [{"name": f"{name}{k}", "at": f"/task/poses/{k - 1}/{name}{'_deg' if name == 'theta' else ''}", "from": -most, "to": most}
            for k in (2, 3, 4) for name, most in (("x", 1), ("y", 1), ("theta", 90))]


def at_place():
    """A coordinate runs to 1, with two branches to 2; where there is no second branch nothing is found."""
    return [{"name": f"place{k}", "at": f"/options/at/{k}", "from": 0, "to": 2} for k in (0, 1)]


def draw(options, origin, number, samples, wanted=None):
    """The linkages of one sweep; its seed is that of the data and its number."""
    table = swept(options, f"learning_{origin}_{wanted or 'any'}_{options.seed}_{number}_{samples}",
                  problem(at=[0.5, 0.5]) if origin == "place" else problem(wanted=wanted),
                  {"method": "random", "samples": samples, "seed": options.seed * 1_000_000 + number},
                  chance() + (at_place() if origin == "place" else []), {"linkages": 1, "columns": LABELS + LINKAGE + PLACE})
    return [{"origin": origin, **row} for row in linkages_with(table, *POSES) if row["type"] in TYPES]


def drawn_until(quotas, options, origin, told, wanted=None):
    """Rows in the order of drawing, of each type its quota and no more."""
    missing, number = dict(quotas), 0
    while any(missing.values()):
        number += 1
        told[origin, "drawn"] += options.block
        for row in draw(options, origin, number, options.block, wanted):
            if missing.get(row["type"], 0) and (origin == "place" or is_free(row)):
                missing[row["type"]] -= 1
                yield row


def collected(options, told):
    """All rows, one by one; `told` counts them for the card."""
    free = round(options.rows * options.free / len(TYPES))
    places = {of: options.rows // len(TYPES) - free for of in TYPES}
    parts = [drawn_until(places, options, "place", told)]
    parts += [drawn_until({of: free}, options, "best", told, of) for of in TYPES]
    for row in itertools.chain(*parts):
        told[row["origin"], row["type"]] += 1
        told.update(kind for kind in ("order", "branch", "circuit") if row[f"defects.{kind}"] == 1)
        told["free"] += is_free(row)
        yield row


def card(options, told):
    """How the data were made, what is in them."""
    rows = sum(told[origin, of] for origin in SIDE for of in TYPES)
    def share(kind):
        return f"{100 * told[kind] / max(rows, 1):.1f} %"
    lines = ["# Four poses and a four-bar through them: data for learning", "",
             f"{rows} rows, made by `script/atlas/learning.py --rows {options.rows} --free {options.free:g} --seed {options.seed}` "
             "with `linkwright sweep`.", "",
             "Poses are random and independent: x and y even in −1…1, theta in −90°…90°. `place`: a place of the map drawn evenly, rows of a "
             "type dropped once there are enough of it. `best`: for each type, the best linkage of that type on the map by transmission angle; "
             "tasks without one are dropped. Places are drawn from 0 to 2, so that curves of two branches count four times as much as "
             "those of one. So neither types nor defects are as frequent as in nature, and `best` rows have good "
             f"angles. Drawn: {told['place', 'drawn']} places, {told['best', 'drawn']} maps.", "",
             f"Free of defects: {share('free')}; order {share('order')}, branch {share('branch')}, circuit {share('circuit')}.", "",
             "| type | place | best |", "|---|---:|---:|", *[f"| `{of}` | {told['place', of]} | {told['best', of]} |" for of in TYPES], "",
             "| column | what, unit |", "|---|---|", *[f"| `{name}` | {words} |" for name, words in WORDS.items()], ""]
    return "\n".join(lines)


def main():
    parser = arguments(__doc__)
    parser.add_argument("--rows", type=int, default=480)
    parser.add_argument("--free", type=float, default=0.25, help="share of rows that are best of their type")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--block", type=int, default=500, help="samples of a sweep")
    parser.add_argument("-o", "--output", type=Path, default=ATLAS / "learning.csv")
    parser.add_argument("--card", type=Path, default=ATLAS / "learning_card.md")
    options = parser.parse_args()
    began, told = time.monotonic(), collections.Counter()
    write_table(options.output, COLUMNS, collected(options, told))
    options.card.write_text(card(options, told), encoding="utf-8")
    print(f"{options.rows} rows in {time.monotonic() - began:.1f} s")


if __name__ == "__main__":
    main()
