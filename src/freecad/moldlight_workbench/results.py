"""Results in the document: each body's in a group of its own, made once and found again."""

import FreeCAD

from . import actions, meshes, parting, regions, shapes, sweeps
from .engine import engine, translate

# Lengths of the part's diagonal by which the halves are moved out at first.
OPENING_SHARE = 0.6


def _new(group, kind, name, label, proxy):
    obj = group.Document.addObject(kind, name)
    obj.Label = label
    proxy(obj)
    if FreeCAD.GuiUp:
        from . import views

        views.attach(obj)
    group.addObject(obj)
    return obj


def group_of(regions_object):
    """The group that the results of a body are in."""
    groups = [parent for parent in regions_object.InList if parent.isDerivedFrom("App::DocumentObjectGroup")]
    return groups[0]


def existing(source):
    """The mold regions of a body that are there already, or None."""
    found = [obj for obj in source.Document.Objects if regions.is_regions(obj) and obj.Source is source]
    return found[0] if found else None


def make_regions(source, direction=None):
    """Mold regions of a body in a new group, with what shows its mixed faces; not yet computed. Raises Refusal for
    an object without solid, and if the module is not there."""
    engine()
    shapes.solid_shape(source)
    document = source.Document
    group = document.addObject("App::DocumentObjectGroup", "Mold")
    group.Label = translate("Moldlight", "Mold of {}").format(source.Label)
    made = _new(group, "Part::FeaturePython", "MoldRegions", translate("Moldlight", "Mold regions"), regions.MoldRegions)
    made.Source = source
    if direction is not None:
        made.Direction = direction
    mixed = _new(group, "Mesh::FeaturePython", "MixedFaces", translate("Moldlight", "Mixed faces"), meshes.MixedFaces)
    mixed.Regions = made
    source.Visibility = False
    return made


def _found_or_new(regions_object, kind, name, label, proxy):
    """(the result of a proxy's class of a body, whether it was made just now)."""
    for obj in regions_object.InList:
        if isinstance(getattr(obj, "Proxy", None), proxy):
            return obj, False
    made = _new(group_of(regions_object), kind, name, label, proxy)
    made.Regions = regions_object
    return made, True


def directions_of(regions_object):
    """The found directions of a body, made if they are not there; not yet computed."""
    return _found_or_new(regions_object, "App::FeaturePython", "FoundDirections", translate("Moldlight", "Directions"),
                         sweeps.FoundDirections)[0]


def actions_of(regions_object):
    """The side actions of a body with their arrows, made if they are not there; not yet computed."""
    found, made = _found_or_new(regions_object, "Mesh::FeaturePython", "SideActions",
                                translate("Moldlight", "Side actions"), actions.SideActions)
    if made:
        arrows = _new(group_of(regions_object), "Part::FeaturePython", "ActionArrows",
                      translate("Moldlight", "Ways of the side actions"), actions.ActionArrows)
        arrows.Actions = found
        arrows.Regions = regions_object
    return found


def parting_of(regions_object):
    """The parting line of a body with its halves and inserts, made if they are not there; not yet computed."""
    found, made = _found_or_new(regions_object, "Part::FeaturePython", "PartingLine",
                                translate("Moldlight", "Parting line"), parting.PartingLine)
    if made:
        found.Opening = OPENING_SHARE * regions_object.Shape.BoundBox.DiagonalLength
        labels = {
            "core": translate("Moldlight", "Core half"),
            "cavity": translate("Moldlight", "Cavity half"),
            "insert": translate("Moldlight", "Inserts"),
        }
        for body, label in labels.items():
            half = _new(group_of(regions_object), "Mesh::FeaturePython", "Mold" + body.capitalize(), label,
                        parting.MoldBody)
            half.Body = body
            half.Regions = regions_object
            half.Line = found
    return found
