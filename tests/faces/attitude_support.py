"""What the tests of `attitude` share: matrices by hand, and a case that runs a command."""

import json
import math

from face_support import FaceTest, run

EXAMPLES = {"antenna": "convert", "gimbal_lock": "convert", "part_transfer": "screw", "climbing_turn": "twist", "spinning_top": "rates", "robot_arm": "dh"}


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


def quaternion_of(orientation):
    """Of three angles about the axes of a sequence, as files give them."""
    w, v = 1, [0, 0, 0]
    for axis, angle in zip(orientation["sequence"], orientation["euler_deg"]):
        c, s = math.cos(math.radians(angle) / 2), math.sin(math.radians(angle) / 2)
        u = [s if name == axis else 0 for name in "xyz"]
        w, v = w * c - sum(a * b for a, b in zip(v, u)), [w * a + c * b + x for a, b, x in zip(u, v, cross(v, u))]
    return [w, *v]


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
