"""A part made of NumPy arrays: a channel with a lip, under which the mold's halves do not reach.

    python3 channel_from_arrays.py
"""

import moldlight
import numpy as np

# The section, counter-clockwise in x and z, in millimetres: walls and floor of 10, a lip of 2 over the floor.
SECTION = np.array([(0, 0), (30, 0), (30, 20), (20, 20), (20, 10), (10, 10), (10, 15), (12, 15), (12, 20), (0, 20)])
END = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 4, 5), (0, 5, 6), (0, 6, 9), (6, 8, 9), (6, 7, 8)])
LENGTH = 40.0


def channel():
    """Vertices and faces of the section, drawn out along y."""
    count = len(SECTION)
    ends = [np.insert(SECTION.astype(float), 1, y, axis=1) for y in (0.0, LENGTH)]
    here = np.arange(count)
    following = np.roll(here, -1)
    walls = [(here, here + count, following), (following, here + count, following + count)]
    faces = [END, END[:, ::-1] + count] + [np.stack(wall, axis=1) for wall in walls]
    return np.concatenate(ends), np.concatenate(faces)


def main():
    part = moldlight.Part(*channel(), unit="mm", name="channel")
    found = part.classify("z")
    for region, area in found.areas.items():
        print(f"{region} {area:g} mm2")
    print("the checks agree:", found.identity["agrees"])

    split = found.split_mesh()
    print("closed split mesh:", moldlight.Part(split.vertices, split.faces).health.closed)
    undercut = split.faces[split.regions == moldlight.REGIONS.index("undercut")]
    corners = split.vertices[undercut].reshape(-1, 3)
    print("the undercut is between", corners.min(axis=0), "and", corners.max(axis=0))


if __name__ == "__main__":
    main()
