"""Motions past near poses, end to end: the program's errors against the linkage turned from its pivots alone."""

import cmath
import json
import math
import unittest

from driven_linkages import FourBar, Pose
from face_support import ROOT, FaceTest, load, run

EXAMPLES = ("hatch_by_hand", "hatch_all_near", "digitised_knee")


def body_poses(linkage, first, steps=14400):
    """Where the body is all round, as (origin, unit vector); it lies at `first` as the bars do."""
    bars, axis = FourBar(linkage), cmath.rect(1, first.angle)
    coupler = bars.output_circle - bars.input_circle
    for way in (1, -1):
        joint = bars.output_circle
        for step in range(steps + 1):
            state = bars.driven_to(way * math.tau * step / steps, joint)
            if state is None:
                break
            moved, joint = state
            turn = (joint - moved) / coupler
            turn /= abs(turn)
            yield moved + turn * (first.origin - bars.input_circle), turn * axis


def error(there, pose, turning_length):
    origin, axis = there
    turn = cmath.phase(axis / cmath.rect(1, pose.angle))
    return math.hypot(abs(origin - pose.origin), turning_length * turn)


class NearPoses(FaceTest):
    def test_the_examples_come_as_near_as_told(self):
        for name in EXAMPLES:
            with self.subTest(name):
                status, output, said = run("solve", ROOT / f"examples/{name}.json", "-o", "-")
                self.assertEqual((status, said), (0, ""))
                result = json.loads(output)
                task = result["problem"]["task"]
                poses = [Pose(pose) for pose in task["poses"]]
                self.assertTrue(result["linkages"])
                best = result["linkages"][0]
                for other in result["linkages"][1:]:
                    self.assertLessEqual(best["near"]["error"]["rms"], other["near"]["error"]["rms"] * (1 + 1e-6))
                length = task.get("turning_length")
                if length is None:
                    continue
                motion = list(body_poses(best, Pose(best["poses"][0])))
                for at in best["near"]["at"]:
                    pose = poses[at["pose"] - 1]
                    told = math.hypot(at["distance"], length * math.radians(at["angle_deg"]))
                    found = min(error(there, pose, length) for there in motion)
                    self.assertAlmostEqual(found, told, delta=0.02 * told + 2e-4 * length)
                    self.assertTrue(at["near"] or told < 1e-6 * length)

    def test_a_file_and_its_result_come_back(self):
        for name in ("hatch_by_hand", "hatch_all_near"):
            path = ROOT / f"examples/{name}.json"
            result = self.folder / f"{name}.json"
            self.assertEqual(run("solve", path, "-o", result)[0], 0)
            self.assertEqual(load(result)["problem"]["task"], load(path)["task"])
            for form in ("svg", "dxf", "json"):
                file = self.folder / f"{name}.{form}.out"
                status, output, said = run("export", result, "--linkage", "1", "--format", form, "-o", file)
                self.assertEqual((status, said), (0, ""), output)

    def test_report_tells_how_near(self):
        status, output, _ = run("solve", ROOT / "examples/hatch_all_near.json")
        self.assertEqual(status, 0)
        self.assertIn("How near the body comes to the near poses", output)
        self.assertIn("evidence, no proof", " ".join(output.split()))

    def test_a_limit_on_the_error_leaves_fewer(self):
        problem = load(ROOT / "examples/hatch_by_hand.json")
        counts = []
        for limit in (None, 10, 3):
            problem["requirements"]["max_near_error"] = limit
            status, output, said = run("solve", self.write("problem.json", problem), "-o", "-")
            self.assertEqual((status, said), (0, ""))
            result = json.loads(output)
            counts.append(result["region"]["meeting_requirements"])
            for linkage in result["linkages"]:
                self.assertLessEqual(linkage["near"]["error"]["rms"], limit or math.inf)
        self.assertGreater(counts[0], counts[1])
        self.assertGreater(counts[1], counts[2])


if __name__ == "__main__":
    unittest.main()
