"""Linkages compared with points and poses, against the program and against geometry alone."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import linkwright as lw
from conftest import EXAMPLES, problem_of, run

BARS = {"pivots": {"input_center": [0, 0], "input_circle": [1, 0], "output_center": [4, 0], "output_circle": [3, 2.5]}}
POSES = np.array([(1, 1, 0), (0.9, 1.3, 3), (0.7, 1.6, 8)])


def poses_of(name: str) -> np.ndarray:
    return np.array([(pose["x"], pose["y"], pose["theta_deg"]) for pose in problem_of(name)["task"]["poses"]])


def test_poses_are_compared_as_the_program_does(tmp_path: Path) -> None:
    linkage = lw.Linkage.read({**BARS, "poses": [{"x": 1, "y": 1, "theta_deg": 0}]})
    told = linkage.compare(POSES)
    table, file, out = (tmp_path / name for name in ("poses.csv", "linkage.json", "out.json"))
    table.write_text("x,y,theta_deg\n" + "".join(f"{x},{y},{theta}\n" for x, y, theta in POSES))
    file.write_text(linkage.export("json"))
    assert run("analyze", file, "--compare", table, "-o", out).returncode == 0
    written = json.loads(out.read_text())["pose_comparison"]
    by_flag = lw.Linkage.read(BARS).compare(POSES.tolist(), body=(1, 1, 0))
    assert told["error"] == written["error"] == by_flag["error"]
    assert told["in_order"] == written["in_order"]
    assert "<svg" in (told._repr_svg_() or "")
    for one, other in zip(told["at"], written["at"], strict=True):
        assert np.array_equal(one["place"], other["place"]) and one["angle_deg"] == other["angle_deg"]
    assert told["turning_length"] != 2 and linkage.compare(POSES, turning_length=2)["turning_length"] == 2


@pytest.mark.parametrize("name", ["hatch_all_near", "tailgate"])
def test_linkages_of_an_answer_come_back(name: str) -> None:
    answer = lw.solve(EXAMPLES / f"{name}.json", samples=40)
    best, poses = answer.linkages[0], poses_of(name)
    length = answer.problem["task"].get("turning_length")
    told = best.compare(poses, turning_length=length)
    assert len(told["at"]) == len(poses)
    if name == "tailgate":
        assert told["error"]["rms"] < 1e-6
    elif length is not None:
        assert told["error"]["rms"] == pytest.approx(best["near"]["error"]["rms"], rel=1e-6)


def test_what_does_not_go_together_is_told() -> None:
    linkage = lw.Linkage.read(BARS)
    with pytest.raises(lw.ProblemError, match="where the body is"):
        linkage.compare(POSES)
    with pytest.raises(lw.ProblemError, match="no coupler|no point of the coupler"):
        linkage.compare(POSES[:, :2])
    assert linkage.compare(POSES[:, :2], point=(1, 1))["closed"] is False
    with pytest.raises(ValueError, match="go with points"):
        linkage.compare(POSES, closed=True, body=(1, 1, 0))
    with pytest.raises(ValueError, match="go with poses"):
        linkage.compare(POSES[:, :2], body=(1, 1, 0))
    for wrong in (POSES[:2], np.zeros((4, 3)), POSES * np.nan, np.zeros((0, 3))):
        with pytest.raises(lw.ProblemError):
            linkage.compare(wrong, body=(1, 1, 0))
    with pytest.raises(lw.ProblemError):
        linkage.compare(POSES, body=(1, 1, 0), turning_length=0)
    with pytest.raises(lw.ProblemError, match="finite numbers"):
        linkage.compare(POSES, body=(1, np.inf, 0))
    with pytest.raises(ValueError):
        linkage.compare(POSES, body=(1, 1))
    with pytest.raises(ValueError):
        linkage.compare([(1, 1, 0), (1, 2), (2, 2, 5)])
    wrist = lw.Linkage.read({"mechanism": "spherical_four_bar", "angles_deg": {"ground": 80, "input": 30, "coupler": 70, "output": 75}})
    with pytest.raises(lw.ProblemError, match="planar four-bars"):
        wrist.compare(POSES, body=(1, 1, 0))
