"""`pip install` from a checkout, into a folder of its own."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

from conftest import EXAMPLES, TREE

import linkwright as lw


def test_the_wheel_installs_and_works(tmp_path: Path) -> None:
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    made = subprocess.run(
        [*pip, "wheel", "--no-index", "--no-deps", "--no-build-isolation", "--config-settings", "build-dir=build/release",
         "--wheel-dir", str(tmp_path), str(TREE)], capture_output=True, text=True, check=False,
    )
    assert made.returncode == 0, made.stdout + made.stderr
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.name.startswith(f"linkwright-{lw.__version__}-cp")
    names = zipfile.ZipFile(wheel).namelist()
    for name in ("py.typed", "_linkwright.pyi", "plot.py"):
        assert f"linkwright/{name}" in names
    target = tmp_path / "site"
    subprocess.run([*pip, "install", "--no-index", "--no-deps", "--target", str(target), str(wheel)], check=True,
                   capture_output=True)
    program = f"import linkwright as lw; print(lw.__file__, lw.solve({str(EXAMPLES / 'nose_gear.json')!r}).status)"
    environment = os.environ | {"PYTHONPATH": str(target)}
    told = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, env=environment,
                          cwd=tmp_path).stdout
    assert told.startswith(str(target)) and told.endswith("solved\n")
