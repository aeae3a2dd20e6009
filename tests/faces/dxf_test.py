"""DXF drawings as a CAD program reads them (ezdxf)."""

import math
import unittest

from face_support import FaceTest, load, run

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
