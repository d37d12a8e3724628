# FreeCAD runs this in its own namespace when its window opens.
import FreeCAD
import FreeCADGui


def translations():
    """A translation of the workbench is a file moldlight_<language>.qm in this folder."""
    import os

    import moldlight_workbench

    return os.path.join(os.path.dirname(os.path.dirname(moldlight_workbench.__file__)), "translations")


FreeCADGui.addLanguagePath(translations())
FreeCADGui.updateLocale()


class MoldlightWorkbench(FreeCADGui.Workbench):
    MenuText = FreeCAD.Qt.translate("Moldlight", "Moldlight")
    ToolTip = FreeCAD.Qt.translate("Moldlight", "Mold regions of a body: what core, cavity and side actions form")

    def __init__(self):
        from moldlight_workbench import views

        self.__class__.Icon = views.icon("moldlight")

    def Initialize(self):
        from moldlight_workbench import commands

        names = commands.add_all()
        self.appendToolbar(FreeCAD.Qt.translate("Moldlight", "Mold"), names)
        self.appendMenu(FreeCAD.Qt.translate("Moldlight", "&Mold"), names)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(MoldlightWorkbench())
