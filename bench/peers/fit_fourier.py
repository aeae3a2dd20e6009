#!/usr/bin/python3
"""Closed paths near points by Fourier descriptors: a peer of fit_curve().

The classical way (C. T. Zahn, R. Z. Roskies, 1972; F. P. Kuhl, C. R. Giardina, 1982; for linkages J. R. McGarva, 1994; I. Ullah,
S. Kota, 1997), written anew as well as we can: an atlas of curves that four-bars with a fully turning input trace, each by the
complex Fourier coefficients of its points at equal steps of its length, free of place, size, attitude and first point; the nearest
to the target's, laid on it by the best similarity, start least squares with exact derivatives, the angles of the crank at the
points being unknowns. What keeps a linkage usable acts inside, as in the engine: the input turns fully with a margin, links are no
longer than ten diagonals; points in order are asked of the outcome. Tells the least sum of squares after some times, the atlas
not counted, since it serves all targets.

usage: fit_fourier.py TARGET.json [SECONDS …]
"""

import json
import sys
import time

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

STEPS = 128  # of a curve
HARMONICS = np.concatenate([np.arange(1, 9), np.arange(-8, 0)])
EVEN = HARMONICS % 2 == 0
MARGIN, LONGEST = 0.003, 10  # of the diagonal: Grashof excess, links
SHAPES, POINTS_OF_EACH = 6000, 32


def couplers(ground, coupler, output, turns):
    """Unit vectors along couplers at angles of the input of length 1, ground along x, in the positive assembly."""
    across = ground - np.exp(1j * turns)
    length = np.abs(across)
    along = (length**2 + coupler**2 - output**2) / (2 * length * coupler)
    return across / length * (along + 1j * np.sqrt(np.maximum(1 - along**2, 0)))


def at_equal_steps(closed, count=STEPS):
    """Rows of points of closed polygons, anew at equal steps of their lengths; and where on the old ones, in steps."""
    ends = np.concatenate([closed, closed[:, :1]], axis=1)
    length = np.concatenate([np.zeros((len(ends), 1)), np.cumsum(np.abs(np.diff(ends)), axis=1)], axis=1)
    length /= length[:, -1:] * (1 + 1e-12)
    rows = np.arange(len(ends))[:, None]
    asked = np.arange(count) / count + rows  # all rows behind each other
    place = np.interp(asked.ravel(), (length + rows).ravel(), np.tile(np.arange(ends.shape[1]), len(ends))).reshape(asked.shape)
    low = np.minimum(place.astype(int), ends.shape[1] - 2)
    share = place - low
    points = np.take_along_axis(ends, low, 1) * (1 - share) + np.take_along_axis(ends, low + 1, 1) * share
    return points, low + share


def coefficients(points):
    return np.fft.fft(points, axis=1)[:, HARMONICS] / points.shape[1]


def normalised(c):
    """Rows of coefficients of one size, turned and begun such that those of the first two harmonics are real and positive."""
    first, last = np.angle(c[:, :1]), np.angle(c[:, -1:])
    turned = c * np.exp(1j * (-(first + last) / 2 + HARMONICS * (last - first) / 2))
    return turned / np.sqrt(np.sum(np.abs(turned) ** 2, axis=1, keepdims=True))


def as_reals(c):
    return np.concatenate([c.real, c.imag], axis=1).astype(np.float32)


class Atlas:
    """Curves of random cranks, linkages by (ground, coupler, output, point), the input of length 1."""

    def __init__(self, seed=1):
        random = np.random.default_rng(seed)
        lengths = np.exp(random.uniform(np.log(1 / 6), np.log(12), (40 * SHAPES, 3)))
        g, h, b = lengths.T
        turns_fully = (g + 1 < 0.995 * (h + b)) & (np.abs(h - b) < 0.995 * np.abs(g - 1))
        shapes = lengths[turns_fully][:SHAPES]
        place = np.sqrt(random.uniform(0, 1, (len(shapes), POINTS_OF_EACH)))
        place = np.where(np.arange(POINTS_OF_EACH) % 3 == 0, 4 * place, 1.5 * place)  # of the coupler, about its middle
        points = shapes[:, 1:2] * (0.5 + place * np.exp(2j * np.pi * random.uniform(0, 1, place.shape)))
        self.shapes, self.points = np.repeat(shapes, POINTS_OF_EACH, axis=0), points.ravel()
        blocks = [self.block(slice(k, k + 4096)) for k in range(0, len(self.points), 4096)]
        self.descriptors = np.concatenate(blocks)

    def curve(self, chosen):
        turns = 2 * np.pi * np.arange(STEPS) / STEPS
        g, h, b = (self.shapes[chosen].T)[:, :, None]
        return np.exp(1j * turns) + self.points[chosen][:, None] * couplers(g, h, b, turns)

    def block(self, chosen):
        return as_reals(normalised(coefficients(at_equal_steps(self.curve(chosen))[0])))

    def nearest(self, target_points, count):
        """Curves nearest to points at equal steps; each as (index, is mirrored, is reversed), nearest first."""
        found = []
        for mirrored in (False, True):
            for back in (False, True):
                points = np.conj(target_points) if mirrored else target_points
                c = normalised(coefficients((points[::-1] if back else points)[None]))
                for of in (c, np.where(EVEN, -c, c)):
                    distance = 1 - self.descriptors @ as_reals(of)[0]
                    best = np.argpartition(distance, count)[:count]
                    found += [(distance[k], k, mirrored, back) for k in best]
        kept = {}
        for distance, k, mirrored, back in sorted(found, key=lambda each: each[0]):
            kept.setdefault((k, mirrored, back), distance)
        return list(kept)[:count]


class Problem:
    """Least squares of one target: residuals and derivatives by A0, B0, a, h, b, p and the angles of the crank."""

    def __init__(self, points, longest, margin):
        self.points, self.count, self.longest, self.margin = points, len(points), longest, margin

    def state(self, x):
        a0, b0, p = x[0] + 1j * x[1], x[2] + 1j * x[3], x[7] + 1j * x[8]
        e = np.exp(1j * x[9:])
        across = b0 - a0 - x[4] * e
        length = np.abs(across)
        along = (length**2 + x[5] ** 2 - x[6] ** 2) / (2 * length * x[5])
        u = across / length * (along + 1j * np.sqrt(np.maximum(1 - along**2, 1e-12)))
        return a0, b0, p, e, u

    def limits(self, x):
        """By how much each limit is broken, and the derivatives by the nine numbers; hinges."""
        ground = x[2:4] - x[:2]
        g, a, h, b = np.hypot(*ground), x[4], x[5], x[6]
        by_g = np.concatenate([-ground, ground, np.zeros(5)]) / g
        by_a, by_h, by_b = np.eye(9)[4], np.eye(9)[5], np.eye(9)[6]
        side, tilt = np.sign(g - a), np.sign(h - b)
        rows = [(self.margin + g + a - h - b, by_g + by_a - by_h - by_b),
                (self.margin + abs(h - b) - abs(g - a), tilt * (by_h - by_b) - side * (by_g - by_a))]
        rows += [(length - self.longest, by) for length, by in ((g, by_g), (a, by_a), (h, by_h), (b, by_b))]
        weights = (30, 30, 1, 1, 1, 1)
        return [(w * value, w * by) if value > 0 else (0.0, np.zeros(9)) for w, (value, by) in zip(weights, rows)]

    def residuals(self, x):
        a0, _, p, e, u = self.state(x)
        off = a0 + x[4] * e + p * u - self.points
        return np.concatenate([off.real, off.imag, [value for value, _ in self.limits(x)]])

    def jacobian(self, x):
        a0, b0, p, e, u = self.state(x)
        across = a0 + x[4] * e + x[5] * u - b0  # the output link
        dot = lambda v: (np.conj(across) * v).real
        lever = dot(1j * x[5] * u)
        lever = np.where(np.abs(lever) < 1e-9, 1e-9, lever)
        one = np.ones(self.count, dtype=complex)
        none = np.zeros(self.count)
        moves = [one, 1j * one, none, none, e, none, none, u, 1j * u, 1j * x[4] * e]  # of the point, u at rest
        turns = [-dot(one), -dot(1j * one), dot(one), dot(1j * one), -dot(e), -dot(u), x[6] * one.real, none, none, -dot(1j * x[4] * e)]
        columns = [move + 1j * p * u * turn / lever for move, turn in zip(moves, turns)]
        j = np.zeros((2 * self.count + 6, 9 + self.count))
        for k in range(9):
            j[:self.count, k], j[self.count:2 * self.count, k] = columns[k].real, columns[k].imag
        each = np.arange(self.count)
        j[each, 9 + each], j[self.count + each, 9 + each] = columns[9].real, columns[9].imag
        j[2 * self.count:, :9] = [by for _, by in self.limits(x)]
        return j

    def improved(self, x, evaluations):
        found = least_squares(self.residuals, x, jac=self.jacobian, method="lm", max_nfev=evaluations, xtol=1e-12, ftol=1e-12,
                              gtol=1e-14)
        return found.x, 2 * found.cost

    def is_usable(self, x, cost):
        """The limits are kept, and the crank passes the points in order, within one turn; back by less than the error is noise."""
        if x[4] <= 0 or x[5] <= 0 or x[6] <= 0 or max(value for value, _ in self.limits(x)) > 1e-4 * self.longest:
            return False
        steps = np.angle(np.exp(1j * np.diff(np.append(x[9:], x[9]))))
        steps *= np.sign(np.sum(np.sign(steps)))
        a0, _, p, e, u = self.state(x)
        at = a0 + x[4] * e + p * u
        travel = np.abs(np.diff(np.append(at, at[0])))
        in_order = np.all((steps > -1e-9) | (travel <= np.sqrt(cost / self.count)))
        return bool(in_order) and abs(np.sum(steps) - 2 * np.pi) < 1e-6


def laid_on(atlas, candidate, dense, places):
    """The linkage of a candidate, by the similarity and the first point that lay its curve best on the target's dense points; with
    the angles of the crank at `places`, shares of the target's length."""
    k, mirrored, back = candidate
    want = np.conj(dense) if mirrored else dense
    want = want[::-1] if back else want
    curve, steps = at_equal_steps(atlas.curve(np.array([k])))
    curve, steps = curve[0], steps[0]
    middle, centre = want.mean(), curve.mean()
    correlation = np.fft.ifft(np.fft.fft(want - middle) * np.conj(np.fft.fft(curve - centre)))
    shift = int(np.argmax(np.abs(correlation)))
    turn = correlation[shift] / np.sum(np.abs(curve - centre) ** 2)
    where = (-places if back else places) * STEPS - (1 if back else 0) - shift
    low = np.floor(where).astype(int)
    share, low, cranks = where - low, low % STEPS, np.append(np.exp(2j * np.pi * steps / STEPS), 1)
    angles = np.angle(cranks[low] * (1 - share) + cranks[low + 1] * share)
    (g, h, b), p, size = atlas.shapes[k], atlas.points[k], np.abs(turn)
    a0 = middle - turn * centre
    b0, point, angles = a0 + g * turn, size * p, angles + np.angle(turn)
    x = np.concatenate([[a0.real, a0.imag, b0.real, b0.imag, size, size * h, size * b, point.real, point.imag], angles])
    return mirrored, x


class Search:
    """Candidates in the order of their descriptors, in lots: all for some steps, the best of each lot to the end."""

    FIRST, LOT, KEPT, MOST = 16, 64, 5, 36  # curves of the first lot, of later ones; one in so many goes on; points in these steps

    def __init__(self, atlas, points, longest=None):
        middle = points.mean()
        self.size = np.sqrt(np.mean(np.abs(points - middle) ** 2))
        scaled = (points - middle) / self.size
        diagonal = np.hypot(np.ptp(scaled.real), np.ptp(scaled.imag))
        chosen = np.unique(np.linspace(0, len(points), min(self.MOST, len(points)), endpoint=False).astype(int))
        self.atlas, self.chosen, self.scaled = atlas, chosen, scaled
        longest = longest / self.size if longest else LONGEST * diagonal
        self.problems = {}
        for mirrored in (False, True):
            of = np.conj(scaled) if mirrored else scaled
            self.problems[mirrored] = tuple(Problem(points, longest, MARGIN * diagonal) for points in (of[chosen], of))

    def dense_targets(self):
        """The target's curve at equal steps, as the polygon and as a smooth line through the points; and where its points are."""
        ends = np.append(self.scaled, self.scaled[0])
        chords = np.concatenate([[0], np.cumsum(np.abs(np.diff(ends)))])
        spline = CubicSpline(chords, np.stack([ends.real, ends.imag], 1), bc_type="periodic")
        fine = spline(np.linspace(0, chords[-1], 2048, endpoint=False))
        smooth = (fine[:, 0] + 1j * fine[:, 1])[None]
        lengths = np.append(0, np.cumsum(np.abs(np.diff(np.append(smooth[0], smooth[0, 0])))))
        at = np.interp(chords[:-1], np.linspace(0, chords[-1], 2049), lengths / lengths[-1])
        return [(at_equal_steps(self.scaled[None])[0][0], chords[:-1] / chords[-1]), (at_equal_steps(smooth)[0][0], at)]

    def candidates(self):
        """Of both of the target's curves in turn, each with the curve that it was found by."""
        found = [[(each, dense, at) for each in self.atlas.nearest(dense, 4000)] for dense, at in self.dense_targets()]
        return [each for both in zip(*found) for each in both]

    def run(self, times):
        """Least sums of squares after the times, seconds of the processor, of usable linkages; and how many were begun."""
        begin, best, begun, told = time.process_time(), np.inf, 0, []

        def tell():
            taken = time.process_time() - begin
            told.extend([best] * sum(taken > each for each in times[len(told):]))
            return len(told) == len(times)

        candidates, size = self.candidates(), self.FIRST
        while candidates:
            lot, candidates, starts = candidates[:size], candidates[size:], []
            size = min(2 * size, self.LOT)
            for candidate, dense, at in lot:
                mirrored, x = laid_on(self.atlas, candidate, dense, at[self.chosen])
                starts.append((*self.problems[mirrored][0].improved(x, 12), mirrored))
                begun += 1
                if tell():
                    break
            for x, _, mirrored in sorted(starts, key=lambda start: start[1])[:1 + len(starts) // self.KEPT]:
                if tell():
                    break
                best = min(best, self.finished(x, mirrored))
            if tell():
                break
        told += [best] * (len(times) - len(told))
        return [cost * self.size**2 for cost in told], begun

    def finished(self, x, mirrored):
        coarse, full = self.problems[mirrored]
        x, cost = coarse.improved(x, 150)
        if len(full.points) > len(coarse.points):
            count = len(full.points)
            angles = np.interp(np.arange(count), np.append(self.chosen, count), np.unwrap(np.append(x[9:], x[9])))
            x, cost = full.improved(np.concatenate([x[:9], angles]), 60)
        return cost if full.is_usable(x, cost) else np.inf


def measure(atlas, path, times, longest=None):
    points = np.array([complex(*point) for point in json.load(open(path, encoding="utf-8"))["points"]])
    return Search(atlas, points, longest).run(times)


if __name__ == "__main__":
    print(*measure(Atlas(), sys.argv[1], [float(each) for each in sys.argv[2:]] or [1.0, 10.0]))
