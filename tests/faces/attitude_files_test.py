"""The files of `attitude`: examples, schema, pictures, and what is refused."""

import copy
import json
import re
import unittest
import xml.etree.ElementTree

from attitude_support import AttitudeTest, EXAMPLES
from face_support import ROOT, load, run
from documents_test import commands, mismatch
from schema_test import apply, paths

try:
    import jsonschema
except ImportError:
    jsonschema = None

PICTURES = ROOT / "docs/theory"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


def alike(drawn, fresh):
    """The same picture, but for coordinates that rounding moved by a hundredth of a px."""
    pairs = zip(NUMBER.findall(drawn), NUMBER.findall(fresh))
    return NUMBER.sub("#", drawn) == NUMBER.sub("#", fresh) and all(abs(float(a) - float(b)) < 0.025 for a, b in pairs)


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
        self.assertIn("Rotation by", output)
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
        "twist": ({"twist": {"angular_velocity": [1, 2, 3], "velocity": [4, 5, 6], "at": [7, 8, 9]}},
                  {"twist": {"screw": {"axis": [1, 0, 0], "point": [1, 2, 3], "rate": 4, "slide_rate": 5}}},
                  {"twist": {"screw": {"axis": [1, 0, 0], "rate": 4, "pitch": 5}}, "length_unit": "mm"}),
        "rates": ({"orientation": {"mrp": [0, 0, 0.1]}, "motion": {"velocity": [1, 2, 3], "acceleration": [4, 5, 6], "frame": "moving"},
                   "origin": {"position": [1, 2, 3], "velocity": [1, 2, 3], "acceleration": [1, 2, 3]}, "step": 2},
                  {"orientation": {"quaternion": [1, 0, 0, 0]}, "motion": {"quaternion_first": [0, 1, 0, 0], "quaternion_second": [-1, 0, 0, 0]}}),
        "dh": ({"displacement": {"translation": [1, 2, 3]}, "form": "modified"},),
    }
    BEYOND = ("rotation", "last row", "null vector", "all four components", "equally near", "skew", "symmetric part", "euler_deg")  # no matter of structure

    def test_what_the_schema_refuses_the_reader_refuses(self):
        schema = load(ROOT / "schema/attitude.schema.json")
        for command in ("convert", "screw", "twist", "rates", "dh"):
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
        page = "".join((PICTURES / f"{name}.md").read_text(encoding="utf-8") for name in ("attitude", "infinitesimal"))
        drawn = re.findall(r"^\$ linkwright (.*--svg (docs/theory/\w+\.svg))", page, re.MULTILINE)
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
            ("screw", {"displacement": {"screw": {"axis": [0, 0, 1], "pitch": 1}}}, "displacement.screw.pitch", "known are"),
            ("screw", {"displacement": {"screw": {"axis": [0, 0, 1]}, "translation": [0, 0, 1]}}, "displacement", "more than one"),
            ("screw", {"displacement": {"from": {"translation": [0, 0, 1]}}}, "displacement.to", "missing"),
            ("twist", {}, "twist", "missing"), ("twist", {"twist": {}}, "twist", "one form"),
            ("twist", {"twist": {"velocity": [0, 0, 1], "screw": {"axis": [0, 0, 1]}}}, "twist", "one form"),
            ("twist", {"twist": {"screw": {"axis": [0, 0, 0], "rate": 1}}}, "twist.screw.axis", "null vector"),
            ("twist", {"twist": {"screw": {"axis": [0, 0, 1], "slide_rate": 1, "pitch": 1}}}, "twist.screw.pitch", "keep one"),
            ("twist", {"twist": {"velocity": [0, 0, 1]}, "points": [[0, 0]]}, "points[0]", "3 numbers"),
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
            (("twist", "--at", "1,2"), ("--at: ", "3 numbers")), (("twist", "--axis", "0,0,1", "--pitch", 1, "--slide-rate", 1), ("--pitch: ", "keep one")),
            (("rates", "--mrp", "0,0,0"), ("motion",)), (("rates", "--mrp", "0,0,0", "--velocity", "0,0,1", "--in", "body"), ("--in: ", "fixed")),
        ):
            with self.subTest(arguments):
                self.assert_mistake(run("attitude", *arguments), *pieces)


if __name__ == "__main__":
    unittest.main()
