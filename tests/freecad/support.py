"""What the tests have in common: a document a test, and the program's own figures of the same part."""

import csv
import os
import subprocess
import tempfile
import unittest

import FreeCAD

from moldlight_workbench import regions, window

PROGRAM = os.environ.get("MOLDLIGHT_PROGRAM", "")


class DocumentCase(unittest.TestCase):
    """A fresh document with undo."""

    def setUp(self):
        self.document = FreeCAD.newDocument("Test")
        self.document.UndoMode = 1
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)
        self.folder.cleanup()

    def recompute(self):
        self.document.recompute()
        broken = [obj.Name for obj in self.document.Objects if not obj.isValid()]
        self.assertEqual(broken, [])

    def areas(self, found):
        return [getattr(found, name).Value for name in regions.REGION_PROPERTIES]

    def assert_areas(self, found, expected, share=1e-9):
        for area, truth in zip(self.areas(found), expected):
            self.assertAlmostEqual(area, truth, delta=share * sum(expected))

    def classified(self, found):
        """Rows of `moldlight classify --faces` of the body that mold regions are of: face, area, four shares."""
        part = window.write_part(found, self.folder.name)
        table = os.path.join(self.folder.name, "faces.csv")
        flags = window.arguments(found, part)[1:]
        subprocess.run([PROGRAM, "classify", *flags, "--faces", table, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        with open(table, newline="") as lines:
            return [tuple(float(cell) for cell in row) for row in list(csv.reader(lines))[1:]]

    @unittest.skipUnless(PROGRAM, "the program is not there")
    def assert_as_classified(self, found):
        """Face for face the areas and the region are the program's."""
        rows = self.classified(found)
        table = regions.face_table(found)
        self.assertEqual(len(rows), len(table))
        total = found.TotalArea.Value
        for row, (number, region, areas, _) in zip(rows, table):
            for share, area in zip(row[2:], areas):
                self.assertAlmostEqual(share * row[1], area, delta=1e-7 * total, msg=f"Face{number}")
            expected = regions.region_of_faces(regions.numpy.array([[share * row[1] for share in row[2:]]]))[0]
            self.assertEqual((*regions.engine().REGIONS, "mixed")[expected], region, f"Face{number}")
        return len(rows)
