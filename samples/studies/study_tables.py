"""The tables of a study's page."""

from __future__ import annotations

import os
from typing import Optional

from number_text import percent, short_number
from page import NUMBER, PROSE, TEXT, VERDICT, Link, Table
from study_findings import HOLDS, OPEN, REFUTED, check_finding
from study_plots import describe
from study_results import RUN_NUMBERS, Cell, PaperColumn, Quantity, Run, StudyResults, Value
from words import Words

NOTHING = "–"


def verdict_classes(words: Words) -> dict[str, str]:
    return {words(HOLDS): "holds", words(REFUTED): "refuted", words(OPEN): "open"}


def settings_table(results: StudyResults, words: Words) -> Table:
    """What was run."""
    cells = results.cells

    def names(attribute: str) -> str:
        return ", ".join(sorted({getattr(cell, attribute) for cell in cells}))

    size = "{0}, quick size" if results.quick else "{0}, full size"
    runs = words("{0} of {1}, {2} of them solved, in {3} cells", sum(cell.runs for cell in cells),
                 sum(cell.planned for cell in cells), sum(cell.solved for cell in cells), len(cells))
    return Table([("", TEXT), ("", TEXT)], [
        [words("Study"), words(size, results.name)],
        [words("Runs"), runs],
        [words("Scenarios"), names("scenario")],
        [words("Strategies"), names("strategy")],
        [words("Operators"), names("operator")],
        ["Glissade", results.version],
        [words("Study file, SHA-256"), results.study_sha256],
        [words("Plan, SHA-256"), results.plan_sha256],
    ])


def paper_table(results: StudyResults, words: Words) -> Table:
    """A row for each cell: its success, and the paper's numbers beside ours."""
    table = Table([(words("Row"), TEXT), (words("Solved"), NUMBER), (words("Success"), NUMBER)],
                  caption=words("Ours: median or mean as the column says, quartiles in brackets; success with "
                                "Wilson's 95 % interval."))
    for column in results.paper:
        title = words(column.title)
        printed = _is_printed(results, column)
        if printed:
            table.columns.append((words("{0}, paper", title), NUMBER))
        if not column.quantity.is_success:
            table.columns.append((words("{0}, ours", title) if printed else title, NUMBER))
    for cell in results.cells:
        row: list[str | Link] = [cell.label, words("{0} of {1}", cell.solved, cell.runs), _success_text(cell)]
        for column in results.paper:
            if _is_printed(results, column):
                row.append(cell.paper_text(column))
            if not column.quantity.is_success:
                row.append(_spread_text(cell.value_of(column.quantity)))
        table.rows.append(row)
    return table


def notes_table(results: StudyResults, words: Words) -> Table:
    """The notes on the paper's rows, each once."""
    table = Table([(words("Row"), TEXT), (words("Note on the paper"), TEXT)])
    for cell in results.cells:
        note = cell.paper.get("note")
        row: list[str | Link] = [cell.row, words(note)] if isinstance(note, str) and note else []
        if row and row not in table.rows[-1:]:
            table.rows.append(row)
    return table


def findings_table(results: StudyResults, words: Words) -> Table:
    """The findings with their verdicts."""
    table = Table([(words("Finding"), PROSE), (words("Verdict"), VERDICT), (words("Pairs"), NUMBER),
                   (words("Quantity"), TEXT), (words("Numbers"), TEXT)],
                  caption=words("Each compares every pair of cells that it speaks of; the numbers are of the pair "
                                "that speaks most against it."),
                  verdicts=verdict_classes(words))
    for finding in results.findings:
        checked = check_finding(finding, results, words)
        table.rows.append([words(finding.text), words(checked.verdict),
                           words("{0} of {1}", checked.agreeing, checked.compared),
                           describe(finding.quantity, words), checked.numbers])
    return table


def endings_table(results: StudyResults, words: Words) -> Table:
    """How the runs of each cell ended."""
    statuses = list(results.cells[0].statuses)
    table = Table([(words("Row"), TEXT), (words("Strategy"), TEXT), (words("Operator"), TEXT),
                   (words("Planned"), NUMBER), (words("Run"), NUMBER),
                   *((words(status), NUMBER) for status in statuses)])
    for cell in results.cells:
        counts = [str(cell.statuses.get(status) or "") for status in statuses]
        table.rows.append([cell.label, cell.strategy, cell.operator, str(cell.planned), str(cell.runs), *counts])
    return table


def runs_table(runs: list[Run], folder: str, words: Words) -> Table:
    """The runs of a cell. The file of each run, in the folder of results, opens it in the window."""
    table = Table([(words("Seed"), NUMBER), (words("Ending"), TEXT), (words("Virtual time (s)"), NUMBER),
                   (words("Nodes"), NUMBER), (words("Edges"), NUMBER), (words("Random configurations"), NUMBER),
                   (words("File"), TEXT)])
    for run in runs:
        numbers = [NOTHING if run.numbers[name] is None else short_number(run.numbers[name]) for name in RUN_NUMBERS]
        file = Link(run.file, os.path.normpath(os.path.join(folder, run.file)))
        table.rows.append([run.seed, words(run.status), *numbers, file])
    return table


def timing_table(results: StudyResults, words: Words) -> Table:
    """Seconds and memory of the cells."""
    table = Table([(words("Row"), TEXT), (words("Planning (s)"), NUMBER), (words("Planning (CPU s)"), NUMBER),
                   (words("Process (s)"), NUMBER), (words("Process (CPU s)"), NUMBER), (words("Memory (MB)"), NUMBER)],
                  caption=words("Median and quartiles over all runs."))
    for cell in results.cells:
        spreads = [_spread_text(cell.value_of(Quantity(measure, "median", "all")))
                   for measure in ("planning_s", "planning_cpu_s", "wall_s", "cpu_s", "peak_memory_mb")]
        table.rows.append([cell.label, *spreads])
    return table


def _is_printed(results: StudyResults, column: PaperColumn) -> bool:
    return any(column.key in cell.paper for cell in results.cells)


def _spread_text(value: Optional[Value]) -> str:
    if value is None:
        return NOTHING
    return f"{short_number(value.value)} ({short_number(value.low)} – {short_number(value.high)})"


def _success_text(cell: Cell) -> str:
    if not cell.runs:
        return NOTHING
    return f"{percent(cell.success.value)} ({percent(cell.success.low)} – {percent(cell.success.high)})"
