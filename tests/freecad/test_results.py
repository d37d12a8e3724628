"""Directions, side actions, parting line and halves: by formula, and as the program reports them."""

import json
import os
import subprocess
import unittest

import FreeCAD
import Part

import models
from moldlight_workbench import actions, analysis, parting, results, sweeps, window
from moldlight_workbench.engine import Refusal
from support import PROGRAM, DocumentCase


class ResultsTest(DocumentCase):
    def setUp(self):
        super().setUp()
        self.body = models.feature(self.document, models.lid_shape())
        self.regions = results.make_regions(self.body)
        self.recompute()

    def reported(self, command, *flags):
        """The program's report of the same part."""
        part = window.write_part(self.regions, self.folder.name)
        given = window.arguments(self.regions, part)[1:]
        file = os.path.join(self.folder.name, "report.json")
        subprocess.run([PROGRAM, command, *given, *flags, "--json", file, "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        with open(file) as text:
            return json.load(text)

    def test_directions(self):
        found = results.directions_of(self.regions)
        self.recompute()
        table = sweeps.direction_table(found)
        # No two are beside each other, so that fewer than were asked for may be listed.
        self.assertLessEqual(len(table), found.Top)
        self.assertGreaterEqual(len(table), 3)
        self.assertEqual(tuple(map(abs, found.Found[0])), (0, 0, 1))
        self.assertAlmostEqual(table[0][1], models.lid_undercut(), delta=1e-6)
        self.assertEqual([row[1] for row in table], sorted(row[1] for row in table))
        # Another direction of the regions asks nothing anew.
        answer = found.Proxy._found
        self.regions.Direction = found.Found[1]
        self.recompute()
        self.assertIs(found.Proxy._found, answer)
        self.assertAlmostEqual(self.regions.UndercutArea.Value, table[1][1], delta=1e-6)

    def test_actions_that_meet(self):
        """Pockets 4 deep in facing walls 12 apart: each lifter comes to 7 beyond its wall."""
        self.body.Shape = models.facing_pockets(12)
        found = results.actions_of(self.regions)
        # Side by side their stems would have no room.
        found.LifterSection = 0
        self.recompute()
        self.assertEqual(actions.meetings(found), [(1, 2)])
        self.body.Shape = models.facing_pockets(16)
        self.recompute()
        self.assertEqual([row[0] for row in actions.action_table(found)], ["lifter", "lifter"])
        self.assertEqual(actions.meetings(found), [])
        self.assertEqual(actions.hits(found), [])

    def test_actions(self):
        found = results.actions_of(self.regions)
        self.recompute()
        table = actions.action_table(found)
        self.assertEqual([row[0] for row in table], ["lifter", "lifter"])
        for kind, direction, travel, stroke, area, body, undercuts in table:
            self.assertGreater(body["volume"], 0)
            self.assertGreater(body["least_section"], 0)
            self.assertLess((direction - FreeCAD.Vector(0, 1, 0)).Length, 1e-5)
            self.assertAlmostEqual(travel, models.CATCH, delta=1e-3)
            self.assertAlmostEqual(area, models.lid_undercut() / 2, delta=1e-6)
        self.assertEqual(len(found.Counts), 2)
        self.assertEqual(sum(found.Counts), found.Mesh.CountFacets)
        self.assertTrue(found.Mesh.isSolid())
        self.assertEqual(len(self.document.ActionArrows.Shape.Solids), 2)
        if PROGRAM:
            reported = self.reported("actions")["actions"]
            self.assertEqual([action["kind"] for action in reported], [row[0] for row in table])
            for action, row in zip(reported, table):
                self.assertAlmostEqual(action["travel"], row[2], delta=1e-6)

    def test_mold(self):
        found = results.parting_of(self.regions)
        self.recompute()
        self.assertEqual(found.Refusal, "")
        self.assertEqual(found.Kinds[0], "outer")
        self.assertEqual(len(found.Shape.Wires), len(found.Kinds))
        self.assertTrue(all(isinstance(wire, Part.Wire) and wire.isClosed() for wire in found.Shape.Wires))
        length, width, _ = models.LID
        self.assertAlmostEqual(found.Shape.Wires[0].Length, 2 * (length + width), places=6)
        self.assertEqual(len(parting.loop_table(found)), len(found.Kinds))
        bodies = [self.document.getObject(name) for name in ("MoldCore", "MoldCavity", "MoldInsert")]
        for body in bodies:
            self.assertTrue(body.Mesh.isSolid(), body.Name)
            self.assertAlmostEqual(body.Mesh.Volume, body.Volume.Value, delta=1e-4 * body.Volume.Value)
        block = self.document.MoldCore.Volume.Value + sum(body.Volume.Value for body in bodies[1:])
        self.assertAlmostEqual(
            block + self.body.Shape.Volume, analysis.report(found)["halves"]["block_volume"], delta=1e-3 * self.body.Shape.Volume)
        opened = self.document.MoldCore.Placement.Base - self.document.MoldCavity.Placement.Base
        self.assertAlmostEqual(opened.z, 2 * found.Opening.Value, places=6)
        if PROGRAM:
            self.assertTrue(found.Verdict.startswith(self.reported("mold", "--fill-undercut")["verdict"]["sentence"]))

    def test_halves_along_an_oblique_direction(self):
        turned = FreeCAD.Placement(FreeCAD.Vector(30, -20, 10), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 0), 33))
        self.body.Placement = turned
        self.regions.Direction = turned.Rotation.multVec(FreeCAD.Vector(0, 0, 1))
        found = results.parting_of(self.regions)
        found.Opening = 0
        self.recompute()
        self.assertEqual(found.Refusal, "")
        # The closed mold stands around the body, wherever that is.
        box = FreeCAD.BoundBox()
        for name in ("MoldCore", "MoldCavity"):
            box.add(self.document.getObject(name).Mesh.BoundBox)
        self.assertLess((box.Center - self.body.Shape.BoundBox.Center).Length, 0.2 * self.body.Shape.BoundBox.DiagonalLength)
        self.assertTrue(box.isInside(self.body.Shape.BoundBox))

    def test_refused_halves(self):
        found = results.parting_of(self.regions)
        found.FillUndercut = False
        self.recompute()
        self.assertIn("fill_undercut", found.Refusal)
        self.assertEqual(self.document.MoldCore.Mesh.CountFacets, 0)
        self.assertGreater(len(found.Shape.Wires), 0)

    def test_everything_follows_the_body(self):
        line, found = results.parting_of(self.regions), results.actions_of(self.regions)
        directions = results.directions_of(self.regions)
        self.recompute()
        self.body.Shape = Part.makeBox(*models.BOX)
        self.recompute()
        self.assertEqual(actions.action_table(found), [])
        self.assertEqual(found.Mesh.CountFacets, 0)
        self.assertEqual(len(self.document.ActionArrows.Shape.Solids), 0)
        self.assertEqual(line.Kinds, ["outer"])
        self.assertEqual(self.document.MoldInsert.Mesh.CountFacets, 0)
        self.assertEqual(sweeps.direction_table(directions)[0][1], 0.0)

    def test_results_without_their_regions(self):
        results.parting_of(self.regions), results.actions_of(self.regions)
        self.recompute()
        self.document.removeObject(self.regions.Name)
        left = [obj for obj in self.document.Objects if hasattr(obj, "Regions")]
        self.assertEqual(len(left), 7)
        for obj in left:
            with self.assertRaises(Refusal, msg=obj.Name):
                obj.Proxy.execute(obj)

    def test_saved_and_opened(self):
        results.parting_of(self.regions), results.actions_of(self.regions)
        self.recompute()

        def state():
            names = ("SideActions", "MoldCore", "MoldCavity", "MoldInsert")
            return [self.document.getObject(name).Mesh.CountFacets for name in names] + [
                self.document.SideActions.Report, self.document.PartingLine.Report,
                round(self.document.PartingLine.Shape.Length, 6),
                len(self.document.ActionArrows.Shape.Faces)]

        before = state()
        file = os.path.join(self.folder.name, "mold.FCStd")
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        self.assertEqual(state(), before)
        self.assertEqual(len(self.document.Mold.Group), 8)

    def test_window_of_the_program(self):
        self.regions.Direction = FreeCAD.Vector(0, 0, -1)
        self.regions.Tau = 2.5
        self.recompute()
        given = window.arguments(self.regions, "part.step")
        self.assertEqual(given[given.index("--direction") + 1], "0.0,0.0,-1.0")
        self.assertEqual(given[given.index("--tau") + 1], "2.5")
        if PROGRAM:
            picture = os.path.join(self.folder.name, "window.png")
            part = window.write_part(self.regions, self.folder.name)
            subprocess.run([PROGRAM, *window.arguments(self.regions, part), "--quick-sweep", "off", "--screenshot", picture],
                           check=True, stdout=subprocess.DEVNULL)
            self.assertGreater(os.path.getsize(picture), 10000)


if __name__ == "__main__":
    unittest.main()
