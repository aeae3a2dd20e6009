"""Tasks of every case of straight lines, and what a linkage found does, traced by circles alone."""

import math

LINE = {"point": [0, 40], "direction_deg": 5}
LEVEL = {"point": [0, 4], "direction_deg": 0}
TOUCHING = [{"s": 1, "multiplicity": 2}, {"s": 3, "multiplicity": 2}]


def line_task(case, line=LINE, **given):
    return {"kind": "straight_line", "mechanism": "four_bar", "case": case, "line": line} | given


TASKS = {
    "four_point_pivots": line_task("four_point_pivots", ground_pivots={"input": [0, 0], "output": [60, 0]}),
    "four_point_cubic": line_task("four_point_cubic", pole_distance=100, point_ray_deg=40, cubic_n=350),
    "ball_point_on_side_link": line_task("ball_point_on_side_link", input_pivot=[80, -60]),
    "isosceles_trapezoid": line_task("isosceles_trapezoid", half_frame=50),
    "pole_at_given_pivot": line_task("pole_at_fixed_pivot", {"point": [0, 0], "direction_deg": 80},
                                     ground_pivots={"input": [-60, 30], "output": [70, -20]}, output_arm=30),
    "pole_at_fixed_pivot": line_task("pole_at_fixed_pivot", pole_distance=100, output_arm=30),
    "pole_at_fixed_pivot_ball_point_on_frame": line_task("pole_at_fixed_pivot_ball_point_on_frame", pole_distance=100),
    "five_point": line_task("five_point", pole_distance=100, point_ray_deg=40),
    "five_point_inflection_pole": line_task("five_point_inflection_pole", pole_distance=100),
    "five_point_side_link_on_frame": line_task("five_point_side_link_on_frame", pole_distance=100),
    "six_point": line_task("six_point", pole_distance=-100),
    "parallel_side_links": line_task("parallel_side_links", input_offset=-10, output_offset=15),
    "mixed": line_task("mixed", LEVEL, input_pivot=[0, 0], contacts=TOUCHING),
    "mixed_at_an_angle": line_task("mixed", LEVEL, input_pivot=[0, 0], contacts=TOUCHING, coupler_angle_deg=40),
    "symmetric_lambda": line_task("symmetric_lambda", stroke=100),
    "symmetric_lambda_of_a_range": line_task("symmetric_lambda", stroke=100, crank_range_deg=150),
    "search": line_task("search", stroke=60, deviation=0.3),
}
WITHOUT_MAP = {"pole_at_given_pivot", "symmetric_lambda_of_a_range", "search"}
LEAST_CONTACT = {"five_point": 5, "five_point_inflection_pole": 5, "five_point_side_link_on_frame": 5, "six_point": 6,
                 "parallel_side_links": 5, "mixed": 2, "mixed_at_an_angle": 2, "symmetric_lambda": 2,
                 "symmetric_lambda_of_a_range": 2, "search": 1}


def problem_of(name, **options):
    return {"linkwright": 1, "task": TASKS[name],
            "options": {"region_samples": 12, "best": 3} | ({"effort": 5000} if name == "search" else {}) | options}


class Tracer:
    """A four-bar with a point, its joints found as meets of circles; as complex numbers on its line, s + i e."""

    def __init__(self, linkage, line):
        pivots = {name: complex(*at) for name, at in linkage["pivots"].items()}
        self.turn = complex(math.cos(math.radians(line["direction_deg"])), math.sin(math.radians(line["direction_deg"])))
        self.start = pivots["point"]
        for name, at in pivots.items():
            setattr(self, name, (at - self.start) / self.turn)

    def closed(self, moved, before):
        """The other joints with the input's pin there, on the branch of those before; None where it cannot be."""
        reach = abs(self.output_moving - self.input_moving)
        output = abs(self.output_moving - self.output_fixed)
        span = self.output_fixed - moved
        gap = abs(span)
        along = (reach ** 2 - output ** 2 + gap ** 2) / (2 * gap)
        square = reach ** 2 - along ** 2
        if square < 0:
            return None
        feet, aside = moved + span / gap * along, span / gap * 1j * math.sqrt(square)
        joint = min((feet + aside, feet - aside), key=lambda at: abs(at - before))
        return joint, moved + (joint - moved) * (self.point - self.input_moving) / (self.output_moving - self.input_moving)

    def path(self, sense, step, limit):
        """Points (s, e) from where it lies on, the input turning by `step` in that sense, until |s| passes the limit
        or the point turns back."""
        arm, joint = self.input_moving - self.input_fixed, self.output_moving
        points = [(0.0, 0.0)]
        for k in range(1, 200000):
            angle = sense * step * k
            found = self.closed(self.input_fixed + arm * complex(math.cos(angle), math.sin(angle)), joint)
            if found is None:
                return points
            joint, point = found
            if abs(point.real) < abs(points[-1][0]):
                return points
            points.append((point.real, point.imag))
            if abs(point.real) > limit:
                return points
        return points
