"""The best parting direction of a part, what it costs in side actions, and a picture of it.

    python3 best_direction.py part.stl best.ppm
"""

import sys

import moldlight


def show(stage, share):
    """Ctrl-C ends the sweep within a second; to return False would, too, with what is done by then."""
    print(f"\r{stage} {100 * share:.0f} %   ", end="", file=sys.stderr)


def main(path, picture):
    part = moldlight.Part.read(path)
    sweep = part.sweep(directions=200, top=3, progress=show)
    print(file=sys.stderr)
    for remark in sweep.remarks:
        print(remark)

    direction = sweep.best_direction
    print("best direction", direction)
    for action in part.actions(direction).actions:
        print(f"{action['kind']} along {action['direction']}, travel {action['travel']}")

    image = part.classify(direction).picture(size=(800, 500), theme="light")
    height, width, _ = image.shape
    with open(picture, "wb") as file:
        file.write(f"P6\n{width} {height}\n255\n".encode())
        file.write(image[..., :3].tobytes())


if __name__ == "__main__":
    main(*sys.argv[1:])
