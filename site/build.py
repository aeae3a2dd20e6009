#!/usr/bin/python3
"""Writes the sources of the site into build/site-source: the documents of the tree with links that lead about the site, a
page to each example with the program's picture and a link into the workbench, and pages made of schemas, headers and
docstrings. usage: site/build.py PROGRAM (script/site does it, and what follows)"""

import json
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import cpp_pages
import python_pages
import schema_pages
from workbench_links import open_link, problem_of

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "build/site-source"
PAGES = SOURCE / "pages"
DOCUMENTS = {  # of the tree, by their place on the site
    "README.md": "index.md", "README.zh-CN.md": "zh.md", "CHANGELOG.md": "changelog.md", "CONTRIBUTING.md": "contributing.md",
    "examples/README.md": "examples/index.md", "data/README.md": "data.md", "bench/README.md": "bench.md", "LICENSE": "LICENSE.txt",
}
START_PAGES = {"index.md": "Open the workbench", "zh.md": "打开工作台"}
SCHEMAS = {"problem": "Problem files", "result": "Result files", "analysis": "Analysis files", "attitude": "Attitude files", "sweep": "Sweep files",
           "spring_boxes": "Boxes of springs", "spring_catalogue": "Catalogues of springs"}
FENCE = re.compile(r"^(```.*?^```[ ]*$)", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")


def title_of(text):
    return re.search(r"^# (.+)$", text, re.MULTILINE)[1]


def example_files():
    return sorted((ROOT / "examples").glob("*.json"))


def place_of(path):
    """Where a file of the tree is on the site; None where it is not."""
    if path in DOCUMENTS:
        return DOCUMENTS[path]
    folder, _, name = path.rpartition("/")
    if folder == "examples" and name.endswith(".json"):
        return f"examples/{name.removesuffix('.json')}.md"
    if folder == "schema":
        return f"formats/{name.removesuffix('.schema.json')}.md"
    if folder == "docs" or folder.startswith("docs/"):
        return path.removeprefix("docs/")
    if folder.startswith("include/linkwright/") and name.endswith(".hpp"):
        return f"cpp/{folder.removeprefix('include/linkwright/')}.md#{cpp_pages.anchor_of(name)}"
    return None


def relative(target, page):
    return os.path.relpath(target, os.path.dirname(page) or ".")


def moved_link(match, path, page):
    """A link of the document at `path`, as it has to be on `page`; its words alone where the target is not on the site."""
    picture, words, target = match.groups()
    if re.match(r"[a-z]+:|#", target):
        return match[0]
    file, _, part = target.partition("#")
    place = place_of(os.path.normpath(os.path.join(os.path.dirname(path), file)))
    if place is None:
        return words
    link = f"{picture}[{words}]({relative(place, page)}{'#' + part if part else ''})"
    return link + opened_example(file, page) if not picture else link


def opened_example(file, page):
    """In the table of the examples, beside each its way into the workbench."""
    if page != "examples/index.md" or not file.endswith(".json"):
        return ""
    problem = problem_of((ROOT / "examples" / file).read_text(encoding="utf-8"))
    return " " + open_link(problem, "../", "open") if problem else ""


def opened_block(block, page):
    """A problem that a document shows can be opened below it."""
    problem = problem_of(block.partition("\n")[2].rpartition("\n")[0]) if block.startswith("```json") else None
    to_root = "../" * page.count("/")
    return f"{block}\n\n{open_link(problem, to_root, '在工作台中打开' if 'zh' in page else 'Open in the workbench')}\n" if problem else block


def moved(text, path, page):
    """The document's text on its page: links outside of code lead about the site, problems can be opened."""
    parts = FENCE.split(text)
    for i, part in enumerate(parts):
        parts[i] = opened_block(part, page) if i % 2 else LINK.sub(lambda match: moved_link(match, path, page), part)
    return "".join(parts)


def with_workbench(text, words):
    """A start page, with the way into the workbench below its title."""
    title, _, rest = text.partition("\n")
    return f'{title}\n\n<a class="open-in-workbench" href="workbench/index.html">{words}</a>\n{rest}'


def write(page, text):
    path = PAGES / page
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def write_documents():
    for path in ROOT.glob("docs/**/*"):
        name = path.relative_to(ROOT).as_posix()
        if path.suffix == ".md":
            write(place_of(name), moved(path.read_text(encoding="utf-8"), name, place_of(name)))
        elif path.is_file():
            (PAGES / place_of(name)).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, PAGES / place_of(name))
    for name, page in DOCUMENTS.items():
        text = moved((ROOT / name).read_text(encoding="utf-8"), name, page)
        write(page, with_workbench(text, START_PAGES[page]) if page in START_PAGES else text)


def story_of(text):
    """The comment that an example begins with."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("//"):
            break
        lines.append(line.removeprefix("//").strip())
    return " ".join(lines)


def draw(program, path):
    """The program's picture of the example's answer."""
    picture = PAGES / f"examples/{path.stem}.svg"
    subprocess.run([program, "solve", path, "--svg", picture], check=True, stdout=subprocess.DEVNULL, timeout=300)
    return picture


def write_example(program, path):
    text = path.read_text(encoding="utf-8")
    problem = problem_of(text)
    draw(program, path)
    shutil.copy(path, PAGES / "examples" / path.name)
    write(f"examples/{path.stem}.md", "\n\n".join([
        f"# {problem['title']}", story_of(text), open_link(problem, "../"), f"![{problem['title']}: the answer]({path.stem}.svg)",
        f"```console\n$ linkwright solve examples/{path.name} --svg {path.stem}.svg\n```",
        f"The file, [{path.name}]({path.name}):\n\n```js\n{text}```\n"]))


def write_examples(program):
    (PAGES / "examples").mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda path: write_example(program, path), example_files()))


def write_references():
    for name in SCHEMAS:
        schema = ROOT / f"schema/{name}.schema.json"
        write(f"formats/{name}.md", schema_pages.page(schema))
        shutil.copy(schema, PAGES / "formats")
    for folder, text in cpp_pages.pages(SOURCE / "doxygen/xml").items():
        write(f"cpp/{folder}.md", text)
    write("python.md", python_pages.page(python_pages.folder_of_module(ROOT / "build")))


def pages_of(folder, titled=lambda text, _: title_of(text)):
    found = sorted((PAGES / folder).glob("*.md"))
    return [{titled(path.read_text(encoding="utf-8"), path.stem): f"{folder}/{path.name}"} for path in found if path.stem != "index"]


def tutorials(language):
    order = ("tailgate", "wrist", "crane", "mixer", "spoon")
    return [f"tutorials/{name}{language}.md" for name in order if (PAGES / f"tutorials/{name}{language}.md").exists()]


def navigation():
    developers = ["architecture.md", {"The workbench": "workbench.md"}, "new_kind.md", "performance.md", "book_map.md",
                  "contributing.md", "changelog.md", {"Worked examples": "data.md"}, {"Benchmarks": "bench.md"}]
    return [
        {"Start": "index.md"}, {"Tutorials": tutorials("")}, {"Examples": ["examples/index.md", *pages_of("examples")]},
        {"Theory": pages_of("theory")}, {"Sweeps": ["sweeps.md", {"Atlases": "atlas.md"}]}, {"Glossary": "glossary.md"},
        {"File formats": [{words: f"formats/{name}.md"} for name, words in SCHEMAS.items()]},
        {"Python": "python.md"}, {"C++": pages_of("cpp", lambda _, name: name)}, {"Development": developers},
        {"中文": [{"说明": "zh.md"}, *tutorials(".zh-CN")]},
    ]


def main(program):
    shutil.rmtree(PAGES, ignore_errors=True)
    write_documents()
    write_examples(program)
    write_references()
    for name in ("site/site.css", "web/public/icon.svg"):
        shutil.copy(ROOT / name, PAGES)
    settings = {"INHERIT": "../../site/mkdocs.yml", "docs_dir": "pages", "site_dir": "../site", "nav": navigation()}
    (SOURCE / "mkdocs.yml").write_text(json.dumps(settings, ensure_ascii=False), encoding="utf-8")  # JSON is YAML


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
