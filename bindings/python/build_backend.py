"""Makes the wheel of `linkwright`: CMake builds and lays out, this packs (PEP 517; needs Debian's python3-wheel).

    /usr/bin/python3 -m pip install --no-build-isolation .
    /usr/bin/python3 -m pip install --no-build-isolation --config-settings build-dir=build/release .   # where that is built
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from pathlib import Path

from wheel.wheelfile import WheelFile

TREE = Path(__file__).parents[2]
PROJECT = tomllib.loads((TREE / "pyproject.toml").read_text())["project"]


def build_wheel(wheel_directory: str, config_settings: dict | None = None, metadata_directory: str | None = None) -> str:
    build = TREE / (config_settings or {}).get("build-dir", "build/wheel")
    _run_cmake(build)
    with tempfile.TemporaryDirectory() as staged:
        _cmake("--install", build, "--component", "python", "--prefix", staged, "--strip")
        version = _version(build)
        _write_metadata(Path(staged) / f"linkwright-{version}.dist-info", version)
        name = f"linkwright-{version}-{_tag()}.whl"
        with WheelFile(Path(wheel_directory) / name, "w") as wheel:
            wheel.write_files(staged)
    return name


def build_sdist(sdist_directory: str, config_settings: dict | None = None) -> str:
    raise NotImplementedError("there are no source packages: install from a checkout")


def _run_cmake(build: Path) -> None:
    if not (build / "CMakeCache.txt").exists():
        switches = {"LINKWRIGHT_PYTHON": "ON", "LINKWRIGHT_BUILD_CLI": "OFF", "LINKWRIGHT_BUILD_TESTS": "OFF"}
        switches |= {"CMAKE_BUILD_TYPE": "Release", "LINKWRIGHT_INSTALL": "OFF", "Python_EXECUTABLE": sys.executable}
        _cmake("-G", "Ninja", "-S", TREE, "-B", build, *(f"-D{name}={value}" for name, value in switches.items()))
    _cmake("--build", build, "--parallel", str(os.cpu_count() or 1), "--target", "linkwright_python")


def _cmake(*words: object) -> None:
    if not shutil.which("cmake"):
        sys.exit("cmake is missing: run script/bootstrap first")
    subprocess.run(["cmake", *map(str, words)], check=True)


def _version(build: Path) -> str:
    """CMakeLists.txt is where it stands."""
    for line in (build / "CMakeCache.txt").read_text().splitlines():
        if line.startswith("CMAKE_PROJECT_VERSION:"):
            return line.partition("=")[2]
    sys.exit(f"{build} is not configured")


def _tag() -> str:
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def _write_metadata(folder: Path, version: str) -> None:
    folder.mkdir()
    lines = ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {version}"]
    lines += [f"Summary: {PROJECT['description']}", f"License: {PROJECT['license']['text']}"]
    lines += [f"Requires-Python: {PROJECT['requires-python']}"]
    lines += [f"Requires-Dist: {package}" for package in PROJECT["dependencies"]]
    for extra, packages in PROJECT["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {package} ; extra == "{extra}"' for package in packages)]
    (folder / "METADATA").write_text("\n".join(lines) + "\n")
    told = f"Wheel-Version: 1.0\nGenerator: linkwright\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    (folder / "WHEEL").write_text(told)
    shutil.copy(TREE / "LICENSE", folder / "LICENSE")
