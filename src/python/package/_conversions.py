"""Parts and regions as other packages take them. Each package is imported when it is asked for."""

import importlib

import numpy as np

from ._core import REGION_COLOURS, Classification, Part, SplitMesh


def _package(name, call):
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name:
            raise
        raise ImportError(f"{call}() needs the package {name}, which is not installed: pip install {name}",
                          name=name) from error


def _part_to_trimesh(self):
    """The part as a trimesh.Trimesh: facet k is facet k of the part."""
    vertices, faces = np.array(self.vertices), np.array(self.faces)
    return _package("trimesh", "to_trimesh").Trimesh(vertices, faces, process=False)


def _part_to_meshio(self):
    """The part as a meshio.Mesh, with the cell data "face" where faces of the file are known."""
    sources = self.face_of_facet
    data = {} if sources is None else {"face": [np.array(sources)]}
    cells = [("triangle", np.array(self.faces))]
    return _package("meshio", "to_meshio").Mesh(np.array(self.vertices), cells, cell_data=data)


def _regions_to_trimesh(self, palette="paper"):
    """The split mesh as a trimesh.Trimesh in the colours of its regions. Its face_attributes are "region", places
    in moldlight.REGIONS, and "facet", the part's facet."""
    split = self.split_mesh()
    regions = np.array(split.regions)
    trimesh = _package("trimesh", "to_trimesh")
    return trimesh.Trimesh(np.array(split.vertices), np.array(split.faces), process=False,
                           face_colors=np.array(REGION_COLOURS[palette], np.uint8)[regions],
                           face_attributes={"region": regions, "facet": np.array(split.facets)})


def _regions_to_meshio(self):
    """The split mesh as a meshio.Mesh. Its cell data are "region", places in moldlight.REGIONS, and "facet", the
    part's facet."""
    split = self.split_mesh()
    meshio = _package("meshio", "to_meshio")
    return meshio.Mesh(np.array(split.vertices), [("triangle", np.array(split.faces))],
                       cell_data={"region": [np.array(split.regions)], "facet": [np.array(split.facets)]})


def _pyvista_faces(self):
    """The faces as pyvista.PolyData takes them: a flat array of int64, each three corners behind a 3."""
    return np.insert(np.array(self.faces, np.int64), 0, 3, axis=1).ravel()


def _named(function, name):
    function.__name__ = name
    return function


Part.to_trimesh = _named(_part_to_trimesh, "to_trimesh")
Part.to_meshio = _named(_part_to_meshio, "to_meshio")
Classification.to_trimesh = _named(_regions_to_trimesh, "to_trimesh")
Classification.to_meshio = _named(_regions_to_meshio, "to_meshio")
Part.pyvista_faces = SplitMesh.pyvista_faces = property(_pyvista_faces)
