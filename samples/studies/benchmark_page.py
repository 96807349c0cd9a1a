"""Writes the page of a folder that packaging/benchmarks.sh filled: DIR/benchmarks.html.

usage: benchmark_page.py DIR [--out DIR] [--pdf FILE]

    collision.json, nearest_neighbours.json, octree.json, growth.json   of tests/benchmarks
    a folder for each study
    commands.txt   what was run

The page depends on these files only. A missing file is named on the page.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Optional

from benchmark_results import (BackendTimes, BenchmarkRun, BenchmarkTime, GrowthSeries, backend_times, benchmark_run,
                               geometric_mean, growth_series)
from number_text import exact_number, short_number
from page import NUMBER, TEXT, VERDICT, Page, Table
from script import carry_out, parser_of, save_page
from study_findings import HOLDS, OPEN, REFUTED
from study_results import Cell, Quantity, ResultsError, StudyResults, read_json, read_results
from words import Words

OURS = "auto"
PEER_PREFIX = "peer-"
PROGRAMS = ("collision", "nearest_neighbours", "growth", "octree")
SECONDS = Quantity("planning_cpu_s", "median", "all")

# A query of the kernel, the finding, and the required ratio to FCL's time (geometric mean).
AIMS = (
    ("collide", "Collide: 30 times faster than FCL.", 30.0),
    ("distance", "Distance with nearest points: 15 times faster than FCL.", 15.0),
    ("edge", "A certified edge: 10 times faster than 20 discrete checks by FCL.", 10.0),
)
# A quantity that grows with the size, its name in the plot, and the name of the size.
GROWING = (
    ("nearest", "Nearest neighbour", "Configurations"),
    ("iteration", "Iteration of a planner", "Nodes of its trees"),
    ("collide", "Collide", "Triangles"),
    ("distance", "Distance", "Triangles"),
    ("edge", "Edge: certified by the kernel, 20 discrete checks by FCL", "Triangles"),
)
ORIGIN = (("date", "Date"), ("machine", "Machine"), ("libraries", "Libraries"), ("glissade", "Glissade"),
          ("commit", "Commit"), ("library_build_type", "Google Benchmark, built for"))


def main(arguments: Optional[list[str]] = None) -> None:
    parser = parser_of("Write the page of the benchmarks.", "folder that packaging/benchmarks.sh filled")
    options = parser.parse_args(arguments)
    html = page_of(options.folder, for_paper=bool(options.pdf))
    save_page(html, options.pdf or (options.out or options.folder) / "benchmarks.html", bool(options.pdf))


def page_of(folder: Path, for_paper: bool = False) -> str:
    """The page as HTML."""
    runs = {name: read_json(file, benchmark_run)
            for name in PROGRAMS if (file := folder / f"{name}.json").exists()}
    studies = sorted(plan.parent for plan in folder.glob("*/plan.json"))
    if not runs and not studies:
        raise ResultsError(f"{folder}: holds no results of benchmarks. Run packaging/benchmarks.sh, and give the "
                           "folder that it filled.")
    writer = _Writer(runs, for_paper)
    writer.write(studies, folder / "commands.txt")
    return writer.page.html()


class _Writer:
    """Adds the sections of the page."""

    def __init__(self, runs: dict[str, BenchmarkRun], for_paper: bool) -> None:
        self.page = Page("Glissade, measured beside its peers")
        self._runs = runs
        self._for_paper = for_paper

    def write(self, studies: list[Path], commands: Path) -> None:
        self._add_origin()
        self._add_collision()
        self._add_growth("nearest_neighbours", "Nearest neighbours: our tree and the plain scan")
        self._add_growth("growth", "Growth")
        if times := self._begin("Octree: one part moved, and built afresh", "octree"):
            self.page.table(times_table(times))
        for study in studies:
            self._add_study(study)
        if commands.exists():
            self.page.heading("What was run")
            self.page.commands(commands.read_text(encoding="utf-8").splitlines())

    def _add_origin(self) -> None:
        rows = []
        for key, title in ORIGIN:
            values = sorted({run.context[key] for run in self._runs.values() if key in run.context})
            if values:
                rows.append([title, "; ".join(values)])
        self.page.heading("Where the numbers are from")
        self.page.table(Table([("", TEXT), ("", TEXT)], rows))

    def _begin(self, heading: str, name: str) -> list[BenchmarkTime]:
        """Begins a section. Returns its times, or nothing after a note that there are none."""
        self.page.heading(heading)
        times = self._runs[name].times if name in self._runs else []
        if not times:
            self.page.text(f"Not measured this time ({name}_benchmark).")
        return times

    def _add_collision(self) -> None:
        times = self._begin("Collision: our kernel and FCL", "collision")
        if times:
            pairs = backend_times(times)
            self.page.table(aims_table(pairs))
            self.page.table(ratio_table(pairs))

    def _add_growth(self, name: str, heading: str) -> None:
        series = growth_series(self._begin(heading, name))
        for quantity, title, size in GROWING:
            chosen = [each for each in series if each.quantity == quantity]
            if chosen:
                self._add_plot(growth_plot(quantity, title, size, chosen))
        if series:
            self.page.table(growth_table(series))

    def _add_plot(self, plot) -> None:
        from plots import svg_of

        self.page.figure(plot.name, svg_of(plot, for_screen=not self._for_paper), plot.title, plot.caption)

    def _add_study(self, folder: Path) -> None:
        """Findings, `auto` beside the best of the others, plots, endings of runs and seconds of a study."""
        import study_tables as tables
        from study_plots import plots_of

        try:
            results = read_results(folder)
        except ResultsError as error:
            self.page.heading(folder.name)
            self.page.text(f"Left out: {error}")
            print(f"warning: {error}", file=sys.stderr)
            return
        words = Words()
        self.page.heading(results.title)
        self.page.text(results.description + (" This is the quick size." if results.quick else ""))
        for omission in results.omissions:
            self.page.text(words(*omission))
        if results.findings:
            self.page.table(tables.findings_table(results, words))
        beside = beside_the_best(results)
        if beside.rows:
            self.page.table(beside)
        for plot in plots_of(results, words):
            plot.name = f"{results.name}-{plot.name}"
            self._add_plot(plot)
        self.page.table(tables.endings_table(results, words))
        self.page.table(tables.timing_table(results, words))


def aims_table(pairs: list[BackendTimes]) -> Table:
    table = Table([("Finding", TEXT), ("Verdict", VERDICT), ("Geometric mean", NUMBER)],
                  verdicts={HOLDS: "holds", REFUTED: "refuted", OPEN: "open"})
    for question, text, ratio in AIMS:
        mean = geometric_mean(pairs, question)
        verdict = OPEN if mean is None else HOLDS if mean >= ratio else REFUTED
        table.rows.append([text, verdict, "–" if mean is None else short_number(mean)])
    return table


def ratio_table(pairs: list[BackendTimes]) -> Table:
    table = Table([("Question", TEXT), ("Model and poses", TEXT), ("FCL (µs)", NUMBER), ("Kernel (µs)", NUMBER),
                   ("Times faster", NUMBER)],
                  caption="The same meshes and poses, one core; surfaces alone in both.")
    for pair in pairs:
        table.rows.append([pair.question, pair.place, _microseconds(pair.fcl), _microseconds(pair.kernel),
                           short_number(pair.ratio)])
    return table


def growth_plot(quantity: str, title: str, size: str, all_series: list[GrowthSeries]):
    from plots import LOGARITHMIC, Plot, Point, Scale, Series

    plot = Plot(f"growth-{quantity}", title,
                "Both axes are logarithmic; n^k in the legend is fitted to all points of a line (least squares).",
                Scale(size, LOGARITHMIC), Scale("Time (µs)", LOGARITHMIC))
    for growth in all_series:
        exponent = growth.exponent
        name = growth.who + (f": n^{short_number(exponent)}" if exponent is not None else "")
        series = Series(name, len(plot.series))
        for number, seconds in growth.points:
            time = 1e6 * seconds
            says = f"{growth.who}, {short_number(number)}: {short_number(time)} µs"
            series.points.append(Point(number, time, time, time, says))
            plot.x.values.append(number)
            plot.y.values.append(time)
        plot.series.append(series)
    return plot


def growth_table(all_series: list[GrowthSeries]) -> Table:
    table = Table([("Quantity", TEXT), ("Who", TEXT), ("Exponent", NUMBER), ("Sizes", NUMBER), ("Times (µs)", NUMBER)])
    for quantity, title, _ in GROWING:
        for growth in all_series:
            if growth.quantity != quantity:
                continue
            (smallest, shortest), (largest, longest) = growth.points[0], growth.points[-1]
            exponent: Optional[float] = growth.exponent
            table.rows.append([title, growth.who, "–" if exponent is None else short_number(exponent),
                               f"{short_number(smallest)} – {short_number(largest)}",
                               f"{_microseconds(shortest)} – {_microseconds(longest)}"])
    return table


def times_table(times: list[BenchmarkTime]) -> Table:
    table = Table([("Benchmark", TEXT), ("Time (ms)", NUMBER), ("Counters", TEXT)])
    for time in times:
        counters = ", ".join(f"{name} {short_number(value)}" for name, value in time.counters.items())
        table.rows.append([time.name, short_number(1e3 * time.seconds), counters])
    return table


def beside_the_best(results: StudyResults) -> Table:
    """`auto` beside the best of those that look at edges in the same way, for each scenario and way."""
    table = Table([("Problem", TEXT), ("auto, solved", NUMBER), ("auto, s", NUMBER), ("Best of the others", TEXT),
                   ("It looks at edges", TEXT), ("It solved", NUMBER), ("It took, s", NUMBER), ("Times", NUMBER)],
                  caption="The best of the others is the one that solved most, and of these the fastest; of those that "
                          "look at edges in the same way. Seconds of the processor while planning: median over all "
                          "runs, also those that ended without a path.")
    scenarios: dict[str, list[Cell]] = {}
    for cell in results.cells:
        if cell.value_of(SECONDS):
            scenarios.setdefault(cell.scenario, []).append(cell)
    for cells in scenarios.values():
        ours = next((cell for cell in cells if cell.strategy == OURS), None)
        for other in _best_others(cells) if ours else []:
            table.rows.append(_beside_row(ours, other))
    return table


def _best_others(cells: list[Cell]) -> list[Cell]:
    best: dict[str, Cell] = {}
    for cell in cells:
        if cell.strategy == OURS:
            continue
        rival = best.setdefault(_edges_of(cell), cell)
        if (-cell.success.value, _seconds(cell)) < (-rival.success.value, _seconds(rival)):
            best[_edges_of(cell)] = cell
    return list(best.values())


def _beside_row(ours: Cell, other: Cell) -> list[str]:
    return [ours.scenario_name, _solved(ours), short_number(_seconds(ours)), other.label, _edges_of(other),
            _solved(other), short_number(_seconds(other)), short_number(_seconds(other) / _seconds(ours))]


def _edges_of(cell: Cell) -> str:
    """How the planner of a cell looks at edges."""
    if not cell.strategy.startswith(PEER_PREFIX):
        return "certified"
    return f"every {exact_number(100 * cell.parameters['ompl_resolution'])} %"


def _seconds(cell: Cell) -> float:
    value = cell.value_of(SECONDS)
    return value.value if value else 0.0


def _solved(cell: Cell) -> str:
    return f"{cell.solved} of {cell.runs}"


def _microseconds(seconds: float) -> str:
    return short_number(1e6 * seconds)


if __name__ == "__main__":
    sys.exit(carry_out(main))
