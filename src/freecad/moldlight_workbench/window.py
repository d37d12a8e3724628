"""The same part, direction and settings in moldlight's own window."""

import os
import shutil
import subprocess
import tempfile
import threading

from . import regions, shapes
from .engine import Refusal, translate

# Where the program is, if it is not in PATH.
PROGRAM_VARIABLE = "MOLDLIGHT_PROGRAM"


def program():
    """The program's file. Raises Refusal."""
    found = shutil.which(os.environ.get(PROGRAM_VARIABLE, "moldlight"))
    if found is None:
        raise Refusal(
            translate(
                "Moldlight", "The program moldlight is not there: install the package moldlight, or name its file in {}."
            ).format(PROGRAM_VARIABLE)
        )
    return found


def arguments(obj, file):
    """What the program is started with to show mold regions whose shape is in `file`."""
    deflection = obj.LinearDeflection.Value or shapes.default_deflection(obj.Shape)
    given = [
        "view", file, "--unit", "mm",
        "--direction", ",".join(repr(component) for component in regions.direction(obj)),
        "--tau", repr(obj.Tau.Value),
        "--linear-deflection", repr(deflection),
        "--angular-deflection", repr(obj.AngularDeflection.Value),
    ]
    if obj.Tolerance.Value:
        given += ["--tolerance", repr(obj.Tolerance.Value)]
    return given


def write_part(obj, folder):
    """Writes the body to a STEP file in the folder and returns its name."""
    letters = "".join(letter if letter.isalnum() else "_" for letter in obj.Source.Label)
    file = os.path.join(folder, (letters or "part") + ".step")
    shapes.solid_shape(obj.Source).exportStep(file)
    return file


def open_window(obj):
    """Starts the program; what it reads is removed once it has ended. Returns its process. Raises Refusal."""
    name = program()
    folder = tempfile.mkdtemp(prefix="moldlight-")
    try:
        process = subprocess.Popen([name, *arguments(obj, write_part(obj, folder))])
    except OSError as failure:
        shutil.rmtree(folder, ignore_errors=True)
        raise Refusal(str(failure)) from None

    def clean():
        process.wait()
        shutil.rmtree(folder, ignore_errors=True)

    threading.Thread(target=clean, daemon=True).start()
    return process
