"""The table of translations: each text of the workbench in each language, with the same places for what is put in."""

import ast
import os
import string
import unittest

import moldlight_workbench
from moldlight_workbench import words

FOLDER = os.path.dirname(os.path.dirname(moldlight_workbench.__file__))
LANGUAGES = ("German", "French")


def texts_of(tree):
    """What is given to translate() or marked for it, as literals."""
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call) and len(node.args) == 2]
    return {call.args[1].value for call in calls
            if isinstance(call.args[0], ast.Constant) and call.args[0].value == "Moldlight"
            and isinstance(call.args[1], ast.Constant)}


def all_texts():
    found = set()
    for folder, _, files in os.walk(FOLDER):
        for name in (name for name in files if name.endswith(".py")):
            with open(os.path.join(folder, name), encoding="utf-8") as text:
                found |= texts_of(ast.parse(text.read()))
    return found


def places(text):
    """What is put into a text, in its order."""
    return [(name, form) for _, name, form, _ in string.Formatter().parse(text) if name is not None]


class WordsTest(unittest.TestCase):
    def test_every_text_has_an_entry(self):
        texts = all_texts()
        self.assertGreater(len(texts), 100)
        for language in LANGUAGES:
            table = words.table(language)
            self.assertEqual(sorted(texts - set(table)), [], f"without {language}")
            self.assertEqual(sorted(set(table) - texts), [], f"{language} of what is no text any more")

    def test_places_and_ends_are_kept(self):
        for language in LANGUAGES:
            for text, translated in words.table(language).items():
                self.assertEqual(places(text), places(translated), translated)
                self.assertEqual(translated, translated.strip())
                self.assertEqual(text.endswith("."), translated.endswith("."), translated)
                self.assertEqual(text.count("&"), translated.count("&"), translated)

    def test_words_of_reports(self):
        for language in LANGUAGES:
            self.assertLessEqual(set(words._WORDS), set(words.table(language)))

    def test_a_language_that_is_not_there(self):
        self.assertEqual(words.table("Klingon"), {})


if __name__ == "__main__":
    unittest.main()
