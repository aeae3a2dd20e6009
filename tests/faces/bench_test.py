"""The peers of the benchmarks count what the kernels count: on small maps, so that no bench run is the first to see it."""

import json
import subprocess
import sys
import unittest
from pathlib import Path

from face_support import CLI, ROOT

sys.path.insert(0, str(ROOT / "bench"))
from peers import region_numpy, sphere_numpy  # noqa: E402

BENCH = Path(CLI).with_name("linkwright_bench")


class Peers(unittest.TestCase):
    def dump(self, *arguments):
        return json.loads(subprocess.run([BENCH, *arguments], check=True, capture_output=True, text=True, timeout=600).stdout)

    def test_numpy_counts_planar_linkages_alike(self):
        for task in ("landing_gear", "drawer_hinge", "tailgate"):
            with self.subTest(task=task):
                self.assertEqual(len(region_numpy.measure(self.dump("--dump", task, "100"), 1)), 1)

    def test_numpy_counts_spherical_linkages_alike(self):
        self.assertEqual(len(sphere_numpy.measure(self.dump("--dump-sphere", "100"), 1)), 1)

    def test_another_count_is_an_error(self):
        dump = self.dump("--dump", "tailgate", "100")
        dump["counts"]["branch"] += 1
        with self.assertRaises(AssertionError):
            region_numpy.measure(dump, 1)


if __name__ == "__main__":
    unittest.main()
