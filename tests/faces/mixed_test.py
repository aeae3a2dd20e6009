"""Mixed positions end to end: the worked cases, their counts and best linkages, and every linkage listed measured again."""

import cmath
import json
import math
import unittest

from face_support import ROOT, FaceTest, load, run

CASES = sorted(path for path in (ROOT / "data/planar").glob("*mixed*.json"))
TYPES = {"GCRR": "crank_rocker", "GRRC": "rocker_crank", "GCCC": "double_crank", "GRCR": "double_rocker",
         "RRR1": "triple_rocker_ground", "RRR2": "triple_rocker_input", "RRR3": "triple_rocker_coupler",
         "RRR4": "triple_rocker_output", "change-point": "change_point", "degenerate": "degenerate"}


def problem_of(case):
    poses = []
    for (x, y, theta), *derivatives in case["positions"]:
        poses.append({"x": x, "y": y, "theta_deg": math.degrees(theta)})
        if derivatives:
            poses[-1]["derivatives"] = [dict(zip(("x", "y", "theta"), derivative)) for derivative in derivatives]
    return {"linkwright": 1, "title": case["name"], "task": {"kind": "motion", "mechanism": "four_bar", "poses": poses}}


def pose_at(pose, t):
    """Origin and angle (radians) at the parameter t of the path that the derivatives prescribe."""
    origin, angle, power = complex(pose["x"], pose["y"]), math.radians(pose["theta_deg"]), 1
    for order, derivative in enumerate(pose.get("derivatives", ()), start=1):
        power *= t / order
        origin += power * complex(derivative["x"], derivative["y"])
        angle += power * derivative["theta"]
    return origin, angle


def carried(point, first, pose, t=0):
    """Where the point of the body lies at `t` from the pose that lies at `point` in the first one."""
    (start, start_angle), (origin, angle) = pose_at(first, 0), pose_at(pose, t)
    return origin + cmath.rect(1, angle - start_angle) * (point - start)


class MixedPositions(FaceTest):
    def solve(self, problem, *arguments):
        status, output, error = run("solve", self.write("problem.json", problem), "-o", "-", *arguments)
        self.assertEqual((status, error), (0, ""))
        return json.loads(output)

    def for_each_case(self, check):
        self.assertEqual(len(CASES), 5)
        for path in CASES:
            with self.subTest(path.stem):
                check(load(path))

    def test_counts_are_those_of_the_cases(self):
        def check(case):
            region = case["solution_region"]
            result = self.solve(problem_of(case), "--samples", region["N"])
            pattern = "-".join("P" * multiplicity for multiplicity in case["multiplicity"])
            self.assertEqual(result["pattern"], pattern)
            self.assertAlmostEqual(result["condition"] / case["condition"], 1, delta=1e-9)
            self.assertAlmostEqual(result["characteristic_length"] / case["working_frame"]["scale"], 1, delta=1e-12)
            wanted, counts = region["driver_A"], result["region"]["counts"]
            allowed = wanted["borderline_type"]
            for theirs, ours in TYPES.items():
                self.assertAlmostEqual(counts[ours], wanted["types"][theirs], delta=allowed)
            for defect in ("circuit", "branch"):
                self.assertAlmostEqual(counts[defect], wanted[f"{defect}_defect"], delta=allowed)
            self.assertAlmostEqual(counts["defect_free"], wanted["defect_free"], delta=allowed)

        self.for_each_case(check)

    def test_the_best_is_at_least_as_good_as_theirs(self):
        def check(case):
            best = case["solution_region"]["driver_A"].get("best_gamma_task")
            problem = problem_of(case) | {"requirements": {"max_link_ratio": None, "max_length": None}}
            result = self.solve(problem, "--samples", 101)
            self.assertEqual(best is None, not result["linkages"])
            if best:
                self.assertGreaterEqual(result["linkages"][0]["min_transmission_angle_deg"], best["gamma_deg"] - 1e-6)

        self.for_each_case(check)

    def test_side_links_keep_their_lengths_to_the_order_prescribed(self):
        def check(case):
            problem = problem_of(case) | {"requirements": {"no_defects": False}}
            poses = problem["task"]["poses"]
            linkages = self.solve(problem)["linkages"]
            self.assertTrue(linkages)
            for linkage in linkages:
                self.assertIs(linkage["verified_by_driving"], True)
                self.assertLess(linkage["residual"], 1e-9)
                self.assertLess(linkage["residual_derivatives"], 1e-14)
                for side in ("input", "output"):
                    center, circle = (complex(*linkage[side][end]) for end in ("center_point", "circle_point"))
                    for pose in poses:
                        self.assert_length_is_kept(center, circle, poses[0], pose)

        self.for_each_case(check)

    def assert_length_is_kept(self, center, circle, first, pose):
        """Along the path t -> pose(t) the squared length changes as t^(m + 1): halving t divides it by 2^(m + 1)."""
        squared = abs(circle - center) ** 2

        def change(t):
            return max(abs(abs(carried(circle, first, pose, way) - center) ** 2 - squared) for way in (t, -t))

        self.assertLess(change(0), 1e-9 * squared)
        order, step = 1 + len(pose.get("derivatives", ())), 0.02
        if order > 1:
            noise = 1e-12 * (1 + squared + abs(circle) ** 2)
            self.assertLess(change(step / 2), 1.3 * change(step) / 2**order + noise)

    def test_turning_the_directions_round_turns_the_drive_round(self):
        def check(case):
            problem = problem_of(case)
            turned = json.loads(json.dumps(problem))
            for pose in turned["task"]["poses"]:
                for order, derivative in enumerate(pose.get("derivatives", ()), start=1):
                    for key in derivative:
                        derivative[key] *= (-1)**order
            there, back = (self.solve(p, "--samples", 101)["region"]["counts"] for p in (problem, turned))
            turned["requirements"] = {"respect_direction": False}
            either = self.solve(turned, "--samples", 101)
            self.assertIs(either["problem"]["requirements"]["respect_direction"], False)
            either = either["region"]["counts"]
            delta = case["solution_region"]["driver_A"]["borderline_type"]
            for key in (*TYPES.values(), "branch", "circuit"):
                self.assertAlmostEqual(there[key], back[key], delta=delta)
                self.assertAlmostEqual(there[key], either[key], delta=delta)
            self.assertGreaterEqual(either["defect_free"] + delta, max(there["defect_free"], back["defect_free"]))
            if len(case["multiplicity"]) == 3:  # three poses come in order one way only
                self.assertAlmostEqual(either["defect_free"], there["defect_free"] + back["defect_free"], delta=delta)

        self.for_each_case(check)

    def test_answers_people_in_words(self):
        status, output, _ = run("solve", ROOT / "examples/hood_hinge.json")
        self.assertEqual(status, 0)
        words = " ".join(output.split())
        for piece in ("four positions (PP-P-P)", "and their derivatives vanish to", "verified every linkage listed"):
            self.assertIn(piece, words)

    def test_linkages_are_exported_in_every_format(self):
        one_pose = problem_of(load(ROOT / "data/planar/mixed_PPPP.json"))
        for problem in (load(ROOT / "examples/hood_hinge.json"), one_pose):
            self.write("result.json", self.solve(problem, "--samples", 100))
            for form in ("svg", "dxf", "csv", "json"):
                target = self.folder / f"linkage.{form}"
                ran = run("export", self.folder / "result.json", "--linkage", 1, "--format", form, "-o", target)
                self.assertEqual((ran[0], ran[2]), (0, ""))
            self.assertEqual(load(self.folder / "linkage.json")["poses"], problem["task"]["poses"])
            self.assertEqual(run("analyze", self.folder / "linkage.json")[0], 0)


if __name__ == "__main__":
    unittest.main()
