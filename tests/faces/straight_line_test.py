"""Straight lines from the command line: what is found is traced anew by circles, which know nothing of how it was found."""

import copy
import json
import math
import os
import signal
import subprocess
import time
import unittest

from face_support import CLI, ROOT, FaceTest, load, run
from schema_test import jsonschema, schemas
from straight_support import LEAST_CONTACT, TASKS, WITHOUT_MAP, Tracer, line_task, problem_of


class StraightLines(FaceTest):
    solved = {}

    def solve(self, problem, *arguments):
        ran = run("solve", self.write("problem.json", problem), "-o", "-", *arguments)
        self.assertEqual((ran[0], ran[2]), (0, ""))
        return json.loads(ran[1])

    def solved_case(self, name):
        if name not in self.solved:
            self.solved[name] = self.solve(problem_of(name))
        return self.solved[name]

    def test_every_case_has_linkages_on_its_line(self):
        for name, task in TASKS.items():
            with self.subTest(name):
                result = self.solved_case(name)
                self.assertEqual(result["status"], "solved")
                self.assertEqual(result["region"] is None, name in WITHOUT_MAP)
                self.assertTrue(result["linkages"])
                for linkage in result["linkages"]:
                    if name != "search":
                        self.assertEqual(linkage["case"], task["case"])
                    line = linkage.get("task", task)["line"]
                    self.assertGreaterEqual(linkage["contact_points"], LEAST_CONTACT.get(name, 4))
                    offset = complex(*linkage["pivots"]["point"]) - complex(*line["point"])
                    direction = complex(math.cos(math.radians(line["direction_deg"])), math.sin(math.radians(line["direction_deg"])))
                    longest = max(linkage["lengths"].values())
                    # A lambda's line is the best one, beside its middle.
                    slack = linkage["residual"] + 1e-9 * longest
                    self.assertLess(abs((offset * direction.conjugate()).imag), slack)
                    self.assertLess(linkage["residual"], 0.01 * longest)

    @unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
    def test_results_are_those_of_the_schema(self):
        problem, result = schemas()
        for name in TASKS:
            with self.subTest(name):
                result.validate(self.solved_case(name))
                problem.validate(self.solved_case(name)["problem"])

    def test_lengths_are_those_between_the_pivots(self):
        ends = {"ground": ("input_fixed", "output_fixed"), "input": ("input_fixed", "input_moving"),
                "coupler": ("input_moving", "output_moving"), "output": ("output_fixed", "output_moving"),
                "point_to_input": ("point", "input_moving"), "point_to_output": ("point", "output_moving")}
        for name in TASKS:
            for linkage in self.solved_case(name)["linkages"]:
                for length, (one, other) in ends.items():
                    there = abs(complex(*linkage["pivots"][one]) - complex(*linkage["pivots"][other]))
                    self.assertAlmostEqual(linkage["lengths"][length], there, delta=1e-12 * max(1, there), msg=(name, length))

    def test_traced_by_circles_it_stays_within_the_strip_and_then_leaves_it(self):
        """Over the usable length |e| <= δ; beyond its ends it is farther off, or the point has turned back."""
        looked = 0
        for name, task in TASKS.items():
            for linkage in self.solved_case(name)["linkages"]:
                with self.subTest(name):
                    looked += self.check_trace(linkage, task)
        self.assertGreater(looked, 30)

    def check_trace(self, linkage, task):
        usable, deviation = linkage["usable"], linkage["deviation"]
        tracer = Tracer(linkage, linkage.get("task", task)["line"])
        looked = 0
        for sense in (1, -1):
            points = tracer.path(sense, 2e-4, 1.5 * usable["length"])
            if len(points) < 10:
                continue  # at a dead point
            ahead = points[-1][0] > 0
            limit, end = (usable["to_s"], usable["ends"][1]) if ahead else (usable["from_s"], usable["ends"][0])
            inside = [e for s, e in points if abs(s) <= abs(limit) * (1 - 1e-9)]
            self.assertLessEqual(max(map(abs, inside)), deviation * (1 + 1e-6))
            beyond = [e for s, e in points if abs(s) > abs(limit) * (1 + 1e-9)]
            if end == "deviation" and beyond:
                self.assertGreater(max(map(abs, beyond[:40])), deviation * (1 - 1e-6))
                looked += 1
            if end == "turn":
                self.assertLessEqual(abs(points[-1][0]), abs(limit) * (1 + 1e-9))
        return looked

    def test_contact_is_of_the_order_told(self):
        """The deviation near the place falls with the power of the points of contact, and has the coefficient told."""
        looked = 0
        for name, task in TASKS.items():
            for linkage in self.solved_case(name)["linkages"]:
                line = linkage.get("task", task)["line"]
                order = linkage["contact_points"]
                with self.subTest(name, order=order):
                    coefficient = linkage["deviation_series"][str(order)]
                    reach = 0.08 * linkage["usable"]["length"]
                    near = [self.at_place(Tracer(linkage, line), sense, reach) for sense in (1, -1)]
                    if None in near:
                        continue
                    mean = sum(e / s ** order for s, e in near) / 2
                    noise = 1e-13 * max(linkage["lengths"].values()) / reach ** order
                    self.assertAlmostEqual(mean / coefficient, 1, delta=0.2 + noise / abs(coefficient))
                    looked += 1
        self.assertGreater(looked, 20)

    @staticmethod
    def at_place(tracer, sense, reach):
        points = tracer.path(sense, 1e-4, reach)
        return points[-1] if len(points) > 10 and abs(points[-1][0]) > reach else None

    def test_strip_is_no_shorter_than_tangent(self):
        for name in TASKS:
            for linkage in self.solved_case(name)["linkages"]:
                self.assertGreaterEqual(linkage["usable_strip"]["length"], linkage["usable"]["length"] * (1 - 1e-9), name)

    def test_echo_is_what_was_given_bit_for_bit(self):
        odd = {"point": [0.1, 1 / 3], "direction_deg": 200.00000000000003}
        for name, task in TASKS.items():
            task = task | {"line": odd} if name not in WITHOUT_MAP else task
            problem = problem_of(name) | {"task": task}
            problem["options"] |= {"best": 0, "region_samples": 8}
            echo = self.solve(problem)["problem"]
            with self.subTest(name):
                for key, value in task.items():
                    if key != "contacts":
                        self.assertEqual(echo["task"][key], value)
                again = self.solve(echo)["problem"]
                self.assertEqual(json.dumps(again), json.dumps(echo))

    def test_a_place_picked_has_the_linkage_found_there(self):
        for name in TASKS:
            if name in WITHOUT_MAP:
                continue
            result = self.solved_case(name)
            for linkage in result["linkages"][:2]:
                picked = copy.deepcopy(result["problem"])
                picked["options"]["at"] = linkage["place"]
                there = [found for found in self.solve(picked)["linkages"] if found["layer"] == linkage["layer"]]
                with self.subTest(name):
                    self.assertEqual(len(there), 1)
                    self.assertTrue(there[0]["meets_requirements"])
                    size = max(linkage["lengths"].values())
                    for pivot, at in linkage["pivots"].items():
                        self.assertLess(abs(complex(*at) - complex(*there[0]["pivots"][pivot])), 1e-7 * size)

    def test_a_linkage_of_a_search_is_on_the_map_of_its_case(self):
        for linkage in self.solved_case("search")["linkages"]:
            picked = {"linkwright": 1, "task": linkage["task"], "options": {"region_samples": 8}}
            if linkage["case"] == "symmetric_lambda":
                continue  # its crank range is the place
            picked["options"]["at"] = linkage["place"]
            there = [found for found in self.solve(picked)["linkages"] if found["layer"] == linkage["layer"]]
            self.assertEqual(len(there), 1)
            size = max(linkage["lengths"].values())
            for pivot, at in linkage["pivots"].items():
                self.assertLess(abs(complex(*at) - complex(*there[0]["pivots"][pivot])), 1e-6 * size)

    def test_exports_carry_the_point(self):
        result = self.solved_case("four_point_pivots")
        path = self.write("result.json", result)
        linkage = result["linkages"][1]
        for form in ("json", "svg", "dxf", "csv"):
            ran = run("export", path, "--linkage", 2, "--format", form, "-o", self.folder / f"linkage.{form}")
            self.assertEqual((ran[0], ran[2]), (0, ""))
        kept = load(self.folder / "linkage.json")
        self.assertEqual(kept["linkage"]["pivots"], linkage["pivots"])
        svg = (self.folder / "linkage.svg").read_text()
        self.assertIn(">C to input pin</text>", svg)
        x, y = (f"{value!r}".removesuffix(".0") for value in linkage["pivots"]["point"])
        self.assertIn(f"\n10\n{x}\n20\n{y}\n", (self.folder / "linkage.dxf").read_text())
        head, first, *_ = (self.folder / "linkage.csv").read_text().splitlines()
        self.assertTrue(head.endswith(",position_error,orientation_error_deg,point_x,point_y"))
        self.assertEqual([float(cell) for cell in first.split(",")[-2:]], linkage["pivots"]["point"])
        analysed = run("analyze", self.folder / "linkage.json")
        self.assertEqual((analysed[0], analysed[2]), (0, ""))
        self.assertIn("4 points in common with that tangent", " ".join(analysed[1].split()))

    def test_the_pictures_are_drawn(self):
        for name in ("five_point", "symmetric_lambda_of_a_range", "search"):
            path = self.folder / "sheet.svg"
            ran = run("solve", self.write("problem.json", problem_of(name)), "--svg", path)
            self.assertEqual((ran[0], ran[2]), (0, ""))
            self.assertIn("Deviation of C from the line", path.read_text())

    def test_no_linkage_has_a_reason(self):
        all_sliders = problem_of("four_point_cubic")
        all_sliders["task"] = all_sliders["task"] | {"cubic_n": None}
        too_much = problem_of("four_point_pivots") | {"requirements": {"min_stroke": 1e6}}
        off = problem_of("four_point_pivots", at=[-10, 50])
        for problem, words in ((all_sliders, "slider"), (too_much, "min_stroke"), (off, "off the map")):
            result = self.solve(problem)
            self.assertEqual((result["status"], result["linkages"]), ("no_solution", []))
            self.assertIn(words, result["reason"])

    def test_linkages_are_judged_over_the_stroke_that_is_asked_for(self):
        for objective, figure, sign in (("velocity_uniformity", "velocity_nonuniformity", 1), ("deviation", "max_deviation", 1),
                                        ("min_transmission_angle", "min_transmission_angle_deg", -1)):
            with self.subTest(objective):
                listed = self.solve(problem_of("four_point_pivots", stroke=5, objective=objective))["linkages"]
                self.assertTrue(listed)
                for linkage in listed:
                    self.assertAlmostEqual(linkage["stroke"]["s_to"] - linkage["stroke"]["s_from"], 5)
                    self.assertEqual(linkage["min_transmission_angle_deg"], linkage["stroke"]["min_transmission_angle_deg"])
                figures = [sign * linkage["stroke"][figure] for linkage in listed]
                self.assertEqual(figures, sorted(figures))

    def test_a_stroke_that_is_not_reached_is_not_listed(self):
        far = problem_of("four_point_pivots", stroke=1e9)
        for objective in ("stroke", "deviation", "velocity_uniformity", "min_transmission_angle"):
            far["options"]["objective"] = objective
            result = self.solve(far)
            self.assertEqual((result["status"], result["linkages"], result["relax"]), ("no_solution", [], []))
            self.assertIn("turn back before the ends of the stroke", result["reason"])

        far["options"]["objective"] = "stroke"
        far["requirements"] = {"max_deviation": 1}
        ran = run("solve", self.write("problem.json", far), "-o", "-")
        self.assertNotIn("nan", ran[1].lower())
        result = json.loads(ran[1])
        self.assertEqual(result["linkages"], [])
        self.assertIn("turn back before the ends of the stroke", result["reason"])
        self.assertEqual([(each["requirement"], each["value"]) for each in result["relax"]], [("max_deviation", None)])

        far["options"]["at"] = [100, 35]
        result = self.solve(far)
        self.assertTrue(result["linkages"])
        for linkage in result["linkages"]:
            self.assertIn("max_deviation", linkage["fails"])
        self.assertIn("turns back before the ends of the stroke", result["reason"])
        told = " ".join(run("solve", self.write("problem.json", far))[1].split())
        self.assertIn("– where the point turns back", told)

    def test_a_search_that_is_stopped_hands_over_the_best_so_far(self):
        problem = problem_of("search", effort=10_000_000)
        result, picture = self.folder / "result.json", self.folder / "sheet.svg"
        arguments = [CLI, "solve", str(self.write("problem.json", problem)), "-o", str(result), "--svg", str(picture)]
        with subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            time.sleep(1.5)
            process.send_signal(signal.SIGINT)
            output, error = process.communicate(timeout=600)
        self.assertEqual((process.returncode, error), (130, b""))
        self.assertIn(b"best so far", output)
        self.assertTrue(picture.exists())
        listed = load(result)["linkages"]
        self.assertTrue(listed)
        for linkage in listed:
            self.assertGreaterEqual(linkage["usable_strip"]["length"], problem["task"]["stroke"])

    def test_a_search_that_lists_nothing_tells_whether_there_is_anything(self):
        none, boxed = problem_of("search", best=0), problem_of("search")
        result = self.solve(none)
        self.assertEqual((result["status"], result["linkages"]), ("solved", []))
        boxed["requirements"] = {"ground_pivots_within": {"x": [500, 500], "y": [500, 500]}}
        self.assertEqual(self.solve(boxed)["status"], "no_solution")
        words = " ".join(run("solve", self.write("problem.json", boxed))[1].split())
        self.assertEqual(words.count("none has a linkage that runs straight"), 1)

    def test_a_search_against_its_own_requirements_says_so(self):
        for requirement, words in (({"min_stroke": 61}, "search for a stroke as long"),
                                   ({"max_deviation": 0.29}, "search for a deviation as small")):
            problem = problem_of("search", effort=2000) | {"requirements": requirement}
            with self.subTest(requirement):
                self.assertIn(words, " ".join(run("solve", self.write("problem.json", problem))[1].split()))

    def test_a_long_search_takes_no_more_memory_than_a_short_one(self):
        problem = problem_of("search", effort=1_000_000)
        with subprocess.Popen([CLI, "solve", str(self.write("problem.json", problem))], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        self.assertLess(usage.ru_maxrss, 60_000)  # kB; what is drawn comes to some 100 000

    def test_sliders_are_told_by_their_code(self):
        import base64
        problem = problem_of("four_point_cubic")
        problem["task"] = problem["task"] | {"cubic_n": None}
        region = self.solve(problem, "--region")["region"]
        codes = base64.b64decode(region["valid"])
        self.assertEqual(len(codes), 12 * 12)
        self.assertLessEqual(set(codes), {0, 2})
        self.assertIn(2, codes)

    def test_refusals(self):
        motion = load(ROOT / "examples/tailgate.json")
        line = problem_of("five_point")
        cases = [
            (motion | {"options": {"stroke": 5}}, "belong to straight lines"),
            (motion | {"options": {"objective": "stroke"}}, "objective"),
            (line | {"options": {"objective": "link_ratio"}}, "objective"),
            (line | {"requirements": {"min_length": 1}}, "min_length"),
            (line | {"requirements": {"no_defects": True}}, "no_defects"),
            (motion | {"requirements": {"min_stroke": 3}}, "min_stroke"),
        ]
        for problem, words in cases:
            with self.subTest(words):
                status, output, error = run("solve", self.write("problem.json", problem))
                self.assertEqual((status, output), (2, ""))
                self.assertIn(words, error)
        status, _, error = run("solve", self.write("problem.json", {"linkwright": 1, "task": line_task("crane")}))
        self.assertEqual(status, 2)
        self.assertIn("not known here", error)


if __name__ == "__main__":
    unittest.main()
