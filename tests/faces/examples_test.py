"""The examples hold what they promise: every linkage found is measured and driven again here, from its pivots alone."""

import bisect
import cmath
import json
import math
import re
import unittest

from attitude_support import quaternion_of
from driven_linkages import STEPS, FourBar, Pose, SixBar, SphericalFourBar, Surroundings, dot3, drive, input_turns
from face_support import ROOT, FaceTest, load, run

ALL = sorted((ROOT / "examples").glob("*.json"))
LINES = [path for path in ALL if path.stem.startswith("straight_")]  # what they find is traced in straight_line_test.py
EXAMPLES = [path for path in ALL if path not in LINES]

PATTERNS = {"tailgate": "P-P-P-P", "tailgate_struts": "P-P-P-P", "counterbalanced_lid": "P-P-P-P", "cylinder_bucket": "P-P-P-P",
            "hood_strut": "P-P-P-P",
            "drawer_hinge": "P-P-P-P", "dump_bucket": "P-P-P-P", "landing_gear": "P-P-P-P",
            "folding_table": "P-P-P-P", "lift_platform": "P-P-P-P", "hood_hinge": "PP-P-P", "corner_drawer": "PPP-P",
            "latch": "P-P-P", "bin_lid": "P-P-P", "bracket_hatch": "P-P-P", "rail_tailgate": "P-P-P-P",
            "airtight_hatch": "P-P-P", "footrest": "P-P-P", "nose_gear": "P-P-P-P-P", "transfer_arm": "PP-P-PP",
            "sine_generator": "P-P-P-P", "log_generator": "P-P-P-P-P", "flow_meter": "P-P-P-P", "flow_meter_as_made": "P-P-P-P", "tailgate_as_made": "P-P-P-P",
            "loader_bucket": "P-P-P-P", "loader_bucket_chain": "P-P-P-P",
            "folding_wing": "P-P-P-P", "wrist_orthosis": "P-P-P-P", "antenna_pointing": "P-P-P-P",
            "ankle_orthosis": "P-P-P-P-P", "universal_joint_like": "P-P-P-P", "film_claw": "P-P-P-P",
            "dough_mixer": "P-P-P-P-P", "windscreen_wiper": "P-P-P", "thread_take_up": "PP-P-P",
            "walking_leg_path": "P-P-P-P-P", "packaging_feeder": "P-P-P-P-P", "garage_door_point": "P-P-P-P-P",
            "bean_stirrer": "16 points", "walking_foot": "19 points", "film_advance": "15 points", "letter_loop": "22 points",
            "transfer_arch": "15 points", "hatch_by_hand": "P-P-P-P", "hatch_all_near": "8 poses", "digitised_knee": "15 poses"}
NEAR = {name for name, pattern in PATTERNS.items() if pattern.endswith(("points", "poses"))}  # searched for: not all that there are
TOLD_OF_NEAR = {"path_fitted", "nearer_with_defects", "path_tolerance_missed", "path_strays", "more_than_best", "poses_fitted",
                "nearer_poses_with_defects", "pose_tolerance_missed"}

# What the function generators are to generate.
WANTED = {"sine_generator": lambda x: math.sin(math.radians(x)), "log_generator": math.log10, "flow_meter": math.sqrt,
          "flow_meter_as_made": math.sqrt}

FAR = 1e4
SURROUNDINGS = {
    "drawer_hinge": Surroundings([(0, 0), (19, 0), (19, 150), (0, 150)],
                                 (-FAR, -1, 0, 16), (-FAR, 19, -FAR, -4)),  # the drawer's floor; the front below
    "dump_bucket": Surroundings([(0, 0), (-700, 150), (-650, -250), (-250, -350)],
                                (150, FAR, -FAR, 560), (-FAR, FAR, -FAR, -385)),  # the hopper; the ground
    "folding_table": Surroundings([(300, 420), (325, 420), (325, 1020), (300, 1020)],
                                  (-FAR, 300, -FAR, 405), (-FAR, 300, 1035, FAR), (-FAR, 0, -FAR, FAR)),  # cabinet; wall
    "lift_platform": Surroundings([(0, 0), (600, 0)], (-FAR, FAR, -FAR, -1e-6)),  # the floor
}


def errors(bars, function, written, scale):
    """Largest error of the output in degrees at the precision points, and over the range."""
    (low, high), count = written["x"], written["points"]
    points = [(low + high) / 2 - (high - low) / 2 * math.cos((2 * i + 1) * math.pi / (2 * count)) for i in range(count)]
    input_range, output_range = (written[key] for key in ("input_range_deg", "output_range_deg"))

    def dial(ends, share):
        return ends[0] + (ends[1] - ends[0]) * share

    def error(x, near):
        turned = dial(input_range, (x - low) / (high - low)) - dial(input_range, (points[0] - low) / (high - low))
        _, joint = bars.driven_to(math.radians(turned), near)
        generated = math.degrees(cmath.phase((joint - bars.output_center) / (bars.output_circle - bars.output_center)))
        rise = (function(x) - function(points[0])) / (function(high) - function(low))
        wanted = scale * (output_range[1] - output_range[0]) * rise
        return joint, abs((generated - wanted + 180) % 360 - 180)

    at_points = between = 0
    for end in (low, high):
        joint = bars.output_circle
        for x in sorted({*points, *(points[0] + (end - points[0]) * i / 1000 for i in range(1001))}, key=lambda x: abs(x - points[0])):
            if (x - points[0]) * (end - points[0]) >= 0:
                joint, wrong = error(x, joint)
                between = max(between, wrong)
                at_points = max(at_points, wrong if x in points else 0)
    return at_points, between


def longest_row(text):
    return max(map(len, text.splitlines()))


class Examples(FaceTest):
    @classmethod
    def setUpClass(cls):
        cls.results, cls.six_bars, cls.spherical, cls.spherical_functions = {}, {}, {}, {}
        for path in EXAMPLES:
            status, output, error = run("solve", path, "-o", "-")
            if (status, error) != (0, ""):
                raise AssertionError(f"{path.name}: exit status {status}: {error}")
            result = json.loads(output)
            kinds = {"four_bar": cls.results, "six_bar": cls.six_bars, "spherical_four_bar": cls.spherical}
            task = result["problem"]["task"]
            is_motion = "orientations" in task or task["mechanism"] != "spherical_four_bar"
            (kinds[task["mechanism"]] if is_motion else cls.spherical_functions)[path.stem] = result
        cls.all = cls.results | cls.six_bars | cls.spherical | cls.spherical_functions

    def for_each_linkage(self, check):
        """Calls check(requirements, poses, linkage as written, its FourBar)."""
        for name, result in self.results.items():
            for number, linkage in enumerate(result["linkages"], start=1):
                of_task = linkage.get("poses") or result["problem"]["task"]["poses"]  # where they are not the task's: its own
                poses = [Pose(pose) for pose in of_task]
                with self.subTest(example=name, linkage=number):
                    check(result["problem"]["requirements"], poses, linkage, FourBar(linkage))

    def test_patterns_and_kinds_are_those_told(self):
        self.assertEqual({name: result["pattern"] for name, result in self.all.items()}, PATTERNS)
        kinds = {name: result["problem"]["task"]["kind"] for name, result in self.results.items()}
        self.assertEqual({name for name, kind in kinds.items() if kind == "function"}, set(WANTED))

    def test_each_tells_its_story_first(self):
        for path in ALL:
            with self.subTest(path.name):
                text = path.read_text(encoding="utf-8")
                story = re.match(r"(?://[^\n]*\n)+", text)
                self.assertIsNotNone(story)
                self.assertIn(story[0].count("\n"), range(3, 8))
                self.assertLessEqual(longest_row(text), 120)
                problem = load(path)
                self.assertTrue(problem["title"])
                self.assertEqual("length_unit" in problem, problem["task"]["mechanism"] != "spherical_four_bar")

    def test_each_is_solved(self):
        for name, result in self.all.items():
            with self.subTest(name):
                self.assertEqual(result["status"], "solved")
                told = {warning["code"] for warning in result["warnings"]}
                self.assertLessEqual(told, TOLD_OF_NEAR if name in NEAR else set())
                positions = 5 if name in NEAR else result["pattern"].count("P")
                is_given_whole = name in ("bin_lid", "bracket_hatch", "rail_tailgate")
                self.assertGreaterEqual(len(result["linkages"]), 1 if positions == 5 or is_given_whole else 2)
                if name == "loader_bucket":
                    continue  # a search: there is no map
                self.assertGreater(result["region"]["meeting_requirements"], 0)
                self.assertGreaterEqual(result["region"]["counts"]["defect_free"], result["region"]["meeting_requirements"])

    def test_linkages_are_verified_and_exact(self):
        def check(_wanted, _poses, linkage, _bars):
            self.assertIs(linkage["verified_by_driving"], True)
            self.assertLess(linkage["residual"], 1e-9)
            self.assertFalse(any(linkage["defects"].values()))

        self.for_each_linkage(check)

    def test_side_links_keep_their_lengths(self):
        def check(_wanted, poses, _linkage, bars):
            for center, circle, length in ((bars.input_center, bars.input_circle, bars.input),
                                           (bars.output_center, bars.output_circle, bars.output)):
                for pose in poses:
                    self.assertLess(abs(abs(pose.carries(circle, poses[0]) - center) / length - 1), 1e-9)

        self.for_each_linkage(check)

    def test_lengths_are_those_of_the_pivots(self):
        def check(_wanted, _poses, linkage, bars):
            for name, length in bars.lengths().items():
                self.assertAlmostEqual(linkage["lengths"][name] / length, 1, delta=1e-12)
            self.assertAlmostEqual(linkage["link_ratio"], max(bars.lengths().values()) / min(bars.lengths().values()), places=9)

        self.for_each_linkage(check)

    def test_requirements_are_met(self):
        def check(wanted, _poses, linkage, bars):
            lengths = bars.lengths().values()
            self.assertLessEqual(max(lengths) / min(lengths), wanted["max_link_ratio"] * (1 + 1e-9))
            self.assertLessEqual(max(lengths), wanted["max_length"] * (1 + 1e-9))
            self.assertGreaterEqual(linkage["min_transmission_angle_deg"], wanted["min_transmission_angle_deg"])
            for box, pivots in (("ground_pivots_within", (bars.input_center, bars.output_center)),
                                ("moving_pivots_within", (bars.input_circle, bars.output_circle))):
                for pivot in pivots if wanted[box] else ():
                    for axis, value in (("x", pivot.real), ("y", pivot.imag)):
                        low, high = wanted[box][axis]
                        self.assertEqual(bisect.bisect((low - 1e-9 * (high - low), high + 1e-9 * (high - low)), value), 1)

        self.for_each_linkage(check)

    def test_driving_gives_the_poses_and_the_transmission_angle(self):
        def check(_wanted, poses, linkage, bars):
            senses = {"ccw": (1,), "cw": (-1,), "either": (1, -1)}[linkage["drive"]]
            drives = [drive(bars, poses, sense) for sense in senses]
            self.assertNotIn(None, drives)
            size = max(bars.lengths().values())
            self.assertLess(max(miss for _, miss in drives), 1e-8 * size)
            if linkage["driver_sweep_deg"] != 360:  # otherwise it is that of the whole turn
                self.assertAlmostEqual(max(least for least, _ in drives), linkage["min_transmission_angle_deg"], delta=0.01)

        self.for_each_linkage(check)

    def test_driving_leaves_a_pose_in_its_direction(self):
        seen = set()

        def check(_wanted, poses, linkage, bars):
            for pose, turned in zip(poses, input_turns(bars, poses, {"ccw": 1, "cw": -1}[linkage["drive"]])):
                if not pose.direction:
                    continue
                seen.add((pose.direction["x"], pose.direction["y"]))  # of a path each linkage turns its coupler otherwise
                step = {"ccw": 1e-4, "cw": -1e-4}[linkage["drive"]]
                joint = pose.carries(bars.output_circle, poses[0])
                ahead, back = (bars.driven_to(turned + way, joint) for way in (step, -step))
                turn = (ahead[1] - ahead[0]) / (back[1] - back[0])
                origin_back = back[0] + (back[1] - back[0]) / (bars.output_circle - bars.input_circle) * (
                    poses[0].origin - bars.input_circle)
                origin_ahead = ahead[0] + turn * (origin_back - back[0])
                moved, turned_by = origin_ahead - origin_back, cmath.phase(turn)
                wanted = complex(pose.direction["x"], pose.direction["y"])
                self.assertAlmostEqual(abs(cmath.phase(moved / wanted)), 0, delta=1e-5)
                self.assertAlmostEqual(turned_by / abs(moved), pose.direction["theta"] / abs(wanted), delta=1e-6)

        self.for_each_linkage(check)
        self.assertEqual(len(seen), 4)
        self.assertIn((18, -2), seen)  # the take-up lever

    def test_the_drawer_comes_straight_out(self):
        """Halving the way out divides what is left of the deviation by 8: direction and curvature are those told."""
        result = self.results["corner_drawer"]
        poses = [Pose(pose) for pose in result["problem"]["task"]["poses"]]
        for number, linkage in enumerate(result["linkages"], start=1):
            bars, sense = FourBar(linkage), {"ccw": 1, "cw": -1}[linkage["drive"]]

            def off(turned):
                moved, joint = bars.driven_to(sense * turned, bars.output_circle)
                turn = (joint - moved) / (bars.output_circle - bars.input_circle)
                front = moved + turn * (poses[0].origin - bars.input_circle)
                return abs(complex(front.imag, 400 * (cmath.phase(turn) - 1e-5 * front.real**2)))

            with self.subTest(linkage=number):
                self.assertAlmostEqual(off(0.01) / off(0.005), 8, delta=0.5)
                self.assertLess(off(0.1), 1)

    def test_the_arms_of_the_footrest_stand_at_the_angle_given(self):
        for linkage in self.results["footrest"]["linkages"]:
            bars = FourBar(linkage)
            between = (bars.output_circle - bars.output_center) / (bars.input_circle - bars.input_center)
            self.assertAlmostEqual(math.degrees(cmath.phase(between)), 60, places=9)

    def test_the_hatch_lifts_its_seal_all_round(self):
        for linkage in self.results["airtight_hatch"]["linkages"]:
            bars = FourBar(linkage)
            for arm in (bars.input_circle - bars.input_center, bars.output_circle - bars.output_center):
                self.assertLess(abs(arm.imag), 1e-9 * abs(arm))

    def test_the_latch_uses_the_arms_in_stock(self):
        for linkage in self.results["latch"]["linkages"]:
            self.assertAlmostEqual(linkage["lengths"]["input"], 18, places=9)
            self.assertAlmostEqual(linkage["lengths"]["output"], 24, places=9)

    def test_given_pivots_are_kept(self):
        [lid] = self.results["bin_lid"]["linkages"]
        for side, at in (("input", (20, 40)), ("output", (-20, -60))):
            self.assertEqual(tuple(round(value, 9) for value in lid[side]["circle_point"]), at)
        [hatch] = self.results["bracket_hatch"]["linkages"]
        for side, at in (("input", (120, 340)), ("output", (200, 340))):
            self.assertEqual(tuple(round(value, 9) for value in hatch[side]["center_point"]), at)
        for gate in self.results["rail_tailgate"]["linkages"]:
            for side in ("input", "output"):
                self.assertAlmostEqual(gate[side]["center_point"][1], 340, places=9)

    def test_generators_generate_their_function(self):
        """Driven again over both dials: nothing is wrong at the precision points, and what is told in between."""
        for name, function in WANTED.items():
            for number, linkage in enumerate(self.results[name]["linkages"], start=1):
                with self.subTest(example=name, linkage=number):
                    written = self.results[name]["problem"]["task"]["function"]
                    at_points, between = errors(FourBar(linkage), function, written, linkage.get("free_value", 1))
                    self.assertLess(at_points, 1e-9)
                    self.assertAlmostEqual(between / linkage["max_structural_error_deg"], 1, delta=0.01)

    def test_the_body_touches_nothing_on_its_way(self):
        for name, surroundings in SURROUNDINGS.items():
            poses = [Pose(pose) for pose in self.results[name]["problem"]["task"]["poses"]]
            for number, linkage in enumerate(self.results[name]["linkages"], start=1):
                bars = FourBar(linkage)
                last = input_turns(bars, poses, {"ccw": 1, "cw": -1}[linkage["drive"]])[-1]
                joint, deepest = bars.output_circle, -math.inf
                for step in range(101):
                    moved, joint = bars.driven_to(last * step / 100, joint)
                    deepest = max(deepest, surroundings.deepest(bars, moved, joint))
                with self.subTest(example=name, linkage=number):
                    self.assertLessEqual(deepest, 1e-9)

    def test_six_bars_keep_their_added_links_and_are_driven_through_the_poses(self):
        self.assertTrue(self.six_bars)
        for name, result in self.six_bars.items():
            poses = [Pose(pose) for pose in result["problem"]["task"]["poses"]]
            for number, linkage in enumerate(result["linkages"], start=1):
                bars, sense = SixBar(linkage), {"ccw": 1, "cw": -1}[linkage["drive"]]
                stops = [bars.at(pose, poses[0], elbow) for pose, elbow in zip(poses, bars.elbow)]
                turned, turns = 0.0, (complex(1), complex(1))
                with self.subTest(example=name, linkage=number):
                    self.assertIs(linkage["verified_by_driving"], True)
                    for angle, wanted in stops:
                        self.assertLess(max(map(abs, bars.stretch(angle, wanted))), 1e-9)
                        way = (angle - turned) % (sense * math.tau) if (angle, wanted) != stops[0] else 0.0
                        for step in range(100):
                            turns = bars.driven_to(turned + way * (step + 1) / 100, turns)
                        turned += way
                        self.assertLess(max(abs(a - b) for a, b in zip(turns, wanted)), 1e-6)
                    self.assertAlmostEqual(math.degrees(abs(turned)), linkage["driver_sweep_deg"], delta=1e-6)

    def test_six_bars_meet_the_requirements(self):
        for name, result in self.six_bars.items():
            wanted = result["problem"]["requirements"]
            for number, linkage in enumerate(result["linkages"], start=1):
                with self.subTest(example=name, linkage=number):
                    self.assertLessEqual(max(linkage["lengths"].values()), wanted["max_length"])
                    self.assertLessEqual(linkage["link_ratio"], wanted["max_link_ratio"])
                    self.assertGreaterEqual(linkage["min_transmission_angle_deg"], wanted["min_transmission_angle_deg"])
                    ground = [linkage["chain"]["a"], *(link["points"][0] for link in linkage["added"] if link["between"][0] == "0")]
                    for pivot in ground:
                        for value, axis in zip(pivot, "xy"):
                            low, high = wanted["ground_pivots_within"][axis]
                            self.assertTrue(low <= value <= high)

    def test_spherical_linkages_are_driven_through_the_orientations(self):
        """Driven again from their axes alone, by small steps of the input."""
        self.assertTrue(self.spherical)
        for name, result in self.spherical.items():
            wanted = result["problem"]["requirements"]
            turns = [quaternion_of(one) for one in result["problem"]["task"]["orientations"]]
            for number, linkage in enumerate(result["linkages"], start=1):
                bars, sense = SphericalFourBar(linkage), {"ccw": 1, "cw": -1}[linkage["drive"]]
                with self.subTest(example=name, linkage=number):
                    self.assertIs(linkage["verified_by_driving"], True)
                    stops = [bars.input_turn(turns[0], turn) * sense % math.tau for turn in turns[1:]]
                    self.assertEqual(stops, sorted(stops))
                    self.assertAlmostEqual(math.degrees(stops[-1]), linkage["driver_sweep_deg"], places=6)
                    joint, least = bars.output_moving, 90.0
                    for step in range(STEPS + 1):
                        turned = stops[-1] * step / STEPS
                        moved, joint = bars.driven_to(sense * turned, joint)
                        least = min(least, bars.transmission_angle(moved, joint))
                        if step == STEPS:
                            self.assertLess(math.dist(joint, bars.carried(turns[0], turns[-1])), 1e-9)
                    self.assertAlmostEqual(least, linkage["min_transmission_angle_deg"], delta=0.01)
                    self.assertGreaterEqual(least, wanted["min_transmission_angle_deg"] - 0.01)
                    for angle in linkage["angles_deg"].values():
                        self.assertGreaterEqual(min(angle, 180 - angle), wanted["min_link_angle_deg"])
                    cone = wanted["fixed_axes_within"] or {"axis": [0, 0, 1], "half_angle_deg": 90}
                    for axis in (bars.input_fixed, bars.output_fixed):
                        cosine = abs(dot3(axis, cone["axis"])) / math.hypot(*cone["axis"])
                        self.assertGreaterEqual(cosine, math.cos(math.radians(cone["half_angle_deg"])) - 1e-12)

    def test_the_list_of_examples_is_true(self):
        text = (ROOT / "examples/README.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| \[`(\w+)\.json`\]\(\1\.json\) \|(.+)\|$", text, re.MULTILINE)
        self.assertEqual({name for name, _ in rows}, set(self.all) | {path.stem for path in LINES})
        for name, row in rows:
            if name not in self.all:
                continue
            result = self.all[name]
            best = result["linkages"][0]
            gamma = f"{best['min_transmission_angle_deg']:.1f}°"
            if name in NEAR:
                error = (f"{best['near']['error']['rms']:.2g} mm" if "near" in best
                         else f"{100 * best['fit']['error']['rms_over_diagonal']:.2g} %")
                expected = [str(len(result["linkages"])), best["type"], error, gamma]
            elif name in self.six_bars:
                expected = [str(len(result["linkages"])), best["topology"], f"{best['driver_sweep_deg']:.1f}°", gamma]
            else:
                counts = (result["region"]["counts"]["defect_free"], result["region"]["meeting_requirements"])
                expected = [*(f"{count:,}".replace(",", " ") for count in counts), str(len(result["linkages"])), best["type"], gamma]
            with self.subTest(name):
                self.assertEqual([cell.strip().strip("`") for cell in row.split("|")][1:], expected)


def grouped(number):
    return f"{number:,}".replace(",", " ")


class StraightLines(FaceTest):
    """Examples of points that run straight."""

    def test_each_is_solved_as_the_list_says(self):
        rows = {match[1]: match[0] for match in
                re.finditer(r"^\| \[`(straight_\w+)\.json`\].*$", (ROOT / "examples/README.md").read_text(encoding="utf-8"), re.MULTILINE)}
        self.assertEqual(set(rows), {path.stem for path in LINES})
        for path in LINES:
            with self.subTest(path.name):
                status, output, error = run("solve", path, "-o", "-")
                self.assertEqual((status, error), (0, ""))
                result = json.loads(output)
                self.assertEqual((result["status"], result["warnings"]), ("solved", []))
                best = result["linkages"][0]
                for linkage in result["linkages"]:
                    self.assertIs(linkage["verified_by_driving"], True)
                    self.assertLess(linkage["residual"], 1e-9 * max(linkage["lengths"].values()))
                if path.stem == "straight_search":
                    continue
                counts = result["region"]["counts"]
                told = (grouped(counts["pairs"] - counts["degenerate"]), grouped(result["region"]["meeting_requirements"]),
                        f"`{best['type']}`", f"{best['min_transmission_angle_deg']:.1f}°")
                for number in told:
                    self.assertIn(f"| {number} |", rows[path.stem])


if __name__ == "__main__":
    unittest.main()
