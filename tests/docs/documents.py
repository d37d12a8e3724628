"""What the tests of the documentation share: its tools and pages."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs" / "tools"))

import blocks  # noqa: E402  (its folder is known now)

PAGES = blocks.pages()
# What only developers read is held to the length of a line alone.
ALL_MARKDOWN = sorted({*PAGES, *ROOT.glob("*.md"), *ROOT.glob("[ast]*/README.md")})


def anchors(lines):
    """The anchors of a page's headings, as Markdown viewers name them."""
    names = []
    for line in blocks.prose(lines):
        if line.startswith("#"):
            text = line.lstrip("#").strip().lower()
            names.append("".join("-" if c == " " else c for c in text if c.isalnum() or c in " -_"))
    return set(names)
