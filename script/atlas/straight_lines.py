#!/usr/bin/python3
"""Straight lines by all cases: which linkage runs straight how far for its size, how exactly, with which transmission
angle. Lengths in strokes; searched for over deviations and least transmission angles.

usage: script/atlas/straight_lines.py [--deviations N] [--angles DEG…] [--seeds N] [--effort N] [-o FILE.csv] [--picture FILE.svg]"""

from pathlib import Path

import numpy

from swept import ATLAS, ROOT, arguments, grid, linkages_with, swept, write_table

PIVOTS = [f"pivots.{pivot}[{k}]" for pivot in ("input_fixed", "input_moving", "output_moving", "output_fixed", "point") for k in (0, 1)]
MEASURES = ["case", "type", "contact_points", "stroke_over_longest", "min_transmission_angle_deg",
            *[f"lengths.{link}" for link in ("ground", "input", "coupler", "output", "point_to_input", "point_to_output")], *PIVOTS]
SHAPE = ["layer", "shape.turns", *[f"shape.numbers[{k}]" for k in range(4)]]
COLUMNS = ["deviation", "least_angle_deg", "seed", "front", *MEASURES, *SHAPE]
NAMES = {"four_point_cubic": "four points", "pole_at_fixed_pivot": "pole at a pivot", "mixed": "contacts at given places",
         "five_point": "five points", "six_point": "six points", "symmetric_lambda": "symmetric λ", "parallel_side_links": "Watt",
         "isosceles_trapezoid": "trapezoid", "ball_point_on_side_link": "Ball's point on a side link"}
COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22"]


def problem(effort):
    """The search over one stroke along the x axis, its middle at the origin."""
    return {"linkwright": 1, "title": "Straight lines", "length_unit": "strokes",
            "task": {"kind": "straight_line", "mechanism": "four_bar", "case": "search", "line": {"point": [0, 0], "direction_deg": 0},
                     "stroke": 1, "deviation": 0.001},
            "requirements": {"min_transmission_angle_deg": 20, "max_length": 20}, "options": {"seed": 1, "effort": effort}}


def beats(one, other):
    """In size and angle as good, and in one of them better."""
    gains = [one[name] - other[name] for name in ("stroke_over_longest", "min_transmission_angle_deg")]
    return min(gains) >= 0 and max(gains) > 0


def front_of(rows):
    """Those that no other beats, of those that are alike one."""
    rows = list({(row["case"], round(row["stroke_over_longest"], 3), round(row["min_transmission_angle_deg"], 1)): row for row in rows}.values())
    return [row for row in rows if not any(beats(other, row) for other in rows)]


def found(options):
    """Every linkage of every search."""
    rows = numpy.logspace(-5, -2, options.deviations)
    table = swept(options, "straight_lines", problem(options.effort), {"method": "grid"},
                  grid(deviation=("/task/deviation", rows), seed=("/options/seed", range(1, options.seeds + 1)),
                       least_angle_deg=("/requirements/min_transmission_angle_deg", options.angles)),
                  {"linkages": 200, "columns": [*MEASURES, *SHAPE]})
    return linkages_with(table, "deviation", "seed", "least_angle_deg")


def fronts(rows):
    """Of each deviation and case the front of size and angle; `front` 1 where none of any case beats it."""
    kept = []
    for deviation in sorted({row["deviation"] for row in rows}):
        of_deviation = [row for row in rows if row["deviation"] == deviation]
        best = {id(row) for row in front_of(of_deviation)}
        for case in sorted({row["case"] for row in of_deviation}):
            front = front_of([row for row in of_deviation if row["case"] == case])
            kept += [{**row, "front": int(id(row) in best)} for row in spread(front, best)]
    return kept


def spread(front, always, most=4):
    """So many along the front, and those that are wanted in any case."""
    front = sorted(front, key=lambda row: row["min_transmission_angle_deg"])
    places = {round(place) for place in numpy.linspace(0, len(front) - 1, most)}
    return [row for i, row in enumerate(front) if i in places or id(row) in always]


def text(x, y, words, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="11" fill="currentColor" {more}>{words}</text>'


def panel(rows, deviation, cases, left, top):
    """Size over angle at one deviation: a mark to a linkage, large on the front of all."""
    def place(row):
        return left + 200 * (row["min_transmission_angle_deg"] - 20) / 70, top + 150 * (1 - row["stroke_over_longest"])
    of = [row for row in rows if row["deviation"] == deviation]
    marks = [f'<circle cx="{place(row)[0]:.1f}" cy="{place(row)[1]:.1f}" r="{4 if row["front"] else 2}" '
             f'fill="{COLOURS[cases.index(row["case"]) % len(COLOURS)]}" fill-opacity="{1 if row["front"] else 0.5}"><title>{row["case"]}: '
             f'stroke / longest {row["stroke_over_longest"]:.3f}, {row["min_transmission_angle_deg"]:.1f}°</title></circle>' for row in of]
    return [f'<rect x="{left}" y="{top}" width="200" height="150" fill="none" stroke="currentColor" stroke-opacity="0.4"/>',
            text(left + 4, top + 13, f"± {deviation:.1g} of the stroke"), *marks,
            *[text(left + 200 * (angle - 20) / 70, top + 163, f"{angle}°", 'text-anchor="middle"') for angle in (20, 40, 60, 80)],
            *[text(left - 4, top + 150 * (1 - size) + 4, f"{size:g}", 'text-anchor="end"') for size in (0, 0.5, 1)]]


def picture(rows):
    """The fronts as small multiples, one panel to a deviation."""
    deviations, cases = sorted({row["deviation"] for row in rows}), sorted({row["case"] for row in rows})
    across, down = 3, -(-len(deviations) // 3)
    lines = [line for i, deviation in enumerate(deviations)
             for line in panel(rows, deviation, cases, 40 + 245 * (i % across), 20 + 190 * (i // across))]
    below = 20 + 190 * down
    lines.append(text(40, below + 10, "Stroke over the longest link, over the least transmission angle; large: no linkage beats it in both"))
    for i, case in enumerate(cases):
        x, y = 40 + 245 * (i % across), below + 32 + 16 * (i // across)
        lines += [f'<circle cx="{x}" cy="{y - 4}" r="4" fill="{COLOURS[i % len(COLOURS)]}"/>',
                  text(x + 10, y, NAMES.get(case, case.replace("_", " ")))]
    height = below + 40 + 16 * -(-len(cases) // across)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 770 {height}" font-family="sans-serif" color="#555">\n'
            + "\n".join(lines) + "\n</svg>\n")


def main():
    parser = arguments(__doc__)
    parser.add_argument("--deviations", type=int, default=7)
    parser.add_argument("--angles", type=float, nargs="+", default=[20, 35, 45, 55, 65])
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--effort", type=int, default=2_000_000)
    parser.add_argument("-o", "--output", type=Path, default=ATLAS / "straight_lines.csv")
    parser.add_argument("--picture", type=Path, default=ROOT / "docs/straight_lines_atlas.svg")
    options = parser.parse_args()
    kept = fronts(found(options))
    write_table(options.output, COLUMNS, kept)
    options.picture.write_text(picture(kept), encoding="utf-8")


if __name__ == "__main__":
    main()
