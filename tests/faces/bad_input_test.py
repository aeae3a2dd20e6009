"""Malformed, senseless and hostile input: one line a mistake, exit status 2, nothing written."""

import unittest

from face_support import ROOT, TAILGATE, FaceTest, as_nobody, load, nobody_may_run, run

BAD_PROBLEMS = ROOT / "data/bad_problems"


class BadProblems(unittest.TestCase):
    def test_every_mistake_is_told_in_its_place(self):
        expected = load(BAD_PROBLEMS / "expected.json")["files"]
        self.assertGreaterEqual(len(expected), 40)
        for name, mistakes in expected.items():
            with self.subTest(name):
                path = BAD_PROBLEMS / name
                status, output, error = run("solve", path)
                self.assertEqual((status, output), (2, ""))
                lines = error.splitlines()
                self.assertEqual(len(lines), len(mistakes), error)
                for line, (place, message) in zip(lines, mistakes):
                    self.assertTrue(line.startswith(f"{path}: {place}: " if place else f"{path}: "), line)
                    self.assertIn(message, line)

    def test_every_file_is_in_the_table(self):
        names = {path.name for path in BAD_PROBLEMS.iterdir()} - {"expected.json"}
        self.assertEqual(names, set(load(BAD_PROBLEMS / "expected.json")["files"]))


class HostileFiles(FaceTest):
    def test_are_refused(self):
        hostile = {
            "a million brackets": (b"[" * 1_000_000, "nested deeper than 64"),
            "a million objects": (b'{"a":' * 1_000_000, "nested deeper than 64"),
            "17 MiB of blanks": (b" " * (17 << 20), "larger than 16 MiB"),
            "17 MiB of digits": (b"1" * (17 << 20), "larger than 16 MiB"),
            "zero bytes": (b"\0" * 1000, "zero byte"),
            "a picture": (b"\x89PNG\r\n\x1a\n" + bytes(range(1, 256)), "line 1, column 1"),
            "a program": (b"\x7fELF\x02\x01\x01" + bytes(200), "zero byte"),
        }
        for name, (content, reason) in hostile.items():
            with self.subTest(name):
                self.assert_mistake(run("solve", self.write("hostile.json", content), timeout=200), reason)

    def test_a_result_file_is_as_strict(self):
        for content, reason in (("", "empty"), ("[" * 100_000, "nested deeper"), ("{", "breaks off")):
            path = self.write("result.json", content)
            self.assert_mistake(run("export", path, "--format", "svg"), reason)
            self.assert_mistake(run("analyze", path), reason)


class UnreadableFiles(FaceTest):
    def test_missing(self):
        self.assert_mistake(run("solve", self.folder / "missing.json"), "missing.json", "No such file")

    def test_directory(self):
        self.assert_mistake(run("solve", self.folder), "directory")

    def test_endless_device(self):
        self.assert_mistake(run("solve", "/dev/zero"), "larger than 16 MiB")

    def test_without_permission(self):
        if not nobody_may_run():
            self.skipTest("the program lies where only root may run it")
        self.folder.chmod(0o755)
        path = self.write("secret.json", "{}")
        path.chmod(0)
        self.assert_mistake(run("solve", path, preexec_fn=as_nobody), "Permission denied")


class CommandLines(FaceTest):
    def test_without_command_helps_and_fails(self):
        status, output, error = run()
        self.assertEqual((status, output), (2, ""))
        self.assertIn("solve", error)

    def test_unknown_words_are_named(self):
        self.assert_mistake(run("solve", TAILGATE, "--sample", "40"), "--sample", "linkwright solve --help")
        self.assert_mistake(run("sovle", TAILGATE), "sovle", "linkwright --help")
        self.assert_mistake(run("solve"), "PROBLEM", "required")
        self.assert_mistake(run("solve", TAILGATE, "--samples", "many"), "many")
        self.assert_mistake(run("export", TAILGATE, "--format", "gif"), "gif")
        self.assert_mistake(run("analyze", TAILGATE, "--drive", "coupler"), "coupler")

    def test_sample_counts_are_checked(self):
        for samples in ("0", "7", "20001", "-5"):
            self.assert_mistake(run("solve", TAILGATE, f"--samples={samples}"), "--samples", "8 to 20000")

    def test_analysis_needs_a_known_ending(self):
        path = self.write("linkage.json", {"lengths": {"ground": 4, "input": 2, "coupler": 3, "output": 3.5}})
        self.assert_mistake(run("analyze", path, "-o", self.folder / "motion.txt"), "motion.txt", ".json or .csv")

    def test_linkage_numbers_are_checked(self):
        result = self.solve_tailgate()
        count = len(load(result)["linkages"])
        for number in (0, -1, count + 1):
            self.assert_mistake(run("export", result, f"--linkage={number}", "--format", "svg"), "--linkage", f"1 to {count}")

    def test_a_problem_is_no_result(self):
        self.assert_mistake(run("export", TAILGATE, "--format", "svg"), "problem file")
        self.assert_mistake(run("analyze", TAILGATE), "no linkage yet")


if __name__ == "__main__":
    unittest.main()
