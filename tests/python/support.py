"""What the tests of the Python module share: parts, the program, its reports and pictures."""

import json
import os
import pathlib
import struct
import subprocess
import zlib

import numpy as np

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
ASSETS = SOURCE / "assets" / "parts"
PROGRAM = os.environ.get("MOLDLIGHT_BINARY", "moldlight")


def shared_folder():
    """The folder of real parts and reference areas, which is no part of the project; None where there is none."""
    folder = pathlib.Path(os.environ.get("MOLDLIGHT_SHARED", SOURCE.parent / "shared"))
    return folder.resolve() if (folder / "parts").is_dir() else None


def program(*arguments):
    """Runs the program; its standard output."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.returncode}: {done.stderr.decode()}")
    return done.stdout


def report(*arguments):
    return json.loads(program(*arguments, "--json", "-"))


def untimed(value):
    """A report without what differs from run to run."""
    if isinstance(value, dict):
        return {key: untimed(item) for key, item in value.items() if key not in ("timings_ms", "elapsed_s")}
    return [untimed(item) for item in value] if isinstance(value, list) else value


def box(size=(4.0, 3.0, 2.0), at=(0.0, 0.0, 0.0)):
    """Vertices and faces of a box, outward."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
             (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    return np.array(corners, dtype=float) * np.array(size) + np.array(at), np.array(faces)


def png_pixels(path):
    """Height x width x channels of a PNG file of eight bits a channel, without interlacing."""
    data = pathlib.Path(path).read_bytes()
    place, packed, header = 8, b"", None
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + size]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        place += size + 12
    width, height, _, colour = header[:4]
    channels = {2: 3, 6: 4}[colour]
    stride = width * channels
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, stride + 1)
    above, lines = np.zeros(stride, np.uint8), []
    for row in rows:
        above = unfiltered(row[0], row[1:].copy(), above, channels)
        lines.append(above)
    return np.array(lines).reshape(height, width, channels)


def unfiltered(kind, line, above, channels):
    if kind == 2:
        return line + above
    if kind == 1:
        return np.add.accumulate(line.reshape(-1, channels), axis=0, dtype=np.uint8).reshape(-1)
    if kind in (3, 4):
        line, above = line.astype(int), above.astype(int)
        for i in range(len(line)):
            left = line[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            if kind == 3:
                guess = (left + above[i]) // 2
            else:
                guess = min((left, above[i], corner), key=lambda value: abs(left + above[i] - corner - value))
            line[i] = (line[i] + guess) % 256
    return line.astype(np.uint8)
