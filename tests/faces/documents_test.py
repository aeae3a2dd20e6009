"""The documents tell the truth: commands run and print what is shown, problems solve, snippets compile and run, links lead
somewhere. In Python what follows `# →` is printed."""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree
from concurrent.futures import ThreadPoolExecutor

import jsonschema
from face_support import CLI, ROOT, FaceTest, run

sys.path.insert(0, str(ROOT / "script"))
import lint_tree  # noqa: E402

READMES = ("README.md", "README.zh-CN.md")
LEFT_OUT = "…"  # a line of its own: the program prints more here
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)|(?:src|href)=\"([^\"]+)\"")
LANGUAGES = {"console", "json", "cpp", "python", "cmake", "sh", "text", ""}  # the last two are not code
LIBRARY = ROOT / "build/release/liblinkwright.a"
PYTHON = ROOT / "build/release/python"  # what belongs on PYTHONPATH, where it was built
ON_CLUSTERS = {"sbatch"}  # shown, but not on every machine


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def blocks(path, language):
    return [content for name, content in BLOCK.findall(text_of(path)) if name == language]


def all_blocks(language):
    """Each block of any document once, and where it stands."""
    return {content: path.relative_to(ROOT) for path in reversed(documents()) for content in blocks(path, language)}


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


class Documents(FaceTest):
    def setUp(self):
        super().setUp()
        self.prepare(self.folder)

    def prepare(self, folder):
        for name in ("examples", "docs"):
            shutil.copytree(ROOT / name, folder / name)

    def complaints_of(self, document):
        """What is wrong with the commands of a document, run one after the other in a folder of its own."""
        folder = self.folder / str(document.relative_to(ROOT)).replace("/", "_")
        folder.mkdir()
        self.prepare(folder)
        for command, shown in commands(document):
            words = shlex.split(command, comments=True)
            if words[0] != "linkwright":
                yield f"{document.name}: {command}: only linkwright is run"
                continue
            status, output, error = run(*words[1:], cwd=folder)
            if (status, error) != (0, ""):
                yield f"{document.name}: {command}: {status} {error}"
            elif shown and (line := mismatch(shown, output.rstrip("\n").split("\n"))):
                yield f"{document.name}: {command}: does not print {line!r} there, but\n{output}"

    def test_commands_print_what_is_shown(self):
        ran = [document for document in documents() if blocks(document, "console")]
        self.assertGreaterEqual({document.name for document in ran}, {"README.md", "attitude.md", "tailgate.md"})
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            complaints = [one for found in pool.map(lambda document: list(self.complaints_of(document)), ran) for one in found]
        self.assertEqual(complaints, [], "\n".join(complaints))

    def test_code_says_what_it_is(self):
        for document in documents():
            for language, content in BLOCK.findall(document.read_text(encoding="utf-8")):
                with self.subTest(document=document.name, block=content[:60]):
                    self.assertIn(language, LANGUAGES)

    def test_scripts_that_are_named_exist(self):
        for document in documents():
            for script in re.findall(r"(?<![\w./-])(script/\w+|\.ci/\w+)", document.read_text(encoding="utf-8")):
                with self.subTest(document=document.name, script=script):
                    self.assertTrue(list(ROOT.glob(script + "*")))

    def test_the_pictures_are_the_programs(self):
        for example, name in (("tailgate", "tailgate"), ("straight_watt_suspension", "straight_line"),
                              ("bean_stirrer", "nearest_path")):
            picture = self.folder / "fresh.svg"
            self.assertEqual(run("solve", f"examples/{example}.json", "--svg", picture, cwd=ROOT)[0], 0)
            self.assert_same_texts(name, picture, f"solve examples/{example}.json")
        result, picture = self.folder / "made.json", self.folder / "tolerances.svg"
        self.assertEqual(run("solve", "examples/tailgate_as_made.json", "-o", result, cwd=ROOT)[0], 0)
        self.assertEqual(run("tolerance", result, "--linkage", "7", "--svg", picture, cwd=ROOT)[0], 0)
        self.assert_same_texts("tolerances", picture, "tolerance RESULT --linkage 7")
        result, picture = self.folder / "struts.json", self.folder / "loads.svg"
        self.assertEqual(run("solve", "examples/tailgate_struts.json", "-o", result, cwd=ROOT)[0], 0)
        self.assertEqual(run("loads", result, "-o", picture, cwd=ROOT)[0], 0)
        self.assert_same_texts("loads", picture, "loads RESULT -o docs/loads.svg")

    def assert_same_texts(self, name, picture, command):
        texts = [[node.text for node in xml.etree.ElementTree.parse(path).iter() if (node.text or "").strip()]
                 for path in (ROOT / f"docs/{name}.svg", picture)]
        self.assertEqual(*texts, f"renew it: linkwright {command} --svg docs/{name}.svg")

    def test_problems_that_are_shown_can_be_solved(self):
        schema = json.loads(text_of("schema/problem.schema.json"))
        shown = all_blocks("json")
        self.assertGreater(len(shown), 3)
        for number, (problem, document) in enumerate(shown.items()):
            with self.subTest(document=str(document), problem=problem[:80]):
                jsonschema.validate(json.loads(problem), schema)
                status, output, error = run("solve", self.write(f"shown{number}.json", problem), "-o", "-")
                self.assertEqual((status, error), (0, ""))
                self.assertIn(json.loads(output)["status"], ("solved", "no_solution"))

    @unittest.skipUnless(shutil.which("g++"), "no g++")
    def test_snippets_compile(self):
        shown = all_blocks("cpp")
        self.assertTrue(shown)
        for snippet, document in shown.items():
            compiled = subprocess.run(["g++", "-std=c++20", "-Wall", "-Wextra", "-fsyntax-only", f"-I{ROOT}/include", "-xc++", "-"],
                                      input=snippet.encode(), capture_output=True, check=False)
            self.assertEqual(compiled.returncode, 0, f"{document}: {compiled.stderr.decode()}")

    @unittest.skipUnless(shutil.which("g++") and LIBRARY.exists(), "no g++, or the library is not built")
    def test_the_readme_s_program_lists_what_the_command_lists(self):
        (snippet,) = blocks("README.md", "cpp")
        self.assertLessEqual(len(snippet.splitlines()), 15)
        libraries = ["-lfmt", "-ltbb", "-lz", "-lpugixml", "-ldl"]
        compiled = subprocess.run(["g++", "-std=c++20", f"-I{ROOT}/include", "-xc++", "-", "-xnone", LIBRARY, *libraries, "-oreadme"],
                                  input=snippet.encode(), cwd=self.folder, capture_output=True, check=False)
        self.assertEqual(compiled.returncode, 0, compiled.stderr.decode())
        printed = subprocess.run([self.folder / "readme"], cwd=self.folder, capture_output=True, text=True, check=True).stdout
        places = re.findall(r"\{(-?\d+), (-?\d+)\}, (?:radians\()?(-?\d+)", snippet)
        poses = [{"x": int(x), "y": int(y), "theta_deg": int(theta)} for x, y, theta in places]
        problem = {"linkwright": 1, "task": {"kind": "motion", "mechanism": "four_bar", "poses": poses},
                   "requirements": {"min_transmission_angle_deg": 30, "max_length": 450}}
        _, output, _ = run("solve", self.write("readme.json", json.dumps(problem)), "-o", "-")
        types = [linkage["type"] for linkage in json.loads(output)["linkages"]]
        self.assertEqual([line.split()[0] for line in printed.splitlines()], types)
        self.assertTrue(xml.etree.ElementTree.parse(self.folder / "tailgate.svg").getroot().tag.endswith("svg"))

    @unittest.skipUnless(list(PYTHON.glob("linkwright/_linkwright*.so")), "the Python module is not built")
    def test_python_runs_and_prints_what_is_shown(self):
        for snippet, document in all_blocks("python").items():
            with self.subTest(document=str(document), snippet=snippet):
                ran = subprocess.run(["/usr/bin/python3", "-c", snippet], cwd=self.folder, capture_output=True, text=True, check=False,
                                     env={**os.environ, "PYTHONPATH": str(PYTHON), "MPLBACKEND": "Agg"}, timeout=1200)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                printed = iter(ran.stdout.splitlines())
                for line in re.findall(r"# → (.+)$", snippet, re.MULTILINE):
                    self.assertIn(line, printed, ran.stdout)  # goes on behind the last one found

    def test_shells_are_told_what_there_is(self):
        for block, document in all_blocks("sh").items():
            made = []  # folders that lines before name
            for line in filter(None, block.split("\n")):
                words = shlex.split(line, comments=True)
                from_here = any(words[0].startswith(f"{folder}/") for folder in made)
                made += [word for word in words[1:] if word.startswith("~/")]
                with self.subTest(document=str(document), line=line):
                    if words[0] == "linkwright":
                        self.assertEqual(run(words[1], "--help")[0], 0)
                    elif words[0] not in ON_CLUSTERS and not from_here:
                        self.assertTrue((ROOT / words[0]).exists() or shutil.which(words[0]))

    def test_the_package_is_found_as_is_shown(self):
        tested = re.findall(r"find_package\(linkwright[^)]*\)|linkwright::linkwright", text_of("tests/package/CMakeLists.txt"))
        for block in all_blocks("cmake"):
            for used in re.findall(r"find_package\(linkwright[^)]*\)|linkwright::linkwright", block):
                self.assertIn(used, tested)

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
        folders = {path.name for base in ("include/linkwright", "src") for path in (ROOT / base).iterdir() if path.is_dir()}
        self.assertEqual(claimed, folders)


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
