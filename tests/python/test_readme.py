"""The Python that the README shows, run."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from conftest import TREE


@pytest.mark.parametrize("name", ["README.md", "README.zh-CN.md"])
def test_shown_code_runs(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture) -> None:
    shown = re.findall(r"^```python\n(.*?)^```", (TREE / name).read_text(), re.MULTILINE | re.DOTALL)
    assert shown
    monkeypatch.chdir(tmp_path)
    for code in shown:
        exec(compile(code, name, "exec"), {})
    assert "All four-bars that pass through all poses: 159 600" in capsys.readouterr().out
    assert (tmp_path / "hinge.png").stat().st_size > 10_000
