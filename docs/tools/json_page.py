"""The page on JSON reports: its sections, the commands and the keys of each."""

import json
import re

import blocks

PAGE = blocks.ROOT / "docs" / "json.md"


def sections():
    """Heading, console blocks and keys with their meaning of each section."""
    lines = blocks.read(PAGE)
    starts = [number for number, line in enumerate(lines) if line.startswith("## ")] + [len(lines)]
    for first, last in zip(starts, starts[1:]):
        part = lines[first:last]
        rows = [re.split(r"(?<!\\)\|", line)[1:3] for line in part if line.startswith("| `")]
        keys = {key: meaning.strip() for cell, meaning in rows for key in re.findall(r"`([^`]+)`", cell)}
        consoles = [block for block in blocks.blocks(part) if block.kind == "console"]
        yield lines[first].removeprefix("## ").strip("`"), consoles, keys


def reports(session, consoles):
    """What the commands write as JSON: reports, settings, the plan of a batch. Raises RuntimeError where one fails."""
    files = []
    for block in consoles:
        for command in blocks.commands(block):
            session.command(command.text)
            if session.status != 0:
                raise RuntimeError(f"{command.text}: exit code {session.status}: {session.errors}")
            files += re.findall(r"--(?:json|save-settings) (\S+)", command.text)
            files += [f"{folder}/batch.json" for folder in re.findall(r"batch plan .*--out (\S+)", command.text)]
    return [json.loads((session.folder / file).read_text(encoding="utf-8")) for file in files]
