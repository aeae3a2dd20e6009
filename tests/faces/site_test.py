"""What the site is made with: pages of schemas, of headers, of docstrings; links into the workbench; the policy of a page."""

import base64
import hashlib
import json
import sys
import types
import unittest
import zlib

from face_support import ROOT, load

sys.path.insert(0, str(ROOT / "site"))
import build  # noqa: E402
import content_policy  # noqa: E402
import python_pages  # noqa: E402
import schema_pages  # noqa: E402
import workbench_links  # noqa: E402


def names_in(schema):
    """Members and definitions anywhere in a schema."""
    for key, value in schema.items() if isinstance(schema, dict) else ():
        if key in ("properties", "$defs"):
            yield from value
            inner = value.values()
        elif key in ("oneOf", "anyOf", "prefixItems"):
            inner = value
        else:
            inner = [value] if key == "items" else []
        for one in inner:
            yield from names_in(one)


class Schemas(unittest.TestCase):
    def test_pages_have_every_definition_and_every_member(self):
        for path in (ROOT / "schema").glob("*.json"):
            page = schema_pages.page(path)
            missing = {name for name in names_in(load(path)) if name not in page}
            self.assertEqual(missing, set(), path.name)

    def test_every_schema_has_a_page(self):
        self.assertEqual({path.name.partition(".")[0] for path in (ROOT / "schema").glob("*.json")}, set(build.SCHEMAS))

    def test_values_are_said_in_words(self):
        for schema, words in (
            ({"type": "number", "exclusiveMinimum": 0}, "number, > 0"),
            ({"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/$defs/point"}}, "list of 2 [point](#point)"),
            ({"type": "array", "minItems": 1, "items": {"type": "string"}}, "list of 1 or more string"),
            ({"enum": ["ccw", "cw"]}, '`"ccw"`, `"cw"`'),
            ({"oneOf": [{"const": None}, {"type": "boolean"}]}, "`null` or boolean"),
            ({"$ref": "problem.schema.json#/$defs/task"}, "[task](problem.md#task)"),
        ):
            self.assertEqual(schema_pages.type_of(schema), words)


class Links(unittest.TestCase):
    def test_hold_the_whole_problem(self):
        for path in build.example_files():
            problem = workbench_links.problem_of(path.read_text(encoding="utf-8"))
            version, check_sum, data = workbench_links.fragment_of(problem).split(".")
            self.assertEqual((version, int(check_sum, 16)), ("#1", zlib.crc32(data.encode())))
            packed = base64.urlsafe_b64decode(data + "=" * (-len(data) % 4))
            self.assertEqual(json.loads(zlib.decompress(packed, -zlib.MAX_WBITS)), problem)

    def test_are_made_of_problems_alone(self):
        for text in ("", "[1]", '{"lengths": {}}', "no JSON"):
            self.assertIsNone(workbench_links.problem_of(text))
        self.assertEqual(workbench_links.problem_of('{"task": "//" // so it is\n}'), {"task": "//"})

    def test_lead_about_the_site(self):
        text = "[a](../planar.md#x) [b](../../include/linkwright/core/angle.hpp) [c](../../src/x.cpp) ![d](s.svg) [e](https://x.y)\n```text\n[a](b.md)\n```"
        self.assertEqual(build.moved(text, "docs/theory/six-bars.md", "theory/six-bars.md"),
                         "[a](../planar.md#x) [b](../cpp/core.md#angle-hpp) c ![d](s.svg) [e](https://x.y)\n```text\n[a](b.md)\n```")
        self.assertEqual(build.moved("[a](docs/glossary.md), [b](examples/tailgate.json)", "README.md", "index.md"),
                         "[a](glossary.md), [b](examples/tailgate.md)")


class Policy(unittest.TestCase):
    def test_allows_the_scripts_of_the_page_and_no_others(self):
        html = '<head><script>let a</script><script type="application/json">{}</script><script src="x.js"></script></head>'
        page = content_policy.with_policy(html)
        digest = base64.b64encode(hashlib.sha256(b"let a").digest()).decode()
        self.assertIn(f"script-src 'self' 'sha256-{digest}';", page)
        self.assertEqual(page.count("sha256"), 1)
        self.assertIn("default-src 'none'", page)


class Docstrings(unittest.TestCase):
    def test_are_laid_out(self):
        def solve(problem, *, samples: "int | None" = None) -> "Answer":
            """All of them, as :class:`Answer`.

            Args:
                problem: a ``dict``,
                    or a file.
                samples: N.
            """

        page = "\n".join(python_pages.shown("solve", solve))
        self.assertIn("solve(problem, *, samples: int | None = None) -> Answer", page)
        self.assertIn("All of them, as `Answer`.", page)
        self.assertIn("- `problem`: a `dict`,\n  or a file.\n- `samples`: N.", page)

    def test_are_those_of_the_module_alone(self):
        module = types.ModuleType("linkwright.some")
        module.foreign = json.dumps
        self.assertEqual(list(python_pages.members_of(module)), [])

    def test_without_a_module_the_page_says_so(self):
        self.assertIn("was not built", python_pages.page(None))


if __name__ == "__main__":
    unittest.main()
