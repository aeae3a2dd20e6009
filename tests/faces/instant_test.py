"""`analyze --instant` from outside: numbers, words, pictures, and what it refuses."""

import json
import math
import unittest

from face_support import ROOT, TAILGATE, FaceTest, load, run
from schema_test import jsonschema, validator

GOESSNER = load(ROOT / "data/instant/goessner.json")
FOUR_BAR = {"lengths": {"ground": 3.5, "input": 1, "coupler": 3, "output": 2.5}, "length_unit": "mm"}
WHEEL = {"linkwright": 1, "title": "Wheel", "task": {"kind": "motion", "mechanism": "four_bar", "poses": [
    {"x": 0, "y": 1, "theta_deg": 0, "derivatives": [{"x": -1, "y": 0, "theta": 1}, {"x": 0, "y": 0, "theta": 0},
                                                   {"x": 0, "y": 0, "theta": 0}]}]}}


def pivots(*points):
    names = ("input_center", "input_circle", "output_center", "output_circle")
    return {"pivots": dict(zip(names, points, strict=True))}


class Instant(FaceTest):
    def instant(self, linkage, *flags):
        status, output, error = run("analyze", self.write("linkage.json", linkage), "--instant", "-o", "-", *flags)
        self.assertEqual((status, error), (0, ""))
        return json.loads(output)

    def words(self, linkage, *flags):
        status, output, error = run("analyze", self.write("linkage.json", linkage), "--instant", *flags)
        self.assertEqual((status, error), (0, ""))
        for line in output.splitlines():
            self.assertLessEqual(len(line), 100, line)
        return output

    def test_is_that_of_the_published_four_bar(self):
        angle, own = GOESSNER["input"]["theta_deg"], GOESSNER["own_result"]
        found = self.instant(FOUR_BAR, "--input-deg", angle)
        self.assertAlmostEqual(found["configuration"]["input_angle_deg"], angle, places=9)
        for name, place in (("pole", "pole"), ("inflection_pole", "inflection_pole")):
            for got, wanted in zip(found["instant"][name], own[place], strict=True):
                self.assertAlmostEqual(got, wanted, delta=1e-10 * abs(own["inflection_circle_diameter"]))
        self.assertAlmostEqual(found["instant"]["inflection_diameter"], own["inflection_circle_diameter"], places=9)

    def test_rolling_circles(self):
        for name, poses in (("cycloid", WHEEL["task"]["poses"]), ("cardan", [
                {"x": 1, "y": 0, "theta_deg": 0, "derivatives": [{"x": 0, "y": -1, "theta": 1}, {"x": -1, "y": 0, "theta": 0},
                                                                {"x": 0, "y": 1, "theta": 0}]}])):
            published = load(ROOT / f"data/instant/{name}.json")["published"]
            problem = {**WHEEL, "task": {**WHEEL["task"], "poses": poses}}
            found = self.instant(problem, "--point", "1,1")
            self.assertAlmostEqual(found["instant"]["inflection_diameter"], published["inflection_circle_diameter"])
            self.assertEqual(found["title"], "Wheel")

    def test_the_point_goes_with_the_coupler(self):
        lying, turned = (self.instant(FOUR_BAR, "--point", "1.5,2", *flags) for flags in ((), ("--input-deg", "130")))
        arms = []
        for found in (lying, turned):
            at, corner = found["instant"]["point"]["at"], found["configuration"]["pivots"]["input_circle"]
            arms.append(math.dist(at, corner))
        self.assertEqual(lying["instant"]["point"]["at"], [1.5, 2])
        self.assertAlmostEqual(*arms, places=12)

    def test_a_linkage_of_a_straight_line_brings_its_point(self):
        watt = {"pivots": {"input_fixed": [-2, 0.5], "input_moving": [0, 0.5], "output_moving": [0, -0.5], "output_fixed": [2, -0.5],
                           "point": [0, 0]}}
        point = self.instant(watt)["instant"]["point"]
        self.assertEqual((point["at"], point["center_of_curvature"], point["contact_points"]), ([0, 0], None, 5))
        self.assertEqual(self.instant(watt, "--point", "1,1")["instant"]["point"]["at"], [1, 1])

    def test_acceleration_moves_the_bresse_circle_only(self):
        even, hastened = (self.instant(FOUR_BAR, "--input-acceleration", a)["instant"] for a in ("0", "2"))
        self.assertNotEqual(even["bresse_circle"], hastened["bresse_circle"])
        self.assertEqual(even["inflection_circle"], hastened["inflection_circle"])
        self.assertAlmostEqual(hastened["body_acceleration"], even["body_acceleration"] + 2 * even["body_rate"], places=12)

    def test_says_it_in_words(self):
        text = self.words(FOUR_BAR, "--input-deg", "60", "--point", "1,2")
        for words in ("Crank-rocker", "60.00°", "inflection circle", "diameter 30.5307", "Ball's point", "centre of curvature"):
            self.assertIn(words, text)
        self.assertIn("hyperbola", self.words(pivots([0, 0], [0, 1], [3, 4], [3, 1.5])))
        self.assertIn("frame line", self.words(pivots([0, 0], [1, 0], [4, 0], [3, 2])))
        self.assertIn("There is no instant", self.words(pivots([0, 0], [1, 0], [4, 0], [3, 0])))
        self.assertIn("runs straight", self.words(pivots([-1, 0], [-0.5, 1.2], [1, 0], [0.5, 1.2]), "--point", "0,-0.4166666666666667"))

    def test_draws_it(self):
        picture = self.folder / "instant.svg"
        self.words(FOUR_BAR, "--svg", picture)
        self.assertIn("inflection circle", picture.read_text(encoding="utf-8"))
        self.words(WHEEL, "--svg", picture)
        self.assertIn("prescribed motion", picture.read_text(encoding="utf-8"))

    @unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
    def test_keeps_to_the_schema(self):
        analysis = validator("analysis")
        for linkage in (FOUR_BAR, WHEEL, pivots([0, 0], [0, 1], [3, 4], [3, 1.5]), pivots([0, 0], [1, 2], [4, 0], [5, 2]),
                        pivots([0, 0], [1, 0], [4, 0], [3, 0]), pivots([0, 0], [1, 1], [4, -2], [3, -1])):
            for flags in ((), ("--point", "2,3")):
                analysis.validate(self.instant(linkage, *flags))


class Refusals(FaceTest):
    def refuse(self, content, flags, *pieces):
        self.assert_mistake(run("analyze", self.write("file.json", content), *flags), *pieces)

    def test_flags_of_the_instant_need_it(self):
        for flags in (["--point", "1,2"], ["--input-deg", "3"], ["--input-acceleration", "1"], ["--svg", "a.svg"]):
            self.refuse(FOUR_BAR, flags, flags[0], "--instant")

    def test_numbers_that_are_none(self):
        for flags in (["--point", "1"], ["--point", "1,2,3"], ["--point", "a,b"], ["--input-deg", "up"], ["--point", "nan,0"],
                      ["--point", "1e300,0"], ["--input-deg", "inf"], ["--input-deg", "1e9"], ["--input-acceleration", "nan"],
                      ["--input-acceleration", "1e200"], ["--point", ""]):
            self.refuse(FOUR_BAR, ["--instant", *flags], flags[0])

    def test_an_angle_out_of_reach(self):
        rocker = {"lengths": {"ground": 4, "input": 5, "coupler": 3, "output": 3}}
        self.refuse(rocker, ["--instant", "--input-deg", "170"], "--input-deg", "cannot be there", "rocks from")

    def test_a_table(self):
        self.refuse(FOUR_BAR, ["--instant", "-o", self.folder / "a.csv"], "--output", ".json")
        self.assertFalse((self.folder / "a.csv").exists())

    def test_other_linkages(self):
        sphere = {"mechanism": "spherical_four_bar", "angles_deg": {"ground": 80, "input": 30, "coupler": 70, "output": 75}}
        self.refuse(sphere, ["--instant"], "--instant", "spherical four-bar", "leave --instant out")
        result, chain = self.folder / "six.json", self.folder / "chain.json"
        self.assertEqual(run("solve", ROOT / "examples/loader_bucket_chain.json", "--samples", 12, "-o", result)[0], 0)
        status, text, _ = run("export", result, "--format", "json")
        self.assertEqual(status, 0)
        chain.write_text(text, encoding="utf-8")
        self.assert_mistake(run("analyze", chain, "--instant"), "--instant", "six-bar")

    def test_problems_that_are_no_instant(self):
        self.assert_mistake(run("analyze", TAILGATE, "--instant"), "task", "one pose and its first three derivatives")
        self.assert_mistake(run("analyze", TAILGATE), "task", "problem file", "linkwright solve")
        self.refuse(WHEEL, ["--instant", "--input-deg", "10"], "--input-deg", "no input link")
        self.refuse(WHEEL, ["--instant", "--input-acceleration", "1"], "--input-acceleration", "no input link")
        still = json.loads(json.dumps(WHEEL))
        still["task"]["poses"][0]["derivatives"][0] = {"x": 0, "y": 0, "theta": 0}
        self.refuse(still, ["--instant"], "derivatives")


if __name__ == "__main__":
    unittest.main()
