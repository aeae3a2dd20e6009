"""Paths end to end: what is listed is turned by its crank, from the pivots and the point alone, and is at each point in time."""

import cmath
import json
import math
import unittest

from driven_linkages import FourBar
from face_support import ROOT, FaceTest, load, run

CASES = sorted(path for path in (ROOT / "data/path").glob("*.json") if "timed" in path.stem and path.stem != "nasty_timed")
UNTIMED = ("dough_mixer_five_points", "wiper_pivots_three_points")
STEPS = 400  # of a drive to a point


def driven_along(linkage, turns):
    """Where the point is when the crank has turned by each of the angles (radians); None where it does not get there."""
    bars, start = FourBar(linkage), complex(*linkage["point"])
    share = (start - bars.input_circle) / (bars.output_circle - bars.input_circle)
    turned, joint, places = 0.0, bars.output_circle, []
    for wanted in turns:
        for step in range(1, STEPS + 1):
            state = bars.driven_to(turned + (wanted - turned) * step / STEPS, joint)
            if state is None:
                return None
            moved, joint = state
        turned = wanted
        places.append(moved + share * (joint - moved))
    return places


class Paths(FaceTest):
    def solve(self, task, *arguments, **more):
        problem = {"linkwright": 1, "title": "A path", "task": task} | more
        status, output, error = run("solve", self.write("problem.json", problem), "-o", "-", *arguments)
        self.assertEqual((status, error), (0, ""))
        return json.loads(output)

    def check_linkage(self, task, linkage, turns):
        points = [complex(point["x"], point["y"]) for point in task["points"]]
        places = driven_along(linkage, turns)
        if any(linkage["defects"].values()):
            far = places is None or max(abs(a - b) for a, b in zip(places, points)) > 1e-6
            self.assertTrue(far, "a linkage with a defect does not do the task")
            return
        size = max(linkage["lengths"].values())
        self.assertLess(max(abs(a - b) for a, b in zip(places, points)), 1e-9 * size)
        if linkage["full_turn"]:
            there = driven_along(linkage, [math.tau / 4 * k for k in range(1, 5)])
            self.assertLess(abs(there[-1] - points[0]), 1e-9 * size)

    def check_cognate(self, task, linkage):
        """The same path at the same angles, by the cognate's pivots."""
        cognate = linkage["cognate"] | {"point": linkage["point"]}
        turns = [math.radians(10 * k) for k in range(3)]
        own, its = driven_along(linkage, turns), driven_along(cognate, turns)
        if own and its:
            self.assertLess(max(abs(a - b) for a, b in zip(own, its)), 1e-8 * max(linkage["lengths"].values()))
        crank = FourBar(cognate).input / FourBar(linkage).input
        self.assertAlmostEqual(crank / linkage["cognate"]["size_ratio"], 1, places=9)

    def test_what_is_listed_passes_the_points_in_time(self):
        self.assertEqual(len(CASES), 5)
        for path in CASES:
            task = load(path)["task"]
            turns = [math.radians(point["input_deg"] - task["points"][0]["input_deg"]) for point in task["points"]]
            result = self.solve(task, "--samples", 101)
            self.assertEqual(result["status"], "solved")
            self.assertEqual(result["timing"], "all")
            self.assertTrue(result["linkages"])
            for number, linkage in enumerate(result["linkages"] + result["pairs"], start=1):
                with self.subTest(path.stem, linkage=number):
                    self.assertIs(linkage["verified_by_driving"], True)
                    self.check_linkage(task, linkage, turns)
                    self.check_cognate(task, linkage)

    def test_points_alone_are_passed_in_order(self):
        for name in UNTIMED:
            task = load(ROOT / f"data/path/{name}.json")["task"]
            result = self.solve(task, "--samples", 61)
            self.assertEqual(result["timing"], "none")
            self.assertEqual([axis["quantity"] for axis in result["region"]["axes"]], ["arm_reach", "arm_difference"])
            self.assertEqual(len(result["linkages"]), 10)
            for number, linkage in enumerate(result["linkages"], start=1):
                with self.subTest(name, linkage=number):
                    turns = linkage["input_deg_at_points"]
                    steps = [b - a for a, b in zip(turns, turns[1:])]
                    self.assertTrue(all(step > 0 for step in steps) or all(step < 0 for step in steps))
                    self.assertLess(abs(turns[-1]), 360)
                    self.check_linkage(task, linkage, [math.radians(turn) for turn in turns])
                    self.assertNotIn("cognate", linkage)

    def test_a_place_is_asked_by_its_layer(self):
        problem = load(ROOT / "examples/dough_mixer.json")
        listed = self.solve(problem["task"], "--samples", 61)["linkages"][0]
        layer = [listed["input"]["coordinate"], listed["output"]["coordinate"]]
        again = self.solve(problem["task"], options={"at": layer})["linkages"]
        self.assertEqual(len(again), 1)
        self.assertEqual(again[0]["elbows"], listed["elbows"])
        self.assertEqual(again[0]["output"]["center_point"], listed["output"]["center_point"])

    def test_counts_are_those_of_the_cases(self):
        for path in CASES:
            case = load(path)
            if "region" not in case:
                continue
            with self.subTest(path.stem):
                counts = self.solve(case["task"], "--samples", case["region"]["samples"])["region"]["counts"]
                wanted = {name: count for name, count in case["region"]["counts"].items() if name != "full_turn_defect_free"}
                self.assertEqual({name: counts[name] for name in wanted}, wanted)

    def test_directions_of_travel_are_kept(self):
        task = load(ROOT / "data/path/thread_takeup_timed_mixed.json")["task"]
        wanted = complex(task["points"][0]["derivatives"][0]["x"], task["points"][0]["derivatives"][0]["y"])
        for linkage in self.solve(task, "--samples", 101)["linkages"]:
            ahead, back = driven_along(linkage, [1e-5])[0], driven_along(linkage, [-1e-5])[0]
            self.assertAlmostEqual(abs(cmath.phase((ahead - back) / wanted)), 0, places=6)
            self.assertAlmostEqual(abs(ahead - back) / 2e-5 / abs(wanted), 1, places=6)

    def test_is_told_in_words_drawn_and_exported(self):
        example, result, picture = ROOT / "examples/film_claw.json", self.folder / "result.json", self.folder / "claw.svg"
        status, words, error = run("solve", example, "-o", result, "--svg", picture)
        self.assertEqual((status, error), (0, ""))
        self.assertIn("path through four positions at given crank angles (P-P-P-P)", words)
        self.assertIn("full turn of the crank", words)
        self.assertLessEqual(max(map(len, words.splitlines())), 100)
        self.assertIn("path of the point", picture.read_text(encoding="utf-8"))
        for form in ("svg", "dxf", "csv", "json"):
            target = self.folder / f"linkage.{form}"
            status, _, error = run("export", result, "--linkage", 1, "--format", form, "-o", target)
            self.assertEqual((status, error), (0, ""))
            self.assertGreater(target.stat().st_size, 500)
        self.assertEqual(len(load(self.folder / "linkage.json")["poses"]), 4)

    def test_five_positions_list_their_cranks(self):
        status, words, error = run("solve", self.write("five.json", {
            "linkwright": 1, "title": "Stirrer", "task": load(ROOT / "data/path/stirrer_timed_five.json")["task"]}))
        self.assertEqual((status, error), (0, ""))
        self.assertIn(": 4 cranks", words)
        self.assertIn("Cranks of all five positions", words)
        self.assertLessEqual(max(map(len, words.splitlines())), 100)


if __name__ == "__main__":
    unittest.main()
