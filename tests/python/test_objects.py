"""What the package itself adds: tasks from objects, arrays that own their memory, pickles, threads, Ctrl-C."""

from __future__ import annotations

import gc
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import linkwright as lw
from conftest import EXAMPLES, TREE, problem_of, solved

POSES = [(0, 0, 0), (-125, 75, -25), (-220, 220, -52), (-220, 450, -82)]


# ---- tasks


def test_poses_of_all_kinds_are_the_same_task() -> None:
    task = {"kind": "motion", "mechanism": "four_bar"}
    task["poses"] = [dict(zip(("x", "y", "theta_deg"), pose)) for pose in POSES]
    results = {
        lw.solve(problem, samples=20).export()
        for problem in (
            lw.MotionTask(POSES),
            lw.MotionTask(np.array(POSES)),
            lw.MotionTask([lw.Pose(*pose) for pose in POSES]),
            lw.Problem(lw.MotionTask(POSES)),
            task,
            {"task": task},
            json.dumps({"linkwright": 1, "task": task}),
        )
    }
    assert len(results) == 1


def test_given_pivots_and_points_of_the_body() -> None:
    pivots = {"input": [120, 340], "output": [200, 340]}
    [made] = lw.solve(lw.MotionTask([POSES[0], POSES[1], POSES[3]], given={"ground_pivots": pivots})).linkages
    for side, pivot in pivots.items():
        assert made[side]["center_point"] == pytest.approx(pivot)
    line = {"point": [0, 340], "direction_deg": 0}
    on_line = lw.solve(lw.MotionTask(POSES, pivot_on=[{"which": "input", "pivot": "ground", "line": line}]), samples=60)
    assert all(linkage["input"]["center_point"][1] == pytest.approx(340) for linkage in on_line.linkages)
    by_points = [{"points": [[0, 0], [100, 0]]}, {"points": [[10, 20], [70, 100]]}, {"points": [[40, 60], [40, 162]]}]
    answer = lw.solve(lw.MotionTask(by_points, given={"ground_pivots": pivots}))
    assert any("apart in the poses given" in warning for warning in answer.warnings)


def test_a_file_by_text_or_path() -> None:
    path = EXAMPLES / "nose_gear.json"
    assert lw.solve(path).export() == lw.solve(str(path)).export() == lw.solve(path.read_text()).export()


def test_orientations_of_scipy_are_the_same_task() -> None:
    angles = [[5, 0, 0], [-10, 4, 20], [-25, 10, 42], [-40, 16, 62]]
    of_scipy = lw.SphericalMotionTask(Rotation.from_euler("XYZ", angles, degrees=True))
    of_files = lw.SphericalMotionTask([{"euler_deg": each, "sequence": "xyz"} for each in angles])
    first, second = (lw.solve(task, samples=40) for task in (of_scipy, of_files))
    assert first.region.counts == second.region.counts
    assert first.linkages[0]["min_transmission_angle_deg"] == pytest.approx(
        second.linkages[0]["min_transmission_angle_deg"], rel=1e-9
    )


@pytest.mark.parametrize("form", ["scipy", "matrix", "quaternion"])
def test_an_orientation_in_every_form(form: str) -> None:
    rotation = Rotation.from_euler("ZXZ", [40, 50, 35], degrees=True)
    given = {"scipy": rotation, "matrix": rotation.as_matrix(), "quaternion": np.roll(rotation.as_quat(), 1)}[form]
    np.testing.assert_allclose(lw.attitude.convert(given).matrix, rotation.as_matrix(), atol=1e-12)


@pytest.mark.parametrize(
    "problem",
    [
        {}, [], "", "{", 7, None, "no_such_file.json", {"task": 3}, lw.MotionTask([]), lw.MotionTask([(0, 0, float("nan"))] * 4),
        lw.MotionTask([(0, 0, float("inf"))] * 4), lw.Problem(lw.MotionTask(POSES), requirements={"max_lenght": 3}),
        lw.Problem(lw.MotionTask(POSES), options={"best": -1}), lw.MotionTask([POSES[0]] * 4), {"task": {"kind": "dance"}},
        {"linkwright": 2}, "\ud800{", "{\0}",
    ],
)
def test_wrong_input_is_refused_in_words(problem: object) -> None:
    with pytest.raises((lw.ProblemError, UnicodeEncodeError)) as caught:
        lw.solve(problem)
    assert str(caught.value)


def test_what_is_no_part_of_a_problem_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="has no place in a problem"):
        lw.solve({"task": object()})


def test_wrong_arguments_are_refused() -> None:
    answer = solved("tailgate", 40)
    for wrong in (
        lambda: lw.solve(lw.MotionTask(POSES), samples=3),
        lambda: answer.linkages[0].export("pdf"),
        lambda: answer.export("dxf"),
        lambda: solved("folding_wing", 40).linkages[0].export("dxf"),
        lambda: answer.tolerance(1),
        lambda: answer.tolerance(99, length=0.1),
        lambda: answer.linkages[0].analyze("coupler"),
        lambda: solved("folding_wing", 40).linkages[0].instant(),
        lambda: lw.Linkage.read({"lengths": {"ground": 1}}),
        lambda: lw.Linkage.read("no_such_file.json"),
        lambda: answer.region.plot(layer=4),
        lambda: lw.attitude.convert([1, 2, 3]),
        lambda: lw.Session(lw.MotionTask([])),
    ):
        with pytest.raises(ValueError) as caught:
            wrong()
        assert str(caught.value)
    with pytest.raises(KeyError, match="link_ratio"):
        answer.region["beauty"]
    with pytest.raises(AttributeError, match="status"):
        answer.result.stattus
    with pytest.raises(OSError, match="no_such_folder"):
        answer.save("/no_such_folder/x.json")


# ---- memory


def test_columns_cannot_be_written() -> None:
    region = solved("tailgate", 40).region
    for column in (region.input, region.types, region.defects, region.failures, region["link_ratio"]):
        assert not column.flags.writeable and not column.flags.owndata
        with pytest.raises(ValueError):
            column.flat[0] = 1
        with pytest.raises(ValueError):
            column.setflags(write=True)


def test_a_view_outlives_its_answer() -> None:
    answer = lw.solve(EXAMPLES / "tailgate.json", samples=200)
    region = answer.region
    views = [region.types, region["link_ratio"], region.output]
    copies = [np.array(view) for view in views]
    motion = answer.linkages[0].motion()
    kept = motion.copy()
    del answer, region
    gc.collect()
    for _ in range(5):
        lw.solve(EXAMPLES / "landing_gear.json", samples=200)
    for view, copy in zip(views, copies):
        assert np.array_equal(view, copy)
    assert motion.tobytes() == kept.tobytes()


def resident_bytes() -> int:
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def test_memory_is_given_back() -> None:
    def work() -> None:
        answer = lw.solve(lw.Problem(lw.MotionTask(POSES), options={"best": 1}), samples=40)
        answer.linkages[0].motion()
        assert answer.region["link_ratio"].size == 1600
        with pytest.raises(lw.ProblemError):
            lw.solve({})

    for _ in range(20):
        work()
    gc.collect()
    before = resident_bytes()
    for _ in range(200):
        work()
    gc.collect()
    assert resident_bytes() - before < 6e6  # 200 results of 60 kB, text and objects, would be more than 40 MB


# ---- pickles


@pytest.mark.parametrize("name", ["tailgate", "nose_gear", "folding_wing", "loader_bucket_chain", "sine_generator"])
def test_a_pickled_answer_says_the_same(name: str) -> None:
    answer = solved(name, 40)
    copy = pickle.loads(pickle.dumps(answer))
    assert copy.export() == answer.export() and repr(copy) == repr(answer)
    for one, other in zip(answer.linkages, copy.linkages):
        assert one.properties.keys() == other.properties.keys() and one.motion().tobytes() == other.motion().tobytes()
    assert copy.region.types.tobytes() == answer.region.types.tobytes() and not copy.region.types.flags.writeable
    for key in answer.region.measures:
        assert copy.region[key].tobytes() == answer.region[key].tobytes()
    twice = pickle.loads(pickle.dumps(copy))
    assert twice.region.failures.tobytes() == answer.region.failures.tobytes()
    assert twice._repr_svg_() == answer._repr_svg_()


def test_a_pickled_linkage_is_the_same() -> None:
    for name in ("tailgate", "folding_wing", "loader_bucket_chain"):
        linkage = solved(name, 60).linkages[0]
        copy = pickle.loads(pickle.dumps(linkage))
        assert type(copy) is type(linkage) and copy.export() == linkage.export() and copy.number == 1


def test_a_pickled_mistake_is_the_same() -> None:
    with pytest.raises(lw.ProblemError) as caught:
        lw.solve({})
    copy = pickle.loads(pickle.dumps(caught.value))
    assert str(copy) == str(caught.value) and copy.mistakes == caught.value.mistakes


# ---- threads, progress, Ctrl-C


def test_two_threads_solve_at_once() -> None:
    names = ["tailgate", "folding_wing", "landing_gear", "sine_generator"] * 3
    alone = {name: lw.solve(EXAMPLES / f"{name}.json", samples=150).export() for name in set(names)}
    found: list[tuple[str, str]] = []

    def work(name: str) -> None:
        found.append((name, lw.solve(EXAMPLES / f"{name}.json", samples=150).export()))

    threads = [threading.Thread(target=work, args=(name,)) for name in names]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == len(names) and all(alone[name] == text for name, text in found)


def long_search() -> dict:
    problem = problem_of("loader_bucket")
    problem["options"]["effort"] = 10_000_000
    return problem


def test_other_threads_run_meanwhile_and_can_cancel() -> None:
    cancellation, shares = lw.Cancellation(), []
    timer = threading.Timer(0.4, cancellation.cancel)
    timer.start()
    answer = lw.solve(long_search(), progress=shares.append, cancellation=cancellation)
    assert cancellation.cancelled
    assert answer.result["search"].interrupted and "interrupted" in answer.reason  # the best so far
    assert shares and all(0 <= share <= 1 for share in shares) and shares == sorted(shares)


def test_a_map_that_is_cancelled_raises() -> None:
    cancellation = lw.Cancellation()
    threading.Timer(0.1, cancellation.cancel).start()
    with pytest.raises(lw.Cancelled):
        lw.solve(EXAMPLES / "tailgate_as_made.json", samples=1500, cancellation=cancellation)


def test_what_progress_raises_ends_the_work() -> None:
    def fail(_: float) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        lw.solve(long_search(), progress=fail)


def stopped_by_control_c(program: str, after: float) -> None:
    """Of a program that says "begun", and "stopped" after a KeyboardInterrupt."""
    # A shell's job in the background is begun with the signal ignored.
    program = "import json, signal, linkwright as lw\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n" + program
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None and child.stdout.readline() == "begun\n"
        time.sleep(after)
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "stopped solved\n"
        assert child.wait(200) == 0


def test_control_c_stops() -> None:
    stopped_by_control_c(
        f"""
problem = lw.read_problem({str(EXAMPLES / "loader_bucket.json")!r})
problem["options"]["effort"] = 10_000_000
print("begun", flush=True)
try:
    lw.solve(problem)
except KeyboardInterrupt:
    print("stopped", lw.solve({str(EXAMPLES / "nose_gear.json")!r}).status, flush=True)
""",
        after=0.5,
    )


def test_control_c_stops_the_placing_of_a_spring() -> None:
    # Boxes as large as these leave the proof much to do.
    stopped_by_control_c(
        f"""
problem = lw.read_problem({str(EXAMPLES / "tailgate_struts.json")!r})
problem["options"]["region_samples"] = 40
answer = lw.solve(problem)
boxes = json.loads(open({str(EXAMPLES / "springs/tailgate_boxes.json")!r}).read())
for box in ("ground", "body"):
    for axis in "xy":
        low, high = boxes[box][axis]
        boxes[box][axis] = [low - 500, high + 500]
print("begun", flush=True)
try:
    answer.place_spring(boxes)
except KeyboardInterrupt:
    print("stopped", answer.status, flush=True)
""",
        after=1,
    )


# ---- pictures, tables, sessions


@pytest.mark.parametrize(
    "name", ["tailgate", "nose_gear", "folding_wing", "loader_bucket_chain", "straight_stage", "sine_generator", "flow_meter"]
)
def test_every_kind_is_drawn(name: str) -> None:
    from matplotlib import pyplot

    answer = solved(name, 60)
    figure = answer.plot()
    assert len(figure.axes) >= 2
    figure.canvas.draw()
    measure = answer.region.measures[0]
    axes = answer.region.plot(measure=measure, contours=measure if min(answer.region.shape) > 1 else None)
    axes.figure.canvas.draw()
    answer.linkages[0].plot().figure.canvas.draw()
    assert "<svg" in answer.linkages[0]._repr_svg_()
    pyplot.close("all")


def test_colours_are_those_of_the_pictures() -> None:
    image = solved("tailgate", 60).region.plot(legend=False).images[0].get_array()
    region = solved("tailgate", 60).region
    row, column = np.argwhere(region.meets)[0]
    color = lw.plot.type_colors[lw.linkage_types[region.types[row, column]]]
    assert [round(255 * part) for part in image[row, column]] == [int(color[i : i + 2], 16) for i in (1, 3, 5)]


def test_region_as_a_table() -> None:
    region = solved("tailgate", 60).region
    table = region.to_dataframe()
    assert len(table) == 3600 and table["meets"].sum() == region.meets.sum()
    counts = table["type"].value_counts()
    assert counts["double_crank"] == region.counts.double_crank
    sound = table[~table[["order_defect", "branch_defect", "circuit_defect"]].any(axis=1)]
    assert sound["min_transmission_angle_deg"].between(0, 90).sum() == region.counts.defect_free
    assert len(region.to_dataframe(meeting_only=True)) == region.meets.sum()


def test_region_says_that_pandas_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match="python3-pandas"):
        solved("tailgate", 60).region.to_dataframe()


def test_a_session_follows_a_dragged_pose() -> None:
    session = lw.Session(EXAMPLES / "tailgate.json")
    first = session.explore(samples=100)
    assert first.counts.meeting == first.meets.sum() == solved("tailgate", 100).region.meets.sum()
    kept = first.types.copy()
    session.move(3, x=-215)
    second = session.explore(samples=100)
    assert not np.array_equal(first.types, second.types) and np.array_equal(first.types, kept)
    fresh = lw.solve(session.problem, samples=100)
    assert second.counts.types.tolist() == [fresh.region.counts.get(name, 0) for name in lw.linkage_types]
    assert session.best(1)[0].type == lw.solve(session.problem).linkages[0].type
    with pytest.raises(lw.ProblemError):
        session.move(2, x=0, y=0, theta_deg=0)
    assert np.array_equal(session.explore(samples=100).types, second.types)  # the last good one stays
    with pytest.raises(IndexError, match="no pose 9"):
        session.move(9, x=0)


def test_a_session_tells_of_one_linkage() -> None:
    session, best = lw.Session(EXAMPLES / "tailgate.json"), solved("tailgate").linkages[0]
    session.explore()
    place = best["input"]["coordinate"], best["output"]["coordinate"]
    assert session.linkage(*place)["states"].size
    np.testing.assert_allclose(session.improve(*place), place, atol=1e-3)
    assert "<svg" in session.export(*place) and session.export(*place, format="csv").count("\n") > 100


def test_a_prescribed_instant() -> None:
    third = {"x": 0, "y": 0, "theta": 0}
    task = lw.MotionTask([lw.Pose(0, 0, 0, ({"x": 1, "y": 0, "theta": 1}, {"x": 0, "y": 1, "theta": 0}, third))])
    found = lw.instant(task)
    assert found.kind == "pivoting"
    np.testing.assert_allclose(found.pole, [0, 1], atol=1e-12)  # velocity (1, 0) at the origin, turning at 1


def test_docstrings_are_everywhere() -> None:
    for name in lw.__all__:
        thing = getattr(lw, name)
        if name in ("__version__", "linkage_types"):
            continue
        assert thing.__doc__, name
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert value.__doc__ or member == "to_dict", f"{name}.{member}"


def test_the_version_is_cmake_s() -> None:
    text = (TREE / "CMakeLists.txt").read_text()
    assert f"VERSION {lw.__version__} " in text


def test_types_are_checked() -> None:
    words = ["/usr/bin/python3", "-m", "mypy"]
    done = subprocess.run([*words, "bindings/python/linkwright"], cwd=TREE, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
