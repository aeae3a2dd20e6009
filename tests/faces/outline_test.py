"""`linkwright outline`: a shape of a DXF or SVG drawing becomes the outline of the body."""

import json
import math
import unittest

from face_support import ROOT, TAILGATE, FaceTest, run

SECTION = "0\nSECTION\n2\n{}\n{}0\nENDSEC\n"


def dxf(*entities, header=""):
    start = SECTION.format("HEADER", header) if header else ""
    return start + SECTION.format("ENTITIES", "".join(entities)) + "0\nEOF\n"


def groups(*values):
    return "".join(f"{value}\n" for value in values)


def rectangle(x, y, width, height):
    corners = ((x, y), (x + width, y), (x + width, y + height), (x, y + height))
    return groups(0, "LWPOLYLINE", 90, 4, 70, 1) + "".join(groups(10, a, 20, b) for a, b in corners)


POINTS = "x;y\n0;9,5\n0;2\n0;-9,5\n4;-10,6\n7,3;1\n4,8;9,2\n0;9,5\n"


class Outline(FaceTest):
    def outline(self, drawing, *flags, name="part.dxf", problem=TAILGATE):
        """The outline, and what is printed."""
        target = self.folder / "with_outline.json"
        status, said, error = run("outline", self.write(name, drawing), problem, "-o", target, *flags)
        self.assertEqual((status, error), (0, ""))
        return json.loads(target.read_text())["view"]["outline"], said

    def refused(self, drawing, *pieces, flags=(), name="part.dxf", problem=TAILGATE):
        target = self.folder / "with_outline.json"
        self.assert_mistake(run("outline", self.write(name, drawing), problem, "-o", target, *flags), *pieces)
        self.assertFalse(target.exists())

    def test_the_largest_part_is_taken(self):
        corners, said = self.outline(dxf(rectangle(0, 0, 30, 20), rectangle(0, 0, 300, 100)))
        self.assertEqual(corners, [[0, 0], [300, 0], [300, 100], [0, 100]])
        self.assertIn("* shape 1: 300 × 100 mm, closed", said)
        self.assertEqual(self.outline(dxf(rectangle(0, 0, 30, 20), rectangle(0, 0, 300, 100)), "--shape", 2)[0][2], [30, 20])

    def test_fold_lines_that_meet_the_contour_do_not_cut_it(self):
        corners = [(19, 16), (20, 17), (150, 17), (151, 16), (150, 15), (150, 0), (170, 0), (170, 15), (169, 16), (170, 17),
                   (170, 104), (0, 104), (0, 17), (1, 16), (0, 15), (0, 0), (20, 0), (20, 15)]
        folds = [((1, 16), (19, 16)), ((151, 16), (169, 16))]
        lines = folds + list(zip(corners, corners[1:] + corners[:1]))
        for order in (lines, lines[::-1], lines[7:] + lines[:7], lines[::2] + lines[1::2]):
            drawn = [groups(0, "LINE", 8, "0", 10, a, 20, b, 11, c, 21, d) for (a, b), (c, d) in order]
            outline, said = self.outline(dxf(*drawn))
            self.assertIn("* shape 1: 170 × 104 mm, closed", said)
            self.assertEqual(len(outline), len(corners))

    def test_units_and_scale(self):
        inches = dxf(rectangle(0, 0, 10, 4), header=groups(9, "$INSUNITS", 70, 1))
        self.assertEqual(self.outline(inches)[0][2], [254, 101.6])
        self.assertEqual(self.outline(inches, "--unit", "cm")[0][2], [100, 40])
        self.assertEqual(self.outline(inches, "--scale", 3)[0][2], [30, 12])
        self.assertIn("brought to the size", self.outline(dxf(rectangle(0, 0, 1e6, 1e6)))[1])
        self.assertEqual(self.outline(dxf(rectangle(0, 0, 1e6, 1e6)), "--scale", 1)[0][2], [1e6, 1e6])

    def test_the_drawing_is_placed(self):
        corners, _ = self.outline(dxf(rectangle(1000, 0, 100, 50)))
        self.assertEqual(corners, [[-50, -25], [50, -25], [50, 25], [-50, 25]])
        corners, _ = self.outline(dxf(rectangle(1000, 0, 100, 50)), "--at", "5,6,90")
        self.assertEqual(corners, [[5, 1006], [5, 1106], [-45, 1106], [-45, 1006]])

    def test_svg(self):
        circle = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" viewBox="0 0 1000 500"><circle cx="0" cy="500" r="500"/></svg>'
        corners, _ = self.outline(circle, name="part.svg")
        self.assertLess(max(abs(math.hypot(x, y) - 50) for x, y in corners), 0.05)

    def test_everything_else_stays_and_the_picture_shows_it(self):
        problem = json.loads(run("outline", self.write("a.dxf", dxf(rectangle(0, 0, 300, 100))), TAILGATE)[1])
        problem["view"]["pins"] = [1.5]
        again = json.loads(run("outline", self.folder / "a.dxf", self.write("p.json", problem))[1])
        self.assertEqual(again, problem)
        bare = dict(problem)
        del bare["view"]
        pictures = [self.folder / "with.svg", self.folder / "without.svg"]
        for content, picture in zip((problem, bare), pictures):
            self.assertEqual(run("solve", self.write("q.json", content), "--samples", 64, "--svg", picture)[0], 0)
        polygons = [picture.read_text().count("<polygon") for picture in pictures]
        self.assertEqual(polygons[0] - polygons[1], len(problem["task"]["poses"]))

    def test_the_problem_may_be_replaced(self):
        problem = self.write("problem.json", TAILGATE.read_text())
        self.assertEqual(run("outline", self.write("a.dxf", dxf(rectangle(0, 0, 300, 100))), problem, "-o", problem)[0], 0)
        self.assertEqual(len(json.loads(problem.read_text())["view"]["outline"]), 4)

    def test_a_shape_becomes_the_points_of_a_path(self):
        path = self.write("path.json", {"linkwright": 1, "length_unit": "mm", "task": {"kind": "path", "mechanism": "four_bar",
                          "tolerance": 2, "points": [{"x": 0, "y": 0}, {"x": 1, "y": 0}, {"x": 0, "y": 1}]}})
        target = self.folder / "with_path.json"

        def task_of(*entities, flags=()):
            drawing = self.write("path.dxf", dxf(*entities))
            status, said, error = run("outline", drawing, path, "-o", target, *flags)
            self.assertEqual((status, error), (0, ""))
            return json.loads(target.read_text())["task"], said

        task, said = task_of(rectangle(0, 0, 30, 10), flags=("--points", 8, "--at", "100,0,90"))
        self.assertEqual([(point["x"], point["y"]) for point in task["points"]],
                         [(100, 0), (100, 10), (100, 20), (100, 30), (90, 30), (90, 20), (90, 10), (90, 0)])
        self.assertEqual((task["closed"], task["tolerance"]), (True, 2))
        self.assertIn("Closed path near 8 points", said)
        line = groups(0, "LINE", 8, "0", 10, 0, 20, 0, 11, 40, 21, 0) + groups(0, "LINE", 8, "0", 10, 40, 20, 0, 11, 40, 21, 40)
        task, said = task_of(line, flags=("--points", 5))
        self.assertEqual(sorted((point["x"], point["y"]) for point in task["points"]), [(0, 0), (20, 0), (40, 0), (40, 20), (40, 40)])
        self.assertNotIn("closed", task)
        status, output, error = run("solve", target)
        self.assertEqual((status, error), (0, ""), output)
        self.assert_mistake(run("outline", self.folder / "path.dxf", path, "--points", 2), "--points", "3 to 1000")

    def test_a_table_of_points_is_an_outline_and_a_path(self):
        self.refused("1,5,2,5\n3,5,4,5\n5,5,6,5\n", "line 1", "decimal points, or semicolons", name="loop.csv")
        self.refused("1,2\n3,4\n", "three lines", name="loop.csv")
        bean, target = ROOT / "examples/bean_stirrer.json", self.folder / "path.json"
        for flags, count in (((), 6), (("--points", 20), 20)):
            self.assertEqual(run("outline", self.write("loop.csv", POINTS), bean, "-o", target, *flags)[0], 0)
            task = json.loads(target.read_text())["task"]
            self.assertTrue(task["closed"])
            self.assertEqual(len(task["points"]), count)
        many = "".join(f"{k},{k * k % 7}\n" for k in range(1500))
        self.assert_mistake(run("outline", self.write("many.csv", many), bean), "--points", "1500 points")
        self.assertEqual(len(self.outline(POINTS, name="loop.csv")[0]), 6)

    def test_mistakes(self):
        part = dxf(rectangle(0, 0, 300, 100))
        self.refused(part, "--shape", "1 to 1", flags=("--shape", 2))
        self.refused(part, "--unit", "furlong", flags=("--unit", "furlong"))
        self.refused(part, "--scale", flags=("--scale", -1))
        self.refused(part, "--at", flags=("--at", "0,nan,0"))
        self.refused(part, ".dxf or .svg", name="part.step")
        self.assert_mistake(run("outline", self.folder / "none.dxf", TAILGATE), "none.dxf", "cannot be read")
        function = {"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar",
                    "pairs": [{"input_deg": x, "output_deg": x * x / 99} for x in (0, 30, 60, 90)]}}
        self.refused(part, "guides no body in the plane", problem=self.write("function.json", function))

    def test_hostile_drawings(self):
        self.refused("AutoCAD Binary DXF\r\n", "binary DXF")
        self.refused("0\nSECTION\n2\nENTITIES\n0\nLINE\nten\n0\n", "line 7")
        self.refused("0\nSECTION\n2\nENTITIES\n0\nLINE\n", "cut off")
        self.refused("<svg><g></svg>", "line 1", name="part.svg")
        self.refused("<html/>", "no <svg>", name="part.svg")
        self.refused(dxf(groups(0, "LWPOLYLINE", 90, 1 << 30, 10, "nan", 20, 0)), "no shape")
        self.refused(dxf(groups(0, "LWPOLYLINE", 90, 1 << 30, 70, 1, *(10, 1, 20, 1) * 110_000)), "too large")
        self.refused("<svg>" + "<g>" * 200 + "</g>" * 200 + "</svg>", "too deeply nested", name="part.svg")
        blocks = groups(0, "BLOCK", 2, "b", 0, "INSERT", 2, "b", 0, "ENDBLK")
        self.refused(SECTION.format("BLOCKS", blocks) + dxf(groups(0, "INSERT", 2, "b")), "too deeply nested")
        self.refused(dxf(rectangle(0, 0, 1e300, 1e300)), "no shape")
        self.refused("0\nSECTION\n" + " " * 17_000_000, "too large")


if __name__ == "__main__":
    unittest.main()
