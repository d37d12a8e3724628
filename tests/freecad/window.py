"""Run by freecad in a real window: commands, panels, colours, messages. Pictures go to MOLDLIGHT_PICTURES, if that is
set. Ends with 1 if a test failed."""

import os
import re
import sys
import tempfile
import time
import traceback
import unittest
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.join(os.environ["MOLDLIGHT_SOURCE"], "tests", "freecad"))

PICTURES = os.environ.get("MOLDLIGHT_PICTURES", "")
# The window has come up by then; by the second the tests have ended or hang.
START_MS, END_MS = 2500, 400_000


def settle(seconds=0.2):
    """Lets the window do what it has to."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents()
        time.sleep(0.01)


def picture(name):
    if PICTURES:
        settle(0.5)
        os.system(f"import -window root '{os.path.join(PICTURES, name)}.png'")


class Marked(QtCore.QTranslator):
    """A language in which every text of the workbench is marked."""

    def translate(self, context, text, disambiguation=None, n=-1):
        return f"«{text}»" if context == "Moldlight" else ""


def unmarked_texts(panel):
    """Words on a panel that do not come from the language: neither names nor what the module says."""
    form = panel.form
    texts = [form.windowTitle(), *(label.text() for label in form.findChildren(QtGui.QLabel))]
    texts += [button.text() for button in form.findChildren(QtGui.QPushButton)]
    texts += [box.text() for box in form.findChildren(QtGui.QCheckBox)]
    for table in form.findChildren(QtGui.QTableWidget):
        texts += [table.horizontalHeaderItem(column).text() for column in range(table.columnCount())]
        texts += [row[0] for row in panel_rows(table)]
    own = re.compile(r"«.*»|Face\d+|[-−+\d., ]*|[-−]?[XYZxyz]|%", re.S)
    return [text for text in texts if not own.fullmatch(text)]


def report_lines():
    """What stands in FreeCAD's report view."""
    view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
    return view.toPlainText().split("\n")


def panel_rows(table):
    return [[table.item(row, column).text() for column in range(table.columnCount())] for row in range(table.rowCount())]


class WindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FreeCADGui.activateWorkbench("MoldlightWorkbench")

    def setUp(self):
        import models
        from moldlight_workbench import commands
        from moldlight_workbench.panels import task

        self.models, self.document = models, FreeCAD.newDocument("Test")
        self.document.UndoMode = 1
        self.messages, self.panels = [], []
        patches = [mock.patch.object(task, "say", self.messages.append)]
        for command in commands.COMMANDS[:-1]:
            patches.append(mock.patch.object(command, "make_panel", self.keeping(command.make_panel)))
        for patch in patches:
            patch.start()
            self.addCleanup(patch.stop)

    def keeping(self, make):
        def made(command, regions):
            self.panels.append(make(command, regions))
            return self.panels[-1]

        return made

    def tearDown(self):
        FreeCADGui.Control.closeDialog()
        FreeCAD.closeDocument(self.document.Name)
        settle()

    def body(self, shape=None):
        made = self.models.feature(self.document, shape or self.models.lid_shape())
        self.document.recompute()
        view = FreeCADGui.activeDocument().activeView()
        view.setAnimationEnabled(False)
        view.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")
        return made

    def run_command(self, name, *selected):
        """Runs a command on what is selected and returns its panel; None if it opened none."""
        FreeCADGui.Selection.clearSelection()
        for source, *elements in selected:
            FreeCADGui.Selection.addSelection(source, *elements)
        count = len(self.panels)
        FreeCADGui.runCommand("Moldlight_" + name)
        settle()
        return self.panels[-1] if len(self.panels) > count and FreeCADGui.Control.activeDialog() else None

    def shown_colours(self, obj):
        return [tuple(round(255 * part) for part in colour[:3]) for colour in obj.ViewObject.DiffuseColor]

    def facet_colours(self, obj):
        from moldlight_workbench import views

        material = views._nodes(obj.ViewObject.RootNode, views.coin.SoMaterial)[0]
        values = material.diffuseColor.getValues()
        return [tuple(round(255 * part) for part in value) for value in values]

    def assert_coloured(self, found):
        """Faces of one region have its colour, facets on mixed faces theirs."""
        from moldlight_workbench import regions

        settle()
        palette = regions.palette()
        shown = self.shown_colours(found)
        self.assertEqual(len(shown), len(found.Shape.Faces))
        for region, colour in zip(found.FaceRegions, shown):
            if region != regions.MIXED:
                self.assertEqual(colour, tuple(palette[region]))
        mixed = self.document.MixedFaces
        expected = [tuple(palette[region]) for region, count in enumerate(mixed.Counts) for _ in range(count)]
        if expected:
            self.assertEqual(self.facet_colours(mixed), expected)

    def test_regions(self):
        body = self.body()
        panel = self.run_command("Regions", (body,))
        found = self.document.MoldRegions
        picture("regions")
        self.assertEqual(self.messages, [])
        self.assertFalse(body.ViewObject.Visibility)
        self.assert_coloured(found)
        self.assertEqual([row[0] for row in panel_rows(panel.areas)], ["Core", "Cavity", "Both", "Undercut"])
        self.assertEqual(len(panel_rows(panel.faces)), len(found.Shape.Faces))
        panel.faces.selectRow(3)
        self.assertEqual(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames, ("Face4",))

        core = found.CoreArea.Value
        panel.typed.setText("-z")
        panel.typed.returnPressed.emit()
        self.assertAlmostEqual(found.CavityArea.Value, core, places=6)
        self.assert_coloured(found)
        panel.typed.setText("nowhere")
        panel.typed.returnPressed.emit()
        self.assertEqual(len(self.messages), 1)
        self.assertEqual(panel.typed.text(), "-z")
        panel.accept()
        self.assertEqual(self.document.UndoNames, ["Mold regions"])
        self.document.undo()
        settle()
        self.assertIsNone(self.document.getObject("MoldRegions"))
        self.assertTrue(body.ViewObject.Visibility)

    def test_direction_of_a_face_and_cancel(self):
        body = self.body()
        side = next(number for number, face in enumerate(body.Shape.Faces, 1)
                    if abs(face.normalAt(0, 0).x) > 0.99 and face.Area > 500)
        panel = self.run_command("Regions", (body, f"Face{side}"))
        found = self.document.MoldRegions
        self.assertAlmostEqual(abs(found.Direction.x), 1.0, places=9)
        self.assertIn(f"Face{side}", panel.follows.text())
        panel.reject()
        settle()
        self.assertIsNone(self.document.getObject("MoldRegions"))
        self.assertEqual(self.document.UndoNames, [])

    def test_all_panels(self):
        body = self.body()
        self.run_command("Regions", (body,)).accept()
        found = self.document.MoldRegions
        panel = self.run_command("FindDirection", (found,))
        picture("direction")
        self.assertEqual(len(panel_rows(panel.rows)), len(self.document.FoundDirections.Found))
        panel.rows.selectRow(1)
        self.assertEqual(found.Direction, self.document.FoundDirections.Found[1])
        self.assert_coloured(found)
        panel.rows.selectRow(0)
        panel.accept()

        panel = self.run_command("Actions", (found,))
        found.ViewObject.Transparency = 60
        picture("actions")
        self.assertEqual([row[0] for row in panel_rows(panel.rows)], ["lifter", "lifter"])
        panel.accept()
        found.ViewObject.Transparency = 0
        panel = self.run_command("Parting", (found,))
        picture("parting")
        self.assertEqual(panel_rows(panel.rows)[0][0], "outer")
        panel.rows.selectRow(0)
        self.assertEqual(len(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames), 4)
        panel.opening.setChecked(False)
        self.assertEqual(self.document.PartingLine.Opening.Value, 0)
        panel.accept()
        for name in ("SideActions", "MoldCore", "MoldCavity", "MoldInsert"):
            self.document.getObject(name).ViewObject.Visibility = False
        panel = self.run_command("Regions", (found,))
        turned = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 160).multiply(FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 42))
        FreeCADGui.activeDocument().activeView().setCameraOrientation(turned.Q)
        FreeCADGui.SendMsgToActiveView("ViewFit")
        picture("freecad")
        panel.accept()
        self.assertEqual(self.messages, [])

        file = os.path.join(tempfile.mkdtemp(), "lid.FCStd")
        before = self.shown_colours(found)
        self.document.saveAs(file)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(file)
        settle()
        self.assertEqual(self.shown_colours(self.document.MoldRegions), before)
        self.assert_coloured(self.document.MoldRegions)
        self.assertEqual(self.document.UndoNames, [])

    def test_file_made_without_a_window(self):
        """Such a file has no views: here they are taken from one."""
        import zipfile

        body = self.body()
        self.run_command("Regions", (body,)).accept()
        folder = tempfile.mkdtemp()
        whole, bare = os.path.join(folder, "whole.FCStd"), os.path.join(folder, "bare.FCStd")
        self.document.saveAs(whole)
        with zipfile.ZipFile(whole) as old, zipfile.ZipFile(bare, "w") as new:
            for name in old.namelist():
                if not name.startswith("GuiDocument") and "Color" not in name:
                    new.writestr(name, old.read(name))
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(bare)
        self.assert_coloured(self.document.MoldRegions)

    def long_search(self):
        """Regions of a body and directions to be found for it, which takes minutes if nobody cancels it."""
        from moldlight_workbench import results

        self.run_command("Regions", (self.body(),)).accept()
        found = results.directions_of(self.document.MoldRegions)
        found.Directions = 100_000
        return found

    def test_cancelled_search(self):
        self.long_search()
        pressed = []

        def press():
            for dialog in QtGui.QApplication.topLevelWidgets():
                if isinstance(dialog, QtGui.QProgressDialog) and dialog.isVisible():
                    pressed.append(dialog.labelText())
                    dialog.cancel()

        timer = QtCore.QTimer()
        timer.timeout.connect(press)
        timer.start(50)
        panel = self.run_command("FindDirection", (self.document.MoldRegions,))
        timer.stop()
        self.assertTrue(pressed)
        self.assertIn("ended early", panel.remarks.text())
        self.assertEqual(self.messages, [])

    def test_cancelled_recompute(self):
        """FreeCAD itself drops the mouse while it recomputes."""
        from moldlight_workbench import sweeps

        found = self.long_search()
        pressed = []

        def press():
            for dialog in QtGui.QApplication.topLevelWidgets():
                if isinstance(dialog, QtGui.QProgressDialog) and dialog.isVisible() and "direction" in dialog.windowTitle():
                    button = dialog.findChild(QtGui.QPushButton)
                    pressed.append(button)
                    QtGui.QApplication.postEvent(button, QtGui.QMouseEvent(
                        QtCore.QEvent.MouseButtonPress, QtCore.QPointF(5, 5), QtCore.Qt.LeftButton, QtCore.Qt.LeftButton,
                        QtCore.Qt.NoModifier))

        timer = QtCore.QTimer()
        timer.timeout.connect(press)
        timer.start(50)
        self.document.recompute()
        timer.stop()
        self.assertTrue(pressed)
        self.assertIn("ended early", sweeps.remarks(found)[0])

    def test_body_of_part_design(self):
        """The face that is clicked on belongs to the last feature; what is molded is the body."""
        body = self.models.designed(self.document)
        self.assertIsNotNone(self.run_command("Regions", (self.document.Pocket, "Face1")))
        found = self.document.MoldRegions
        self.assertIs(found.Source, body)
        self.assertEqual(found.Reference[0], self.document.Pocket)

    def test_all_texts_can_be_translated(self):
        language = Marked()
        QtGui.QApplication.installTranslator(language)
        self.addCleanup(QtGui.QApplication.removeTranslator, language)
        body = self.body()
        for command in ("Regions", "FindDirection", "Actions", "Parting"):
            panel = self.run_command(command, (body,))
            # What the module says is in its own words.
            said = [getattr(panel, name).text() for name in ("remarks", "verdict", "refusal") if hasattr(panel, name)]
            said += [found.Verdict for found in self.document.Objects if hasattr(found, "Verdict")]
            self.assertEqual([text for text in unmarked_texts(panel) if text not in said], [], command)
            panel.accept()

    def test_languages(self):
        from moldlight_workbench import words

        self.addCleanup(FreeCADGui.setLocale, "English")
        names = {"German": ("Formbereiche", "Entformschräge", "Kern"), "French": ("Zones de moulage", "Dépouille", "Noyau")}
        body = self.body()
        for language, (title, draft, core) in names.items():
            FreeCADGui.setLocale(language)
            settle()
            panel = self.run_command("Regions", (body,))
            picture("regions_" + language.lower())
            self.assertEqual(panel.form.windowTitle(), title)
            self.assertIn(draft, [panel.faces.horizontalHeaderItem(column).text() for column in range(3)])
            self.assertEqual(panel_rows(panel.areas)[0][0], core)
            self.assertIn(title, [action.text() for action in FreeCADGui.getMainWindow().findChildren(QtGui.QAction)])
            known = {text.lower() for text in words.table(language).values()}
            texts = [button.text() for button in panel.form.findChildren(QtGui.QPushButton) if len(button.text()) > 1]
            self.assertEqual([text for text in texts if text.lower() not in known], [])
            panel.reject()

    def assert_seen(self, boxes):
        """Every corner of the boxes is within the view."""
        view = FreeCADGui.activeDocument().activeView()
        width, height = view.getSize()
        for box in boxes:
            for number in range(8):
                x, y = view.getPointOnScreen(box.getPoint(number))
                self.assertTrue(0 <= x <= width and 0 <= y <= height, f"{x}, {y} of {width} x {height}")

    def test_a_part_without_undercut(self):
        import Part

        body = self.body(Part.makeBox(40, 30, 20))
        for command in ("Regions", "FindDirection", "Actions"):
            self.run_command(command, (body,)).accept()
        panel = self.run_command("Parting", (body,))
        picture("no_undercut")
        self.assertEqual([row[0] for row in panel_rows(panel.bodies)], ["Core half", "Cavity half"])
        halves = [self.document.getObject(name) for name in ("MoldCore", "MoldCavity")]
        self.assert_seen([half.Mesh.BoundBox for half in halves])
        self.assertNotIn("..", panel.verdict.text())
        self.document.recompute()
        settle()
        self.assertEqual([line for line in report_lines() if "void" in line], [])
        panel.accept()

    def test_columns_and_units(self):
        body = self.body()
        for command in ("Regions", "FindDirection", "Actions", "Parting"):
            panel = self.run_command(command, (body,))
            for table in panel.form.findChildren(QtGui.QTableWidget):
                for column in range(table.columnCount()):
                    self.assertGreaterEqual(table.columnWidth(column), table.sizeHintForColumn(column))
                self.assertEqual(table.horizontalScrollBar().maximum(), 0, command)
                cells = [cell for row in panel_rows(table) for cell in row]
                self.assertEqual([cell for cell in cells if "cm" in cell or "^" in cell or cell.endswith(" ml")], [])
            panel.accept()

    def test_messages(self):
        import Part

        self.assertIsNone(self.run_command("Regions"))
        self.assertIn("Nothing is selected", self.messages.pop())
        sheet = self.body(Part.makePlane(10, 10))
        for command in ("Regions", "FindDirection", "Actions", "Parting"):
            self.assertIsNone(self.run_command(command, (sheet,)))
            self.assertIn("has no solid", self.messages.pop())
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        self.assertIsNone(self.run_command("Regions", (group,)))
        self.assertIn("“Group” has no solid", self.messages.pop())
        self.document.removeObject("Group")
        with mock.patch.dict(sys.modules, {"moldlight": None}):
            self.assertIsNone(self.run_command("Regions", (sheet,)))
        self.assertIn("module moldlight is not there", self.messages.pop())
        self.run_command("Window", (sheet,))
        self.assertIn("no mold regions yet", self.messages.pop())
        self.assertEqual(self.messages, [])
        self.assertEqual(self.document.UndoNames, [])
        self.assertEqual([obj.Name for obj in self.document.Objects], [sheet.Name])

    def test_colours_follow_the_body(self):
        import Part

        body = self.body()
        self.run_command("Regions", (body,)).accept()
        body.Shape = Part.makeBox(20, 20, 20)
        self.document.recompute()
        settle()
        self.assert_coloured(self.document.MoldRegions)
        self.assertEqual(len(self.shown_colours(self.document.MoldRegions)), 6)
        self.assertEqual(self.document.MixedFaces.Mesh.CountFacets, 0)


def run():
    status = 1
    try:
        names = os.environ.get("MOLDLIGHT_TESTS", "").split()
        suite = unittest.defaultTestLoader.loadTestsFromTestCase(WindowTest)
        if names:
            suite = unittest.TestSuite(WindowTest(name) for name in names)
        outcome = unittest.TextTestRunner(stream=sys.__stderr__, verbosity=2).run(suite)
        status = 0 if outcome.wasSuccessful() and outcome.testsRun else 1
    except BaseException:
        traceback.print_exc(file=sys.__stderr__)
    finally:
        sys.__stderr__.flush()
        os._exit(status)  # it does not quit by itself


QtCore.QTimer.singleShot(START_MS, run)
QtCore.QTimer.singleShot(END_MS, lambda: os._exit(2))
