"""Tests of the pages of samples/studies: the numbers of stored results, and one clear error for bad ones.

`expected/` holds what the program printed about these results before the pages were written by Python.
"""

from __future__ import annotations

import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from xml.etree import ElementTree

HERE = Path(__file__).resolve().parent
SCRIPTS = HERE.parent.parent / "samples" / "studies"
RESULTS = HERE / "results"
sys.path[:0] = [str(HERE), str(SCRIPTS)]

import benchmark_page  # noqa: E402
import report  # noqa: E402
from page_reader import lines_of_file  # noqa: E402
from benchmark_results import GrowthSeries  # noqa: E402
from french import FRENCH  # noqa: E402
from script import carry_out  # noqa: E402
from number_text import exact_number, percent, short_number  # noqa: E402
from study_findings import HOLDS, OPEN, REFUTED, check_finding  # noqa: E402
from study_plots import plots_of  # noqa: E402
from study_results import Distribution, Finding, Measure, Quantity, read_results  # noqa: E402
from words import Words  # noqa: E402


@dataclass
class Done:
    """The end of a script."""

    returncode: int
    stdout: str
    stderr: str


def run(script: ModuleType, *arguments: object) -> Done:
    """Runs a script in this process, so that matplotlib is loaded once."""
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as errors:
        code = carry_out(lambda: script.main([str(argument) for argument in arguments]))
    return Done(code, out.getvalue(), errors.getvalue())


class FolderTest(unittest.TestCase):
    """A test with a copy of the stored results."""

    def setUp(self) -> None:
        self._temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self._temporary.cleanup)
        self.folder = Path(self._temporary.name) / "results"
        shutil.copytree(RESULTS, self.folder)
        self.small = self.folder / "small"

    def page(self, *arguments: object) -> list[str]:
        done = run(report, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return lines_of_file(Path(done.stdout.strip()))

    def expect_refused(self, mentions: str, *arguments: object) -> None:
        done = run(report, *arguments)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(mentions, done.stderr)


class Numbers(FolderTest):
    def expect_lines(self, name: str, lines: list[str]) -> None:
        """Every expected line is on the page, as often and in that order; the page may have more."""
        expected = (HERE / "expected" / f"{name}.txt").read_text(encoding="utf-8").splitlines()
        found = iter(line.replace("\n", "\\n").rstrip() for line in lines)
        for line in expected:
            self.assertTrue(any(line == other for other in found), f"{name}: {line!r} is missing")

    def test_pages_have_the_numbers_of_before(self) -> None:
        self.expect_lines("small-en", self.page(self.small))
        self.expect_lines("small-fr", self.page(self.small, "--language", "fr"))
        self.expect_lines("beside-en", self.page(self.folder / "beside"))

    def test_benchmarks_have_the_numbers_of_before(self) -> None:
        done = run(benchmark_page, self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("warning: ", done.stderr)
        lines = lines_of_file(self.folder / "benchmarks.html")
        self.expect_lines("benchmarks", lines)
        self.assertFalse(any("secret" in line for line in lines), "the name of the machine is nobody's business")

    def test_short_numbers(self) -> None:
        shown = {0: "0", 27600: "27\u202f600", 1234567: "1\u202f234\u202f567", 1234.4: "1234", 14.46: "14.5",
                 0.1523: "0.152", 0.08: "0.08", -12345.6: "-12\u202f346"}
        for value, text in shown.items():
            self.assertEqual(short_number(value), text)
        self.assertEqual((percent(0.974), exact_number(1.0), exact_number(0.001)), ("97 %", "1", "0.001"))

    def test_exponents(self) -> None:
        points = [(x, 7 * x ** 0.4) for x in (10, 100, 3000)]
        self.assertAlmostEqual(GrowthSeries("q", "w", points).exponent, 0.4)
        self.assertIsNone(GrowthSeries("q", "w", points[:1]).exponent)


class Findings(unittest.TestCase):
    """Pairs of cells with given medians of nodes; None: never solved."""

    def check(self, finding: dict, *nodes: float | None):
        results = read_results(RESULTS / "small")
        for cell, value in zip(results.cells, nodes):
            sample = Distribution(0) if value is None else Distribution(4, value, value, value, value)
            cell.measures["nodes"] = Measure(sample, sample)
        claim = Finding("", Quantity("nodes", "median", "solved"), below=True, **finding)
        return check_finding(claim, results, Words())

    TENTH = {"cells": {"rows": ["α = 0.2"]}, "than": {"rows": ["plain"]}, "factor": 0.1}

    def test_a_finding_holds_where_every_pair_does(self) -> None:
        checked = self.check(self.TENTH, 1000, 90, 50)
        self.assertEqual((checked.verdict, checked.compared, checked.agreeing), (HOLDS, 2, 2))
        self.assertIn("90 against plain: 1000, 0.09 times", checked.numbers)

    def test_one_pair_refutes_it_and_is_named(self) -> None:
        checked = self.check(self.TENTH, 1000, 90, 120)
        self.assertEqual((checked.verdict, checked.agreeing), (REFUTED, 1))
        self.assertIn("0.12 times; wanted below 0.1", checked.numbers)

    def test_it_stays_open_where_a_row_was_never_solved_or_is_not_there(self) -> None:
        checked = self.check(self.TENTH, None, 90, 50)
        self.assertEqual(checked.verdict, OPEN)
        self.assertIn("plain was never solved", checked.numbers)
        self.assertEqual(self.check({**self.TENTH, "cells": {"rows": ["nowhere"]}}, 1, 1, 1).verdict, OPEN)

    def test_pairs_agree_in_what_is_named(self) -> None:
        finding = {"cells": {"rows": ["α = 0.2"]}, "than": {"rows": ["α = 0.8"]}, "pair_by": ("operator",)}
        self.assertEqual(self.check(finding, 1, 1, 1, 2, 2).compared, 2)

    def test_a_bound_of_zero_is_compared_by_difference(self) -> None:
        self.assertEqual(self.check(self.TENTH, 0, 0, 0).verdict, REFUTED)


class Pages(FolderTest):
    def test_a_page_is_well_formed_needs_nothing_else_and_is_the_same_again(self) -> None:
        self.page(self.small)
        first = (self.small / "report.html").read_text(encoding="utf-8")
        root = ElementTree.fromstring(first.replace("<!DOCTYPE html>\n", ""))
        self.assertEqual(len(list(root.iter("{http://www.w3.org/2000/svg}svg"))), 3)
        for outside in ('src="http', "@import", "<script"):
            self.assertNotIn(outside, first)
        self.page(self.small)
        self.assertEqual(first, (self.small / "report.html").read_text(encoding="utf-8"))

    def test_runs_lead_to_their_files(self) -> None:
        page = (self.folder / "elsewhere" / "report.html")
        self.page(self.small, "--out", page.parent)
        text = page.read_text(encoding="utf-8")
        self.assertIn('href="../small/runs/cell2-seed3.json"', text)
        self.page(self.small)
        self.assertIn('href="runs/cell2-seed3.json"', (self.small / "report.html").read_text(encoding="utf-8"))

    def test_pictures_come_into_the_page(self) -> None:
        (self.small / "pictures").mkdir()
        (self.small / "pictures" / "cell1.png").write_bytes(b"PNG?")
        (self.small / "pictures" / "cell1.txt").write_text("A typical roadmap", encoding="utf-8")
        self.assertIn("figcaption A typical roadmap", self.page(self.small))
        self.assertIn("base64,UE5HPw==", (self.small / "report.html").read_text(encoding="utf-8"))

    def test_plots_are_saved_as_drawings(self) -> None:
        self.page(self.small, "--plots", self.folder / "plots")
        files = sorted(file.name for file in (self.folder / "plots").iterdir())
        self.assertEqual(files, ["nodes-over-alpha.svg", "success-over-alpha.svg", "time_s-over-alpha.svg"])
        self.assertNotIn("var(", (self.folder / "plots" / files[0]).read_text(encoding="utf-8"))

    def test_plots_vary_what_the_study_varies(self) -> None:
        names = [plot.name for plot in plots_of(read_results(self.folder / "beside"), Words())]
        self.assertEqual(names[0], "virtual_s-at-0.5")
        self.assertEqual(len(names), 8)
        plot = plots_of(read_results(self.small), Words())[0]
        self.assertIn("Not on this axis: plain.", plot.caption)
        self.assertEqual([point.x for point in plot.series[0].points], [0.2, 0.8])

    def test_studies_are_wholly_french(self) -> None:
        for file in SCRIPTS.glob("*.json"):
            study = json.loads(file.read_text(encoding="utf-8"))
            texts = [study["title"], study.get("description", ""),
                     *(finding["text"] for finding in study.get("findings", [])),
                     *(column["title"] for column in study.get("paper", [])),
                     *(row["paper"]["note"] for row in study.get("rows", []) if "note" in row.get("paper", {}))]
            for text in filter(None, texts):
                self.assertIn(text, FRENCH, file.name)


class BadResults(FolderTest):
    def test_a_folder_without_results(self) -> None:
        self.expect_refused("No such file", self.folder / "nowhere")
        done = run(benchmark_page, self.folder / "nowhere")
        self.assertEqual(done.returncode, 3)
        self.assertIn("holds no results of benchmarks", done.stderr)

    def test_a_summary_that_is_broken_or_of_another_version(self) -> None:
        summary = self.small / "summary.json"
        whole = summary.read_text(encoding="utf-8")
        broken = {"is malformed": whole[:3000], "has version 2": whole.replace('"version": 1', '"version": 2', 1),
                  "has no": whole.replace('"cells"', '"rooms"', 1), "has no cells": '{"format": '
                  '"glissade-study-summary", "version": 1, "cells": []}', "malformed": "[[[" * 20000}
        for mentions, text in broken.items():
            summary.write_text(text, encoding="utf-8")
            self.expect_refused(mentions, self.small)
        summary.write_bytes(b"\xff\xfe\x00")
        self.expect_refused("malformed", self.small)

    def test_lines_that_cannot_be_read_are_left_out_and_stated(self) -> None:
        runs = self.small / "runs.csv"
        lines = runs.read_text(encoding="utf-8").splitlines()
        runs.write_text("\n".join([*lines[:3], "2,garbage", *lines[4:]]) + "\n", encoding="utf-8")
        (self.small / "timing_summary.csv").unlink()
        page = self.page(self.small)
        self.assertIn("p Lines of runs.csv that cannot be read and are left out: 1.", page)
        self.assertIn("p timing_summary.csv has no seconds for 5 of 5 cells.", page)

    def test_a_table_of_runs_that_is_older_than_the_summary(self) -> None:
        runs = self.small / "runs.csv"
        runs.write_text("".join(runs.read_text(encoding="utf-8").splitlines(keepends=True)[:4]), encoding="utf-8")
        self.assertIn("p runs.csv has 3 of 15 runs.", self.page(self.small))

    def test_a_study_without_runs_has_a_page(self) -> None:
        summary = json.loads((self.small / "summary.json").read_text(encoding="utf-8"))
        for cell in summary["cells"]:
            cell["runs"] = 0
            cell["statuses"] = dict.fromkeys(cell["statuses"], 0)
            cell["measures"] = {name: {"solved": {"count": 0}, "all": {"count": 0}} for name in cell["measures"]}
        (self.small / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        for table in ("runs.csv", "timing_summary.csv"):
            (self.small / table).unlink()
        page = self.page(self.small)
        self.assertIn("row Runs | 0 of 15, 0 of them solved, in 5 cells", page)

    def test_a_broken_study_is_left_out_of_the_benchmarks(self) -> None:
        (self.small / "summary.json").write_text("{", encoding="utf-8")
        done = run(benchmark_page, self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: ", done.stderr)
        lines = lines_of_file(self.folder / "benchmarks.html")
        self.assertTrue(any(line.startswith("p Left out: ") for line in lines))
        (self.folder / "growth.json").write_text('{"context": ', encoding="utf-8")
        self.assertEqual(run(benchmark_page, self.folder).returncode, 3)

    def test_a_module_that_is_missing_is_named(self) -> None:
        (self.folder / "matplotlib.py").write_text("raise ModuleNotFoundError(name='matplotlib')", encoding="utf-8")
        done = subprocess.run([sys.executable, str(SCRIPTS / "report.py"), str(self.small)], capture_output=True,
                              text=True, check=False, env={**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertEqual((done.returncode, done.stderr), (69, "matplotlib (apt install python3-matplotlib)\n"))


if __name__ == "__main__":
    unittest.main()
