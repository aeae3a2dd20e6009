"""The commands end to end: solve, analyze, export."""

import csv
import io
import json
import math
import subprocess
import unittest
import xml.etree.ElementTree

from face_support import CLI, ROOT, TAILGATE, FaceTest, load, run


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


class Solve(FaceTest):
    def test_answers_people_in_words(self):
        status, output, error = run("solve", TAILGATE)
        self.assertEqual((status, error), (0, ""))
        for piece in ("Tailgate hinge", "two branches", "159 600", "free of defects", "25 608", "at least 30°",
                      "at most 450 mm", "Best linkages", "ground", "moving pivot", "Linkage 1", "linkage 2"):
            self.assertIn(piece, " ".join(output.split("\n")))
        self.assertLessEqual(max(len(line) for line in output.splitlines()), 100)

    def test_says_by_what_a_spherical_linkage_is_the_best(self):
        status, output, _ = run("solve", ROOT / "examples/universal_joint_like.json", "--samples", 60)
        self.assertEqual(status, 0)
        self.assertIn("Best linkages, smallest structural error first:\n", output)

    def test_the_flag_wins_over_the_file(self):
        problem = load(TAILGATE) | {"options": {"region_samples": 30}}
        path = self.write("problem.json", problem)
        self.assertEqual(json.loads(run("solve", path, "-o", "-")[1])["region"]["samples"], 30)
        self.assertEqual(json.loads(run("solve", path, "--samples", 20, "-o", "-")[1])["region"]["samples"], 20)

    def test_reads_standard_input(self):
        with open(TAILGATE, "rb") as problem:
            status, output, _ = run("solve", "-", "--samples", 32, stdin=problem)
        self.assertEqual(status, 0)
        self.assertIn("Tailgate hinge", output)
        status, _, error = run("solve", "-")
        self.assertEqual(status, 2)
        self.assertTrue(error.startswith("standard input: "))

    def test_solving_the_echo_gives_the_same_result(self):
        first = load(self.solve_tailgate("--region"))
        again = json.loads(run("solve", self.write("echo.json", first["problem"]), "-o", "-", "--region")[1])
        self.assertEqual(first, again)

    def test_arrays_come_only_with_region(self):
        self.assertNotIn("type", load(self.solve_tailgate())["region"])
        self.assertIn("type", load(self.solve_tailgate("--region"))["region"])

    def test_draws_a_well_formed_picture(self):
        problem = load(TAILGATE) | {"title": "<Tailgate & \"hinge\"> \u0007 门"}
        picture = self.folder / "picture.svg"
        self.assertEqual(run("solve", self.write("problem.json", problem), "--svg", picture)[0], 0)
        root = xml.etree.ElementTree.parse(picture).getroot()
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        self.assertLess(picture.stat().st_size, 300_000)
        texts = "".join(root.itertext())
        for piece in ("<Tailgate & \"hinge\">", "Solution region", "Triple rocker, input longest", "100 mm"):
            self.assertIn(piece, texts)

    def test_no_solution_is_an_answer(self):
        problem = load(TAILGATE)
        problem["requirements"]["min_transmission_angle_deg"] = 89
        status, output, error = run("solve", self.write("problem.json", problem), "-o", self.folder / "result.json")
        self.assertEqual((status, error), (0, ""))
        self.assertEqual(load(self.folder / "result.json")["linkages"], [])
        self.assertIn("would leave", output)

    def test_what_dropping_a_requirement_leaves_is_said_once(self):
        problem = load(TAILGATE)
        problem["requirements"]["ground_pivots_within"] = {"x": [5000, 5010], "y": [5000, 5010]}
        status, output, error = run("solve", self.write("problem.json", problem))
        self.assertEqual((status, error), (0, ""))
        words = " ".join(output.split())
        self.assertIn("ground_pivots_within is the most restrictive: without it ", words)
        self.assertNotIn("Without ground_pivots_within", words)

    def test_translations_are_an_answer(self):
        problem = load(TAILGATE)
        for pose in problem["task"]["poses"]:
            pose["theta_deg"] = 12
        status, output, _ = run("solve", self.write("problem.json", problem), "--svg", self.folder / "picture.svg")
        self.assertEqual(status, 0)
        self.assertIn("parallel", output)
        xml.etree.ElementTree.parse(self.folder / "picture.svg")

    def test_help_and_version(self):
        for arguments in (("--help",), ("solve", "--help"), ("analyze", "--help"), ("export", "--help")):
            status, output, error = run(*arguments)
            self.assertEqual((status, error), (0, ""))
            self.assertIn("linkwright" if arguments == ("--help",) else "--", output)
        self.assertRegex(run("--version")[1], r"^linkwright \d+\.\d+\.\d+\n$")


class CommandLine(FaceTest):
    def test_a_mistyped_command_is_guessed(self):
        for words, meant in ((["solv", TAILGATE], "solve"), (["analyse", TAILGATE], "analyze"), (["attitude", "convrt"], "convert")):
            status, output, error = run(*words)
            self.assertEqual((status, output, error.count("\n")), (2, "", 1))
            self.assertIn(f"did you mean {meant}?", error)

    def test_an_empty_text_is_no_value(self):
        for flags in (["--samples", ""], ["-o", ""], ["--svg", ""]):
            status, output, error = run("solve", TAILGATE, *flags)
            self.assertEqual((status, output), (2, ""), flags)
            self.assertIn("not an empty text", error)
        self.assertEqual(run("studio", "--port", "")[0], 2)
        self.assertEqual(run("solve", "")[0], 2)


class Analyze(FaceTest):
    CRANK_ROCKER = {"lengths": {"ground": 4, "input": 2, "coupler": 3, "output": 3.5}}

    def test_names_the_type_and_the_angles(self):
        status, output, _ = run("analyze", self.write("linkage.json", self.CRANK_ROCKER))
        self.assertEqual(status, 0)
        self.assertIn("Crank-rocker", output)
        self.assertIn("turns fully", output)
        status, output, _ = run("analyze", self.folder / "linkage.json", "--drive", "output")
        self.assertIn("Rocker-crank", output)
        self.assertIn("dead point", output)

    def test_change_points_by_barker(self):
        kite = {"lengths": {"ground": 4, "input": 4, "coupler": 2, "output": 2}}
        self.assertIn("parallelogram or kite", run("analyze", self.write("linkage.json", kite))[1])

    def test_writes_json_and_csv(self):
        path = self.write("linkage.json", self.CRANK_ROCKER)
        self.assertEqual(run("analyze", path, "-o", self.folder / "a.json")[0], 0)
        analysis = load(self.folder / "a.json")
        self.assertEqual(analysis["type"], "crank_rocker")
        self.assertEqual(len(analysis["motion"]["input_angle_deg"]), 361)
        self.assertEqual(run("analyze", path, "-o", self.folder / "a.csv")[0], 0)
        with open(self.folder / "a.csv", encoding="utf-8", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual(len(rows), 361)
        for row, output in zip(rows, analysis["motion"]["output_angle_deg"], strict=True):
            self.assertAlmostEqual(float(row["output_angle_from_x_deg"]), output, places=9)  # its ground link lies along x
        self.assertEqual(json.loads(run("analyze", path, "-o", "-")[1]), analysis)

    def test_links_that_cannot_close(self):
        path = self.write("linkage.json", {"lengths": {"ground": 10, "input": 1, "coupler": 2, "output": 3}})
        self.assert_mistake(run("analyze", path), "lengths", "do not close")

    def test_a_result_file_points_to_export(self):
        self.assert_mistake(run("analyze", self.solve_tailgate()), "linkages", "linkwright export")


class Export(FaceTest):
    def export(self, result, form, number=1):
        status, output, error = run("export", result, "--linkage", number, "--format", form)
        self.assertEqual((status, error), (0, ""))
        return output

    def test_json_is_accepted_by_analyze(self):
        result = self.solve_tailgate()
        for number, linkage in enumerate(load(result)["linkages"], start=1):
            exported = self.write("linkage.json", self.export(result, "json", number))
            self.assertEqual(load(exported)["linkage"], linkage)
            analysis = json.loads(run("analyze", exported, "-o", "-")[1])
            self.assertEqual(analysis["type"], linkage["type"])
            for link, length in linkage["lengths"].items():
                self.assertAlmostEqual(analysis["lengths"][link], length, delta=1e-9 * length)

    def test_csv_passes_the_poses(self):
        result = self.solve_tailgate()
        linkage = load(result)["linkages"][0]
        rows = list(csv.DictReader(io.StringIO(self.export(result, "csv"))))
        center = linkage["input"]["center_point"]
        for row in rows:
            pivot = (float(row["input_circle_x"]), float(row["input_circle_y"]))
            self.assertAlmostEqual(distance(center, pivot), linkage["lengths"]["input"], delta=1e-6)
        met = [row for row in rows if row["position"]]
        self.assertEqual([row["position"] for row in met], ["1", "2", "3", "4"])
        self.assertIs(met[0], rows[0])
        for row, pose in zip(met, load(TAILGATE)["task"]["poses"], strict=True):
            self.assertAlmostEqual(float(row["body_x"]), pose["x"], places=6)
            self.assertAlmostEqual(float(row["body_y"]), pose["y"], places=6)
            self.assertAlmostEqual(float(row["body_theta_deg"]), pose["theta_deg"], places=6)
            self.assertLess(float(row["position_error"]), 1e-6)
            self.assertLess(float(row["orientation_error_deg"]), 1e-6)

    def test_svg_is_well_formed(self):
        root = xml.etree.ElementTree.fromstring(self.export(self.solve_tailgate(), "svg"))
        self.assertIn("Tailgate hinge, linkage 1", "".join(root.itertext()))

    def test_writes_a_file(self):
        picture = self.folder / "linkage.svg"
        self.assertEqual(run("export", self.solve_tailgate(), "--format", "svg", "-o", picture)[0], 0)
        xml.etree.ElementTree.parse(picture)

    def test_result_without_linkages(self):
        problem = load(TAILGATE)
        problem["requirements"]["max_length"] = 1
        result = self.folder / "result.json"
        run("solve", self.write("problem.json", problem), "-o", result)
        self.assert_mistake(run("export", result, "--format", "svg"), "holds no linkages")

    def test_result_with_a_large_region(self):
        result = self.folder / "result.json"
        self.assertEqual(run("solve", TAILGATE, "--samples", 1000, "--region", "-o", result)[0], 0)
        self.assertGreater(result.stat().st_size, 20 << 20)
        self.assertIn("<svg", self.export(result, "svg"))

    def test_closed_pipe_is_no_crash(self):
        with subprocess.Popen([CLI, "export", str(self.solve_tailgate()), "--format", "dxf"], stdout=subprocess.PIPE) as process:
            process.stdout.read(10)
            process.stdout.close()
            self.assertNotIn(process.wait(timeout=300), (-6, -11))


if __name__ == "__main__":
    unittest.main()
