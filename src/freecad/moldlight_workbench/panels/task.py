"""What all task panels have in common: one transaction from opening to OK, messages, tables, a look at the result."""

from contextlib import contextmanager

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import progress
from ..engine import Refusal, translate

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# Of a table with more rows, at least.
ROWS_SHOWN = 8
# In pixels what a panel needs beside its widest table; it is as wide as that, but no wider than that share of the window.
# A user may make it narrower again.
PANEL_RIM, LEAST_WIDTH, PANEL_SHARE = 80, 440, 0.55
NO_LIMIT = 16_777_215


def say(text):
    """One message to the user."""
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "moldlight", text)


@contextmanager
def failures_said():
    """What is refused, or fails in the module, becomes one message; what was cancelled none. The value is a list that
    holds the failure."""
    failures = []
    try:
        yield failures
    except Refusal as refusal:
        failures.append(refusal)
        say(str(refusal))
    except Exception as failure:
        import moldlight

        if not isinstance(failure, moldlight.Error):
            raise
        failures.append(failure)
        if not isinstance(failure, moldlight.Cancelled):
            say(str(failure))


def show(make):
    """Opens the panel that `make` returns, unless another one is open."""
    if FreeCADGui.Control.activeDialog():
        say(translate("Moldlight", "Another task is open; close it first."))
        return
    with failures_said():
        panel = make()
        if panel is not None:
            # What is selected hides the colours.
            FreeCADGui.Selection.clearSelection()
            panel.layout.addStretch()
            FreeCADGui.Control.showDialog(panel)
            _widen(panel.form)
            panel.opened()


def _widen(form):
    """Makes the dock that the form is in wide enough for its tables."""
    dock, window = form.parent(), FreeCADGui.getMainWindow()
    while dock is not None and not isinstance(dock, QtGui.QDockWidget):
        dock = dock.parent()
    tables = [table.horizontalHeader().length() + PANEL_RIM for table in form.findChildren(QtGui.QTableWidget)]
    width = max(LEAST_WIDTH, min(max(tables, default=0), int(PANEL_SHARE * window.width())))
    if dock is not None and dock.width() < width:
        window.resizeDocks([dock], [width], QtCore.Qt.Horizontal)


def fit_view():
    """Moves the camera until all is seen that is shown."""
    FreeCADGui.SendMsgToActiveView("ViewFit")


class Panel:
    """A task panel about mold regions. `begun`: the transaction is open already, in which they may have been made;
    else it opens one. Everything in it is one step to undo; Cancel takes it back."""

    title = ""
    picture = "moldlight"

    def __init__(self, regions, begun=False):
        from ..views import icon

        self.title = translate("Moldlight", self.title)
        if not begun:
            regions.Document.openTransaction(self.title)
        self.regions = regions
        self.document = regions.Document
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(self.title)
        self.form.setWindowIcon(QtGui.QIcon(icon(self.picture)))
        self.layout = QtGui.QVBoxLayout(self.form)

    def getStandardButtons(self):
        return int(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        self.document.commitTransaction()
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self):
        self.document.abortTransaction()
        self.document.recompute()
        FreeCADGui.Control.closeDialog()
        return True

    def opened(self):
        """Called once it stands in the window."""

    @property
    def shown(self):
        """The result that it shows: one of the regions', or they themselves."""
        return getattr(self, "found", self.regions)

    def ask(self, *results):
        """compute() under the panel's title."""
        return compute(self.title, *results)

    def text(self, words=""):
        """A line of text that wraps."""
        label = QtGui.QLabel(words)
        label.setWordWrap(True)
        self.layout.addWidget(label)
        return label

    def table(self, headings, chosen=None):
        """A table; `chosen` is called with the number of a row that is clicked, from 0."""
        table = QtGui.QTableWidget(0, len(headings))
        table.setHorizontalHeaderLabels(headings)
        table.verticalHeader().hide()
        table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
        table.verticalHeader().setDefaultSectionSize(table.fontMetrics().height() + 6)
        if chosen is not None:
            table.itemSelectionChanged.connect(lambda: _chosen_row(table, chosen))
        self.layout.addWidget(table)
        return table

    def button(self, words, tip, action, layout=None):
        button = QtGui.QPushButton(words)
        button.setToolTip(tip)
        button.clicked.connect(lambda *_: action())
        (layout or self.layout).addWidget(button)
        return button


def compute(title, *results):
    """Computes what the results need, with progress, before the recompute that only takes it over. False if it was
    refused, failed or cancelled."""
    with failures_said() as failures:
        with progress.shown(title) as listener:
            for result in results:
                result.Proxy.prepare(result, listener)
        for result in results:
            result.touch()
        results[0].Document.recompute()
    return not failures


@contextmanager
def transaction(document, title):
    """A transaction that is taken back if its body raises; a panel's OK or Cancel ends it else."""
    document.openTransaction(title)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise


def fill(table, rows, colours=()):
    """Sets the rows of a table: texts. `colours`: (r, g, b) from 0 to 1 of the first
    column's mark, one a row."""
    table.blockSignals(True)
    table.setRowCount(len(rows))
    for place, row in enumerate(rows):
        for column, cell in enumerate(row):
            item = QtGui.QTableWidgetItem(cell)
            if column and not cell[:1].isalpha():
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            item.setToolTip(cell)
            table.setItem(place, column, item)
        if place < len(colours):
            mark = QtGui.QPixmap(12, 12)
            mark.fill(QtGui.QColor.fromRgbF(*colours[place][:3]))
            table.item(place, 0).setIcon(QtGui.QIcon(mark))
    table.resizeColumnsToContents()
    shown = max(1, min(len(rows), ROWS_SHOWN)) * table.verticalHeader().defaultSectionSize()
    height = table.horizontalHeader().sizeHint().height() + shown + 2 * table.frameWidth() + 2
    table.setMinimumHeight(height)
    table.setMaximumHeight(height if len(rows) <= ROWS_SHOWN else NO_LIMIT)
    table.blockSignals(False)


def _chosen_row(table, chosen):
    rows = table.selectionModel().selectedRows()
    if rows:
        chosen(rows[0].row())


def select(obj, element=""):
    """Selects only this."""
    FreeCADGui.Selection.clearSelection()
    if element:
        FreeCADGui.Selection.addSelection(obj, element)
    else:
        FreeCADGui.Selection.addSelection(obj)
