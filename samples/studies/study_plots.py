"""The plots of a study: each quantity over each parameter that its cells vary, or over scenarios."""

from __future__ import annotations

import math
from typing import Optional

from number_text import exact_number, percent, short_number
from plots import CATEGORIES, LOGARITHMIC, PERCENTAGES, Plot, Point, Scale, Series, fitting
from study_results import Axis, Cell, PaperColumn, Quantity, StudyResults, Value
from words import Words

# Parameters of OMPL's planners distinguish series and panels, and are no axis of their own.
OMPL_RANGE = "ompl_range"
OMPL_RESOLUTION = "ompl_resolution"

SUCCESS = PaperColumn("success_rate", "Success rate", Quantity("success_rate"))
USUAL_COLUMNS = [
    PaperColumn("virtual_s", "Virtual time (s)", Quantity("virtual_s", "median", "solved")),
    PaperColumn("nodes", "Nodes", Quantity("nodes", "median", "solved")),
    PaperColumn("random_configurations", "Random configurations",
                Quantity("random_configurations", "median", "solved")),
]


def plots_of(results: StudyResults, words: Words) -> list[Plot]:
    """The series are strategies and operators, and the paper's numbers."""
    axes: list[Optional[Axis]] = [axis for axis in results.axes if axis.key not in (OMPL_RANGE, OMPL_RESOLUTION)]
    return [_Plotter(results, axis, panel, words).plot(column)
            for axis in axes or [None] for panel in _panels_of(results) for column in _columns_of(results)]


def _columns_of(results: StudyResults) -> list[PaperColumn]:
    columns = results.paper or USUAL_COLUMNS
    return columns if any(column.quantity.is_success for column in columns) else [*columns, SUCCESS]


def _panels_of(results: StudyResults) -> list[Optional[float]]:
    """A panel for each resolution at which OMPL's planners check edges. None: one panel of all cells."""
    values = {cell.settings[OMPL_RESOLUTION] for cell in results.cells if OMPL_RESOLUTION in cell.settings}
    return sorted(values, reverse=True) if len(values) > 1 else [None]


class _Plotter:
    """Makes the plots of one study over one parameter, or over scenarios, in one panel."""

    def __init__(self, results: StudyResults, along: Optional[Axis], panel: Optional[float], words: Words) -> None:
        self._results = results
        self._along = along
        self._panel = panel
        self._words = words
        self._scenarios = list(dict.fromkeys(cell.scenario_name for cell in results.cells))
        self._several_strategies = len({cell.strategy for cell in results.cells}) > 1
        self._several_scenarios = len({cell.scenario for cell in results.cells}) > 1

    def plot(self, column: PaperColumn) -> Plot:
        series = self._ours(column)
        plot = Plot(self._name(column), self._title(column), self._caption(column.quantity), Scale(""), Scale(""),
                    bars=self._along is None, series=series + self._papers(column, series))
        self._set_scales(column, plot)
        return plot

    def _name(self, column: PaperColumn) -> str:
        over = f"-over-{self._along.key}" if self._along else ""
        return column.key + over + (f"-at-{exact_number(self._panel)}" if self._panel is not None else "")

    def _title(self, column: PaperColumn) -> str:
        title = self._words(column.title)
        if self._along:
            title = self._words("{0} over {1}", title, self._words(self._along.label))
        else:
            title = self._words("{0} over scenario and strategy", title)
        if self._panel is not None:
            title += self._words(", OMPL's edges looked at every {0} %", exact_number(100 * self._panel))
        return title

    def _caption(self, quantity: Quantity) -> str:
        described = describe(quantity, self._words)
        text = "{0}, with Wilson's 95 % interval." if quantity.is_success else "{0}, with quartiles."
        text = self._words(text, described[0].upper() + described[1:])
        if not self._along and not quantity.is_success:
            text += " " + self._words("Above each bar: success rate in %.")
        for cell in self._results.cells:
            if self._along and self._along.key not in cell.settings:
                text += " " + self._words("Not on this axis: {0}.", cell.label)
        return text

    def _x_of(self, cell: Cell) -> Optional[float]:
        if self._along:
            return cell.settings.get(self._along.key)
        return float(self._scenarios.index(cell.scenario_name))

    def _series_name(self, cell: Cell) -> str:
        parts = [cell.strategy] if self._several_strategies else []
        if cell.operator != "none":
            parts.append(cell.operator)
        if self._along and self._several_scenarios:
            parts.append(cell.scenario_name)
        for axis in self._results.axes:
            if axis is not self._along and axis.key != OMPL_RESOLUTION and axis.key in cell.settings:
                parts.append(f"{axis.key} {short_number(cell.settings[axis.key])}")
        return ", ".join(parts) or "Glissade"

    def _ours(self, column: PaperColumn) -> list[Series]:
        series: dict[str, Series] = {}
        for cell in self._results.cells:
            x = self._x_of(cell)
            if x is None or self._panel not in (None, cell.settings.get(OMPL_RESOLUTION, self._panel)):
                continue
            name = self._series_name(cell)
            own = series.setdefault(name, Series(name, len(series)))
            value = cell.value_of(column.quantity)
            if value:
                own.points.append(self._point(x, cell, column, value))
        for own in series.values():
            own.points.sort(key=lambda point: point.x)
        return list(series.values())

    def _point(self, x: float, cell: Cell, column: PaperColumn, value: Value) -> Point:
        unit = 100.0 if column.quantity.is_success else 1.0
        show = percent if column.quantity.is_success else short_number
        says = self._words("{0}: {1} ({2} to {3}), {4} of {5} solved", cell.label, show(value.value), show(value.low),
                           show(value.high), cell.solved, cell.runs)
        marked = not self._along and not column.quantity.is_success
        mark = short_number(math.floor(100 * cell.success.value + 0.5)) if marked else ""
        return Point(x, unit * value.value, unit * value.low, unit * value.high, says, mark)

    def _papers(self, column: PaperColumn, ours: list[Series]) -> list[Series]:
        """The paper's numbers, one series for each strategy: it prints one number for a row, for all operators."""
        series: dict[str, Series] = {}
        seen = set()
        for cell in self._results.cells:
            x = self._x_of(cell)
            number = cell.paper.get(column.key)
            place = (cell.row, cell.strategy, cell.scenario)
            if x is None or not isinstance(number, (int, float)) or place in seen:
                continue
            seen.add(place)
            own = series.setdefault(cell.strategy, self._paper_series(cell, ours))
            value = 100.0 * number if column.quantity.is_success else float(number)
            shown = percent(number) if column.quantity.is_success else short_number(number)
            own.points.append(Point(x, value, value, value, self._words("{0}, paper: {1}", cell.row, shown)))
        for own in series.values():
            own.points.sort(key=lambda point: point.x)
        return list(series.values())

    def _paper_series(self, cell: Cell, ours: list[Series]) -> Series:
        names = [series.name for series in ours]
        name = self._series_name(cell)
        beside = names.index(name) if not self._along and name in names else None
        return Series(self._words("paper"), of_paper=True, beside=beside)

    def _set_scales(self, column: PaperColumn, plot: Plot) -> None:
        points = [point for series in plot.series for point in series.points]
        title = self._words(column.title)
        if self._along:
            plot.x = fitting(_axis_title(self._along, self._words), [point.x for point in points])
        else:
            plot.x = Scale(self._words("Scenario"), CATEGORIES, names=self._scenarios)
        # Zeros have no place on a logarithmic axis.
        ys = [y for point in points for y in (point.y, point.low, point.high) if y > 0]
        if column.quantity.is_success:
            plot.y = Scale(f"{title} (%)", PERCENTAGES)
        elif self._along:
            plot.y = fitting(title, ys)
        else:
            # Bars start at a power of ten below all of them.
            bottom = [10.0 ** math.floor(math.log10(min(ys)))] if ys else []
            plot.y = Scale(title, LOGARITHMIC, ys + bottom)


def _axis_title(axis: Axis, words: Words) -> str:
    symbol = f" {axis.symbol}" if axis.symbol else ""
    unit = f" ({axis.unit})" if axis.unit else ""
    return words(axis.label) + symbol + unit


def describe(quantity: Quantity, words: Words) -> str:
    """'median of nodes over the solved runs', or 'success rate'."""
    measure = words(quantity.measure.replace("_", " "))
    if quantity.is_success:
        return measure
    if quantity.statistic == "mean":
        text = "mean of {0} over all runs" if quantity.over == "all" else "mean of {0} over the solved runs"
    else:
        text = "median of {0} over all runs" if quantity.over == "all" else "median of {0} over the solved runs"
    return words(text, measure)
