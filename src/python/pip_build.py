"""Builds the Python package with CMake, for `pip install .` and `pip wheel .`: pyproject.toml names it."""

import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, build_meta, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build"


class BuildWithCMake(build_ext):
    def run(self):
        folder = BUILD / f"pip-{sys.implementation.cache_tag}"
        subprocess.run(["cmake", "--preset", "release", "-B", folder, "-DMOLDLIGHT_PYTHON=ON",
                        f"-DPython_EXECUTABLE={sys.executable}"], cwd=SOURCE, check=True)
        # STEP is read by a program of its own, where OpenCASCADE is there.
        rules = subprocess.run(["cmake", "--build", folder, "--target", "help"], check=True, capture_output=True,
                               text=True).stdout
        targets = ["python_package"] + ["moldlight_step"] * ("moldlight_step" in rules)
        subprocess.run(["cmake", "--build", folder, "--parallel", "--target", *targets], check=True)
        package = pathlib.Path(self.build_lib) / "moldlight"
        shutil.copytree(folder / "python" / "moldlight", package, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("__pycache__"))
        for program in targets[1:]:
            shutil.copy2(folder / "bin" / program.replace("_", "-"), package)

    def get_outputs(self):
        return [str(path) for path in (pathlib.Path(self.build_lib) / "moldlight").rglob("*")]


class Backend(build_meta._BuildMetaBackend):
    """What pyproject.toml names: setuptools, with this file in place of a setup.py."""

    def run_setup(self, setup_script="setup.py"):
        super().run_setup(__file__)


if __name__ == "__main__":
    BUILD.mkdir(exist_ok=True)
    setup(version=re.search(r"project\(moldlight VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1],
          packages=[], ext_modules=[Extension("moldlight._core", [])], cmdclass={"build_ext": BuildWithCMake},
          options={"egg_info": {"egg_base": "build"}, "build": {"build_base": "build/pip"}})
else:
    backend = Backend()
