"""What the workbench's files import: the document's objects know of no window, and FreeCAD's geometry computes no regions."""

import os
import re
import unittest
import xml.etree.ElementTree

import moldlight_workbench

FOLDER = os.path.dirname(moldlight_workbench.__file__)
# What package.xml says for want of a place where the project is hosted: to be set before the workbench is offered there.
PLACEHOLDERS = {"maintainer": "moldlight@example.org", "repository": "https://example.org/moldlight"}
OF_WINDOW = {"views.py", "selection.py", "commands.py", "progress.py", "language.py"}


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

    def test_package(self):
        folder = os.path.dirname(FOLDER)
        package = xml.etree.ElementTree.parse(os.path.join(folder, "package.xml")).getroot()
        of = {"": "https://wiki.freecad.org/Package_Metadata"}

        def one(path):
            found = package.findall(path, of)
            self.assertEqual(len(found), 1, path)
            return found[0]

        with open(os.path.join(os.environ["MOLDLIGHT_SOURCE"], "CMakeLists.txt"), encoding="utf-8") as text:
            self.assertIn(f"VERSION {one('version').text} ", text.read())
        self.assertRegex(one("date").text, r"^\d{4}-\d\d-\d\d$")
        self.assertEqual(one("maintainer").text, "the moldlight authors")
        repository = one("url[@type='repository']")
        self.assertEqual(repository.get("branch"), "main")
        self.assertEqual({"maintainer": one("maintainer").get("email"), "repository": repository.text}, PLACEHOLDERS)
        with open(os.path.join(folder, "InitGui.py"), encoding="utf-8") as text:
            self.assertIn(f"class {one('.//classname').text}(", text.read())
        for icon in package.findall(".//icon", of):
            self.assertTrue(os.path.isfile(os.path.join(folder, icon.text)), icon.text)


if __name__ == "__main__":
    unittest.main()
