"""What pip makes: the metadata and the files of the source distribution, and libraries that are carried beside a program."""

import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

from support import PROGRAM, SOURCE

sys.path[:0] = [str(SOURCE / "src/python"), str(SOURCE / "assets/package")]
import carried  # noqa: E402

try:
    import pip_build
except ImportError:
    pip_build = None

VERSION = re.search(r"project\(moldlight VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]


@unittest.skipUnless(pip_build, "python3-setuptools is not installed")
class SourceDistribution(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        # In a process of its own, as pip calls it: setuptools changes the one that it runs in.
        code = "import sys, pip_build; print(pip_build.backend.build_sdist(sys.argv[1]))"
        said = subprocess.run([sys.executable, "-B", "-c", code, cls.folder.name], check=True, capture_output=True, text=True,
                              cwd=SOURCE, env={"PYTHONPATH": str(SOURCE / "src/python"), "PATH": "/usr/bin:/bin"}).stdout
        cls.name = said.split()[-1]
        with tarfile.open(pathlib.Path(cls.folder.name, cls.name)) as tar:
            cls.entries = {entry.name: entry for entry in tar}
            cls.metadata = tar.extractfile(f"moldlight-{VERSION}/PKG-INFO").read().decode()

    def test_metadata(self):
        self.assertEqual(self.name, f"moldlight-{VERSION}.tar.gz")
        for line in ("Name: moldlight", f"Version: {VERSION}", "License: MIT", "Requires-Python: >=3.9", "Requires-Dist: numpy"):
            self.assertIn(f"\n{line}\n", self.metadata)
        self.assertIn("\n# moldlight\n", self.metadata)  # the README

    def test_files(self):
        files = {name.removeprefix(f"moldlight-{VERSION}/") for name in self.entries}
        for name in ("pyproject.toml", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "CHANGELOG.md",
                     "third_party/CMakeLists.txt", "src/python/pip_build.py", "assets/package/carried.py"):
            self.assertIn(name, files)
        # All that the build looks at: sources by patterns, the rest by name.
        endings_in = {"src": ("cpp", "hpp", "py", "in", "js", "css"), "shaders": ("*",), "docs": ("md", "json")}
        for folder, endings in endings_in.items():
            for ending in endings:
                there = {str(file.relative_to(SOURCE)) for file in (SOURCE / folder).rglob(f"*.{ending}")
                         if file.is_file() and "__pycache__" not in file.parts}
                self.assertEqual(sorted(there - files), [], folder)
        self.assertEqual([name for name in files if name.startswith(("tests/", "build/", ".git"))], [])
        self.assertEqual({(entry.uid, entry.uname) for entry in self.entries.values()}, {(0, "")})


@unittest.skipUnless(shutil.which("patchelf") and shutil.which("dpkg-query"), "patchelf is not installed")
class Carried(unittest.TestCase):
    def test_libraries_are_found_beside_the_program(self):
        for rename in (False, True):
            with self.subTest(rename=rename), tempfile.TemporaryDirectory() as folder:
                program = carried.copied(PROGRAM, pathlib.Path(folder, "moldlight"))
                own = pathlib.Path(folder, "lib")
                sources = carried.carry([program], own, rename)
                self.assertGreater(len(sources), 10)
                lines = [line.split() for line in carried.ran("ldd", program).splitlines()]
                elsewhere = [line[0] for line in lines if len(line) > 2 and not line[2].startswith(folder)]
                self.assertEqual([name for name in elsewhere if not carried.OF_THE_SYSTEM.match(name)], [])
                self.assertIn("moldlight", carried.ran(program, "--version"))
                self.assertEqual([file.name for file in own.iterdir() if rename and "-moldlight.so" not in file.name], [])
                carried.add_licences(sources, own / "licences")
                self.assertGreater(len(list((own / "licences").iterdir())), 10)

    def test_what_belongs_to_no_package_is_named(self):
        with self.assertRaisesRegex(FileNotFoundError, "own.file belongs to no package"):
            carried.packages_of([pathlib.Path("/own.file")])


if __name__ == "__main__":
    unittest.main()
