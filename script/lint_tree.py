#!/usr/bin/python3
"""Checks the rules of the tree; one line per violation, exit status 1 if there is any.

1. Who may include whom: a folder of the library includes only itself and the ranks below its own.
2. Public headers include only public headers and the standard library.
3. include/linkwright/<folder>/<noun>.hpp has its tests in tests/<folder>/<noun>_test.cpp.
4. Files are named snake_case; in web/src the components (.svelte) UpperCamel.
5. In the library and what is bound to it a dependency stays behind one door: Eigen in src/algebra/dense.cpp, nlohmann in
   src/files/json.
6. Nobody casts to find out what kind a family or an answer is: there is no dynamic_cast.
7. linkwright/linkwright.hpp includes every public header that the programs and the Python module include.

usage: lint_tree.py [--self-test]
"""

import re
import sys
import tempfile
from pathlib import Path

# From the bottom up; folders of one rank do not include each other. The faces (apps, bindings) stand above all.
RANKS = (
    ("core",),
    ("algebra",),
    ("attitude",),
    ("mechanism",),
    ("region",),
    ("fields",),
    ("function", "approximate"),
    ("planar", "spherical", "infinitesimal", "robust", "loads"),
    ("straight_line",),
    ("synthesis",),
    ("solve",),
    ("files",),
    ("drawing",),
    ("kinds", "analyses"),
    ("machine",),
    ("sweep",),
)
RANK_OF = {folder: rank for rank, folders in enumerate(RANKS) for folder in folders}
NAMED = ("include", "src", "apps", "bindings", "tests", "bench", "fuzz", "web/src", "web/tests", "web/e2e", "web/site")
FILE_NAME = re.compile(r"[a-z0-9_]+(\.(test|dom\.test|spec|svelte|d))?\.(cpp|hpp|py|ts)$|[A-Z][A-Za-z0-9]*\.svelte$")
PUBLIC = Path("include/linkwright")
PRIVATE = Path("src")
WHOLE = PUBLIC / "linkwright.hpp"
FACES = ("apps", "bindings/python")
CODE = ("include", "src", "apps", "bindings")
BEHIND_DOORS = ("src", "bindings")
CAST = re.compile(r"\bdynamic_(pointer_)?cast\b")
DOORS = {"Eigen": "src/algebra/dense.cpp", "nlohmann": "src/files/json/"}  # what is long to compile, and who includes it
# What visits tasks and answers sees all kinds, and what asks for analyses all of them, wherever it stands.
VISITED = ("kinds/kinds.hpp", "analyses/analyses.hpp")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def includes_of(file):
    """(line number, is quoted, path) of every #include of the file."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] == '"', match[2]


def order_problem(folder, kind, included):
    """What is wrong with `included` in a file of `folder` and there of a kind; None if nothing is."""
    if included in VISITED and RANK_OF["synthesis"] <= RANK_OF[folder] < RANK_OF["kinds"]:
        return None
    if folder == "kinds" and included == "analyses/analyses.hpp":
        return None
    parts = included.removeprefix("linkwright/").split("/")
    if ".." in parts:
        return f'"{included}": write the path from include/ or src/, without ..'
    if len(parts) == 1:
        return None  # a neighbour in the same folder
    other = parts[0]
    if other == folder == "kinds" and kind not in ("kinds.hpp", parts[1]):
        return f'"{included}": a kind does not include another; what two need stands below them'
    if other not in RANK_OF:
        return f'"{included}": no folder of the library is called {other}'
    if other == folder or RANK_OF[other] < RANK_OF[folder]:
        return None
    relation = "stands beside" if RANK_OF[other] == RANK_OF[folder] else "stands above"
    return f'"{included}": {folder} may not include {other}, which {relation} it'


def public_header_problem(quoted, included):
    """What is wrong with `included` in a public header; None if nothing is."""
    if included.startswith("linkwright/"):
        return None
    if quoted:
        return f'"{included}": a public header includes other public headers as "linkwright/…"'
    if "/" in included or "." in included:
        return f"<{included}>: a public header needs nothing but the standard library"
    return None


def file_violations(root, base, file):
    folder, kind = (*file.relative_to(root / base).parts, "")[:2]
    place = file.relative_to(root)
    if folder not in RANK_OF:
        yield f"{place}: the library has no folder {folder}; its folders and their order are in script/lint_tree.py"
        return
    for number, quoted, included in includes_of(file):
        problem = public_header_problem(quoted, included) if base == PUBLIC else None
        if not problem and (quoted or included.startswith("linkwright/")):
            problem = order_problem(folder, kind, included)
        if problem:
            yield f"{place}:{number}: {problem}"


def include_violations(root):
    for base in (PUBLIC, PRIVATE):
        for file in sorted((root / base).rglob("*.[ch]pp")):
            if file != root / WHOLE:
                yield from file_violations(root, base, file)


def whole_violations(root):
    has = {included for _, _, included in includes_of(root / WHOLE)} if (root / WHOLE).exists() else None
    for face in FACES if has is not None else ():
        for file in sorted((root / face).rglob("*.[ch]pp")):
            for number, _, included in includes_of(file):
                if included.startswith("linkwright/") and included not in has | {"linkwright/linkwright.hpp"}:
                    yield f'{file.relative_to(root)}:{number}: "{included}" is missing in {WHOLE}'


def door_violations(root):
    for folder in BEHIND_DOORS:
        for file in sorted((root / folder).rglob("*.[ch]pp")):
            place = file.relative_to(root).as_posix()
            for number, _, included in includes_of(file):
                door = DOORS.get(included.split("/")[0])
                if door and not place.startswith(door):
                    yield f"{place}:{number}: <{included}>: {door} alone includes it; what is missing there is added there"


def cast_violations(root):
    for folder in CODE:
        for file in sorted((root / folder).rglob("*.[ch]pp")):
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), start=1):
                if CAST.search(line):
                    yield f"{file.relative_to(root)}:{number}: no cast to find out a kind: give its base a virtual function"


def test_violations(root):
    for header in sorted((root / PUBLIC).rglob("*/*.hpp")):
        noun = header.relative_to(root / PUBLIC)
        test = Path("tests") / noun.with_name(noun.stem + "_test.cpp")
        if not (root / test).exists():
            yield f"{header.relative_to(root)}: has no {test}"


def name_violations(root):
    kinds = {".cpp", ".hpp", ".py", ".ts", ".svelte"}
    for folder in NAMED:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in kinds and file.name != "vite-env.d.ts" and not FILE_NAME.match(file.name):
                yield f"{file.relative_to(root)}: files are named snake_case, components of the page (.svelte) UpperCamel"


def violations(root):
    return [*include_violations(root), *door_violations(root), *whole_violations(root), *cast_violations(root), *test_violations(root), *name_violations(root)]


def self_test():
    """Each case: files of a tree, and a piece of every message that it must draw, in order."""
    header = "include/linkwright/{}.hpp"
    tested = {header.format("core/angle"): "#pragma once\n#include <cmath>\n", "tests/core/angle_test.cpp": ""}
    cases = [
        (tested, []),
        ({header.format("core/angle"): ""}, ["has no tests/core/angle_test.cpp"]),
        ({"src/planar/a.cpp": '#include "linkwright/core/angle.hpp"\n#include "b.hpp"\n#include <vector>\n'}, []),
        ({"src/algebra/dense.cpp": "#include <Eigen/Core>\n"}, []),
        ({"src/algebra/dense.hpp": "#include <Eigen/Core>\n"}, ["dense.hpp:1: <Eigen/Core>: src/algebra/dense.cpp alone"]),
        ({"src/files/json/json.hpp": "#include <nlohmann/json.hpp>\n"}, []),
        ({"bindings/wasm/reply.cpp": "#include <nlohmann/json.hpp>\n"}, ["reply.cpp:1: <nlohmann/json.hpp>: src/files/json/ alone"]),
        ({"apps/cli/flags.cpp": "#include <nlohmann/json.hpp>\n"}, []),
        ({"src/kinds/four_bar/x.cpp": '#include "analyses/analyses.hpp"\n'}, []),
        ({"src/kinds/four_bar/x.cpp": '#include "analyses/tolerances/y.hpp"\n'}, ["kinds may not include analyses"]),
        ({"src/planar/a.cpp": '#include "region/kernel.hpp"\n#include "planar/b.hpp"\n'}, []),
        ({"src/region/a.cpp": '\n #  include "linkwright/planar/b.hpp"\n'}, ["src/region/a.cpp:2: ", "stands above"]),
        ({"src/region/a.cpp": "#include <linkwright/planar/b.hpp>\n"}, ["region may not include planar"]),
        ({"src/planar/a.cpp": '#include "spherical/b.hpp"\n'}, ["planar may not include spherical, which stands beside"]),
        ({"src/core/a.cpp": '// #include "files/b.hpp"\n'}, []),
        ({"src/files/a.cpp": '#include "kinds/kinds.hpp"\n'}, []),
        ({"src/planar/a.cpp": '#include "kinds/kinds.hpp"\n'}, ["planar may not include kinds"]),
        ({"src/kinds/kinds.hpp": '#include "kinds/six_bar/a.hpp"\n', "src/kinds/six_bar/a.hpp": '#include "files/b.hpp"\n'}, []),
        ({"src/kinds/six_bar/a.cpp": '#include "kinds/spherical/b.hpp"\n'}, ["a kind does not include another"]),
        ({"src/core/a.cpp": "\nauto* b = dynamic_cast<B*>(a);\n"}, ["src/core/a.cpp:2: no cast"]),
        ({"src/core/a.cpp": '#include "../files/b.hpp"\n'}, ["without .."]),
        ({"src/core/a.cpp": '#include "apps/b.hpp"\n'}, ["no folder of the library is called apps"]),
        ({"src/utils/a.cpp": ""}, ["src/utils/a.cpp: the library has no folder utils"]),
        ({"src/a.cpp": ""}, ["src/a.cpp: the library has no folder a.cpp"]),
        (tested | {header.format("core/angle"): "#include <Eigen/Core>\n"}, ["angle.hpp:1: <Eigen/Core>"]),
        ({"web/src/drawing/snapping.test.ts": "", "web/src/Linkage.svelte": "", "web/src/state/a.svelte.ts": ""}, []),
        ({"web/src/MyModule.ts": "", "web/src/view.svelte": "", "apps/cli/textTable.cpp": ""},
         ["web/src/MyModule.ts: files", "web/src/view.svelte: files", "apps/cli/textTable.cpp: files"]),
        (tested | {header.format("core/angle"): '#include "core/b.hpp"\n'}, ['includes other public headers as']),
        (tested | {header.format("linkwright"): '#include "linkwright/core/angle.hpp"\n',
                   "apps/cli/a.cpp": '#include "linkwright/core/angle.hpp"\n'}, []),
        (tested | {header.format("linkwright"): "", "apps/cli/a.cpp": '#include "linkwright/core/angle.hpp"\n'},
         ['a.cpp:1: "linkwright/core/angle.hpp" is missing in']),
    ]
    failures = 0
    for files, expected in cases:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            found = violations(root)
        if bool(found) != bool(expected) or not all(piece in "\n".join(found) for piece in expected):
            failures += 1
            print(f"self-test: {files}: expected {expected}, found {found}")
    print(f"self-test: {len(cases) - failures} of {len(cases)} cases passed")
    return failures


def main(arguments):
    if arguments == ["--self-test"]:
        return 1 if self_test() else 0
    if arguments:
        print(__doc__, file=sys.stderr)
        return 2
    found = violations(Path(__file__).resolve().parent.parent)
    print("\n".join(found) or "the tree keeps its rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
