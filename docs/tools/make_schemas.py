#!/usr/bin/env python3
"""Writes a JSON Schema of each kind of report into docs/schemas: make_schemas.py [KIND…]

What a key may hold is found from reports: those of the commands of docs/json.md, and of the shipped parts along several
directions, with a part that is open, one without a unit and one that overlaps itself among them. What it means is taken
from the tables of that page, and so is that it may be null. Keys may be added at any time, so others are allowed.
"""

import json
import math
import sys

import blocks
import json_page
import runs

FOLDER = blocks.ROOT / "docs" / "schemas"
PARTS = ("enclosure_lid", "cable_clip", "bottle_cap", "tilted_bracket")
TYPES = {bool: "boolean", int: "integer", float: "number", str: "string", type(None): "null", dict: "object", list: "array"}
# Three facets of a tetrahedron; beside it two boxes of which one reaches into the other, and a coarse nut.
OPEN = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"


def boxes():
    text = ""
    for low, high in ((0, 10), (4, 14)):
        text += "".join(f"v {x} {y} {z}\n" for z in (low, high) for y in (low, high) for x in (low, high))
    for first in (1, 9):
        for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            text += f"f {first + a} {first + b} {first + c} {first + d}\n"
    return text


def nut():
    """A tube with a thread of so few facets that its core hits them as it turns."""
    around, lead, height = 16, 4, 16
    levels = height * around // lead

    def corner(number, level):
        z = lead * level / around
        phase = z / lead - number / around
        tooth = abs(2 * (phase - math.floor(phase + 0.5)))
        return 8 - 0.8 * min(1, z / 3, (height - z) / 3) * min(1, max(0, 2 * tooth - 0.5)), z

    rings = [[corner(number, level) for number in range(around)] for level in range(levels + 1)]
    rings += [[(14, height)] * around, [(14, 0)] * around]  # on outside, from the top down
    text = ""
    for ring in rings:
        for number, (radius, z) in enumerate(ring):
            angle = 2 * math.pi * number / around
            text += f"v {radius * math.cos(angle)} {radius * math.sin(angle)} {z}\n"
    for low in range(len(rings)):
        high = (low + 1) % len(rings)
        for number in range(around):
            following = (number + 1) % around
            a, b, c, d = (1 + ring * around + place for ring, place in
                          ((low, number), (low, following), (high, following), (high, number)))
            text += f"f {a} {c} {b}\nf {a} {d} {c}\n"
    return text


def commands(kind):
    """Command lines of a kind of report beside those of the page; each writes to `out.json`."""
    if kind == "info":
        return [f"moldlight info {part} --json out.json" for part in ("open.obj", "boxes.obj", "parts/bottle_cap.stl")]
    if kind in ("batch", "view"):  # as on the page
        return []
    if kind == "compare":
        return ["moldlight compare open.obj boxes.obj -d z --json out.json",
                "moldlight compare parts/bottle_cap.stl parts/bottle_cap.stl --unit mm -d each --json out.json",
                "moldlight compare parts/enclosure_lid.stl parts/cable_clip.stl --unit mm -d z --json out.json"]
    if kind == "pieces":
        return [f"moldlight pieces {part} --json out.json"
                for part in ("open.obj", "boxes.obj", "parts/tilted_bracket.stl --unit mm --out mold",
                             "parts/enclosure_lid.stl --unit mm --max 2 --fixed z --fixed -z --elongation 400",
                             "open.obj --max 1 --fixed x --elongation 300", "nut.obj --max 2 --fixed z --out mold")]
    flags = {"sweep": ["--top 3", "--top 2 --pressure 30", "--time-limit 0.05"],
             "mold": ["", "--actions", "--fill-undercut --out mold --registration"],
             "classify": ["", "--readout samples", "--required-draft 2"], "actions": ["", "--strip-strain 0"]}
    lines = []
    for part in [*(f"parts/{name}.stl --unit mm" for name in PARTS), "open.obj", "boxes.obj --repair union", "boxes.obj", "nut.obj"]:
        for more in flags[kind]:
            for direction in ("",) if kind == "sweep" else ("-d z", "-d 0.2,0.3,1", "-d best"):
                lines.append(f"moldlight {kind} {part} {direction} {more} --json out.json")
    return lines


def all_reports(session, heading, consoles):
    found = json_page.reports(session, consoles)
    (session.folder / "open.obj").write_text(OPEN, encoding="utf-8")
    (session.folder / "boxes.obj").write_text(boxes(), encoding="utf-8")
    (session.folder / "nut.obj").write_text(nut(), encoding="utf-8")
    for line in commands(heading.split(".")[1].split("/")[0]):
        (session.folder / "out.json").unlink(missing_ok=True)
        session.command(line)
        if (session.folder / "out.json").exists():
            found.append(json.loads((session.folder / "out.json").read_text(encoding="utf-8")))
        elif session.status not in (2, 3):
            raise RuntimeError(f"{line}: exit code {session.status}: {session.errors}")
    return found


def meaning_of(path, keys):
    """That of the key, or of the group `a.*` it belongs to."""
    if path in keys:
        return keys[path]
    groups = [key for key in keys if key.endswith(".*") and path == key[:-2]]
    return keys[groups[0]] if groups else ""


def is_open(path, keys):
    """Whether the page lists a group `a.*` whole, so that what is in it may differ."""
    return f"{path}.*" in keys or path == "verdict.actions" or path.endswith(".verdict.actions")


def schema_of(values, path, keys):
    """What all of these values have in common."""
    types = {TYPES[type(value)] for value in values}
    if "number" in types:
        types.discard("integer")
    meaning = meaning_of(path, keys)
    if "null" in meaning or types == {"null"}:
        types.add("null")
    schema = {}
    if types and types != {"null"}:  # of what is null in all of them nothing is known
        schema["type"] = sorted(types)[0] if len(types) == 1 else sorted(types)
    if meaning:
        schema["description"] = meaning
    objects = [value for value in values if isinstance(value, dict)]
    if objects:
        names = list(dict.fromkeys(name for value in objects for name in value))
        schema["properties"] = {
            name: schema_of([value[name] for value in objects if name in value],
                            f"{path}.{name}" if path else name, keys) for name in names}
        required = [name for name in names if all(name in value for value in objects)]
        if required and not is_open(path, keys):
            schema["required"] = required
    items = [item for value in values if isinstance(value, list) for item in value]
    if items:
        schema["items"] = schema_of(items, f"{path}[]", keys)
    return schema


def main(kinds):
    FOLDER.mkdir(exist_ok=True)
    part_keys = {}
    for heading, consoles, keys in json_page.sections():
        if not heading.startswith("moldlight."):
            part_keys = {f"part.{key}": meaning for key, meaning in keys.items()}
            continue
        if kinds and heading.split(".")[1].split("/")[0] not in kinds:
            continue
        session = runs.Session()
        found = all_reports(session, heading, consoles)
        session.close()
        schema = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": heading}
        schema.update(schema_of(found, "", {**part_keys, **keys}))
        schema["properties"]["schema"] = {"const": heading}
        file = FOLDER / (heading.replace("/", "-") + ".schema.json")
        file.write_text(json.dumps(schema, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        print(f"{file.relative_to(blocks.ROOT)}: of {len(found)} reports")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
