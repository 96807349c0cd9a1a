"""Reads a page of results as text: its headings, paragraphs, rows of tables and tooltips of plots."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path
from typing import Optional

READ = {"h1", "h2", "p", "caption", "figcaption", "th", "td", "pre", "summary"}
CELLS = {"th", "td"}


class PageReader(HTMLParser):
    """Collects a line for each part of a page and each row of a table, in the order of the page."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []
        self._row: list[str] = []
        self._text: Optional[str] = None
        self._in_svg = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, Optional[str]]]) -> None:
        self._in_svg = self._in_svg or tag == "svg"
        if tag in READ or (self._in_svg and tag == "title"):
            self._text = ""

    def handle_endtag(self, tag: str) -> None:
        self._in_svg = self._in_svg and tag != "svg"
        if tag == "tr":
            self.lines.append("row " + " | ".join(self._row))
            self._row = []
        elif self._text is not None and tag in CELLS:
            self._row.append(self._text.strip())
            self._text = None
        elif self._text is not None and (tag in READ or tag == "title"):
            kind = "point" if tag == "title" else tag
            self.lines.append(f"{kind} {self._text.strip()}")
            self._text = None

    def handle_data(self, data: str) -> None:
        if self._text is not None:
            self._text += data


def lines_of(html: str) -> list[str]:
    reader = PageReader()
    reader.feed(html)
    return reader.lines


def lines_of_file(file: Path) -> list[str]:
    return lines_of(file.read_text(encoding="utf-8"))
