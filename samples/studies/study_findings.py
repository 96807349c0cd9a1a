"""Findings of a study: claims about all pairs of some of its cells, which the results prove or refute."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Optional

from number_text import percent, short_number
from study_results import Cell, Finding, StudyResults
from words import Words

HOLDS = "holds"
REFUTED = "does not hold"
OPEN = "open"  # no pair refutes it, but some cells were not run or never solved

_SELECTED = {"rows": "row", "strategies": "strategy", "operators": "operator", "scenarios": "scenario"}


@dataclass
class CheckedFinding:
    """The verdict, the number of pairs, and the pair with the strongest evidence against the finding."""

    verdict: str = OPEN
    compared: int = 0
    agreeing: int = 0
    numbers: str = ""


def check_finding(finding: Finding, results: StudyResults, words: Words) -> CheckedFinding:
    """Compares every pair of cells that the finding speaks of, or every cell with its number."""
    check = _Check(finding, words)
    for cell in _selected(finding.cells, results.cells):
        if not isinstance(finding.than, dict):
            check.compare_with_number(cell, finding.than)
            continue
        for other in _selected(finding.than, results.cells):
            if other is not cell and all(getattr(cell, key) == getattr(other, key) for key in finding.pair_by):
                check.compare(cell, other)
    return check.conclude()


def _selected(selection: dict[str, list[str]], cells: list[Cell]) -> list[Cell]:
    """The cells that have one of the names in each list; a missing list selects all."""
    return [cell for cell in cells
            if all(getattr(cell, attribute) in selection[key]
                   for key, attribute in _SELECTED.items() if selection.get(key))]


class _Check:
    """Notes pairs, and keeps the one with the strongest evidence against the finding."""

    def __init__(self, finding: Finding, words: Words) -> None:
        self._quantity = finding.quantity
        self._below = finding.below
        self._factor = finding.factor
        self._words = words
        self._result = CheckedFinding()
        self._worst = -math.inf
        self._missing = ""

    def compare_with_number(self, cell: Cell, bound: float) -> None:
        left = self._value(cell)
        if left is None:
            return
        against = left - bound if self._below else bound - left
        text = "{0}: {1}; wanted below {2}" if self._below else "{0}: {1}; wanted above {2}"
        self._note(against < 0, against, self._words(text, cell.label, self._shown(left), self._shown(bound)))

    def compare(self, cell: Cell, other: Cell) -> None:
        left = self._value(cell)
        right = self._value(other)
        if left is None or right is None:
            return
        bound = self._factor * right
        # Distance of the pair from its bound: a ratio, or a difference where the bound is zero.
        ratio = left / bound if bound > 0 else left - bound + 1
        text = self._words("{0}: {1} against {2}: {3}", cell.label, self._shown(left), other.label,
                           self._shown(right))
        if right > 0:
            more = "{0}, {1} times; wanted below {2}" if self._below else "{0}, {1} times; wanted above {2}"
            text = self._words(more, text, short_number(left / right), short_number(self._factor))
        agrees = left < bound if self._below else left > bound
        self._note(agrees, ratio if self._below else -ratio, text)

    def conclude(self) -> CheckedFinding:
        result = self._result
        if result.agreeing < result.compared:
            result.verdict = REFUTED
        elif result.compared and not self._missing:
            result.verdict = HOLDS
        elif self._missing:
            result.numbers += ("; " if result.numbers else "") + self._missing
        else:
            result.numbers = self._words("Its rows are not part of this size of the study")
        return result

    def _value(self, cell: Cell) -> Optional[float]:
        found = cell.value_of(self._quantity)
        if found is None:
            text = "{0} was never solved" if cell.runs else "{0} has not been run"
            self._missing = self._words(text, cell.label)
            return None
        return found.value

    def _shown(self, value: float) -> str:
        return percent(value) if self._quantity.is_success else short_number(value)

    def _note(self, agrees: bool, against: float, text: str) -> None:
        self._result.compared += 1
        self._result.agreeing += agrees
        if against > self._worst:
            self._worst = against
            self._result.numbers = text
