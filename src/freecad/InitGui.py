# FreeCAD runs this in its own namespace when its window opens.
import FreeCAD
import FreeCADGui

from moldlight_workbench import language

language.install()


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
