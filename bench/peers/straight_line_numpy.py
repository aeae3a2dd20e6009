#!/usr/bin/python3
"""The map of straight lines in numpy: the peer that the engine is measured against.

The case with both ground pivots given (four points of contact, two linkages at each place): geometry, then the path of
every linkage beside its line and what that is worth, by the same formulas and steps, vectorised over blocks of cells
that stay in the cache. Left out are the type, the deviation and the ratios of links, which the engine's map has too. Reads
what `linkwright_bench --dump-lines SAMPLES` writes, and checks its own numbers against the engine's.

usage: straight_line_numpy.py DUMP.json [REPETITIONS]
"""

import json
import sys
import time

import numpy as np

ORDER, STEPS, CONTACT = 7, 28, 4
LONGEST_STEP, STEPS_TO_DEVIATION = 0.05, 12
VANISHING_LINK = SLIDING_PIVOT = 1e-6  # tolerance::vanishing_link, tolerance::sliding_pivot
CELLS_PER_BLOCK = 1500


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


def norm(a):
    return a.real * a.real + a.imag * a.imag


class Linkages:
    """Those of both layers, all cells; complex numbers by cell."""

    def __init__(self, dump):
        point = lambda pair: complex(*pair)
        self.along, self.line = point(dump["direction"]), point(dump["point"])
        self.a0, self.b0 = point(dump["input"]), point(dump["output"])
        self.deviation = dump["deviation"]
        self.first, self.second = (np.exp(1j * np.array(dump[key])) for key in ("first", "second"))
        self.columns = self.design()

    def design(self):
        first, second = self.first[:, None], self.second[None, :]
        left = 1j * self.along
        pole = self.a0 + first * (cross(self.b0 - self.a0, second) / cross(first, second))
        a, b = dot(self.a0 - pole, first), dot(self.b0 - pole, second)
        height = dot(left, pole - self.line)
        c, to_point = np.abs(height), np.where(height > 0, -left, left)
        z = cross(second, to_point) / a * first**2 - cross(first, to_point) / b * second**2
        tangent = np.sqrt(z / np.abs(z))
        point, layers = pole + c * to_point, []
        for along in (tangent, 1j * tangent):
            sine_of_point = cross(along, to_point)

            def moving(from_pole, ray):
                sine = c * cross(along, ray)
                return pole + from_pole * (sine / (from_pole * sine_of_point + sine)) * ray

            layers.append(self.built(moving(a, first), moving(b, second), point))
        return [np.concatenate(column) for column in zip(*layers)]

    def built(self, input_circle, output_circle, point):
        """Those that are four-bars: moving pivots, point, longest link."""
        away = [norm(pivot - point) for pivot in (self.a0, input_circle, self.b0, output_circle)]
        links = [norm(a - b) for a, b in ((self.a0, input_circle), (input_circle, output_circle), (output_circle, self.b0),
                                          (input_circle, point), (output_circle, point))]
        frame = abs(self.b0 - self.a0) ** 2
        longest = np.maximum.reduce([*links, np.full_like(away[0], frame)])
        shortest = np.minimum.reduce([*links, np.full_like(away[0], frame)])
        good = np.maximum.reduce(away) * SLIDING_PIVOT**2 <= frame
        good &= shortest > VANISHING_LINK**2 * longest
        return input_circle[good], output_circle[good], point[good], np.sqrt(longest[good])


def loop_series(links):
    """e^{if} of each link by the parameter of the loop, to the seventh power, and the first derivatives of the turns f."""
    way = [cross(links[1], links[2]), cross(links[2], links[0]), cross(links[0], links[1])]
    square = way[0] ** 2 + way[1] ** 2 + way[2] ** 2
    unit = 1 / np.sqrt(square)
    back = [(links[(j + 1) % 3] * way[j - 1] - links[j - 1] * way[(j + 1) % 3]) / square for j in range(3)]
    turn = [[None, way[j] * unit] for j in range(3)]
    rotation = [[1.0, 1j * turn[j][1]] for j in range(3)]
    for k in range(2, ORDER + 1):
        known = [1j / k * sum(i * turn[j][i] * rotation[j][k - i] for i in range(1, k)) for j in range(3)]
        gap = links[0] * known[0] + links[1] * known[1] + links[2] * known[2]
        for j in range(3):
            turn[j].append(-dot(gap, back[j]))
            rotation[j].append(known[j] + 1j * turn[j][k])
    return rotation, [turns[1] for turns in turn]


def root_estimate(value, degree):
    """By a share of the bits, which grow about as the logarithm does."""
    bits = value.view(np.int64) / degree + float(0x3FF0_0000 << 32) * (1 - 1 / degree)
    return bits.astype(np.int64).view(np.float64)


class Paths:
    """The paths of some linkages by steps from where they lie: both ways × steps × cells."""

    def __init__(self, linkages, cells):
        a, b, point, longest = (column[cells] for column in linkages.columns)
        a0, b0, line = linkages.a0, linkages.b0, linkages.along
        self.deviation = linkages.deviation if linkages.deviation is not None else 1e-4 * longest
        links, arm = [a - a0, b - a, b0 - b], point - a
        rotation, turns = loop_series(links)
        path = [links[0] * rotation[0][k] + arm * rotation[1][k] for k in range(1, ORDER + 1)]
        along, off = dot(line, path[0]), [cross(line, term) for term in path]
        self.coefficient = off[CONTACT - 1] / along**CONTACT
        reach = np.minimum.reduce(
            [root_estimate(np.minimum(self.deviation / np.maximum(np.abs(off[k - 1]), 1e-300), 1e200), k)
             for k in range(CONTACT, ORDER + 1)])
        step = np.minimum(reach * np.abs(turns[1]), STEPS_TO_DEVIATION * LONGEST_STEP) / STEPS_TO_DEVIATION
        self.walk(links, arm / links[1], line, np.copysign(step, turns[1] * along), b0 - a0)

    def walk(self, links, arm_in_coupler, line, step, ground):
        """The coupler turns; the other two links by the intersection of two circles."""
        first, coupler, output = links
        square, side = norm(first), np.sign(cross(first + output, first))
        difference, still = square - norm(output), norm(coupler) * norm(output)
        count = len(step)
        driven = np.stack([coupler, coupler])
        rotor = np.exp(1j * np.stack([step, -step]))
        start = first + coupler * arm_in_coupler
        sense = np.array([[1.0], [-1.0]])
        shape = (2, STEPS + 1, count)
        self.s, self.e, self.sine_square, self.velocity = (np.empty(shape) for _ in range(4))
        on, self.last, before = np.ones((2, count), bool), np.zeros((2, count), int), np.zeros((2, count))
        taken = 0
        for i in range(STEPS + 1):
            if i in (17, 23):
                rotor = rotor * rotor
            if i > 0:
                driven = driven * rotor
                rest = ground - driven
                length = norm(rest)
                share = (length + difference) / (2 * length)
                height = square / length - share * share
                on &= height > 0
                input_link = rest * (share + 1j * side * np.sqrt(np.maximum(height, 0)))
            else:
                input_link = np.stack([first, first])
            output_link, arm = ground - input_link - driven, driven * arm_in_coupler
            moved = (input_link + arm - start) * np.conj(line)
            sine = cross(driven, output_link)
            rate = sine * input_link + cross(output_link, input_link) * arm
            self.s[:, i], self.e[:, i] = sense * moved.real, moved.imag
            self.sine_square[:, i], self.velocity[:, i] = sine * sine / still, -cross(line, rate) / sine
            if i == 0:
                self.s[:, 0] = self.e[:, 0] = 0
                continue
            on &= self.s[:, i] > before
            before = self.s[:, i]
            self.last += on
            on &= np.abs(self.e[:, i]) < 2 * self.deviation
            taken = i
            if not on.any():
                break
        for name in ("s", "e", "sine_square", "velocity"):
            setattr(self, name, getattr(self, name)[:, : taken + 1])
        self.there = np.arange(taken + 1)[:, None] <= self.last[:, None]

    @staticmethod
    def at(values, index):
        return np.take_along_axis(values, index[:, None], 1)[:, 0]

    def usable(self):
        """The way along the line on both sides, the last sample within, and the share of the next step."""
        off = self.there & (np.abs(self.e) > self.deviation)
        leaves = off.any(1)
        inside = np.where(leaves, off.argmax(1), self.last + 1) - 1
        beyond = np.minimum(inside + 1, self.last)
        e, far_e, s, far_s = self.at(self.e, inside), self.at(self.e, beyond), self.at(self.s, inside), self.at(self.s, beyond)
        share = np.where(leaves, (np.copysign(self.deviation, far_e) - e) / np.where(leaves, far_e - e, 1), 0)
        return s + share * (far_s - s), inside, beyond, share

    def strip(self):
        """The length of the longest stretch over which e ranges over 2 δ."""
        width = 2 * self.deviation
        low, high = np.minimum.accumulate(self.e, 1), np.maximum.accumulate(self.e, 1)
        best = np.zeros(self.e.shape[2])
        top, bottom, fits = np.empty(self.e.shape[1:]), np.empty(self.e.shape[1:]), np.empty(self.e.shape[1:], bool)
        for near, far in ((0, 1), (1, 0)):
            reach = np.zeros(self.e.shape[1:], np.int8)
            for j in range(1, self.e.shape[1]):
                np.maximum(high[near], high[far, j], out=top)
                np.minimum(low[near], low[far, j], out=bottom)
                np.subtract(top, bottom, out=top)
                np.less_equal(top, np.where(self.there[far, j], width, -1), out=fits)
                np.add(reach, fits.view(np.int8), out=reach)
            self.extend(best, near, far, reach.astype(np.int64), width, low, high)
        return best

    def extend(self, best, near, far, reach, width, low, high):
        """Both ends beyond their samples: the far one up to an edge, the near one as far as the strip lets it."""
        take = lambda values, index: np.take_along_axis(values[far], index, 0)
        possible = self.there[near] & (high[near] - low[near] <= width)
        ends = reach >= self.last[far]
        beyond = np.minimum(reach + 1, self.last[far])
        lowest, highest = np.minimum(low[near], take(low, reach)), np.maximum(high[near], take(high, reach))
        e, far_e, s, far_s = take(self.e, reach), take(self.e, beyond), take(self.s, reach), take(self.s, beyond)
        below = far_e < lowest
        floor = np.where(ends, lowest, np.where(below, highest - width, lowest))
        edge = np.where(below, floor, floor + width)
        length = s + np.where(ends, 0, (edge - e) / np.where(ends, 1, far_e - e) * (far_s - s))
        here, next_e, next_s = self.e[near], np.roll(self.e[near], -1, 0), np.roll(self.s[near], -1, 0)
        more = (np.arange(len(here))[:, None] < self.last[near]) & (next_e != here)
        edge = np.clip(next_e, floor, floor + width)
        share = (edge - here) / np.where(more, next_e - here, 1)
        length += self.s[near] + np.where(more, share * (next_s - self.s[near]), 0)
        np.maximum(best, np.where(possible, length, 0).max(0), out=best)

    def drive(self, inside, beyond, share, length):
        """Over the usable stroke: least sine of the transmission angle, and how evenly the input drives."""
        at_end = lambda values: self.at(values, inside) + share * (self.at(values, beyond) - self.at(values, inside))
        within = np.arange(self.e.shape[1])[:, None] <= inside[:, None]
        end_sine, end_velocity = at_end(self.sine_square), at_end(self.velocity)
        sine = np.minimum(np.where(within, self.sine_square, np.inf).min((0, 1)), end_sine.min(0))
        slowest = np.minimum(np.where(within, self.velocity, np.inf).min((0, 1)), end_velocity.min(0))
        fastest = np.maximum(np.where(within, self.velocity, -np.inf).max((0, 1)), end_velocity.max(0))
        slowness = 1 / self.velocity
        steps = 0.5 * np.diff(self.s, axis=1) * (slowness[:, 1:] + slowness[:, :-1])
        sweep = np.where(within[:, 1:], steps, 0).sum((0, 1))
        way = self.at(self.s, beyond) - self.at(self.s, inside)
        sweep += (0.5 * share * way * (self.at(slowness, inside) + 1 / end_velocity)).sum(0)
        one_way = (slowest > 0) | (fastest < 0)
        return np.sqrt(sine), np.where(one_way, (fastest - slowest) * np.abs(sweep) / length, np.inf)


NUMBERS = ("usable_stroke", "usable_strip", "min_transmission_sine", "velocity_nonuniformity", "contact_coefficient")


def estimated(dump):
    """The numbers of all four-bars of the map."""
    linkages = Linkages(dump)
    found = {name: [] for name in NUMBERS}
    for begin in range(0, len(linkages.columns[0]), CELLS_PER_BLOCK):
        paths = Paths(linkages, slice(begin, begin + CELLS_PER_BLOCK))
        ways, inside, beyond, share = paths.usable()
        stroke = ways.sum(0)
        sine, nonuniformity = paths.drive(inside, beyond, share, stroke)
        numbers = (stroke, np.maximum(paths.strip(), stroke), sine, nonuniformity, np.abs(paths.coefficient))
        for name, values in zip(NUMBERS, numbers):
            found[name].append(values)
    return {name: np.concatenate(parts) for name, parts in found.items()}


def check(ours, theirs):
    """The same linkages, in the middle the same digits, and next to none that differ: or this raises."""
    for name in NUMBERS:
        wanted = np.array(theirs[name], float)
        if len(wanted) != len(ours[name]):
            raise SystemExit(f"{len(ours[name])} linkages, and the engine's {len(wanted)}")
        both = np.isfinite(wanted) & np.isfinite(ours[name])
        off = np.abs(ours[name] - wanted)[both] / np.maximum(np.abs(wanted[both]), 1e-12)
        strays = np.mean(off > 1e-6) + np.mean(np.isfinite(wanted) != np.isfinite(ours[name]))
        if not (np.median(off) < 1e-12 and strays < 0.01):
            raise SystemExit(f"{name}: off by {np.median(off):.1e} in the middle, {strays:.2%} stray")


def measure(dump, repetitions):
    """Nanoseconds a cell, by repetition; the numbers are the engine's, or this raises."""
    taken = []
    with np.errstate(all="ignore"):
        for _ in range(repetitions):
            begin = time.process_time()
            ours = estimated(dump)
            taken.append(1e9 * (time.process_time() - begin) / (2 * len(dump["first"]) * len(dump["second"])))
    check(ours, dump["estimates"])
    return taken


def main(path, repetitions="5"):
    with open(path, encoding="utf-8") as file:
        taken = measure(json.load(file), int(repetitions))
    print("ns a cell:", ", ".join(f"{ns:.0f}" for ns in taken))


if __name__ == "__main__":
    main(*sys.argv[1:])
