"""Many small systems of linear inequalities at once: which have a solution?"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
TINY = 2.0**-46
"""What counts as zero, in systems whose coefficients are about 1."""
HEURISTIC = 5
"""For so many exchanges a variable the greatest are taken; then those of Bland's rule, which must end."""


@dataclass
class Systems:
    """Systems lower <= (table · t, t) <= upper, on the way to an answer.

    Attributes
    ----------
    table
        The dependent variables (rows) as sums of the independent ones (columns), shape (n, r, c).
    lower, upper
        The bounds of all variables, shape (n, r + c).
    values
        Those of the dependent variables; the independent ones lie at their lower bounds, or at the upper
        ones:
    at_upper
        which do.
    left, right
        Which variables are dependent, and which independent.
    """

    table: Floats
    lower: Floats
    upper: Floats
    values: Floats
    at_upper: Flags
    left: NDArray[np.intp]
    right: NDArray[np.intp]

    def some(self, which: NDArray[np.intp]) -> Systems:
        """Some of the systems."""
        return Systems(*(getattr(self, field.name)[which] for field in fields(self)))

    def exchange(self, row: NDArray[np.intp], column: NDArray[np.intp], change: Floats) -> None:
        """Make one variable dependent and one independent; the latter goes to its bound, a change away."""
        n = np.arange(len(row))
        line, entries = self.table[n, row], self.table[n, :, column]
        pivot = line[n, column]
        step, line = change / pivot, -line / pivot[:, None]
        line[n, column] = 1 / pivot
        self.table[n, :, column] = 0
        self.table += entries[:, :, None] * line[:, None, :]
        self.table[n, row] = line
        entering, leaving = self.right[n, column], self.left[n, row]
        bound = np.where(self.at_upper[n, column], self.upper[n, entering], self.lower[n, entering])
        self.values += entries * step[:, None]
        self.values[n, row] = bound + step
        self.left[n, row], self.right[n, column], self.at_upper[n, column] = entering, leaving, change < 0


def feasible(table: Any, lower: Floats, upper: Floats) -> tuple[Flags, Floats]:
    """Which of n systems lower <= (table · t, t) <= upper, with lower bounds 0 of t, have a solution.

    The simplex method of Dutertre and de Moura (*A fast linear-arithmetic solver for DPLL(T)*, 2006). Of the
    dependent variables one that is out of bounds is exchanged for an independent one that can make up for it.
    If there is none, there is no solution: the sum of the variables with certain coefficients, which are the
    other answer, is always 0, and cannot be within the bounds.

    >>> once = np.ones((2, 1, 1))
    >>> found, reasons = feasible(once, np.array([[2.0, 0], [2, 0]]), np.array([[9.0, 3], [9, 1]]))
    >>> found.tolist(), reasons[1].tolist()
    ([True, False], [1.0, -1.0])
    """
    n, r, c = table.shape
    names = np.tile(np.arange(r + c), (n, 1))
    at_upper = np.zeros((n, c), dtype=np.bool_)
    now = Systems(table, lower, upper, np.zeros((n, r)), at_upper, names[:, :r].copy(), names[:, r:].copy())
    result, reasons, left = np.zeros(n, dtype=np.bool_), np.zeros((n, r + c)), np.arange(n)
    for step in range(1000 * (r + c)):
        all_of, bland = np.arange(len(left)), step > HEURISTIC * (r + c)
        lack = np.take_along_axis(now.lower, now.left, 1) - now.values
        excess = now.values - np.take_along_axis(now.upper, now.left, 1)
        wrong = np.maximum(lack, excess)
        row = np.where(wrong > TINY, -now.left if bland else wrong, -np.inf).argmax(axis=1)
        done = wrong[all_of, row] <= TINY
        result[left[done]] = True
        change = np.where(lack[all_of, row] > 0, lack[all_of, row], -excess[all_of, row])
        # An independent variable can move away from its bound, not beyond it.
        gain = np.where(now.at_upper ^ (change > 0)[:, None], 1, -1) * now.table[all_of, row]
        column = np.where(gain > TINY, -now.right if bland else gain, -np.inf).argmax(axis=1)
        go = np.flatnonzero(~done & (gain[all_of, column] > TINY))
        stuck = np.flatnonzero(~done & (gain[all_of, column] <= TINY))
        reasons[left[stuck, None], now.right[stuck]] = now.table[stuck, row[stuck]]
        reasons[left[stuck], now.left[stuck, row[stuck]]] = -1
        if not len(go):
            return result, reasons
        now, left = now.some(go), left[go]
        now.exchange(row[go], column[go], change[go])
    raise AssertionError("the simplex method does not end")
