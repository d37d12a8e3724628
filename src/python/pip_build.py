"""Builds the Python package with CMake, for `pip install .` and `pip wheel .`, and its source distribution: pyproject.toml
names it. Where patchelf is there, the wheel carries the libraries that it needs."""

import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

from setuptools import Extension, build_meta, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = SOURCE / "build"
VERSION = re.search(r"project\(moldlight VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]
# A wheel is made without them.
NOT_OF_THE_SOURCES = (".ci/", ".git", "tests/")
# What pictures and papers are set in where a machine has no fonts.
FONTS = ("Inter-Regular.otf", "Inter-Medium.otf", "Inter-SemiBold.otf", "DejaVuSans.ttf")

sys.path.append(str(SOURCE / "assets/package"))
import carried  # noqa: E402


def carries():
    """Whether libraries can be carried: copied, renamed, and their licences found."""
    return bool(shutil.which("patchelf") and shutil.which("dpkg-query"))


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
        shutil.rmtree(package, ignore_errors=True)
        shutil.copytree(folder / "python" / "moldlight", package, ignore=shutil.ignore_patterns("__pycache__"))
        programs = [shutil.copy2(folder / "bin" / target.replace("_", "-"), package) for target in targets[1:]]
        self.carry(package, [*package.glob("_core*.so"), *map(pathlib.Path, programs)])

    def carry(self, package, files):
        subprocess.run(["strip", *files], check=True)
        if not carries():
            print("moldlight: without patchelf the package needs the libraries of this machine")
            return
        own = package / "carried"
        sources = carried.carry(files, own, rename=True)
        (own / "fonts").mkdir()
        for name in FONTS:
            for font in list(pathlib.Path("/usr/share/fonts").rglob(name))[:1]:
                shutil.copyfile(font, own / "fonts" / name)
                sources.append(font)
        carried.add_licences(sources, own / "licences")

    def get_outputs(self):
        return [str(path) for path in (pathlib.Path(self.build_lib) / "moldlight").rglob("*")]


def source_files():
    """What the source distribution has, relative to the source tree, sorted."""
    if (SOURCE / ".git").exists():
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=SOURCE,
                                check=True, capture_output=True, text=True).stdout
        names = listed.rstrip("\0").split("\0")
    else:
        names = [str(file.relative_to(SOURCE)) for file in SOURCE.rglob("*")
                 if not file.is_dir() and BUILD not in file.parents and "__pycache__" not in file.parts
                 and file.name != "PKG-INFO"]
    return sorted(name for name in names if not name.startswith(NOT_OF_THE_SOURCES))


class Backend(build_meta._BuildMetaBackend):
    """What pyproject.toml names: setuptools, with this file in place of a setup.py."""

    def run_setup(self, setup_script="setup.py"):
        super().run_setup(__file__)

    def build_sdist(self, sdist_directory, config_settings=None):
        root = f"moldlight-{VERSION}"
        archive = os.path.join(sdist_directory, root + ".tar.gz")
        with tempfile.TemporaryDirectory() as folder, tarfile.open(archive, "w:gz") as tar:
            metadata = pathlib.Path(folder, self.prepare_metadata_for_build_wheel(folder), "METADATA")
            tar.add(metadata, f"{root}/PKG-INFO", filter=nobodys)
            for name in source_files():
                tar.add(SOURCE / name, f"{root}/{name}", filter=nobodys)
        return os.path.basename(archive)


def nobodys(entry):
    """An entry of an archive without the owner that the file has here."""
    entry.uid = entry.gid = 0
    entry.uname = entry.gname = ""
    return entry


if __name__ == "__main__":
    BUILD.mkdir(exist_ok=True)
    # Of the system it needs glibc and GCC's runtime alone.
    tag = "manylinux_" + "_".join(platform.libc_ver()[1].split(".")) + "_" + platform.machine()
    setup(version=VERSION, packages=[], ext_modules=[Extension("moldlight._core", [])],
          cmdclass={"build_ext": BuildWithCMake},
          options={"egg_info": {"egg_base": "build"}, "build": {"build_base": "build/pip"},
                   **({"bdist_wheel": {"plat_name": tag}} if carries() else {})})
else:
    backend = Backend()
