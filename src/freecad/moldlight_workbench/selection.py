"""What is selected: the body to work on, and what gives a direction."""

import FreeCADGui

from . import regions, results, shapes
from .engine import Refusal, translate


def chosen():
    """(object, its selected element or "") of everything that is selected, in order."""
    pairs = []
    for entry in FreeCADGui.Selection.getSelectionEx():
        pairs += [(entry.Object, element) for element in entry.SubElementNames or ("",)]
    return pairs


def chosen_element():
    """The object and element that is to give a direction. Raises Refusal if nothing is selected."""
    pairs = chosen()
    if not pairs:
        raise Refusal(translate("Moldlight", "Nothing is selected: choose a face, an edge or an axis first."))
    return next((pair for pair in pairs if pair[1]), pairs[0])


def _has_shape(source):
    try:
        return not shapes.located_shape(source).isNull()
    except Exception:  # FreeCAD raises whatever its C++ finds of an object without shape
        return False


def chosen_body():
    """(mold regions that are there already or None, the body, (object, element) that gives a direction or None).
    Raises Refusal."""
    pairs = chosen()
    for source, _ in pairs:
        known = regions.regions_of(source)
        if known is not None:
            return known, known.Source, None
    solids = [source for source, element in pairs if not element or element.startswith("Face")]
    bodies = [source for source in (*solids, *(source for source, _ in pairs)) if _has_shape(source)]
    if not pairs:
        raise Refusal(translate("Moldlight", "Nothing is selected: choose the body to be molded first."))
    if not bodies:
        return None, pairs[0][0], None
    body = next((source for source in bodies if shapes.located_shape(source).Solids), bodies[0])
    reference = next((pair for pair in pairs if pair[1] or pair[0] is not body), None)
    # A click on a body of PartDesign selects the feature that made the face.
    group = body.getParentGeoFeatureGroup()
    if group is not None and group.isDerivedFrom("PartDesign::Body"):
        body = group
    return results.existing(body), body, reference
