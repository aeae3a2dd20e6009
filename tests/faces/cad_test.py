"""What `export` writes for CAD, printers and cutters, read by others' software."""

import json
import math
import shutil
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET
import zipfile
from pathlib import Path

import ezdxf
from face_support import CLI, ROOT, run

EXAMPLES = ("tailgate", "loader_bucket_chain", "folding_wing")


class CadExports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        for name in EXAMPLES:
            run("solve", ROOT / f"examples/{name}.json", "--samples", "60", "-o", cls.folder / f"{name}.result.json")

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def export(self, name, form, *flags, suffix=None):
        output = self.folder / f"{name}.{suffix or form}"
        status, _, error = run("export", self.folder / f"{name}.result.json", "--format", form, "-o", output, *flags)
        self.assertEqual(status, 0, error)
        return output

    def lengths(self, name):
        return json.loads((self.folder / f"{name}.result.json").read_text())["linkages"][0]

    def test_3mf_holds_a_named_mesh_of_each_part(self):
        for name in EXAMPLES:
            with zipfile.ZipFile(self.export(name, "3mf")) as archive:
                self.assertIsNone(archive.testzip())
                for member in archive.namelist():
                    ET.fromstring(archive.read(member))
                model = ET.fromstring(archive.read("3D/3dmodel.model"))
            core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
            self.assertEqual(model.get("unit"), "millimeter")
            names = [part.get("name") for part in model.iter(f"{core}object")]
            self.assertIn("ground", names)
            self.assertEqual(len(names), len(set(names)))
            for part in model.iter(f"{core}object"):
                vertices = len(list(part.iter(f"{core}vertex")))
                edges = set()
                for triangle in part.iter(f"{core}triangle"):
                    corners = [int(triangle.get(f"v{k}")) for k in (1, 2, 3)]
                    self.assertTrue(all(0 <= corner < vertices for corner in corners))
                    for one, other in zip(corners, corners[1:] + corners[:1]):
                        self.assertNotIn((one, other), edges)
                        edges.add((one, other))
                self.assertTrue(all((b, a) in edges for a, b in edges), part.get("name"))

    def test_stl_is_as_long_as_it_says(self):
        for name in EXAMPLES:
            content = self.export(name, "stl").read_bytes()
            (count,) = struct.unpack_from("<I", content, 80)
            self.assertEqual(len(content), 84 + 50 * count)

    def test_plates_have_a_layer_each_and_true_holes(self):
        for name in EXAMPLES[:2]:
            drawing = ezdxf.readfile(self.export(name, "plates", "--pin", "8", "--clearance", "0.3", "--width", "20", suffix="dxf"))
            self.assertEqual(drawing.audit().errors, [])
            self.assertEqual(drawing.header["$INSUNITS"], 4)
            layers = {entity.dxf.layer for entity in drawing.modelspace()}
            self.assertEqual(len(layers), 4 if name == "tailgate" else 6)
            for layer in layers:
                holes = drawing.modelspace().query(f'CIRCLE[layer=="{layer}"]')
                self.assertGreaterEqual(len(holes), 2)
                for hole in holes:
                    self.assertAlmostEqual(2 * hole.dxf.radius, 8.3)
                for arc in drawing.modelspace().query(f'ARC[layer=="{layer}"]'):
                    self.assertAlmostEqual(arc.dxf.radius, 10)

    def test_holes_of_a_plate_lie_as_far_apart_as_the_link_is_long(self):
        drawing = ezdxf.readfile(self.export("tailgate", "plates", suffix="dxf"))
        lengths = self.lengths("tailgate")["lengths"]
        for layer in ("ground", "input", "coupler", "output"):
            one, other = drawing.modelspace().query(f'CIRCLE[layer=="{layer}"]')
            apart = math.dist(tuple(one.dxf.center)[:2], tuple(other.dxf.center)[:2])
            self.assertAlmostEqual(apart / lengths[layer], 1, delta=1e-12)

    def test_step_of_every_position(self):
        for position in (1, 2, 3, 4):
            text = self.export("tailgate", "step", "--position", str(position)).read_text()
            self.assertTrue(text.startswith("ISO-10303-21;"))
            self.assertIn("AUTOMOTIVE_DESIGN", text)
            for part in ("ground", "input", "coupler", "output", "pin_input_ground"):
                self.assertIn(f"'{part}'", text)

    @unittest.skipUnless(shutil.which("freecadcmd"), "FreeCAD is not installed")
    def test_freecad_opens_the_step_file(self):
        step = self.export("folding_wing", "step")
        script = self.folder / "count.py"
        script.write_text(
            "import Part\n"
            f"shape = Part.read({str(step)!r})\n"
            "print('solids', len(shape.Solids), shape.isValid())\n"
        )
        answer = subprocess.run(["freecadcmd", script], capture_output=True, text=True, timeout=1200, check=False)
        self.assertIn("solids 8 True", answer.stdout, answer.stderr)

    def test_mistakes(self):
        def refused(name, form, *flags):
            output = self.folder / "refused"
            status, _, error = run("export", self.folder / f"{name}.result.json", "--format", form, "-o", output, *flags)
            self.assertFalse(output.exists())
            self.assertEqual(status, 2)
            return error

        self.assertIn("--position: the linkage does not get to a position 9", refused("tailgate", "step", "--position", "9"))
        self.assertIn("narrower than", refused("tailgate", "stl", "--pin", "200"))
        self.assertIn("--width", refused("tailgate", "stl", "--width", "-3"))
        self.assertIn("--width", refused("tailgate", "stl", "--width", "nan"))
        self.assertIn("curved", refused("folding_wing", "plates"))
        self.assertIn("sphere of radius", refused("folding_wing", "stl", "--radius", "10", "--thickness", "5"))

    def test_without_the_component_it_says_how_to_get_it(self):
        alone = self.folder / "bin"
        alone.mkdir()
        program = shutil.copy(CLI, alone / "linkwright")
        answer = subprocess.run(
            [program, "export", self.folder / "tailgate.result.json", "--format", "step"], capture_output=True, text=True, check=False
        )
        self.assertEqual(answer.returncode, 1)
        self.assertEqual(answer.stdout, "")
        self.assertIn("libocct-data-exchange-dev", answer.stderr)


if __name__ == "__main__":
    unittest.main()
