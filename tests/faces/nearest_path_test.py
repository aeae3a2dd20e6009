"""Paths near points, end to end: the program's distances against the linkage turned from its pivots and its point alone."""

import json
import math
import unittest

from driven_linkages import FourBar
from face_support import ROOT, FaceTest, load, run

EXAMPLES = ("bean_stirrer", "walking_foot", "film_advance", "letter_loop")


def whole_path(linkage, steps=1440):
    bars, start = FourBar(linkage), complex(*linkage["point"])
    share = (start - bars.input_circle) / (bars.output_circle - bars.input_circle)
    joint, path = bars.output_circle, []
    for step in range(steps + 1):
        state = bars.driven_to(math.tau * step / steps, joint)
        if state is None:
            return None
        moved, joint = state
        path.append(moved + share * (joint - moved))
    return path


def distance(path, place):
    def of_side(a, b):
        side = b - a
        share = 0 if side == 0 else ((place - a) * side.conjugate()).real / abs(side) ** 2
        return abs(a + min(max(share, 0), 1) * side - place)

    return min(of_side(a, b) for a, b in zip(path, path[1:]))


class NearestPaths(FaceTest):
    def test_the_examples_pass_as_near_as_told(self):
        for name in EXAMPLES:
            with self.subTest(name):
                status, output, error = run("solve", ROOT / f"examples/{name}.json", "-o", "-")
                self.assertEqual((status, error), (0, ""))
                result = json.loads(output)
                points = [complex(point["x"], point["y"]) for point in load(ROOT / f"examples/{name}.json")["task"]["points"]]
                self.assertTrue(result["linkages"])
                for linkage in result["linkages"]:
                    path = whole_path(linkage)
                    self.assertIsNotNone(path, "its crank turns fully")
                    diagonal = abs(complex(max(p.real for p in points) - min(p.real for p in points),
                                           max(p.imag for p in points) - min(p.imag for p in points)))
                    for at in linkage["fit"]["at"]:
                        found, told = distance(path, points[at["point"] - 1]) / diagonal, at["distance"] / diagonal
                        self.assertLessEqual(found, told + 2e-4)  # another strand may pass nearer, out of turn
                        if linkage is result["linkages"][0] and name != "letter_loop":
                            self.assertAlmostEqual(found, told, delta=2e-4)

    def test_a_timed_point_is_where_turning_the_crank_takes_it(self):
        points = load(ROOT / "examples/flying_knife.json")["task"]["points"]
        status, output, error = run("solve", ROOT / "examples/flying_knife.json", "-o", "-")
        self.assertEqual((status, error), (0, ""))
        for linkage in json.loads(output)["linkages"]:
            bars, start = FourBar(linkage), complex(*linkage["point"])
            share = (start - bars.input_circle) / (bars.output_circle - bars.input_circle)
            turns = [at["input_deg"] for at in linkage["fit"]["at"]]
            sense = math.copysign(1, turns[-1])
            joint, angle = bars.output_circle, 0
            for at, point in zip(linkage["fit"]["at"], points):
                self.assertAlmostEqual(sense * at["input_deg"], point["input_deg"], places=6)
                while angle < point["input_deg"]:
                    angle += 1
                    moved, joint = bars.driven_to(sense * math.radians(angle), joint)
                moved, joint = bars.driven_to(sense * math.radians(point["input_deg"]), joint)
                place = moved + share * (joint - moved)
                self.assertAlmostEqual(abs(place - complex(point["x"], point["y"])), at["distance"], places=6)
        self.assertIn("at the angles of the crank given", run("solve", ROOT / "examples/flying_knife.json")[1])

    def test_a_file_and_its_result_come_back(self):
        path = ROOT / "examples/bean_stirrer.json"
        result = self.folder / "bean.json"
        self.assertEqual(run("solve", path, "-o", result)[0], 0)
        again = load(result)["problem"]
        self.assertEqual(again["task"], load(path)["task"])
        for form in ("svg", "dxf"):
            status, output, error = run("export", result, "--linkage", "1", "--format", form, "-o", self.folder / f"bean.{form}")
            self.assertEqual((status, error), (0, ""), output)
        exported = self.folder / "linkage.json"
        self.assertEqual(run("export", result, "--linkage", "1", "--format", "json", "-o", exported)[0], 0)
        status, output, error = run("analyze", exported)
        self.assertEqual((status, error), (0, ""), output)

    def test_any_linkage_is_compared_with_points(self):
        result, linkage, report = (self.folder / name for name in ("film.json", "linkage.json", "report.json"))
        problem = ROOT / "examples/film_advance.json"
        self.assertEqual(run("solve", problem, "-o", result)[0], 0)
        self.assertEqual(run("export", result, "--linkage", 1, "--format", "json", "-o", linkage)[0], 0)
        picture = self.folder / "compared.svg"
        status, output, error = run("analyze", linkage, "--compare", problem, "-o", report, "--svg", picture)
        self.assertEqual((status, error), (0, ""))
        self.assertIn("Compared with 15 points", output)
        told, found = load(result)["linkages"][0]["fit"], load(report)["comparison"]
        self.assertAlmostEqual(found["error"]["rms"], told["error"]["rms"], delta=1e-6)
        for one, other in zip(told["at"], found["at"]):
            self.assertAlmostEqual(one["distance"], other["distance"], delta=1e-5)
        self.assertIn("<svg", picture.read_text())
        points = [(point["x"], point["y"]) for point in load(problem)["task"]["points"]]
        table = self.write("points.csv", "x,y\n" + "".join(f"{x},{y}\n" for x, y in points))
        status, output, error = run("analyze", linkage, "--compare", table, "--closed", "-o", self.folder / "distances.csv")
        self.assertEqual((status, error), (0, ""))
        rows = (self.folder / "distances.csv").read_text().splitlines()
        self.assertEqual(len(rows), 16)
        whole = whole_path(load(result)["linkages"][0])
        for row, point in zip(rows[1:], points):
            self.assertAlmostEqual(float(row.split(",")[5]), distance(whole, complex(*point)), delta=2e-3)

    def test_what_cannot_be_compared_is_told(self):
        linkage = self.write("linkage.json", {"lengths": {"ground": 4, "input": 1, "coupler": 3, "output": 3.5}})
        table = self.write("points.csv", "0,0\n1,0\n1,1\n")
        self.assert_mistake(run("analyze", linkage, "--compare", table), "no point of the coupler")
        self.assertEqual(run("analyze", linkage, "--compare", table, "--point", "1,2")[0], 0)
        self.assert_mistake(run("analyze", linkage, "--compare", ROOT / "examples/log_generator.json"), "neither a path nor poses")
        self.assert_mistake(run("analyze", linkage, "--compare", table, "--instant"), "one at a time")
        self.assert_mistake(run("analyze", linkage, "--point", "1,2"), "--instant or --compare")
        wrist = self.write("wrist.json", {"mechanism": "spherical_four_bar",
                                          "angles_deg": {"ground": 80, "input": 30, "coupler": 70, "output": 75}})
        self.assert_mistake(run("analyze", wrist, "--compare", table), "planar four-bars")

    def test_report_tells_how_near(self):
        status, output, _ = run("solve", ROOT / "examples/letter_loop.json")
        self.assertEqual(status, 0)
        self.assertIn("How near the points lie", output)
        self.assertIn("times as much would do", " ".join(output.split()))
        self.assertIn("evidence, no proof", " ".join(output.split()))

    def test_more_effort_is_never_worse(self):
        problem = load(ROOT / "examples/walking_foot.json")
        errors = []
        for effort in ("quick", "standard"):
            problem["options"] = {"fit": {"effort": effort}}
            status, output, error = run("solve", self.write("problem.json", problem), "-o", "-")
            self.assertEqual((status, error), (0, ""))
            errors.append(json.loads(output)["linkages"][0]["fit"]["error"]["rms"])
        self.assertLessEqual(errors[1], errors[0] * (1 + 1e-6))


if __name__ == "__main__":
    unittest.main()
