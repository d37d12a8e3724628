# FreeCAD runs this in its own namespace when its window opens.
import FreeCAD
import FreeCADGui


class MoldlightWorkbench(FreeCADGui.Workbench):
    MenuText = FreeCAD.Qt.translate("Moldlight", "Moldlight")
    ToolTip = FreeCAD.Qt.translate("Moldlight", "What core, cavity and side actions of a mold form of a body")

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
