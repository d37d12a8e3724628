"""The areas of the four regions of every part in a folder, as a table, several parts at a time.

    python3 regions_of_a_folder.py parts z areas.csv
"""

import csv
import pathlib
import sys

import moldlight

ENDINGS = {".stl", ".obj", ".ply", ".off", ".3mf", ".step", ".stp", ".iges", ".igs"}


def main(folder, direction, table):
    paths = sorted(path for path in pathlib.Path(folder).iterdir() if path.suffix.lower() in ENDINGS)
    with open(table, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["part", *moldlight.REGIONS, "uncertainty", "unit", "remarks"])
        for path, part, found, error in moldlight.batch(paths, "classify", direction=direction):
            if error:
                writer.writerow([path.name, *[""] * (len(moldlight.REGIONS) + 2), error])
                continue
            areas = [found.areas[region] for region in moldlight.REGIONS]
            writer.writerow([path.name, *areas, found.undercut_uncertainty, part.unit, "; ".join(found.warnings)])


if __name__ == "__main__":
    main(*sys.argv[1:])
