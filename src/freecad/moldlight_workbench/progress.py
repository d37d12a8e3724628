"""Progress of long work, with a button that cancels it; nothing of it where there is no window."""

from contextlib import contextmanager

import FreeCAD

from .engine import translate

STEPS = 1000
# Shorter work shows no progress.
PATIENCE_MS = 600


@contextmanager
def shown(title):
    """A listener as the module's calls take it, or None without a window."""
    if not FreeCAD.GuiUp:
        yield None
        return
    import FreeCADGui
    from PySide import QtCore, QtGui

    dialog = QtGui.QProgressDialog(
        title, translate("Moldlight", "Cancel"), 0, STEPS, FreeCADGui.getMainWindow()
    )
    dialog.setWindowTitle(title)
    dialog.setWindowModality(QtCore.Qt.ApplicationModal)
    dialog.setMinimumDuration(PATIENCE_MS)
    dialog.setMinimumWidth(360)
    dialog.setAutoReset(False)
    dialog.setValue(0)
    application = QtGui.QApplication.instance()
    ear = _ear(dialog)
    application.installEventFilter(ear)

    def listener(stage, share):
        dialog.setLabelText(f"{title}: {stage}")
        dialog.setValue(min(int(share * STEPS), STEPS - 1))
        return not dialog.wasCanceled()

    try:
        yield listener
    finally:
        application.removeEventFilter(ear)
        dialog.close()
        dialog.deleteLater()


def _ear(dialog):
    """Hears the button and the escape key before FreeCAD does, which drops them while it recomputes."""
    from PySide import QtCore, QtGui

    class Ear(QtCore.QObject):
        def eventFilter(self, heard_by, event):
            pressed = event.type() == QtCore.QEvent.MouseButtonPress and isinstance(heard_by, QtGui.QPushButton)
            escaped = event.type() == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape
            if (pressed and heard_by.window() is dialog) or (escaped and dialog.isVisible()):
                dialog.cancel()
                return True
            return False

    return Ear(dialog)
