"""Sweeps in memory and from tables: the program's numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import EXAMPLES, run

import linkwright as lw

REACH = EXAMPLES / "sweeps/log_generator_reach.json"


@pytest.fixture(scope="module")
def swept() -> lw.Sweep:
    return lw.sweep(REACH, threads=2)


def test_a_plan_gives_the_problem_of_any_sample() -> None:
    plan = lw.SweepPlan(REACH)
    assert len(plan) == 128
    assert plan.variables == ("input_range", "output_range", "pivots")
    problem = plan.problem(77)
    assert problem["task"]["ground_pivots"]["output"][0] == plan.values(77)[2]
    with pytest.raises(IndexError):
        plan.problem(128)


def test_rows_are_those_of_solve(swept: lw.Sweep) -> None:
    assert len(swept) == 128
    plan = lw.SweepPlan(REACH)
    for row in range(0, len(swept.linkages["sample"]), 7):
        best = lw.solve(plan.problem(int(swept.linkages["sample"][row]))).linkages[0]
        assert best.type == swept.linkages["type"][row]
        assert best.lengths.coupler == swept.linkages["lengths.coupler"][row]
    assert swept.units["linkages/lengths.ground"] == "mm"


def test_a_table_of_the_program_is_the_same(swept: lw.Sweep, tmp_path: Path) -> None:
    pytest.importorskip("h5py")
    table = tmp_path / "out.h5"
    assert run("sweep", REACH, "-o", table).returncode == 0
    loaded = lw.load_sweep(table)
    assert loaded.about == swept.about and loaded.units == swept.units
    for name in ("samples", "linkages", "failures"):
        ours, theirs = getattr(swept, name), getattr(loaded, name)
        assert list(ours) == list(theirs)
        for column in ours:
            assert np.array_equal(ours[column], theirs[column], equal_nan=ours[column].dtype.kind == "f"), column


def test_frames_join_linkages_to_their_samples(swept: lw.Sweep) -> None:
    pytest.importorskip("pandas")
    joined = swept.joined()
    assert len(joined) == len(swept.linkages["sample"])
    assert {"input_range", "type", "max_structural_error_deg", "status"} <= set(joined.columns)
    with pytest.raises(KeyError):
        swept.frame("rows")


def test_mistakes_have_places(tmp_path: Path) -> None:
    with pytest.raises(lw.ProblemError) as caught:
        lw.sweep({"linkwright": 1, "problem": lw.read_problem(EXAMPLES / "tailgate.json"), "sampling": {"method": "grid"},
                  "vary": [{"at": "/task/nowhere", "from": 0, "to": 1, "count": 2}]})
    assert caught.value.mistakes[0].where == "vary[0].at"
    pytest.importorskip("h5py")
    with pytest.raises((ValueError, OSError)):
        (tmp_path / "none.h5").write_text("{}")
        lw.load_sweep(tmp_path / "none.h5")
