"""The document objects of side actions: the bodies of slides, lifters and others, and arrows that say where they move."""

import FreeCAD
import Part

from . import meshes, properties, regions
from .analysis import Analysis, report
from .engine import translate

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

COLOURS = {
    "slide": (0.93, 0.55, 0.13),
    "inclined": (0.80, 0.40, 0.10),
    "lifter": (0.60, 0.35, 0.75),
    "unscrew": (0.85, 0.75, 0.20),
    "strip": (0.45, 0.70, 0.75),
    "insert": (0.55, 0.45, 0.40),
}
OTHER_COLOUR = (0.5, 0.5, 0.5)
# An arrow's sizes as shares of the part's diagonal; it is as long as the travel, but not shorter than the first.
ARROW_LENGTH, ARROW_RADIUS = 0.25, 0.008
# Of its length and its radius the tip has so much.
TIP_LENGTH, TIP_RADIUS = 0.3, 2.5


class SideActions(Analysis):
    """Of a Mesh::FeaturePython: the closed solids that the actions move, where the mold is closed."""

    call = "actions"
    keys = (
        "slide_angle_deg", "incline_deg", "lifter_angle_deg", "lifter_room_mm", "lifter_section_mm", "pin_diameter_mm",
        "clearance_mm", "bundle_across_mm", "bundle_along_mm",
    )
    title = QT_TRANSLATE_NOOP("Moldlight", "Undercuts and actions")

    def add_properties(self, obj):
        super().add_properties(obj)
        properties.add_result(obj, "App::PropertyString", "Verdict",
                              translate("Moldlight", "Verdict on the undercuts"))
        properties.add_result(obj, "App::PropertyArea", "Unreleased",
                              translate("Moldlight", "Undercut that no action releases"))
        properties.add_result(obj, "App::PropertyIntegerList", "Counts", "", hidden=True)
        properties.add_result(obj, "App::PropertyColorList", "Colours", "", hidden=True)

    def show(self, obj, part, answer, listener):
        bodies = answer.bodies(progress=listener)
        kinds = [action["kind"] for action in answer.actions]
        obj.Verdict = answer.verdict["sentence"]
        obj.Unreleased = answer.unreleased["area"]
        mesh, counts = meshes.joined([(body["vertices"], body["faces"]) for body in bodies])
        obj.Counts = counts
        obj.Colours = [COLOURS.get(kinds[body["action"]], OTHER_COLOUR) for body in bodies]
        obj.Mesh = mesh


class ActionArrows(properties.Proxy):
    """Of a Part::FeaturePython: a solid arrow an action that moves straight, from the undercut along its way."""

    def add_properties(self, obj):
        properties.add_link(obj, "Actions", translate("Moldlight", "The side actions"))
        properties.add_link(obj, "Regions", translate("Moldlight", "The mold regions that it belongs to"))
        properties.add_result(obj, "App::PropertyColorList", "Colours", "", hidden=True)

    def execute(self, obj):
        found = report(obj.Actions) if obj.Actions is not None else {}
        diagonal = regions.of_result(obj).Shape.BoundBox.DiagonalLength
        centres = {undercut["id"]: undercut["centre"] for undercut in found.get("undercuts", ())}
        arrows, colours = [], []
        for action in found.get("actions", ()):
            if action["direction"] is None or not action["undercuts"]:
                continue
            start = FreeCAD.Vector(*centres[action["undercuts"][0]])
            length = max(action["travel"] or 0.0, ARROW_LENGTH * diagonal)
            shape = arrow(start, FreeCAD.Vector(*action["direction"]), length, ARROW_RADIUS * diagonal)
            arrows.append(shape)
            colours += [COLOURS.get(action["kind"], OTHER_COLOUR)] * len(shape.Faces)
        obj.Colours = colours
        # The box around a compound of nothing is an error to FreeCAD.
        obj.Shape = Part.makeCompound(arrows) if arrows else Part.Shape()


def arrow(start, direction, length, radius):
    """A solid arrow; lengths in mm."""
    shaft = length * (1.0 - TIP_LENGTH)
    tip = Part.makeCone(TIP_RADIUS * radius, 0.0, length * TIP_LENGTH, start + direction * shaft, direction)
    return Part.makeCylinder(radius, shaft, start, direction).fuse(tip)


def action_table(obj):
    """A row an action, as the report has it: kind, direction or None, travel and stroke in mm or None, area in mm², its body
    with volume in mm³ and least section in mm², or None each, the undercuts that it releases."""
    return [
        (
            action["kind"],
            FreeCAD.Vector(*action["direction"]) if action["direction"] else None,
            action["travel"],
            action["stroke"],
            action["area"],
            action["body"],
            action["undercuts"],
        )
        for action in report(obj).get("actions", ())
    ]


def meetings(obj):
    """Pairs of actions whose ways cross, as rows of the table from 1."""
    found = report(obj).get("actions", ())
    return [(row, other) for row, action in enumerate(found, 1) for other in action["meets"] if other > row]


def hits(obj):
    """Rows of the table from 1 whose bodies are not clear, with "part" or the row that each reaches into, and how deep in
    mm."""
    found = [(row, action["clear"]) for row, action in enumerate(report(obj).get("actions", ()), 1)]
    return [(row, clear["hits"], clear["depth"]) for row, clear in found if isinstance(clear, dict)]
