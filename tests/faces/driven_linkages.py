"""Linkages as the examples' tests measure and drive them: from their pivots alone, link by link."""

import cmath
import math

STEPS = 2000  # of a drive; the transmission angle is smooth, so the sampled least is off by far less than 0.01 degrees


def point(pair):
    return complex(*pair)


def cross(u, v):
    return (u.conjugate() * v).imag


class FourBar:
    """Pivots in position 1, and what follows from them."""

    def __init__(self, linkage):
        self.input_center, self.input_circle = (point(linkage["input"][end]) for end in ("center_point", "circle_point"))
        self.output_center, self.output_circle = (point(linkage["output"][end]) for end in ("center_point", "circle_point"))
        self.ground = abs(self.output_center - self.input_center)
        self.input = abs(self.input_circle - self.input_center)
        self.coupler = abs(self.output_circle - self.input_circle)
        self.output = abs(self.output_circle - self.output_center)

    def lengths(self):
        return {"ground": self.ground, "input": self.input, "coupler": self.coupler, "output": self.output}

    def driven_to(self, turned, near):
        """Moving pivots with the input turned by that angle (radians), the output's nearer to `near`; None if it cannot be."""
        moved = self.input_center + (self.input_circle - self.input_center) * cmath.rect(1, turned)
        diagonal = self.output_center - moved
        along = (self.coupler**2 - self.output**2 + abs(diagonal) ** 2) / (2 * abs(diagonal))
        height = self.coupler**2 - along**2
        if height < 0:
            return None
        direction = diagonal / abs(diagonal)
        sides = [moved + direction * complex(along, sign * math.sqrt(height)) for sign in (1, -1)]
        return moved, min(sides, key=lambda joint: abs(joint - near))

    def transmission_angle(self, moved, joint):
        """Degrees between coupler and output link, the acute one."""
        between = abs(math.degrees(cmath.phase((moved - joint) / (self.output_center - joint))))
        return min(between, 180 - between)


class Pose:
    def __init__(self, written):
        self.origin, self.angle = complex(written["x"], written["y"]), math.radians(written["theta_deg"])
        self.direction = next(iter(written.get("derivatives", ())), None)

    def carries(self, where, first):
        """Where the point of the body lies that lies at `where` in the first pose."""
        return self.origin + cmath.rect(1, self.angle - first.angle) * (where - first.origin)


def input_turns(bars, poses, sense):
    """Angles by which the input has turned from the first pose to each, turning that way (+1 or -1) less than once."""
    arm = bars.input_circle - bars.input_center
    turned = []
    for pose in poses:
        angle = cmath.phase((pose.carries(bars.input_circle, poses[0]) - bars.input_center) / arm)
        turned.append(angle % (sense * math.tau) if pose is not poses[0] else 0.0)
    return turned


def drive(bars, poses, sense):
    """Drives in small steps through the poses; (least transmission angle in degrees, worst miss of a pose), or None."""
    stops = input_turns(bars, poses, sense)
    if any(sense * later <= sense * sooner for sooner, later in zip(stops, stops[1:])):
        return None
    ticks = {stops[-1] * i / STEPS for i in range(STEPS + 1)} | set(stops)
    joint, least, miss = bars.output_circle, 90.0, 0.0
    for turned in sorted(ticks, key=abs):
        state = bars.driven_to(turned, joint)
        if state is None:
            return None
        moved, joint = state
        least = min(least, bars.transmission_angle(moved, joint))
        if turned in stops:
            pose = poses[stops.index(turned)]
            miss = max(miss, abs(moved - pose.carries(bars.input_circle, poses[0])),
                       abs(joint - pose.carries(bars.output_circle, poses[0])))
    return least, miss


class SixBar:
    """A chain a, b, d of bodies 1, 2 and 3, and two links between bodies 0 to 3; driven by body 1."""

    def __init__(self, linkage):
        self.a, self.b, self.d = (point(linkage["chain"][key]) for key in "abd")
        self.elbow = linkage["chain"]["elbow"]
        self.added = [(*map(int, link["between"].split("-")), *map(point, link["points"])) for link in linkage["added"]]

    def moved(self, body, where, turned, turns):
        """Where a point of a body lies, the driver turned by that angle, bodies 2 and 3 by these unit numbers."""
        b = self.a + cmath.rect(1, turned) * (self.b - self.a)
        d = b + turns[0] * (self.d - self.b)
        return (where, self.a + cmath.rect(1, turned) * (where - self.a), b + turns[0] * (where - self.b),
                d + turns[1] * (where - self.d))[body]

    def stretch(self, turned, turns):
        """By how much of itself each added link would have to be longer."""
        return [abs(self.moved(k, z, turned, turns) - self.moved(x, c, turned, turns)) / abs(z - c) - 1
                for x, k, c, z in self.added]

    def at(self, pose, first, elbow):
        """Angle of the driver and turns of bodies 2 and 3 in a pose."""
        d = pose.carries(self.d, first)
        arm, link, span = abs(self.b - self.a), abs(self.d - self.b), abs(d - self.a)
        along = (arm**2 - link**2 + span**2) / (2 * span)
        b = self.a + (d - self.a) / span * complex(along, elbow * math.sqrt(arm**2 - along**2))
        return (cmath.phase((b - self.a) / (self.b - self.a)), ((d - b) / (self.d - self.b), cmath.rect(1, pose.angle - first.angle)))

    def driven_to(self, turned, near):
        """Turns of bodies 2 and 3 that keep the added links' lengths, by Newton's method."""
        angles = [cmath.phase(turn) for turn in near]
        for _ in range(4):
            at = [cmath.rect(1, angle) for angle in angles]
            wrong = self.stretch(turned, at)
            step = 1e-7
            slopes = [self.stretch(turned, [at[0] * cmath.rect(1, step * (k == 0)), at[1] * cmath.rect(1, step * (k == 1))])
                      for k in (0, 1)]
            (m00, m10), (m01, m11) = ([(s - w) / step for s, w in zip(slope, wrong)] for slope in slopes)
            whole = m00 * m11 - m01 * m10
            angles[0] -= (m11 * wrong[0] - m01 * wrong[1]) / whole
            angles[1] -= (m00 * wrong[1] - m10 * wrong[0]) / whole
        return tuple(cmath.rect(1, angle) for angle in angles)


class Surroundings:
    """The body's outline in the first pose (fixed frame) and the rectangles (x, x, y, y) that it must not touch."""

    def __init__(self, outline, *obstacles):
        edges = zip(outline, outline[1:] + outline[:1])
        self.outline = [complex(*a) + (complex(*b) - complex(*a)) * i / 24 for a, b in edges for i in range(24)]
        self.obstacles = obstacles

    def deepest(self, bars, moved, joint):
        """How deep the body reaches into an obstacle, with its two pivots there."""
        turned = (joint - moved) / (bars.output_circle - bars.input_circle)
        body = [moved + turned * (corner - bars.input_circle) for corner in self.outline]
        return max(min(p.real - left, right - p.real, p.imag - low, high - p.imag)
                   for p in body for left, right, low, high in self.obstacles)


def dot3(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross3(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned_by(quaternion, vector):
    w, axis = quaternion[0], quaternion[1:]
    twice = [2 * x for x in cross3(axis, vector)]
    return [v + w * t + c for v, t, c in zip(vector, twice, cross3(axis, twice))]


class SphericalFourBar:
    """Axes in position 1, and what follows from them."""

    def __init__(self, linkage):
        self.input_fixed, self.input_moving = (linkage["input"][end] for end in ("fixed_axis", "moving_axis"))
        self.output_fixed, self.output_moving = (linkage["output"][end] for end in ("fixed_axis", "moving_axis"))

    def carried(self, first, there, axis=None):
        """Where the output's moving axis lies, or another, when the coupler has come from the first orientation to one."""
        inverse = [first[0], *(-x for x in first[1:])]
        return turned_by(there, turned_by(inverse, axis or self.output_moving))

    def input_turn(self, first, there):
        """By which angle the input has turned about its fixed axis."""
        after = self.carried(first, there, self.input_moving)
        before, axis = self.input_moving, self.input_fixed
        sine = dot3(axis, cross3(before, after))
        return math.atan2(sine, dot3(before, after) - dot3(axis, before) * dot3(axis, after))

    def driven_to(self, turned, near):
        """Moving axes with the input turned by that angle (radians), the output's nearer to `near`."""
        moved = turned_by([math.cos(turned / 2), *(math.sin(turned / 2) * x for x in self.input_fixed)], self.input_moving)
        a, b = moved, self.output_fixed
        to_a, to_b, between = dot3(self.input_moving, self.output_moving), dot3(b, self.output_moving), dot3(a, b)
        share = 1 - between**2
        along = [((to_a - to_b * between) * x + (to_b - to_a * between) * y) / share for x, y in zip(a, b)]
        height = math.sqrt(max(0, 1 - dot3(along, along)) / share)
        sides = [[x + sign * height * y for x, y in zip(along, cross3(a, b))] for sign in (1, -1)]
        return moved, min(sides, key=lambda joint: math.dist(joint, near))

    def transmission_angle(self, moved, joint):
        """Degrees between the planes of coupler and output link, the acute one."""
        one, other = cross3(joint, moved), cross3(joint, self.output_fixed)
        angle = math.degrees(math.atan2(math.hypot(*cross3(one, other)), dot3(one, other)))
        return min(angle, 180 - angle)
