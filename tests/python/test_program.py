"""The same numbers and the same sentences as the program."""

from __future__ import annotations

import base64
import csv
import io
import json
import re
from pathlib import Path

import numpy as np
import pytest

import linkwright as lw
from conftest import EXAMPLES, TREE, problem_of, run, solved

NAMES = sorted(path.stem for path in EXAMPLES.glob("*.json"))


def uncommented(path: Path) -> dict:
    return json.loads(re.sub(r"//.*", "", path.read_text()))


@pytest.mark.parametrize("name", NAMES)
def test_result_is_that_of_the_program(name: str, tmp_path: Path) -> None:
    file = tmp_path / "result.json"
    done = run("solve", EXAMPLES / f"{name}.json", "--samples", 100, "-o", file)
    assert done.returncode == 0, done.stderr
    assert solved(name, 100).export() == file.read_text()


@pytest.mark.parametrize("name", ["tailgate", "tailgate_as_made", "straight_stage", "folding_wing", "loader_bucket_chain"])
def test_region_is_that_of_the_program(name: str, tmp_path: Path) -> None:
    file = tmp_path / "result.json"
    assert run("solve", EXAMPLES / f"{name}.json", "--samples", 60, "--region", "-o", file).returncode == 0
    told, region = json.loads(file.read_text())["region"], solved(name, 60).region
    assert np.frombuffer(base64.b64decode(told["type"]), np.uint8).tobytes() == region.types.tobytes()
    assert np.frombuffer(base64.b64decode(told["defects"]), np.uint8).tobytes() == region.defects.tobytes()
    for key, text in told["properties"].items():
        assert base64.b64decode(text) == region[key].astype("<f4").tobytes(), key
    assert int(region.meets.sum()) == told["meeting_requirements"]


@pytest.mark.parametrize("format", ["svg", "dxf", "csv", "json"])
def test_exports_are_those_of_the_program(format: str, tailgate: lw.Answer, result_file: Path, tmp_path: Path) -> None:
    written = tmp_path / f"hinge.{format}"
    tailgate.linkages[1].save(written)
    assert written.read_text() == run("export", result_file, "--linkage", 2, "--format", format).stdout


@pytest.mark.parametrize("format", ["stl", "3mf", "plates", "step", "mjcf", "sdf", "urdf"])
@pytest.mark.filterwarnings("ignore:the plates are free of collisions")
def test_machines_are_those_of_the_program(format: str, tailgate: lw.Answer, result_file: Path, tmp_path: Path) -> None:
    written, theirs = tmp_path / f"hinge.{format}", tmp_path / "theirs"
    tailgate.linkages[1].save(written, pin=7, clearance=0.25)
    sizes = ("--pin", 7, "--clearance", 0.25)
    assert run("export", result_file, "--linkage", 2, "--format", format, *sizes, "-o", theirs).returncode == 0
    if format == "step":  # it tells the time of writing
        assert len(written.read_bytes()) == len(theirs.read_bytes())
    else:
        assert written.read_bytes() == theirs.read_bytes()


def test_mistakes_of_machines(tailgate: lw.Answer, tmp_path: Path) -> None:
    linkage = tailgate.linkages[0]
    with pytest.raises(lw.ProblemError, match="narrower than"):
        linkage.build("stl", pin=500)
    with pytest.raises(lw.ProblemError, match="does not get to a position 9"):
        linkage.build("step", position=9)
    with pytest.raises(ValueError, match="'hight' is not a size"):
        linkage.build("stl", hight=3)
    with pytest.raises(ValueError, match="'obj' is not a format"):
        linkage.build("obj")
    for wrong in (-1, float("nan"), float("inf")):
        with pytest.raises(lw.ProblemError):
            linkage.build("stl", width=wrong)


@pytest.mark.parametrize("name", ["tailgate", "folding_wing", "loader_bucket_chain", "straight_stage"])
def test_motion_is_the_table_of_the_program(name: str) -> None:
    linkage = solved(name, 100).linkages[0]
    rows = list(csv.DictReader(io.StringIO(linkage.export("csv"))))
    motion = linkage.motion()
    assert motion.dtype.names == tuple(rows[0]) and len(motion) == len(rows)
    for row, state in zip(rows, motion):
        for key, text in row.items():
            told = float(text) if text else (0 if key == "position" else np.nan)
            assert np.array_equal(told, state[key], equal_nan=True), key


def test_analysis_is_that_of_the_program(tailgate: lw.Answer, tmp_path: Path) -> None:
    tailgate.linkages[0].save(tmp_path / "hinge.json")
    told = json.loads(run("analyze", tmp_path / "hinge.json", "-o", "-").stdout)
    found = tailgate.linkages[0].analyze()
    assert list(found) == list(told)
    assert found.type == told["type"] and found.pivots.keys() == told["pivots"].keys()
    assert np.array_equal(found.motion["output_rate"], np.array(told["motion"]["output_rate"], float), equal_nan=True)


def test_instant_is_that_of_the_program(tmp_path: Path) -> None:
    file = TREE / "examples/linkages/crank_rocker.json"
    words = ["analyze", file, "--instant", "--input-deg", 240, "--point", "0.5,2.5", "-o", "-"]
    told = json.loads(run(*words).stdout)["instant"]
    found = lw.Linkage.read(file).instant((0.5, 2.5), input_deg=240)
    assert list(found) == list(told)
    assert found.pole.tolist() == told["pole"] and found.cubic == told["cubic"]
    assert found._repr_svg_().startswith("<svg") or "<svg" in found._repr_svg_()


def test_loads_are_those_of_the_program(tmp_path: Path) -> None:
    answer = solved("tailgate_struts", 80)
    answer.save(tmp_path / "struts.json")
    told = json.loads(run("loads", tmp_path / "struts.json", "-o", "-").stdout)["report"]
    found = answer.loads()
    curves = found["curves"]
    assert found["cases"][2]["max_close_force"] == told["cases"][2]["max_close_force"]
    assert found["worst"] == answer.linkages[0]["loads"]["worst"]
    assert list(curves) == [case["name"] for case in told["cases"]]
    assert curves["cold"]["open_N"].shape == (73,)
    assert -curves["cold"]["open_N"][-1] == pytest.approx(told["cases"][1]["hold_open"], abs=1e-9)
    assert "<svg" in found._repr_svg_()
    assert list(answer.loads(answer.linkages[0], case="hot")["curves"]) == ["hot"]
    with pytest.raises(lw.ProblemError, match="warm"):
        answer.loads(case="warm")
    real = answer.loads(free_share=0.5)["balance"]["real_springs"]
    assert real["free_share"] == 0.5
    assert real["one"]["residual_hand_force"] < real["hand_force_without"]


def test_loads_in_motion_are_told_in_time() -> None:
    problem = uncommented(EXAMPLES / "tailgate_struts.json")
    problem |= {"requirements": {"min_transmission_angle_deg": 30}, "options": {"region_samples": 60}}
    problem["loads"] |= {"drive": "input", "motion": {"table": [[0, 0], [0.6, 0.4], [1.5, 1]]}}
    found = lw.solve(problem).loads()
    room = found["curves"]["room"]
    assert room["time_s"][[0, -1]] == pytest.approx([0, 1.5])
    assert np.all(np.diff(room["time_s"]) > 0)
    shaking = np.hypot(room["shaking.x_N"], room["shaking.y_N"])
    assert shaking.max() <= found["cases"][0]["shaking"]["max"] * (1 + 1e-9)
    assert found["worst"]["max_torque"]["value"] >= np.abs(room["torque_Nm"]).max() * (1 - 1e-9)


def test_springs_are_placed_as_the_program_places_them(tmp_path: Path) -> None:
    answer = solved("tailgate_struts", 80)
    answer.save(tmp_path / "struts.json")
    file = TREE / "examples/springs/tailgate_boxes.json"
    boxes = json.loads(file.read_text())
    run("loads", tmp_path / "struts.json", "--place-springs", file, "-o", tmp_path / "placed.json")
    told = json.loads((tmp_path / "placed.json").read_text())
    placed = answer.place_spring(boxes)
    assert placed.proven and placed.lower_bound == told["lower_bound"] < placed.max_hand_force == told["max_hand_force"]
    boxes["max_F1"] = -1
    with pytest.raises(lw.ProblemError, match="max_F1"):
        answer.place_spring(boxes)


def test_tolerance_is_that_of_the_program(tmp_path: Path) -> None:
    answer = solved("tailgate_as_made", 60)
    answer.save(tmp_path / "made.json")
    words = ["tolerance", tmp_path / "made.json", "--linkage", 2, "--samples", 2000, "--seed", 3, "-o", "-"]
    told = json.loads(run(*words).stdout)["tolerance"]
    found = answer.tolerance(answer.linkages[1], samples=2000, seed=3)
    assert found["yield"] == told["yield"] and found.error == told["error"]
    assert [share["share"] for share in found.sensitivities] == [share["share"] for share in told["sensitivities"]]


@pytest.mark.parametrize(
    "command, flags, ours",
    [
        ("convert", ["--euler", "zxz", "40,50,35"], lambda: lw.attitude.convert({"euler_deg": [40, 50, 35], "sequence": "zxz"})),
        ("screw", "part_transfer.json", lambda: lw.attitude.screw(uncommented(EXAMPLES / "attitude/part_transfer.json")["displacement"])),
    ],
)
def test_attitude_is_that_of_the_program(command: str, flags: object, ours: object, tmp_path: Path) -> None:
    words = flags if isinstance(flags, list) else [EXAMPLES / "attitude" / str(flags)]
    done = run("attitude", command, *words, "-o", "-")
    told, found = json.loads(done.stdout), ours()
    assert found.matrix.tolist() == told["matrix"] and found.quaternion.tolist() == told["quaternion"]
    assert "<svg" in found._repr_svg_()


def test_pictures_are_those_of_the_program(tmp_path: Path) -> None:
    assert run("solve", EXAMPLES / "nose_gear.json", "--svg", tmp_path / "a.svg").returncode == 0
    solved("nose_gear").save(tmp_path / "b.svg")
    assert (tmp_path / "a.svg").read_text() == (tmp_path / "b.svg").read_text() == solved("nose_gear")._repr_svg_()


def test_every_bad_problem_is_refused_in_the_program_s_words() -> None:
    folder = TREE / "data/bad_problems"
    expected = json.loads((folder / "expected.json").read_text())["files"]
    for name, mistakes in expected.items():
        with pytest.raises(lw.ProblemError) as caught:
            lw.solve(folder / name, samples=8)
        found = caught.value.mistakes
        assert len(found) == len(mistakes), name
        for one, (where, part) in zip(found, mistakes):
            assert one.where == where and part in one.message and one.code, name


@pytest.mark.parametrize("name", ["many_mistakes", "repeated_pose", "not_json"])
def test_the_message_is_what_the_program_prints(name: str) -> None:
    file = TREE / f"data/bad_problems/{name}.json"
    with pytest.raises(lw.ProblemError) as caught:
        lw.solve(file)
    assert str(caught.value) + "\n" == run("solve", file).stderr


def test_problem_is_read_with_its_defaults() -> None:
    told = problem_of("tailgate")
    assert told["options"]["region_samples"] == 400 and len(told["task"]["poses"]) == 4
