"""The results of a study, as `glissade-cli study`, `merge` and `report` write them into a folder.

Read are `summary.json` (the study, and statistics of its cells), `timing_summary.csv` (seconds and memory of the
cells) and `runs.csv` (one row for each run).
"""

from __future__ import annotations

import csv
import json
import math
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any, Callable, Optional, Union

from number_text import percent, short_number

SUMMARY_VERSION = 1
TIMING_MEASURES = ("planning_s", "planning_cpu_s", "wall_s", "cpu_s", "peak_memory_mb")


class ResultsError(Exception):
    """Results that cannot be read, in one sentence with the file and the remedy."""


@dataclass(frozen=True)
class Quantity:
    """'success_rate', or a measure with a statistic ('median', 'mean') over 'solved' or 'all' runs."""

    measure: str
    statistic: str = ""
    over: str = ""

    @property
    def is_success(self) -> bool:
        return self.measure == "success_rate"


@dataclass(frozen=True)
class PaperColumn:
    """A column of a paper's table, and the quantity of the study that it is compared with."""

    key: str
    title: str
    quantity: Quantity


@dataclass(frozen=True)
class Finding:
    """A claim about cells.

    For each pair of a cell of `cells` and one of `than` that agree in `pair_by`, the quantity of the first is below
    (above) `factor` times that of the second; or, where `than` is a number, below (above) it.

    A selection of cells has the lists "rows", "strategies", "operators" and "scenarios"; a missing list selects all.
    """

    text: str
    quantity: Quantity
    cells: dict[str, list[str]]
    below: bool
    than: Union[dict[str, list[str]], float]
    factor: float = 1.0
    pair_by: tuple[str, ...] = ()


@dataclass(frozen=True)
class Distribution:
    """Statistics of a measure over the runs that have it."""

    count: int
    q1: float = 0.0
    median: float = 0.0
    q3: float = 0.0
    mean: float = 0.0


@dataclass(frozen=True)
class Measure:
    """A measure over the solved runs and over all runs."""

    solved: Distribution
    all: Distribution


@dataclass(frozen=True)
class Value:
    """A value with its spread: Wilson's 95 % interval of a success rate, else the quartiles."""

    value: float
    low: float
    high: float


@dataclass
class Cell:
    """Settings that were run with several seeds, and the statistics of these runs."""

    label: str
    row: str
    scenario: str
    strategy: str
    operator: str
    settings: dict[str, float]
    parameters: dict[str, float]
    planned: int
    runs: int
    statuses: dict[str, int]
    success: Value
    measures: dict[str, Measure]
    paper: dict[str, Any]
    command: str

    @property
    def solved(self) -> int:
        return self.statuses["solved"]

    @property
    def scenario_name(self) -> str:
        """'environment-1' of '../environment-1/scenario.json', or 'tight-star'."""
        path = PurePosixPath(self.scenario)
        return path.parent.name if path.stem == "scenario" else path.stem

    def value_of(self, quantity: Quantity) -> Optional[Value]:
        """The value of a quantity. None where no run has it."""
        if quantity.is_success:
            return self.success if self.runs else None
        measure = self.measures.get(quantity.measure)
        sample = measure and (measure.all if quantity.over == "all" else measure.solved)
        if not sample or not sample.count:
            return None
        value = sample.mean if quantity.statistic == "mean" else sample.median
        return Value(value, sample.q1, sample.q3)

    def paper_text(self, column: PaperColumn) -> str:
        """The paper's number or words in a column; empty where it prints none."""
        printed = self.paper.get(column.key, "")
        if isinstance(printed, str):
            return printed
        return percent(printed) if column.quantity.is_success else short_number(printed)


@dataclass(frozen=True)
class Axis:
    """A parameter that the study varies."""

    key: str
    label: str
    symbol: str
    unit: str


@dataclass(frozen=True)
class Run:
    """One run: the number of its cell, from 1, its seed, its end and the numbers that the page lists."""

    cell: int
    seed: str
    status: str
    numbers: dict[str, Optional[float]]

    @property
    def file(self) -> str:
        return f"runs/cell{self.cell}-seed{self.seed}.json"


@dataclass
class StudyResults:
    """A study with its results."""

    name: str
    title: str
    description: str
    citation: str
    quick: bool
    version: str
    study_sha256: str
    plan_sha256: str
    paper: list[PaperColumn]
    findings: list[Finding]
    axes: list[Axis]
    cells: list[Cell]
    runs: list[Run] = field(default_factory=list)
    omissions: list[tuple[str, ...]] = field(default_factory=list)  # texts with arguments, for Words


RUN_NUMBERS = ("virtual_s", "nodes", "edges", "random_configurations")


def read_results(folder: Path) -> StudyResults:
    """Reads a folder of results. What is missing beside the summary is stated in `omissions`."""
    results = read_json(folder / "summary.json", _study_of)
    _add_timing(results, folder / "timing_summary.csv")
    _add_runs(results, folder / "runs.csv")
    return results


def read_json(file: Path, make: Callable[[Any], Any]) -> Any:
    """Makes a value of a JSON file. A file that is missing or has another form is a ResultsError."""
    try:
        return make(json.loads(file.read_text(encoding="utf-8")))
    except OSError as error:
        raise ResultsError(f"{file}: {error.strerror}. Run the study, or choose its folder of results.") from error
    except KeyError as error:
        raise ResultsError(f"{file}: has no {error}. Write it again: glissade-cli report DIR.") from error
    except (ValueError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        reason = str(error).splitlines()[0]
        raise ResultsError(f"{file}: is malformed: {reason}. Write it again: glissade-cli report DIR.") from error


def text_of(value: Any) -> str:
    """A text of a JSON file. Characters that cannot be written are replaced."""
    if not isinstance(value, str):
        raise ValueError(f"{value!r:.40} is no text")
    return value.encode("utf-8", "replace").decode("utf-8")


def number_of(value: Any) -> float:
    """A finite number of a JSON file."""
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ValueError(f"{value!r:.40} is no number")
    return float(value)


def _count_of(value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= 10**9:
        raise ValueError(f"{value!r:.40} is no count")
    return value


def _study_of(root: dict[str, Any]) -> StudyResults:
    if root["format"] != "glissade-study-summary":
        raise ValueError("it is no summary of a study")
    if root["version"] != SUMMARY_VERSION:
        raise ValueError(f"it has version {root['version']!r:.40}, and version {SUMMARY_VERSION} is known")
    if not root["cells"]:
        raise ValueError("it has no cells")
    return StudyResults(
        name=text_of(root["name"]),
        title=text_of(root["title"]),
        description=text_of(root["description"]),
        citation=text_of(root["citation"]),
        quick=bool(root["quick"]),
        version=text_of(root["glissade"]),
        study_sha256=text_of(root["study_sha256"]),
        plan_sha256=text_of(root["plan_sha256"]),
        paper=[PaperColumn(text_of(c["key"]), text_of(c["title"]), _quantity_of(c)) for c in root["paper"]],
        findings=[_finding_of(finding) for finding in root["findings"]],
        axes=[Axis(*(text_of(a[key]) for key in ("key", "label", "symbol", "unit"))) for a in root["axes"]],
        cells=[_cell_of(cell) for cell in root["cells"]],
    )


def _quantity_of(entry: dict[str, Any]) -> Quantity:
    return Quantity(text_of(entry["measure"]), text_of(entry.get("statistic", "")), text_of(entry.get("over", "")))


def _finding_of(entry: dict[str, Any]) -> Finding:
    than = entry["than"]
    pair_by = tuple(text_of(key) for key in entry.get("pair_by", ()))
    if not set(pair_by) <= {"operator", "scenario", "strategy"}:
        raise ValueError(f"{pair_by} is no pairing")
    return Finding(
        text=text_of(entry["text"]),
        quantity=_quantity_of(entry),
        cells=_selection_of(entry["cells"]),
        below=entry["is"] == "below",
        than=_selection_of(than) if isinstance(than, dict) else number_of(than),
        factor=number_of(entry.get("factor", 1.0)),
        pair_by=pair_by,
    )


def _selection_of(entry: dict[str, Any]) -> dict[str, list[str]]:
    return {key: [text_of(name) for name in names] for key, names in entry.items()}


def _cell_of(entry: dict[str, Any]) -> Cell:
    rate = entry["success_rate"]
    return Cell(
        label=text_of(entry["label"]),
        row=text_of(entry["row"]),
        scenario=text_of(entry["scenario"]),
        strategy=text_of(entry["strategy"]),
        operator=text_of(entry["operator"]),
        settings=_numbers_of(entry["settings"]),
        parameters=_numbers_of(entry["parameters"]),
        planned=_count_of(entry["planned"]),
        runs=_count_of(entry["runs"]),
        statuses={"solved": 0, **{text_of(name): _count_of(count) for name, count in entry["statuses"].items()}},
        success=Value(*(number_of(rate[key]) for key in ("share", "wilson95_low", "wilson95_high"))),
        measures={name: _measure_of(measure) for name, measure in entry["measures"].items()},
        paper={key: text_of(value) if isinstance(value, str) else number_of(value)
               for key, value in entry["paper"].items()},
        command=text_of(entry["command"]),
    )


def _numbers_of(entry: dict[str, Any]) -> dict[str, float]:
    return {key: number_of(value) for key, value in entry.items()}


def _measure_of(entry: dict[str, Any]) -> Measure:
    return Measure(_distribution_of(entry["solved"]), _distribution_of(entry["all"]))


def _distribution_of(entry: dict[str, Any]) -> Distribution:
    if not entry["count"]:
        return Distribution(0)
    return Distribution(_count_of(entry["count"]), *(number_of(entry[key]) for key in ("q1", "median", "q3", "mean")))


def _add_timing(results: StudyResults, file: Path) -> None:
    """Adds the seconds and the memory of each cell to its measures."""
    rows, broken = _read_rows(file, _timing_of)
    for number, measures in rows:
        if 1 <= number <= len(results.cells):
            results.cells[number - 1].measures.update(measures)
    if len(rows) < len(results.cells):
        results.omissions.append(("{0} has no seconds for {1} of {2} cells.", file.name,
                                  str(len(results.cells) - len(rows)), str(len(results.cells))))
    _note_broken(results, file, broken)


def _timing_of(row: dict[str, str]) -> tuple[int, dict[str, Measure]]:
    def distribution(measure: str, over: str) -> Distribution:
        count = int(row[f"{measure}_{over}_n"])
        names = ("q1", "median", "q3", "mean")
        return Distribution(count, *(number_of(float(row[f"{measure}_{over}_{name}"])) for name in names if count))

    measures = {name: Measure(distribution(name, "solved"), distribution(name, "all")) for name in TIMING_MEASURES}
    return int(row["cell"]), measures


def _add_runs(results: StudyResults, file: Path) -> None:
    rows, broken = _read_rows(file, _run_of)
    results.runs = [run for run in rows if 1 <= run.cell <= len(results.cells)]
    counted = sum(cell.runs for cell in results.cells)
    if len(results.runs) + broken < counted:
        results.omissions.append(("{0} has {1} of {2} runs.", file.name, str(len(results.runs)), str(counted)))
    _note_broken(results, file, broken)


def _run_of(row: dict[str, str]) -> Run:
    numbers = {name: number_of(float(row[name])) if row[name] else None for name in RUN_NUMBERS}
    return Run(int(row["cell"]), str(int(row["seed"])), row["status"], numbers)


def _read_rows(file: Path, make: Callable[[dict[str, str]], Any]) -> tuple[list[Any], int]:
    """The rows of a table, and the number of rows that cannot be read. A missing table has no rows."""
    rows: list[Any] = []
    broken = 0
    try:
        with file.open(encoding="utf-8", newline="") as lines:
            for row in csv.DictReader(lines, strict=True):
                try:
                    rows.append(make(row))
                except (ValueError, TypeError, KeyError):
                    broken += 1
    except (csv.Error, ValueError):
        broken += 1
    except OSError:
        pass
    return rows, broken


def _note_broken(results: StudyResults, file: Path, broken: int) -> None:
    if broken:
        results.omissions.append(("Lines of {0} that cannot be read and are left out: {1}.", file.name, str(broken)))
