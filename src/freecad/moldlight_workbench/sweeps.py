"""The document object of directions found: the best parting directions of a body."""

import FreeCAD

from . import properties
from .analysis import Analysis, report
from .engine import translate

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class FoundDirections(Analysis):
    """Of an App::FeaturePython. It does not depend on the direction of the regions."""

    call = "sweep"
    keys = ("directions", "top", "apart_deg")
    title = QT_TRANSLATE_NOOP("Moldlight", "Find direction")
    follows_direction = False

    def add_properties(self, obj):
        super().add_properties(obj)
        properties.add_result(obj, "App::PropertyVectorList", "Found",
                              translate("Moldlight", "The directions found, best first"))

    def show(self, obj, part, answer, listener):
        obj.Found = [FreeCAD.Vector(*candidate["direction"]) for candidate in answer.candidates]


def direction_table(obj):
    """A row a direction, best first: direction, undercut in mm² and its uncertainty, share of the surface, why it was
    tried."""
    rows = []
    for candidate in report(obj).get("candidates", ()):
        sources = candidate["sources"]
        rows.append(
            (
                FreeCAD.Vector(*candidate["direction"]),
                candidate["areas"]["undercut"],
                candidate["undercut_uncertainty"],
                candidate["fractions"]["undercut"],
                sources[0]["reason"] if sources else "",
            )
        )
    return rows


def remarks(obj):
    """Remarks on the directions, a sentence each."""
    found = report(obj)
    early = [translate("Moldlight", "The search ended early. These are the directions found by then.")]
    return (early if found and not found["complete"] else []) + found.get("remarks", [])
