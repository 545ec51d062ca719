"""Finding what is meant by a few letters."""

import re
from collections.abc import Sequence

_WORDS = re.compile(r"\w+")
_BETWEEN = re.compile(r"[\s+]+")
"""Between typed words: keys are typed as they are written, Ctrl+S."""
WORD_START, INSIDE, SCATTERED = 3, 2, 1
"""How well a typed word fits: a word begins with it, holds it, or has its letters in order."""


def score(typed: str, text: str) -> int:
    """Return how well a text fits what was typed; 0 if any of the typed words does not fit.

    Case does not matter, nor the order of the words.
    """
    total = 0
    words = _WORDS.findall(text.casefold())
    for part in filter(None, _BETWEEN.split(typed.casefold())):
        best = max((_fit(part, word) for word in words), default=0)
        if not best and _initials(part, words):
            best = INSIDE
        if not best:
            return 0
        total += best
    return total or 1


def ranked(typed: str, texts: Sequence[str]) -> list[int]:
    """Return the places of the texts that fit, the best first; equals keep their order."""
    scores = [score(typed, text) for text in texts]
    return sorted((k for k, points in enumerate(scores) if points), key=lambda k: -scores[k])


def _fit(part: str, word: str) -> int:
    if word.startswith(part):
        return WORD_START
    if part in word:
        return INSIDE
    letters = iter(word)
    # Two letters in order are in many words.
    return SCATTERED if len(part) > 2 and all(letter in letters for letter in part) else 0


def _initials(part: str, words: Sequence[str]) -> bool:
    return part in "".join(word[0] for word in words)
