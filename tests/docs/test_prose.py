"""How README and docs are written: short, one word for one thing, and blocks that a test reads."""

import re
import statistics
import unittest

import documents
import blocks

LONGEST_LINE = 120
MOST_WORDS, MEAN_WORDS = 30, 16
README_LINES, README_WORDS = 130, 900
KINDS = {"console", "python", "output", "sh", "yaml", "made by"}


def sentences(lines):
    """Sentences of paragraphs and list items; tables, headings and pictures are none."""
    text = []
    for line in blocks.prose(lines):
        if line.startswith(("#", "|", "!", "<!--")):
            line = ""
        text.append(re.sub(r"^\s*([-*]|\d+\.)\s", "\n\n", line))
    for paragraph in re.split(r"\n\s*\n", "\n".join(text)):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", paragraph)
        plain = re.sub(r"`[^`]*`", "code", plain)
        for sentence in re.split(r"(?<=[.!?])\s+", plain.strip()):
            words = [word for word in re.findall(r"[^\s]+", sentence) if re.search(r"\w", word)]
            if words:
                yield words


class Prose(unittest.TestCase):
    def each(self, check):
        for page in documents.PAGES:
            with self.subTest(page=page.name):
                check(blocks.read(page))

    def test_readme_is_short(self):
        text = (documents.ROOT / "README.md").read_text(encoding="utf-8")
        self.assertLessEqual(len(text.splitlines()), README_LINES)
        self.assertLessEqual(len(text.split()), README_WORDS)

    def test_readme_has_the_two_commands_of_a_clone(self):
        text = (documents.ROOT / "README.md").read_text(encoding="utf-8")
        for command in ("third_party/setup demo", "third_party/setup test"):
            self.assertIn(command, text)

    def test_lines_are_short(self):
        # What the program writes is as long as it is.
        for page in documents.ALL_MARKDOWN:
            with self.subTest(page=page):
                self.assertEqual([line for line in blocks.prose(blocks.read(page)) if len(line) > LONGEST_LINE], [])

    def test_sentences_are_short(self):
        lengths = []

        def check(lines):
            found = list(sentences(lines))
            lengths.extend(len(words) for words in found)
            self.assertEqual([" ".join(words) for words in found if len(words) > MOST_WORDS], [])

        self.each(check)
        self.assertGreater(len(lengths), 300)
        self.assertLessEqual(statistics.mean(lengths), MEAN_WORDS)

    def test_reports_report(self):
        self.each(lambda lines: self.assertEqual(
            re.findall(r"\b(?:tells?|told)\b", " ".join(blocks.prose(lines)).lower()), []))

    def test_blocks_are_of_a_known_kind(self):
        def check(lines):
            self.assertEqual({block.kind for block in blocks.blocks(lines)} - KINDS, set())
            # An indented block would escape the check of commands.
            code = [line for line in blocks.prose(lines) if line.startswith("    ") and "moldlight " in line]
            self.assertEqual(code, [])

        self.each(check)

    def test_glossary_is_in_order_and_has_each_word_once(self):
        rows = [line.split("|")[1].strip() for line in blocks.read(documents.ROOT / "docs" / "glossary.md")
                if line.startswith("| ")][1:]
        self.assertEqual(rows, sorted(set(rows)))


if __name__ == "__main__":
    unittest.main()
