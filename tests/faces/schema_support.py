"""Walks through a schema and a problem side by side, and problems that have all that a schema bounds."""

import copy

from face_support import ROOT, load
from straight_support import TASKS

BOUNDS = {"minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum", "minItems", "maxItems", "minProperties", "maxProperties"}

# Parts of the schema that say what a place is not, or which positions count how often: tasks of all patterns are tried above.
NO_BOUNDS_OF_A_PLACE = ("_positions/", "/if/", "/not", "#/$defs/single", "#/$defs/double", "#/$defs/triple", "#/$defs/quadruple", "#/$defs/quintuple",
                        "#/$defs/zero", "#/$defs/near_path/")


def pointers_of_bounds(schema, pointer="#"):
    if isinstance(schema, dict):
        if BOUNDS & set(schema) and not isinstance(schema.get("minimum"), dict):
            yield pointer
        for key, part in schema.items():
            yield from pointers_of_bounds(part, f"{pointer}/{key}")
    elif isinstance(schema, list):
        for i, part in enumerate(schema):
            yield from pointers_of_bounds(part, f"{pointer}/{i}")


def applied(validator, instance):
    """Each part of the schema that a value has to keep: the value's path, the part's pointer, the part."""
    root = validator.schema
    is_valid = lambda part, value: validator.evolve(schema=part).is_valid(value)  # noqa: E731

    def walk(part, pointer, value, path):
        if not isinstance(part, dict):
            return
        yield path, pointer, part
        if "$ref" in part:
            name = part["$ref"].rsplit("/", 1)[1]
            yield from walk(root["$defs"][name], f"#/$defs/{name}", value, path)
        for key in ("allOf", "anyOf", "oneOf"):
            for i, choice in enumerate(part.get(key, [])):
                if is_valid(choice, value):
                    yield from walk(choice, f"{pointer}/{key}/{i}", value, path)
        if "if" in part:
            then = "then" if is_valid(part["if"], value) else "else"
            yield from walk(part.get(then), f"{pointer}/{then}", value, path)
        if isinstance(value, dict):
            for key, member in value.items():
                yield from walk(part.get("properties", {}).get(key), f"{pointer}/properties/{key}", member, (*path, key))
        if isinstance(value, list):
            first = part.get("prefixItems", [])
            for i, item in enumerate(value):
                if i < len(first):
                    yield from walk(first[i], f"{pointer}/prefixItems/{i}", item, (*path, i))
                else:
                    yield from walk(part.get("items"), f"{pointer}/items", item, (*path, i))

    yield from walk(root, "#", instance, ())


def changed_at(problem, path):
    for key in path:
        problem = problem[key]
    return problem


def around_bounds(problem, path, node):
    """The problem with the value at the path on each bound of the schema's node, and to either side of it."""
    value = changed_at(problem, path)
    values = []
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        step = 1 if node.get("type") == "integer" else 1e-6
        for key in ("minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"):
            if key in node:
                room = max(step, 1e-6 * abs(node[key])) if step != 1 else 1
                values += [node[key] - room, node[key], node[key] + room]
    elif isinstance(value, list):
        for key in ("minItems", "maxItems"):
            if key in node:
                values += [(value * (count + 1))[:count] for count in range(max(node[key] - 1, 0), node[key] + 2) if value]
    for changed_value in values:
        changed = copy.deepcopy(problem)
        *way, last = path
        changed_at(changed, way)[last] = changed_value
        yield changed


def start_of(input_center, input_circle, output_center, output_circle):
    """A linkage to begin a fit with."""
    return {"input": {"center_point": list(input_center), "circle_point": list(input_circle)},
            "output": {"center_point": list(output_center), "circle_point": list(output_circle)}}


def problems_with_everything():
    """Tasks of all kinds that between them have every bounded member of the schema."""
    quick = {"region_samples": 8, "best": 0}

    def task_of(example):
        return load(ROOT / f"examples/{example}.json")["task"]

    def problem(task, options=None, **members):
        return {"linkwright": 1, "task": task, "options": quick | (options or {})} | members

    box = {"x": [-1000, 1000], "y": [-1000, 1000]}
    cone = {"axis": [0, 0, 1], "half_angle_deg": 90}
    tailgate = task_of("tailgate")
    yield "motion", problem(tailgate, {"window": [[0, 1], [0.5, 1]], "seed": 1, "effort": 1}, requirements={
        "types": ["crank_rocker"], "min_transmission_angle_deg": 1, "max_link_ratio": 20, "max_length": 450, "min_length": 1,
        "ground_pivots_within": box, "moving_pivots_within": box})
    tolerances = {"length": 0.1, "clearance": 0.1, "driver_deg": 0.1, "turning_length": 10, "samples": 1000, "seed": 1,
                  "cost": {"exponent": 1}}
    yield "tolerances", problem(tailgate, tolerances=tolerances | {"limit": {"position": 1}},
                                requirements={"max_tolerance_error": 5, "min_yield": 0.5})
    stud = {"from": {"on": "ground", "at": [150, 115]}, "to": {"on": "body", "at": [60, 298]}}
    gas = {"kind": "gas", **stud, "extended_length": 325, "stroke": 128, "measured_at": 5, "F1": 375, "F2": 500}
    springs = [gas | {"name": "one", "count": 2, "F3": 425, "F4": 560, "rod_diameter": 8, "percent_per_10K": 4},
               gas | {"name": "other", "friction": 25},
               {"kind": "coil", **stud, "rate": 1, "free_length": 50, "acts": "tension"},
               {"kind": "torsion", "joint": "output_coupler", "rate_per_deg": 0.1, "torque_at_position_1": -3}]
    case = {"name": "cold", "temperature_C": -30, "slope_deg": 6, "extra": ["snow"], "spring_percent": 90,
            "gas_exponent": 1.2, "for": ["hold_open", "max_pin_force"]}
    loads = {"gravity": {"direction_deg": -80, "acceleration": 9.81}, "body": {"mass": 24, "center": [40, 120], "inertia": 1},
             "links": {"input": {"kg_per_m": 1.2}, "coupler": {"mass": 1, "center": [20, 3], "inertia": 0.1}, "output": {"mass": 1}},
             "extra": [{"name": "snow", "on": "body", "at": [70, 200], "mass": 6},
                       {"name": "tool", "on": "output", "at": [7, 2], "force": [6, 1], "frame": "body", "always": True}],
             "handle": {"point": [-5, -70], "direction": {"fixed_deg": 135}}, "springs": springs,
             "pins": {"radius": 6, "friction": 0.15}, "drive": "input", "rpm": 30, "cases": [case, {"name": "room"}], "stations": 13}
    yield "loads", problem(tailgate, length_unit="mm", loads=loads, requirements={
        "max_open_force": 60, "max_close_force": 90, "min_hold_open": -5, "max_pin_force": 2000, "max_torque": 50,
        "max_self_rise_deg": 40, "min_self_close_deg": 10})
    by_cylinder = {"handle": {"point": [-5, -70], "direction": "vertical"}, "drive": {"cylinder": stud}}
    yield "loads by a cylinder", problem(tailgate, length_unit="mm", loads=by_cylinder, requirements={"max_cylinder_force": 900})
    for motion in ({"law": "3-4-5", "duration_s": 2}, {"law": "trapezoid", "duration_s": 2, "ramp": 0.2},
                   {"table": [[0, 0], [1, 0.4], [2.5, 1]]}):
        yield "a motion", problem(tailgate, length_unit="mm", loads=by_cylinder | {"motion": motion})
    yield "a free strength", problem(tailgate, length_unit="mm", loads={"body": loads["body"], "handle": loads["handle"], "springs": [
        gas | {"best_F1": {"max_F1": 900, "min_F1": 100, "min_hold_open": 5}}]}, requirements={"max_best_F1": 800})
    yield "angles", problem(tailgate, tolerances=tolerances | {
        "length": {key: 0.1 for key in ("input", "coupler", "output", "ground_pivots", "point")}, "limit": {"angle_deg": 1}})
    yield "pareto", problem(tailgate, {"pareto": ["link_ratio", "size"], "best": 2})
    yield "place", problem(tailgate, {"at": [0.25, 0.75]})
    yield "sphere", problem(task_of("folding_wing"), tolerances={"link_angle_deg": 0.1, "samples": 1000, "limit": {"angle_deg": 1}},
                            requirements={"min_link_angle_deg": 5, "max_link_angle_deg": 85, "fixed_axes_within": cone,
                                          "moving_axes_within": cone})
    hood = task_of("hood_hinge")
    yield "mixed", problem(hood)
    poses = tailgate["poses"][:3]
    for given in ({"side_lengths": [180, 240]}, {"side_length": 180}, {"side_angle_deg": 30, "input_length": 180},
                  {"instant_center": [200, 0]}, {"ground_pivots": [[200, -200], [400, -200]]},
                  {"moving_pivots": [[50, -200], [100, -300]]},
                  {"ground_pivot_on": {"point": [0, -200], "direction_deg": 0}}):
        yield "three", problem({"kind": "motion", "mechanism": "four_bar", "poses": poses, "given": given, "pivot_on": []})
    line = {"which": "input", "pivot": "ground", "line": {"point": [0, -20], "direction_deg": 0}}
    yield "on a line", problem(tailgate | {"pivot_on": [line]})
    by_points = [{"points": points} for points in ([[0, 0], [5, 0]], [[4, 10], [8, 7]], [[34, 14], [34, 9]])]
    yield "by points", problem({"kind": "motion", "mechanism": "four_bar", "poses": by_points, "given": {"side_lengths": [18, 24]}})
    yield "freed", problem(task_of("five_hatch") | {"freed_pose": 2} if (ROOT / "examples/five_hatch.json").exists() else
                           {"kind": "motion", "mechanism": "four_bar", "freed_pose": 2, "poses": tailgate["poses"] + [
                               {"x": 900, "y": 300, "theta_deg": 95}]})
    rates = [{"input": 1, "output": 0.8}, {"input": 0, "output": 0.1}]
    pairs = [{"input_deg": 0, "output_deg": 0, "derivatives": rates}, {"input_deg": 50, "output_deg": 30}]
    yield "pairs", problem({"kind": "function", "mechanism": "four_bar", "pairs": pairs})
    dials = {"input_range_deg": [0, 60], "output_range_deg": [0, 90]}
    function = dials | {"table": [[0, 0], [1, 2], [2, 3], [4, 3.5]], "x": [0, 3], "y": [0, 3.5], "spacing": [0, 1, 2, 3]}
    yield "function", problem({"kind": "function", "mechanism": "four_bar", "function": function,
                               "free": {"number": "output_scale", "range": [0.5, 2]}})
    yield "free", problem({"kind": "function", "mechanism": "four_bar", "function": dials | {"expression": "x^2", "x": [0, 1]},
                           "free": {"number": "pair_output", "pair": 2, "range": [10, 20]}})
    yield "about a centre", problem({"kind": "function", "mechanism": "spherical_four_bar", "ground_angle_deg": 60,
                                     "function": dials | {"expression": "x^2", "x": [0, 1], "points": 4}})
    for name in ("thread_takeup_timed_mixed", "dough_mixer_five_points", "wiper_pivots_three_points", "walking_leg_pivots_five",
                 "feeder_three_poses_two_points", "tailgate_four_poses_one_point"):
        task = load(ROOT / f"data/path/{name}.json")["task"]
        if name.startswith("walking"):
            task["points"][0]["derivatives"] = []
        yield name, problem(task)
    timed = [{"x": x, "y": y, "input_deg": turn} for x, y, turn in ((0, 9.5, 0), (0.1, 3.2, 35), (0, -9.5, 105))]
    yield "path in a box", problem({"kind": "path", "mechanism": "four_bar", "points": [
        {"x": x, "y": y} for x, y in ((0, 0), (95, 40), (150, 140), (60, 230), (-70, 190))]},
        {"box": {"x": [-300, 400], "y": [-300, 400]}, "effort": 1, "seed": 1})
    near = [(0, 0), (95, 40), (150, 140), (60, 230), (-70, 190), (-90, 80)]
    yield "near points", problem({"kind": "path", "mechanism": "four_bar", "points": [{"x": x, "y": y} for x, y in near]})
    yield "near weighted points", problem(
        {"kind": "path", "mechanism": "four_bar", "closed": True, "tolerance": 3, "between": "free", "map": "pivots", "points": [
            {"x": x, "y": y, "weight": 1, "tolerance": 2, "derivatives": []} for x, y in near]},
        {"fit": {"effort": "quick", "measure": "least_squares", "grashof_margin": 0.003, "starts": [
            start_of((0, 0), (40, 10), (200, 20), (180, 90)) | {"point": [90, 120]}]}}, requirements={"max_path_error": 5})
    near_poses = [{"x": x, "y": y, "theta_deg": theta, "near": True, "weight": 1, "tolerance": {"position": 5, "angle_deg": 2}}
                  for x, y, theta in ((0, 0, 0), (-60, 25, -11), (-125, 75, -25), (-178, 145, -39), (-220, 220, -52), (-240, 300, -63))]
    yield "near poses", problem({"kind": "motion", "mechanism": "four_bar", "poses": near_poses, "turning_length": 200},
                                {"fit": {"effort": "quick", "measure": "least_squares", "starts": [
                                    start_of((120, 290), (160, 240), (140, 350), (110, 330)) | {
                                        "pose": {"x": 1, "y": 2, "theta_deg": 3}}]}},
                                requirements={"max_near_error": 50})
    yield "timed about a pivot", problem({"kind": "path", "mechanism": "four_bar", "points": timed,
                                          "given": {"ground_pivots": {"input": [40, 0]}}})
    chain = task_of("loader_bucket_chain")
    yield "chain", problem(chain | {"chain": chain["chain"] | {"elbow": [0, 0, 0, 0]}})
    turns = [{"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}, {"axis": [0, 1, 1], "angle_deg": 30}, {"quaternion": [1, 0.1, 0, 0]},
             {"rotation_vector": [0.1, 0.2, 0]}, {"euler_deg": [40, 50, 20], "sequence": "zyx"}]
    sphere = {"kind": "motion", "mechanism": "spherical_four_bar"}
    yield "turns", problem(sphere | {"orientations": turns[:4]})
    yield "turns", problem(sphere | {"orientations": turns[1:]})
    yield "axes", problem(sphere | {"orientations": turns[:3], "given": {"fixed_axes": [[0, 0, 2], [1, 0, 0]]}})
    yield "rates", problem(sphere | {"orientations": [turns[0] | {"angular_velocity": [0.3, 0.1, 0.2]}, turns[1], turns[3]]})
    for name, task in TASKS.items():
        given = {"min_stroke": 1, "max_deviation": 1}
        yield name, problem(task, {"stroke": 5, "deviation": 0.05, "effort": 1}, requirements=given)
    yield "line as made", problem(TASKS["four_point_pivots"], {"stroke": 5}, tolerances={
        "length": 0.1, "samples": 1000, "limit": {"deviation": 1}})
    yield "mixed contacts", problem(TASKS["mixed"] | {"contacts": [
        {"s": 0, "multiplicity": 1}, {"s": 1, "multiplicity": 2, "side": -1}, {"s": 2.5, "side": 1, "multiplicity": 1}],
        "coupler_angle_deg": 0})
    yield "cubic", problem(TASKS["four_point_cubic"] | {"cubic_n": 5})
    yield "search", problem({"kind": "motion", "mechanism": "six_bar", "poses": chain["poses"], "added": chain["added"]},
                            {"box": {"x": [0, 500], "y": [0, 500]}, "effort": 1, "seed": 1})


def paths(value, path=()):
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, member in items:
        yield (*path, key)
        yield from paths(member, (*path, key))


def apply(tree, path, change):
    *way, last = path
    for key in way:
        tree = tree[key]
    if change == "dropped":
        del tree[last]
    elif change == "renamed" and isinstance(tree, dict):
        tree[last + "_"] = tree.pop(last)
    else:
        tree[last] = change
