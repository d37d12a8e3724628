# Run by freecadcmd where the packages are installed: the workbench is found, and knows the regions of a cube.
import os
import sys
import traceback

status = 1
try:
    import FreeCAD

    from moldlight_workbench import results

    document = FreeCAD.newDocument()
    cube = document.addObject("Part::Box", "Cube")
    document.recompute()
    found = results.make_regions(cube)
    document.recompute()
    print("try: core", found.CoreArea, "cavity", found.CavityArea, "both", found.BothArea)
    if abs(found.CoreArea.Value - 100) < 1e-9 and abs(found.BothArea.Value - 400) < 1e-9:
        status = 0
except BaseException:
    traceback.print_exc()
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
