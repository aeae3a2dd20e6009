"""The documents tell the truth: commands run and print what is shown, snippets compile and solve, links lead somewhere."""

import json
import re
import shlex
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from face_support import CLI, ROOT, FaceTest, run

sys.path.insert(0, str(ROOT / "script"))
import lint_tree  # noqa: E402

READMES = ("README.md", "README.zh-CN.md")
LEFT_OUT = "…"  # a line of its own: the program prints more here
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)|(?:src|href)=\"([^\"]+)\"")


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def blocks(path, language):
    return [content for name, content in BLOCK.findall(text_of(path)) if name == language]


def commands(path):
    """(command, lines shown below it) of each `$ …` in the console blocks."""
    for block in blocks(path, "console"):
        for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, _, output = part.replace("\\\n", " ").partition("\n")
            yield command, output.rstrip("\n").split("\n") if output.strip() else []


def documents():
    folders = (ROOT.glob("*.md"), *((ROOT / folder).rglob("*.md") for folder in ("docs", "examples", "data")))
    return sorted(path for folder in folders for path in folder)


def mismatch(shown, printed):
    """The first line shown that the program does not print there; None if all are."""
    at, anywhere = 0, False
    for line in shown:
        if line == LEFT_OUT:
            anywhere = True
            continue
        found = next((i for i in range(at, len(printed)) if printed[i].rstrip() == line.rstrip()), None)
        if found is None or (found != at and not anywhere):
            return line
        at, anywhere = found + 1, False
    return None if anywhere or at == len(printed) else "(the end)"


class Readme(FaceTest):
    def setUp(self):
        super().setUp()
        for folder in ("examples", "docs"):
            shutil.copytree(ROOT / folder, self.folder / folder)

    def test_commands_print_what_is_shown(self):
        for readme in READMES:
            ran = 0
            for command, shown in commands(readme):
                words = shlex.split(command, comments=True)
                if words[0] != "linkwright":
                    continue
                with self.subTest(readme=readme, command=command):
                    status, output, error = run(*words[1:], cwd=self.folder)
                    self.assertEqual((status, error), (0, ""))
                    if shown:
                        self.assertIsNone(mismatch(shown, output.rstrip("\n").split("\n")), output)
                ran += 1
            self.assertGreaterEqual(ran, 4, readme)

    def test_scripts_that_are_named_exist(self):
        for document in documents():
            for script in re.findall(r"(?<![\w./-])(script/\w+|\.ci/\w+)", document.read_text(encoding="utf-8")):
                with self.subTest(document=document.name, script=script):
                    self.assertTrue(list(ROOT.glob(script + "*")))

    def test_the_pictures_are_the_programs(self):
        for example, name in (("tailgate", "tailgate"), ("straight_watt_suspension", "straight_line")):
            picture = self.folder / "fresh.svg"
            self.assertEqual(run("solve", f"examples/{example}.json", "--svg", picture, cwd=ROOT)[0], 0)
            self.assert_same_texts(name, picture, f"solve examples/{example}.json")
        result, picture = self.folder / "made.json", self.folder / "tolerances.svg"
        self.assertEqual(run("solve", "examples/tailgate_as_made.json", "-o", result, cwd=ROOT)[0], 0)
        self.assertEqual(run("tolerance", result, "--linkage", "7", "--svg", picture, cwd=ROOT)[0], 0)
        self.assert_same_texts("tolerances", picture, "tolerance RESULT --linkage 7")

    def assert_same_texts(self, name, picture, command):
        texts = [[node.text for node in xml.etree.ElementTree.parse(path).iter() if (node.text or "").strip()]
                 for path in (ROOT / f"docs/{name}.svg", picture)]
        self.assertEqual(*texts, f"renew it: linkwright {command} --svg docs/{name}.svg")

    def test_problems_that_are_shown_can_be_solved(self):
        for readme in READMES:
            shown = blocks(readme, "json")
            self.assertTrue(shown, readme)
            for number, problem in enumerate(shown):
                path = self.write(f"shown{number}.json", problem)
                status, output, error = run("solve", path, "-o", "-")
                self.assertEqual((status, error), (0, ""))
                self.assertEqual(json.loads(output)["status"], "solved")

    @unittest.skipUnless(shutil.which("g++"), "no g++")
    def test_snippets_compile(self):
        for readme in READMES:
            shown = blocks(readme, "cpp")
            self.assertTrue(shown, readme)
            for snippet in shown:
                compiled = subprocess.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-fsyntax-only", f"-I{ROOT}/include", "-xc++", "-"],
                                          input=snippet.encode(), capture_output=True, check=False)
                self.assertEqual(compiled.returncode, 0, compiled.stderr.decode())

    def test_both_languages_show_the_same(self):
        for language in ("console", "json", "cpp", "cmake", "python"):
            self.assertEqual(*(blocks(readme, language) for readme in READMES))

    def test_links_lead_somewhere(self):
        for document in documents():
            for groups in LINK.findall(document.read_text(encoding="utf-8")):
                target = "".join(groups).partition("#")[0]
                if target and not re.match(r"[a-z]+:", target):
                    with self.subTest(document=document.name, target=target):
                        self.assertTrue((document.parent / target).exists())

    def test_the_program_is_the_one_that_was_built(self):
        self.assertEqual(run("--version")[1].split()[0], "linkwright", CLI)


class Architecture(unittest.TestCase):
    def test_the_order_of_the_folders_is_the_one_that_is_enforced(self):
        ranks = [ranked[0] if len(ranked) == 1 else "{" + ", ".join(ranked) + "}" for ranked in lint_tree.RANKS]
        self.assertIn("\n    " + " < ".join([*ranks, "front ends"]) + "\n", text_of("docs/architecture.md"))

    def test_the_folders_are_those_of_the_tree(self):
        rows = re.findall(r"^\| (`.+?) \|.*\| (.+?) \|$", text_of("docs/architecture.md"), re.MULTILINE)
        claimed = {folder for names, state in rows for folder in re.findall(r"`(\w+)`", names) if state != "not yet"}
        self.assertEqual(claimed, {path.name for path in (ROOT / "include/linkwright").iterdir()})


class Glossary(unittest.TestCase):
    def test_words_are_those_of_the_code(self):
        sources = [path.read_text(encoding="utf-8") for folder, ending in (("include", "*.hpp"), ("src", "*.?pp"), ("schema", "*.json"))
                   for path in (ROOT / folder).rglob(ending)]
        words = {word for source in sources for word in re.findall(r"\w+", source)}
        rows = re.findall(r"^\| (.+?) \|", text_of("docs/glossary.md"), re.MULTILINE)
        named = [word for row in rows for word in re.findall(r"`(\w+)`", row)]
        self.assertGreater(len(named), 50)
        self.assertEqual([word for word in named if word not in words], [])

    def test_barkers_codes_stand_in_the_tooltips_of_both_languages(self):
        rows = [row.strip("|").split("|") for row in text_of("docs/glossary.md").splitlines() if row.count("|") == 6]
        codes = {re.search(r"`(\w+)`", row[0])[1]: re.findall(r"\b[A-Z]\w{2,3}\b", row[3]) for row in rows if "`" in row[0]}
        self.assertEqual(len(codes), 11)
        self.assertEqual(codes["double_crank"], ["GCCC"])
        for language in "en", "zh":
            texts = json.loads(text_of(f"web/src/texts/{language}.json"))
            for kind, named in codes.items():
                shown = re.findall(r"\b[A-Z][A-Z0-9]{2,3}\b", texts.get(f"term.{kind}", ""))
                self.assertEqual(shown, named, f"{kind} in {language}")


if __name__ == "__main__":
    unittest.main()
