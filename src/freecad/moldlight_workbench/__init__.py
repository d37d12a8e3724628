"""moldlight in FreeCAD: mold-piece regions, directions, side actions, parting line and halves as document objects.

All geometry is computed by the Python module moldlight; here are the document, the view and the panels.
"""
