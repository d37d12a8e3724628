"""The comparison of outputs itself: what agrees, and what does not."""

import unittest

import documents  # noqa: F401  (finds the tools)
import shown


class Difference(unittest.TestCase):
    def test_equal_output_agrees_whatever_its_white_space(self):
        self.assertIsNone(shown.difference("core  16173.3\nboth", "core 16173.3 \n   both\n"))

    def test_a_number_agrees_by_the_digits_shown(self):
        self.assertIsNone(shown.difference("area 16.2 mm²", "area 16.2481 mm²"))
        self.assertEqual(shown.difference("area 16.3 mm²", "area 16.2481 mm²"), "16.3 is 16.2481")
        self.assertIsNotNone(shown.difference("area 16.20 mm²", "area 16.2481 mm²"))

    def test_whole_numbers_and_exponents(self):
        self.assertIsNotNone(shown.difference("3 undercuts", "4 undercuts"))
        self.assertIsNone(shown.difference("± 1.5e-05", "± 1.47e-05"))
        self.assertIsNotNone(shown.difference("± 1.5e-05", "± 1.5e-04"))

    def test_signs_count(self):
        self.assertIsNotNone(shown.difference("0, 0, -1", "0, 0, 1"))

    def test_words_count(self):
        self.assertEqual(shown.difference("1 slide", "1 lifter"), "the text differs")
        self.assertIsNotNone(shown.difference("1 slide", "1 slide, 2 lifters"))

    def test_an_ellipsis_stands_for_any_text(self):
        self.assertIsNone(shown.difference("first\n…\nlast 5", "first\nsecond 2\nlast 5"))
        self.assertIsNotNone(shown.difference("first\n…\nlast 5", "first\nlast 5\nmore"))
        self.assertIsNone(shown.difference("…", ""))


class Refreshed(unittest.TestCase):
    def test_all_lines_are_replaced(self):
        self.assertEqual(shown.refreshed(["old"], "one\ntwo\n"), ["one", "two"])

    def test_lines_around_an_ellipsis_are_found_again(self):
        actual = "heading\narea 5.5\nmore 1\ncheck 7\n"
        self.assertEqual(shown.refreshed(["heading", "area 5.4", "…"], actual), ["heading", "area 5.5", "…"])
        self.assertEqual(shown.refreshed(["…", "check 6"], actual), ["…", "check 7"])
        self.assertEqual(shown.refreshed(["…", "more 2", "…"], actual), ["…", "more 1", "…"])

    def test_long_lines_are_wrapped_and_found_again(self):
        actual = "heading " + "word " * 40 + "end\narea 5\nlast 7\n"
        wrapped = shown.refreshed(["?"], actual)
        self.assertEqual(len(wrapped), 4)
        self.assertIsNone(shown.difference("\n".join(wrapped), actual))
        self.assertEqual(shown.refreshed([*wrapped[:2], "…"], actual), [*wrapped[:2], "…"])

    def test_an_ellipsis_of_the_program_itself_is_kept(self):
        self.assertEqual(shown.refreshed(["from 0 … 4"], "from 0 … 5\n"), ["from 0 … 5"])

    def test_lines_that_are_gone_are_left_to_a_person(self):
        self.assertIsNone(shown.refreshed(["…", "warm", "…"], "heading\ncold\n"))


if __name__ == "__main__":
    unittest.main()
