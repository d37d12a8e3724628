"""The panel of the parting line and the mold's halves."""

from PySide import QtGui

from .. import parting, results, words
from ..engine import translate
from ..properties import quantity
from . import task


class PartingPanel(task.Panel):
    picture, title = "parting", task.QT_TRANSLATE_NOOP("Moldlight", "Parting line")

    def __init__(self, regions, begun=False):
        super().__init__(regions, begun)
        self.found = results.parting_of(regions)
        self.verdict = self.text()
        self.rows = self.table([translate("Moldlight", "Line"), translate("Moldlight", "Length"),
                                translate("Moldlight", "Climb"), translate("Moldlight", "Steepest")], self._choose)
        self.opening = QtGui.QCheckBox(translate("Moldlight", "Open the mold"))
        self.opening.setChecked(self.found.Opening.Value > 0.0)
        self.opening.toggled.connect(self._open)
        self.layout.addWidget(self.opening)
        self.fill_undercut = QtGui.QCheckBox(translate("Moldlight", "Inserts for undercuts"))
        self.fill_undercut.setChecked(self.found.FillUndercut)
        self.fill_undercut.toggled.connect(self._set_fill)
        self.layout.addWidget(self.fill_undercut)
        self.bodies = self.table([translate("Moldlight", "Body"), translate("Moldlight", "Volume")])
        self.refusal = self.text()
        self.refresh()

    def opened(self):
        task.fit_view()

    def _open(self, opened):
        diagonal = self.regions.Shape.BoundBox.DiagonalLength
        self.found.Opening = results.OPENING_SHARE * diagonal if opened else 0.0
        self.document.recompute()
        task.fit_view()

    def _set_fill(self, filled):
        self.found.FillUndercut = filled
        self.ask(self.found)
        self.refresh()

    def _choose(self, row):
        # The wires stand one after another in the shape, and so do their edges.
        wires = self.found.Shape.Wires
        first = sum(len(wire.Edges) for wire in wires[:row]) + 1
        task.FreeCADGui.Selection.clearSelection()
        for number in range(first, first + len(wires[row].Edges)):
            task.FreeCADGui.Selection.addSelection(self.found, f"Edge{number}")

    def refresh(self):
        self.verdict.setText(self.found.Verdict)
        task.fill(self.rows, [(words.shown(kind), quantity(length, "length"), quantity(climb, "length"), quantity(steepest, "angle"))
                              for kind, length, climb, steepest in parting.loop_table(self.found)])
        halves = [obj for obj in self.found.InList
                  if isinstance(getattr(obj, "Proxy", None), parting.MoldBody) and obj.Volume.Value]
        task.fill(self.bodies, [(half.Label, quantity(half.Volume.Value, "volume")) for half in halves],
                  [half.Colours[0] for half in halves])
        self.refusal.setText(self.found.Refusal)
        self.refusal.setVisible(bool(self.found.Refusal))
