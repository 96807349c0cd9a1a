"""Plots as values, and their drawing by matplotlib as SVG."""

from __future__ import annotations

import io
import math
import re
from dataclasses import dataclass, field
from typing import Optional
from xml.etree import ElementTree

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator
from matplotlib.transforms import ScaledTranslation

from number_text import short_number

INK = "#1d2329"
FAINT = "#c9d0d8"
GROUND = "#ffffff"
# Okabe and Ito's colours, which can be distinguished with any colour blindness, on light and on dark ground.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
MARKERS = ("o", "s", "^")
HATCHES = ("", "////", "....")

WIDTH_INCHES = 9.2
AXES_HEIGHT_INCHES = 3.3
LEFT_INCHES = 0.78
RIGHT_INCHES = 0.25  # includes half of a long last label
TOP_INCHES = 0.2
AXIS_INCHES = 0.5  # labels of the ticks and the title of the axis
LEGEND_ROW_INCHES = 0.21
LETTER_INCHES = 0.078
TURNED_DEGREES = 28
BARS_SHARE = 0.84  # share of a category's width that its bars take
NARROWEST_MARK_POINTS = 15
DODGE_POINTS = 4.6  # distance between points of different series at one x
SPAN_FOR_LOGARITHMS = 20.0
MOST_DECADES_WITH_MINOR_LABELS = 3.1
LETTERS_OF_LEGEND = 108  # letters and keys that one row of a legend has room for
LETTERS_OF_AXIS = 104  # letters that fit under the axis

_SVG = "http://www.w3.org/2000/svg"
_XLINK = "http://www.w3.org/1999/xlink"
_FONT = re.compile(r"font: (\S+) 'DejaVu Sans'")


@dataclass
class Point:
    """A point with its interval (none where low is high), a mark above it, and the text of its tooltip."""

    x: float
    y: float
    low: float
    high: float
    says: str
    mark: str = ""


@dataclass
class Series:
    """Points of one name. Those of a paper are diamonds in the colour of the text."""

    name: str
    style: int = 0
    of_paper: bool = False
    beside: Optional[int] = None  # bars: index of the series at whose place the paper's points are
    points: list[Point] = field(default_factory=list)

    @property
    def colour(self) -> str:
        return INK if self.of_paper else COLOURS[self.style % len(COLOURS)]

    @property
    def marker(self) -> str:
        return "D" if self.of_paper else MARKERS[self.style % len(MARKERS)]

    @property
    def hatch(self) -> str:
        return HATCHES[self.style // len(COLOURS) % len(HATCHES)]


LINEAR = "linear"
LOGARITHMIC = "logarithmic"
PERCENTAGES = "percentages"
CATEGORIES = "categories"


@dataclass
class Scale:
    """An axis: its title, its kind, the values that it has room for, and the names of categories."""

    title: str
    kind: str = LINEAR
    values: list[float] = field(default_factory=list)
    names: list[str] = field(default_factory=list)


@dataclass
class Plot:
    """A plot. Its bars are over categories; without bars it has lines."""

    name: str
    title: str
    caption: str
    x: Scale
    y: Scale
    bars: bool = False
    series: list[Series] = field(default_factory=list)


def fitting(title: str, values: list[float]) -> Scale:
    """A logarithmic axis where the positive values span more than a factor of twenty, else a linear one."""
    positive = [value for value in values if value > 0]
    wide = bool(positive) and max(positive) > SPAN_FOR_LOGARITHMS * min(positive)
    return Scale(title, LOGARITHMIC if wide else LINEAR, values)


def svg_of(plot: Plot, for_screen: bool = True) -> str:
    """The plot as an <svg> element. The same plot gives the same text.

    On a screen its colours follow the style sheet of the page (light and dark). For paper they are fixed.
    """
    settings = {"svg.fonttype": "none", "svg.hashsalt": plot.name, "font.family": "DejaVu Sans", "font.size": 9,
                "hatch.linewidth": 0.6, "axes.linewidth": 0.8}
    with matplotlib.rc_context(settings):
        figure, axes = _frame(plot)
        says = _Drawing(plot, axes).draw()
        content = io.BytesIO()
        figure.savefig(content, format="svg", metadata={"Date": None, "Creator": None}, facecolor="none")
    return _clean_svg(content.getvalue(), plot.title, says, for_screen)


def _frame(plot: Plot) -> tuple[Figure, Axes]:
    """The axes of a plot, with room for turned names of categories and for the rows of the legend below them."""
    turned = _is_crowded(plot.x.names)
    longest = LETTER_INCHES * max((len(name) for name in plot.x.names), default=0) if turned else 0.0
    names = longest * math.sin(math.radians(TURNED_DEGREES))
    left = max(LEFT_INCHES, longest * math.cos(math.radians(TURNED_DEGREES)) - 3.0 / max(1, len(plot.x.names)))
    rows, columns = _legend_shape(plot)
    bottom = AXIS_INCHES + names + 0.12 + LEGEND_ROW_INCHES * rows
    height = TOP_INCHES + AXES_HEIGHT_INCHES + bottom
    figure = Figure(figsize=(WIDTH_INCHES, height))
    FigureCanvasSVG(figure)
    axes = figure.add_axes((left / WIDTH_INCHES, bottom / height, (WIDTH_INCHES - left - RIGHT_INCHES) / WIDTH_INCHES,
                            AXES_HEIGHT_INCHES / height))
    keys = _legend_keys(plot)
    if keys:
        axes.legend(list(keys.values()), list(keys), loc="lower left", bbox_to_anchor=(LEFT_INCHES / WIDTH_INCHES, 0),
                    bbox_transform=figure.transFigure, ncol=columns, frameon=False, fontsize=9, labelcolor=INK,
                    borderaxespad=0, borderpad=0.2, handlelength=2, columnspacing=1.6, labelspacing=0.4)
    return figure, axes


def _is_crowded(names: list[str]) -> bool:
    """True where the names of categories do not fit beside each other."""
    return len(names) * (max((len(name) for name in names), default=0) + 2) > LETTERS_OF_AXIS


def _legend_shape(plot: Plot) -> tuple[int, int]:
    """Rows and columns of the legend."""
    names = {series.name for series in plot.series}
    if not names:
        return 0, 1
    columns = max(1, min(len(names), LETTERS_OF_LEGEND // (max(len(name) for name in names) + 7)))
    return math.ceil(len(names) / columns), columns


def _legend_keys(plot: Plot) -> dict[str, object]:
    keys: dict[str, object] = {}
    for series in plot.series:
        keys.setdefault(series.name, _legend_key(plot, series))
    return keys


class _Drawing:
    """Draws a plot into axes."""

    def __init__(self, plot: Plot, axes: Axes) -> None:
        self._plot = plot
        self._axes = axes
        self._says: list[str] = []
        self._bars = [series for series in plot.series if not series.of_paper] if plot.bars else []

    def draw(self) -> list[str]:
        """Returns the tooltips: the i-th is that of the element with the id point-i."""
        self._set_scales()
        for index, series in enumerate(self._plot.series):
            if series in self._bars:
                self._draw_bars(series)
            else:
                self._draw_points(index, series)
        return self._says

    def _set_scales(self) -> None:
        axes = self._axes
        axes.set_facecolor("none")
        axes.spines[["top", "right"]].set_visible(False)
        axes.spines[["left", "bottom"]].set_color(INK)
        axes.tick_params(which="both", colors=INK, labelsize=9)
        axes.grid(axis="y", which="major", color=FAINT, linewidth=0.8)
        axes.set_axisbelow(True)
        axes.set_xlabel(self._plot.x.title, color=INK)
        axes.set_ylabel(self._plot.y.title, color=INK)
        _set_scale(axes, "x", self._plot.x)
        _set_scale(axes, "y", self._plot.y)

    def _gid(self, says: str) -> str:
        self._says.append(says)
        return f"point-{len(self._says) - 1}"

    def _bar_width(self) -> float:
        return BARS_SHARE / max(1, len(self._bars))

    def _shift(self, place: int) -> float:
        return (place - (len(self._bars) - 1) / 2) * self._bar_width()

    def _draw_bars(self, series: Series) -> None:
        bottom = self._axes.get_ylim()[0]
        shift = self._shift(self._bars.index(series))
        width = 0.9 * self._bar_width()
        for point in series.points:
            bar, = self._axes.bar(point.x + shift, point.y - bottom, width, bottom, color=series.colour,
                                  hatch=series.hatch or None, edgecolor=GROUND, linewidth=0)
            bar.set_gid(self._gid(point.says))
            self._draw_interval(point, point.x + shift, INK, self._axes.transData)
            if point.mark:
                self._draw_mark(point, point.x + shift)

    def _draw_mark(self, point: Point, x: float) -> None:
        """The mark above a bar, upright where the bars are narrow."""
        axes_width = 72 * (WIDTH_INCHES - LEFT_INCHES - RIGHT_INCHES)
        narrow = axes_width * self._bar_width() / len(self._plot.x.names) < NARROWEST_MARK_POINTS
        self._axes.annotate(point.mark, (x, max(point.y, point.high)), (0, 3), textcoords="offset points",
                            ha="center", va="bottom", fontsize=6.5, color=INK, rotation=90 if narrow else 0)

    def _draw_points(self, index: int, series: Series) -> None:
        axes = self._axes
        transform, shift = axes.transData, 0.0
        if self._plot.bars:
            shift = self._shift(series.beside) if series.beside is not None else 0.0
        else:
            points = (index - (len(self._plot.series) - 1) / 2) * DODGE_POINTS
            transform = transform + ScaledTranslation(points / 72, 0, axes.figure.dpi_scale_trans)
            axes.plot([p.x for p in series.points], [p.y for p in series.points], transform=transform,
                      color=series.colour, linewidth=1.4, linestyle="--" if series.of_paper else "-", clip_on=False)
        for point in series.points:
            self._draw_interval(point, point.x + shift, series.colour, transform)
            marker, = axes.plot([point.x + shift], [point.y], transform=transform, marker=series.marker, markersize=6,
                                color=series.colour, markeredgecolor=GROUND, markeredgewidth=0.8, clip_on=False,
                                zorder=3)
            marker.set_gid(self._gid(point.says))

    def _draw_interval(self, point: Point, x: float, colour: str, transform) -> None:
        if point.low != point.high:
            self._axes.plot([x, x], [point.low, point.high], transform=transform, color=colour, linewidth=1,
                            marker="_", markersize=5, clip_on=False)


def _set_scale(axes: Axes, which: str, scale: Scale) -> None:
    axis = getattr(axes, f"{which}axis")
    set_limits = getattr(axes, f"set_{which}lim")
    if scale.kind == CATEGORIES:
        set_limits(-0.5, len(scale.names) - 0.5)
        _name_categories(axis, scale.names)
    elif scale.kind == LOGARITHMIC:
        _set_logarithmic(axes, which, scale.values)
    else:
        low, high = _linear_limits(scale)
        margin = 0.02 * (high - low) if which == "x" else 0.0  # points at the ends stay clear of the axis
        set_limits(low - margin, high + margin)
        axis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
        axis.set_major_formatter(FuncFormatter(lambda value, _: short_number(value)))


def _name_categories(axis, names: list[str]) -> None:
    axis.set_major_locator(FixedLocator(range(len(names))))
    turned = {"rotation": TURNED_DEGREES, "ha": "right", "rotation_mode": "anchor"} if _is_crowded(names) else {}
    axis.set_ticklabels(names, **turned)
    axis.set_tick_params(length=0)


def _linear_limits(scale: Scale) -> tuple[float, float]:
    if scale.kind == PERCENTAGES:
        return 0, 100
    low = min([0.0, *scale.values])
    high = max([low + 1e-9, *scale.values]) if scale.values else 1.0
    step = _round_number((high - low) / 6, up=True)
    return math.floor(low / step + 1e-9) * step, math.ceil(high / step - 1e-9) * step


def _set_logarithmic(axes: Axes, which: str, values: list[float]) -> None:
    """A logarithmic axis between round bounds. A zero among the values has its own place at the left end."""
    positive = [value for value in values if value > 0] or [1.0, 10.0]
    low = _round_number(min(positive), up=False)
    high = max(_round_number(max(positive), up=True), 2 * low)
    axis = getattr(axes, f"{which}axis")
    set_scale = getattr(axes, f"set_{which}scale")
    has_zero = which == "x" and any(value == 0 for value in values)
    if has_zero:
        set_scale("symlog", linthresh=low, linscale=0.15 * math.log10(high / low))
        _mark_break(axes, low)
    else:
        set_scale("log")
    getattr(axes, f"set_{which}lim")(0 if has_zero else low, high)
    decades = [10.0 ** power for power in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)]
    between = [digit * decade for decade in decades for digit in range(2, 10)]
    axis.set_major_locator(FixedLocator([0.0] * has_zero + [d for d in decades if low <= d * (1 + 1e-9)]))
    axis.set_minor_locator(FixedLocator([value for value in between if low * (1 - 1e-9) <= value <= high]))
    axis.set_major_formatter(FuncFormatter(lambda value, _: short_number(value)))
    labelled = math.log10(high / low) < MOST_DECADES_WITH_MINOR_LABELS
    axis.set_minor_formatter(FuncFormatter(lambda value, _: _minor_label(value) if labelled else ""))


def _minor_label(value: float) -> str:
    digit = round(value / 10.0 ** math.floor(math.log10(value) + 1e-9))
    return short_number(value) if digit in (2, 5) else ""


def _mark_break(axes: Axes, low: float) -> None:
    """Two strokes across the axis, between the zero and the beginning of the logarithms."""
    axes.plot([low / 2], [0], transform=axes.get_xaxis_transform(), color=INK, clip_on=False, linestyle="",
              marker="$//$", markersize=9)


def _round_number(value: float, up: bool) -> float:
    """The nearest 1, 2 or 5 times a power of ten that is not below (above) the value."""
    power = 10.0 ** math.floor(math.log10(value) + 1e-9)
    numbers = [digit * power for digit in (1, 2, 5, 10)]
    if up:
        return next(number for number in numbers if number >= value * (1 - 1e-9))
    return max(number for number in numbers if number <= value * (1 + 1e-9))


def _legend_key(plot: Plot, series: Series) -> object:
    if plot.bars and not series.of_paper:
        return Patch(facecolor=series.colour, hatch=series.hatch or None, edgecolor=GROUND, linewidth=0)
    line = "none" if plot.bars else "--" if series.of_paper else "-"
    return Line2D([], [], color=series.colour, marker=series.marker, markersize=6, markeredgecolor=GROUND,
                  linestyle=line, linewidth=1.4)


def _clean_svg(content: bytes, title: str, says: list[str], for_screen: bool) -> str:
    """Adds the tooltips and the title, removes names that nothing refers to, and takes colours from the page."""
    ElementTree.register_namespace("", _SVG)
    ElementTree.register_namespace("xlink", _XLINK)
    root = ElementTree.fromstring(content)
    for metadata in root.findall(f"{{{_SVG}}}metadata"):
        root.remove(metadata)
    root.set("role", "img")
    root.set("aria-label", title)
    if not for_screen:
        _inline_uses(root)
    used = set(re.findall(rb'(?:href="#|url\(#)([^")]+)', content))
    for element in root.iter():
        name = element.get("id", "")
        if name.startswith("point-"):
            element.insert(0, _title(says[int(name.removeprefix("point-"))]))
        if name and name.encode() not in used:
            del element.attrib["id"]
        style = element.get("style", "")
        element.attrib.update({"style": _FONT.sub(r"font-size: \1; font-family: 'DejaVu Sans', sans-serif", style)}
                              if style else {})
    text = ElementTree.tostring(root, encoding="unicode")
    if for_screen:
        for colour, variable in ((INK, "ink"), (FAINT, "line"), (GROUND, "ground")):
            text = text.replace(colour, f"var(--{variable}, {colour})")
    return text


def _inline_uses(root: ElementTree.Element) -> None:
    """Puts a copy of the shape where the drawing uses it: WeasyPrint draws no <use> of a marker."""
    shapes = {element.get("id"): element for element in root.iter(f"{{{_SVG}}}path") if element.get("id")}
    for use in list(root.iter(f"{{{_SVG}}}use")):
        shape = shapes[use.attrib.pop(f"{{{_XLINK}}}href").removeprefix("#")]
        use.tag = f"{{{_SVG}}}path"
        use.set("d", shape.get("d", ""))
        use.set("transform", f"translate({use.attrib.pop('x')} {use.attrib.pop('y')})")


def _title(text: str) -> ElementTree.Element:
    title = ElementTree.Element(f"{{{_SVG}}}title")
    title.text = text
    return title
