"""Numbers as the pages of results print them, in the same form in every language."""

import math

NARROW_SPACE = "\u202f"


def short_number(value: float) -> str:
    """At least three significant digits, and spaces between thousands: '27 600', '0.152', '14.5'."""
    size = abs(value)
    digits = 0 if size >= 100 or size == 0 else min(max(2 - math.floor(math.log10(size)), 1), 9)
    text = f"{value:.{digits}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    whole, point, part = text.partition(".")
    if len(whole.lstrip("-")) >= 5:
        whole = f"{int(whole):,}".replace(",", NARROW_SPACE)
    return whole + point + part


def percent(share: float) -> str:
    """A share as a percentage: '97 %'."""
    return f"{100 * share:.0f} %"


def exact_number(value: float) -> str:
    """The shortest text that reads back as this number: '0.01', '1'."""
    return str(int(value)) if value == int(value) else repr(float(value))
