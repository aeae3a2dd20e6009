#!/usr/bin/python3
"""The region of a task in numpy: the peer that Linkwright's kernel is measured against.

The same verdicts and the same six columns, vectorised over blocks of whole rows that stay in the cache, into arrays that
are made once; what few cells ask for is worked out for those cells alone. Reads what `linkwright_bench --dump TASK SAMPLES`
writes, and checks its own counts against the kernel's.

usage: region_numpy.py DUMP.json [REPETITIONS]
"""

import json
import sys
import time

import numpy as np

CHANGE_POINT = 1e-9  # tolerance::change_point
CELLS_PER_BLOCK = 8000  # some twenty arrays of doubles: 1.3 MB
CHANGE_POINT_CODE, DEGENERATE_CODE = 8, 9
TYPE_OF_SIGNS = np.array([5, 2, 3, 7, 1, 6, 4, 0], np.uint8)  # LinkageType by the signs of the three excesses, T₁ first
ORDER, BRANCH, CIRCUIT = 1, 2, 4


class Axis:
    """The side links of a task, an array for each quantity; arms by pose."""

    def __init__(self, dump):
        for name, values in dump["axis"].items():
            setattr(self, name, np.array(values))
        self.poses = len(self.arm_x)
        self.moved_x, self.moved_y = self.center_x + self.arm_x, self.center_y + self.arm_y


class Region:
    """The columns over all pairs, and the arrays to work in."""

    def __init__(self, axis, unit):
        self.axis, self.unit, self.size = axis, unit, len(axis.length)
        cells = (self.size, self.size)
        self.types, self.defects = np.empty(cells, np.uint8), np.empty(cells, np.uint8)
        self.versine, self.full_versine = np.empty(cells, np.float32), np.empty(cells, np.float32)
        self.ratio, self.longest = np.empty(cells, np.float32), np.empty(cells, np.float32)
        self.rows_at_once = max(1, CELLS_PER_BLOCK // self.size)
        self.real = [np.empty((self.rows_at_once, self.size)) for _ in range(14)]

    def classify(self):
        with np.errstate(divide="ignore", invalid="ignore"):
            for begin in range(0, self.size, self.rows_at_once):
                self.classify_rows(slice(begin, min(begin + self.rows_at_once, self.size)))

    def classify_rows(self, rows):
        axis = self.axis
        height = rows.stop - rows.start
        fx, fy, gg, hh, g, h, ab, t1, t2, t3, zero, u, v, w = (array[:height] for array in self.real)

        def of_rows(values):
            return values[rows, None]

        a, b = of_rows(axis.length), axis.length
        np.subtract(axis.center_x, of_rows(axis.center_x), out=fx)
        np.subtract(axis.center_y, of_rows(axis.center_y), out=fy)
        np.multiply(fx, fx, out=gg)
        gg += np.multiply(fy, fy, out=u)
        np.subtract(of_rows(axis.circle_x), axis.circle_x, out=u)
        np.multiply(u, u, out=hh)
        np.subtract(of_rows(axis.circle_y), axis.circle_y, out=u)
        hh += np.multiply(u, u, out=u)
        np.sqrt(gg, out=g)
        np.sqrt(hh, out=h)

        # Grashof's excesses and the type.
        np.add(g, h, out=u)
        np.add(a, b, out=ab)
        np.subtract(u, ab, out=t1)
        u += ab
        np.multiply(u, CHANGE_POINT, out=zero)
        np.subtract(np.add(g, b, out=t2), np.add(a, h, out=u), out=t2)
        np.subtract(np.add(h, b, out=t3), np.add(g, a, out=u), out=t3)
        p1, p2, p3 = t1 > zero, t2 > zero, t3 > zero
        shortest = np.minimum(np.minimum(a, b, out=u), np.minimum(g, h, out=v), out=u)
        whole = shortest > zero
        longest = np.maximum(np.maximum(a, b, out=v), np.maximum(g, h, out=w), out=v)
        np.negative(zero, out=zero)
        n1, n2, n3 = t1 < zero, t2 < zero, t3 < zero
        change_point = ~((p1 | n1) & (p2 | n2) & (p3 | n3))
        types = self.types[rows]
        TYPE_OF_SIGNS.take(p1 * np.uint8(4) + p2 * np.uint8(2) + p3, out=types)
        types[change_point] = CHANGE_POINT_CODE
        types[~whole] = DEGENERATE_CODE
        ratio = self.ratio[rows]
        ratio[...] = longest
        np.multiply(ratio, np.float32(self.unit), out=self.longest[rows])
        ratio /= shortest.astype(np.float32)
        ratio[~whole] = self.longest[rows][~whole] = 0

        # Joint signs: at the output's moving joint everywhere, at the others where the circuit depends on them.
        output_changes = np.zeros((height, self.size), bool)
        for j in range(axis.poses):
            np.subtract(of_rows(axis.arm_y[j]), fy, out=t1)
            t1 *= axis.arm_x[j]
            np.subtract(of_rows(axis.arm_x[j]), fx, out=t2)
            t2 *= axis.arm_y[j]
            t1 -= t2
            negative = np.signbit(t1)
            if j == 0:
                first = negative
            else:
                output_changes |= negative != first
        meets_frame = (p1 & p2) | (n1 & n2)
        cranks = p3 & meets_frame
        lost_circuit = cranks & output_changes
        self.check_joint(lost_circuit, rows, p1 & n2 & n3, self.at_input_circle)
        self.check_joint(lost_circuit, rows, n1 & p2 & n3, self.at_input_center)
        lost_branch = output_changes | lost_circuit

        # The travel: which of its limits the driver passes, and |cos μ|·hb at its largest.
        hb, still, swing = np.multiply(h, b, out=h), np.subtract(hh, gg, out=hh), np.multiply(g, a, out=g)
        still += b * b - a * a
        still *= 0.5
        worst_0 = np.abs(np.add(still, swing, out=t1), out=t1)
        worst_pi = np.abs(np.subtract(still, swing, out=t2), out=t2)
        turn, ends = [], []
        for j in (0, axis.poses - 1):
            arm_x, arm_y = of_rows(axis.arm_x[j]), of_rows(axis.arm_y[j])
            turn.append(fx * arm_y - fy * arm_x)
            end = fx * arm_x
            end += np.multiply(fy, arm_y, out=w)
            end += still
            ends.append(np.abs(end, out=end))
        senses = of_rows(axis.senses)
        backward = senses == 2  # with four poses, a driver has one sense at most
        wide = (of_rows(axis.wide) & senses) != 0
        in_negative, in_positive = (np.where(backward, turn[1], turn[0]) < 0, np.where(backward, turn[1], turn[0]) > 0)
        out_negative, out_positive = (np.where(backward, turn[0], turn[1]) < 0, np.where(backward, turn[0], turn[1]) > 0)
        passes_0 = np.where(wide, in_negative | out_positive, in_negative & out_positive)
        passes_pi = np.where(wide, in_positive | out_negative, in_positive & out_negative)
        in_order = ~((passes_0 & ~meets_frame) | (passes_pi & ~p3)) & (senses != 0)
        worst = np.maximum(ends[0], ends[1], out=t3)
        np.maximum(worst, worst_0, out=worst, where=passes_0)
        np.maximum(worst, worst_pi, out=worst, where=passes_pi)

        lost_branch |= change_point & ~in_order & (senses != 0)
        defects = self.defects[rows]
        np.multiply(lost_circuit, np.uint8(CIRCUIT), out=defects)
        defects |= lost_branch * np.uint8(BRANCH)
        defects |= ~(lost_branch | in_order) * np.uint8(ORDER)
        defects[~whole] = 0
        self.put_versine(self.versine[rows], whole & (defects == 0), hb, worst)
        self.put_versine(self.full_versine[rows], whole & cranks, hb, np.maximum(worst_0, worst_pi, out=worst_0))

    def check_joint(self, lost_circuit, rows, asked, joint):
        """Adds the cells among those asked for where the joint's sign changes."""
        row, column = np.nonzero(asked)
        if not len(row):
            return
        driver = row + rows.start
        first = np.signbit(joint(driver, column, 0))
        changes = np.zeros(len(row), bool)
        for j in range(1, self.axis.poses):
            changes |= np.signbit(joint(driver, column, j)) != first
        lost_circuit[row[changes], column[changes]] = True

    def at_input_circle(self, driver, driven, j):
        axis = self.axis
        x = axis.moved_x[j][driven] - axis.center_x[driver]
        y = axis.moved_y[j][driven] - axis.center_y[driver]
        return x * axis.arm_y[j][driver] - y * axis.arm_x[j][driver]

    def at_input_center(self, driver, driven, j):
        axis = self.axis
        x = axis.center_x[driven] - axis.center_x[driver]
        y = axis.center_y[driven] - axis.center_y[driver]
        return x * axis.arm_y[j][driver] - y * axis.arm_x[j][driver]

    @staticmethod
    def put_versine(column, mask, hb, worst):
        np.subtract(hb, worst, out=column, where=mask, casting="same_kind")
        np.maximum(column, 0, out=column, where=mask)
        np.divide(column, hb.astype(np.float32), out=column, where=mask)
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
    """Nanoseconds a mechanism, by repetition; the counts equal the kernel's or this raises."""
    region = Region(Axis(dump), dump["unit"])
    taken = []
    for _ in range(repetitions):
        begin = time.perf_counter()
        region.classify()
        taken.append((time.perf_counter() - begin) * 1e9 / region.size**2)
    if region.counts() != dump["counts"]:
        raise AssertionError(f"{dump['task']}: numpy counts {region.counts()}, the kernel {dump['counts']}")
    return taken


def main(arguments):
    if not arguments:
        print(__doc__, file=sys.stderr)
        return 2
    with open(arguments[0], encoding="utf-8") as file:
        dump = json.load(file)
    taken = measure(dump, int(arguments[1]) if len(arguments) > 1 else 3)
    print(f"{dump['task']}: counts equal the kernel's: {dump['counts']}")
    print(f"{min(taken):.1f} ns a mechanism at best of {len(taken)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
