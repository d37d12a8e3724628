"""The Python module that computes, and what refuses a request: one sentence for the user."""

import FreeCAD

translate = FreeCAD.Qt.translate


class Refusal(Exception):
    """A request that cannot be met; its text says why, and what to do."""


def isolated():
    """Whether work can be done in a process of its own, so that a fault of the module takes no document with it."""
    return engine().can_isolate()


def engine():
    """The module moldlight. Raises Refusal if it is not there."""
    try:
        import moldlight
    except ImportError as failure:
        raise Refusal(
            translate(
                "Moldlight",
                "The Python module moldlight is not there: install the package python3-moldlight, or start "
                "FreeCAD with -P and the module's folder ({}).",
            ).format(failure)
        ) from None
    return moldlight
