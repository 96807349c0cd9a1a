"""The output of the programs of tests/benchmarks (Google Benchmark's JSON)."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Optional

from study_results import number_of, text_of

OWN_CLOCK = "manual_time"  # the program measured the time itself
_SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
_OWN_KEYS = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations",
             "real_time", "cpu_time"}


@dataclass
class BenchmarkTime:
    """One benchmark, whose name has parts: 'collide/L/near/kernel', 'nearest/tree/1000'."""

    name: str
    seconds: float
    counters: dict[str, float]

    @property
    def parts(self) -> list[str]:
        """Parts of the name, without those that Google Benchmark adds ('iterations:1', 'manual_time')."""
        return [part for part in self.name.split("/") if ":" not in part and part != OWN_CLOCK] or [self.name]


@dataclass
class BenchmarkRun:
    """The results of a program: where they are from, and the times."""

    context: dict[str, str]
    times: list[BenchmarkTime]


@dataclass
class BackendTimes:
    """Seconds of the same query by our kernel and by FCL."""

    question: str
    place: str  # model and poses, for example 'L/near'
    kernel: float
    fcl: float

    @property
    def ratio(self) -> float:
        return self.fcl / self.kernel


@dataclass
class GrowthSeries:
    """Seconds of a quantity over the size."""

    quantity: str
    who: str
    points: list[tuple[float, float]] = field(default_factory=list)

    @property
    def exponent(self) -> Optional[float]:
        """The exponent k of y = c x^k by least squares of the logarithms. None for a single size."""
        xs = [math.log(size) for size, _ in self.points]
        ys = [math.log(seconds) for _, seconds in self.points]
        mean_x = sum(xs) / len(xs)
        mean_y = sum(ys) / len(ys)
        squares = sum((x - mean_x) ** 2 for x in xs)
        products = sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys))
        return products / squares if squares > 1e-12 else None


def benchmark_run(root: dict[str, Any]) -> BenchmarkRun:
    """Benchmarks that ended with an error, and aggregates other than the median, are left out."""
    context = {key: text_of(value) for key, value in root["context"].items() if isinstance(value, str)}
    return BenchmarkRun(context, [_time_of(entry) for entry in root["benchmarks"] if _is_measured(entry)])


def _is_measured(entry: dict[str, Any]) -> bool:
    if entry.get("error_occurred", False):
        return False
    return entry.get("run_type") != "aggregate" or entry.get("aggregate_name") == "median"


def _time_of(entry: dict[str, Any]) -> BenchmarkTime:
    name = text_of(entry["run_name" if entry.get("run_type") == "aggregate" else "name"])
    measured = number_of(entry["real_time" if OWN_CLOCK in name else "cpu_time"])
    if text_of(entry["time_unit"]) not in _SECONDS or not measured > 0:
        raise ValueError(f"the time of {name} is not positive, or not in ns, us, ms or s")
    counters = {key: number_of(value) for key, value in entry.items()
                if isinstance(value, (int, float)) and not isinstance(value, bool) and key not in _OWN_KEYS}
    return BenchmarkTime(name, measured * _SECONDS[entry["time_unit"]], dict(sorted(counters.items())))


def backend_times(times: list[BenchmarkTime]) -> list[BackendTimes]:
    """Queries that were measured with both, sorted by query and place."""
    fcl = {tuple(time.parts[:-1]): time.seconds for time in times if time.parts[-1] == "fcl"}
    pairs = [BackendTimes(time.parts[0], "/".join(time.parts[1:-1]), time.seconds, fcl[tuple(time.parts[:-1])])
             for time in times
             if len(time.parts) >= 3 and time.parts[-1] == "kernel" and tuple(time.parts[:-1]) in fcl]
    return sorted(pairs, key=lambda pair: (pair.question, pair.place))


def geometric_mean(times: list[BackendTimes], question: str) -> Optional[float]:
    """Geometric mean of the ratios for a query. None where it was not measured."""
    logarithms = [math.log(pair.ratio) for pair in times if pair.question == question]
    return math.exp(sum(logarithms) / len(logarithms)) if logarithms else None


def growth_series(times: list[BenchmarkTime]) -> list[GrowthSeries]:
    """Times over sizes: 'quantity/who/size'. The counter 'size', if present, has the exact size."""
    series: dict[tuple[str, str], GrowthSeries] = {}
    for time in times:
        parts = time.parts
        size = _positive(parts[2]) if len(parts) == 3 else None
        if size is None:
            continue
        own = series.setdefault((parts[0], parts[1]), GrowthSeries(parts[0], parts[1]))
        exact = time.counters.get("size", 0.0)
        own.points.append((exact if exact > 0 else size, time.seconds))
    return list(series.values())


def _positive(text: str) -> Optional[float]:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if 0 < value < math.inf else None
