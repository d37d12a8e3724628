# FreeCAD runs this at every start; all that the workbench needs is found through sys.path.
