"""Kinds of inputs from public reports that were answered wrongly or not at all."""

import csv
import io
import json
import math
import unittest

from face_support import ROOT, TAILGATE, FaceTest, load, run

ROUNDED = {
    "linkwright": 1, "title": "pivots rounded to whole units",
    "poses": [{"x": 8.4, "y": 10.4, "theta_deg": 0}, {"x": 15.75307999925125, "y": 6.635448633158675, "theta_deg": 1.6616734751610893},
              {"x": 22.17995730186216, "y": 14.34686035802784, "theta_deg": 43.4681702286939},
              {"x": 12.61818756779844, "y": 15.25966971714668, "theta_deg": -270.3228804174674}],
    "pivots": {"input_center": [21, 7], "input_circle": [12, -1], "output_center": [9, 19], "output_circle": [-2, 8]}}
DOUBLE_CRANK = {
    "title": "double crank", "length_unit": "m",
    "pivots": {"input_center": [0, 0], "input_circle": [1, -3.872983346207417], "output_center": [-2, 0],
               "output_circle": [-3, -3.872983346207417]}}
KLANN = {"mechanism": "six_bar", "title": "Klann leg",
         "chain": {"a": [41.395, -26.641], "b": [36.033, -25.415], "d": [10.879, -21.918]},
         "added": [{"between": "0-2", "points": [[27.69, -19.705], [21.501, -22.089]]},
                   {"between": "0-3", "points": [[27.69, -31.092], [19.432, -32.923]]}]}
FIVE = {
    "linkwright": 1, "length_unit": "mm",
    "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
        {"x": -1.428224328, "y": 12.41993985, "theta_deg": -62.35511292533679,
         "derivatives": [{"x": 7.780161487, "y": -8.642030043, "theta": 0.2690674263}]},
        {"x": 1.314299366, "y": 7.219040281, "theta_deg": -44.777073432247676,
         "derivatives": [{"x": -7.014887641, "y": -5.079881573, "theta": 0.5129420369},
                         {"x": -49.21253937, "y": 2.019234096, "theta": 0.3492961953}]}]},
    "requirements": {"max_link_ratio": None, "max_length": None}, "options": {"best": 20}}


class Reports(FaceTest):
    def ran(self, *arguments):
        status, output, error = run(*arguments)
        self.assertEqual((status, error), (0, ""))
        return output

    def assert_as_it_is(self, table, lengths):
        rows = list(csv.DictReader(io.StringIO(table)))
        for row in rows:
            at = {name: float(row[name]) for name in row if row[name]}
            self.assertAlmostEqual(math.hypot(at["input_circle_x"] - 21, at["input_circle_y"] - 7), lengths[0], places=9)
            self.assertAlmostEqual(math.hypot(at["output_circle_x"] - 9, at["output_circle_y"] - 19), lengths[1], places=9)
        return [row for row in rows if row["position"]]

    def test_a_linkage_with_rounded_pivots_moves_as_it_is(self):
        linkage, table = self.write("rounded.json", ROUNDED), self.folder / "t.csv"
        words = self.ran("analyze", linkage, "-o", table)
        self.assertIn("As it moves the linkage misses position 2 by ", " ".join(words.split()))
        lengths = math.hypot(9, 8), math.hypot(11, 11)
        status, exported, warning = run("export", linkage, "--format", "csv")
        self.assertEqual(status, 0)
        self.assertIn("warning: as it moves the linkage misses position 2 by ", warning)
        for text in (table.read_text(), exported):
            met = self.assert_as_it_is(text, lengths)
            self.assertEqual([row["position"] for row in met], ["1", "2", "3", "4"])
            for row, pose in zip(met, ROUNDED["poses"]):
                off = math.hypot(float(row["body_x"]) - pose["x"], float(row["body_y"]) - pose["y"])
                self.assertAlmostEqual(float(row["position_error"]), off, places=9)
                turned = math.remainder(float(row["body_theta_deg"]) - pose["theta_deg"], 360)
                self.assertAlmostEqual(float(row["orientation_error_deg"]), abs(turned), places=9)
            self.assertGreater(min(float(row["position_error"]) + float(row["orientation_error_deg"]) for row in met[1:]), 0.1)
        errors = json.loads(self.ran("analyze", linkage, "-o", "-"))["position_errors"]
        self.assertEqual([error["position"] for error in errors], [2, 3, 4])

    def test_a_six_bar_with_rounded_hinges_tells_what_it_misses(self):
        result = self.folder / "result.json"
        self.ran("solve", ROOT / "examples/loader_bucket_chain.json", "--samples", 40, "-o", result)
        exact = self.write("exact.json", json.loads(self.ran("export", result, "--format", "json")))
        self.assertNotIn("misses", self.ran("analyze", exact))
        rounded = json.loads(exact.read_text())
        rounded["linkage"]["added"][0]["points"] = [[round(x) for x in point] for point in rounded["linkage"]["added"][0]["points"]]
        words = " ".join(self.ran("analyze", self.write("rounded.json", rounded), "-o", self.folder / "t.csv").split())
        self.assertRegex(words, r"As it moves the linkage (misses|does not come to) position 2")

    def test_a_spherical_linkage_with_rounded_axes_tells_what_it_misses(self):
        result = self.folder / "result.json"
        self.ran("solve", ROOT / "examples/folding_wing.json", "--samples", 40, "-o", result)
        linkage = json.loads(self.ran("export", result, "--format", "json"))
        self.assertIn("It meets all", self.ran("analyze", self.write("exact.json", linkage)))
        axes = linkage["linkage"]
        rounded = {key: linkage[key] for key in ("linkwright", "title", "orientations")} | {"mechanism": "spherical_four_bar", "axes": {
            f"{side}_{kind}": [round(x, 2) for x in axes[side][f"{kind}_axis"]] for side in ("input", "output")
            for kind in ("fixed", "moving")}}
        words = " ".join(self.ran("analyze", self.write("rounded.json", rounded)).split())
        self.assertRegex(words, r"As it moves the linkage (misses|does not come to) position 2")

    def test_the_largest_transmission_angle_is_no_sample(self):
        linkage = self.write("linkage.json", {"lengths": {"ground": 8, "input": 6, "coupler": 4, "output": 5}})
        words = " ".join(self.ran("analyze", linkage).split())
        self.assertRegex(words, r"largest, 90(\.0+)?°, at input angle -?52\.08°")

    def test_a_linkage_file_is_exported(self):
        linkage = self.write("linkage.json", DOUBLE_CRANK)
        for form in ("mjcf", "sdf", "svg", "dxf", "csv", "json"):
            status, output, _ = run("export", linkage, "--format", form)
            self.assertEqual(status, 0, form)
            self.assertTrue(output)
        self.assert_mistake(run("export", linkage, "--linkage", 2, "--format", "csv"), "this file holds one")
        self.assert_mistake(run("export", TAILGATE, "--format", "csv"), "this is a problem file")
        self.assert_mistake(run("export", self.write("none.json", {}), "--format", "csv"), "no linkage is given")

    def test_what_export_wrote_is_exported(self):
        result = self.folder / "result.json"
        for example in ("tailgate", "loader_bucket_chain", "folding_wing"):
            self.ran("solve", ROOT / f"examples/{example}.json", "--samples", 40, "-o", result)
            taken = self.folder / "linkage.json"
            self.ran("export", result, "--format", "json", "-o", taken)
            self.assertEqual(self.ran("export", taken, "--format", "csv"), self.ran("export", result, "--format", "csv"))

    def test_a_point_is_traced_or_refused(self):
        self.assert_mistake(run("analyze", self.write("leg.json", KLANN | {"point": [0, 0]})), "point", "guided body")
        self.ran("analyze", self.write("leg.json", KLANN))
        traced = self.ran("export", self.write("crank.json", DOUBLE_CRANK | {"point": [1, 1]}), "--format", "csv")
        self.assertIn("point_x,point_y", traced.splitlines()[0])

    def test_units_are_known_however_they_are_spelled(self):
        for unit, insunits in (("inches", 1), ("\"", 1), ("feet", 2), ("MM", 4), ("millimeter", 4), ("metre", 6)):
            linkage = self.write("linkage.json", DOUBLE_CRANK | {"length_unit": unit})
            drawing = self.ran("export", linkage, "--format", "dxf").split()
            self.assertEqual(drawing[drawing.index("$INSUNITS") + 2], str(insunits), unit)
            self.assertNotIn("unit of length", run("export", linkage, "--format", "sdf")[2])
        linkage = self.write("linkage.json", DOUBLE_CRANK | {"length_unit": "furlong"})
        self.assertIn("\"furlong\" is not known, so that the drawing has none", run("export", linkage, "--format", "dxf")[2])
        self.assertIn("\"furlong\" is not known, so that lengths are taken for millimetres", run("export", linkage, "--format", "sdf")[2])
        self.assertIn("Lengths in inches", self.ran("analyze", self.write("linkage.json", DOUBLE_CRANK | {"length_unit": "in"})))

    def test_sequences_in_capitals_are_known(self):
        turns = [{"euler_deg": angles, "sequence": "ZYX"} for angles in ([0, 0, 0], [20, 10, 15], [45, 15, 40])]
        task = {"kind": "motion", "mechanism": "spherical_four_bar", "orientations": turns,
                "given": {"fixed_axes": [[0, 0, 1], [1, 0, 0]]}}
        capitals, small = (self.ran("solve", self.write("p.json", json.loads(json.dumps({"linkwright": 1, "task": task}).replace("ZYX", way))))
                           for way in ("ZYX", "zyx"))
        self.assertEqual(capitals, small)

    def test_a_function_without_pairs_is_told_so(self):
        problem = {"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar", "time_ratio": 1.25, "swing_deg": 45}}
        error = run("solve", self.write("p.json", problem))[2]
        self.assertIn("neither pairs nor a function are given", error)
        self.assertNotIn("not both", error)

    def test_all_pairs_of_five_positions_that_meet_the_requirements_are_listed(self):
        result = json.loads(self.ran("solve", self.write("five.json", FIVE), "-o", "-"))
        listed = {tuple(sorted(int(linkage[side]["coordinate"]) for side in ("input", "output"))) for linkage in result["linkages"]}
        self.assertEqual(len(listed), len(result["linkages"]))
        meeting = [pair for pair in result["pairs"] if not any(pair["defects"].values())]
        self.assertEqual(len(listed), len(meeting))
        self.assertIn((2, 3), listed)  # the dyads 4 and 3 of the table

    def test_far_fetched_names_are_not_offered(self):
        problem = load(TAILGATE)
        problem["task"]["poses"] = problem["task"]["poses"][:3]
        problem["task"]["given"] = {"hinges_of_the_body": {"input": [60, 223]}}
        error = run("solve", self.write("p.json", problem))[2]
        self.assertNotIn("nearest", error)
        self.assertIn("known are \"side_lengths\"", error)

    def test_one_mistake_is_one_line(self):
        for problem in (load(TAILGATE) | {"tolerances": 5},):
            error = run("solve", self.write("p.json", problem))[2]
            self.assertEqual(error.count("\n"), 1, error)
        pivots = {key: [0, 1] for key in ("input_circle", "output_center", "output_circle")} | {"input_center": ["x", "y"]}
        error = run("analyze", self.write("l.json", {"pivots": pivots}))[2]
        self.assertEqual(error.count("\n"), 1, error)

    def test_a_gap_of_an_axis_is_called_one(self):
        problem = load(TAILGATE)
        problem["task"]["poses"] = problem["task"]["poses"][:3]
        problem["task"]["given"] = {"side_lengths": [300, 300]}
        reasons = []
        for place in (x / 20 for x in range(0, 40)):
            problem["options"] = {"at": [place, place], "region_samples": 40}
            result = json.loads(self.ran("solve", self.write("p.json", problem), "-o", "-"))
            if not result["linkages"]:
                reasons.append(result["reason"])
        self.assertTrue(any("lies in a gap of the first axis" in reason for reason in reasons) or not reasons, reasons)
        self.assertFalse(any("of the solution region: a hinge is at infinity" in reason for reason in reasons), reasons)

    def test_what_is_listed_meets_the_yield_that_is_required(self):
        problem = load(ROOT / "examples/tailgate_as_made.json")
        problem["requirements"] = problem.get("requirements", {}) | {"min_yield": 0.8}
        problem["tolerances"]["samples"] = 20000
        result = json.loads(self.ran("solve", self.write("p.json", problem), "--samples", 100, "-o", "-"))
        self.assertTrue(result["linkages"])
        for linkage in result["linkages"]:
            self.assertGreaterEqual(linkage["tolerance"]["yield"], 0.8)

    def test_what_all_fails_under_tolerances_is_not_blamed_on_rounding(self):
        problem = load(ROOT / "examples/tailgate_as_made.json")
        problem["requirements"] = problem.get("requirements", {}) | {"min_yield": 1, "min_transmission_angle_deg": 45}
        problem["tolerances"]["limit"] = {"position": 0.8}

        def solved(objective):
            problem["options"] = {"objective": objective}
            return json.loads(self.ran("solve", self.write("p.json", problem), "--samples", 100, "-o", "-"))

        nothing = solved("min_transmission_angle")
        self.assertFalse(nothing["linkages"])
        self.assertIn("by the few samples of the solution region does not", nothing["reason"])
        self.assertIn("Optimise for the yield", nothing["reason"])
        advised = solved("yield")["linkages"]
        self.assertTrue(advised)
        for linkage in advised:
            self.assertEqual(linkage["tolerance"]["yield"], 1)


if __name__ == "__main__":
    unittest.main()
