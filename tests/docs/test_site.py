"""The pages as they are installed: built without a warning, whole, and without a network."""

import html.parser
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import documents  # noqa: F401  (finds the tools)
import build_site

LONGEST_BUILD_S = 20


class Reader(html.parser.HTMLParser):
    """Links, loaded files and anchors of a page."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            self.anchors.add(values["id"])
        if tag == "a":
            self.links.append(values["href"])
        elif tag in ("img", "script", "link"):
            self.loaded.append(values.get("src", values.get("href")))


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name) / "html"
        # Processor time, pandoc's with it: other work on the machine makes the clock say more.
        begin = sum(os.times()[:4])
        build_site.main(cls.folder, "1.2.3")
        cls.seconds = sum(os.times()[:4]) - begin
        cls.pages = {page.name: Reader(page.read_text(encoding="utf-8")) for page in cls.folder.glob("*.html")}

    def test_it_is_built_soon(self):
        self.assertLess(self.seconds, LONGEST_BUILD_S)

    def test_every_page_is_there(self):
        sources = {page.stem for page in (documents.ROOT / "docs").glob("*.md")}
        self.assertEqual({name.removesuffix(".html") for name in self.pages}, sources)
        self.assertIn("1.2.3", (self.folder / "index.html").read_text(encoding="utf-8"))

    def test_links_lead_to_pages_and_headings(self):
        for name, page in self.pages.items():
            for link in page.links:
                target, _, anchor = link.partition("#")
                with self.subTest(page=name, link=link):
                    self.assertIn(target or name, self.pages)
                    if anchor:
                        self.assertIn(anchor, self.pages[target or name].anchors)

    def test_what_pages_load_is_beside_them(self):
        for name, page in self.pages.items():
            for file in page.loaded:
                with self.subTest(page=name, file=file):
                    self.assertTrue((self.folder / file).is_file())

    def test_the_search_knows_every_page(self):
        text = (self.folder / "search_index.js").read_text(encoding="utf-8")
        sections = json.loads(text.removeprefix("const sections = ").rstrip(";\n"))
        self.assertEqual({section["page"] for section in sections}, set(self.pages))
        for section in sections:
            self.assertIn(section["anchor"], self.pages[section["page"]].anchors)
        self.assertTrue(any("shut-off" in section["text"] for section in sections))

    def test_the_search_works_in_a_browser(self):
        if not shutil.which("chromium"):
            self.skipTest("chromium is not installed")
        for words, expected in (("shut-off terms", "Nothing found"), ("lifter stroke", "undercuts.html#the-kinds")):
            done = subprocess.run(
                ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={self.folder.parent}/browser",
                 "--virtual-time-budget=2000", "--dump-dom", f"file://{self.folder}/index.html?q={words}"],
                capture_output=True, text=True, timeout=120, check=True)
            found = done.stdout[done.stdout.index('id="found"'):done.stdout.index("</ol>")]
            self.assertIn(expected, found)


if __name__ == "__main__":
    if not shutil.which("pandoc"):
        print("pandoc is not installed; the site is not tested (third_party/setup packages docs)")
        sys.exit(77)
    unittest.main()
