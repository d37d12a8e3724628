"""Mold-piece regions of injection-molded parts.

If a mold opens along a direction, which surface of the part is formed by the core, which by the cavity,
which by either, and which is an undercut?

    import moldlight

    part = moldlight.Part.read("lid.step", unit="mm")     # or moldlight.Part(vertices, faces, unit="mm")
    found = part.classify("z", tau_deg=1.0)
    print(found.areas["undercut"], "+-", found.undercut_uncertainty, part.unit)
    split = found.split_mesh()                            # vertices, faces, regions, borders

Every call has the settings of the command of that name as keywords; help(moldlight.Part.classify) lists
them, moldlight.settings("classify") lists them for a program. Results have the figures of the program's JSON
report, to the last digit; to_json() is that report. What fails raises moldlight.Error or a subclass of it.
Python's lock is released while work runs, so threads compute side by side.
"""

from . import _conversions, _core, _notebook  # noqa: F401
from ._core import *  # noqa: F401,F403
from ._batch import BatchResult, batch  # noqa: F401
from ._isolated import can_isolate, isolating as _isolating
from ._core import __version__


class Verdict(dict):
    """What a result says first: a dict whose members are attributes, too. What it has not is None.

    state: a word such as 'two-plate'. sentence: the verdict as a sentence. undercuts: how many count.
    undercut_area, unreleased_area: areas. specks: undercuts that do not count. actions: how many of each kind.
    reasons: what else there is to say, a sentence each.
    """

    __slots__ = ()


def _add_members(names):
    for name in names:
        setattr(Verdict, name, property(lambda self, name=name: self.get(name)))


_add_members(("state", "sentence", "undercuts", "undercut_area", "unreleased_area", "specks", "actions", "reasons"))


def _as_verdict(value):
    return None if value is None else Verdict(value)


def _give_verdict(owner):
    found = owner.verdict
    owner.verdict = property(lambda self: _as_verdict(found.fget(self)), doc=found.__doc__)


for _owner in (_core.Classification, _core.Sweep, _core.Actions, _core.Mold, _core.Pieces, _core.Draft):
    _give_verdict(_owner)
_both = _core.Comparison.verdicts
_change = _core.Comparison.verdict
_core.Comparison.verdicts = property(
    lambda self: {name: _as_verdict(value) for name, value in _both.fget(self).items()}, doc=_both.__doc__)
_core.Comparison.verdict = property(
    lambda self: Verdict({**(self.verdicts["b"] or {}), "sentence": _change.fget(self)}), doc=_change.__doc__)

for _name in ("classify", "draft", "sweep", "actions", "mold", "pieces"):
    setattr(_core.Part, _name, _isolating(getattr(_core.Part, _name)))
compare = _core.compare = _isolating(_core.compare)

__all__ = sorted([name for name in vars(_core) if not name.startswith("_")] + ["BatchResult", "Verdict", "batch", "can_isolate"])

# What is said of the classes is the package's.
for _name in __all__:
    if isinstance(globals()[_name], type) or _name in ("batch", "can_isolate"):
        globals()[_name].__module__ = __name__
del _name, _owner
