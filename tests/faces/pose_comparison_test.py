"""Bodies compared with poses, end to end: what `analyze --compare` tells of a task's own linkages, and of others."""

import csv
import json
import math
import unittest

from driven_linkages import Pose
from face_support import ROOT, FaceTest, load, run
from near_poses_test import body_poses, error

EXAMPLES = ("hatch_by_hand", "hatch_all_near", "digitised_knee", "tailgate")
BARS = {"pivots": {"input_center": [0, 0], "input_circle": [1, 0], "output_center": [4, 0], "output_circle": [3, 2.5]},
        "poses": [{"x": 1, "y": 1, "theta_deg": 0}]}


def table_of(poses):
    return "x,y,theta_deg\n" + "".join(f"{pose['x']},{pose['y']},{pose['theta_deg']}\n" for pose in poses)


class PoseComparison(FaceTest):
    def compared(self, name, *arguments):
        """Result, comparison and text of the best linkage of an example."""
        result, linkage, report = (self.folder / f"{name}.{part}.json" for part in ("result", "linkage", "report"))
        if not linkage.exists():
            self.assertEqual(run("solve", ROOT / f"examples/{name}.json", "-o", result)[0], 0)
            self.assertEqual(run("export", result, "--linkage", 1, "--format", "json", "-o", linkage)[0], 0)
        status, output, said = run("analyze", linkage, "--compare", *arguments, "-o", report)
        self.assertEqual((status, said), (0, ""))
        return load(result), load(report)["pose_comparison"], output

    def test_linkages_of_a_result_come_back_with_their_errors(self):
        for name in EXAMPLES:
            with self.subTest(name):
                problem = ROOT / f"examples/{name}.json"
                picture = self.folder / f"{name}.svg"
                result, found, output = self.compared(name, problem, "--svg", picture)
                told = result["linkages"][0].get("near")
                poses = load(problem)["task"]["poses"]
                self.assertIn(f"Compared with {len(poses)} poses", output)
                self.assertTrue(found["one_circuit"] and found["in_order"] and found["input_drives"])
                self.assertIn("drives the body past all of them", " ".join(output.split()))
                self.assertIn("<svg", picture.read_text())
                self.assertEqual([at["pose"] for at in found["at"]], list(range(1, len(poses) + 1)))
                if told is None:  # all poses exact
                    self.assertLess(found["error"]["rms"], 1e-6)
                    continue
                for key in ("rms", "position_rms", "position_max", "angle_rms_deg", "angle_max_deg"):
                    self.assertAlmostEqual(found["error"][key], told["error"][key], delta=1e-6 * (1 + told["error"][key]))
                self.assertLess(found["error"]["exact_residual"], 1e-6)
                self.assertEqual(found["error"]["max_at"], told["error"]["max_at"])
                for one, other in zip(found["at"], told["at"]):
                    self.assertAlmostEqual(one["distance"], other["distance"], delta=1e-5)
                    self.assertAlmostEqual(one["angle_deg"], other["angle_deg"], delta=1e-5)
                near = [at for at in found["at"] if at["near"]]
                farthest = max(near, key=lambda at: at["distance"])
                self.assertEqual(farthest["pose"], found["position_max_at"])
                self.assertAlmostEqual(farthest["distance"], found["error"]["position_max"])
                self.assertEqual(max(near, key=lambda at: at["angle_deg"])["pose"], found["angle_max_at"])

    def test_a_table_of_poses_is_compared_as_it_stands(self):
        poses = load(ROOT / "examples/hatch_all_near.json")["task"]["poses"]
        result, by_task, _ = self.compared("hatch_all_near", ROOT / "examples/hatch_all_near.json")
        _, by_table, _ = self.compared("hatch_all_near", self.write("poses.csv", table_of(poses)))
        length = by_table["turning_length"]
        motion = list(body_poses(result["linkages"][0], Pose(result["linkages"][0]["poses"][0])))
        for at, pose in zip(by_table["at"], poses):
            told = math.hypot(at["distance"], length * math.radians(at["angle_deg"]))
            found = min(error(there, Pose(pose), length) for there in motion)
            self.assertAlmostEqual(found, told, delta=0.02 * told + 2e-4 * length)
        self.assertLess(abs(by_table["error"]["rms"] - by_task["error"]["rms"]), 0.5 * by_task["error"]["rms"])
        _, in_capitals, _ = self.compared("hatch_all_near", self.write("POSES.CSV", table_of(poses)))
        self.assertEqual(in_capitals, by_table)
        rows = self.folder / "rows.csv"
        linkage = self.folder / "hatch_all_near.linkage.json"
        self.assertEqual(run("analyze", linkage, "--compare", self.folder / "poses.csv", "-o", rows)[0], 0)
        with open(rows, encoding="utf-8") as file:
            listed = list(csv.DictReader(file))
        self.assertEqual(len(listed), len(poses))
        for row, at in zip(listed, by_table["at"]):
            self.assertAlmostEqual(float(row["distance"]), at["distance"], places=9)
            self.assertAlmostEqual(float(row["body_theta_deg"]), at["theta_deg"], places=9)

    def test_a_linkage_of_other_makers_says_where_its_body_is(self):
        poses = [{"x": 1, "y": 1, "theta_deg": 0}, {"x": 0.9, "y": 1.3, "theta_deg": 3}, {"x": 0.7, "y": 1.6, "theta_deg": 8}]
        table = self.write("poses.csv", table_of(poses))
        with_body = self.write("body.json", BARS)
        bare = self.write("bare.json", {"pivots": BARS["pivots"]})
        beside = json.loads(run("analyze", with_body, "--compare", table, "-o", "-")[1])["pose_comparison"]
        by_flag = json.loads(run("analyze", bare, "--compare", table, "--body", "1,1,0", "-o", "-")[1])["pose_comparison"]
        self.assertEqual(beside["error"], by_flag["error"])
        self.assertNotEqual(0, beside["error"]["rms"])
        other = json.loads(run("analyze", with_body, "--compare", table, "--body", "1,1.2,5", "-o", "-")[1])["pose_comparison"]
        self.assertNotEqual(beside["error"], other["error"])
        self.assert_mistake(run("analyze", bare, "--compare", table), "nothing says where the body is", "--body")
        status, output, said = run("analyze", with_body, "--compare", table, "--drive", "output")
        self.assertEqual((status, said), (0, ""))
        self.assertIn("Compared with 3 poses", output)

    def test_what_cannot_be_compared_is_told(self):
        linkage = self.write("body.json", BARS)
        three = self.write("three.csv", "0,0,0\n1,0,5\n1,1,9\n")

        def refused(content, *pieces, name="poses.csv", flags=()):
            self.assert_mistake(run("analyze", linkage, "--compare", self.write(name, content), *flags), *pieces)

        refused("", "three lines")
        refused("x,y,theta_deg\n", "three lines")
        refused("0,0,0\n1,0,5\n", "three lines of x, y and theta_deg")
        refused("0,0\n1,0\n2,1\n", "no point of the coupler")
        refused("x,y,theta_deg\n0,0\n1,0\n2,1\n", "no point of the coupler")
        refused("0,0,0\n1,2\n1,1,9\n", "line 2", "2 columns stand here")
        refused("0,0,0\n1,nan,3\n1,1,9\n", "line 2", "a number is missing")
        refused("0,0,0\n1,inf,3\n1,1,9\n", "line 2", "a number is missing")
        refused("0,0,0\n1,1e99,3\n1,1,9\n", "line 2", "a number is missing")
        refused("0,0,0\n0,0,0\n1,1,9\n", "2 different poses")
        refused("0,0,0\n" * 1001 + "1,1,1\n2,2,2\n", "1000 are the most")
        self.assert_mistake(run("analyze", linkage, "--compare", three, "--point", "1,2"), "--point", "a body is compared")
        self.assert_mistake(run("analyze", linkage, "--compare", three, "--closed"), "--closed", "poses")
        self.assert_mistake(run("analyze", linkage, "--compare", three, "--body", "1,nan,2"), "--body")
        points = self.write("points.csv", "0,0\n1,0\n1,1\n")
        self.assert_mistake(run("analyze", linkage, "--compare", points, "--body", "1,1,2"), "these are points")
        self.assertEqual(run("analyze", linkage, "--body", "1,1,2")[0], 2)
        for example in ("wrist_orthosis", "log_generator"):
            self.assert_mistake(run("analyze", linkage, "--compare", ROOT / f"examples/{example}.json"), "neither a path nor poses")
        six_bar = self.write("six_bar.json", load(ROOT / "fuzz/corpus/problem_reader/six_bar_linkage.json"))
        self.assert_mistake(run("analyze", six_bar, "--compare", three), "this is a six-bar")


if __name__ == "__main__":
    unittest.main()
