"""Writes the page of a study: settings, the paper's table beside ours, findings, plots, pictures, runs and times.

usage: report.py DIR [--out DIR] [--pdf FILE] [--plots DIR] [--language en|fr]

`glissade-cli report DIR` brings the tables in DIR up to date and then runs this script.
"""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path
from typing import Optional

from page import Page
from script import carry_out, describe_machine, parser_of, save_page
from study_results import StudyResults, read_results
from words import Words


def main(arguments: Optional[list[str]] = None) -> None:
    parser = parser_of("Write the page of a study.", "folder of results")
    parser.add_argument("--plots", type=Path, metavar="DIR", help="save each plot as an SVG file there, too")
    options = parser.parse_args(arguments)
    out = options.out or options.folder
    # The tables are where the page is written, where DIR cannot be written.
    tables = out if (out / "summary.json").exists() else options.folder
    words = Words(options.language)
    results = read_results(tables)
    html = page_of(results, options.folder, out, words, for_paper=bool(options.pdf))
    save_page(html, options.pdf or out / "report.html", bool(options.pdf))
    if options.plots:
        save_plots(results, words, options.plots)


def page_of(results: StudyResults, folder: Path, out: Path, words: Words, for_paper: bool = False) -> str:
    """The page as HTML in the folder `out`. On paper it has no list of runs."""
    import study_tables as tables

    page = Page(words(results.title), words.language)
    if results.description:
        page.text(words(results.description))
    if results.citation:
        page.text(words("After: {0}.", results.citation))
    for omission in results.omissions:
        page.text(words(*omission))
    page.heading(words("What was run"))
    page.table(tables.settings_table(results, words))
    page.heading(words("The paper's table, and ours" if results.paper else "Results"))
    page.table(tables.paper_table(results, words))
    notes = tables.notes_table(results, words)
    if notes.rows:
        page.table(notes)
    if results.findings:
        page.heading(words("Findings"))
        page.table(tables.findings_table(results, words))
    page.heading(words("Plots"))
    _add_plots(page, results, words, for_paper)
    _add_pictures(page, folder / "pictures", words)
    page.heading(words("How runs ended"))
    page.table(tables.endings_table(results, words))
    if not for_paper:
        _add_runs(page, results, folder, out, words)
    _add_commands(page, results, words)
    page.heading(words("Time on the machine"))
    page.text(words("Seconds and memory depend on the machine that carried out the run. Of the sections above, only "
                    "findings and plots in seconds depend on it. This report was written on {0}.", describe_machine()))
    page.table(tables.timing_table(results, words))
    return page.html()


def _add_plots(page: Page, results: StudyResults, words: Words, for_paper: bool) -> None:
    from plots import svg_of
    from study_plots import plots_of

    for plot in plots_of(results, words):
        page.figure(plot.name, svg_of(plot, for_screen=not for_paper), plot.title, plot.caption)


def save_plots(results: StudyResults, words: Words, folder: Path) -> None:
    """Saves each plot as an SVG file."""
    from page import save_whole
    from plots import svg_of
    from study_plots import plots_of

    for plot in plots_of(results, words):
        save_whole(folder / f"{plot.name}.svg", svg_of(plot, for_screen=False).encode("utf-8"))


def _add_pictures(page: Page, folder: Path, words: Words) -> None:
    """The pictures that `glissade-offscreen --study-pictures` took, with their texts as captions."""
    files = sorted(folder.glob("*.png"))
    if files:
        page.heading(words("Typical roadmaps"))
    for file in files:
        text = file.with_suffix(".txt")
        page.picture(file.read_bytes(), text.read_text(encoding="utf-8") if text.exists() else file.stem)


def _add_runs(page: Page, results: StudyResults, folder: Path, out: Path, words: Words) -> None:
    import study_tables as tables

    page.heading(words("Runs"))
    page.text(words("A run can be seen again in the window: Plan > Studies > Open run of a study, with its file. This command "
                    "does the same for the first run:"))
    page.commands([f"glissade {shlex.quote(str(folder.resolve() / run.file))}" for run in results.runs[:1]])
    for number, cell in enumerate(results.cells, 1):
        runs = [run for run in results.runs if run.cell == number]
        if runs:
            table = tables.runs_table(runs, os.path.relpath(folder, out), words)
            page.folded(words("{0} (runs: {1})", cell.label, len(runs)), table)


def _add_commands(page: Page, results: StudyResults, words: Words) -> None:
    name = shlex.quote(results.name)
    quick = " --quick" if results.quick else ""
    page.heading(words("How to repeat it"))
    page.text(words("The whole study, from the folder of its file:"))
    page.commands([f"glissade-cli study {shlex.quote(results.name + '.json')} --out out/{name}{quick} --jobs 2",
                   f"glissade-offscreen --study-pictures out/{name}", f"glissade-cli report out/{name}"])
    page.text(words("The first run of each cell, from the same folder; the others differ in their --seed only:"))
    page.commands([line for cell in results.cells for line in (f"# {cell.label}", cell.command)])


if __name__ == "__main__":
    sys.exit(carry_out(main))
