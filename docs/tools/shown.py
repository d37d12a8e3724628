"""Compares the output that a page shows with the output that a command gives, and brings the page up to date.

Text is compared word by word, whatever the white space. A number agrees if it is the command's number, rounded to the
digits shown. `…` stands for any text.
"""

import re
import textwrap
from decimal import Decimal

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?|\d+(?:\.\d+)?(?:e[-+]?\d+)?", re.IGNORECASE)
ELLIPSIS = "…"
LINE_WIDTH = 110
# Begins what a long line goes on with: spaces that the program does not print, so that it is found again.
CONTINUATION = "\u00a0" * 6


def pattern(text):
    """A regular expression for text of the same words, with a group for each number; and the numbers."""
    parts, numbers, place = [], [], 0
    text = re.sub(r"\s+", " ", text).strip()
    for match in NUMBER.finditer(text):
        parts.append(re.escape(text[place:match.start()]))
        parts.append(r"([-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)")
        numbers.append(match.group())
        place = match.end()
    parts.append(re.escape(text[place:]))
    return "".join(parts), numbers


def half_digit(number):
    """Half of the last digit of a number as it is written."""
    return Decimal((0, (5,), Decimal(number).as_tuple().exponent - 1))


def difference(shown, actual):
    """Why the output shown is not the actual one; None where it is."""
    texts, numbers = zip(*(pattern(segment) for segment in shown.split(ELLIPSIS)))
    numbers = [number for segment in numbers for number in segment]
    found = re.fullmatch("(?:.*?)".join(texts), re.sub(r"\s+", " ", actual).strip(), re.DOTALL)
    if not found:
        return "the text differs"
    for number, group in zip(numbers, found.groups()):
        if abs(Decimal(number) - Decimal(group)) > half_digit(number):
            return f"{number} is {group}"
    return None


def wrapped(line):
    if len(line) <= LINE_WIDTH:
        return [line]
    return textwrap.wrap(line, LINE_WIDTH, subsequent_indent=CONTINUATION, break_long_words=False)


def unwrapped(lines):
    whole = []
    for line in lines:
        if line.startswith(CONTINUATION):
            whole[-1] += " " + line.strip()
        else:
            whole.append(line)
    return whole


def located(segment, actual):
    """Where lines of the segment's words stand in the actual output: (first, last); None where they do not."""
    words = [re.compile(pattern(line)[0]) for line in segment]
    flat = [re.sub(r"\s+", " ", line).strip() for line in actual]
    for first in range(len(flat) - len(words) + 1):
        if all(word.fullmatch(flat[first + i]) for i, word in enumerate(words)):
            return first, first + len(words)
    return None


def refreshed(shown, actual):
    """The lines to show now; None where a person has to say which."""
    lines, shown = [line.rstrip() for line in actual.rstrip().splitlines()], unwrapped(shown)
    if not any(line.strip() == ELLIPSIS for line in shown):
        return [part for line in lines for part in wrapped(line)]
    segments, segment = [], []
    for line in [*shown, ELLIPSIS]:
        if line.strip() == ELLIPSIS:
            segments.append(segment)
            segment = []
        else:
            segment.append(line)
    if shown[-1].strip() != ELLIPSIS:
        segments.append([])
    kept = []
    for number, segment in enumerate(segments):
        if not segment:
            continue
        place = (0, len(segment)) if number == 0 else located(segment, lines)
        if number == len(segments) - 2 and shown[-1].strip() != ELLIPSIS:
            place = (len(lines) - len(segment), len(lines))
        if place is None:
            return None
        if number > 0:
            kept.append(ELLIPSIS)
        kept += [part for line in lines[place[0]:place[1]] for part in wrapped(line)]
    if shown[0].strip() == ELLIPSIS and kept[0] != ELLIPSIS:
        kept.insert(0, ELLIPSIS)
    return [*kept, ELLIPSIS] if shown[-1].strip() == ELLIPSIS else kept
