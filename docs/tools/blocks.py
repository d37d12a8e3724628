"""Blocks of a Markdown page: fenced code with its commands, and parts that a program writes.

A fence `console` is run: `$ ` begins a command, the lines after it are its standard output, `…` stands for any text.
A fence `python` is run, and a fence `output` right after it is its standard output. A fence `sh` is shown, not run. Of a
fence `yaml` each command of moldlight must be one of the page's console blocks, which are run.
`<!-- made by: COMMAND -->` and `<!-- end -->` enclose what the command prints.
"""

import dataclasses
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
MADE_BY = re.compile(r"<!-- made by: (.+) -->$")
MADE_END = "<!-- end -->"


@dataclasses.dataclass
class Block:
    """Lines [first, last) of the page, without the fence or the comments around them."""
    kind: str
    first: int
    last: int
    lines: list


@dataclasses.dataclass
class Command:
    """A command of a console block and the output shown: lines [first, last) of the page."""
    text: str
    first: int
    last: int
    shown: str


def pages():
    """README and the pages of docs/."""
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def read(page):
    return page.read_text(encoding="utf-8").splitlines()


def blocks(lines):
    """All blocks in order; a part that a program writes has the kind `made by` and the command as its first line."""
    found, number = [], 0
    while number < len(lines):
        line = lines[number]
        fence = re.match(r"```(\w*)$", line)
        made = MADE_BY.match(line)
        if fence or made:
            end = "```" if fence else MADE_END
            if end not in lines[number + 1:]:
                raise ValueError(f"line {number + 1}: the block has no end")
            last = lines.index(end, number + 1)
            kind = fence.group(1) if fence else "made by"
            body = lines[number + 1:last] if fence else [made.group(1)]
            found.append(Block(kind, number + 1, last, body))
            number = last
        number += 1
    return found


def commands(block):
    """The commands of a console block."""
    found, number = [], 0
    while number < len(block.lines):
        if not block.lines[number].startswith("$ "):
            raise ValueError(f"line {block.first + number + 1}: output without a command")
        text = [block.lines[number][2:]]
        while text[-1].endswith("\\"):
            number += 1
            text.append(block.lines[number])
        number += 1
        first = number
        while number < len(block.lines) and not block.lines[number].startswith("$ "):
            number += 1
        found.append(Command("\n".join(text), block.first + first, block.first + number,
                             "\n".join(block.lines[first:number])))
    return found


def prose(lines):
    """The lines that a person wrote as text: those outside of blocks are kept, the others are empty."""
    kept = list(lines)
    for block in blocks(lines):
        for number in range(block.first - 1, block.last + 1):
            kept[number] = ""
    return kept
