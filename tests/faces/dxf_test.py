"""DXF drawings as a CAD program reads them (ezdxf)."""

import math
import unittest

from face_support import ROOT, FaceTest, load, run

try:
    import ezdxf
    from ezdxf import recover
except ImportError:
    ezdxf = None


@unittest.skipIf(ezdxf is None, "python3-ezdxf is not installed")
class DxfDrawing(FaceTest):
    def drawing(self, number=1, unit="mm"):
        result = self.solve_tailgate()
        text = result.read_text(encoding="utf-8").replace('"length_unit": "mm"', f'"length_unit": "{unit}"')
        result.write_text(text, encoding="utf-8")
        path = self.folder / "linkage.dxf"
        self.assertEqual(run("export", result, "--linkage", number, "--format", "dxf", "-o", path)[0], 0)
        return path, load(result)["linkages"][number - 1]

    def test_passes_the_audit(self):
        for number in (1, 2, 3):
            path, _ = self.drawing(number)
            document = ezdxf.readfile(path)
            audit = document.audit()
            self.assertEqual((list(audit.errors), list(audit.fixes)), ([], []))
            _, strict = recover.readfile(path)
            self.assertEqual((list(strict.errors), list(strict.fixes)), ([], []))
            self.assertEqual(document.dxfversion, "AC1015")

    def test_units(self):
        for unit, code in (("mm", 4), ("cm", 5), ("m", 6), ("in", 1), ("ft", 2), ("furlong", 0)):
            self.assertEqual(ezdxf.readfile(self.drawing(unit=unit)[0]).units, code)

    def test_pins_lie_at_the_pivots_1_to_1(self):
        path, linkage = self.drawing()
        space = ezdxf.readfile(path).modelspace()
        for link, ends in {
            "INPUT": (linkage["input"]["center_point"], linkage["input"]["circle_point"]),
            "OUTPUT": (linkage["output"]["center_point"], linkage["output"]["circle_point"]),
            "COUPLER": (linkage["input"]["circle_point"], linkage["output"]["circle_point"]),
            "GROUND": (linkage["input"]["center_point"], linkage["output"]["center_point"]),
        }.items():
            pins = [circle.dxf.center for circle in space.query(f'CIRCLE[layer=="{link}"]')]
            self.assertEqual(len(pins), 2)
            for pin, end in zip(pins, ends):
                self.assertAlmostEqual(math.dist((pin.x, pin.y), end), 0, delta=1e-9)
            self.assertAlmostEqual(math.dist(pins[0], pins[1]), linkage["lengths"][link.lower()], delta=1e-6)

    def test_springs_of_loads_have_layers_of_their_own(self):
        result, path = self.folder / "struts.json", self.folder / "struts.dxf"
        self.assertEqual(run("solve", ROOT / "examples/tailgate_struts.json", "--samples", 60, "-o", result)[0], 0)
        self.assertEqual(run("export", result, "--format", "dxf", "-o", path)[0], 0)
        document = ezdxf.readfile(path)
        self.assertEqual(document.audit().errors, [])
        space = document.modelspace()

        def circles(layer):
            return [(circle.dxf.center.x, circle.dxf.center.y) for circle in space.query(f'CIRCLE[layer=="{layer}"]')]

        # In position 1 the moving frame lies on the fixed one.
        self.assertEqual(circles("SPRINGS"), [(150, 115), (60, 298)])
        (line,) = space.query('LINE[layer=="SPRINGS"]')
        self.assertEqual([(end.x, end.y) for end in (line.dxf.start, line.dxf.end)], [(150, 115), (60, 298)])
        self.assertEqual(circles("HANDLE"), [(-5, -70)])
        links = load(result)["linkages"][0]
        middles = [[(a + b) / 2 for a, b in zip(links[link]["center_point"], links[link]["circle_point"])] for link in ("input", "output")]
        for found, wanted in zip(circles("MASSES"), [(40, 120), *middles, (70, 200)], strict=True):
            self.assertAlmostEqual(math.dist(found, wanted), 0, delta=1e-9)
        self.assertNotIn("SPRINGS", self.drawing()[0].read_text())

    def test_coupler_curve_passes_the_poses(self):
        path, _ = self.drawing()
        space = ezdxf.readfile(path).modelspace()
        curve = space.query('LWPOLYLINE[layer=="COUPLER_CURVE"]')
        self.assertEqual(len(curve), 1)
        points = [(x, y) for x, y, *_ in curve[0].get_points()]
        for pose in ((0, 0), (-125, 75), (-220, 220), (-220, 450)):
            self.assertLess(min(math.dist(pose, point) for point in points), 2)


if __name__ == "__main__":
    unittest.main()
