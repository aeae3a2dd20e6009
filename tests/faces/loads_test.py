"""Loads as the program tells them: tables, files, mistakes."""

import csv
import json
import math
import unittest
import xml.etree.ElementTree

from face_support import ROOT, FaceTest, load, run


class LoadsTest(FaceTest):
    def solved(self, name="tailgate_struts", **options):
        problem = load(ROOT / f"examples/{name}.json")
        problem.setdefault("options", {}).update(options)
        result = self.folder / f"{name}_result.json"
        status, _, error = run("solve", self.write(f"{name}.json", json.dumps(problem)), "-o", result)
        self.assertEqual((status, error), (0, ""))
        return result

    def test_curves_meet_the_read_outs(self):
        result = self.solved(region_samples=120)
        linkage = json.loads(result.read_text())["linkages"][0]
        table = self.folder / "curves.csv"
        self.assertEqual(run("loads", result, "-o", table)[0], 0)
        rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
        for case in linkage["loads"]["cases"]:
            own = [row for row in rows if row["case"] == case["name"]]
            self.assertEqual(len(own), 3 * 24 + 1)
            opening = [float(row["open_N"]) for row in own]
            closing = [float(row["close_N"]) for row in own]
            self.assertAlmostEqual(-opening[-1], case["hold_open"], places=8)
            self.assertAlmostEqual(-opening[0], case["pop_up"], places=8)
            self.assertAlmostEqual(closing[-1], case["close_start"], places=8)
            for most, forces in ((case["max_open_force"], opening), (case["max_close_force"], closing)):
                self.assertGreaterEqual(most, max(forces) - 1e-9)
                self.assertLess(most - max(forces), 0.05)
            spring = case["springs"][0]["length"]
            self.assertAlmostEqual(min(float(row["strut.length"]) for row in own), spring[0], places=6)
            joints = [math.hypot(float(row["output_ground.x_N"]), float(row["output_ground.y_N"])) for row in own]
            self.assertLessEqual(max(joints), case["pins"]["output_ground"]["max"] + 1e-6)

    def test_a_requirement_is_kept_by_all_that_is_listed(self):
        linkages = json.loads(self.solved(region_samples=200, best=20).read_text())["linkages"]
        self.assertTrue(linkages)
        for linkage in linkages:
            worst = linkage["loads"]["worst"]
            self.assertLessEqual(worst["max_open_force"]["value"], 40)
            self.assertLessEqual(worst["max_close_force"]["value"], 150)
            self.assertGreaterEqual(worst["hold_open"]["value"], 3)

    def test_a_strength_left_free_is_that_of_all_cases(self):
        loads = load(ROOT / "examples/tailgate_struts.json")["loads"]
        loads["springs"][0]["best_F1"] = {"max_F1": 900, "min_hold_open": 3}
        problem = load(ROOT / "examples/tailgate_struts.json") | {"loads": loads, "options": {"region_samples": 60}}
        result = self.folder / "free_result.json"
        self.assertEqual(run("solve", self.write("free.json", json.dumps(problem)), "-o", result)[0], 0)
        told = json.loads(result.read_text())["linkages"][0]["loads"]
        self.assertGreaterEqual(told["worst"]["hold_open"]["value"], 3)
        words = f"F1 that is left free: {told['best_F1']:.4g} N"
        self.assertIn(words, run("loads", result)[1])
        report = self.folder / "cold.json"
        self.assertEqual(run("loads", result, "--case", "cold", "-o", report)[0], 0)
        cold = json.loads(report.read_text())
        self.assertAlmostEqual(cold["loads"]["springs"][0]["F1"], told["best_F1"], places=6)
        own = next(case for case in told["cases"] if case["name"] == "cold")
        self.assertAlmostEqual(cold["report"]["cases"][0]["max_close_force"], own["max_close_force"], places=6)

    def test_files_are_what_their_names_say(self):
        result = self.solved("cylinder_bucket", region_samples=80)
        report, picture = self.folder / "report.json", self.folder / "picture.svg"
        self.assertEqual(run("loads", result, "--case", "room", "-o", report)[0], 0)
        told = json.loads(report.read_text())
        self.assertEqual([case["name"] for case in told["report"]["cases"]], ["room"])
        self.assertGreater(told["report"]["worst"]["cylinder_force"]["value"], 0)
        self.assertIsNone(told["report"]["cases"][0]["max_open_force"])
        self.assertEqual(run("loads", result, "-o", picture)[0], 0)
        xml.etree.ElementTree.parse(picture)

    def test_a_motion_is_told_in_time(self):
        loads = load(ROOT / "examples/tailgate_struts.json")["loads"]
        loads |= {"drive": "input", "motion": {"law": "cycloid", "duration_s": 0.9}}
        problem = load(ROOT / "examples/tailgate_struts.json") | {
            "loads": loads, "options": {"region_samples": 60}, "requirements": {"min_transmission_angle_deg": 30}}
        result, table, picture = (self.folder / f"moving.{end}" for end in ("result", "csv", "svg"))
        self.assertEqual(run("solve", self.write("moving.json", json.dumps(problem)), "-o", result)[0], 0)
        case = json.loads(result.read_text())["linkages"][0]["loads"]["cases"][0]
        self.assertEqual((case["equilibria"], case["rests"]), ([], []))
        self.assertIn("on the ground, N", run("loads", result, "-o", table)[1])
        own = [row for row in csv.DictReader(table.read_text(encoding="utf-8").splitlines()) if row["case"] == case["name"]]
        times = [float(row["time_s"]) for row in own]
        self.assertEqual((times[0], round(times[-1], 9)), (0, 0.9))
        self.assertEqual(times, sorted(times))
        shaking = [math.hypot(float(row["shaking.x_N"]), float(row["shaking.y_N"])) for row in own]
        self.assertLessEqual(max(shaking), case["shaking"]["max"] + 1e-6)
        self.assertAlmostEqual(float(own[0]["driver_rad_per_s"]), 0)
        self.assertEqual(run("loads", result, "-o", picture)[0], 0)
        self.assertIn("Force on the ground", picture.read_text(encoding="utf-8"))

    def test_a_balance_by_real_springs_leaves_what_it_says(self):
        result, report = self.solved(region_samples=60), self.folder / "balance.json"
        words = run("loads", result, "--balance", "--free-share", "0.6", "-o", report)[1]
        self.assertIn("a free length of 0.6 of their shortest length", " ".join(words.split()))
        told = json.loads(report.read_text())
        real = told["balance"]["real_springs"]
        self.assertEqual(real["free_share"], 0.6)
        problem = json.loads(result.read_text())["problem"]
        problem["loads"] |= {"springs": real["one"]["springs"], "cases": problem["loads"]["cases"][:1]}
        del problem["loads"]["pins"]
        problem["requirements"] = {}
        place = json.loads(result.read_text())["linkages"][0]
        problem["options"] = {"region_samples": 60, "at": [place["input"]["coordinate"], place["output"]["coordinate"]]}
        again = self.folder / "again.json"
        self.assertEqual(run("solve", self.write("balanced.json", json.dumps(problem)), "-o", again)[0], 0)
        worst = json.loads(again.read_text())["linkages"][0]["loads"]["worst"]
        self.assertAlmostEqual(worst["hand_force"]["value"], real["one"]["residual_hand_force"], places=5)
        self.assertLess(real["one"]["residual_hand_force"], real["hand_force_without"] / 10)
        status, _, error = run("loads", result, "--balance", "--free-share", "2")
        self.assertEqual(status, 2)
        self.assertIn("--free-share", error)

    def test_springs_are_placed_and_proven(self):
        result = self.solved(region_samples=80)
        boxes, parts = ROOT / "examples/springs/tailgate_boxes.json", ROOT / "examples/springs/catalogue.json"
        report = self.folder / "placed.json"
        status, output, error = run("loads", result, "--place-springs", boxes, "-o", report)
        self.assertEqual((status, error), (0, ""))
        placed = json.loads(report.read_text())
        self.assertIs(placed["proven"], True)
        self.assertLessEqual(placed["lower_bound"], placed["at_stations"])
        self.assertGreaterEqual(placed["max_hand_force"], placed["at_stations"] - 1e-6)
        for part in ("Largest force of the hand", "proven to 5.0 %"):
            self.assertIn(part, " ".join(output.split()))
        spring = placed["spring"]
        for axis, (low, high) in enumerate(((50, 250), (-45, 275))):
            self.assertTrue(low <= spring["from"]["at"][axis] <= high)
        self.assertGreaterEqual(spring["extended_length"], 2 * spring["stroke"] + 65 - 1e-6)
        self.assertIn("Parts of the catalogue", run("loads", result, "--place-springs", boxes, "--catalogue", parts)[1])

    def test_pictures_and_assemblies_have_the_springs(self):
        result = self.solved(region_samples=60)
        drawn = run("export", result, "--format", "svg")[1]
        bare = load(result)
        del bare["problem"]["loads"], bare["problem"]["options"]["objective"]
        for limit in ("max_open_force", "max_close_force", "min_hold_open"):
            del bare["problem"]["requirements"][limit]
        plain = run("export", self.write("bare.json", json.dumps(bare)), "--format", "svg")[1]
        self.assertEqual(drawn.count("<circle") - plain.count("<circle"), 2 + 4 + 1)  # studs, masses, handle
        xml.etree.ElementTree.fromstring(drawn)
        status, step, error = run("export", result, "--format", "step", "--position", 4)
        self.assertEqual((status, error), (0, ""))
        for part in ("stud_strut_from", "stud_strut_to", "strut_tube", "strut_rod"):
            self.assertIn(f"'{part}'", step)

    def test_limits_of_forces_are_told_with_their_unit(self):
        words = " ".join(run("solve", ROOT / "examples/tailgate_struts.json", "--samples", 40)[1].split())
        self.assertIn("opening force at most 40 N, closing force at most 150 N, hold-open force at least 3 N", words)
        bucket = load(ROOT / "examples/cylinder_bucket.json")
        bucket["loads"]["drive"] = "input"
        bucket["requirements"]["max_torque"] = 0.5
        told = {}
        for unit in ("mm", "furlong"):
            bucket["length_unit"] = unit
            told[unit] = " ".join(run("solve", self.write("bucket.json", json.dumps(bucket)), "--samples", 40)[1].split())
        self.assertIn("driving torque at most 0.5 N·m", told["mm"])
        self.assertIn("driving torque at most 0.5 N·furlong", told["furlong"])

    def test_mistakes_of_boxes_say_where(self):
        result = self.solved(region_samples=40)
        boxes = load(ROOT / "examples/springs/tailgate_boxes.json")
        wrong = self.write("wrong.json", json.dumps({**boxes, "ground": {"x": [9, 1], "y": [0, 1]}}))
        good = self.write("good.json", json.dumps(boxes))
        cubits = self.write("cubits.json", json.dumps({**load(ROOT / "examples/springs/catalogue.json"), "length_unit": "cubit"}))
        for words, part in ((["--place-springs", wrong], "ground.x"),
                            (["--place-springs", self.folder / "none.json"], "none.json"),
                            (["--place-springs", good, "-o", "places.csv"], "written as .json"),
                            (["--place-springs", good, "--case", "hot"], "all cases"),
                            (["--place-springs", good, "--catalogue", wrong], f"{wrong}: linkwright_catalogue"),
                            (["--place-springs", good, "--catalogue", cubits], f"{cubits}: length_unit"),
                            (["--place-springs", good, "--linkage", "99"], f"{result}: --linkage"),
                            (["--catalogue", good], "--place-springs")):
            with self.subTest(words=[str(word) for word in words]):
                status, output, error = run("loads", result, *words, cwd=self.folder)
                self.assertEqual((status, output), (2, ""))
                self.assertIn(part, error)

    def test_mistakes_say_what_is_wrong(self):
        result = self.solved("cylinder_bucket", region_samples=40)
        plain = self.folder / "plain.json"
        self.assertEqual(run("solve", ROOT / "examples/tailgate.json", "-o", plain)[0], 0)
        for words, part in ((["loads", result, "--case", "warm"], "no case \"warm\""),
                            (["loads", result, "-o", "curves.pdf"], "a table ends in .csv"),
                            (["loads", result, "--linkage", "99"], "linkage"),
                            (["loads", plain], "has no loads")):
            with self.subTest(words=words[2:]):
                status, output, error = run(*words, cwd=self.folder)
                self.assertEqual((status, output), (2, ""))
                self.assertIn(part, error)
        self.assertFalse((self.folder / "curves.pdf").exists())


if __name__ == "__main__":
    unittest.main()
