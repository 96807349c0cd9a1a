"""What the scripts of this folder have in common: options, one clear error instead of a traceback, and saving."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import Callable

from study_results import ResultsError
from words import LANGUAGES

EXIT_BAD_INPUT = 3
EXIT_MODULE_MISSING = 69  # sysexits.h: a service is unavailable

PACKAGES = {"matplotlib": "python3-matplotlib", "weasyprint": "weasyprint"}


def parser_of(description: str, folder: str) -> argparse.ArgumentParser:
    """The options that the scripts share."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("folder", type=Path, metavar="DIR", help=folder)
    parser.add_argument("--out", type=Path, help="folder of the page (default: DIR)")
    parser.add_argument("--pdf", type=Path, metavar="FILE",
                        help="write the page as PDF, and no HTML (needs weasyprint)")
    parser.add_argument("--language", choices=LANGUAGES, default="en")
    return parser


def save_page(html: str, file: Path, pdf: bool) -> None:
    """Writes a page, and prints the name of its file."""
    from page import save_whole

    save_whole(file, _pdf_of(html) if pdf else html.encode("utf-8"))
    print(file)


def _pdf_of(html: str) -> bytes:
    import weasyprint

    return weasyprint.HTML(string=html).write_pdf()


def carry_out(main: Callable[[], None]) -> int:
    """Runs a script. Returns its exit code."""
    try:
        main()
    except ModuleNotFoundError as error:
        name = (error.name or "").split(".")[0]
        if name not in PACKAGES:
            raise
        print(f"{name} (apt install {PACKAGES[name]})", file=sys.stderr)
        return EXIT_MODULE_MISSING
    except ResultsError as error:
        print(error, file=sys.stderr)
        return EXIT_BAD_INPUT
    except OSError as error:
        print(f"{error.filename or ''}: {error.strerror or error}", file=sys.stderr)
        return EXIT_BAD_INPUT
    return 0


def describe_machine() -> str:
    """'2 cores (Intel Xeon), 8 GB of memory, Linux x86_64'."""
    system = os.uname()
    text = f"{os.cpu_count()} cores"
    processor = _processor_name()
    if processor:
        text += f" ({processor})"
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return f"{text}, {memory / 2**30:.0f} GB of memory, {system.sysname} {system.machine}"


def _processor_name() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(": ")[2]
    except OSError:
        pass
    return ""
