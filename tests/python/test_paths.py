"""Paths: tasks from objects, and what is found, against the program and against geometry alone."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import numpy as np
import pytest

import linkwright as lw
from conftest import TREE, run

DEGENERATE = lw.linkage_types.index("degenerate")
FIVE = [(0, 0), (95, 40), (150, 140), (60, 230), (-70, 190)]
TIMED = [(0, 9.5, 0), (0.1, 3.2, 35), (0.1, -3.3, 70), (0, -9.5, 105)]
PIVOT = {"input": [40, 90]}
WIPER = lw.PathTask([(0, 0), (260, 90), (420, 300)], {"input": [150, -200], "output": [330, -160]})
FORMS = {  # a task of each, and the shape of its map at 40 samples
    "film_claw_timed": (40, 40),
    "thread_takeup_timed_mixed": (40, 40),
    "stirrer_timed_five": (4, 4),
    "dough_mixer_five_points": (40, 40),
    "wiper_pivots_three_points": (40, 40),
    "feeder_three_poses_two_points": (40, 40),
    "tailgate_four_poses_one_point": (40, 6),
    "walking_leg_pivots_five": (1, 24),
}


def of_data(name: str) -> lw.PathTask:
    task = json.loads((TREE / f"data/path/{name}.json").read_text())["task"]
    return lw.PathTask([lw.PathPoint(**point) for point in task["points"]], task.get("given", {}).get("ground_pivots"))


def written(task: lw.PathTask, folder: Path) -> Path:
    file = folder / "problem.json"
    file.write_text(json.dumps({"linkwright": 1, "task": lw.read_problem(task)["task"]}))
    return file


def turned(angle_deg: float, vector: np.ndarray) -> np.ndarray:
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    return np.array([[c, -s], [s, c]]) @ vector


def test_points_of_all_kinds_are_the_same_task() -> None:
    given = {"ground_pivots": PIVOT}
    points = [dict(zip("xy", point)) for point in FIVE]
    results = {
        lw.solve(problem, samples=20).export()
        for problem in (
            lw.PathTask(FIVE, PIVOT),
            lw.PathTask(np.array(FIVE), {"input": np.array([40, 90])}),
            lw.PathTask([lw.PathPoint(*point) for point in FIVE], PIVOT),
            lw.PathTask(points, PIVOT),
            {"kind": "path", "mechanism": "four_bar", "points": points, "given": given},
        )
    }
    assert len(results) == 1
    by_name = [lw.PathPoint(x, y, input_deg=angle) for x, y, angle in TIMED]
    assert lw.solve(lw.PathTask(TIMED), samples=20).export() == lw.solve(lw.PathTask(by_name), samples=20).export()


def test_a_point_has_two_numbers_or_three() -> None:
    with pytest.raises(ValueError, match="not 4 numbers"):
        lw.solve(lw.PathTask([(0, 0, 5, 5)] * 4))


@pytest.mark.parametrize("name", FORMS)
def test_each_form_is_that_of_the_program(name: str, tmp_path: Path) -> None:
    task, file = of_data(name), tmp_path / "result.json"
    assert run("solve", written(task, tmp_path), "--samples", 40, "-o", file).returncode == 0
    answer = lw.solve(task, samples=40)
    assert answer.export() == file.read_text()
    assert answer.region.shape == FORMS[name]
    assert answer.region.counts.defect_free == np.sum((answer.region.defects == 0) & (answer.region.types != DEGENERATE))


@pytest.mark.parametrize("name", FORMS)
def test_the_point_is_where_the_task_wants_it(name: str) -> None:
    """From pivots and angles alone: the crank turned, the coupler turned, and the output as long as it was."""
    task = of_data(name)
    found = lw.solve(lw.Problem(task, requirements={"no_defects": False}), samples=60).linkages
    assert found
    for linkage in found:
        fixed, pin = linkage.pivots["input_fixed"], linkage.pivots["input_moving"]
        end, joint = linkage.pivots["output_fixed"], linkage.pivots["output_moving"]
        size = linkage.lengths.coupler + linkage.lengths.point_to_input
        for point, crank, coupler in zip(task.points, linkage["input_deg_at_points"], linkage["theta_deg_at_points"]):
            here = fixed + turned(crank, pin - fixed)
            np.testing.assert_allclose(here + turned(coupler, linkage["point"] - pin), [point.x, point.y], atol=1e-6 * size)
            length = np.linalg.norm(here + turned(coupler, joint - pin) - end)
            assert length == pytest.approx(linkage.lengths.output, abs=1e-6 * size)
            if point.input_deg is not None and task.points[0].input_deg is not None:
                assert (crank - (point.input_deg - task.points[0].input_deg) + 180) % 360 == pytest.approx(180, abs=1e-6)
            if point.theta_deg is not None and task.points[0].theta_deg is not None:
                assert (coupler - (point.theta_deg - task.points[0].theta_deg) + 180) % 360 == pytest.approx(180, abs=1e-6)
        for side, pivot in (task.ground_pivots or {}).items():
            np.testing.assert_allclose(linkage.pivots[f"{side}_fixed"], pivot, atol=1e-9 * size)


def test_full_turn_and_elbows_have_names() -> None:
    answer = lw.solve(lw.Problem(lw.PathTask(FIVE, PIVOT), requirements={"full_turn": True}), samples=60)
    best = answer.linkages[0]
    assert best.full_turn is True and best.type in ("crank_rocker", "double_crank")
    sides, _, dyad = best.elbows.partition(" ")
    assert set(sides) <= {"+", "-"} and len(sides) == len(FIVE) and dyad in ("1", "2", "3")
    motion = best.motion()
    there = motion[motion["position"] > 0]
    np.testing.assert_allclose([there["point_x"], there["point_y"]], np.transpose(FIVE), atol=1e-5)
    hinge = lw.solve(lw.MotionTask([(0, 0, 0), (-125, 75, -25), (-220, 220, -52), (-220, 450, -82)]), samples=40).linkages[0]
    assert hinge.full_turn is None and hinge.elbows is None


def test_a_pivot_is_searched_for_in_a_box() -> None:
    box = {"x": [-150, 250], "y": [-150, 350]}
    problem = lw.Problem(lw.PathTask(FIVE), options={"box": box, "effort": 4000, "best": 3})
    answer = lw.solve(problem, samples=40)
    x, y = answer.linkages[0].pivots["input_fixed"]
    assert box["x"][0] <= x <= box["x"][1] and box["y"][0] <= y <= box["y"][1]
    assert any("searched for" in warning for warning in answer.warnings)
    assert all(linkage.pivots["input_fixed"] == pytest.approx((x, y)) for linkage in answer.linkages)
    again = lw.solve(lw.Problem(lw.PathTask(FIVE, {"input": [x, y]}), options={"best": 3}), samples=40)
    assert [linkage.lengths for linkage in again.linkages] == [linkage.lengths for linkage in answer.linkages]
    with pytest.raises(lw.ProblemError, match="a box"):
        lw.solve(lw.PathTask(FIVE))


def test_all_linkages_of_a_place_are_told() -> None:
    session = lw.Session(lw.PathTask(FIVE, PIVOT))
    region = session.explore(samples=40)
    row, column = np.argwhere(region.meets)[0]
    place = region.input[row], region.output[column]
    places = session.all_at(*place)
    linkages = [session.linkage(*there) for there in places]
    assert len(places) > 8 and len({linkage.elbows for linkage in linkages}) == len(places)
    assert {there[1] for there in places} == {place[1]}
    assert all(there[0] >= 1 and there[0] % 1 == pytest.approx(place[0], abs=1e-9) for there in places)
    best = session.linkage(*place)
    assert best.elbows == linkages[0].elbows and lw.linkage_types[region.types[row, column]] == best.type
    assert session.all_at(*places[3]) == places  # of a layer: all of its place
    assert len(session.linkage(*places[-1])["states"]) or session.linkage(*places[-1])["reason"]


def test_elsewhere_a_place_has_one_linkage() -> None:
    session = lw.Session(lw.PathTask(TIMED))
    assert session.all_at(0.25, 0.5) == [(0.25, 0.5)]


def test_a_session_follows_a_dragged_point() -> None:
    session = lw.Session(WIPER)
    before = session.explore(samples=40)
    session.move(3, x=400)
    after = session.explore(samples=40)
    assert not np.array_equal(before.types, after.types)
    fresh = lw.solve(session.problem, samples=40)
    assert after.counts.types.tolist() == [fresh.region.counts.get(name, 0) for name in lw.linkage_types]
    with pytest.raises(IndexError, match="no point 4: this task has 3"):
        session.move(4, x=0)


def crowded(point: lw.PathPoint) -> lw.PathTask:
    return lw.PathTask([point, *(lw.PathPoint(*each) for each in FIVE[1:])], PIVOT)


@pytest.mark.parametrize(
    "task, where, part",
    [
        (lw.PathTask([]), "task.points", "a list of points"),
        (lw.PathTask(FIVE), "task.points", "points alone leave too much open"),
        (lw.PathTask(FIVE[:4], PIVOT), "task.points", "add 1"),
        (lw.PathTask(FIVE[:4], {"input": [0, -50], "output": [90, 0]}), "task.points", "three or with five"),
        (lw.PathTask(FIVE, {"input": [95, 40]}), "task.points[1]", "lies at a ground pivot"),
        (lw.PathTask(TIMED[:3] + [(0, -9.5, 400)]), "task.points[3].input_deg", ""),
        (crowded(lw.PathPoint(0, 0, input_deg=5, theta_deg=5)), "task.points[0]", "more than a four-bar can keep"),
        (lw.PathTask([lw.PathPoint(x, y, theta_deg=20 * x) for x, y in FIVE]), "task.points", '"kind" to "motion"'),
        (lw.PathTask([*FIVE[:4], (3, 4, 5)]), "task.points", "three go with two, and four with one"),
        (lw.PathTask([*FIVE[:3], lw.PathPoint(60, 230, derivatives=[{"x": 0, "y": 0}])], PIVOT), "task.points[3].derivatives[0]", "stand still"),
    ],
)
def test_refusals_have_their_place_and_the_program_s_sentence(task: lw.PathTask, where: str, part: str, tmp_path: Path) -> None:
    with pytest.raises(lw.ProblemError) as caught:
        lw.solve(task)
    mistake = next(one for one in caught.value.mistakes if part in one.message)
    assert mistake.where == where and mistake.code
    file = tmp_path / "problem.json"
    file.write_text(lw.tasks.to_json(task))
    done = run("solve", file)
    assert done.returncode == 2
    told = [line.removeprefix(f"{file}: ") for line in done.stderr.splitlines()]
    assert told == [str(one) for one in caught.value.mistakes]


@pytest.mark.parametrize("name", ["film_claw_timed", "dough_mixer_five_points", "tailgate_four_poses_one_point", "walking_leg_pivots_five"])
def test_paths_are_drawn_and_pickled(name: str) -> None:
    from matplotlib import pyplot

    task = of_data(name)
    answer = lw.solve(task, samples=40)
    figure = answer.plot()
    picture, map_ = figure.axes[:2]
    drawn = {tuple(line.get_xydata()[0]) for line in picture.lines if len(line.get_xydata()) == 1}
    assert {(point.x, point.y) for point in task.points} <= drawn
    ends = [axis["branches"][-1]["to"] for axis in reversed(answer.region.about["axes"])]
    marks = [line.get_xydata()[0] for line in map_.lines if len(line.get_xydata()) == 1]
    assert len(marks) == len(answer.linkages)
    assert all(0 <= x <= ends[0] and 0 <= y <= ends[1] for x, y in marks)
    figure.canvas.draw()
    pyplot.close("all")
    copy = pickle.loads(pickle.dumps(answer))
    assert copy.export() == answer.export() and copy.region.types.tobytes() == answer.region.types.tobytes()


# ---- a linkage that is known: what passes its points has it


def known(random: np.random.Generator, count: int) -> tuple[dict[str, complex], list[tuple[complex, float, float]]]:
    """Pivots of a four-bar, and so many places of a point of its coupler: point, turn of the crank and of the coupler in
    degrees."""
    while True:
        fixed, reach = complex(*random.uniform(-1, 1, 2)), random.uniform(0.2, 2.5, 2)
        end = fixed + complex(random.uniform(0.5, 3), random.uniform(-1, 1))
        pin, joint = (at + r * np.exp(1j * random.uniform(-np.pi, np.pi)) for at, r in zip((fixed, end), reach))
        point, coupler = complex(*random.uniform(-2, 3, 2)), joint - pin
        side = np.sign((coupler.conjugate() * (end - pin)).imag)
        turns = random.choice([-1, 1]) * np.append(0, np.sort(random.uniform(0.1, 2.5, count - 1)))
        pins = fixed + np.exp(1j * turns) * (pin - fixed)
        apart = np.abs(end - pins)
        cosine = (abs(coupler) ** 2 + apart**2 - reach[1] ** 2) / (2 * abs(coupler) * apart)
        if np.all(np.abs(cosine) < 0.99):
            turned_by = (end - pins) / apart * np.exp(-1j * side * np.arccos(cosine)) * abs(coupler) / coupler
            points = pins + turned_by * (point - pin)
            pivots = {"input_fixed": fixed, "input_moving": pin, "output_fixed": end, "output_moving": joint}
            return pivots, list(zip(points.tolist(), np.degrees(turns).tolist(), np.degrees(np.angle(turned_by)).tolist()))


def is_among(pivots: dict[str, complex], linkages: list) -> bool:
    """By pivots, or the links of a session's record."""
    keys = {"fixed": "center_point", "moving": "circle_point"}
    found = [{f"{side}_{end}": each[side][key] for side in ("input", "output") for end, key in keys.items()} for each in linkages]
    return any(all(abs(complex(*each[name]) - at) < 1e-5 for name, at in pivots.items()) for each in found)


ANY = {"no_defects": False, "max_link_ratio": None, "max_length": None, "min_length": None}


def test_between_both_pivots_no_linkage_is_lost() -> None:
    random = np.random.default_rng(5)
    for _ in range(40):
        pivots, places = known(random, 5)
        given = {side: [pivots[f"{side}_fixed"].real, pivots[f"{side}_fixed"].imag] for side in ("input", "output")}
        task = lw.PathTask([(point.real, point.imag) for point, _, _ in places], given)
        answer = lw.solve(lw.Problem(task, requirements=ANY, options={"best": 100}))
        assert is_among(pivots, answer.linkages) or any("of 36" in warning.lower() for warning in answer.warnings)


def coordinate(axis: lw.Record, places: np.ndarray, value: float) -> float:
    """x = middle + size · tan(π (c − ½)), the whole line on an axis of unit length."""
    (first, second), tangents = axis["values"][[2, 5]], np.tan(np.pi * (places[[2, 5]] - 0.5))
    size = (second - first) / (tangents[1] - tangents[0])
    return 0.5 + np.arctan((value - first) / size + tangents[0]) / np.pi


@pytest.mark.parametrize("angle", ["theta_deg", "input_deg"])
def test_at_its_ground_pivot_a_linkage_is_found(angle: str) -> None:
    random = np.random.default_rng(7)
    for _ in range(25):
        pivots, places = known(random, 5)
        with_angle = random.choice(5, 3, replace=False)
        angles = [{angle: turn if angle == "input_deg" else coupler} for _, turn, coupler in places]
        points = [lw.PathPoint(p.real, p.imag, **(angles[j] if j in with_angle else {})) for j, (p, _, _) in enumerate(places)]
        problem = lw.Problem(lw.PathTask(points), requirements=ANY)
        region, session = lw.solve(problem, samples=8).region, lw.Session(problem)
        rows, columns = region.about["axes"]
        y = coordinate(rows, region.input, pivots["input_fixed"].imag)
        x = coordinate(columns, region.output, pivots["input_fixed"].real)
        there = [session.linkage(*place) for place in session.all_at(y, x)]
        assert is_among(pivots, [each for each in there if "input" in each])


BEAN = [(90, 18), (83, 31), (64, 34), (34, 32), (0, 30), (-34, 32), (-64, 34), (-83, 31), (-90, 18), (-83, -6), (-64, -34), (-34, -57),
        (0, -66), (34, -57), (64, -34), (83, -6)]


def test_a_drawn_path_is_fitted() -> None:
    answer = lw.fit_path(np.array(BEAN), closed=True, effort="quick", length_unit="mm")
    assert answer.status == "solved"
    best = answer.linkages[0]
    assert best.type == "crank_rocker" and best.full_turn and best.verified
    fit = best["fit"]
    assert fit["error"]["rms_over_diagonal"] < 0.005
    distances = np.array([at["distance"] for at in fit["at"]])
    assert np.sqrt(np.mean(distances**2)) == pytest.approx(fit["error"]["rms"])
    assert len(fit["realisations"]) == 3
    motion = best.motion()
    assert best.length_unit == "mm" and len(motion) > 360


def test_a_drawn_path_is_fitted_from_linkages_that_are_given() -> None:
    points = np.array(BEAN)
    longer = lw.fit_path(points, closed=True, best=20)
    shorter = lw.fit_path(points, closed=True, effort="quick", starts=longer.linkages, best=20)
    errors = [[linkage["fit"]["error"]["rms"] for linkage in answer.linkages] for answer in (longer, shorter)]
    assert errors[1][0] <= errors[0][0] * (1 + 1e-9)
    mapping = {side: longer.linkages[0][side] for side in ("input", "output")} | {"point": longer.linkages[0]["point"]}
    assert lw.fit_path(points, closed=True, effort="quick", starts=[mapping]).status == "solved"
    del mapping["point"]
    with pytest.raises(KeyError, match="point"):
        lw.fit_path(points, closed=True, starts=[mapping])


def test_poses_are_fitted_from_linkages_that_are_given() -> None:
    poses = [(0, 0, 0), (-60, 25, -11), (-125, 75, -25), (-178, 145, -39), (-220, 220, -52), (-240, 300, -63)]
    longer = lw.fit_poses(poses, turning_length=177.38)
    shorter = lw.fit_poses(poses, turning_length=177.38, effort="quick", starts=longer.linkages)
    assert shorter.linkages[0]["near"]["error"]["rms"] <= longer.linkages[0]["near"]["error"]["rms"] * (1 + 1e-6)


def test_a_drawn_path_is_fitted_at_angles_of_the_crank() -> None:
    angles = np.arange(16) * 22.5
    timed = lw.fit_path(BEAN, input_deg=angles, closed=True).linkages[0]
    assert timed["fit"]["timed"] and len(timed["fit"]["realisations"]) == 2
    turns = np.array([at["input_deg"] for at in timed["fit"]["at"]])
    assert np.abs(turns) == pytest.approx(angles, abs=1e-9)
    free = lw.fit_path(BEAN, closed=True).linkages[0]
    assert not free["fit"]["timed"] and free["fit"]["error"]["rms"] < timed["fit"]["error"]["rms"]
    with pytest.raises(ValueError, match="2 angles are given for 16 points"):
        lw.fit_path(BEAN, input_deg=[0, 1])
    with pytest.raises(lw.ProblemError, match="turn back"):
        lw.fit_path(BEAN, input_deg=[0, 20, 10, *range(30, 43)])
    assert lw.read_problem(lw.PathTask([(*p, a) for p, a in zip(BEAN, angles)], timing="absolute"))["task"]["timing"] == "absolute"


def test_a_drawn_path_goes_by_weights_and_tolerances() -> None:
    weights = [100.0] * 8 + [1.0] * 8
    heavy = lw.fit_path(BEAN, closed=True, weights=weights, effort="quick").linkages[0]["fit"]
    even = lw.fit_path(BEAN, closed=True, effort="quick").linkages[0]["fit"]
    upper = lambda fit: max(at["distance"] for at in fit["at"][:8])  # noqa: E731
    assert upper(heavy) <= upper(even) * (1 + 1e-6)
    assert lw.fit_path(BEAN, closed=True, tolerance=50, effort="quick").linkages[0]["fit"]["within_tolerance"]
    task = lw.PathTask([lw.PathPoint(*point, tolerance=2) for point in BEAN], closed=True, between="polyline")
    assert lw.read_problem(task)["task"]["between"] == "polyline"


def test_a_drawn_path_has_its_mistakes_told() -> None:
    with pytest.raises(lw.ProblemError, match="three or more"):
        lw.fit_path(BEAN[:2])
    with pytest.raises(lw.ProblemError, match="above 0"):
        lw.fit_path(BEAN, tolerance=0)
    with pytest.raises(ValueError, match="3 weights are given for 16 points"):
        lw.fit_path(BEAN, weights=[1, 2, 3])
    with pytest.raises(lw.ProblemError, match="endless"):
        lw.fit_path(BEAN, effort="endless")
