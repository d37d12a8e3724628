"""The examples run as they are shipped, and say what they should."""

import os
import subprocess
import sys
import tempfile
import unittest

import support

EXAMPLES = support.SOURCE / "src" / "python" / "examples"


class Examples(unittest.TestCase):
    def run_example(self, name, *arguments):
        done = subprocess.run([sys.executable, EXAMPLES / name, *map(str, arguments)], capture_output=True, text=True,
                              check=False, env=os.environ)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_none_is_left_out(self):
        tested = {"channel_from_arrays.py", "regions_of_a_folder.py", "best_direction.py"}
        self.assertEqual({path.name for path in EXAMPLES.glob("*.py")}, tested)

    def test_channel_from_arrays(self):
        # A channel of 40 x 30 x 20, walls and floor of 10, with a lip of 2 over its floor.
        lines = self.run_example("channel_from_arrays.py").splitlines()
        self.assertIn("undercut 360 mm2", lines)
        self.assertIn("closed split mesh: True", lines)

    def test_regions_of_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            table = os.path.join(folder, "table.csv")
            self.run_example("regions_of_a_folder.py", support.ASSETS, "z", table)
            with open(table, encoding="utf-8") as file:
                lines = file.read().splitlines()
        self.assertEqual(len(lines), 1 + len(list(support.ASSETS.glob("*.stl"))))
        self.assertTrue(lines[0].startswith("part,core,cavity,both,undercut"))

    def test_best_direction(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "best.ppm")
            text = self.run_example("best_direction.py", support.ASSETS / "cable_clip.stl", picture)
            self.assertIn("best direction", text)
            with open(picture, "rb") as file:
                self.assertTrue(file.read().startswith(b"P6\n800 500\n255\n"))


if __name__ == "__main__":
    unittest.main()
