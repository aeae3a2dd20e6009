"""Files for simulators, by those who read them: MuJoCo swings the linkage, libsdformat and check_urdf read it."""

import json
import math
import os
import re
import shutil
import subprocess
import unittest

from driven_linkages import FourBar, Pose, turned_by
from face_support import ROOT, TAILGATE, FaceTest, load, run

SIMULATORS = ROOT / "tests/simulators"
KEPT_NODE = ROOT / "build/node/bin"
SEARCHED = f"{KEPT_NODE}{os.pathsep}{os.environ['PATH']}"
ACCURACY = 1e-4  # of the longest link
DOUBLE_CRANK = {"mechanism": "four_bar", "input": {"center_point": [0, 0], "circle_point": [10, 70]},
                "output": {"center_point": [30, 0], "circle_point": [85, 60]}}
PARALLELOGRAM = {"mechanism": "four_bar", "input": {"center_point": [0, 0], "circle_point": [30, 60]},
                 "output": {"center_point": [100, 0], "circle_point": [130, 60]}}


def distance(a, b):
    return math.dist(a, b)


def product(p, q):
    (w, x, y, z), (a, b, c, d) = p, q
    return [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a]


def about(axis, angle):
    return [math.cos(angle / 2)] + [math.sin(angle / 2) * (axis == name) for name in "xyz"]


def quaternion_of(orientation):
    """Of angles about axes that the body carries along."""
    whole = [1, 0, 0, 0]
    for axis, angle in zip(orientation["sequence"], orientation["euler_deg"]):
        whole = product(whole, about(axis, math.radians(angle)))
    return whole


def heading(quaternion):
    return 2 * math.atan2(quaternion[3], quaternion[0])


class SimulatorTest(FaceTest):
    def result_of(self, example, *arguments):
        result = self.folder / f"{example.stem}.result.json"
        status, _, error = run("solve", example, "--samples", 64, "-o", result, *arguments)
        self.assertEqual((status, error), (0, ""))
        return result

    def result_with(self, linkage):
        return self.write("given.result.json", {"linkwright": 1, "problem": {"length_unit": "mm"}, "linkages": [linkage]})

    def export(self, result, kind, *arguments):
        path = self.folder / f"linkage.{kind}"
        status, output, error = run("export", result, "--format", kind, "-o", path, *arguments)
        self.assertEqual((status, output), (0, ""), error)
        return path

    def swing(self, result, sweep=0):
        """What MuJoCo says of the linkage: driven through its positions, then by `sweep` radians more."""
        node = shutil.which("node", path=SEARCHED)
        done = subprocess.run([node, SIMULATORS / "drive.mjs", self.export(result, "mjcf"), str(sweep)], capture_output=True,
                              text=True, check=False, timeout=1200)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        seen = json.loads(done.stdout)
        self.assertEqual(seen["complaints"], [])
        return seen

    def loaded_tailgate(self):
        """The tailgate on a crank, with all that a simulator knows of loads, and without friction."""
        problem = load(ROOT / "examples/tailgate_struts.json")
        loads = problem["loads"]
        loads["drive"] = "input"
        del loads["pins"]
        loads["links"]["coupler"] = {"mass": 0.7, "center": [60, -12], "inertia": 0.01}
        gas = loads["springs"][0]
        gas["F2"] = 430  # little compressed, so that the straight line that stands for the gas is near
        gas["F3"], gas["F4"] = gas["F1"], gas["F2"]
        loads["springs"] += [
            {"kind": "coil", "name": "helper", "from": {"on": "input", "at": [40, 15]}, "to": {"on": "ground", "at": [420, 150]},
             "rate": 1.5, "free_length": 90, "acts": "tension"},
            {"kind": "torsion", "name": "bar", "joint": "input_ground", "rate_per_deg": 0.2, "torque_at_position_1": -8}]
        loads["extra"] += [
            {"name": "wind", "on": "body", "at": [60, 150], "force": [25, -10], "frame": "fixed", "always": True},
            {"name": "cable", "on": "body", "at": [30, 60], "force": [-12, 30], "frame": "body", "always": True}]
        loads["cases"] = [{"name": "slope", "temperature_C": 5, "slope_deg": 7, "extra": ["snow"], "spring_percent": 94}]
        problem["requirements"] = {"min_transmission_angle_deg": 30, "max_length": 450}
        problem["options"] = {"objective": "size"}
        return self.write("loaded.json", problem)

    def assert_closed(self, looks, size):
        for look in looks:
            sites = look["sites"]
            for hinge in {name.split("_of_")[0] for name in sites if "_of_" in name}:
                one, other = (where for name, where in sites.items() if name.startswith(f"{hinge}_of_"))
                self.assertLess(distance(one, other), ACCURACY * size, hinge)

    def assert_meets_poses(self, seen, guided, poses, size):
        self.assertEqual(len(seen["driven"]), len(poses))
        poses = [Pose({**pose, "x": pose["x"] * self.metre, "y": pose["y"] * self.metre}) for pose in poses]
        begin = seen["keys"][0]["bodies"][guided]
        worst = 0
        for looks in (seen["keys"], seen["driven"]):
            for look, pose in zip(looks, poses):
                there = look["bodies"][guided]
                wanted = pose.carries(complex(*begin["at"][:2]), poses[0])
                turn = heading(there["quat"]) - heading(begin["quat"]) - (pose.angle - poses[0].angle)
                worst = max(worst, abs(complex(*there["at"][:2]) - wanted) / size, abs(math.remainder(turn, math.tau)))
        self.assertLess(worst, ACCURACY)

    def test_mujoco_holds_a_loaded_linkage_with_the_torque_that_is_told(self):
        problem = self.loaded_tailgate()
        result = self.result_of(problem)
        curves = self.folder / "curves.csv"
        status, _, error = run("loads", result, "--linkage", 1, "-o", curves)
        self.assertEqual((status, error), (0, ""))
        heads, *rows = [line.split(",") for line in curves.read_text(encoding="utf-8").splitlines()]
        turns, torques = ([float(row[heads.index(head)]) for row in rows] for head in ("driver_turn_deg", "torque_Nm"))
        looks = self.swing(result)["driven"]
        sense = math.copysign(1, looks[-1]["joints"][0])
        xml = (self.folder / "linkage.mjcf").read_text(encoding="utf-8")
        off = float(re.search(r"line stands for its force, ([0-9.]+) N off at most", xml)[1])
        self.assertEqual(len(looks), 4)
        largest = max(map(abs, torques))
        for look in looks:
            turn = sense * math.degrees(look["joints"][0])
            k = min(max(sum(at <= turn for at in turns), 1), len(turns) - 1)
            share = (turn - turns[k - 1]) / (turns[k] - turns[k - 1])
            told = torques[k - 1] + share * (torques[k] - torques[k - 1])
            # The straight line that stands for the gas is off by so much, at no arm longer than the links.
            self.assertAlmostEqual(look["motor"], told, delta=1e-3 * largest + off * 0.45, msg=f"at {turn} degrees")
        self.assertLess(off * 0.45, 6e-3 * largest)

    def test_mujoco_swings_a_tailgate_through_its_positions(self):
        self.metre = 0.001
        result = self.result_of(TAILGATE)
        size = self.metre * max(FourBar(load(result)["linkages"][0]).lengths().values())
        seen = self.swing(result, 0.3)
        self.assert_meets_poses(seen, "coupler", load(TAILGATE)["task"]["poses"], size)
        self.assert_closed(seen["keys"] + seen["driven"] + seen["swept"], size)

    def test_mujoco_swings_a_six_bar_through_its_positions(self):
        self.metre = 0.001
        example = ROOT / "examples/loader_bucket_chain.json"
        result = self.result_of(example)
        joints = load(result)["linkages"][0]["joints"]
        size = self.metre * min(distance(joints[p], joints[q]) for p, q in ("ab", "bd"))
        seen = self.swing(result)
        self.assertEqual(seen["joints"], 5)
        self.assert_meets_poses(seen, "body_3", load(example)["task"]["poses"], size)
        self.assert_closed(seen["keys"] + seen["driven"], size)

    def test_mujoco_swings_a_folding_wing_through_its_orientations(self):
        example = ROOT / "examples/folding_wing.json"
        seen = self.swing(self.result_of(example))
        orientations = [quaternion_of(orientation) for orientation in load(example)["task"]["orientations"]]
        self.assertEqual(len(seen["driven"]), len(orientations))
        back = [orientations[0][0]] + [-x for x in orientations[0][1:]]
        for looks in (seen["keys"], seen["driven"]):
            for look, orientation in zip(looks, orientations):
                for arm in ([1, 0, 0], [0, 1, 0]):
                    wanted = turned_by(product(orientation, back), arm)
                    self.assertLess(distance(turned_by(look["bodies"]["coupler"]["quat"], arm), wanted), ACCURACY)
        self.assert_closed(seen["keys"] + seen["driven"], 0.1)

    def test_mujoco_turns_a_double_crank_fully(self):
        bars = FourBar(DOUBLE_CRANK)
        size = 0.001 * max(bars.lengths().values())
        seen = self.swing(self.result_with(DOUBLE_CRANK), 2 * math.pi + 0.1)
        self.assertGreater(seen["swept"][-1]["turn"], 2 * math.pi)
        self.assert_closed(seen["swept"], size)
        near, last = bars.output_circle, 0
        for look in seen["swept"]:
            turned = look["joints"][0]
            self.assertLess(abs(turned - look["turn"]), 0.2)
            for part in range(1, 11):
                moved, near = bars.driven_to(last + (turned - last) * part / 10, near)
            last = turned
            there = look["sites"]["output_coupler_of_coupler"]
            self.assertLess(abs(complex(*there[:2]) - 0.001 * near), ACCURACY * size)

    def read_sdf(self):
        """A program that reads SDF; none where libsdformat is missing."""
        flags = subprocess.run(["pkg-config", "--cflags", "--libs", "sdformat12"], capture_output=True, text=True, check=False)
        if flags.returncode != 0:
            self.skipTest("libsdformat is not there: run script/bootstrap")
        program, source = ROOT / "build/simulators/read_sdf", SIMULATORS / "read_sdf.cpp"
        if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
            program.parent.mkdir(parents=True, exist_ok=True)
            subprocess.run(["g++", "-std=c++17", source, "-o", program, *flags.stdout.split()], check=True)
        return program

    def read_by_sdformat(self, path):
        done = subprocess.run([self.read_sdf(), path], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = [line.split() for line in done.stdout.splitlines()]
        for line in lines:
            self.assertEqual(line[2], "1", line)
        return ({line[1]: line for line in lines if line[0] == "link"}, {line[1]: line for line in lines if line[0] == "joint"})

    def assert_tree(self, links, found):
        """Gazebo refuses a link that is the child of two joints."""
        children = [joint[5] for joint in found.values()]
        self.assertEqual(sorted(children), sorted(links))

    def assert_loops_closed(self, path, found):
        """A pin that turns in one of the two links is welded to the other."""
        welds = re.findall(r"<plugin [^>]*DetachableJoint\">\s*<parent_link>(\w+)</parent_link>\s*"
                           r"<child_model>__model__</child_model>\s*<child_link>(\w+)_pin</child_link>", path.read_text())
        for link, hinge in welds:
            self.assertEqual(found[hinge][5], f"{hinge}_pin")
            self.assertNotIn(link, found[hinge][4:6])
        return len(welds)

    def test_sdformat_reads_all_hinges(self):
        chain = self.result_of(ROOT / "examples/loader_bucket_chain.json")
        joints = load(chain)["linkages"][0]["joints"]
        for kind, loops in (("sdf", 2), ("urdf", 0)):
            path = self.export(chain, kind)
            links, found = self.read_by_sdformat(path)
            self.assertEqual(len(links), 6 + loops)
            self.assert_tree(links, found)
            self.assertEqual(self.assert_loops_closed(path, found), loops)
            self.assertEqual(len(found), 6 + loops)
            self.assertLessEqual(set(found), {*joints, "ground_to_world"})
            for name in set(found) - {"ground_to_world"}:
                x, y = joints[name]
                self.assertLess(distance(map(float, found[name][6:9]), (x / 1000, y / 1000, 0)), 2e-5, name)
                self.assertEqual(found[name][9:12], ["0", "0", "1"])
            for link in links.values():
                self.assertEqual((link[3], link[5]), ("1", "0"))  # a mass matrix that can be, and nothing to collide with

    def test_axes_of_a_sphere_pass_through_its_centre(self):
        wing = self.result_of(ROOT / "examples/folding_wing.json")
        for kind, hinges in (("sdf", 4), ("urdf", 3)):
            links, found = self.read_by_sdformat(self.export(wing, kind))
            self.assert_tree(links, found)
            self.assertEqual(len(found), hinges + 1)
            for name in set(found) - {"ground_to_world"}:
                at, axis = [[float(x) for x in found[name][k:k + 3]] for k in (6, 9)]
                self.assertLess(distance(at, [0.1 * x for x in axis]), 1e-5, name)

    def test_check_urdf_finds_a_tree(self):
        check = shutil.which("check_urdf")
        if check is None:
            self.skipTest("check_urdf is not there: run script/bootstrap")
        for linkage, mimics in ((DOUBLE_CRANK, 0), (PARALLELOGRAM, 2)):
            path = self.export(self.result_with(linkage), "urdf")
            done = subprocess.run([check, path], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(re.findall(r"child\(\d+\): +(\w+)", done.stdout), ["ground", "input", "coupler", "output"])
            self.assertEqual(path.read_text().count("<mimic"), mimics)

    def test_masses_scale_with_the_density(self):
        masses = []
        for density in (7850, 2700):
            text = self.export(self.result_with(DOUBLE_CRANK), "sdf", "--density", density).read_text()
            masses.append([float(mass) / density for mass in re.findall("<mass>(.*)</mass>", text)])
        self.assertEqual(len(masses[0]), 5)  # with the pin of the loop
        for one, other in zip(*masses):
            self.assertAlmostEqual(one, other, delta=1e-8 * one)

    def test_mistakes(self):
        result = self.result_with(DOUBLE_CRANK)
        for density, piece in (("0", "--density"), ("1e9", "between 0.001 and 1000000"), ("steel", "--density")):
            self.assert_mistake(run("export", result, "--format", "mjcf", "--density", density), piece)


if __name__ == "__main__":
    unittest.main()
