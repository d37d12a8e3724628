"""The panel of mold regions: direction, required draft, areas, and the faces with region, areas and draft."""

from PySide import QtGui

from .. import directions, regions, selection, window, words
from ..engine import translate
from ..properties import percent, quantity
from ..views import MIXED_COLOUR
from . import task


class RegionsPanel(task.Panel):
    picture, title = "regions", task.QT_TRANSLATE_NOOP("Moldlight", "Mold regions")

    def __init__(self, obj, begun=False):
        super().__init__(obj, begun)
        self.text(translate("Moldlight", "Body: {}").format(obj.Source.Label if obj.Source else "–"))
        self._add_direction()
        self._add_draft()
        self.areas = self.table([translate("Moldlight", "Region"), translate("Moldlight", "Area"),
                                 translate("Moldlight", "Share")])
        self.doubt = self.text()
        area = translate("Moldlight", "Area")
        self.faces = self.table(
            [translate("Moldlight", "Face"), translate("Moldlight", "Region"), translate("Moldlight", "Draft"), area,
             *(words.shown(name).capitalize() for name in regions.engine().REGIONS)],
            self._choose_face)
        self.button(translate("Moldlight", "Open in moldlight"),
                    translate("Moldlight", "Open the part with this direction and these settings in moldlight's own window"),
                    self.open_window)
        self.refresh()

    def _add_direction(self):
        line = QtGui.QHBoxLayout()
        self.typed = QtGui.QLineEdit()
        self.typed.setToolTip(translate("Moldlight", "Parting direction: three numbers, or an axis such as z or -y"))
        self.typed.returnPressed.connect(lambda: self.apply(self._take_typed))
        line.addWidget(QtGui.QLabel(translate("Moldlight", "Direction")))
        line.addWidget(self.typed)
        self.layout.addLayout(line)
        self.follows = self.text()
        buttons = QtGui.QHBoxLayout()
        for axis in directions.AXES:
            button = self.button(axis.upper(), translate("Moldlight", "Along this axis of the document"),
                                 lambda axis=axis: self.apply(lambda: self._take(directions.typed(axis))), buttons)
            button.setMaximumWidth(40)
        self.button(translate("Moldlight", "Flip"), translate("Moldlight", "Reverse the direction: core and cavity change places"),
                    lambda: self.apply(self._flip), buttons)
        self.button(translate("Moldlight", "From selection"),
                    translate("Moldlight", "The normal of the selected face, or along the selected edge or axis"),
                    lambda: self.apply(self._take_selection), buttons)
        self.layout.addLayout(buttons)

    def _add_draft(self):
        line = QtGui.QHBoxLayout()
        self.draft = QtGui.QDoubleSpinBox()
        asked = next(entry for entry in regions.engine().settings("classify") if entry["key"] == "tau_deg")
        self.draft.setRange(asked["least"], asked["greatest"])
        self.draft.setSingleStep(0.25)
        self.draft.setSuffix(" °")
        self.draft.setToolTip(self.regions.getDocumentationOfProperty("Tau"))
        self.draft.editingFinished.connect(self._draft_edited)
        line.addWidget(QtGui.QLabel(translate("Moldlight", "Near-vertical below")))
        line.addWidget(self.draft)
        self.layout.addLayout(line)

    def _draft_edited(self):
        value = self.draft.value()
        if value != self.regions.Tau.Value:
            self.apply(lambda: setattr(self.regions, "Tau", value))

    def _take(self, vector):
        self.regions.Reference = None
        self.regions.Direction = vector

    def _take_typed(self):
        self._take(directions.typed(self.typed.text()))

    def _take_selection(self):
        regions.set_reference(self.regions, *selection.chosen_element())

    def _flip(self):
        if self.regions.Reference is None:
            self.regions.Direction = self.regions.Direction * -1.0
        else:
            self.regions.Reversed = not self.regions.Reversed

    def apply(self, change):
        """Makes a change and shows what follows; a change that is refused is taken back."""
        kept = {name: getattr(self.regions, name) for name in ("Reference", "Direction", "Reversed", "Tau")}
        with task.failures_said() as failures:
            change()
        if failures or not self.ask(self.regions):
            for name, value in kept.items():
                setattr(self.regions, name, value)
            self.document.recompute()
        self.refresh()

    def refresh(self):
        obj = self.regions
        self.typed.setText(directions.text_of(obj.Direction))
        self.draft.setValue(obj.Tau.Value)
        if obj.Reference is not None:
            source, elements = obj.Reference
            where = " ".join((source.Label, *elements))
            self.follows.setText(translate("Moldlight", "follows {}").format(where))
        self.follows.setVisible(obj.Reference is not None)
        total = obj.TotalArea.Value or 1.0
        areas = [getattr(obj, name).Value for name in regions.REGION_PROPERTIES]
        rows = [(words.shown(name).capitalize(), quantity(area, "area"), percent(area / total))
                for name, area in zip(regions.engine().REGIONS, areas)]
        task.fill(self.areas, rows, obj.Colours)
        doubt = 100.0 * obj.Uncertainty.Value / total
        # Less is not seen in any figure of the panel.
        error = [translate("Moldlight", "Undercut ± {:.1g} % of the surface.").format(doubt)] if doubt >= 0.005 else []
        self.doubt.setText("\n".join([obj.Verdict, *error, *obj.Warnings]))
        self._fill_faces()

    def _fill_faces(self):
        table = regions.face_table(self.regions)
        rows = [(f"Face{number}", words.shown(region), quantity(draft, "angle"), quantity(sum(areas), "area"),
                 *(quantity(area, "area") if area else "–" for area in areas)) for number, region, areas, draft in table]
        colours = [*self.regions.Colours, MIXED_COLOUR]
        task.fill(self.faces, rows, [colours[region] for region in self.regions.FaceRegions])

    def _choose_face(self, row):
        task.select(self.regions, f"Face{row + 1}")

    def open_window(self):
        with task.failures_said():
            window.open_window(self.regions)
