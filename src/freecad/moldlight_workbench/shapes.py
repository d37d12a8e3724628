"""A FreeCAD shape as facets of which each knows its CAD face, where the body stands in the document."""

import collections
import math

import MeshPart
import numpy
import Part

from .engine import Refusal, translate

# Share of the part's diagonal that facets may be from its surface unless a length is given, and the angle
# between neighbouring chords: what moldlight does to a STEP file, so that both see the same facets.
DEFLECTION_SHARE = 0.0005
ANGLE_DEG = 5.0


# vertices: n x 3 in mm; faces: m x 3; face_of_facet: m numbers of the shape's Faces, from 0; normals: of each face k x 3,
# the surface's own at the corners of its facets, one of a plane.
FacetedShape = collections.namedtuple("FacetedShape", ("vertices", "faces", "face_of_facet", "normals"))


def located_shape(source, element="", element_needed=False):
    """The shape of an object, or of an element such as "Face3", in the document's coordinates."""
    shape = Part.getShape(source, element, needSubElement=element_needed)
    group = source.getParentGeoFeatureGroup()
    if group is not None and not shape.isNull():
        shape.Placement = group.getGlobalPlacement().multiply(shape.Placement)
    return shape


def containers(source):
    """What the place of an object depends on, from inside outwards."""
    found = []
    group = source.getParentGeoFeatureGroup()
    while group is not None and group not in found:
        found.append(group)
        group = group.getParentGeoFeatureGroup()
    return found


def solid_shape(source):
    """The solids of an object in the document's coordinates. Raises Refusal if it has none."""
    if source is None:
        raise Refusal(translate("Moldlight", "The body is no longer there; choose another one."))
    shape = located_shape(source)
    if shape.isNull() or not shape.Solids:
        raise Refusal(
            translate(
                "Moldlight", "“{}” has no solid. Choose a body that encloses a volume."
            ).format(source.Label)
        )
    # Faces keep the numbers that they have in the body wherever all of them belong to solids.
    if len(shape.Faces) == sum(len(solid.Faces) for solid in shape.Solids):
        return shape
    return Part.makeCompound(shape.Solids)


def same_solids(first, second):
    """Whether two shapes are the same solids at the same places."""
    a, b = first.Solids, second.Solids
    # Places that are equal are not the same to OpenCASCADE where each was made for itself.
    return len(a) == len(b) and all(
        one.isPartner(other) and one.Orientation == other.Orientation and one.Matrix == other.Matrix
        for one, other in zip(a, b)
    )


def default_deflection(shape):
    """In mm."""
    return DEFLECTION_SHARE * shape.BoundBox.DiagonalLength


def faceted(shape, deflection=0.0, angle_deg=ANGLE_DEG):
    """Facets of a shape; a deflection of 0 is default_deflection()."""
    deflection = deflection or default_deflection(shape)
    # A copy, so that the facets that the view shows of the body stay as they are.
    work = shape.copy()
    MeshPart.meshFromShape(
        Shape=work, LinearDeflection=deflection, AngularDeflection=math.radians(angle_deg), Relative=False
    )
    vertices, faces, numbers, count = [], [], [], 0
    for number, face in enumerate(work.Faces):
        # What is there already is handed out, in double precision.
        points, facets = face.tessellate(deflection)
        vertices.extend((point.x, point.y, point.z) for point in points)
        faces.append(numpy.asarray(facets, dtype=numpy.int64).reshape(-1, 3) + count)
        numbers.append(numpy.full(len(facets), number))
        count += len(points)
    return FacetedShape(
        numpy.asarray(vertices, dtype=float).reshape(-1, 3),
        numpy.concatenate(faces),
        numpy.concatenate(numbers),
        [_normals(face) for face in work.Faces],
    )


def _normals(face):
    if isinstance(face.Surface, Part.Plane):
        u0, _, v0, _ = face.ParameterRange
        return numpy.asarray([face.normalAt(u0, v0)])
    found = []
    for u, v in face.getUVNodes():
        try:
            found.append(tuple(face.normalAt(u, v)))
        except Part.OCCError:
            pass  # a tip, which has none
    return numpy.asarray(found).reshape(-1, 3)
