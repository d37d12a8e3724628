"""Mold regions of bodies: areas by formula, faces as the program has them, what follows a change, what is refused."""

import math
import os
import pathlib
import signal
import sys
import unittest
from unittest import mock

import FreeCAD
import Part

import models
from moldlight_workbench import directions, properties, regions, results, shapes
from moldlight_workbench.engine import Refusal
from support import DocumentCase


class RegionsTest(DocumentCase):
    def make(self, body, direction=None):
        found = results.make_regions(body, direction)
        self.recompute()
        return found

    def test_pocket(self):
        body, _ = models.pocket(self.document)
        found = self.make(body)
        self.assert_areas(found, models.pocket_areas())
        self.assert_as_classified(found)

    def test_pocket_across_is_undercut(self):
        body, _ = models.pocket(self.document)
        found = self.make(body, FreeCAD.Vector(1, 0, 0))
        across, along, depth = models.POCKET
        self.assertAlmostEqual(found.UndercutArea.Value, across * along + 2 * depth * (across + along), places=6)
        self.assert_as_classified(found)

    def test_lid(self):
        found = self.make(models.feature(self.document, models.lid_shape()))
        self.assertAlmostEqual(found.UndercutArea.Value, models.lid_undercut(), delta=1e-6)
        self.assert_as_classified(found)
        mixed = self.document.MixedFaces
        floor = [sum(areas) for _, region, areas, _ in regions.face_table(found) if region == "mixed"]
        self.assertEqual(len(floor), 1)
        self.assertAlmostEqual(mixed.Mesh.Area, floor[0], delta=1e-3)
        self.assertEqual(sum(mixed.Counts), mixed.Mesh.CountFacets)

    def test_what_ends_the_module_ends_no_document(self):
        found = self.make(models.feature(self.document, models.lid_shape()))
        areas = list(found.FaceAreas)
        tasks = pathlib.Path("/proc/self/task").iterdir()
        children = {int(child) for task in tasks for child in (task / "children").read_text(encoding="ascii").split()}
        self.assertTrue(children)
        for child in children:
            os.kill(child, signal.SIGSEGV)
            os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
        facets = self.document.MixedFaces.Mesh.CountFacets
        self.document.MixedFaces.touch()
        self.recompute()
        self.assertEqual(self.document.MixedFaces.Mesh.CountFacets, facets)
        self.assertEqual(list(found.FaceAreas), areas)

    def test_fillets(self):
        body, radius = models.filleted(self.document)
        found = self.make(body)
        length, width, height = models.BOX
        # Quarters of cylinders that meet in a mitre at the corners.
        rounded = math.pi * radius * (length + width) - 4 * radius**2 * (math.pi - 2)
        core = (length - 2 * radius) * (width - 2 * radius) + rounded
        self.assertAlmostEqual(found.CavityArea.Value, length * width, places=6)
        both = found.BothArea.Value + found.CoreArea.Value
        self.assertAlmostEqual(both, core + 2 * (length + width) * (height - radius), delta=1e-3 * core)
        self.assertEqual(found.UndercutArea.Value, 0.0)
        self.assert_as_classified(found)

    def test_assembly(self):
        found = self.make(models.three_cubes(self.document))
        self.assert_areas(found, (200.0, 200.0, 1200.0, 200.0))
        self.assertEqual(self.assert_as_classified(found), 18)

    def test_links(self):
        body = models.feature(self.document, models.lid_shape())
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = body
        link.Placement.Base = FreeCAD.Vector(100, 0, 0)
        assembly = self.document.addObject("App::Part", "Assembly")
        assembly.Placement.Base = FreeCAD.Vector(0, 0, 30)
        assembly.addObject(link)
        self.document.recompute()
        found = self.make(link)
        self.assertAlmostEqual(found.UndercutArea.Value, models.lid_undercut(), delta=1e-6)
        self.assertAlmostEqual(found.Shape.BoundBox.XMin, 100, places=6)
        self.assertAlmostEqual(found.Shape.BoundBox.ZMin, 30, places=6)

    def test_bodies_that_touch(self):
        cubes = [Part.makeBox(10, 10, 10, FreeCAD.Vector(x, 0, 0)) for x in (0, 10)]
        found = self.make(models.feature(self.document, Part.makeCompound(cubes)))
        self.assertTrue(any("duplicate facets" in text for text in found.Warnings))
        self.assertEqual(len(found.Warnings), len(set(found.Warnings)))

    def test_placements(self):
        body = models.designed(self.document)
        found = self.make(body)
        floor = next(number for number, face in enumerate(found.Shape.Faces, 1)
                     if abs(face.Area - models.POCKET[0] * models.POCKET[1]) < 1e-6)
        regions.set_reference(found, found, f"Face{floor}")
        self.recompute()
        self.assert_areas(found, models.pocket_areas())
        self.assert_as_classified(found)
        turned = body.getGlobalPlacement().Rotation.multVec(FreeCAD.Vector(0, 0, 1))
        self.assertLess((found.Direction - turned).Length, 1e-9)

        before = found.Shape.BoundBox.Center
        self.document.Assembly.Placement = FreeCAD.Placement(
            FreeCAD.Vector(0, 0, 50), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 70))
        self.recompute()
        self.assertGreater((found.Shape.BoundBox.Center - before).Length, 1.0)
        self.assertLess((found.Shape.BoundBox.Center - shapes.solid_shape(body).BoundBox.Center).Length, 1e-9)
        self.assert_areas(found, models.pocket_areas())

    def test_inches(self):
        schema = FreeCAD.Units.getSchema()
        body, tool = models.pocket(self.document)
        body.Base.Length, body.Base.Width, body.Base.Height = "4 in", "3 in", "2 in"
        tool.Length, tool.Width, tool.Height = "2 in", "1 in", "1 in"
        tool.Placement.Base = FreeCAD.Vector(25.4, 25.4, 25.4)
        self.recompute()
        found = self.make(body)
        square_inch = 25.4**2
        self.assert_areas(found, [inches * square_inch for inches in (12 + 6, 12, 28, 0)])
        self.assert_as_classified(found)
        try:
            FreeCAD.Units.setSchema(3)
            self.assertEqual(properties.quantity(found.CavityArea.Value, "area"), "12.00 in²")
            self.assertEqual(properties.quantity(16387.064, "volume"), "1.00 in³")
        finally:
            FreeCAD.Units.setSchema(schema)

    def test_one_unit_whatever_the_size(self):
        for area in (0.5, 168.0, 5843.1, 2e6):
            self.assertEqual(properties.quantity(area, "area"), f"{area:.2f} mm²")
            self.assertEqual(properties.quantity(area, "volume"), f"{area:.2f} mm³")
            self.assertEqual(properties.quantity(area, "length"), f"{area:.2f} mm")

    def test_dimension_changed(self):
        body, tool = models.pocket(self.document)
        found = self.make(body)
        before = list(found.FaceRegions)
        # Through the whole block: what the core alone formed is now formed by either half.
        tool.Height = models.BOX[2] + 2
        tool.Placement.Base = FreeCAD.Vector(5, 5, -1)
        self.recompute()
        length, width, height = models.BOX
        across, along, _ = models.POCKET
        plane = length * width - across * along
        self.assert_areas(found, (plane, plane, 2 * height * (length + width + across + along), 0.0))
        self.assertNotEqual(list(found.FaceRegions), before)
        self.assert_as_classified(found)

    def test_saved_and_opened(self):
        found = self.make(models.feature(self.document, models.lid_shape()))
        kept = {name: getattr(found, name) for name in ("FaceRegions", "FaceAreas", "FaceDrafts", "Colours", "Direction")}
        areas, facets = self.areas(found), self.document.MixedFaces.Mesh.CountFacets
        file = os.path.join(self.folder.name, "lid.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        found = self.document.MoldRegions
        for again in (False, True):
            for name, value in kept.items():
                self.assertEqual(getattr(found, name), value, name)
            self.assertEqual(self.areas(found), areas)
            self.assertEqual(self.document.MixedFaces.Mesh.CountFacets, facets)
            if not again:
                found.touch()
                self.recompute()

    def test_undo(self):
        body, _ = models.pocket(self.document)
        self.document.openTransaction("regions")
        found = self.make(body)
        self.document.commitTransaction()
        first = self.areas(found)
        self.document.openTransaction("direction")
        found.Direction = FreeCAD.Vector(1, 0, 0)
        self.recompute()
        self.document.commitTransaction()
        self.assertNotEqual(self.areas(found), first)
        self.document.undo()
        self.assertEqual(self.areas(found), first)
        self.document.redo()
        self.assertNotEqual(self.areas(found), first)
        self.document.undo()
        self.document.undo()
        self.assertIsNone(self.document.getObject("MoldRegions"))
        self.assertIsNone(self.document.getObject("MixedFaces"))
        self.assertTrue(body.Visibility)
        self.document.redo()
        self.assertEqual(self.areas(self.document.MoldRegions), first)

    def test_draft(self):
        cone = models.feature(self.document, Part.makeCone(10, 8, 20))
        found = self.make(cone)
        lean = math.degrees(math.atan2(2, 20))
        side = [draft for _, region, _, draft in regions.face_table(found) if region == "core" and draft < 80]
        self.assertEqual(len(side), 1)
        self.assertAlmostEqual(side[0], lean, places=9)


class DirectionsTest(DocumentCase):
    def test_typed(self):
        self.assertEqual(tuple(directions.typed("-y")), (0, -1, 0))
        self.assertEqual(tuple(directions.typed(" 0, 0 2")), (0, 0, 1))
        for text in ("", "w", "1,2", "0,0,0", "1,2,nan", "--z", "1e999,0,0"):
            with self.assertRaises(Refusal, msg=text):
                directions.typed(text)

    def test_elements(self):
        body = models.feature(self.document, Part.makeCylinder(
            5, 9, FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(0, 1, 1)))
        axis = FreeCAD.Vector(0, 1, 1).normalize()
        for kind, count in (("Face", len(body.Shape.Faces)), ("Edge", len(body.Shape.Edges))):
            for number in range(1, count + 1):
                found = directions.of_element(body, f"{kind}{number}")
                self.assertAlmostEqual(abs(found.dot(axis)), 1.0, places=9, msg=f"{kind}{number}")
        with self.assertRaises(Refusal):
            directions.of_element(body)

    def test_axes_of_a_body(self):
        body = models.designed(self.document)
        origin = {feature.Role: feature for feature in body.Origin.OriginFeatures}
        turned = body.getGlobalPlacement().Rotation
        for role, local in (("X_Axis", (1, 0, 0)), ("Y_Axis", (0, 1, 0)), ("Z_Axis", (0, 0, 1)), ("XY_Plane", (0, 0, 1)),
                            ("YZ_Plane", (1, 0, 0))):
            found = directions.of_element(origin[role])
            self.assertLess((found - turned.multVec(FreeCAD.Vector(*local))).Length, 1e-9, role)


class RefusalTest(DocumentCase):
    def refused(self, body):
        with self.assertRaises(Refusal) as caught:
            results.make_regions(body)
        self.assertNotIn("\n", str(caught.exception))
        self.assertIsNone(self.document.getObject("MoldRegions"))
        return str(caught.exception)

    def test_no_solid(self):
        sheet = models.feature(self.document, Part.makePlane(10, 10), "Sheet")
        self.assertIn("“Sheet” has no solid", self.refused(sheet))
        self.assertIn("has no solid", self.refused(self.document.addObject("PartDesign::Body", "Empty")))
        self.assertIn("has no solid", self.refused(self.document.addObject("App::DocumentObjectGroup", "Group")))

    def test_no_module(self):
        body, _ = models.pocket(self.document)
        with mock.patch.dict(sys.modules, {"moldlight": None}):
            self.assertIn("module moldlight is not there", self.refused(body))

    def test_file_without_module(self):
        body, _ = models.pocket(self.document)
        found = results.make_regions(body)
        self.recompute()
        file = os.path.join(self.folder.name, "pocket.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        with mock.patch.dict(sys.modules, {"moldlight": None}):
            self.document = FreeCAD.openDocument(file)
            self.assert_areas(self.document.MoldRegions, models.pocket_areas())

    def test_no_direction(self):
        body, _ = models.pocket(self.document)
        found = results.make_regions(body)
        with self.assertRaises(Refusal):
            regions.set_reference(found, self.document.MixedFaces)
        found.Direction = FreeCAD.Vector(0, 0, 0)
        with self.assertRaises(Refusal):
            found.Proxy.classification(found)


if __name__ == "__main__":
    unittest.main()
