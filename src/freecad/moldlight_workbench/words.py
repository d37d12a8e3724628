"""Words of the module's reports as FreeCAD shows them."""

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
