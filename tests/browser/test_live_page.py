"""The page of `--html --live` in Firefox: other code than Chromium's compiles its shaders and runs its scripts."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import firefox

MOLDLIGHT = os.environ["MOLDLIGHT_BINARY"]
PART = pathlib.Path(__file__).parents[2] / "assets" / "parts" / "tilted_bracket.stl"
FRAMES = pathlib.Path(__file__).parents[1] / "data" / "live_frames.js"
DIRECTIONS = ("1,0,0", "0,1,0", "0.3,-0.5,0.81", "-0.7,0.2,0.1", "0.02,0,1")

# Areas along a direction that the page has left at rest, or moves to, and what it says of them.
AREAS = """begun.then((view) => {
  const live = view.director;
  live.shownAt = 0;
  live.go(unit(%s), %s);
  view.draw();
  clearTimeout(live.resting);
  return {areas: live.areas, said: byId("standing").textContent};
})"""


def moldlight(*words):
    return subprocess.run([MOLDLIGHT, *words], check=True, capture_output=True, timeout=300)


def live_page(part, folder):
    page = pathlib.Path(folder) / "live.html"
    moldlight("classify", str(part), "--direction", "z", "--html", str(page), "--live")
    return page


@unittest.skipUnless(firefox.IS_THERE, "firefox-esr or Xvfb is not installed")
class LivePage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        page = live_page(PART, cls.folder.name)
        cls.browser = firefox.Firefox()
        cls.addClassCleanup(cls.browser.close)
        cls.browser.load(page)

    def exact_areas(self, direction):
        path = pathlib.Path(self.folder.name) / "exact.json"
        moldlight("classify", str(PART), f"--direction={direction}", "--json", str(path))
        return json.loads(path.read_text())["areas"]

    def test_areas_of_any_direction_are_within_the_stated_error(self):
        for direction in DIRECTIONS:
            exact = self.exact_areas(direction)
            for rest in ("false", "true"):
                with self.subTest(direction=direction, rest=rest):
                    found = self.browser.value(AREAS % (f"[{direction}]", rest))
                    stated = re.fullmatch(r"Areas by shadow maps, ± ([0-9.]+) % of the surface\.", found["said"])
                    self.assertIsNotNone(stated, found["said"])
                    error = float(stated[1])
                    self.assertLess(error, 0.5 if rest == "true" else 10.0)
                    for area, region in zip(found["areas"], ("core", "cavity", "both", "undercut")):
                        self.assertAlmostEqual(100 * area / exact["total"], 100 * exact[region] / exact["total"], delta=error)

    def test_exact_areas_stand_for_the_asked_direction(self):
        found = self.browser.value(AREAS % ("[0, 0, 1]", "true"))
        exact = self.exact_areas("0,0,1")
        self.assertEqual(found["areas"], [exact[region] for region in ("core", "cavity", "both", "undercut")])
        self.assertEqual(found["said"], "Exact areas.")

    def test_nothing_is_complained_of_or_asked_for(self):
        self.browser.value(AREAS % ("[0.1, 0.2, 1]", "true"))
        self.assertEqual(self.browser.messages, [])
        self.assertEqual(self.browser.requests, 0)

    def test_the_picture_has_the_regions(self):
        # Colours that are no grey: in the background there are none.
        colourful = self.browser.value("""begun.then((view) => {
          view.director.go(unit([0.3, -0.5, 0.81]), true);
          view.draw();
          const {gl} = view, {width, height} = gl.canvas, pixels = new Uint8Array(4 * width * height);
          gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
          let count = 0;
          for (let k = 0; k < pixels.length; k += 4) {
            const colour = [...pixels.subarray(k, k + 3)];
            if (Math.max(...colour) - Math.min(...colour) > 80) ++count;
          }
          return count / width / height;
        })""")
        self.assertGreater(colourful, 0.03)


def print_frames(parts):
    """How fast the pages of these parts follow the direction."""
    browser = firefox.Firefox()
    for part in parts:
        with tempfile.TemporaryDirectory() as folder:
            browser.load(live_page(part, folder))
            plain, live = browser.value(f"begun.then({FRAMES.read_text()})")
            print(f"{pathlib.Path(part).name}: plain {plain:.1f} ms, by maps {live:.1f} ms a frame")
    browser.close()


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print_frames(sys.argv[1:])
    elif not firefox.IS_THERE:
        print("skipped: firefox-esr or Xvfb is not installed")
        sys.exit(77)
    else:
        unittest.main()
