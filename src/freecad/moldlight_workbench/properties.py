"""Properties of the document objects. Settings are made from the module's own table: name, unit, help, default."""

import FreeCAD

from .engine import engine

# The property of a setting by its unit; numbers without one are plain.
_KINDS_BY_UNIT = {
    "deg": "App::PropertyAngle",
    "mm": "App::PropertyLength",
    "part's unit": "App::PropertyLength",
    "file's unit": "App::PropertyLength",
}

# How some schemas write inches.
DOUBLE_PRIME = '"'


def add(obj, kind, name, group, tip, value=None):
    """Adds a property unless it is there; a file of an older version gets what is new."""
    if hasattr(obj, name):
        return
    obj.addProperty(kind, name, group, tip)
    if value is not None:
        setattr(obj, name, value)


def add_result(obj, kind, name, tip, hidden=False):
    """A property that only a recompute sets."""
    add(obj, kind, name, "Result", tip)
    obj.setEditorMode(name, 2 if hidden else 1)


def add_link(obj, name, tip):
    """A link to another result, which only the program sets."""
    add(obj, "App::PropertyLinkGlobal", name, "Mold", tip)
    obj.setEditorMode(name, 1)


def setting_name(key):
    """The property of a setting: "tau_deg" is "Tau"."""
    words = key.split("_")
    if words[-1] in ("deg", "mm"):
        words.pop()
    return "".join(word.capitalize() for word in words)


def add_settings(obj, call, keys, values=None):
    """Adds settings of a call as properties; `values` replace their defaults."""
    table = {entry["key"]: entry for entry in engine().settings(call)}
    for key in keys:
        entry = table[key]
        name = setting_name(key)
        if hasattr(obj, name):
            continue
        default = (values or {}).get(key, entry["default"])
        obj.addProperty(_kind(entry), name, "Settings", f'{entry["label"]}: {entry["help"]}')
        if entry["words"]:
            setattr(obj, name, entry["words"])
        if default is not None:
            setattr(obj, name, default)


def settings(obj, call, keys):
    """The settings of a call as keyword arguments. An optional number that is 0 is left to its default."""
    table = {entry["key"]: entry for entry in engine().settings(call)}
    given = {}
    for key in keys:
        value = getattr(obj, setting_name(key))
        value = getattr(value, "Value", value)
        optional = table[key]["default"] is None
        if not (optional and value in (0, "")):
            given[key] = value
    return given


def _kind(entry):
    if entry["words"]:
        return "App::PropertyEnumeration"
    kind = entry["type"].removeprefix("Optional[").rstrip("]")
    if kind == "bool":
        return "App::PropertyBool"
    if kind == "int":
        return "App::PropertyInteger"
    if kind == "float":
        return _KINDS_BY_UNIT.get(entry["unit"], "App::PropertyFloat")
    return "App::PropertyString"


class Unsaved:
    """Of its objects FreeCAD saves nothing but the name of their class."""

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        return None

    dumps, loads = __getstate__, __setstate__


class Proxy(Unsaved):
    """What the classes behind document objects have in common."""

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def onDocumentRestored(self, obj):
        self.add_properties(obj)
        # A file that was made without a window has no views.
        if FreeCAD.GuiUp and not obj.ViewObject.Proxy:
            from . import views

            views.attach(obj)


def quantity(value, kind):
    """A number of mm, mm², mm³ or degrees in the user's unit schema and with its digits, all of a kind in the same unit,
    which FreeCAD changes with the size of the number; kind: "length", "area", "volume", "angle"."""
    units = FreeCAD.Units
    if kind == "angle":
        return units.Quantity(value, units.Angle).UserString
    power = ("length", "area", "volume").index(kind) + 1
    # Of a length of a centimetre.
    _, factor, unit = units.Quantity(10.0, units.Length).getUserPreferred()
    return f"{plain(value / factor**power)} {'in' if unit == DOUBLE_PRIME else unit}{' ²³'[power - 1].strip()}"


def plain(number):
    """A number without a unit, with the digits that the user has set."""
    return FreeCAD.Units.Quantity(number).UserString.strip()


def percent(share):
    """A share of 0 to 1 as percent."""
    return f"{plain(100.0 * share)} %"
