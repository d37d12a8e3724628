"""Meshes as document objects: facets in groups, each group in a colour of its own."""

import FreeCAD
import Mesh
import numpy

from . import progress, properties, regions
from .engine import engine, translate


def mesh_of(vertices, faces):
    """A FreeCAD mesh of n x 3 points and m x 3 places in them; vertices that no facet uses are left out."""
    faces = numpy.asarray(faces, dtype=numpy.int64)
    if not len(faces):
        return Mesh.Mesh()
    used, places = numpy.unique(faces, return_inverse=True)
    corners = [FreeCAD.Vector(*corner) for corner in numpy.asarray(vertices)[used].tolist()]
    mesh = Mesh.Mesh()
    mesh.addFacets((corners, [tuple(facet) for facet in places.reshape(-1, 3).tolist()]))
    return mesh


def joined(meshes):
    """One mesh of several (vertices, faces), and the number of facets of each."""
    points, facets, counts, base = [numpy.zeros((0, 3))], [numpy.zeros((0, 3), dtype=numpy.int64)], [], 0
    for vertices, faces in meshes:
        points.append(numpy.asarray(vertices))
        facets.append(numpy.asarray(faces, dtype=numpy.int64) + base)
        counts.append(len(faces))
        base += len(vertices)
    return mesh_of(numpy.concatenate(points), numpy.concatenate(facets)), counts


class ColouredMesh(properties.Proxy):
    """Of a Mesh::FeaturePython: what of a result is a mesh. Facets are in groups of Counts, coloured by Colours."""

    def add_properties(self, obj):
        properties.add_link(obj, "Regions", translate("Moldlight", "The mold regions that it belongs to"))
        properties.add_result(obj, "App::PropertyIntegerList", "Counts", "", hidden=True)
        properties.add_result(obj, "App::PropertyColorList", "Colours", "", hidden=True)


class MixedFaces(ColouredMesh):
    """The split mesh of the faces that belong to several regions."""

    def execute(self, obj):
        with progress.shown(translate("Moldlight", "Mixed faces")) as listener:
            asked = regions.of_result(obj)
            part, found = asked.Proxy.classification(asked, listener)
            split = found.split_mesh(progress=listener)
        mixed = numpy.asarray(asked.FaceRegions) == regions.MIXED
        shown = mixed[part.facets.face_of_facet][split.facets]
        order = numpy.argsort(split.regions[shown], kind="stable")
        obj.Counts = numpy.bincount(split.regions[shown], minlength=len(engine().REGIONS)).tolist()
        obj.Colours = asked.Colours
        obj.Mesh = mesh_of(split.vertices, split.faces[shown][order])
