"""Parting directions: of a face, an edge, an axis, a plane, or typed."""

import FreeCAD
import Part

from . import shapes
from .engine import Refusal, translate

AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def typed(text):
    """The unit vector of "z", "-y" or three numbers. Raises Refusal."""
    words = text.strip().lower().lstrip("+")
    sign = -1.0 if words[:1] == "-" and words[1:] in AXES else 1.0
    if words.lstrip("-") in AXES and words.count("-") <= 1:
        return FreeCAD.Vector(*AXES[words.lstrip("-")]) * sign
    try:
        numbers = [float(word) for word in words.replace(";", ",").replace(" ", ",").split(",") if word]
    except ValueError:
        numbers = []
    if len(numbers) != 3:
        raise Refusal(
            translate("Moldlight", "“{}” is not a direction: type three numbers, or an axis such as z or -y.").format(text)
        )
    return unit(FreeCAD.Vector(*numbers))


def unit(vector):
    """Of length one. Raises Refusal for a vector of no length."""
    if not 0.0 < vector.Length < float("inf"):
        raise Refusal(translate("Moldlight", "A parting direction of length 0 points nowhere; type another one."))
    # 0.0 takes the sign from zeros.
    return FreeCAD.Vector(*(component / vector.Length + 0.0 for component in vector))


def text_of(vector, digits=6):
    """As typed() reads it, with so many digits after the point."""
    for name, axis in AXES.items():
        for sign, prefix in ((1.0, ""), (-1.0, "-")):
            if (vector - FreeCAD.Vector(*axis) * sign).Length < 1e-12:
                return prefix + name
    # 0.0 takes the sign from what is rounded to zero.
    return ", ".join(f"{round(value, digits) + 0.0:.{digits}f}" for value in vector)


def of_element(source, element=""):
    """The unit vector of an element of an object, in the document's coordinates: the normal of a plane, the axis
    of what is round, the way of a straight edge. Raises Refusal for what has none."""
    if source.isDerivedFrom("App::OriginFeature"):
        local = (0, 0, 1) if source.TypeId == "App::Plane" else (1, 0, 0)
        return unit(_global_placement(source).Rotation.multVec(FreeCAD.Vector(*local)))
    shape = Part.Shape()
    if hasattr(source, "Shape") or element:
        shape = shapes.located_shape(source, element, element_needed=bool(element))
    direction = _of_shape(shape)
    if direction is None and not element and hasattr(source, "Placement") and not shape.Faces:
        # A coordinate system or a sketch: its z.
        direction = _global_placement(source).Rotation.multVec(FreeCAD.Vector(0, 0, 1))
    if direction is None:
        raise Refusal(
            translate(
                "Moldlight", "{} of “{}” gives no direction: choose a face, a straight or round edge, or an axis."
            ).format(element or translate("Moldlight", "The shape"), source.Label)
        )
    return unit(direction)


def _global_placement(source):
    group = source.getParentGeoFeatureGroup()
    outer = group.getGlobalPlacement() if group is not None else FreeCAD.Placement()
    return outer.multiply(source.Placement)


def _of_shape(shape):
    if shape.isNull() or shape.ShapeType not in ("Face", "Edge"):
        return None
    if shape.ShapeType == "Edge":
        curve = shape.Curve
        if isinstance(curve, Part.Line):
            return shape.tangentAt(shape.FirstParameter)
        return getattr(curve, "Axis", None)
    if not isinstance(shape.Surface, Part.Plane) and hasattr(shape.Surface, "Axis"):
        return shape.Surface.Axis
    u0, u1, v0, v1 = shape.ParameterRange
    return shape.normalAt((u0 + u1) / 2, (v0 + v1) / 2)
