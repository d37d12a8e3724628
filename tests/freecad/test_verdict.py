"""The verdict in FreeCAD is that of the program on the file: over shared real parts along their three axes, if they
are there, and over the shipped ones."""

import json
import os
import subprocess
import unittest

import FreeCAD
import Mesh
import Part

from moldlight_workbench import results
from support import PROGRAM, DocumentCase

SHARED = os.environ.get("MOLDLIGHT_SHARED", "")
MOST_FACETS = 1500  # FreeCAD makes a face of each


def solids(file):
    """The solid that FreeCAD makes of a part's file; None where it makes none."""
    if file.endswith((".step", ".stp")):
        shape = Part.read(file)
        return shape if shape.Solids else None
    mesh = Mesh.Mesh(file)
    if mesh.CountFacets > MOST_FACETS or not mesh.isSolid() or mesh.countComponents() > 1:
        return None
    shape = Part.Shape()
    shape.makeShapeFromMesh(mesh.Topology, 1e-7)
    solid = Part.makeSolid(shape)
    return solid if solid.isClosed() and solid.Volume > 0 else None


@unittest.skipUnless(PROGRAM, "the program is not there")
class VerdictTest(DocumentCase):
    def reported(self, command, file, direction):
        report = os.path.join(self.folder.name, "report.json")
        subprocess.run([PROGRAM, command, file, "--unit", "mm", "--direction", direction, "--json", report, "--quiet"],
                       check=True, stdout=subprocess.DEVNULL)
        with open(report) as text:
            return json.load(text)["verdict"]

    def expect_one_verdict(self, file):
        shape = solids(file)
        if shape is None:
            return 0
        body = self.document.addObject("Part::Feature", "Body")
        body.Shape = shape
        regions = results.make_regions(body)
        found = results.actions_of(regions)
        for axis, direction in zip("xyz", (FreeCAD.Vector(1, 0, 0), FreeCAD.Vector(0, 1, 0), FreeCAD.Vector(0, 0, 1))):
            regions.Direction = direction
            self.document.recompute()
            with self.subTest(file=os.path.basename(file), axis=axis):
                self.assertEqual(regions.Verdict, self.reported("classify", file, axis)["sentence"])
                self.assertEqual(found.Verdict, self.reported("actions", file, axis)["sentence"])
        for obj in list(self.document.Objects):
            self.document.removeObject(obj.Name)
        return 1

    def expect_in_folder(self, folder):
        files = sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith((".stl", ".step", ".stp")))
        return sum(self.expect_one_verdict(file) for file in files)

    def test_shipped(self):
        self.assertGreater(self.expect_in_folder(os.path.join(os.environ["MOLDLIGHT_SOURCE"], "tests", "data")), 0)

    @unittest.skipUnless(SHARED, "no shared parts here")
    def test_shared(self):
        used = self.expect_in_folder(os.path.join(SHARED, "parts"))
        print(used, "shared parts used")
        self.assertGreater(used, 2)
