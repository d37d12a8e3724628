"""The commands of menu and toolbar."""

import FreeCAD
import FreeCADGui

from . import regions, results, selection, views, window
from .engine import engine, translate
from .panels import task
from .panels.actions_panel import ActionsPanel
from .panels.direction_panel import DirectionPanel
from .panels.parting_panel import PartingPanel
from .panels.regions_panel import RegionsPanel

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Command:
    """A command on the selected body. What it makes, from the group to the figures, is one step to undo. `opens` is
    the class of its panel."""

    name = picture = text = tip = ""
    opens = None

    def GetResources(self):
        return {"Pixmap": views.icon(self.picture), "MenuText": self.text, "ToolTip": self.tip}

    def IsActive(self):
        return FreeCAD.ActiveDocument is not None

    def Activated(self):
        task.show(self.panel)

    def panel(self):
        """The panel that the command opens. Raises Refusal."""
        engine()
        known, body, reference = selection.chosen_body()
        title = translate("Moldlight", self.text)
        with task.transaction(body.Document, title):
            made = known or results.make_regions(body)
            if known is None and reference is not None:
                regions.set_reference(made, *reference)
            panel = self.make_panel(made) if known or task.compute(title, made) else None
            if panel is None or not task.compute(title, panel.shown):
                body.Document.abortTransaction()
                return None
        panel.refresh()
        return panel

    def make_panel(self, made):
        """The panel of mold regions that are computed, for the transaction that is open."""
        return self.opens(made, begun=True)


class Regions(Command):
    name, picture = "Moldlight_Regions", "regions"
    opens = RegionsPanel
    text = QT_TRANSLATE_NOOP("Moldlight", "Mold regions")
    tip = QT_TRANSLATE_NOOP(
        "Moldlight", "Find what core and cavity form of the selected body, and its undercuts. A face, edge or axis "
        "selected with it sets the parting direction.")


class Direction(Command):
    name, picture = "Moldlight_FindDirection", "direction"
    opens = DirectionPanel
    text = QT_TRANSLATE_NOOP("Moldlight", "Find direction")
    tip = QT_TRANSLATE_NOOP("Moldlight", "Find the parting directions with the least undercut, and choose one")


class Actions(Command):
    name, picture = "Moldlight_Actions", "actions"
    opens = ActionsPanel
    text = QT_TRANSLATE_NOOP("Moldlight", "Undercuts and actions")
    tip = QT_TRANSLATE_NOOP("Moldlight", "Find the slides, lifters and other side actions that release the undercuts")


class Parting(Command):
    name, picture = "Moldlight_Parting", "parting"
    opens = PartingPanel
    text = QT_TRANSLATE_NOOP("Moldlight", "Parting line")
    tip = QT_TRANSLATE_NOOP("Moldlight", "Make the parting line as edges, and the mold halves as meshes")


class Window(Command):
    name, picture = "Moldlight_Window", "window"
    text = QT_TRANSLATE_NOOP("Moldlight", "Open in moldlight")
    tip = QT_TRANSLATE_NOOP("Moldlight", "Open the part with this direction and these settings in moldlight's own window")

    def Activated(self):
        with task.failures_said():
            known, _, _ = selection.chosen_body()
            if known is None:
                task.say(translate("Moldlight", "This body has no mold regions yet: call Mold regions first."))
            else:
                window.open_window(known)


COMMANDS = (Regions, Direction, Actions, Parting, Window)


def add_all():
    """Makes the commands known to FreeCAD and returns their names."""
    for command in COMMANDS:
        FreeCADGui.addCommand(command.name, command())
    return [command.name for command in COMMANDS]
