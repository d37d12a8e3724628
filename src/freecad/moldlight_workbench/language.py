"""The workbench's texts in the language of FreeCAD's window, by the table of words."""

import functools

import FreeCADGui
from PySide import QtCore

from . import words

table = functools.lru_cache(words.table)


class Language(QtCore.QTranslator):
    """Asked anew for each text, so that it follows a change of the language."""

    def translate(self, context, text, disambiguation=None, n=-1):
        # A command's context is its name.
        return table(FreeCADGui.getLocale()).get(text) if context.startswith("Moldlight") else None


def install():
    """From now on texts are translated, for as long as the window is there."""
    application = QtCore.QCoreApplication.instance()
    application.installTranslator(Language(application))
