"""Runs the blocks of a page in a folder of their own, in which `parts` and `revisions` are the shipped parts."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import blocks

TIME_LIMIT_S = 300


def program():
    """The program of the build folder, or the one that is installed."""
    built = blocks.ROOT / "build" / "ci" / "bin" / "moldlight"
    named = os.environ.get("MOLDLIGHT_BINARY", str(built) if built.exists() else shutil.which("moldlight"))
    if not named:
        sys.exit("docs: there is no program; build it, or name it in MOLDLIGHT_BINARY")
    return pathlib.Path(named).resolve()


class Session:
    """The commands of one page, one after the other, as a reader types them."""

    def __init__(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name) / "work"
        self.folder.mkdir()
        for name in ("parts", "revisions"):
            shutil.copytree(blocks.ROOT / "assets" / name, self.folder / name)
        home = pathlib.Path(self._temporary.name) / "home"
        home.mkdir()
        bin_folder = program().parent
        self.environment = {
            **os.environ, "HOME": str(home), "XDG_STATE_HOME": str(home / "state"), "NO_COLOR": "1",
            "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(bin_folder.parent / "python"),
            "PATH": os.pathsep.join([str(bin_folder), str(blocks.ROOT / "assets" / "batch"),
                                     os.path.dirname(sys.executable), os.environ["PATH"]])}
        for name in ("DISPLAY", "WAYLAND_DISPLAY"):
            self.environment.pop(name, None)
        self.status = 0

    def close(self):
        self._temporary.cleanup()

    def _run(self, words, folder):
        done = subprocess.run(words, cwd=folder, env=self.environment, stdin=subprocess.DEVNULL, text=True,
                              capture_output=True, timeout=TIME_LIMIT_S, check=False)
        self.status, self.errors = done.returncode, done.stderr
        return done.stdout

    def command(self, text):
        """Standard output of a shell command; `$?` is the exit code of the one before."""
        # A window is drawn into a picture, since there may be no display.
        if text.startswith("moldlight view") and "--screenshot" not in text and "--save-settings" not in text:
            text += " --quick-sweep off --size 640x480 --screenshot window.png"
        return self._run(["bash", "-c", f"(exit {self.status})\n{text}"], self.folder)

    def python(self, text):
        return self._run([sys.executable, "-c", text], self.folder)

    def made(self, text):
        """What a command prints that writes a part of a page; it runs where the sources are."""
        return self._run(["bash", "-c", text], blocks.ROOT)
