"""What the workbench's files import: the document's objects know of no window, and FreeCAD's geometry computes no regions."""

import os
import re
import unittest

import moldlight_workbench

FOLDER = os.path.dirname(moldlight_workbench.__file__)
OF_WINDOW = {"views.py", "selection.py", "commands.py", "progress.py"}


class LayersTest(unittest.TestCase):
    def test_imports(self):
        seen = 0
        for folder, _, files in os.walk(FOLDER):
            for name in (name for name in files if name.endswith(".py")):
                with open(os.path.join(folder, name), encoding="utf-8") as text:
                    lines = text.read()
                seen += 1
                self.assertLess(lines.count("\n"), 400, name)
                shows = name in OF_WINDOW or os.path.basename(folder) == "panels"
                if not shows:
                    self.assertIsNone(re.search(r"FreeCADGui|PySide|pivy", lines), name)
                # One place knows whether the module is there.
                if name not in ("engine.py", "task.py"):
                    self.assertIsNone(re.search(r"^\s*(import|from) moldlight\b", lines, re.M), name)
        self.assertGreater(seen, 15)


if __name__ == "__main__":
    unittest.main()
