# Run where nothing but Python, NumPy and the wheel is: figures of a shipped part and of a STEP file; with "draw", after some
# OpenGL was installed, a picture and a paper.
import hashlib
import sys

import moldlight

part = moldlight.Part.read("/cable_clip.stl", unit="mm")
found = part.classify("y")
assembly = moldlight.Part.read("/assembly.step")
print("try:", found.verdict.sentence, "|", len(assembly.faces), "facets of the STEP file")
assert abs(sum(found.areas.values()) - found.total_area) < 1e-6 * found.total_area
assert len(part.actions("z").actions) >= 1 and len(part.mold("y").bodies) >= 2
# The interpreter's own libraries are not exchanged for those of the wheel.
assert len(hashlib.sha256(b"").hexdigest()) == 64
if sys.argv[1:] == ["draw"]:
    image = found.picture(size=(640, 480))
    assert image.shape == (480, 640, 4) and image.std() > 5
    found.to_pdf("/clip.pdf")
else:
    try:
        found.picture(size=(64, 48))
        sys.exit("try: a picture without OpenGL")
    except moldlight.Error as failure:
        assert "libegl1" in str(failure)
