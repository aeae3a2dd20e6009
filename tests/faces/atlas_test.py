"""The atlases in data/atlas: rows solved again by the program, and each generator twice to the same bytes."""

import json
import random
import subprocess
import sys
import unittest
from pathlib import Path

from face_support import CLI, ROOT, FaceTest, run
from straight_support import TASKS, Tracer

SCRIPTS, ATLAS = ROOT / "script/atlas", ROOT / "data/atlas"
sys.path.insert(0, str(SCRIPTS))

try:
    import learning
    import robust
    import six_bars
    import straight_lines
    import swept
except ImportError:
    swept = None


def member(linkage, name):
    """A column of a linkage of a result: lengths.ground, joints.a[0]."""
    for part in name.replace("[", ".").replace("]", "").split("."):
        linkage = linkage[int(part) if part.isdigit() else part]
    return linkage


def over_the_stroke(row):
    """The path of a row of straight lines from one end of the stroke to the other, joints found as meets of circles."""
    pivots = {name: [row[f"pivots.{name}[{k}]"] for k in (0, 1)]
              for name in ("input_fixed", "input_moving", "output_moving", "output_fixed", "point")}
    tracer = Tracer({"pivots": pivots}, {"direction_deg": 0})
    points = [complex(*point) + tracer.start for sense in (1, -1) for point in tracer.path(sense, 2e-4, 1)]
    return [point for point in points if abs(point.real) <= 0.5]


@unittest.skipIf(swept is None, "h5py and numpy are missing")
class AtlasTest(FaceTest):
    def solved(self, problem):
        result = self.folder / "result.json"
        result.unlink(missing_ok=True)
        status, _, error = run("solve", self.write("problem.json", problem), "-o", result)
        self.assertEqual((status, error), (0, ""))
        return json.loads(result.read_text(encoding="utf-8"))["linkages"]

    def rows(self, name, count=None, test=lambda row: True):
        rows = [row for row in swept.read_table(ATLAS / name) if test(row)]
        return random.Random(7).sample(rows, count) if count else rows

    def assert_alike(self, linkage, row, names, tolerance):
        for name in names:
            value, kept = member(linkage, name), row[name]
            if isinstance(kept, float):
                self.assertAlmostEqual(float(value), kept, delta=tolerance * max(1, abs(kept)), msg=name)
            else:
                self.assertEqual("" if value is None else value, kept, name)

    def made_twice(self, script, outputs, *words):
        """What the generator writes at a small size, two times."""
        def made(folder):
            for output in outputs.values():
                (self.folder / folder / output).parent.mkdir(parents=True, exist_ok=True)
            paths = [word for option, output in outputs.items() for word in (option, str(self.folder / folder / output))]
            done = subprocess.run([sys.executable, SCRIPTS / script, "--program", CLI, "--work", self.folder / folder / "work", *paths,
                                   *map(str, words)], capture_output=True, text=True, timeout=600, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            return {path.relative_to(self.folder / folder): path.read_bytes() for path in sorted((self.folder / folder).rglob("*"))
                    if path.is_file() and "work" not in path.parts}
        once, again = made("once"), made("again")
        self.assertEqual(once, again)
        self.assertTrue(once and all(once.values()))
        return once


class SixBars(AtlasTest):
    def test_stand_on_the_maps_of_their_chains(self):
        for row in self.rows("six_bars.csv", 4):
            linkage, = self.solved(six_bars.map_of(row, [row[name] for name in six_bars.PLACE]))
            self.assert_alike(linkage, row, ["topology", "type", "min_transmission_angle_deg", *six_bars.JOINTS], 1e-6)

    def test_every_row_that_has_any_has_a_map(self):
        best = {row["row"]: row["best_angle_deg"] for row in self.rows("six_bar_rows.csv")}
        self.assertEqual(list(best), six_bars.ROWS)
        found = self.rows("six_bars.csv")
        self.assertEqual({row["row"] for row in found}, {row for row, angle in best.items() if angle})
        for row in {row["row"] for row in found}:
            self.assertEqual(max(other["min_transmission_angle_deg"] for other in found if other["row"] == row), best[row])
            self.assertTrue((ATLAS / f"six_bar_maps/{row.replace(' ', '_')}.svg").exists())

    def test_are_the_same_when_made_again(self):
        made = self.made_twice("six_bars.py", {"-o": "."}, "--searches", 1, "--effort", 400)
        self.assertIn(Path("six_bar_rows.csv"), made)


class StraightLines(AtlasTest):
    def test_run_as_straight_as_they_say(self):
        for row in self.rows("straight_lines.csv", 25):
            points = over_the_stroke(row)
            self.assertLess(max(abs(point.imag) for point in points), 1.001 * row["deviation"])
            self.assertLess(min(point.real for point in points), -0.49)
            self.assertGreater(max(point.real for point in points), 0.49)

    def test_are_where_a_search_begins(self):
        """A search so short that it draws next to nothing finds what is as large for its stroke, whatever the stroke."""
        for row in self.rows("straight_lines.csv", 6, lambda row: row["front"] == 1):
            problem = straight_lines.problem(1)
            problem["task"].update(stroke=70, deviation=70 * row["deviation"])
            problem["requirements"].update(min_transmission_angle_deg=row["min_transmission_angle_deg"] - 2, max_length=1400)
            best = self.solved(problem)[0]
            self.assertGreater(best["stroke_over_longest"], 0.98 * row["stroke_over_longest"])

    def test_fronts_are_fronts(self):
        rows = self.rows("straight_lines.csv")
        self.assertLessEqual({row["case"] for row in rows}, {task["case"] for task in TASKS.values()})
        for row in rows:
            beaten = any(straight_lines.beats(other, row) for other in rows if other["deviation"] == row["deviation"])
            self.assertEqual(row["front"], float(not beaten))

    def test_are_the_same_when_made_again(self):
        self.made_twice("straight_lines.py", {"-o": "lines.csv", "--picture": "lines.svg"}, "--deviations", 2, "--angles", 40, "--effort", 5000)


class Robust(AtlasTest):
    def test_are_found_again(self):
        for row in self.rows("robust.csv", 3, lambda row: row["type"] != "none"):
            problem = robust.as_made(row["task"], row["question"], 120)
            problem["tolerances"]["length"] = row["half_tolerance"]
            problem["options"]["best"] = 1
            linkage, = self.solved(problem)
            self.assert_alike(linkage, row, robust.KEPT, 1e-6)

    def test_are_the_same_when_made_again(self):
        self.made_twice("robust.py", {"-o": "robust.csv"}, "--tasks", "latch", "--samples", 24)


class Learning(AtlasTest):
    def problem_of(self, row):
        poses = [tuple(row[f"{name}{k}"] for name in ("x", "y", "theta")) for k in (2, 3, 4)]
        if row["origin"] == "place":
            return learning.problem(poses, at=[row[name] for name in learning.PLACE])
        return learning.problem(poses, wanted=row["type"])

    def test_rows_are_found_again(self):
        for origin in ("place", "best"):
            for row in self.rows("learning.csv", 12, lambda row, of=origin: row["origin"] == of):
                linkage, = self.solved(self.problem_of(row))
                self.assert_alike(linkage, row, learning.LABELS[:1] + learning.LABELS[-1:] + learning.LINKAGE, 1e-4)

    def test_types_are_balanced(self):
        rows = self.rows("learning.csv")
        counts = {of: sum(row["type"] == of for row in rows) for of in learning.TYPES}
        self.assertEqual(set(counts.values()), {len(rows) // 8})
        for row in rows:
            self.assertTrue(row["origin"] == "place" or learning.is_free(row))
        text = (ATLAS / "learning_card.md").read_text(encoding="utf-8")
        for of in learning.TYPES:
            here = [sum(row["type"] == of and row["origin"] == origin for row in rows) for origin in ("place", "best")]
            self.assertIn(f"| `{of}` | {here[0]} | {here[1]} |", text)

    def test_are_the_same_when_made_again(self):
        for end in ("csv", "h5"):
            self.made_twice("learning.py", {"-o": f"data.{end}", "--card": "card.md"}, "--rows", 16, "--block", 60, "--free", 0)


class Mistakes(AtlasTest):
    def test_of_the_program_are_told(self):
        done = subprocess.run([sys.executable, SCRIPTS / "robust.py", "--program", CLI, "--work", self.folder / "work", "--tasks", "latch",
                               "--samples", "1", "-o", self.folder / "robust.csv"], capture_output=True, text=True, timeout=600, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("region_samples", done.stderr)
        self.assertFalse((self.folder / "robust.csv").exists())


if __name__ == "__main__":
    unittest.main()
