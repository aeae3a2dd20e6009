"""Tolerances from outside: what `solve` tells of them, and `tolerance` of one linkage of a result."""

import json
import unittest

from face_support import ROOT, TAILGATE, FaceTest, load, run
from schema_test import jsonschema, validator
from solve_support import SolveTest

EXAMPLES = ROOT / "examples"
LENGTHS, ARCS = {"length": 0.1}, {"link_angle_deg": 0.1}
# An example of each kind, its tolerances, the limit of its error, and samples a side of its map.
KINDS = {
    "tailgate": (LENGTHS, {"position": 1}, 64),
    "hood_hinge": (LENGTHS, {"angle_deg": 1}, 64),
    "log_generator": (LENGTHS, {"angle_deg": 0.5}, 64),
    "antenna_pointing": (ARCS, {"angle_deg": 0.5}, 64),
    "universal_joint_like": (ARCS, {"angle_deg": 0.2}, 64),
    "straight_walking_leg": (LENGTHS, {"deviation": 0.5}, 40),
    "loader_bucket_chain": (LENGTHS, {"position": 5}, 120),
}


def made(name, **more):
    """An example with tolerances."""
    tolerances, limit, samples = KINDS[name]
    problem = load(EXAMPLES / f"{name}.json")
    problem["tolerances"] = {**tolerances, "limit": limit, "samples": 2000, **more}
    problem.setdefault("options", {}).update(region_samples=samples, best=2)
    return problem


class Solved(SolveTest):
    def test_every_kind_tells_of_each_linkage(self):
        for name in KINDS:
            with self.subTest(name):
                result, words, _ = self.solve(made(name))
                self.assertIn("Tolerances: ", words)
                self.assertIn("worst case", words)
                self.assertTrue(result["linkages"])
                for linkage in result["linkages"]:
                    self.check(linkage["tolerance"])

    def check(self, told):
        self.assertGreater(told["error"], 0)
        self.assertAlmostEqual(told["error_sampled"] / told["error"], 1, delta=0.2)
        self.assertGreater(told["worst_case"], told["error"] / 3)
        self.assertAlmostEqual(sum(share["share"] for share in told["sensitivities"]), 1, places=9)
        low, high = told["yield_interval"]
        self.assertLessEqual(low, told["yield"])
        self.assertLessEqual(told["yield"], high)

    def test_ranks_and_requires(self):
        problem = made("tailgate")
        problem["options"]["objective"] = "tolerance_error"
        problem["requirements"]["max_tolerance_error"] = 0.2
        result, words, _ = self.solve(problem)
        errors = [linkage["tolerance"]["error_sampled"] for linkage in result["linkages"]]
        self.assertEqual(errors, sorted(errors))
        self.assertLess(errors[0], 0.2)
        self.assertIn("smallest error by tolerances", words)

    def test_lists_a_front(self):
        problem = made("tailgate")
        problem["options"]["pareto"] = ["min_transmission_angle", "tolerance_error"]
        result, words, _ = self.solve(problem)
        front = [cell["values"] for cell in result["pareto"]["front"]]
        self.assertGreater(len(front), 2)
        self.assertEqual(front, sorted(front, reverse=True))
        self.assertEqual([error for _, error in front], sorted((error for _, error in front), reverse=True))
        self.assertIn("no other beats in both", words)

    def test_says_nothing_of_them_where_there_are_none(self):
        result, words, _ = self.solve(TAILGATE, "--samples", 64)
        self.assertNotIn("olerance", words)
        self.assertNotIn("olerance", json.dumps(result))


class Command(FaceTest):
    def result_of(self, problem, *arguments):
        result = self.folder / "result.json"
        status, _, error = run("solve", self.write("problem.json", problem), "-o", result, *arguments)
        self.assertEqual((status, error), (0, ""))
        return result

    def study(self, result, *arguments):
        status, output, error = run("tolerance", result, "-o", "-", *arguments)
        self.assertEqual((status, error), (0, ""))
        return output

    def test_tells_of_any_linkage_what_its_result_does(self):
        for name in KINDS:
            with self.subTest(name):
                result = self.result_of(made(name))
                for number, linkage in enumerate(load(result)["linkages"], 1):
                    told = json.loads(self.study(result, "--linkage", number))["tolerance"]
                    listed = linkage["tolerance"]
                    self.assertEqual(told["samples"], 2000)
                    for key in ("error", "error_sampled", "worst_case", "mean_plus_3_sigma"):
                        self.assertAlmostEqual(told[key] / listed[key], 1, places=6, msg=key)
                    self.assertEqual(told["yield"], listed["yield"])
                    status, words, _ = run("tolerance", result, "--linkage", number)
                    self.assertEqual(status, 0)
                    self.assertTrue(all(len(line) <= 100 for line in words.splitlines()), words)
                    for said in ("to first order", "Shares of the variance", "95 % certainty"):
                        self.assertIn(said, words)

    def test_the_same_seed_gives_the_same_bytes(self):
        result = self.result_of(made("tailgate"))
        again = [self.study(result, "--seed", seed, "--samples", 5000) for seed in (7, 7, 8)]
        self.assertEqual(again[0], again[1])
        one, other = (json.loads(text)["tolerance"] for text in again[1:])
        self.assertNotEqual(one["error_sampled"], other["error_sampled"])
        self.assertEqual(one["error"], other["error"])
        self.assertLess(max(one["yield_interval"][0], other["yield_interval"][0]),
                        min(one["yield_interval"][1], other["yield_interval"][1]))

    def test_large_seeds_differ(self):
        result = self.result_of(made("tailgate"))
        largest = 2**53 - 1
        told = [json.loads(self.study(result, "--seed", seed))["tolerance"] for seed in (largest, largest - 1)]
        self.assertEqual([one["seed"] for one in told], [largest, largest - 1])
        self.assertNotEqual(told[0]["error_sampled"], told[1]["error_sampled"])
        seeded = load(self.result_of(made("tailgate", seed=largest)))["linkages"][0]["tolerance"]
        self.assertEqual(seeded, told[0])

    def test_a_length_stands_for_the_tolerances_of_the_file(self):
        result = self.result_of({**load(TAILGATE), "options": {"region_samples": 64}})
        fine, coarse = (json.loads(self.study(result, "--length", length)) for length in (0.1, 0.2))
        self.assertAlmostEqual(coarse["tolerance"]["error"] / fine["tolerance"]["error"], 2, places=9)
        self.assertEqual(coarse["tolerances"]["length"], 0.2)

    @unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
    def test_keeps_to_the_schema(self):
        study = self.study(self.result_of(made("tailgate", cost={"exponent": 2})))
        validator("analysis").validate(json.loads(study))

    def test_writes_to_a_file(self):
        result, report = self.result_of(made("tailgate")), self.folder / "study.json"
        status, words, error = run("tolerance", result, "-o", report)
        self.assertEqual((status, error), (0, ""))
        self.assertIn("linkage 1", words)
        self.assertEqual(report.read_text(encoding="utf-8"), self.study(result))

    def test_says_that_nothing_assembles(self):
        far_off = made("tailgate", driver_deg=90, distribution="uniform", samples=1000)
        far_off["tolerances"].pop("length")
        words = run("tolerance", self.result_of(far_off))[1]
        self.assertRegex(words, r"do not assemble|assembles in all positions")
        self.assertNotRegex(words, r"\b(inf|nan)\b")


class Refusals(FaceTest):
    def setUp(self):
        super().setUp()
        self.result = self.folder / "result.json"
        self.assertEqual(run("solve", self.write("problem.json", made("tailgate")), "-o", self.result)[0], 0)

    def refuse(self, flags, *pieces, result=None):
        self.assert_mistake(run("tolerance", result or self.result, *flags), *pieces)

    def changed(self, change):
        result = load(self.result)
        change(result)
        return self.write("changed.json", result)

    def test_linkages_that_are_not_there(self):
        for number in ("0", "3", "-1"):
            self.refuse(["--linkage", number], "--linkage", "this result holds 1 to 2")
        self.refuse([], "holds no linkages", result=self.changed(lambda result: result.update(linkages=[])))

    def test_numbers_that_are_none(self):
        for flags, place in ((["--length", "-1"], "tolerances.length"), (["--length", "nan"], "tolerances.length"),
                             (["--length", "1e200"], "tolerances.length"), (["--samples", "10"], "tolerances.samples"),
                             (["--seed", "-1"], "tolerances.seed"), (["--seed", "9007199254740992"], "tolerances.seed"),
                             (["--length", "0"], "tolerances"), (["--samples", "many"], "--samples"),
                             (["--seed", "1.5"], "--seed"), (["--linkage", "first"], "--linkage")):
            with self.subTest(flags):
                self.refuse(flags, place)

    def test_a_result_without_tolerances(self):
        bare = self.changed(lambda result: result["problem"].pop("tolerances"))
        self.refuse([], "problem.tolerances", "solve it again", "--length", result=bare)

    def test_tolerances_of_other_kinds(self):
        path = self.folder / "sphere.json"
        self.assertEqual(run("solve", EXAMPLES / "antenna_pointing.json", "--samples", 40, "-o", path)[0], 0)
        self.refuse(["--length", "1"], "tolerances.length", "link_angle_deg", result=path)

    def test_files_that_are_no_results(self):
        self.refuse([], "not a result file", "linkwright solve", result=TAILGATE)
        self.refuse([], "No such file", result=self.folder / "missing.json")
        whole = self.result.read_bytes()
        self.refuse([], "breaks off", result=self.write("cut.json", whole[:2000]))
        self.refuse([], "UTF-8", result=self.write("text.json", whole.replace(b"Tailgate hinge", b"\xff\xfe")))
        self.refuse([], "newer", result=self.changed(lambda result: result.update(linkwright=99)))

    def test_results_that_were_written_over(self):
        def at(key, value):
            return lambda result: result["problem"].update({key: value})
        for change in (at("options", 5), at("options", [1]), at("task", "motion"), at("task", [1]),
                       lambda result: result.update(linkages={}), lambda result: result.update(problem=[])):
            self.refuse([], "not a result file", result=self.changed(change))
        for change in (lambda linkage: linkage["input"].update(coordinate="left"), lambda linkage: linkage.pop("output"),
                       lambda linkage: linkage["input"].update(coordinate=1e300)):
            self.refuse([], "linkages", "anew", result=self.changed(lambda result, change=change: change(result["linkages"][0])))
        self.refuse([], "linkages", "no place", result=self.changed(lambda result: result["linkages"].insert(0, 7)))


if __name__ == "__main__":
    unittest.main()
