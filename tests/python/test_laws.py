"""Laws that hold for any task, by hypothesis."""

from __future__ import annotations

import numpy as np
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import linkwright as lw

laws = settings(max_examples=15, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
length = st.integers(-400, 400).map(float)
angle = st.integers(-160, 160).map(float)
pose = st.tuples(length, length, angle)
SAMPLES = 24


@st.composite
def four_poses(draw: st.DrawFn) -> list[tuple[float, float, float]]:
    poses = [draw(pose) for _ in range(4)]
    for i, first in enumerate(poses):
        for second in poses[:i]:
            assume(np.hypot(first[0] - second[0], first[1] - second[1]) > 20 and abs(first[2] - second[2]) > 5)
    return poses


def counts(poses: object) -> dict:
    return dict(lw.solve(lw.MotionTask(poses), samples=SAMPLES).region.counts)


def alike(first: dict, second: dict) -> bool:
    """Cells on a border may fall to either side by rounding."""
    return all(abs(first[key] - second[key]) <= 2 for key in first)


@laws
@given(four_poses(), st.integers(-3, 3), length, length)
def test_neither_size_nor_place_of_the_drawing_matters(poses: list, power: int, x: float, y: float) -> None:
    scale = 2.0**power
    moved = [(scale * px + x, scale * py + y, theta) for px, py, theta in poses]
    assert alike(counts(poses), counts(moved))


@laws
@given(four_poses(), angle)
def test_the_drawing_may_be_turned(poses: list, by: float) -> None:
    c, s = np.cos(np.radians(by)), np.sin(np.radians(by))
    turned = [(c * x - s * y, s * x + c * y, theta + by) for x, y, theta in poses]
    assert alike(counts(poses), counts(turned))


@laws
@given(four_poses())
def test_every_linkage_keeps_its_lengths_in_every_position(poses: list) -> None:
    """By the poses alone, without the library: grounded links are rigid, so |Z_j − M| does not change."""
    for linkage in lw.solve(lw.MotionTask(poses), samples=SAMPLES).linkages:
        for side in ("input", "output"):
            fixed, moving = linkage.pivots[f"{side}_fixed"], linkage.pivots[f"{side}_moving"]
            lengths = [np.linalg.norm(carried(moving, poses[0], there) - fixed) for there in poses]
            assert np.ptp(lengths) <= 1e-8 * max(lengths[0], 1)


@laws
@given(four_poses())
def test_motion_passes_the_poses(poses: list) -> None:
    for linkage in lw.solve(lw.MotionTask(poses), samples=SAMPLES).linkages[:2]:
        motion = linkage.motion()
        for row in motion[motion["position"] > 0]:
            x, y, theta = poses[row["position"] - 1]
            assert np.hypot(row["body_x"] - x, row["body_y"] - y) < 1e-5 * 400
            assert abs((row["body_theta_deg"] - theta + 180) % 360 - 180) < 1e-4


@laws
@given(st.tuples(angle, angle, angle), st.tuples(angle, angle, angle))
def test_attitudes_agree_with_scipy(first: tuple, second: tuple) -> None:
    one, other = (Rotation.from_euler("ZYX", angles, degrees=True) for angles in (first, second))
    found = lw.attitude.convert(one * other)
    np.testing.assert_allclose(found.matrix, one.as_matrix() @ other.as_matrix(), atol=1e-12)
    np.testing.assert_allclose(np.abs(found.rotation_vector), np.abs((one * other).as_rotvec()), atol=1e-7)


def carried(point: np.ndarray, home: tuple, there: tuple) -> np.ndarray:
    turn = np.radians(there[2] - home[2])
    c, s = np.cos(turn), np.sin(turn)
    return np.array([[c, -s], [s, c]]) @ (point - np.array(home[:2])) + np.array(there[:2])
