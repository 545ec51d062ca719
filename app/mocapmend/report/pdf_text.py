"""Text on a page: fonts that every reader has, for Latin and Chinese, and breaking into lines.

Nothing is embedded: Helvetica is one of the standard fonts of PDF, and readers put a font of
their own in the place of the standard Chinese and Korean ones.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.cidfonts import UnicodeCIDFont
from reportlab.pdfgen.canvas import Canvas

LATIN, BOLD = "Helvetica", "Helvetica-Bold"
CHINESE, KOREAN = "STSong-Light", "HYSMyeongJo-Medium"
LEADING = 1.3
NO_SIGN = "\u25a1"
WORDS = re.compile(r"[\u2e80-\uffef]|[^\s\u2e80-\uffef]+\s*|\s+")
"""Between Chinese signs, a line may break anywhere."""


@dataclass(frozen=True)
class Style:
    """Font, size in points, and colour as "#rrggbb"."""

    size: float
    colour: str = "#1c2026"
    font: str = LATIN

    @property
    def line(self) -> float:
        """Height of a line in points."""
        return LEADING * self.size


def register_fonts() -> None:
    """Make the fonts known that are not there from the start."""
    for name in (CHINESE, KOREAN):
        pdfmetrics.registerFont(UnicodeCIDFont(name))


@cache
def _font(sign: str) -> str:
    """Return the font that has a sign; "" for Latin."""
    try:
        sign.encode("cp1252")
    except UnicodeEncodeError:
        return KOREAN if "\uac00" <= sign <= "\ud7a3" else CHINESE
    return ""


def _printable(text: str) -> str:
    """Replace what no font of these can show."""
    return "".join(c if c.isprintable() and ord(c) < 0x10000 else NO_SIGN for c in text)


def _pieces(text: str, style: Style) -> Iterator[tuple[str, str]]:
    """Split a text by the fonts that it takes."""
    if text.isascii():
        yield style.font, text
        return
    start = 0
    for end in range(1, len(text) + 1):
        if end == len(text) or _font(text[end]) != _font(text[start]):
            yield _font(text[start]) or style.font, text[start:end]
            start = end


def width(text: str, style: Style) -> float:
    """Return how wide a text is, in points."""
    pieces = _pieces(text, style)
    return sum((float(pdfmetrics.stringWidth(t, font, style.size)) for font, t in pieces), 0.0)


def wrap(text: str, style: Style, room: float) -> list[str]:
    """Break a text into lines that are no wider than a room in points."""
    text = _printable(text)
    if width(text, style) <= room:
        return [text]
    lines, line, used = [], "", 0.0
    for word in WORDS.findall(text):
        # The space after a word may hang over the end of the line.
        size = width(word.rstrip(), style)
        if line and used + size > room:
            lines.append(line.rstrip())
            line, used = "", 0.0
        while size > room and len(word) > 1:
            fits = next(
                n for n in range(len(word), 0, -1) if n == 1 or width(word[:n], style) <= room
            )
            lines.append(word[:fits])
            word = word[fits:]  # noqa: PLW2901 - the rest of it
            size = width(word.rstrip(), style)
        line, used = line + word, used + width(word, style)
    return [*lines, line.rstrip()]


def put(canvas: Canvas, x: float, y: float, text: str, style: Style, align: str = "left") -> None:
    """Write one line; `x` is its left end, its right end or its middle."""
    if align != "left":
        x -= width(text, style) * (1.0 if align == "right" else 0.5)
    target = canvas.beginText(x, y)
    target.setFillColor(style.colour)
    for font, piece in _pieces(text, style):
        target.setFont(font, style.size)
        target.textOut(piece)
    canvas.drawText(target)
