"""Spherical four-bars from outside: solved, told in words, written, analysed, drawn, exported."""

import csv
import io
import math
import unittest
import xml.etree.ElementTree

from attitude_support import quaternion_of
from face_support import ROOT, load, run
from solve_support import SolveTest

WING = ROOT / "examples/folding_wing.json"
TURNS = [{"euler_deg": angles, "sequence": "zyx"} for angles in ((0, 0, 0), (6, 18, 4), (9, 36, 11), (10, 52, 21))]


def motion(orientations, **more):
    task = {"kind": "motion", "mechanism": "spherical_four_bar", "orientations": orientations} | more
    return {"linkwright": 1, "title": "A task", "task": task}


class Spherical(SolveTest):
    def solve(self, problem, *arguments):
        solved = super().solve(problem, *arguments)
        self.assertLess((self.folder / "picture.svg").stat().st_size, 300_000)
        return solved

    def export(self, form):
        target = self.folder / f"linkage.{form}"
        ran = run("export", self.folder / "result.json", "--format", form, "-o", target)
        self.assertEqual((ran[0], ran[2]), (0, ""))
        return target

    def analyze(self, linkage, *arguments):
        status, words, error = run("analyze", self.write("analysed.json", linkage), *arguments)
        self.assertEqual((status, error), (0, ""))
        self.assertTrue(all(len(line) <= 100 for line in words.splitlines()), words)
        return " ".join(words.split())

    def test_a_report_says_what_was_found(self):
        result, words, picture = self.solve(WING, "--region")
        counts = result["region"]["counts"]
        self.assertIn("four orientations about a fixed centre (P-P-P-P)", words)
        self.assertIn("Cone of moving axes: a cubic cone of two components", words)
        self.assertIn(f"{counts['defect_free']:,}".replace(",", " ") + " are free of defects", words)
        self.assertIn("fixed axes within 60° of (0, 0, 1)", words)
        best = result["linkages"][0]
        for name in ("ground", "input", "coupler", "output"):
            self.assertIn(f"{best['angles_deg'][name]:.2f}°", words)
        for axis in (best["input"]["fixed_axis"], best["output"]["moving_axis"]):
            self.assertIn(" ".join(f"{x:.4f}" for x in axis), words)
        self.assertIn(f"Linkage 1 has the largest minimum transmission angle, {best['min_transmission_angle_deg']:.2f}°", words)
        self.assertRegex(words, r"keep their angles over the orientations \(the cosines to \d.*e-1\d\)")
        self.assertIn("simulation of the motion verified every linkage listed", words)
        for name in ("G₁", "G₂", "W₁", "W₂"):
            self.assertEqual(picture.count(f">{name}</text>"), 2, name)

    def test_the_grounded_links_keep_their_angles(self):
        """Recomputed from the numbers of the result alone."""
        result, _, _ = self.solve(WING)

        def apply(q, v):
            w, x, y, z = q
            t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
            return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]

        turns = [quaternion_of(one) for one in result["problem"]["task"]["orientations"]]
        for linkage in result["linkages"]:
            for side in ("input", "output"):
                fixed, moving = linkage[side]["fixed_axis"], linkage[side]["moving_axis"]
                in_body = apply([turns[0][0], *(-x for x in turns[0][1:])], moving)
                cosines = [sum(a * b for a, b in zip(fixed, apply(q, in_body))) for q in turns]
                self.assertLess(max(cosines) - min(cosines), 1e-12)
                self.assertAlmostEqual(math.degrees(math.acos(cosines[0])), linkage[side]["angle_deg"], places=9)

    def test_exports(self):
        result, _, _ = self.solve(WING)
        linkage = load(self.export("json"))
        self.assertEqual(linkage["linkage"], result["linkages"][0])
        self.assertEqual(len(linkage["orientations"]), 4)
        rows = list(csv.DictReader(io.StringIO(self.export("csv").read_text(encoding="utf-8"))))
        self.assertEqual(sorted(row["position"] for row in rows if row["position"]), ["1", "2", "3", "4"])
        xml.etree.ElementTree.parse(self.export("svg"))
        self.assert_mistake(run("export", self.folder / "result.json", "--format", "dxf"), "--format", "sphere", "csv or json")
        words = self.analyze(linkage)
        self.assertIn("It meets all 4 orientations of the file.", words)
        self.assertIn("Triple rocker", words)

    def test_analysis_of_angles(self):
        def of(*angles):
            return {"mechanism": "spherical_four_bar", "angles_deg": dict(zip(("ground", "input", "coupler", "output"), angles))}

        words = self.analyze(of(80, 30, 70, 75))
        self.assertIn("Type: Crank-rocker (Grashof", words)
        self.assertIn("The input turns fully; it has no dead points.", words)
        self.assertIn("minimum over a full turn: ", words)
        words = self.analyze(of(80, 30, 70, 75), "--drive", "output")
        self.assertIn("driven by the file's output link", words)
        self.assertIn("Type: Rocker-crank", words)
        self.assertIn("dead point: ", words)
        for angles, kind in (((30, 80, 40, 50), "00"), ((30, 40, 50, 80), "ππ"), ((30, 40, 80, 50), "π0"), ((80, 30, 40, 50), "0π")):
            self.assertIn(f"Sub-class {kind}:", self.analyze(of(*angles)), angles)
        report = self.folder / "analysis.json"
        self.analyze(of(80, 30, 70, 75), "-o", report)
        self.assertEqual(load(report)["type"], "crank_rocker")
        table = self.folder / "motion.csv"
        self.analyze(of(80, 30, 70, 75), "-o", table)
        self.assertGreater(len(table.read_text(encoding="utf-8").splitlines()), 300)
        self.assert_mistake(run("analyze", self.write("bad.json", of(170, 20, 30, 40))), "angles_deg", "do not close")

    def test_a_place_is_listed_alone(self):
        result, words, _ = self.solve(motion(TURNS) | {"options": {"at": [0.3, 0.7]}}, "--samples", 40)
        self.assertEqual(len(result["linkages"]), 1)
        self.assertIn("The linkage there:", words)

    def test_nothing_left_has_ways_out(self):
        problem = motion(TURNS) | {"requirements": {"min_transmission_angle_deg": 89, "min_link_angle_deg": 60}}
        result, words, picture = self.solve(problem, "--samples", 60)
        self.assertEqual(result["linkages"], [])
        self.assertTrue(result["relax"])
        self.assertIn(result["reason"].split(".")[0], words)
        self.assertIn("No linkage to show", picture)

    def test_three_orientations_and_given_axes_are_one_linkage(self):
        given = {"fixed_axes": [[0, 0.2, 1], [0.6, 0, 0.9]]}
        result, words, _ = self.solve(motion(TURNS[:3], given=given) | {"requirements": {"no_defects": False}})
        self.assertIsNone(result["curve"])
        self.assertEqual((len(result["dyads"]), len(result["pairs"])), (2, 1))
        self.assertIn("Dyads of all positions", words)
        self.assertIn("given fixed axes", words)

    def test_five_orientations_are_pairs_of_dyads(self):
        result, words, picture = self.solve(ROOT / "examples/ankle_orthosis.json", "--region")
        self.assertIn("five orientations about a fixed centre", words)
        count = len(result["dyads"])
        self.assertEqual([dyad["multiplicity"] for dyad in result["dyads"]], [1] * count)
        self.assertEqual(len(result["pairs"]), count * (count - 1) // 2)
        self.assertIn("Dyads of all positions", words)
        self.assertIn("All pairs as four-bars", words)
        self.assertIn("every cell is a pair of dyads", picture)
        self.assertIn("fixed and moving axis of a dyad", picture)
        self.export("svg")

    def test_five_orientations_without_answer_have_ways_out(self):
        angles = ((-4, -25, 6), (-1, -12, 3.5), (0, 0, 0), (2.5, 11, -2), (6, 20, -5.5))
        result, words, _ = self.solve(motion([{"euler_deg": list(one), "sequence": "zyx"} for one in angles]))
        self.assertEqual(result["linkages"], [])
        ways = [way for way in result["freed"] if way["linkage"]]
        self.assertTrue(ways)
        for way in ways:
            self.assertIn(f"Relax orientation {way['orientation']}: the nearest four-bar free of defects is off by ", words)

    def test_directions_are_positions(self):
        problem = motion([TURNS[0] | {"angular_velocity": [0.1, 0.4, 0.1]}, *TURNS[1:3]]) | {"requirements": {"no_defects": False}}
        result, words, _ = self.solve(problem, "--samples", 60)
        self.assertEqual(result["pattern"], "PP-P-P")
        self.assertIn("their derivatives vanish to", words)
        self.assertTrue(all("residual_derivatives" in linkage for linkage in result["linkages"]))

    def test_orientations_about_one_axis_are_told(self):
        turns = [{"axis": [0, 0, 1], "angle_deg": angle} for angle in (0, 20, 50, 90)]
        result, words, picture = self.solve(motion(turns))
        self.assertEqual(result["status"], "degenerate")
        self.assertIn("one axis", words)
        self.assertIn("No linkage to show", picture)


if __name__ == "__main__":
    unittest.main()
