"""The document object of mold regions: a copy of the body, its faces known by region and coloured by it."""

import FreeCAD
import numpy

from . import directions, progress, properties, shapes, words
from .engine import Refusal, engine, isolated, translate

# A face is mixed if more than this share of it belongs to other regions than the one that has most of it.
MIXED_SHARE = 1e-3
# What FaceRegions says of a mixed face, after the places in moldlight.REGIONS.
MIXED = 4

CLASSIFY_KEYS = ("tau_deg", "tolerance")
# Regions in the order of moldlight.REGIONS, as properties and headings call them.
REGION_PROPERTIES = ("CoreArea", "CavityArea", "BothArea", "UndercutArea")


class FacetedPart:
    """A body as moldlight sees it, kept while neither body nor meshing changes."""

    def __init__(self, shape, meshing, listener):
        self.shape = shape
        self.meshing = meshing
        self.facets = shapes.faceted(shape, *meshing)
        self.part = engine().Part(self.facets.vertices, self.facets.faces, unit="mm", progress=listener)

    def is_of(self, shape, meshing):
        return self.meshing == meshing and shapes.same_solids(self.shape, shape)

    def per_face(self, areas):
        """Sums over the facets of each face; `areas` is m x k."""
        sums = numpy.zeros((len(self.shape.Faces), areas.shape[1]))
        numpy.add.at(sums, self.facets.face_of_facet, areas)
        return sums

    def least_draft_deg(self, direction):
        """Of each face the least angle of its surface to the direction, at the corners of its facets; 90 of none."""
        return [
            float(numpy.degrees(numpy.arcsin(numpy.clip(numpy.abs(normals @ numpy.asarray(direction)).min(initial=1.0), 0, 1))))
            for normals in self.facets.normals
        ]


class MoldRegions(properties.Proxy):
    """Of a Part::FeaturePython. It stands where the body stands, in the document's coordinates."""

    _part = None
    _found = None  # (part, direction, settings, classification)

    def add_properties(self, obj):
        add, result = properties.add, properties.add_result
        tip = translate
        add(obj, "App::PropertyLinkGlobal", "Source", "Mold", tip("Moldlight", "The body that is molded"))
        add(obj, "App::PropertyLinkListGlobal", "Containers", "Mold", "")
        obj.setEditorMode("Containers", 2)
        add(obj, "App::PropertyVector", "Direction", "Mold",
            tip("Moldlight", "Parting direction, along which the core moves; follows Reference if that is set"),
            FreeCAD.Vector(0, 0, 1))
        add(obj, "App::PropertyLinkSubGlobal", "Reference", "Mold",
            tip("Moldlight", "Face, edge or axis that the parting direction follows"))
        add(obj, "App::PropertyBool", "Reversed", "Mold", tip("Moldlight", "Opposite to Reference"))
        properties.add_settings(obj, "classify", CLASSIFY_KEYS)
        properties.add_settings(obj, "read", ("linear_deflection", "angular_deflection_deg"))
        for name, region in zip(REGION_PROPERTIES, engine().REGIONS):
            result(obj, "App::PropertyArea", name, tip("Moldlight", "Area of the region: {}").format(words.shown(region)))
        result(obj, "App::PropertyArea", "TotalArea", tip("Moldlight", "Area of the whole surface"))
        result(obj, "App::PropertyArea", "Uncertainty", tip("Moldlight", "Uncertainty of the undercut area"))
        result(obj, "App::PropertyString", "Verdict", tip("Moldlight", "Verdict on the direction"))
        result(obj, "App::PropertyStringList", "Warnings", tip("Moldlight", "Warnings: why figures are in doubt"))
        hidden = (("App::PropertyIntegerList", "FaceRegions"), ("App::PropertyFloatList", "FaceAreas"),
                  ("App::PropertyFloatList", "FaceDrafts"), ("App::PropertyColorList", "Colours"))
        for kind, name in hidden:
            result(obj, kind, name, "", hidden=True)

    def onChanged(self, obj, name):
        if name == "Source" and hasattr(obj, "Containers") and obj.Source is not None:
            obj.Containers = shapes.containers(obj.Source)

    def faceted_part(self, obj, listener=None):
        """The body's facets as a part. Raises Refusal, or what the module raises."""
        shape = shapes.solid_shape(obj.Source)
        meshing = (obj.LinearDeflection.Value, obj.AngularDeflection.Value)
        if self._part is None or not self._part.is_of(shape, meshing):
            self._part = FacetedPart(shape, meshing, listener)
        return self._part

    def classification(self, obj, listener=None):
        """(part, classification) of the object's direction and settings, computed anew if these have changed."""
        part = self.faceted_part(obj, listener)
        asked = tuple(direction(obj)), properties.settings(obj, "classify", CLASSIFY_KEYS)
        if self._found is None or self._found[0] is not part or self._found[1:3] != asked:
            found = part.part.classify(asked[0], split=True, isolated=isolated(), progress=listener, **asked[1])
            self._found = (part, *asked, found)
        return part, self._found[3]

    prepare = classification

    def execute(self, obj):
        with progress.shown(translate("Moldlight", "Mold regions")) as listener:
            part, found = self.classification(obj, listener)
        obj.Direction = direction(obj)
        # While it recomputes, FreeCAD moves a shape that it is given to the object's place.
        obj.Placement = part.shape.Placement
        obj.Shape = part.shape
        for name, region in zip(REGION_PROPERTIES, engine().REGIONS):
            setattr(obj, name, found.areas[region])
        obj.TotalArea = found.total_area
        obj.Uncertainty = found.undercut_uncertainty
        obj.Verdict = found.verdict["sentence"]
        obj.Warnings = list(dict.fromkeys([*part.part.warnings, *found.warnings]))
        areas = part.per_face(found.facet_areas)
        obj.Colours = [tuple(value / 255 for value in colour) for colour in palette()]
        obj.FaceAreas = areas.ravel().tolist()
        obj.FaceDrafts = part.least_draft_deg(tuple(obj.Direction))
        obj.FaceRegions = region_of_faces(areas).tolist()


def palette():
    """Red, green, blue of each region, 0 to 255; the user parameter Palette is a word of moldlight's, "safe" for
    colour-blind eyes."""
    palettes = engine().REGION_COLOURS
    chosen = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Moldlight").GetString("Palette", "paper")
    return palettes.get(chosen, palettes["paper"])


def direction(obj):
    """The unit vector that an object of mold regions asks about. Raises Refusal."""
    if obj.Reference is None:
        return directions.unit(obj.Direction)
    source, elements = obj.Reference
    found = directions.of_element(source, elements[0] if elements else "")
    return found * (-1.0 if obj.Reversed else 1.0)


def region_of_faces(areas):
    """Of each row of f x 4 areas the place of its region, or MIXED."""
    most = areas.argmax(axis=1)
    rest = areas.sum(axis=1) - areas.max(axis=1)
    return numpy.where(rest > MIXED_SHARE * areas.sum(axis=1), MIXED, most)


def face_table(obj):
    """A row a face: its number from 1, as FreeCAD names it, its region, the four areas in mm², its least draft in
    degrees. The region of a mixed face is "mixed"."""
    names = (*engine().REGIONS, "mixed")
    areas = numpy.reshape(obj.FaceAreas, (-1, len(REGION_PROPERTIES)))
    rows = zip(obj.FaceRegions, areas.tolist(), obj.FaceDrafts)
    return [(number, names[region], area, draft) for number, (region, area, draft) in enumerate(rows, 1)]


def is_regions(obj):
    return isinstance(getattr(obj, "Proxy", None), MoldRegions)


def regions_of(obj):
    """The mold regions that a result belongs to, itself if it is them; None of anything else."""
    if is_regions(obj):
        return obj
    linked = getattr(obj, "Regions", None)
    return linked if is_regions(linked) else None


def of_result(obj):
    """The mold regions that a result belongs to. Raises Refusal if they are gone."""
    found = regions_of(obj)
    if found is None:
        raise Refusal(
            translate("Moldlight", "The mold regions that “{}” belongs to are no longer there; delete it.").format(obj.Label)
        )
    return found


def set_reference(obj, source, element=""):
    """Makes the direction follow an element. Of the regions themselves it is the body's element of that name."""
    if source is obj:
        body = shapes.located_shape(obj.Source)
        if len(body.Faces) != len(obj.Shape.Faces):
            raise Refusal(translate("Moldlight", "Choose the face or edge on the body itself, not on its regions."))
        source = obj.Source
    if regions_of(source) is not None:
        raise Refusal(translate("Moldlight", "A result gives no direction; choose a face, an edge or an axis of the part."))
    directions.of_element(source, element)
    obj.Reference = (source, [element] if element else [])
