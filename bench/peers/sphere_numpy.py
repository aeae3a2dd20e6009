#!/usr/bin/python3
"""The region of a spherical task in numpy: the peer that the spherical kernel is measured against.

The same verdicts and the same columns, vectorised over blocks of whole rows that stay in the cache, by the same closed
forms; triple products by matrix products. Reads what `linkwright_bench --dump-sphere SAMPLES` writes, and checks its own
counts against the kernel's.

usage: sphere_numpy.py DUMP.json [REPETITIONS]
"""

import json
import sys
import time

import numpy as np

CHANGE_POINT = 1e-9  # tolerance::change_point
CELLS_PER_BLOCK = 8000
CHANGE_POINT_CODE, DEGENERATE_CODE, TRIPLE_ROCKER_CODE = 8, 9, 10
ORDER, BRANCH, CIRCUIT = 1, 2, 4


class Region:
    """The columns over all pairs."""

    def __init__(self, dump):
        self.fixed = np.array(dump["fixed"]).T.copy()  # sample × 3
        self.moving = [np.array(axes).T.copy() for axes in dump["moving"]]
        self.normal = [np.cross(self.fixed, axes) for axes in self.moving]
        self.sine, self.cosine = np.array(dump["half_sine"]), np.array(dump["half_cosine"])
        self.senses, self.wide = np.array(dump["senses"]), np.array(dump["wide"])
        self.size = len(self.sine)
        cells = (self.size, self.size)
        self.types, self.defects = np.empty(cells, np.uint8), np.empty(cells, np.uint8)
        self.versine, self.full_versine = np.empty(cells, np.float32), np.empty(cells, np.float32)
        self.least, self.largest = np.empty(cells, np.float32), np.empty(cells, np.float32)
        self.rows_at_once = max(1, CELLS_PER_BLOCK // self.size)

    def classify(self):
        with np.errstate(divide="ignore", invalid="ignore"):
            for begin in range(0, self.size, self.rows_at_once):
                self.classify_rows(slice(begin, min(begin + self.rows_at_once, self.size)))

    @staticmethod
    def half_angle(a, b):
        """Sine and cosine of half the angles between unit vectors, by their dot products: exact enough away from 0 and π."""
        dots = a @ b.T
        sine = np.sqrt(np.maximum(1 - dots, 0) * 0.5)
        np.add(dots, 1, out=dots)
        dots *= 0.5
        return sine, np.sqrt(np.maximum(dots, 0, out=dots), out=dots)

    def changes(self, rows, a, b):
        """Where a·b changes its sign from orientation to orientation."""
        first, changed = None, None
        for j in range(len(a)):
            negative = np.signbit(a[j][rows] @ b[j].T)
            if first is None:
                first, changed = negative, np.zeros_like(negative)
            else:
                changed |= negative != first
        return changed

    def classify_rows(self, rows):
        ground_s, ground_c = self.half_angle(self.fixed[rows], self.fixed)
        coupler_s, coupler_c = self.half_angle(self.moving[0][rows], self.moving[0])
        input_s, input_c = self.sine[rows, None], self.cosine[rows, None]
        output_s, output_c = self.sine, self.cosine
        sc, cs, ss, cc = ground_s * input_c, ground_c * input_s, ground_s * input_s, ground_c * input_c
        frame_sum, frame_sum_c, frame_diff, frame_diff_c = sc + cs, cc - ss, sc - cs, cc + ss
        sc, cs, ss, cc = coupler_s * output_c, coupler_c * output_s, coupler_s * output_s, coupler_c * output_c
        rest_sum, rest_sum_c, rest_diff, rest_diff_c = sc + cs, cc - ss, sc - cs, cc + ss
        a, b, c, d = frame_diff * rest_diff_c, frame_diff_c * rest_diff, rest_sum * frame_sum_c, rest_sum_c * frame_sum
        t1, t2, t3, t4 = a + b, a - b, c - d, c + d
        sides = [np.minimum(ground_s, ground_c), np.minimum(input_s, input_c), np.minimum(coupler_s, coupler_c),
                 np.minimum(output_s, output_c)]
        least = np.minimum(np.minimum(sides[0], sides[1]), np.minimum(sides[2], sides[3]))
        largest = np.maximum(np.maximum(sides[0], sides[1]), np.maximum(sides[2], sides[3]))
        zero = CHANGE_POINT * (sides[0] + sides[1] + sides[2] + sides[3])
        n1, n2, n3, n4 = t1 < 0, t2 < 0, t3 < 0, t4 < 0
        flat_0 = np.minimum(np.abs(t1), np.abs(t2)) <= zero
        flat_pi = np.minimum(np.abs(t3), np.abs(t4)) <= zero
        change_point, whole = flat_0 | flat_pi, least > np.maximum(zero, 2e-8)  # dot products know no smaller angle
        pass_0, pass_pi = (n1 == n2) & ~flat_0, (n3 == n4) & ~flat_pi
        regular = whole & ~change_point
        grashof = regular & (pass_0 == pass_pi)
        crank, output_crank = grashof & pass_0, grashof & (n1 != n3)
        types = self.types[rows]
        types[...] = np.where(pass_0, np.where(output_crank, 2, 0), np.where(output_crank, 1, 3))
        types[regular & ~grashof] = TRIPLE_ROCKER_CODE
        types[change_point] = CHANGE_POINT_CODE
        types[~whole] = DEGENERATE_CODE
        np.multiply(2 * least, least, out=self.least[rows], casting="same_kind")
        np.multiply(2 * largest, largest, out=self.largest[rows], casting="same_kind")
        self.least[rows][~whole] = self.largest[rows][~whole] = 0

        fixed = [self.fixed] * len(self.moving)
        output_changes = self.changes(rows, self.moving, self.normal)
        circuit = crank & output_changes
        circuit |= output_crank & ~crank & self.changes(rows, self.normal, self.moving)
        circuit |= grashof & ~crank & ~output_crank & self.changes(rows, self.normal, fixed)
        branch = circuit | output_changes

        coupler_v, output_v = 2 * coupler_s * coupler_s, 2 * output_s * output_s
        still = coupler_v + output_v - coupler_v * output_v
        worst_0, worst_pi = np.abs(still - 2 * frame_diff * frame_diff), np.abs(still - 2 * frame_sum * frame_sum)
        ends, turn = [], []
        for j in (0, len(self.moving) - 1):
            ends.append(np.abs(still - (1 - self.moving[j][rows] @ self.fixed.T)))
            turn.append(-(self.normal[j][rows] @ self.fixed.T))
        senses = self.senses[rows, None]
        backward, wide = senses == 2, (self.wide[rows, None] & senses) != 0
        first, last = np.where(backward, turn[1], turn[0]), np.where(backward, turn[0], turn[1])
        passes_0 = np.where(wide, (first < 0) | (last > 0), (first < 0) & (last > 0))
        passes_pi = np.where(wide, (first > 0) | (last < 0), (first > 0) & (last < 0))
        in_order = ~((passes_0 & ~pass_0) | (passes_pi & ~pass_pi)) & (senses != 0)
        worst = np.maximum(ends[0], ends[1])
        np.maximum(worst, worst_0, out=worst, where=passes_0)
        np.maximum(worst, worst_pi, out=worst, where=passes_pi)

        branch |= change_point & ~in_order & (senses != 0)
        defects = self.defects[rows]
        np.multiply(circuit, np.uint8(CIRCUIT), out=defects)
        defects |= branch * np.uint8(BRANCH)
        defects |= ~(branch | in_order) * np.uint8(ORDER)
        defects[~whole] = 0
        scale = 4 * (coupler_s * coupler_c) * (output_s * output_c)
        self.put_versine(self.versine[rows], whole & (defects == 0), scale, worst)
        self.put_versine(self.full_versine[rows], crank, scale, np.maximum(worst_0, worst_pi))

    @staticmethod
    def put_versine(column, mask, scale, worst):
        np.subtract(scale, worst, out=column, where=mask, casting="same_kind")
        np.maximum(column, 0, out=column, where=mask)
        np.divide(column, scale.astype(np.float32), out=column, where=mask)
        column[~mask] = 0

    def counts(self):
        whole = self.types != DEGENERATE_CODE
        types = np.bincount(self.types.ravel(), minlength=11)
        types[DEGENERATE_CODE] -= self.size  # the diagonal
        return {
            "types": types.tolist(),
            "order": int(np.count_nonzero(self.defects & ORDER)),
            "branch": int(np.count_nonzero(self.defects & BRANCH)),
            "circuit": int(np.count_nonzero(self.defects & CIRCUIT)),
            "defect_free": int(np.count_nonzero(whole & (self.defects == 0))),
        }


def measure(dump, repetitions):
    """Nanoseconds a mechanism, by repetition; the counts equal the kernel's but for ten cells of a million, whose angles
    dot products do not tell from 0, or this raises."""
    region = Region(dump)
    taken = []
    for _ in range(repetitions):
        begin = time.perf_counter()
        region.classify()
        taken.append(1e9 * (time.perf_counter() - begin) / region.size**2)
    ours, theirs = region.counts(), dump["counts"]
    off = max(abs(a - b) for a, b in zip(ours["types"], theirs["types"]))
    off = max(off, *(abs(ours[key] - theirs[key]) for key in ("order", "branch", "circuit", "defect_free")))
    if off > 1e-5 * region.size**2:
        raise SystemExit(f"counts differ: {ours} and the kernel's {theirs}")
    return taken


def main(path, repetitions="5"):
    with open(path, encoding="utf-8") as file:
        taken = measure(json.load(file), int(repetitions))
    print("ns a mechanism:", ", ".join(f"{ns:.1f}" for ns in taken))


if __name__ == "__main__":
    main(*sys.argv[1:])
