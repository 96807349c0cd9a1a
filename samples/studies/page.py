"""One HTML page that needs no other file: plots are inline SVG, pictures are data URLs."""

from __future__ import annotations

import base64
import os
import tempfile
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import Union

STYLE = Path(__file__).with_name("page.css")
MANY_COLUMNS = 10


@dataclass(frozen=True)
class Link:
    """A cell of a table that leads to a file or to a place of the page."""

    text: str
    target: str


TEXT = ""
NUMBER = "number"
PROSE = "prose"
VERDICT = "verdict"


@dataclass
class Table:
    """A table. A column is a title and a kind: TEXT, NUMBER (aligned to the right), PROSE or VERDICT."""

    columns: list[tuple[str, str]]
    rows: list[list[Union[str, Link]]] = field(default_factory=list)
    caption: str = ""
    verdicts: dict[str, str] = field(default_factory=dict)  # CSS class of each verdict


class Page:
    """Collects the parts of a page."""

    def __init__(self, title: str, language: str = "en") -> None:
        self._title = title
        self._language = language
        self._parts: list[str] = []
        self._sections: list[str] = []

    def heading(self, text: str) -> None:
        self._sections.append(text)
        self._parts.append(f'<h2 id="section-{len(self._sections)}">{escape(text)}</h2>\n')

    def text(self, text: str) -> None:
        self._parts.append(f"<p>{escape(text)}</p>\n")

    def table(self, table: Table) -> None:
        self._parts.append(table_html(table))

    def folded(self, summary: str, table: Table) -> None:
        """A table that a click unfolds, and that is not printed."""
        self._parts.append(f"<details><summary>{escape(summary)}</summary>\n{table_html(table)}</details>\n")

    def figure(self, name: str, svg: str, title: str, caption: str) -> None:
        self._parts.append(f'<figure id="{escape(name)}">\n{svg}\n<figcaption><strong>{escape(title)}.</strong> '
                           f"{escape(caption)}</figcaption>\n</figure>\n")

    def picture(self, png: bytes, caption: str) -> None:
        data = base64.b64encode(png).decode("ascii")
        self._parts.append(f'<figure class="picture">\n<img alt="{escape(caption)}" '
                           f'src="data:image/png;base64,{data}"/>\n<figcaption>{escape(caption)}</figcaption>\n'
                           "</figure>\n")

    def commands(self, lines: list[str]) -> None:
        self._parts.append("<pre>" + "".join(escape(line) + "\n" for line in lines) + "</pre>\n")

    def html(self) -> str:
        contents = "".join(f'<a href="#section-{number}">{escape(text)}</a>\n'
                           for number, text in enumerate(self._sections, 1))
        return (f'<!DOCTYPE html>\n<html lang="{self._language}" xmlns="http://www.w3.org/1999/xhtml">\n<head>\n'
                '<meta charset="utf-8"/>\n'
                '<meta name="viewport" content="width=device-width, initial-scale=1"/>\n'
                '<meta name="color-scheme" content="light dark"/>\n'
                f'<title>{escape(self._title)}</title>\n<style>\n{STYLE.read_text(encoding="utf-8")}</style>\n'
                f"</head>\n<body>\n<h1>{escape(self._title)}</h1>\n<nav>\n{contents}</nav>\n"
                + "".join(self._parts) + "</body>\n</html>\n")


def table_html(table: Table) -> str:
    many = ' class="many"' if len(table.columns) > MANY_COLUMNS else ""
    caption = f"<caption>{escape(table.caption)}</caption>\n" if table.caption else ""
    titles = "".join(f"<th{_class(kind)}>{escape(title)}</th>" for title, kind in table.columns)
    head = f"<thead><tr>{titles}</tr></thead>\n" if any(title for title, _ in table.columns) else ""
    rows = "".join(_row_html(table, row) for row in table.rows)
    return f'<div class="wide"><table{many}>\n{caption}{head}<tbody>\n{rows}</tbody>\n</table></div>\n'


def _row_html(table: Table, row: list[Union[str, Link]]) -> str:
    cells = []
    for (_, kind), cell in zip(table.columns, row):
        style = table.verdicts.get(str(cell), "") if kind == VERDICT else kind
        text = f'<a href="{escape(cell.target)}">{escape(cell.text)}</a>' if isinstance(cell, Link) else escape(cell)
        cells.append(f"<td{_class(style)}>{text}</td>")
    return f"<tr>{''.join(cells)}</tr>\n"


def _class(kind: str) -> str:
    return f' class="{kind}"' if kind not in (TEXT, VERDICT) else ""


def save_whole(file: Path, content: bytes) -> None:
    """Replaces a file: after a failure it has its old content or the new one, and never a part."""
    file.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=file.name + ".saving-", dir=file.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
        os.chmod(name, 0o666 & ~_file_mask())
        os.replace(name, file)
    except BaseException:
        os.unlink(name)
        raise


def _file_mask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
