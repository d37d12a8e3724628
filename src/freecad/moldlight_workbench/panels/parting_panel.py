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
        self.line = results.parting_of(regions)
        self.verdict = self.text()
        self.rows = self.table([translate("Moldlight", "Line"), translate("Moldlight", "Length"),
                                translate("Moldlight", "Climb"), translate("Moldlight", "Steepest")], self._choose)
        self.opening = QtGui.QCheckBox(translate("Moldlight", "Open the mold"))
        self.opening.setChecked(self.line.Opening.Value > 0.0)
        self.opening.toggled.connect(self._open)
        self.layout.addWidget(self.opening)
        self.fill_undercut = QtGui.QCheckBox(translate("Moldlight", "Inserts for undercuts"))
        self.fill_undercut.setChecked(self.line.FillUndercut)
        self.fill_undercut.toggled.connect(self._set_fill)
        self.layout.addWidget(self.fill_undercut)
        self.bodies = self.table([translate("Moldlight", "Body"), translate("Moldlight", "Volume")])
        self.refusal = self.text()
        self.refresh()

    def _open(self, opened):
        diagonal = self.regions.Shape.BoundBox.DiagonalLength
        self.line.Opening = results.OPENING_SHARE * diagonal if opened else 0.0
        self.document.recompute()

    def _set_fill(self, filled):
        self.line.FillUndercut = filled
        self.ask(self.line)
        self.refresh()

    def _choose(self, row):
        # The wires stand one after another in the shape, and so do their edges.
        wires = self.line.Shape.Wires
        first = sum(len(wire.Edges) for wire in wires[:row]) + 1
        task.FreeCADGui.Selection.clearSelection()
        for number in range(first, first + len(wires[row].Edges)):
            task.FreeCADGui.Selection.addSelection(self.line, f"Edge{number}")

    def shown(self):
        """The results that it shows."""
        return (self.line,)

    def refresh(self):
        self.verdict.setText(self.line.Verdict)
        task.fill(self.rows, [(words.shown(kind), quantity(length, "length"), quantity(climb, "length"), quantity(steepest, "angle"))
                              for kind, length, climb, steepest in parting.loop_table(self.line)])
        halves = [obj for obj in self.line.InList if isinstance(getattr(obj, "Proxy", None), parting.MoldBody)]
        task.fill(self.bodies, [(half.Label, quantity(half.Volume.Value, "volume")) for half in halves],
                  [half.Colours[0] if half.Colours else (1, 1, 1) for half in halves])
        task.fit_rows(self.bodies)
        self.refusal.setText(self.line.Refusal)
        self.refusal.setVisible(bool(self.line.Refusal))
