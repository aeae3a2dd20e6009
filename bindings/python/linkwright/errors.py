"""What can go wrong: the caller's mistakes, and work that was asked to stop."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Sequence


@dataclass(frozen=True)
class Mistake:
    """One mistake of the caller's, worded as the program words it.

    Attributes:
        code: stable identifier, one to a sentence, e.g. ``repeated_pose``.
        where: place in the problem, e.g. ``task.poses[2].theta_deg``; empty for the whole of it.
        message: one sentence: what is wrong, and the way out.
        values: the numbers and words in the message, by name.
    """

    code: str
    where: str
    message: str
    values: dict[str, float | str] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.where}: {self.message}" if self.where else self.message


class ProblemError(ValueError):
    """A problem, a linkage or a question that has mistakes: one line each, as the program prints them.

    Attributes:
        mistakes: all of them, as :class:`Mistake`; at least one.
        file: where they were read from; empty for what was not a file.
    """

    def __init__(self, mistakes: Sequence[Mistake], file: str = "") -> None:
        self.mistakes = list(mistakes)
        self.file = file
        prefix = f"{file}: " if file else ""
        super().__init__("\n".join(f"{prefix}{mistake}" for mistake in self.mistakes))

    def __reduce__(self) -> tuple[type[ProblemError], tuple[list[Mistake], str]]:
        return type(self), (self.mistakes, self.file)


class Cancelled(RuntimeError):
    """solve() was asked to stop, by :meth:`Cancellation.cancel`, before its answer was complete."""
