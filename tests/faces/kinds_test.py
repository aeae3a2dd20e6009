"""Three positions, five positions and functions from outside: solved, told in words, written, drawn, exported."""

import re
import unittest

from face_support import ROOT, FaceTest, load, run
from solve_support import SolveTest

FORMATS = ("svg", "dxf", "csv", "json")


def poses(*numbers):
    return [dict(zip(("x", "y", "theta_deg"), pose)) for pose in numbers]


def motion(listed, **more):
    return {"linkwright": 1, "title": "A task", "task": {"kind": "motion", "mechanism": "four_bar", "poses": listed} | more}


def function(**members):
    return {"linkwright": 1, "title": "A task", "task": {"kind": "function", "mechanism": "four_bar"} | members}


THREE = poses((0, 0, 0), (50, 30, 30), (60, 90, 80))
FIVE = poses((0, 0, 0), (30, 10, 25), (55, 40, 40), (60, 75, 75), (40, 100, 110))
PAIRS = [{"input_deg": a, "output_deg": b} for a, b in ((0, 0), (30, 10), (50, 30), (70, 70))]
SQUARE = {"expression": "x^2", "x": [0, 1], "input_range_deg": [0, 90], "output_range_deg": [0, 90], "points": 4}


class Kinds(SolveTest):
    def check_exports(self, result, count):
        """The first linkage in every format; analyze reads the JSON, and it holds so many poses."""
        for form in FORMATS:
            target = self.folder / f"linkage.{form}"
            ran = run("export", self.folder / "result.json", "--linkage", 1, "--format", form, "-o", target)
            self.assertEqual((ran[0], ran[2]), (0, ""))
            self.assertGreater(target.stat().st_size, 500)
        linkage = load(self.folder / "linkage.json")
        self.assertEqual(len(linkage["poses"]), count)
        self.assertEqual(linkage["linkage"], result["linkages"][0])
        status, words, error = run("analyze", self.folder / "linkage.json")
        self.assertEqual((status, error), (0, ""))
        self.assertIn("Type: ", words)

    def test_three_positions(self):
        result, words, picture = self.solve(ROOT / "examples/latch.json")
        self.assertIsNone(result["curve"])
        self.assertIn("three positions (P-P-P), grounded links 18 and 24", words)
        self.assertIn("2 parameters are free, the axes of the solution region", words)
        self.assertNotIn("our positions", words + picture)
        self.check_exports(result, 3)

    def test_a_length_left_open_is_chosen_and_told(self):
        given = motion(THREE, given={"side_length": 80})
        result, words, _ = self.solve(given, "--samples", 60)
        chosen = result["linkages"][0]["lengths"]["output"]
        self.assertIn("3 parameters are free, 2 of them the axes of the solution region", words)
        self.assertRegex(words, rf"the length {chosen:.4g} of the output link was chosen")

    def test_other_givens_of_three_positions(self):
        for given, quantities, said in (
                ({"side_angle_deg": 60, "directed": False}, ["side_direction", "side_length"], "lines of the grounded links at 60°"),
                ({"side_angle_deg": 60, "directed": True, "input_length": 70}, ["side_direction", "side_length"], "input 70"),
                ({"instant_center": [-20, 120]}, ["curve_coordinate"] * 2, "instant centre (-20, 120)")):
            with self.subTest(given):
                result, words, _ = self.solve(motion(THREE, given=given), "--samples", 60, "--region")
                self.assertEqual([axis["quantity"] for axis in result["region"]["axes"]], quantities)
                self.assertIn(said, words)
                self.assertTrue(result["linkages"])
                self.assertTrue(all(linkage["verified_by_driving"] for linkage in result["linkages"]))

    def test_places_without_side_links_are_no_sliders(self):
        result, words, _ = self.solve(motion(THREE, given={"side_angle_deg": 60, "input_length": 70}), "--samples", 60)
        empty = result["region"]["counts"]["degenerate"]
        self.assertGreater(empty, 0)
        self.assertIn(f"four-bars, and none in {f'{empty:,}'.replace(',', ' ')} cells.", words)
        self.assertNotIn("slider", words)

    def test_five_positions(self):
        result, words, picture = self.solve(ROOT / "examples/nose_gear.json", "--region")
        self.assertEqual([dyad["multiplicity"] for dyad in result["dyads"]], [1, 1, 1, 1])
        self.assertEqual(len(result["pairs"]), 6)
        self.assertEqual(result["freed"], [])
        self.assertIn("five positions (P-P-P-P-P): 4 Burmester points", words)
        self.assertIn("Dyads of all five positions", words)
        for pair in result["pairs"]:
            self.assertEqual("reason" in pair, any(pair["defects"].values()))
            self.assertIn(pair.get("reason", ""), words)
        self.assertIn("every cell is a pair of dyads", picture)
        self.check_exports(result, 5)

    def test_five_positions_without_answer_have_ways_out(self):
        result, words, picture = self.solve(motion(FIVE))
        self.assertEqual((result["status"], result["linkages"]), ("solved", []))
        self.assertIn("Why they fail", words)
        ways = [way for way in result["freed"] if way["linkage"]]
        self.assertTrue(ways)
        for way in ways:
            self.assertRegex(words, rf"Relax position {way['pose']}: the nearest four-bar free of defects is off by ")
        self.assertIn("Alternative: without position ", picture)

        # The way named is open: the same four-bars, with what they miss.
        pose = ways[0]["pose"]
        self.assertIn(f'"freed_pose": {pose}', words)
        freed, words, _ = self.solve(motion(FIVE, freed_pose=pose), "--samples", 80)
        self.assertTrue(freed["linkages"])
        self.assertIn("Position and orientation error at the relaxed position", words)
        least = ways[0]["miss"]["combined"]
        self.assertTrue(all(linkage["miss"]["combined"] > 0.999 * least for linkage in freed["linkages"]))
        self.check_exports(freed, 4)

    def test_linkages_without_position_1_are_told_in_position_2(self):
        box = {"x": [-300, 300], "y": [-300, 300]}
        freed = motion(FIVE, freed_pose=1) | {"requirements": {"no_defects": False, "moving_pivots_within": box}}
        result, words, picture = self.solve(freed, "--samples", 60)
        self.assertTrue(result["linkages"])
        self.assertIn("moving pivots (position 2) in x -300…300", words)
        self.assertIn("moving pivots as they lie in position 2", words)
        self.assertNotIn("position 1)", words)
        self.assertIn("its moving pivot, position 2", picture)
        self.assertNotIn("pivot, position 1", picture)

    def test_five_positions_without_side_links_are_an_answer(self):
        listed = poses((0, 0, 0), (6, -33, 50), (-38, -46, -100), (13, -23, -20), (36, 5, 10))
        result, words, _ = self.solve(motion(listed))
        self.assertEqual((result["status"], result["dyads"], result["pairs"]), ("no_solution", [], []))
        self.assertIn("no Burmester point", words)
        self.assertTrue(result["freed"])

    def test_a_function(self):
        result, words, picture = self.solve(ROOT / "examples/sine_generator.json")
        self.assertIn("function sin_deg on 4 precision points", words)
        self.assertIn("In simulation over the range, the output is exact at every pair", words)
        for linkage in result["linkages"]:
            self.assertIs(linkage["verified_by_driving"], True)
            self.assertLess(linkage["precision_error_deg"], 1e-9)
            curve = linkage["error_curve"]
            largest = max(abs(error) for error in curve["error_deg"])
            self.assertLessEqual(largest, linkage["max_structural_error_deg"] * (1 + 1e-9))
            self.assertGreater(largest, 0.98 * linkage["max_structural_error_deg"])
        errors = [linkage["max_structural_error_deg"] for linkage in result["linkages"]]
        self.assertEqual(errors, sorted(errors))
        self.assertIn("Structural error of linkage 1", picture)
        self.check_exports(result, 4)

    def test_a_function_that_is_not_reached_says_where(self):
        result, words, _ = self.solve(function(function=SQUARE), "--samples", 120)
        short = [linkage for linkage in result["linkages"] if linkage["unreached_deg"]]
        self.assertTrue(short)
        for low, high in short[0]["unreached_deg"]:
            self.assertIn(f"not {low:.2f}°…{high:.2f}°", words)

    def test_a_free_number_is_told(self):
        free = {"number": "output_scale", "range": [0.5, 2]}
        result, words, _ = self.solve(function(pairs=PAIRS, free=free), "--samples", 30, "--region")
        self.assertIn("the output scale free", words)
        axis = result["region"]["axes"][1]
        self.assertEqual((axis["quantity"], len(axis["values"])), ("output_scale", 30))
        for linkage in result["linkages"]:
            self.assertIsNone(linkage["max_structural_error_deg"])
            self.assertTrue(0.5 <= linkage["free_value"] <= 2)

    def test_five_precision_points(self):
        result, words, picture = self.solve(ROOT / "examples/log_generator.json")
        self.assertEqual(len(result["pairs"]), len(result["region"]["input_coordinate"]))
        self.assertIn("on 5 precision points", words)
        self.assertIn("every cell is one four-bar", picture)
        self.check_exports(result, 5)

    def test_linkages_of_other_kinds_are_refused_by_name(self):
        path = self.write("linkage.json", {"mechanism": "slider_crank"})
        self.assert_mistake(run("analyze", path), "mechanism", "six_bar", "four_bar", "spherical_four_bar", "slider_crank")


class Pictures(FaceTest):
    EXAMPLES = {"three_positions": "latch", "five_positions": "nose_gear", "function": "sine_generator", "spherical": "folding_wing"}

    def test_those_of_the_documents_are_the_programs(self):
        """Byte for byte, but for the map, which is packed by the machine's own zlib."""
        def without_map(path):
            return re.sub(r"base64,[A-Za-z0-9+/=]*", "", path.read_text(encoding="utf-8"))

        for picture, example in self.EXAMPLES.items():
            fresh = self.folder / f"{picture}.svg"
            self.assertEqual(run("solve", f"examples/{example}.json", "--svg", fresh, cwd=ROOT)[0], 0)
            self.assertEqual(without_map(fresh), without_map(ROOT / f"docs/{picture}.svg"),
                             f"renew it: linkwright solve examples/{example}.json --svg docs/{picture}.svg")


if __name__ == "__main__":
    unittest.main()
