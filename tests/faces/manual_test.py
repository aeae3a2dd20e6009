"""The manual pages and the completion of bash are those of the program as it is."""

import gzip
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from face_support import CLI, ROOT, run

COMMANDS = [(), ("solve",), ("analyze",), ("export",), ("tolerance",), ("attitude",), ("attitude", "screw"), ("studio",)]
COMPLETE = 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _linkwright; printf "%s\\n" "${COMPREPLY[@]}"'


def spellings_of(command):
    _, text, _ = run(*command, "--help")
    return ",".join(re.findall(r"^  (-\S+)", text, re.MULTILINE)).split(",")


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        subprocess.run([sys.executable, ROOT / "script/manual.py", CLI, "1.2.3", cls.folder], check=True)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def page(self, command):
        return gzip.decompress((self.folder / "man1" / f"{'-'.join(('linkwright', *command))}.1.gz").read_bytes())

    def completions(self, *words):
        done = subprocess.run(["bash", "-c", COMPLETE, self.folder / "linkwright", "linkwright", *words], cwd=ROOT / "examples",
                              capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_every_page_is_sound(self):
        pages = sorted((self.folder / "man1").iterdir())
        self.assertIn("linkwright-attitude-screw.1.gz", [page.name for page in pages])
        for page in pages:
            drawn = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=gzip.decompress(page.read_bytes()),
                                   capture_output=True, check=True)
            self.assertEqual(drawn.stderr, b"", page.name)

    @unittest.skipUnless(shutil.which(f"{CLI}-mpi"), "linkwright-mpi is not there")
    def test_other_programs_have_theirs(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "script/manual.py", f"{CLI}-mpi", "1.2.3", folder], check=True)
            pages = sorted(page.name for page in Path(folder, "man1").iterdir())
            self.assertEqual(pages, ["linkwright-mpi-sweep.1.gz", "linkwright-mpi.1.gz"])
            page = gzip.decompress(Path(folder, "man1", pages[0]).read_bytes()).decode().replace("\\-", "-")
            self.assertIn("\\fBlinkwright-mpi sweep\\fR [OPTIONS] [SWEEP]", page)
            self.assertIn("complete -F _linkwright_mpi linkwright-mpi\n", Path(folder, "linkwright-mpi").read_text())

    def test_every_option_has_its_entry(self):
        for command in COMMANDS:
            page = self.page(command).decode().replace("\\-", "-")
            for option in spellings_of(command):
                self.assertIn(f"\\fB{option}\\fR", page, command)

    def test_a_page_says_what_an_option_takes_and_needs(self):
        page = self.page(("analyze",)).decode().replace("\\-", "-")
        self.assertIn("\\fB--drive\\fR \\fI{input,output}\\fR\nWhich grounded link drives", page)
        self.assertIn("Draw the instant, or what is compared, to this SVG file", page)

    def test_commands_are_completed(self):
        self.assertEqual(self.completions("s"), ["solve", "sweep", "studio"])
        self.assertEqual(self.completions("attitude", "s"), ["screw"])

    def test_options_are_completed(self):
        for command in COMMANDS:
            self.assertLessEqual(set(spellings_of(command)), set(self.completions(*command, "-")), command)

    def test_values_are_completed(self):
        self.assertIn("svg", self.completions("export", "--format", ""))
        self.assertEqual(self.completions("analyze", "--drive", "=", "o"), ["output"])
        self.assertEqual(self.completions("studio", "--port", ""), [])

    def test_files_are_completed(self):
        self.assertEqual(sorted(self.completions("solve", "tail")),
                         ["tailgate.json", "tailgate_as_made.json", "tailgate_struts.json"])
        self.assertEqual(self.completions("solve", "tailgate.json", "--svg", "wri"), ["wrist_orthosis.json"])


if __name__ == "__main__":
    unittest.main()
