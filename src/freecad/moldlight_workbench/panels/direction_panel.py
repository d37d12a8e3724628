"""The panel of directions found: a list to choose from; what is chosen becomes the parting direction at once."""

from PySide import QtGui

from .. import directions, results, sweeps
from ..engine import translate
from ..properties import percent, quantity
from . import task


class DirectionPanel(task.Panel):
    picture, title = "direction", task.QT_TRANSLATE_NOOP("Moldlight", "Find direction")

    def __init__(self, regions, begun=False):
        super().__init__(regions, begun)
        self.found = results.directions_of(regions)
        line = QtGui.QHBoxLayout()
        line.addWidget(QtGui.QLabel(translate("Moldlight", "Directions listed")))
        self.top = QtGui.QSpinBox()
        self.top.setRange(1, 1000)
        self.top.setValue(self.found.Top)
        line.addWidget(self.top)
        self.button(translate("Moldlight", "Find"),
                    translate("Moldlight", "Find the directions with the least undercut"), self.search, line)
        self.layout.addLayout(line)
        self.rows = self.table([translate("Moldlight", "Direction"), translate("Moldlight", "Undercut"), "%",
                                translate("Moldlight", "Tried as")], self.choose)
        self.remarks = self.text()
        self.current = self.text()
        self.refresh()

    def search(self):
        """Sweeps, and shows what was found."""
        self.found.Top = self.top.value()
        self.ask(self.found)
        self.refresh()

    def choose(self, row):
        """Makes the direction of a row that of the regions."""
        self.regions.Reference = None
        self.regions.Direction = sweeps.direction_table(self.found)[row][0]
        self.ask(self.regions)
        self.refresh_current()

    def refresh(self):
        table = sweeps.direction_table(self.found)
        rows = [(directions.text_of(direction, 3), quantity(undercut, "area"), percent(share), why)
                for direction, undercut, _, share, why in table]
        task.fill(self.rows, rows)
        self.remarks.setText("\n".join(sweeps.remarks(self.found)))
        self.refresh_current()

    def refresh_current(self):
        self.current.setText(translate("Moldlight", "Parting direction: {}; undercut {}").format(
            directions.text_of(self.regions.Direction), quantity(self.regions.UndercutArea.Value, "area")))
