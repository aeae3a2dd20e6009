"""The commands of `attitude`: against the worked rotations, from files and from flags, and what they refuse."""

import copy
import json
import math
import re
import unittest
import xml.etree.ElementTree

from face_support import ROOT, FaceTest, load, run
from readme_test import commands, mismatch
from schema_test import apply, paths

try:
    import jsonschema
except ImportError:
    jsonschema = None

EXAMPLES = {"antenna": "convert", "gimbal_lock": "convert", "part_transfer": "screw", "spinning_top": "rates", "robot_arm": "dh"}
PICTURES = ROOT / "docs/theory"


def product(a, b):
    return [[sum(row[k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))] for row in a]


def transposed(a):
    return [list(row) for row in zip(*a)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def about(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis]


def matrix_of(sequence, angles):
    matrix = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for axis, angle in zip(sequence, angles):
        matrix = product(matrix, about(axis, angle))
    return matrix


NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


def alike(drawn, fresh):
    """The same picture, but for coordinates that rounding moved by a hundredth of a px."""
    pairs = zip(NUMBER.findall(drawn), NUMBER.findall(fresh))
    return NUMBER.sub("#", drawn) == NUMBER.sub("#", fresh) and all(abs(float(a) - float(b)) < 0.025 for a, b in pairs)


class AttitudeTest(FaceTest):
    def report(self, command, content):
        """What the program writes for a file."""
        status, output, error = run("attitude", command, self.write("in.json", {"linkwright": 1} | content), "-o", "-")
        self.assertEqual((status, error), (0, ""))
        return json.loads(output)

    def convert(self, orientation, **more):
        return self.report("convert", {"orientation": orientation} | more)

    def flags(self, command, *arguments):
        status, output, error = run("attitude", command, *arguments, "-o", "-")
        self.assertEqual((status, error), (0, ""))
        return json.loads(output)

    def assert_close(self, a, b, delta=1e-14):
        if isinstance(a, list):
            self.assertEqual(len(a), len(b))
            for x, y in zip(a, b):
                self.assert_close(x, y, delta)
        else:
            self.assertAlmostEqual(a, b, delta=delta)


class Convert(AttitudeTest):
    def test_agrees_with_the_worked_rotations(self):
        rows = load(ROOT / "data/attitude/table.json")["rows"]
        self.assertGreater(len(rows), 100)
        for row in rows:
            with self.subTest(row["name"]):
                found = self.convert({"quaternion": row["q_in"]})
                self.assert_close(found["matrix"], row["R"], 1e-15)
                self.assert_close(found["quaternion"], row["q"], 1e-15)
                self.assert_close(found["mrp"], row["mrp"], 1e-15)
                self.assertAlmostEqual(math.radians(found["angle_deg"]), row["angle"], delta=2e-15)
                if row["rodrigues"]:
                    self.assert_close(found["rodrigues"], row["rodrigues"], 1e-14 * (1 + max(map(abs, row["rodrigues"]))) ** 2)
                for sequence, angles in found["euler_deg"].items():
                    self.assert_close(matrix_of(sequence, angles), row["R"], 2e-15)
                    if row["euler_intrinsic"][sequence]["locked"]:
                        self.assertTrue(found["locked"][sequence], sequence)
                    elif found["locked"][sequence]:  # of turns by 1e-20 the table knows more than doubles can
                        self.assertLess(found["lock_distance"][sequence], 1e-15)
                    middle = row["euler_intrinsic"][sequence]["angles"][1]
                    self.assertAlmostEqual(math.radians(angles[1]), middle, delta=2e-15 / max(found["lock_distance"][sequence], 1e-8))

    def test_every_form_says_the_same(self):
        found = self.convert({"axis": [1, 2, 2], "angle_deg": 75})
        sequence = "yxz"
        forms = [{"matrix": found["matrix"]}, {"quaternion": [3 * x for x in found["quaternion"]]},
                 {"rotation_vector": found["rotation_vector"]}, {"rodrigues": found["rodrigues"]}, {"mrp": found["mrp"]},
                 {"euler_deg": found["euler_deg"][sequence], "sequence": sequence},
                 {"euler_deg": found["euler_deg"][sequence], "sequence": "2-1-3"},
                 {"euler_deg": found["euler_deg"][sequence][::-1], "sequence": sequence[::-1], "turning": "extrinsic"},
                 {"turns": [{"axis": [1, 2, 2], "angle_deg": 25}, {"axis": [1, 2, 2], "angle_deg": 50}]},
                 {"triads": {"fixed": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "moving": transposed(found["matrix"])}}]
        for form in forms:
            with self.subTest(form):
                self.assert_close(self.convert(form)["quaternion"], found["quaternion"], 1e-15)

    def test_flags_say_what_files_say(self):
        def text(values):
            return ",".join(map(str, values))

        for flags, orientation in (
            (("--axis", "0,0,1", "--angle", "30"), {"axis": [0, 0, 1], "angle_deg": 30}),
            (("--axis", "-1,.5,-2e-1", "--angle", "-30"), {"axis": [-1, 0.5, -0.2], "angle_deg": -30}),
            (("--euler", "zxz", "30,40,50"), {"euler_deg": [30, 40, 50], "sequence": "zxz"}),
            (("--euler", "xyz", "-30,-40,50", "--extrinsic"), {"euler_deg": [-30, -40, 50], "sequence": "xyz", "turning": "extrinsic"}),
            (("--quaternion", "-1 2 3 4"), {"quaternion": [-1, 2, 3, 4]}),
            (("--matrix", "0,-1,0; 1,0,0; 0,0,1"), {"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}),
            (("--matrix", text([2, 0, 0, 0, 1, 0, 0, 0, 1]), "--nearest"), {"matrix": [[2, 0, 0], [0, 1, 0], [0, 0, 1]], "nearest": True}),
            (("--rotation-vector", "0.1,0.2,0.3"), {"rotation_vector": [0.1, 0.2, 0.3]}),
            (("--rodrigues", "0.1,0.2,0.3"), {"rodrigues": [0.1, 0.2, 0.3]}),
            (("--mrp", "0.1,0.2,0.3"), {"mrp": [0.1, 0.2, 0.3]}),
        ):
            with self.subTest(flags):
                self.assertEqual(self.flags("convert", *flags), self.convert(orientation))
        self.assertEqual(self.flags("convert", "--mrp", "0,0,0.1", "--vector", "1,0,0", "--vector", "0,-1,0"),
                         self.convert({"mrp": [0, 0, 0.1]}, vectors=[[1, 0, 0], [0, -1, 0]]))

    def test_the_axis_of_no_turn_is_undefined(self):
        found = self.convert({"rotation_vector": [0, 0, 0]})
        self.assertEqual((found["axis_defined"], found["angle_deg"], found["rodrigues"]), (False, 0, [0, 0, 0]))
        self.assertIn("No turn", run("attitude", "convert", "--rotation-vector", "0,0,0")[1])

    def test_a_half_turn_has_no_rodrigues_vector(self):
        found = self.convert({"quaternion": [0, -1, 0, 0]})
        self.assertIsNone(found["rodrigues"])
        self.assertEqual((found["axis"], found["angle_deg"]), ([1, 0, 0], 180))
        self.assertIn("half-turn", run("attitude", "convert", "--quaternion", "0,1,0,0")[1])

    def test_a_locked_sequence_says_so(self):
        output = run("attitude", "convert", "--euler", "xyz", "30,90,40")[1].replace("\n", " ")
        self.assertIn("Gimbal lock of xyz: the first axis and the third lie in one line, so that only first + third = 70.0000°", output)
        found = self.convert({"euler_deg": [30, -90, 40], "sequence": "xyz"})
        self.assertTrue(found["locked"]["xyz"])
        self.assertEqual(found["determined"]["xyz"]["combination"], "first - third")
        self.assertAlmostEqual(found["determined"]["xyz"]["angle_deg"], -10, delta=1e-12)
        near = run("attitude", "convert", "--euler", "zxz", "30,0.000001,40")[1].replace("\n", " ")
        self.assertIn("Near gimbal lock of zxz", near)
        self.assertIn("first + third = 70.0000° is not", near)

    def test_tensor_properties_images_and_resals_frame(self):
        found = self.convert({"euler_deg": [20, 50, 70], "sequence": "zxz"}, vectors=[[1, 2, 3], [0, 0, 0]])
        matrix = found["matrix"]
        tensor = [[sum(a[i] * b[j] for a, b in found["dyads"]) for j in range(3)] for i in range(3)]
        self.assert_close(tensor, matrix)
        self.assert_close([[found["matrix_minus_identity"][i][j] + (i == j) for j in range(3)] for i in range(3)], matrix)
        self.assert_close(found["images"], [[row[0] for row in product(matrix, [[1], [2], [3]])], [0, 0, 0]])
        self.assert_close(found["resal"]["matrix"], matrix_of("zx", [20, 50]))
        self.assertAlmostEqual(found["resal"]["spin_deg"], 70, delta=1e-12)
        properties = found["properties"]
        self.assertLess(properties["orthogonality_error"] + properties["cofactor_error"] + abs(properties["determinant"] - 1), 4e-15)
        self.assert_close(properties["eigenvalue_one"]["axis"], found["axis"])

    def test_the_nearest_rotation_on_request(self):
        noisy = [[1.1, 0, 0], [0, 1, 0.2], [0, 0, 1]]
        found = self.convert({"matrix": noisy, "nearest": True})
        self.assertGreater(found["nearest_distance"], 0.1)
        self.assertLess(found["properties"]["orthogonality_error"], 4e-15)
        self.assertIn("nearest rotation", run("attitude", "convert", "--nearest", "--matrix", "1.1,0,0,0,1,0.2,0,0,1")[1])


class Screw(AttitudeTest):
    def test_there_and_back(self):
        given = {"axis": [1, 2, 6], "point": [60, -20, 0], "angle_deg": 120, "slide": 50}
        found = self.report("screw", {"length_unit": "mm", "displacement": {"screw": given}, "points": [[60, -20, 0]], "directions": [[1, 2, 6]]})
        self.assertEqual(found["screw"]["kind"], "general")
        self.assertAlmostEqual(found["screw"]["angle_deg"], 120, delta=1e-12)
        self.assertAlmostEqual(found["screw"]["slide"], 50, delta=1e-12)
        self.assertAlmostEqual(found["screw"]["pitch"], 50 / math.radians(120), delta=1e-12)
        self.assert_close(cross([a - b for a, b in zip(found["screw"]["point"], given["point"])], given["axis"]), [0, 0, 0], 1e-12)
        unit = [x / math.sqrt(41) for x in given["axis"]]
        self.assert_close(found["displaced_points"][0], [p + 50 * u for p, u in zip(given["point"], unit)], 1e-12)
        self.assert_close(found["displaced_directions"][0], given["axis"], 1e-13)
        self.assert_close(product(found["matrix"], found["inverse"]), [[float(i == j) for j in range(4)] for i in range(4)], 1e-13)
        for displacement in ({"matrix": found["matrix"]}, {"orientation": {"quaternion": found["quaternion"]}, "translation": found["translation"]},
                             {"from": {"translation": [0, 0, 0]}, "to": {"matrix": found["matrix"]}}):
            again = self.report("screw", {"displacement": displacement})
            self.assert_close(again["matrix"], found["matrix"], 1e-13)
            self.assert_close(again["screw"]["point"], found["screw"]["point"], 1e-12)

    def test_kinds(self):
        for displacement, kind in (({"translation": [0, 0, 0]}, "identity"), ({"translation": [0, -2, 0]}, "pure_translation"),
                                   ({"screw": {"axis": [0, 1, 0], "angle_deg": 180}}, "half_turn"),
                                   ({"screw": {"axis": [0, 1, 0], "slide": 3}}, "pure_translation"),
                                   ({"screw": {"axis": [0, 1, 0], "angle_deg": 360, "slide": 3, "point": [1, 0, 0]}}, "pure_translation"),
                                   ({"screw": {"axis": [0, 1, 0], "angle_deg": 1e-9}}, "general")):
            with self.subTest(displacement):
                found = self.report("screw", {"displacement": displacement})["screw"]
                self.assertEqual(found["kind"], kind)
                self.assertEqual(found["point"] is None, kind in ("identity", "pure_translation"))
                self.assertEqual(found["axis_defined"], kind != "identity")

    def test_flags(self):
        given = self.report("screw", {"length_unit": "mm", "displacement": {"screw": {"axis": [0, 0, 2], "point": [1, 0, 0], "angle_deg": 90, "slide": 5}},
                                      "points": [[1, 1, 1]]})
        found = self.flags("screw", "--axis", "0,0,2", "--point", "1,0,0", "--angle", 90, "--slide", 5, "--move", "1,1,1", "--unit", "mm")
        self.assertEqual(found, given)
        matrix = ",".join(str(x) for row in found["matrix"] for x in row)
        self.assert_close(self.flags("screw", "--matrix", matrix)["screw"]["point"], [1, 0, 0])
        self.assertEqual(self.flags("screw", "--axis", "0,0,1", "--angle", 90, "--translation", "1,2,3")["translation"], [1, 2, 3])
        self.assertEqual(self.flags("screw", "--translation", "1,2,2")["screw"]["kind"], "pure_translation")
        self.assertIn("A turn by 90.0000°", run("attitude", "screw", "--matrix", matrix)[1])


class Rates(AttitudeTest):
    EULER = {"euler_deg": [20, 25, 60], "sequence": "zxz"}

    def angles_at(self, time):
        return [20 + 30 * time + 2 * time**2, 25 + 10 * time, 60 - 50 * time + 5 * time**2]

    def test_rates_of_angles_are_derivatives(self):
        step = 1e-4
        first, second = [30, 10, -50], [4, 0, 10]
        found = self.report("rates", {"orientation": self.EULER, "motion": {"euler_rates_deg": first, "euler_accelerations_deg": second}})
        before, now, after = (matrix_of("zxz", self.angles_at(time)) for time in (-step, 0, step))
        for i in range(3):
            for j in range(3):
                self.assertAlmostEqual(found["matrix_first"][i][j], (after[i][j] - before[i][j]) / (2 * step), delta=1e-7)
                self.assertAlmostEqual(found["matrix_second"][i][j], (after[i][j] - 2 * now[i][j] + before[i][j]) / step**2, delta=1e-6)
        self.assert_close(found["given_angles"]["rates_deg"], first, 1e-12)
        self.assert_close(found["given_angles"]["accelerations_deg"], second, 1e-11)
        self.assert_close(found["euler"]["zxz"]["rates_deg"], first, 1e-12)

    def test_every_form_says_the_same(self):
        found = self.report("rates", {"orientation": self.EULER, "motion": {"velocity": [1, 2, 3], "acceleration": [-1, 0.5, 2]}})
        attitude = {"quaternion": found["quaternion"]}
        sequences = found["euler"].items()
        for orientation, motion in (
            (attitude, {key: found["moving"][key] for key in ("velocity", "acceleration")} | {"frame": "moving"}),
            (attitude, {"matrix_first": found["matrix_first"], "matrix_second": found["matrix_second"]}),
            (attitude, {"quaternion_first": found["quaternion_first"], "quaternion_second": found["quaternion_second"]}),
            *(({"euler_deg": each["angles_deg"], "sequence": sequence},
               {"euler_rates_deg": each["rates_deg"], "euler_accelerations_deg": each["accelerations_deg"]}) for sequence, each in sequences),
        ):
            with self.subTest(motion):
                again = self.report("rates", {"orientation": orientation, "motion": motion})
                self.assert_close(again["fixed"]["velocity"], [1, 2, 3], 1e-12)
                self.assert_close(again["fixed"]["acceleration"], [-1, 0.5, 2], 1e-11)

    def test_points(self):
        omega, epsilon, r = [0, 0, 2], [0, 0, 3], [1, 0, 0]
        found = self.report("rates", {"orientation": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}, "motion": {"velocity": omega, "acceleration": epsilon},
                                      "origin": {"position": [5, 5, 5], "velocity": [1, 0, 0]}, "points": [{"position": r, "velocity": [0.5, 0, 0]}]})["points"][0]
        self.assertEqual(found["position"], [6, 5, 5])
        self.assertEqual(found["velocity"], [1.5, 2, 0])
        self.assertEqual(found["acceleration"], [-4, 3 + 2, 0])
        self.assertEqual(found["acceleration_parts"]["coriolis"], [0, 2, 0])

    def test_flags_and_step(self):
        found = self.flags("rates", "--axis", "0,0,1", "--angle", 30, "--velocity", "0,0,1", "--in", "moving", "--step", math.pi / 3, "--point", "1,0,0")
        self.assert_close(found["after_step"]["matrix"], about("z", 90), 1e-15)
        self.assertEqual(len(found["points"]), 1)
        flags = ("--euler", "zxz", "20,25,60", "--euler-rates", "30,10,-50")
        self.assertEqual(self.flags("rates", *flags), self.report("rates", {"orientation": self.EULER, "motion": {"euler_rates_deg": [30, 10, -50]}}))
        output = run("attitude", "rates", *flags)[1]
        self.assertIn("zxz, given", output)
        self.assertIn("angular velocity", output)

    def test_the_lock(self):
        found = self.report("rates", {"orientation": {"euler_deg": [0, 0, 0], "sequence": "zxz"}, "motion": {"velocity": [0, 1, 2]}})
        self.assertTrue(found["euler"]["zxz"]["locked"])
        self.assertAlmostEqual(found["euler"]["zxz"]["velocity_residual"], 1, delta=1e-15)
        self.assertIn("Gimbal lock", run("attitude", "rates", "--euler", "zxz", "0,0,0", "--velocity", "0,1,2")[1])


class HartenbergDenavit(AttitudeTest):
    def transform(self, theta, d, a, alpha, modified):
        def move(x, z):
            return [[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, z], [0, 0, 0, 1]]

        def turn(axis, angle):
            return [row + [0] for row in about(axis, angle)] + [[0, 0, 0, 1]]

        parts = [turn("z", theta), move(0, d), move(a, 0), turn("x", alpha)]
        parts = [*reversed(parts[2:]), *parts[:2]] if modified else parts
        result = parts[0]
        for part in parts[1:]:
            result = product(result, part)
        return result

    def test_chains(self):
        links = [(30, 400, 25, 90), (45, 0, 455, 0), (-60, 10, 0, -90)]
        keys = ("theta_deg", "d", "a", "alpha_deg")
        for form in ("classic", "modified"):
            found = self.report("dh", {"form": form, "links": [dict(zip(keys, link)) for link in links], "points": [[1, 2, 3]]})
            tip = [[float(i == j) for j in range(4)] for i in range(4)]
            for link, shown in zip(links, found["links"]):
                joint = self.transform(*link, form == "modified")
                tip = product(tip, joint)
                self.assert_close(shown["matrix"], joint, 1e-12)
                self.assert_close(shown["frame"], tip, 1e-12)
            self.assert_close(found["tip"]["matrix"], tip, 1e-12)
            self.assert_close(found["points"][0], [row[0] for row in product(tip, [[1], [2], [3], [1]])][:3], 1e-12)
            flags = [word for link in links for word in ("--link", ",".join(map(str, link)))]
            self.assertEqual(self.flags("dh", *flags, "--form", form, "--point", "1,2,3"), found)
            joint = found["links"][0]["matrix"]
            fit = self.report("dh", {"form": form, "displacement": {"matrix": joint}})
            self.assert_close([fit["link"][key] for key in keys], list(links[0]), 1e-12)

    def test_words(self):
        output = run("attitude", "dh", "--link", "30,400,25,90", "--unit", "mm")[1]
        for piece in ("Chain of 1 link", "lengths in mm", "30.0000°", "screw axis"):
            self.assertIn(piece, output)
        missed = run("attitude", "dh", "--matrix", "1,0,0,0, 0,0,-1,5, 0,1,0,6, 0,0,0,1")[1].replace("\n", " ")
        self.assertIn("Four parameters cannot say all of it", missed)


class Files(AttitudeTest):
    def test_examples_print_and_write(self):
        self.assertEqual({path.stem for path in (ROOT / "examples/attitude").glob("*.json")}, set(EXAMPLES))
        for name, command in EXAMPLES.items():
            with self.subTest(name):
                status, output, error = run("attitude", command, ROOT / f"examples/attitude/{name}.json")
                self.assertEqual((status, error), (0, ""))
                self.assertLessEqual(max(map(len, output.splitlines())), 100)
                self.assertNotRegex(output, r"\bnan\b|\binf\b|-0\.0+\b(?!\d)")

    def test_numbers_read_back_bit_identical(self):
        found = self.convert({"axis": [1, 2, 3], "angle_deg": 10})
        self.assertEqual(self.convert({"quaternion": found["quaternion"]})["quaternion"], found["quaternion"])
        self.assertEqual(self.convert({"axis": found["axis"], "angle_deg": found["angle_deg"]})["angle_deg"], found["angle_deg"])

    def test_reads_standard_input_and_writes_both(self):
        status, output, error = run("attitude", "convert", "-", "-o", self.folder / "out.json", "--svg", self.folder / "out.svg",
                                    input='{"linkwright": 1, "orientation": {"mrp": [0, 0, 0.1]}} // a comment')
        self.assertEqual((status, error), (0, ""))
        self.assertIn("One turn by", output)
        self.assertEqual(load(self.folder / "out.json")["mrp"], [0, 0, 0.1])
        xml.etree.ElementTree.parse(self.folder / "out.svg")

    def test_unwritable_output(self):
        self.assert_failure(run("attitude", "convert", "--mrp", "0,0,0", "-o", self.folder), "regular file")

    @unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
    def test_examples_and_reports_keep_the_schema(self):
        schema = load(ROOT / "schema/attitude.schema.json")
        jsonschema.Draft202012Validator.check_schema(schema)
        for name, command in EXAMPLES.items():
            with self.subTest(name):
                example = load(ROOT / f"examples/attitude/{name}.json")
                report = json.loads(run("attitude", command, ROOT / f"examples/attitude/{name}.json", "-o", "-")[1])
                for definition, content in ((command, example), (f"{command}_report", report)):
                    jsonschema.Draft202012Validator(schema | {"anyOf": [{"$ref": f"#/$defs/{definition}"}]}).validate(content)


@unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
class Changes(AttitudeTest):
    """Every value of a file replaced by values of other types, every member dropped or renamed."""

    MORE = {
        "convert": ({"orientation": {"euler_deg": [1, 2, 3], "sequence": "yzx", "turning": "extrinsic"}},
                    {"orientation": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "nearest": False}},
                    {"orientation": {"turns": [{"axis": [0, 0, 1], "angle_deg": 3}]}, "vectors": [[1, 2, 3]]}),
        "screw": ({"displacement": {"screw": {"axis": [1, 0, 0], "point": [1, 2, 3], "angle_deg": 4, "slide": 5}}},
                  {"displacement": {"matrix": [[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]}, "directions": [[1, 0, 0]]}),
        "rates": ({"orientation": {"mrp": [0, 0, 0.1]}, "motion": {"velocity": [1, 2, 3], "acceleration": [4, 5, 6], "frame": "moving"},
                   "origin": {"position": [1, 2, 3], "velocity": [1, 2, 3], "acceleration": [1, 2, 3]}, "step": 2},
                  {"orientation": {"quaternion": [1, 0, 0, 0]}, "motion": {"quaternion_first": [0, 1, 0, 0], "quaternion_second": [-1, 0, 0, 0]}}),
        "dh": ({"displacement": {"translation": [1, 2, 3]}, "form": "modified"},),
    }
    BEYOND = ("rotation", "last row", "null vector", "all four components", "equally near", "skew", "symmetric part", "euler_deg")  # no matter of structure

    def test_what_the_schema_refuses_the_reader_refuses(self):
        schema = load(ROOT / "schema/attitude.schema.json")
        for command in ("convert", "screw", "rates", "dh"):
            validator = jsonschema.Draft202012Validator(schema | {"anyOf": [{"$ref": f"#/$defs/{command}"}]})
            files = [load(ROOT / f"examples/attitude/{name}.json") for name, its in EXAMPLES.items() if its == command]
            for content in [*files, *({"linkwright": 1} | more for more in self.MORE[command])]:
                validator.validate(content)
                self.check_changes(command, content, validator)

    def check_changes(self, command, content, validator):
        for path in paths(content):
            for change in (None, True, -1.5, "text", [], {}, [1, 2, 3], "dropped", "renamed"):
                changed = copy.deepcopy(content)
                apply(changed, path, change)
                status, _, error = run("attitude", command, self.write("changed.json", changed))
                with self.subTest(command, path=path, change=change):
                    self.assertIn(status, (0, 2), error)
                    if not validator.is_valid(changed):
                        self.assertEqual(status, 2)
                    elif status == 2:
                        self.assertTrue(any(word in error for word in self.BEYOND), error)


class Pictures(AttitudeTest):
    def test_those_of_the_theory_are_the_programs(self):
        page = (PICTURES / "attitude.md").read_text(encoding="utf-8")
        drawn = re.findall(r"^\$ linkwright (attitude .*--svg (docs/theory/\w+\.svg))", page, re.MULTILINE)
        self.assertEqual({name for _, name in drawn}, {f"docs/theory/{path.name}" for path in PICTURES.glob("*.svg")})
        for command, name in drawn:
            with self.subTest(name):
                self.assertIn(f"]({name.rpartition('/')[2]})", page)
                fresh = self.folder / "fresh.svg"
                self.assertEqual(run(*command.replace(name, str(fresh)).split())[0], 0)
                self.assertTrue(alike(*(path.read_text(encoding="utf-8") for path in (ROOT / name, fresh))), f"renew it: linkwright {command}")

    def test_commands_of_the_theory_print_what_is_shown(self):
        shown_commands = list(commands("docs/theory/attitude.md"))
        self.assertGreaterEqual(len(shown_commands), 6)
        (self.folder / "docs/theory").mkdir(parents=True)
        for command, shown in shown_commands:
            with self.subTest(command):
                status, output, error = run(*command.split()[1:], cwd=self.folder)
                self.assertEqual((status, error), (0, ""))
                self.assertIsNone(mismatch(shown, output.rstrip("\n").split("\n")), output)

    def boxes(self, picture):
        """(text, left, top, right, bottom) of each label with a halo: roughly."""
        for node in picture.iter("{http://www.w3.org/2000/svg}text"):
            if "stroke" in node.attrib:
                x, y, size = (float(node.attrib[key]) for key in ("x", "y", "font-size"))
                half = 0.3 * size * len(node.text)
                yield node.text, x - half, y - 0.8 * size, x + half, y + 0.1 * size

    def test_labels_keep_clear_of_each_other(self):
        for number, flags in enumerate((
            ("convert", "--axis", "1,2,3", "--angle", 75), ("convert", "--axis", "0,0,1", "--angle", 180), ("convert", "--axis", "1,1,0.6", "--angle", 20),
            ("convert", "--rotation-vector", "0,0,0"), ("convert", "--euler", "zxz", "40,50,35"), ("convert", "--euler", "xyz", "30,90,40"),
            ("convert", "--euler", "zyx", "0,0,0"), ("convert", "--euler", "xzx", "-170,300,1000"), ("screw", "--axis", "0,0,1", "--angle", 720, "--slide", 3),
            ("screw", "--translation", "1,2,3"), ("screw", "--translation", "0,0,0"), ("screw", "--axis", "1,1,0.6", "--angle", 1e-9, "--point", "1e6,0,0"),
            ("screw", "--axis", "1,1,0.6", "--angle", "1e11", "--point", "1e11,0,0", "--slide", "1e12"),
        )):
            with self.subTest(flags):
                path = self.folder / f"{number}.svg"
                self.assertEqual(run("attitude", *flags, "--svg", path)[::2], (0, ""))
                root = xml.etree.ElementTree.parse(path).getroot()
                self.assertEqual(float(root.attrib["width"]), 640)
                self.assertNotIn("nan", path.read_text(encoding="utf-8"))
                labels = list(self.boxes(root))
                for i, (text, left, top, right, bottom) in enumerate(labels):
                    self.assertTrue(-8 < left < right < 648, text)
                    for other, left2, top2, right2, bottom2 in labels[:i]:
                        apart = right <= left2 or right2 <= left or bottom <= top2 or bottom2 <= top
                        self.assertTrue(apart, f"{text} on {other}")

    def test_the_lock_names_the_axes(self):
        picture = self.folder / "lock.svg"
        run("attitude", "convert", "--euler", "xyz", "30,-90,40", "--svg", picture)
        text = "".join(xml.etree.ElementTree.parse(picture).getroot().itertext())
        self.assertIn("Gimbal lock: x₀ = −z₂", text)
        self.assertIn("axes 1 and 3", text)


class Refusals(AttitudeTest):
    def assert_refused(self, command, content, *pieces):
        self.assert_mistake(run("attitude", command, self.write("bad.json", content if isinstance(content, str) else {"linkwright": 1} | content)), *pieces)

    def test_orientations(self):
        eye = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        for orientation, place, piece in (
            ({"matrix": [[1, 0, 0], [0, 1, 0.1], [0, 0, 1]]}, "orientation.matrix", "nearest rotation"),
            ({"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}, "orientation.matrix", "determinant"),
            ({"matrix": [[0, 0, 0]] * 3, "nearest": True}, "orientation.matrix", "equally near"),
            ({"matrix": eye[:2]}, "orientation.matrix", "3 rows"), ({"matrix": [[1, 0, 0], [0, 1, 0], [0, 0]]}, "orientation.matrix[2]", "not 2"),
            ({"matrix": eye, "nearest": 1}, "orientation.matrix.nearest".replace("matrix.", ""), "true or false"),
            ({"axis": [0, 0, 0], "angle_deg": 1}, "orientation.axis", "null vector"), ({"axis": [0, 0, 1]}, "orientation.angle_deg", "missing"),
            ({"axis": [0, 0, 1, 0], "angle_deg": 1}, "orientation.axis", "3 numbers [x, y, z] belong here, not 4"),
            ({"axis": [0, 0, "1"], "angle_deg": 1}, "orientation.axis[2]", "a number"), ({"axis": [0, 0, 1], "angle_deg": 1e13}, "orientation.angle_deg", "too large"),
            ({"quaternion": [0, 0, 0, 0]}, "orientation.quaternion", "identity is 1, 0, 0, 0"), ({"quaternion": [1, 0, 0]}, "orientation.quaternion", "4 numbers"),
            ({"euler_deg": [1, 2, 3], "sequence": "xxz"}, "orientation.sequence", "take xyz"),
            ({"euler_deg": [1, 2, 3], "sequence": "x" * 10000}, "orientation.sequence", "xxxxx…"),
            ({"euler_deg": [1, 2, 3]}, "orientation.sequence", "missing"), ({"euler_deg": [1, 2, 3], "sequence": "xyz", "turning": "extrinsik"}, "orientation.turning", "extrinsic"),
            ({"quaternoin": [1, 0, 0, 0]}, "orientation.quaternoin", '"quaternion"'), ({}, "orientation", "no orientation"), ([], "orientation", "an object"),
            ({"mrp": [0, 0, 0], "rodrigues": [0, 0, 0]}, "orientation.mrp", "keep one"), ({"mrp": [0, 0, 0], "sequence": "xyz"}, "orientation.sequence", "belongs to"),
            ({"turns": [{"axis": [0, 0, 1]}]}, "orientation.turns[0].angle_deg", "missing"), ({"turns": {}}, "orientation.turns", "a list"),
            ({"turns": [{"axis": [0, 0, 1], "angle_deg": 1}] * 101}, "orientation.turns", "at most 100"),
            ({"triads": {"fixed": eye, "moving": [[1, 0, 0], [1, 0, 0], [0, 0, 1]]}}, "orientation.triads", "nearest rotation"),
            ({"triads": {"fixed": eye}}, "orientation.triads.moving", "missing"),
        ):
            with self.subTest(orientation):
                self.assert_refused("convert", {"orientation": orientation}, f"bad.json: {place}: ", piece)

    def test_files(self):
        for command, content, *pieces in (
            ("convert", "", "empty"), ("convert", "[]", "an object"), ("convert", '{"linkwright": 2}', "newer"), ("convert", '{"linkwright": 0, "orientation": {"mrp": [0, 0, 0]}}', "linkwright", "no version 0"),
            ("convert", '{"linkwright": 1, "orientation": {"mrp": [NaN, 0, 0]}}', "line 1"), ("convert", "[" * 100000, "nested deeper"),
            ("convert", '{"linkwright": 1, "orientation": {"mrp": [1e999, 0, 0]}}', "1e999"),
            ("convert", '{"linkwright": 1, "orientation": {"mrp": [0, 0, 0], "mrp": [0, 0, 0]}}', "twice"),
            ("convert", {"orientation": {"mrp": [0, 0, 0]}, "vectors": [[1, 2]]}, "vectors[0]", "3 numbers"),
            ("convert", {"orientation": {"mrp": [0, 0, 0]}, "vectors": [[1, 2, 1e13]]}, "vectors[0]", "too large"),
            ("convert", {"orientation": {"mrp": [0, 0, 0]}, "vectors": [[0, 0, 0]] * 1001}, "vectors", "at most 1000"),
            ("convert", {"orientation": {"mrp": [0, 0, 0]}, "vector": [1, 2, 3]}, "vector", '"vectors"'),
            ("screw", {}, "displacement", "missing"), ("screw", {"displacement": {}}, "displacement", "no displacement"),
            ("screw", {"displacement": {"matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1]]}}, "displacement.matrix", "last row"),
            ("screw", {"displacement": {"matrix": [[1, 0, 0, 1e13], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}}, "displacement.matrix", "larger unit"),
            ("screw", {"displacement": {"matrix": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}}, "displacement.matrix", "rotation"),
            ("screw", {"displacement": {"screw": {"angle_deg": 1}}}, "displacement.screw.axis", "missing"),
            ("screw", {"displacement": {"screw": {"axis": [0, 0, 0]}}}, "displacement.screw.axis", "null vector"),
            ("screw", {"displacement": {"screw": {"axis": [0, 0, 1], "pitch": 1}}}, "displacement.screw.pitch", "nearest known"),
            ("screw", {"displacement": {"screw": {"axis": [0, 0, 1]}, "translation": [0, 0, 1]}}, "displacement", "more than one"),
            ("screw", {"displacement": {"from": {"translation": [0, 0, 1]}}}, "displacement.to", "missing"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}}, "motion", "missing"), ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {}}, "motion", "one form"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"velocity": [0, 0, 1], "euler_rates_deg": [0, 0, 1]}}, "motion", "one form"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"euler_rates_deg": [0, 0, 1]}}, "motion", "euler_deg"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"velocity": [0, 0, 1], "frame": "movign"}}, "motion.frame", "moving"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"quaternion_first": [0, 0, 0, 1], "frame": "fixed"}}, "motion.frame", "remove"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"matrix_first": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}, "motion.matrix_first", "skew"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"matrix_second": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}, "motion.matrix_first", "missing"),
            ("rates", {"orientation": {"mrp": [0, 0, 0]}, "motion": {"velocity": [0, 0, 1]}, "points": [{"positon": [0, 0, 0]}]}, "points[0].positon", "position"),
            ("dh", {}, "links", "missing"), ("dh", {"links": []}, "links", "0 links"), ("dh", {"links": [{"theta": 1}]}, "links[0].theta", "theta_deg"),
            ("dh", {"links": [{}], "form": "craig"}, "form", "classic"), ("dh", {"links": [{}], "displacement": {"translation": [0, 0, 0]}}, "displacement", "keep"),
            ("dh", {"links": [{"d": 1e13}]}, "links[0].d", "too large"),
        ):
            with self.subTest(content if len(str(content)) < 200 else command):
                self.assert_refused(command, content, *pieces)

    def test_flags(self):
        for arguments, pieces in (
            (("convert",), ("--axis", "--help")), (("convert", "a.json", "--mrp", "0,0,0"), ("--mrp", "not both")), (("convert", "missing.json"), ("missing.json", "No such file")),
            (("convert", "--axis", "0,0,0", "--angle", 1), ("--axis: ", "null vector")), (("convert", "--axis", "0,0", "--angle", 1), ("--axis: ", "3 numbers", "not 2")),
            (("convert", "--axis", "0,0,nan", "--angle", 1), ("--axis: ", "nan")), (("convert", "--axis", "0,0,1e999", "--angle", 1), ("--axis: ", "1e999")),
            (("convert", "--axis", "0,0,1"), ("orientation.angle_deg", "missing")), (("convert", "--angle", 1), ("no orientation",)),
            (("convert", "--euler", "xxx", "1,2,3"), ("--euler: ", "take xyz")), (("convert", "--euler", "xyz"), ("--euler",)),
            (("convert", "--matrix", "1,0,0,0,1,0,0,0,2"), ("--matrix: ", "nearest rotation")), (("convert", "--mrp", "0,0,0", "--rodrigues", "0,0,0"), ("keep one",)),
            (("convert", "--anlge", 1), ("--anlge", "linkwright attitude convert --help")), (("turn",), ("linkwright attitude --help",)), ((), ("linkwright attitude --help",)),
            (("screw", "--axis", "0,0,0"), ("--axis: ",)), (("screw", "--matrix", "1,2,3"), ("--matrix: ", "16 numbers")), (("dh", "--link", "1,2,3"), ("--link: ", "4 numbers")),
            (("rates", "--mrp", "0,0,0"), ("motion",)), (("rates", "--mrp", "0,0,0", "--velocity", "0,0,1", "--in", "body"), ("--in: ", "fixed")),
        ):
            with self.subTest(arguments):
                self.assert_mistake(run("attitude", *arguments), *pieces)


if __name__ == "__main__":
    unittest.main()
