"""Words of the module's reports as FreeCAD shows them, and the table by which all texts are translated."""

import csv
import os

import FreeCAD

from .engine import translate

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_WORDS = (
    QT_TRANSLATE_NOOP("Moldlight", "core"),
    QT_TRANSLATE_NOOP("Moldlight", "cavity"),
    QT_TRANSLATE_NOOP("Moldlight", "both"),
    QT_TRANSLATE_NOOP("Moldlight", "undercut"),
    QT_TRANSLATE_NOOP("Moldlight", "mixed"),
    QT_TRANSLATE_NOOP("Moldlight", "slide"),
    QT_TRANSLATE_NOOP("Moldlight", "inclined"),
    QT_TRANSLATE_NOOP("Moldlight", "lifter"),
    QT_TRANSLATE_NOOP("Moldlight", "unscrew"),
    QT_TRANSLATE_NOOP("Moldlight", "strip"),
    QT_TRANSLATE_NOOP("Moldlight", "insert"),
    QT_TRANSLATE_NOOP("Moldlight", "outer"),
    QT_TRANSLATE_NOOP("Moldlight", "shut-off"),
    QT_TRANSLATE_NOOP("Moldlight", "action"),
)


def shown(word):
    """A region, a kind of side action or of loop in the user's language."""
    return translate("Moldlight", word) if word in _WORDS else word


def table(language):
    """The texts in a language, as FreeCAD names it, by the English ones; empty if translations.csv has no such column."""
    file = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "translations.csv")
    with open(file, newline="", encoding="utf-8") as lines:
        rows = list(csv.DictReader(lines))
    return {row["English"]: row[language] for row in rows if row.get(language)}
