"""What the face tests share: the program, a folder of their own, JSON with comments."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CLI = os.environ.get("LINKWRIGHT_CLI", str(ROOT / "build/release/bin/linkwright"))
TAILGATE = ROOT / "examples/tailgate.json"


def run(*arguments, **options):
    """The program's exit status, standard output and standard error."""
    options.setdefault("timeout", 1200)
    if "input" in options:
        options["input"] = options["input"].encode()
    else:
        options.setdefault("stdin", subprocess.DEVNULL)
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, check=False, **options)
    return done.returncode, done.stdout.decode(), done.stderr.decode(errors="replace")


def as_nobody():
    """For preexec_fn: gives up what root may do."""
    if os.geteuid() == 0:
        os.setgid(65534)
        os.setuid(65534)


def nobody_may_run():
    try:
        return run("--version", preexec_fn=as_nobody)[0] == 0
    except (OSError, subprocess.SubprocessError):
        return False


def without_comments(text):
    """JSON text without // comments outside of its texts."""
    return re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*', lambda match: match.group(1) or "", text)


def load(path):
    return json.loads(without_comments(Path(path).read_text(encoding="utf-8")))


class FaceTest(unittest.TestCase):
    """A test with a folder of its own in self.folder."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        else:
            path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return path

    def solve_tailgate(self, *arguments):
        """The result file of the example on a small region."""
        result = self.folder / "result.json"
        status, _, error = run("solve", TAILGATE, "--samples", 64, "-o", result, *arguments)
        self.assertEqual((status, error), (0, ""))
        return result

    def assert_mistake(self, ran, *pieces):
        """Exit status 2, nothing on standard output, one line on standard error with all the pieces."""
        status, output, error = ran
        self.assertEqual(status, 2, error)
        self.assertEqual(output, "")
        self.assertEqual(len(error.splitlines()), 1, error)
        for piece in pieces:
            self.assertIn(piece, error)

    def assert_failure(self, ran, *pieces):
        """Exit status 1 and one line on standard error with all the pieces."""
        status, _, error = ran
        self.assertEqual(status, 1, error)
        self.assertEqual(len(error.splitlines()), 1, error)
        for piece in pieces:
            self.assertIn(piece, error)
