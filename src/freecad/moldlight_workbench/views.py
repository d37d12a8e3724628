"""View providers: colours by region, by action and by half; a double click opens the panel."""

import os

from pivy import coin
from PySide import QtCore

from . import actions, meshes, parting, properties, regions, shapes, sweeps

# Of a face that belongs to several regions, in tables and under its split mesh.
MIXED_COLOUR = (0.95, 0.75, 0.05)
ICONS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "icons")


def icon(name):
    """The file of one of the workbench's icons."""
    return os.path.join(ICONS, name + ".svg")


class View(properties.Unsaved):
    """Of a result. `picture` names its icon."""

    picture = "moldlight"
    # What is set once, when the result is made.
    looks = {}

    def __init__(self, view):
        view.Proxy = self
        for name, value in self.looks.items():
            if hasattr(view, name):
                setattr(view, name, value)

    def attach(self, view):
        self.Object = view.Object

    def getIcon(self):
        return icon(self.picture)

    def updateData(self, obj, prop):
        # FreeCAD takes a shape or a mesh over after this call, and its colours back to one.
        if prop in ("Colours", "FaceRegions", "Counts", "Mesh", "Shape"):
            QtCore.QTimer.singleShot(0, lambda: self._recolour(obj))

    def _recolour(self, obj):
        try:
            self.colour(obj, obj.ViewObject)
        except (ReferenceError, RuntimeError):
            pass  # FreeCAD has deleted it meanwhile

    def colour(self, obj, view):
        """Gives the colours that the object has."""

    def panel(self, obj):
        """The task panel of the object, or None."""
        return None

    def doubleClicked(self, view):
        from .panels.task import show

        show(lambda: self.panel(view.Object))
        return True


class RegionsView(View):
    """Faces by region; on mixed faces lies their split mesh."""

    picture = "regions"

    def colour(self, obj, view):
        if not obj.Colours or len(obj.FaceRegions) != len(obj.Shape.Faces):
            return
        # The same facets as those of the split mesh, so that it lies on them.
        box = obj.Shape.BoundBox
        deflection = obj.LinearDeflection.Value or shapes.default_deflection(obj.Shape)
        view.Deviation = 300.0 * deflection / (box.XLength + box.YLength + box.ZLength)
        view.AngularDeflection = obj.AngularDeflection.Value
        colours = [*(colour[:3] for colour in obj.Colours), MIXED_COLOUR]
        view.DiffuseColor = [(*colours[region], 0.0) for region in obj.FaceRegions]

    def panel(self, obj):
        from .panels.regions_panel import RegionsPanel

        return RegionsPanel(obj)

    def onDelete(self, view, elements):
        if view.Object.Source is not None:
            view.Object.Source.Visibility = True
        return True


class MeshView(View):
    """Groups of facets, each in its colour."""

    picture = "regions"
    looks = {"Lighting": "Two side"}

    def colour(self, obj, view):
        if not obj.Counts or len(obj.Counts) != len(obj.Colours) or sum(obj.Counts) != obj.Mesh.CountFacets:
            return
        # The colours of facets are the material's, which FreeCAD has no property for.
        facets = [colour[:3] for colour, count in zip(obj.Colours, obj.Counts) for _ in range(count)]
        for material in _nodes(view.RootNode, coin.SoMaterial):
            if facets:
                material.diffuseColor.setNum(len(facets))
                material.diffuseColor.setValues(0, len(facets), facets)
        for binding in _nodes(view.RootNode, coin.SoMaterialBinding):
            binding.value = coin.SoMaterialBinding.PER_FACE


class MixedView(MeshView):
    """It lies on the faces; a click goes through it, to the face below."""

    looks = {**MeshView.looks, "Selectable": False}

    def attach(self, view):
        super().attach(view)
        through = coin.SoPickStyle()
        through.style = coin.SoPickStyle.UNPICKABLE
        in_front = coin.SoPolygonOffset()
        in_front.factor, in_front.units = -1.0, -1.0
        for node in (through, in_front):
            view.RootNode.insertChild(node, 0)


class DirectionsView(View):
    picture = "direction"

    def panel(self, obj):
        from .panels.direction_panel import DirectionPanel

        return DirectionPanel(obj.Regions)


class OfActions:
    """Opens their panel."""

    picture = "actions"

    def panel(self, obj):
        from .panels.actions_panel import ActionsPanel

        return ActionsPanel(obj.Regions)


class ActionsView(OfActions, MeshView):
    pass


class ArrowsView(OfActions, View):
    looks = {"DisplayMode": "Shaded"}

    def colour(self, obj, view):
        if obj.Colours and len(obj.Colours) == len(obj.Shape.Faces):
            view.DiffuseColor = [colour[:3] + (0.0,) for colour in obj.Colours]


class OfParting:
    """Opens its panel."""

    picture = "parting"

    def panel(self, obj):
        from .panels.parting_panel import PartingPanel

        return PartingPanel(obj.Regions)


class LineView(OfParting, View):
    looks = {"LineWidth": 4.0, "LineColor": (0.95, 0.75, 0.05), "PointSize": 1.0}


class BodyView(OfParting, MeshView):
    pass


_VIEWS = {
    regions.MoldRegions: RegionsView,
    meshes.MixedFaces: MixedView,
    sweeps.FoundDirections: DirectionsView,
    actions.SideActions: ActionsView,
    actions.ActionArrows: ArrowsView,
    parting.PartingLine: LineView,
    parting.MoldBody: BodyView,
}


def attach(obj):
    """Gives a result its view."""
    _VIEWS[type(obj.Proxy)](obj.ViewObject)


def _nodes(root, kind):
    search = coin.SoSearchAction()
    search.setType(kind.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(root)
    paths = search.getPaths()
    return [paths[place].getTail() for place in range(paths.getLength())]
