"""The panel of side actions: undercuts, and what releases them."""

from .. import actions, directions, results, words
from ..engine import translate
from ..properties import quantity
from . import task


class ActionsPanel(task.Panel):
    picture, title = "actions", task.QT_TRANSLATE_NOOP("Moldlight", "Undercuts and actions")

    def __init__(self, regions, begun=False):
        super().__init__(regions, begun)
        self.found = results.actions_of(regions)
        self.text(translate("Moldlight", "Side actions"))
        self.rows = self.table([translate("Moldlight", "Kind"), translate("Moldlight", "Direction"),
                                translate("Moldlight", "Travel"), translate("Moldlight", "Stroke"),
                                translate("Moldlight", "Area"), translate("Moldlight", "Body"),
                                translate("Moldlight", "Section"), translate("Moldlight", "Undercuts")])
        self.summary = self.text()
        self.text(translate("Moldlight", "Undercuts"))
        self.undercuts = self.table([translate("Moldlight", "No."), translate("Moldlight", "Area"),
                                     translate("Moldlight", "Depth"), translate("Moldlight", "Side")])
        self.refresh()

    def refresh(self):
        def length(value, unit="length"):
            return "–" if value is None else quantity(value, unit)

        table = actions.action_table(self.found)
        rows = [(words.shown(kind), "–" if direction is None else directions.text_of(direction, 3), length(travel), length(stroke),
                 quantity(area, "area"), length(body["volume"], "volume"), length(body["least_section"], "area"),
                 ", ".join(str(number) for number in undercuts))
                for kind, direction, travel, stroke, area, body, undercuts in table]
        task.fill(self.rows, rows, [actions.COLOURS.get(row[0], actions.OTHER_COLOUR) for row in table])
        found = actions.report(self.found)
        task.fill(self.undercuts, [(str(undercut["id"]), quantity(undercut["area"], "area"), length(undercut["depth"]),
                                    words.shown(undercut["side"] or "–")) for undercut in found.get("undercuts", ())])
        self.summary.setText("\n".join(self._remarks()))

    def _remarks(self):
        """The verdict, and a sentence on actions that meet and on bodies that hit."""
        sentences = [self.found.Verdict]
        if meet := actions.meetings(self.found):
            sentences.append(translate("Moldlight", "The paths of these rows cross: {}.").format(
                ", ".join(f"{one} + {other}" for one, other in meet)))
        for row, other, depth in actions.hits(self.found):
            sentences.append(translate("Moldlight", "The body of row {} reaches {} into {}.").format(
                row, quantity(depth, "length"), translate("Moldlight", "the part") if other == "part" else
                translate("Moldlight", "that of row {}").format(other)))
        return sentences
