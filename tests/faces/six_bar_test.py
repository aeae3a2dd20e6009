"""Six-bars end to end: examples, files and pictures, and a search that is stopped with Ctrl-C."""

import csv
import io
import json
import math
import os
import pty
import re
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

from face_support import CLI, ROOT, FaceTest, load, run

SEARCH, CHAIN = ROOT / "examples/loader_bucket.json", ROOT / "examples/loader_bucket_chain.json"
HINGES = ("a", "b", "d", "c4", "z4", "c5", "z5")


def solved(path):
    status, output, error = run("solve", path, "-o", "-")
    if (status, error) != (0, ""):
        raise AssertionError(f"{path.name}: exit status {status}: {error}")
    return json.loads(output)


class SixBars(FaceTest):
    @classmethod
    def setUpClass(cls):
        cls.search, cls.chain = solved(SEARCH), solved(CHAIN)

    def export(self, result, form, number=1):
        path = self.write("result.json", result)
        status, output, error = run("export", path, "--linkage", number, "--format", form)
        self.assertEqual((status, error), (0, ""))
        return output

    def test_examples_find_what_they_promise(self):
        self.assertGreaterEqual(len(self.search["linkages"]), 3)
        self.assertGreaterEqual(len(self.chain["linkages"]), 3)
        self.assertEqual(self.search["search"]["chains_tried"], self.search["search"]["effort"])
        for result in (self.search, self.chain):
            wanted = result["problem"]["requirements"]
            self.assertEqual(result["status"], "solved")
            for linkage in result["linkages"]:
                self.assertIs(linkage["verified_by_driving"], True)
                self.assertFalse(any(linkage["defects"].values()))
                self.assertLess(max(linkage["residual"], linkage["pose_residual"]), 1e-9)
                self.assertGreaterEqual(linkage["min_transmission_angle_deg"], wanted["min_transmission_angle_deg"])
                self.assertLessEqual(linkage["link_ratio"], wanted["max_link_ratio"])
                self.assertLessEqual(max(linkage["lengths"].values()), wanted["max_length"])
                for hinge in ("a", "c4"):
                    for value, (low, high) in zip(linkage["joints"][hinge], wanted["ground_pivots_within"].values()):
                        self.assertTrue(low <= value <= high)

    def test_says_which_limits_the_best_touches(self):
        status, output, error = run("solve", CHAIN)
        self.assertEqual((status, error), (0, ""))
        self.assertIn("Six-bar 1 is at no limit of the requirements.", output)
        problem, best = load(CHAIN), self.chain["linkages"][0]
        problem["requirements"]["max_length"] = 1.001 * max(best["lengths"].values())
        lowest = min(best["joints"][hinge][1] for hinge in ("a", "c4"))
        problem["requirements"]["ground_pivots_within"]["y"] = [lowest - 0.5, lowest + 2000]
        status, output, error = run("solve", self.write("limits.json", problem))
        self.assertEqual((status, error), (0, ""))
        words = " ".join(output.split())
        self.assertIn("Six-bar 1 is at a limit of the requirements: ", words)
        self.assertIn("longest link at most", words.partition("at a limit")[2])
        self.assertRegex(words, "hinge (a|c4) at the border y = ")

    def test_counts_are_grouped_in_sentences(self):
        problem = load(CHAIN)
        problem["requirements"]["max_length"] = 10
        status, output, error = run("solve", self.write("short.json", problem))
        self.assertEqual((status, error), (0, ""))
        self.assertRegex(" ".join(output.split()), r"None of the six-bars looked at that are free of defects \(1 \d{3}\) meets all")

    def test_no_four_bar_does_it(self):
        problem = load(CHAIN)
        del problem["task"]["chain"], problem["task"]["added"]
        problem["task"]["mechanism"] = "four_bar"
        status, output, error = run("solve", "-", "-o", "-", input=json.dumps(problem))
        self.assertEqual((status, error), (0, ""))
        self.assertEqual(json.loads(output)["linkages"], [])

    def test_a_search_finds_better_than_one_good_chain_has(self):
        found, chosen = (result["linkages"][0]["min_transmission_angle_deg"] for result in (self.search, self.chain))
        self.assertGreater(found, chosen)

    def test_the_list_of_examples_is_true(self):
        text = (ROOT / "examples/README.md").read_text(encoding="utf-8")
        words = re.sub(r"\s+", " ", text[text.index("## Six-bars"):])
        counts = self.chain["region"]["counts"]
        for said in (f"{self.search['search']['effort'] // 1000} 000 chains",
                     f"{counts['defect_free']:,} are free of defects".replace(",", " "),
                     f"{self.chain['region']['meeting_requirements']} meet the requirements"):
            self.assertIn(said, words)

    def test_the_table_drives_through_the_poses(self):
        """Distances within the bodies, poses, sweep and transmission angle, from the table alone."""
        for result in (self.search, self.chain):
            linkage = result["linkages"][0]
            rows = list(csv.DictReader(io.StringIO(self.export(result, "csv"))))
            self.assertGreater(len(rows), linkage["driver_sweep_deg"])
            turns = [float(row["driver_turn_from_position_1_deg"]) for row in rows]
            self.assertEqual(turns, sorted(turns))
            self.assertAlmostEqual(turns[-1], linkage["driver_sweep_deg"], places=6)
            self.assertEqual([row["position"] for row in rows if row["position"]], ["1", "2", "3", "4"])
            for row in rows:
                at = {hinge: complex(float(row[hinge + "_x"]), float(row[hinge + "_y"])) for hinge in HINGES}
                for name, length in linkage["lengths"].items():
                    one, other = name.split(":")[1].split("-")
                    self.assertAlmostEqual(abs(at[one] - at[other]) / length, 1, delta=1e-9)
                if row["position"]:
                    pose = result["problem"]["task"]["poses"][int(row["position"]) - 1]
                    for key, value in (("body_x", pose["x"]), ("body_y", pose["y"]), ("body_theta_deg", pose["theta_deg"])):
                        self.assertAlmostEqual(float(row[key]), value, places=5)
            least = min(float(row["transmission_angle_deg"]) for row in rows)
            self.assertAlmostEqual(least, linkage["min_transmission_angle_deg"], delta=0.1)  # at the rows alone

    def test_json_is_accepted_by_analyze(self):
        for number, linkage in enumerate(self.search["linkages"], start=1):
            exported = self.write("linkage.json", self.export(self.search, "json", number))
            self.assertEqual(load(exported)["linkage"], linkage)
            analysis = json.loads(run("analyze", exported, "-o", "-")[1])
            self.assertEqual(analysis["joints"], linkage["joints"])
            self.assertEqual(analysis["lengths"], linkage["lengths"])
            self.assertEqual((analysis["type"], analysis["topology"]), (linkage["type"], linkage["topology"]))
            self.assertAlmostEqual(analysis["min_transmission_angle_deg"], linkage["min_transmission_angle_deg"], delta=0.005)
            low, high = analysis["driver_range_deg"]
            self.assertTrue(low <= 0 and high >= linkage["driver_sweep_deg"])

    def test_analyze_says_it_in_words(self):
        exported = self.write("linkage.json", self.export(self.search, "json"))
        status, output, error = run("analyze", exported)
        self.assertEqual((status, error), (0, ""))
        linkage = self.search["linkages"][0]
        for piece in ("Watt I by 0-2 and 1-3", "driven by body 1", "The driver rocks from", f"{linkage['driver_sweep_deg']:.2f}°",
                      "minimum transmission angle"):
            self.assertIn(piece, " ".join(output.split()))
        self.assert_mistake(run("analyze", exported, "--drive", "output"), "--drive", "leave --drive out")
        table = self.folder / "motion.csv"
        self.assertEqual(run("analyze", exported, "-o", table)[0], 0)
        self.assertIn("driver_turn_from_position_1_deg", table.read_text(encoding="utf-8"))

    def test_drawings_can_be_read(self):
        for form in ("svg", "dxf"):
            self.assertNotIn("nan", self.export(self.chain, form))
        xml.etree.ElementTree.fromstring(self.export(self.chain, "svg"))
        for path in (SEARCH, CHAIN):
            picture = self.folder / "picture.svg"
            self.assertEqual(run("solve", path, "--svg", picture)[0], 0)
            texts = "".join(xml.etree.ElementTree.parse(picture).getroot().itertext())
            self.assertIn("Watt I by 0-2 and 1-3", texts)
            self.assertLess(picture.stat().st_size, 300_000)

    def test_dxf_draws_bodies_on_their_layers(self):
        try:
            import ezdxf
        except ImportError:
            self.skipTest("python3-ezdxf is not installed")
        path = self.folder / "linkage.dxf"
        path.write_text(self.export(self.search, "dxf"), encoding="utf-8")
        document = ezdxf.readfile(path)
        self.assertFalse(document.audit().has_errors)
        joints = self.search["linkages"][0]["joints"]
        for body, hinges in ((1, "a b c5"), (2, "b d z4")):  # the ternary links
            outline, = document.modelspace().query(f'LWPOLYLINE[layer=="BODY_{body}"]')
            self.assertTrue(outline.closed)
            drawn = sorted((x, y) for x, y, *_ in outline.get_points())
            for corner, hinge in zip(drawn, sorted(joints[name] for name in hinges.split())):
                self.assertAlmostEqual(math.dist(corner, hinge), 0, delta=1e-6)
        for body in (3, 4, 5):
            self.assertEqual(len(document.modelspace().query(f'CIRCLE[layer=="BODY_{body}"]')), 2)

    def test_the_picture_is_the_programs(self):
        picture = self.folder / "fresh.svg"
        self.assertEqual(run("solve", "examples/loader_bucket_chain.json", "--svg", picture, cwd=ROOT)[0], 0)
        texts = [[node.text for node in xml.etree.ElementTree.parse(path).iter() if (node.text or "").strip()]
                 for path in (ROOT / "docs/six_bar.svg", picture)]
        self.assertEqual(*texts, "renew it: linkwright solve examples/loader_bucket_chain.json --svg docs/six_bar.svg")

    def test_the_answer_says_what_was_searched_and_found(self):
        status, output, error = run("solve", SEARCH)
        self.assertEqual((status, error), (0, ""))
        for piece in ("six-bar for four positions (P-P-P-P), Watt I by 0-2 and 1-3", "Tried 200 000 chains", "seed 1", "c4 (0-4)",
                      f"{self.search['linkages'][0]['min_transmission_angle_deg']:.1f}°", "verified every six-bar"):
            self.assertIn(piece, " ".join(output.split()))
        self.assertLessEqual(max(map(len, output.splitlines())), 100)

    def test_results_agree_with_the_schema(self):
        try:
            from schema_test import jsonschema, schemas
        except ImportError:
            jsonschema = None
        if jsonschema is None:
            self.skipTest("python3-jsonschema is not installed")
        problem, result = schemas()
        for found in (self.search, self.chain):
            result.validate(found)
            problem.validate(found["problem"])


class Interrupted(FaceTest):
    """A search of minutes, stopped after a second."""

    def stop(self, after=1.0, **requirements):
        problem = load(SEARCH)
        problem["options"]["effort"] = 2_000_000
        problem["requirements"] |= requirements
        result = self.folder / "result.json"
        arguments = [CLI, "solve", str(self.write("problem.json", problem)), "-o", str(result), "--svg", str(self.folder / "p.svg")]
        with subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            time.sleep(after)
            process.send_signal(signal.SIGINT)
            output, error = process.communicate(timeout=600)
        self.assertEqual((process.returncode, error), (130, b""))
        xml.etree.ElementTree.parse(self.folder / "p.svg")
        return load(result), output.decode()

    def test_keeps_the_best_so_far(self):
        # Defects allowed: the very first chains have something to show.
        result, output = self.stop(no_defects=False, min_transmission_angle_deg=None)
        self.assertIs(result["search"]["interrupted"], True)
        self.assertLess(result["search"]["chains_tried"], 2_000_000)
        self.assertTrue(result["linkages"])
        for linkage in result["linkages"]:
            self.assertIs(linkage["verified_by_driving"], True)
        self.assertIn("Stopped early", output)
        self.assertIn("best so far", output)
        self.assertIn("Best six-bars", output)

    def test_says_that_nothing_is_found_so_far(self):
        result, output = self.stop(min_transmission_angle_deg=89)
        self.assertEqual(result["linkages"], [])
        self.assertIs(result["search"]["interrupted"], True)
        self.assertIn("nothing is found so far", output)

    def test_shows_progress_on_a_terminal(self):
        terminal, end = pty.openpty()
        with subprocess.Popen([CLI, "solve", str(SEARCH)], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=end) as process:
            os.close(end)
            shown = b""
            try:
                while piece := os.read(terminal, 4096):
                    shown += piece
            except OSError:  # closed at the other end
                pass
            os.close(terminal)
            self.assertEqual(process.wait(timeout=600), 0)
        percents = [int(text) for text in re.findall(rb"(\d+) %", shown)]
        self.assertGreater(len(percents), 10)
        self.assertEqual(percents, sorted(percents))


if __name__ == "__main__":
    unittest.main()
