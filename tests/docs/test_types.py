"""The Python of README and docs that uses the module has the types that its stubs say: mypy --strict. Skipped where mypy is
not installed."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import documents  # noqa: F401, which finds docs/tools
import blocks


class Types(unittest.TestCase):
    def test_snippets_are_well_typed(self):
        with tempfile.TemporaryDirectory() as folder:
            for page in blocks.pages():
                for block in blocks.blocks(blocks.read(page)):
                    if block.kind == "python" and "import moldlight" in block.lines:
                        file = pathlib.Path(folder, f"{page.stem}_line_{block.first}.py")
                        file.write_text("\n".join(block.lines) + "\n", encoding="utf-8")
            files = sorted(pathlib.Path(folder).iterdir())
            self.assertGreaterEqual(len(files), 3)
            done = subprocess.run(["mypy", "--strict", "--cache-dir", f"{folder}/cache", *files], capture_output=True,
                                  text=True, env={**os.environ, "MYPYPATH": os.environ["PYTHONPATH"]})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    if shutil.which("mypy") is None:
        print("mypy is not installed; the types are not tested")
        sys.exit(77)
    unittest.main()
