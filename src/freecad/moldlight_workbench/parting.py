"""The document objects of the mold: the parting line as wires, the halves and inserts as meshes."""

import FreeCAD
import Part

from . import meshes, progress, properties, regions
from .analysis import Analysis, report
from .engine import Refusal, translate

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# The bodies that halves are made of, by the first word of their names, and where each opens to along the direction.
BODIES = {"core": 1.0, "cavity": -1.0, "insert": 0.0}
INSERT_COLOUR = (0.85, 0.35, 0.30)
# Points of a line nearer than this, in mm, are one.
SAME_POINT = 1e-6


class PartingLine(Analysis):
    """Of a Part::FeaturePython: a closed Part.Wire a loop."""

    call = "mold"
    keys = ("soft_deg", "parting_height", "margin", "shrink_pct", "slope_deg", "fill_undercut", "registration")
    title = QT_TRANSLATE_NOOP("Moldlight", "Parting line")

    def add_properties(self, obj):
        first = not hasattr(obj, "FillUndercut")
        super().add_properties(obj)
        if first:
            # Halves are shown in any case; what they cannot form is an insert beside them.
            obj.FillUndercut = True
        properties.add(obj, "App::PropertyDistance", "Opening", "Mold",
                       translate("Moldlight", "Distance by which each half is moved out"))
        properties.add_result(obj, "App::PropertyString", "Verdict", translate("Moldlight", "Verdict on the mold, and a sentence on its parting line"))
        properties.add_result(obj, "App::PropertyString", "Refusal", translate("Moldlight", "Why there are no halves"))
        properties.add_result(obj, "App::PropertyStringList", "Kinds", translate("Moldlight", "Kind of each wire"))

    def show(self, obj, part, answer, listener):
        loops = answer.loops
        line = answer.parting_line.rstrip(".")
        obj.Verdict = "{} {}{}.".format(answer.verdict["sentence"], line[:1].upper(), line[1:])
        obj.Refusal = answer.refusal
        obj.Kinds = [loop["kind"] for loop in loops]
        obj.Shape = Part.makeCompound([wire_of(loop["points"].tolist()) for loop in loops])


class MoldBody(meshes.ColouredMesh):
    """A half, or all inserts, where the mold is closed, moved out by the line's Opening."""

    def add_properties(self, obj):
        super().add_properties(obj)
        properties.add_link(obj, "Line", translate("Moldlight", "The parting line"))
        properties.add(obj, "App::PropertyString", "Body", "Mold", translate("Moldlight", "core, cavity or insert"))
        obj.setEditorMode("Body", 1)
        properties.add_result(obj, "App::PropertyVolume", "Volume", translate("Moldlight", "Volume of the body"))

    def execute(self, obj):
        asked = regions.of_result(obj)
        if obj.Line is None:
            raise Refusal(translate("Moldlight", "The parting line of “{}” is no longer there; delete it.").format(obj.Label))
        with progress.shown(translate("Moldlight", PartingLine.title)) as listener:
            _, mold = obj.Line.Proxy.found(obj.Line, listener)
        # What is refused is not there: bodies without a certificate are no mold.
        bodies = [] if mold.refusal else [body for body in mold.bodies if body["name"].split("_")[0] == obj.Body]
        mesh, _ = meshes.joined([(body["vertices"], body["faces"]) for body in bodies])
        obj.Counts = [mesh.CountFacets]
        obj.Colours = [colour_of(obj)]
        obj.Volume = sum(body["volume"] for body in bodies)
        mesh.transform(FreeCAD.Matrix(*mold.frame.ravel().tolist()))
        out = regions.direction(asked) * (BODIES[obj.Body] * obj.Line.Opening.Value)
        obj.Mesh = mesh
        obj.Placement = FreeCAD.Placement(out, FreeCAD.Rotation())


def colour_of(obj):
    """That of the region that the half forms."""
    places = {"core": 0, "cavity": 1}
    return obj.Regions.Colours[places[obj.Body]] if obj.Body in places else INSERT_COLOUR


def wire_of(points):
    """A closed wire through points of which the first is not repeated."""
    apart = []
    for point in (FreeCAD.Vector(*numbers) for numbers in points):
        if not apart or (point - apart[-1]).Length > SAME_POINT:
            apart.append(point)
    while len(apart) > 1 and (apart[-1] - apart[0]).Length <= SAME_POINT:
        apart.pop()
    return Part.makePolygon([*apart, apart[0]])


def loop_table(obj):
    """A row a loop: kind, length, climb in mm, steepest run in degrees."""
    return [
        (loop["kind"], loop["length"], loop["climb"], loop["steepest_deg"]) for loop in report(obj).get("loops", ())
    ]
