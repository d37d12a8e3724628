"""Parts of which the regions are known by formula."""

import FreeCAD
import Part

VECTOR = FreeCAD.Vector

# A box with a pocket, mm.
BOX, POCKET = (40.0, 30.0, 20.0), (30.0, 18.0, 10.0)
# A lid: outer sizes, wall; bosses: radii; hooks: width, height of the catch above the floor, depth of the catch.
LID, WALL = (60.0, 40.0, 15.0), 2.0
BOSS, HOLE = 3.0, 1.5
HOOK_WIDTH, HOOK_HEIGHT, CATCH = 6.0, 11.0, 1.5


def pocket(document):
    """A box with a pocket in its upper side; returns the cut and the pocket's box."""
    box = document.addObject("Part::Box", "Block")
    box.Length, box.Width, box.Height = BOX
    tool = document.addObject("Part::Box", "Pocket")
    tool.Length, tool.Width, tool.Height = POCKET
    tool.Placement.Base = VECTOR(5, 5, BOX[2] - POCKET[2])
    cut = document.addObject("Part::Cut", "Body")
    cut.Base, cut.Tool = box, tool
    document.recompute()
    return cut, tool


def pocket_areas():
    """core, cavity, both, undercut along z."""
    length, width, height = BOX
    across, along, depth = POCKET
    return (length * width + 2 * depth * (across + along), length * width, 2 * height * (length + width), 0.0)


def lid_shape():
    """A shelled lid, open upward, with four bosses and two snap hooks that catch toward y."""
    length, width, height = LID
    shell = Part.makeBox(*LID).cut(
        Part.makeBox(length - 2 * WALL, width - 2 * WALL, height, VECTOR(WALL, WALL, WALL)))
    for x in (15, 45):
        for y in (14, 30):
            shell = shell.fuse(Part.makeCylinder(BOSS, 11, VECTOR(x, y, 1)))
            shell = shell.cut(Part.makeCylinder(HOLE, 9, VECTOR(x, y, 3)))
    for x in (20, 34):
        shell = shell.fuse(Part.makeBox(HOOK_WIDTH, 1.5, HOOK_HEIGHT + 3, VECTOR(x, WALL, 1)))
        shell = shell.fuse(Part.makeBox(HOOK_WIDTH, CATCH, 2, VECTOR(x, WALL + 1.5, WALL + HOOK_HEIGHT)))
    return shell.removeSplitter()


def lid_undercut():
    """Below each catch: its underside, the hook's wall, the floor in its shadow."""
    return 2 * HOOK_WIDTH * (HOOK_HEIGHT + 2 * CATCH)


def facing_pockets(inside):
    """A box, open upward and `inside` wide, with a pocket 4 deep in either of two facing walls."""
    box = Part.makeBox(inside + 20, 80, 40, VECTOR(-10, -10, 0)).cut(Part.makeBox(inside, 60, 40, VECTOR(0, 0, 5)))
    for x in (-4, inside):
        box = box.cut(Part.makeBox(4, 10, 8, VECTOR(x, 25, 12)))
    return box


def feature(document, shape, name="Body"):
    made = document.addObject("Part::Feature", name)
    made.Shape = shape
    return made


def filleted(document):
    """A box of which all edges of the upper side are rounded; returns it and the radius."""
    radius = 4.0
    box = Part.makeBox(*BOX)
    upper = [edge for edge in box.Edges if all(abs(vertex.Z - BOX[2]) < 1e-9 for vertex in edge.Vertexes)]
    return feature(document, box.makeFillet(radius, upper)), radius


def three_cubes(document):
    """An assembly of three cubes of 10 mm: two side by side, one above the first. Along z their undercut is what
    the two that stand above each other hide."""
    assembly = document.addObject("App::Part", "Assembly")
    for number, place in enumerate(((0, 0, 0), (20, 0, 0), (0, 0, 20))):
        cube = document.addObject("Part::Box", f"Cube{number}")
        cube.Placement.Base = VECTOR(*place)
        assembly.addObject(cube)
    document.recompute()
    return assembly


def designed(document):
    """A PartDesign body of a box with a pocket, turned and moved within an assembly that is turned, too."""
    body = document.addObject("PartDesign::Body", "Designed")
    box = document.addObject("PartDesign::AdditiveBox", "Block")
    body.addObject(box)
    box.Length, box.Width, box.Height = BOX
    tool = document.addObject("PartDesign::SubtractiveBox", "Pocket")
    body.addObject(tool)
    tool.Length, tool.Width, tool.Height = POCKET
    tool.Placement.Base = VECTOR(5, 5, BOX[2] - POCKET[2])
    body.Placement = FreeCAD.Placement(VECTOR(3, -7, 11), FreeCAD.Rotation(VECTOR(1, 2, 3), 40))
    assembly = document.addObject("App::Part", "Assembly")
    assembly.Placement = FreeCAD.Placement(VECTOR(100, 5, 0), FreeCAD.Rotation(VECTOR(0, 1, 0), 25))
    assembly.addObject(body)
    document.recompute()
    return body
