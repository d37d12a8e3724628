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

from . import _core
from ._core import *  # noqa: F401,F403
from ._core import __version__

__all__ = sorted(name for name in vars(_core) if not name.startswith("_"))

# What is said of the classes is the package's.
for _name in __all__:
    if isinstance(getattr(_core, _name), type):
        getattr(_core, _name).__module__ = __name__
del _name
