"""What tests of solved problems share: a problem solved, told in words and drawn, all three looked at."""

import json
import xml.etree.ElementTree

from face_support import FaceTest, run
from schema_test import jsonschema, schemas


class SolveTest(FaceTest):
    def solve(self, problem, *arguments):
        """(result, words, picture) of a problem as an object or a file."""
        path = problem if not isinstance(problem, dict) else self.write("problem.json", problem)
        result, picture = self.folder / "result.json", self.folder / "picture.svg"
        status, words, error = run("solve", path, "-o", result, "--svg", picture, *arguments)
        self.assertEqual((status, error), (0, ""))
        self.assertTrue(all(len(line) <= 100 for line in words.splitlines()), words)
        text = result.read_text(encoding="utf-8")
        self.assertNotRegex(text, r"\b(nan|inf|NaN|Infinity)\b")
        if jsonschema is not None:
            schemas()[1].validate(json.loads(text))
        xml.etree.ElementTree.parse(picture)
        return json.loads(text), " ".join(words.split()), picture.read_text(encoding="utf-8")
