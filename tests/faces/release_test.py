"""The version has one place, CMakeLists.txt; script/release refuses what is not ready to be released."""

import re
import shutil
import subprocess
import tempfile
import tomllib
import unittest
from pathlib import Path

from face_support import ROOT, run

VERSION = re.search(r"^project\(linkwright VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


class Version(unittest.TestCase):
    def test_the_program_has_it(self):
        self.assertEqual(run("--version")[1], f"linkwright {VERSION}\n")

    def test_what_asks_for_the_library_asks_for_it(self):
        series = ".".join(VERSION.split(".")[:2])
        for name in ("README.md", "README.zh-CN.md", "tests/package/CMakeLists.txt"):
            asked = re.findall(r"find_package\(linkwright (\S+) REQUIRED\)", (ROOT / name).read_text())
            self.assertEqual(asked, [series], name)

    def test_other_packages_have_it_or_none(self):
        wheel = ROOT / "pyproject.toml"
        if wheel.exists():
            self.assertIn(tomllib.loads(wheel.read_text())["project"].get("version"), (None, VERSION))
        for name in ("web/package.json", "web/npm/package.json"):
            self.assertNotIn('"version"', (ROOT / name).read_text(), name)


class Release(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.tree = Path(scratch.name)
        (self.tree / "script").mkdir()
        for name in ("script/common.sh", "script/release", "CMakeLists.txt"):
            shutil.copy(ROOT / name, self.tree / name)
        (self.tree / "CHANGELOG.md").write_text("# Changelog\n\n## [Unreleased]\n\n- New.\n")
        self.git("init", "--quiet")
        self.commit()

    def git(self, *arguments):
        subprocess.run(["git", "-c", "user.name=A", "-c", "user.email=a@b.invalid", *arguments], cwd=self.tree, check=True)

    def commit(self):
        self.git("add", ".")
        self.git("commit", "--quiet", "-m", "All")

    def refused(self, *arguments):
        done = subprocess.run(["script/release", *arguments], cwd=self.tree, capture_output=True, text=True, check=False)
        self.assertFalse((self.tree / "build").exists())
        return done.returncode, done.stderr

    def test_refuses_a_version_without_changes(self):
        self.assertEqual(self.refused()[0], 1)
        self.assertIn(f"CHANGELOG.md has no section [{VERSION}]", self.refused()[1])

    def test_refuses_what_is_not_committed(self):
        (self.tree / "CHANGELOG.md").write_text(f"# Changelog\n\n## [{VERSION}]\n\n- New.\n")
        self.assertEqual(self.refused()[0], 1)
        self.assertIn("changes that are not committed", self.refused()[1])

    def test_refuses_what_it_does_not_know(self):
        for arguments in (["--fast"], ["--dirty", "--dirty"]):
            self.assertEqual(self.refused(*arguments)[0], 2)


if __name__ == "__main__":
    unittest.main()
