"""The areas of the four regions of every part in a folder, as a table, several parts at a time.

    python3 regions_of_a_folder.py parts z areas.csv
"""

import csv
import os
import pathlib
import sys
from concurrent.futures import ThreadPoolExecutor

import moldlight

ENDINGS = {".stl", ".obj", ".ply", ".off", ".3mf", ".step", ".stp"}


def row(path, direction):
    """What the table says of a part; of one that cannot be read, why."""
    try:
        part = moldlight.Part.read(path)
        found = part.classify(direction)
    except moldlight.Error as error:
        return [path.name] + [""] * (len(moldlight.REGIONS) + 2) + [str(error)]
    areas = [found.areas[region] for region in moldlight.REGIONS]
    return [path.name, *areas, found.undercut_uncertainty, part.unit, "; ".join(found.warnings)]


def main(folder, direction, table):
    paths = sorted(path for path in pathlib.Path(folder).iterdir() if path.suffix.lower() in ENDINGS)
    # Python's lock is released while moldlight computes.
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        rows = list(threads.map(lambda path: row(path, direction), paths))
    with open(table, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["part", *moldlight.REGIONS, "uncertainty", "unit", "remarks"])
        writer.writerows(rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
