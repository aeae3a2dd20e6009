"""The published schemas agree with what the program reads and writes."""

import copy
import json
import unittest

from face_support import ROOT, TAILGATE, FaceTest, load, run, without_comments
from schema_support import (
    BOUNDS, NO_BOUNDS_OF_A_PLACE, applied, apply, around_bounds, changed_at, paths, pointers_of_bounds, problems_with_everything)
from straight_support import TASKS, problem_of

try:
    import jsonschema
except ImportError:
    jsonschema = None

# Files that no schema can refuse: what is wrong is no matter of structure.
BEYOND_SCHEMA = {"repeated_pose", "repeated_pose_a_turn_later", "transmission_angle_with_defects", "box_upside_down",
                 "window_reversed", "repeated_pose_with_direction",
                 "repeated_input", "constant_output", "equal_ground_pivots", "free_scale_turned_round",
                 "constant_function", "log_that_touches_zero", "root_of_negative_numbers", "range_turned_round",
                 "range_outside_of_table", "dial_of_two_turns", "table_out_of_order", "spacing_of_other_count",
                 "spacing_out_of_order", "spacing_outside_of_range",
                 "chain_that_cannot_reach", "chain_with_no_first_link", "chain_without_elbow", "elbow_other_than_drawn",
                 "search_box_of_nothing", "path_in_a_box_of_nothing", "requirements_of_the_sphere", "spherical_function_link_ratio",
                 "spherical_function_same_input", "spherical_function_standing_output", "objective_of_the_sphere", "place_of_a_search",
                 "lengths_on_a_sphere", "boxes_on_a_sphere", "planar_type_on_a_sphere", "planar_objective_on_a_sphere",
                 "axis_of_zeros", "cone_about_nothing", "given_axis_of_zeros", "given_axes_the_same", "quaternion_of_zeros",
                 "given_pivots_at_one_place", "points_at_one_place",
                 "velocity_zero", "link_angles_crossed", "matrix_that_mirrors", "matrix_that_stretches",
                 "line_pivots_coincide", "line_ball_pivot_at_point", "line_pole_on_line",
                 "line_parallel_offsets_equal", "line_mixed_of_three_points", "line_mixed_of_five_points",
                 "line_mixed_out_of_order", "line_mixed_at_one_place", "line_search_deviation_wide",
                 "line_option_objective_link_ratio", "line_requirement_no_defects", "line_requirement_min_length",
                 "line_requirement_of_the_sphere", "line_requirement_type_of_the_sphere", "line_options_of_lines_in_a_motion",
                 "line_objective_of_lines_in_a_motion", "line_requirement_of_lines_in_a_motion",
                 "line_deviation_of_lines_in_a_motion", "line_measure_of_lines_in_a_motion",
                 "path_equal_angles", "path_equal_angles_a_turn_apart", "path_closed_by_its_first_point", "path_repeated_point",
                 "path_of_more_than_a_turn", "path_that_turns_back", "path_crank_against_its_sense",
                 "path_requirement_of_a_motion",
                 "path_of_one_pose_and_four_points", "path_of_two_poses_and_three_points", "path_pivot_at_a_point",
                 "path_pivot_of_output_at_a_point", "path_pivots_at_one_place", "path_point_again_at_once",
                 "path_point_three_times", "path_point_twice_between_pivots", "path_rest_at_a_plain_point",
                 "path_some_angles_equal", "path_some_angles_more_than_a_turn", "path_some_angles_turn_back",
                 "path_some_crank_against_its_sense", "path_with_a_pose_twice",
                 "loads_case_extra_unknown", "loads_case_twice", "loads_coil_studs_meet",
                 "loads_drive_cylinder_on_itself", "loads_extra_on_ground", "loads_extra_twice",
                 "loads_gas_compressing", "loads_gas_compressing_alone", "loads_gas_forces",
                 "loads_gas_friction_twice", "loads_gas_measured_at", "loads_gas_measured_at_without_unit",
                 "loads_gas_stroke", "loads_gas_too_long", "loads_gas_too_short", "loads_hand_without_handle",
                 "loads_handle_vertical_in_space", "loads_link_density_without_unit", "loads_no_case_counts",
                 "loads_no_handle", "loads_objective_without_loads", "loads_of_function",
                 "loads_required_without_loads", "loads_rpm_without_unit", "loads_spring_on_itself",
                 "loads_spring_twice", "loads_torque_by_hand", "loads_cylinder_by_hand", "loads_F1_without_free_spring",
                 "loads_motion_and_rpm", "loads_motion_ends", "loads_motion_order", "loads_motion_turns_back",
                 "loads_motion_without_unit", "loads_free_upside_down", "loads_free_without_case",
                 "loads_free_without_hand", "loads_two_free_springs", "fit_of_exact_path", "near_path_of_one_place",
                 "near_path_of_two_places", "near_path_without_weight", "path_error_of_motion", "near_path_pivot_at_a_point", "near_path_pivots_at_one_place",
                 "near_beside_six_exact", "near_error_without_near", "near_fit_of_region", "near_fitted_with_derivatives",
                 "near_fitted_with_margin", "near_fitted_with_pivot_on", "near_repeated_exact", "near_two_different_poses",
                 "near_weights_zero", "near_path_start_without_point", "near_fitted_start_with_point", "near_path_start_with_pose",
                 "timed_path_that_turns_back", "timed_path_with_equal_angles", "timed_path_of_more_than_a_turn", "timed_path_closed_by_its_first_point",
                 "timed_path_of_one_place", "timed_path_without_weight"}

# Words of refusals that no schema can give: what is wrong is no matter of structure.
BEYOND_STRUCTURE = ("same", "above the upper", "max_length", "at infinity", "in which the body moves", "the lower number first",
                    "does not change", "no value", "precision points", "lies outside of", "whole turn", "low below high",
                    "at one place", "sort them", "is empty", "cannot reach", "on one line", "coincide", "the elbow is",
                    "are given and four or five are needed", "add up to", "by rising s", "a tenth of the stroke",
                    "lies on the line", "is where the coupler point is", "above the largest", "keep x within", "are the most that",
                    "turn back after", "against the sense", "and four with one", "is there already", "in position", "half of the stroke",
                    "shorter than the extended", "at least F1", "is not within 0 to",
                    "share 1 at its end", "ascend from point to point")


def validator(name):
    """Of schema/NAME.schema.json, which may refer to that of problems."""
    problem, schema = (load(ROOT / f"schema/{one}.schema.json") for one in ("problem", name))
    resolver = jsonschema.RefResolver.from_schema(schema, store={problem["$id"]: problem})
    return jsonschema.Draft202012Validator(schema, resolver=resolver)


def schemas():
    return validator("problem"), validator("result")


@unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
class Schemas(FaceTest):
    @classmethod
    def setUpClass(cls):
        cls.problem, cls.result = schemas()

    def test_are_schemas(self):
        for name in ("problem", "result", "analysis", "sweep", "spring_boxes", "spring_catalogue"):
            schema = load(ROOT / f"schema/{name}.schema.json")
            jsonschema.Draft202012Validator.check_schema(schema)

    def test_examples_are_problems(self):
        examples = sorted((ROOT / "examples").glob("*.json"))
        self.assertTrue(examples)
        for path in examples:
            with self.subTest(path.name):
                self.problem.validate(load(path))

    def test_files_of_springs_are_what_their_schemas_say(self):
        files = {"spring_boxes": [ROOT / "examples/springs/tailgate_boxes.json", ROOT / "docs/tutorials/winter_boxes.json"],
                 "spring_catalogue": [ROOT / "examples/springs/catalogue.json"]}
        for name, paths in files.items():
            for path in paths:
                with self.subTest(path.name):
                    validator(name).validate(load(path))

    def test_files_of_springs_are_refused_alike(self):
        result = self.folder / "struts.json"
        self.assertEqual(run("solve", ROOT / "examples/tailgate_struts.json", "--samples", 40, "-o", result)[0], 0)
        boxes, catalogue = (load(ROOT / f"examples/springs/{name}.json") for name in ("tailgate_boxes", "catalogue"))
        part = catalogue["springs"][0]
        wrong = {
            "spring_boxes": [{**boxes, "linkwright": 2}, {**boxes, "ground": {"x": [1, 2]}}, {**boxes, "spring": {"kind": "coil"}},
                             {**boxes, "max_F1": -1}, {**boxes, "box": {}}, {**boxes, "body": {"x": [1], "y": [1, 2]}},
                             {key: value for key, value in boxes.items() if key != "spring"}],
            "spring_catalogue": [{**catalogue, "linkwright_catalogue": 2}, {**catalogue, "kind": "coils"},
                                 {**catalogue, "springs": [{**part, "F1": []}]}, {**catalogue, "springs": [{**part, "F1": 300}]},
                                 {**catalogue, "springs": [{**part, "stroke": 0}]}, {**catalogue, "springs": [{**part, "colour": "red"}]},
                                 {**catalogue, "springs": [{**part, "F1": {"from": 200}}]}]}
        good = self.write("boxes.json", json.dumps(boxes))
        for name, documents in wrong.items():
            for number, document in enumerate(documents):
                path = self.write(f"{name}_{number}.json", json.dumps(document))
                words = ["--place-springs", path] if name == "spring_boxes" else ["--place-springs", good, "--catalogue", path]
                with self.subTest(path.name):
                    self.assertFalse(validator(name).is_valid(document))
                    self.assertEqual(run("loads", result, *words)[0], 2)

    def test_results_are_results(self):
        for arguments in ((), ("--region",)):
            result = load(self.solve_tailgate(*arguments))
            self.result.validate(result)
            self.problem.validate(result["problem"])

    def test_results_of_mixed_positions_are_results(self):
        pose, way = {"x": 1, "y": 2, "theta_deg": 30}, {"x": 1, "y": 0, "theta": 0.5}
        bent, on = {"x": 0.6, "y": 1, "theta": 0.2}, {"x": 0, "y": 1.2, "theta": -0.3}
        second, third = {"x": 4, "y": 3, "theta_deg": 70}, {"x": 5, "y": 6, "theta_deg": 100}
        for poses in ([pose | {"derivatives": [way]}, second | {"derivatives": []}, third],
                      [pose, second | {"derivatives": [way]}, third], [pose, second, third | {"derivatives": [way]}],
                      [pose | {"derivatives": [way]}, second | {"derivatives": [way]}],
                      [pose | {"derivatives": [way, bent]}, second], [pose, second | {"derivatives": [way, bent]}],
                      [pose | {"derivatives": [way, bent, on]}]):
            task = {"kind": "motion", "mechanism": "four_bar", "poses": poses}
            problem = {"linkwright": 1, "task": task, "requirements": {"no_defects": False}}
            with self.subTest(poses=poses):
                self.problem.validate(problem)
                ran = run("solve", self.write("problem.json", problem), "--samples", 40, "-o", "-", "--region")
                self.assertEqual((ran[0], ran[2]), (0, ""))
                result = json.loads(ran[1])
                self.result.validate(result)
                self.problem.validate(result["problem"])
                self.assertTrue(result["linkages"])
                self.assertTrue(all("residual_derivatives" in linkage for linkage in result["linkages"]))

    def test_results_of_straight_lines_are_results(self):
        for name in TASKS:
            for options, requirements in (({"at": [10, 20]}, {}), ({}, {"min_stroke": 1e6, "max_deviation": 1})):
                problem = problem_of(name, stroke=5, deviation=0.05, measure="strip", best=1, region_samples=8, **options)
                if name == "search":
                    problem["options"].pop("at", None)
                problem["requirements"] = requirements
                with self.subTest(name, options=options, requirements=requirements):
                    self.problem.validate(problem)
                    ran = run("solve", self.write("problem.json", problem), "-o", "-", "--region")
                    self.assertEqual((ran[0], ran[2]), (0, ""))
                    result = json.loads(ran[1])
                    self.result.validate(result)
                    self.problem.validate(result["problem"])

    def test_results_without_answer_are_results(self):
        tailgate = load(TAILGATE)
        nothing = copy.deepcopy(tailgate)
        nothing["requirements"]["max_length"] = 1
        shifts = copy.deepcopy(tailgate)
        for pose in shifts["task"]["poses"]:
            pose["theta_deg"] = 0
        with_defects = copy.deepcopy(tailgate)
        with_defects["requirements"] = {"no_defects": False, "max_link_ratio": None, "max_length": None}
        symmetric = copy.deepcopy(tailgate)
        symmetric["task"]["poses"] = [{"x": x, "y": y, "theta_deg": theta}
                                      for x, y, theta in ((-2, 0, 30), (-1, 1, 10), (1, 1, -10), (2, 0, -30))]
        for problem in (nothing, shifts, with_defects, symmetric):
            status, output, _ = run("solve", self.write("problem.json", problem), "--samples", 40, "-o", "-", "--region")
            self.assertEqual(status, 0)
            self.result.validate(json.loads(output))

    def check_analysis(self, linkage, *flags):
        ran = run("analyze", linkage, *flags, "-o", "-")
        self.assertEqual((ran[0], ran[2]), (0, ""))
        validator("analysis").validate(json.loads(ran[1]))
        return json.loads(ran[1])

    def test_analyses_of_linkages_found_are_analyses(self):
        result, linkage = self.folder / "result.json", self.folder / "linkage.json"
        for name in ("tailgate", "hood_hinge", "flow_meter", "loader_bucket_chain", "wrist_orthosis", "straight_stage"):
            with self.subTest(name):
                self.assertEqual(run("solve", ROOT / f"examples/{name}.json", "--samples", 40, "-o", result)[0], 0)
                self.assertEqual(run("export", result, "--format", "json", "-o", linkage)[0], 0)
                analysis = self.check_analysis(linkage)
                self.assertEqual("position_errors" in analysis, not name.startswith("straight"))
                if "mechanism" not in analysis:
                    self.check_analysis(linkage, "--instant")

    def test_analyses_of_bare_linkages_are_analyses(self):
        names = ("ground", "input", "coupler", "output")
        lengths = ((4, 1, 3, 3.5), (4, 5, 3, 3), (1, 3, 3, 4), (4, 2, 4, 2), (4, 3, 2, 1), (2, 2, 2, 2), (5, 3, 1, 4))
        angles = ((80, 30, 70, 75), (80, 70, 30, 45), (100, 110, 120, 95), (40, 60, 50, 55))
        for key, values in ([("lengths", each) for each in lengths] + [("angles_deg", each) for each in angles]):
            linkage = {key: dict(zip(names, values, strict=True))}
            if key == "angles_deg":
                linkage["mechanism"] = "spherical_four_bar"
            with self.subTest(key, values=values):
                self.check_analysis(self.write("linkage.json", linkage))

    def test_analyses_with_more_are_refused(self):
        linkage = {"lengths": {"ground": 4, "input": 1, "coupler": 3, "output": 3.5}}
        analysis = self.check_analysis(self.write("linkage.json", linkage))
        for more in ({"mechanism": "four_bar"}, {"linkwright": 2}, {"motion": {**analysis["motion"], "speed": [1]}}, {"type": "slider"}):
            self.assertFalse(validator("analysis").is_valid({**analysis, **more}), more)

    def test_bad_problems_are_refused_alike(self):
        checked = 0
        for path in sorted((ROOT / "data/bad_problems").glob("*.json")):
            if path.name == "expected.json" or path.stem in BEYOND_SCHEMA:
                continue
            try:
                content = json.loads(without_comments(path.read_text(encoding="utf-8")), parse_constant=lambda _: None,
                                     object_pairs_hook=dict)
            except ValueError:
                continue  # not JSON
            if path.stem.startswith(("duplicate_key", "overflow", "nested_too_deep")):
                continue  # not visible in a tree
            with self.subTest(path.name):
                self.assertFalse(self.problem.is_valid(content))
                checked += 1
        self.assertGreater(checked, 40)

    def test_what_the_schema_accepts_the_reader_accepts(self):
        variants = [
            ("title", ""), ("length_unit", ""), ("view", {}), ("view", {"a": [None, True, "x"]}),
            ("requirements", {}), ("requirements", {"types": None}), ("requirements", {"types": []}),
            ("requirements", {"types": ["double_crank", "change_point"], "no_defects": False}),
            ("requirements", {"min_transmission_angle_deg": None, "max_link_ratio": None, "max_length": None,
                              "ground_pivots_within": None, "moving_pivots_within": None}),
            ("requirements", {"max_link_ratio": 1, "max_length": 1e-3, "min_transmission_angle_deg": 0}),
            ("requirements", {"ground_pivots_within": {"x": [0, 0], "y": [-1e300, 1e300]}}),
            ("options", {}), ("options", {"region_samples": 8, "best": 0}), ("options", {"region_samples": 8.0}),
            ("options", {"spacing": "arc_length", "objective": "size", "region_samples": 8}),
            ("options", {"window": None, "region_samples": 8}), ("options", {"window": [[0, 1], [0.5, 2]], "region_samples": 8}),
            ("options", {"at": None}), ("options", {"at": [0.5, 1.25]}), ("options", {"at": [-1, 1e300]}),
            ("requirements", {"min_link_angle_deg": None, "max_link_angle_deg": None, "fixed_axes_within": None}),
        ]
        for key, value in variants:
            problem = load(TAILGATE) | {key: value}
            with self.subTest(key, value=value):
                self.problem.validate(problem)
                status, _, error = run("solve", self.write("problem.json", problem), "--samples", 8)
                self.assertEqual((status, error), (0, ""))

    def test_what_the_schema_refuses_the_reader_refuses(self):
        """Every value of the example replaced by values of other types, every member dropped or renamed."""
        self.check_changes_of(load(TAILGATE))

    def test_of_mixed_positions_too(self):
        problem = load(ROOT / "examples/hood_hinge.json")
        self.check_changes_of({key: problem[key] for key in ("linkwright", "task")})

    def test_of_three_positions_too(self):
        problem = load(ROOT / "examples/airtight_hatch.json")
        self.check_changes_of({key: problem[key] for key in ("linkwright", "task")}, below=("task", "given"))

    def test_of_functions_too(self):
        problem = load(ROOT / "examples/flow_meter.json")
        self.check_changes_of({key: problem[key] for key in ("linkwright", "task")}, below=("task", "free"))
        problem = load(ROOT / "examples/log_generator.json")
        self.check_changes_of({key: problem[key] for key in ("linkwright", "task")}, below=("task", "function"))
        rates = [{"input": 1, "output": 0.8}, {"input": 0, "output": 0.1}]
        pairs = [{"input_deg": 0, "output_deg": 0, "derivatives": rates}, {"input_deg": 50, "output_deg": 30}]
        self.check_changes_of({"linkwright": 1, "task": {"kind": "function", "mechanism": "four_bar", "pairs": pairs}},
                              below=("task", "pairs"))

    def test_of_six_bars_too(self):
        problem = load(ROOT / "examples/loader_bucket_chain.json")
        for member in ("chain", "added"):
            self.check_changes_of({key: problem[key] for key in ("linkwright", "task")}, below=("task", member))

    def test_of_spherical_four_bars_too(self):
        turns = [{"quaternion": [1, 0.1, 0, 0], "angular_velocity": [0.1, 0.4, 0.2]}, {"axis": [0, 1, 1], "angle_deg": 30},
                 {"euler_deg": [40, 50, 20], "sequence": "zyx"}]
        self.check_changes_of({"linkwright": 1, "task": {"kind": "motion", "mechanism": "spherical_four_bar", "orientations": turns}},
                              below=("task",))

    def test_results_of_paths_are_results(self):
        for path in sorted((ROOT / "data/path").glob("*.json")):
            case = load(path)
            for task in [item["task"] for item in case["items"] if "status" in item["expect"]] if "items" in case else [case["task"]]:
                problem = {"linkwright": 1, "task": task, "requirements": {"no_defects": False, "full_turn": True}}
                with self.subTest(path.stem, task=task):
                    status, output, _ = run("solve", self.write("problem.json", problem), "--samples", 30, "-o", "-", "--region")
                    if status == 2:
                        continue  # a crank that turns back
                    self.problem.validate(problem)
                    result = json.loads(output)
                    self.result.validate(result)
                    self.problem.validate(result["problem"])

    def test_of_paths_too(self):
        for name in ("thread_takeup_timed_mixed", "feeder_three_poses_two_points", "walking_leg_pivots_five"):
            task = load(ROOT / f"data/path/{name}.json")["task"]
            below = ("task", "given", "ground_pivots") if "given" in task else ("task", "points")
            self.check_changes_of({"linkwright": 1, "task": task}, below=below)

    def test_of_straight_lines_too(self):
        for name in ("four_point_pivots", "mixed", "symmetric_lambda_of_a_range"):
            problem = problem_of(name)
            del problem["options"]
            self.check_changes_of(problem, below=("task",), best=0)
        for key in ("four_point_cubic", "ball_point_on_side_link", "isosceles_trapezoid", "pole_at_given_pivot", "six_point",
                    "parallel_side_links", "search"):
            problem = problem_of(key)
            del problem["options"]
            for member in set(problem["task"]) - {"kind", "mechanism", "case", "line"}:
                self.check_changes_of(problem, below=("task", member), best=0)

    def test_options_of_straight_lines_too(self):
        problem = problem_of("isosceles_trapezoid", best=0, region_samples=8)
        for key in ("deviation", "stroke", "measure", "objective"):
            for value in (None, True, -1.5, 0, 2.5, "strip", "deviation", "link_ratio", [], {}):
                changed = problem | {"options": problem["options"] | {key: value}}
                status, _, error = run("solve", self.write("problem.json", changed))
                with self.subTest(key, value=value):
                    foreign = (key, value) == ("objective", "link_ratio")
                    self.assertEqual(status == 0, self.problem.is_valid(changed) and not foreign, error)

    def test_all_that_the_reader_knows_is_in_the_schema(self):
        def task(**members):
            return {"kind": "function", "mechanism": "four_bar"} | members

        def named(**members):
            return task(function={"input_range_deg": [0, 60], "output_range_deg": [0, 90]} | members)

        poses = [{"x": x, "y": y, "theta_deg": theta} for x, y, theta in ((0, 0, 0), (4, 10, -10), (34, 14, -75))]
        pairs = [{"input_deg": x, "output_deg": y} for x, y in ((0, 0), (20, 25), (40, 45), (60, 60))]
        tasks = [{"kind": "motion", "mechanism": "four_bar", "poses": poses, "given": given} for given in (
            {"side_lengths": [18, 24]}, {"side_length": 18}, {"side_angle_deg": 30}, {"instant_center": [20, 0]},
            {"side_angle_deg": -400, "directed": False, "input_length": 18}, {"side_angle_deg": 0, "input_length": None},
            {"instant_center": [0, 1], "at_infinity": True}, {"ground_pivots": {"input": [20, -20], "output": [40, -20]}},
            {"moving_pivots": [[5, -20], [10, -30]]}, {"output_moving_pivot": [5, -20]},
            {"input_ground_pivot": [20, -20], "output_moving_pivot": [5, -20]},
            {"ground_pivot_on": {"point": [0, -20], "direction_deg": 0}},
            {"ground_pivot_on": {"point": [0, -20], "direction_deg": 0}, "moving_pivot_on": {"point": [5, 0], "direction_deg": 90}})]
        by_points = [{"points": [[0, 0], [5, 0]]}, {"points": [[4, 10], [8, 7]]}, {"points": [[34, 14], [34, 9]], "derivatives": []}]
        tasks.append({"kind": "motion", "mechanism": "four_bar", "poses": by_points, "given": {"side_lengths": [18, 24]}})
        lines = [{"which": side, "pivot": "ground", "line": {"point": [0, -20], "direction_deg": 0}} for side in ("input", "output")]
        four = [*poses, {"x": 50, "y": 30, "theta_deg": -100}]
        tasks += [{"kind": "motion", "mechanism": "four_bar", "poses": four, "pivot_on": on} for on in (None, [], lines[:1], lines)]
        tasks += [named(expression=text, x=[0.5, 1]) for text in ("x", "x^2", "x^-1", "x^.5", "x^1e-1", "sqrt(x)", "ln", "log10",
                                                                  "tan", "cos_deg(x)")]
        table = [[0, 0], [1, 2], [2, 3], [4, 3.5]]
        tasks += [named(table=table), named(table=table, interpolation="linear", x=[0.5, 3], y=None, points=5, spacing="even"),
                  named(expression="x^2", x=[0, 1], y=[1, 0], spacing=[0, 0.2, 0.5, 0.7, 1])]
        tasks += [task(pairs=pairs, free=free) for free in (None, {"number": "output_scale"},
                                                            {"number": "pair_output", "pair": 2, "range": [20, 30]})]
        turns = [{"rotation_vector": [0.1, 0, 0]}, {"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]},
                 {"matrix": [[0.99, 0, 0], [0, 0, -1], [0, 1, 0]], "nearest": True},
                 {"euler_deg": [10, 20, 30], "sequence": "xyz", "turning": "extrinsic"}]
        sphere = {"kind": "motion", "mechanism": "spherical_four_bar"}
        tasks += [sphere | {"orientations": turns}, sphere | {"orientations": turns, "given": None}]
        tasks += [sphere | {"orientations": turns[:3], "given": {key: [[0, 0, 2], [1, 0, 0]]}} for key in ("fixed_axes", "moving_axes")]
        way, bend = {"angular_velocity": [0.3, 0.1, 0.2]}, {"angular_acceleration": [0, 0, 0]}
        tasks += [sphere | {"orientations": [turns[0] | way, turns[1] | way]}, sphere | {"orientations": [turns[0] | way | bend, turns[1]]},
                  sphere | {"orientations": [turns[0] | way | bend | {"angular_jerk": [0.1, 0.2, -0.3]}]}]
        tasks += [task for name, task in TASKS.items() if name != "search"]
        tasks += [TASKS["four_point_cubic"] | {"cubic_n": None}, TASKS["symmetric_lambda"] | {"crank_range_deg": None},
                  TASKS["mixed"] | {"contacts": [{"s": 0}, {"s": 1, "multiplicity": 2, "side": -1}, {"s": 2.5, "side": 1}]}]
        for one in tasks:
            problem = {"linkwright": 1, "task": one, "options": {"region_samples": 8, "best": 1}}
            with self.subTest(task=one):
                self.problem.validate(problem)
                ran = run("solve", self.write("problem.json", problem))
                self.assertEqual((ran[0], ran[2]), (0, ""))

    def test_every_bound_is_the_programs(self):
        """Each number and each list of tasks of all kinds, on, just within and just beyond what the schema says of it."""
        bounds, met = set(pointers_of_bounds(self.problem.schema)), set()
        for name, problem in problems_with_everything():
            self.problem.validate(problem)
            for path, pointer, node in applied(self.problem, problem):
                if pointer in met or not BOUNDS & set(node):
                    continue
                met.add(pointer)
                for changed in around_bounds(problem, path, node):
                    self.check_alike(changed, (name, path, changed_at(changed, path)))
        self.assertEqual({bound for bound in bounds - met if not any(part in bound for part in NO_BOUNDS_OF_A_PLACE)}, set())

    def check_alike(self, problem, of):
        valid = self.problem.is_valid(problem)
        status, _, error = run("solve", self.write("problem.json", problem))
        with self.subTest(of):
            self.assertIn(status, (0, 2), error)
            beyond = valid and any(words in error for words in BEYOND_STRUCTURE)
            self.assertTrue(beyond or valid == (status == 0), (of, valid, error))

    def check_changes_of(self, problem, below=(), best=2):
        problem = problem | {"options": {"region_samples": 8, "spacing": "coordinate", "best": best}}
        for path in list(paths(problem)):
            if path[:len(below)] != below:
                continue
            for change in (None, True, -1.5, "text", [], {}, [1, 2, 3], "dropped", "renamed"):
                changed = copy.deepcopy(problem)
                apply(changed, path, change)
                valid = self.problem.is_valid(changed)
                status, _, error = run("solve", self.write("problem.json", changed))
                with self.subTest(path=path, change=change):
                    self.assertIn(status, (0, 2), error)
                    if not valid:
                        self.assertEqual(status, 2)
                    elif status == 2:  # more than structure
                        self.assertTrue(any(words in error for words in BEYOND_STRUCTURE), error)


if __name__ == "__main__":
    unittest.main()
