"""Links, pictures, flags and tests that README and docs name exist."""

import re
import unittest

import documents
import blocks
import page_check

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
# Flags of other programs: sbatch, cmake.
OTHERS = {"--cpus-per-task", "--build", "--install", "--no-build-isolation", "--prefix", "--preset"}


class Links(unittest.TestCase):
    def test_links_and_pictures_exist(self):
        count = 0
        for page in documents.PAGES:
            for target in LINK.findall("\n".join(blocks.prose(blocks.read(page)))):
                with self.subTest(page=page.name, target=target):
                    self.assertFalse(target.startswith(("http:", "https:")), "the pages need no network")
                    path, _, anchor = target.partition("#")
                    file = (page.parent / path).resolve() if path else page
                    self.assertTrue(file.exists())
                    if anchor:
                        self.assertIn(anchor, documents.anchors(blocks.read(file)))
                    count += 1
        self.assertGreater(count, 80)

    def test_every_picture_is_shown(self):
        text = "\n".join(page.read_text(encoding="utf-8") for page in documents.PAGES)
        for picture in (documents.ROOT / "assets" / "pictures").glob("*.png"):
            self.assertTrue(f"pictures/{picture.name}" in text, picture.name)

    def test_every_picture_is_made_by_the_script(self):
        # Some are written on the way of a script that the window plays.
        scripts = [documents.ROOT / "docs" / "tools" / "make_pictures", *documents.ROOT.glob("assets/*.json")]
        script = "\n".join(path.read_text(encoding="utf-8") for path in scripts)
        for picture in (documents.ROOT / "assets" / "pictures").glob("*.png"):
            self.assertTrue(picture.stem in script, picture.name)

    def test_flags_exist(self):
        known = set().union(*page_check.known_flags().values()) | {"--help"} | OTHERS
        for page in documents.PAGES:
            for code in re.findall(r"`([^`]+)`", "\n".join(blocks.prose(blocks.read(page)))):
                for flag in re.findall(r"(?<![\w-])--[a-z0-9][a-z0-9-]*", code):
                    with self.subTest(page=page.name, flag=flag):
                        self.assertTrue(flag in known)

    def test_tests_that_are_named_exist(self):
        sources = "\n".join(path.read_text(encoding="utf-8") for path in documents.ROOT.glob("tests/*/*.cpp"))
        named = re.findall(r"--gtest_filter='(\w+)(?:\*|\.(\w+))'",
                           (documents.ROOT / "docs" / "validation.md").read_text(encoding="utf-8"))
        self.assertGreater(len(named), 5)
        for suite, case in named:
            with self.subTest(suite=suite):
                self.assertRegex(sources, rf"TEST\w*\({suite}\w*,\s*{case}")


if __name__ == "__main__":
    unittest.main()
