"""Dimensional synthesis of linkages: every solution, on one map.

    >>> import linkwright as lw
    >>> answer = lw.solve(lw.MotionTask([(0, 0, 0), (-125, 75, -25), (-220, 220, -52), (-220, 450, -82)]))
    >>> answer.linkages[0].type, answer.region.counts.defect_free
    ('triple_rocker_output', 97477)

Lengths are in the user's unit, angles in degrees with ``_deg`` in the name. Mistakes raise :class:`ProblemError`, with the
same sentences as the program's.
"""

from . import attitude, plot
from ._linkwright import linkage_types
from ._linkwright import version as __version__
from .answers import Answer, instant
from .linkages import FourBar, Linkage, SixBar, SphericalFourBar
from .region import Region
from .errors import Cancelled, Mistake, ProblemError
from .records import Record
from .sessions import LiveMap, Session
from .solving import Cancellation, fit_path, fit_poses, read_problem, solve
from .sweeps import Sweep, SweepPlan, load_sweep, sweep
from .tasks import (
    FunctionTask,
    MotionTask,
    PathPoint,
    PathTask,
    Pose,
    Problem,
    SixBarTask,
    SphericalMotionTask,
    StraightLineTask,
    orientation,
)

__all__ = [
    "Answer",
    "Cancellation",
    "Cancelled",
    "FourBar",
    "FunctionTask",
    "Linkage",
    "LiveMap",
    "Mistake",
    "MotionTask",
    "PathPoint",
    "PathTask",
    "Pose",
    "Problem",
    "ProblemError",
    "Record",
    "Region",
    "Session",
    "SixBar",
    "SixBarTask",
    "SphericalFourBar",
    "SphericalMotionTask",
    "StraightLineTask",
    "Sweep",
    "SweepPlan",
    "__version__",
    "attitude",
    "fit_path",
    "fit_poses",
    "instant",
    "linkage_types",
    "load_sweep",
    "orientation",
    "plot",
    "read_problem",
    "solve",
    "sweep",
]
