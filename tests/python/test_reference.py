"""The module's figures are the program's, to the last digit: rows of the reference, and reports of each kind."""

import csv
import json
import os
import tempfile
import unittest

import moldlight
import numpy as np
import support

LID = support.ASSETS / "enclosure_lid.stl"
CLIP = support.ASSETS / "cable_clip.stl"


class Reference(unittest.TestCase):
    def setUp(self):
        self.shared = support.shared_folder()
        if self.shared is None:
            self.skipTest("the folder of real parts is not there")

    def test_every_row_is_as_known_and_the_programs_report(self):
        with open(self.shared / "reference" / "areas.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertGreaterEqual(len(rows), 95)
        parts = {}
        for number, row in enumerate(rows):
            path = self.shared / "parts" / row["part"]
            part = parts.setdefault(row["part"], moldlight.Part.read(path))
            direction = ",".join(row[axis] for axis in ("dx", "dy", "dz"))
            with self.subTest(part=row["part"], direction=direction):
                found = part.classify([float(row[axis]) for axis in ("dx", "dy", "dz")],
                                      tau_deg=float(row["tau_deg"]), tolerance=float(row["lateral_tolerance"]))
                self.assertAlmostEqual(found.areas["undercut"], float(row["undercut"]),
                                       delta=1e-6 * float(row["total"]))
                if number % 3 != 0:  # a process each
                    continue
                noted = support.report("classify", path, "--direction", direction, "--tau", row["tau_deg"],
                                      "--tolerance", row["lateral_tolerance"])
                self.assertEqual(support.untimed(found.to_dict()), support.untimed(noted))
                self.assertEqual(support.untimed(json.loads(found.to_json())), support.untimed(noted))
                for region, area in found.areas.items():
                    self.assertEqual(area, noted["areas"][region])


class Reports(unittest.TestCase):
    """The reports of every command on shipped parts."""

    def check(self, found, *arguments):
        self.assertEqual(support.untimed(found.to_dict()), support.untimed(support.report(*arguments)))
        self.assertEqual(json.loads(found.to_json()), found.to_dict())

    def test_info(self):
        self.check(moldlight.Part.read(LID, unit="mm"), "info", LID, "--unit", "mm")

    def test_pieces(self):
        part = moldlight.Part.read(LID, unit="mm")
        found = part.pieces(fixed="z", eps=0.006)
        self.check(found, "pieces", LID, "--unit", "mm", "--fixed", "z", "--eps", "0.006")
        self.assertEqual(found.count, len(found.directions))
        vertices, faces = found.mesh()
        self.assertEqual(len(faces), len(found.piece_of_face))
        self.assertLess(faces.max(), len(vertices))
        self.assertEqual(len(found.seam_lines()), len(found.to_dict()["seams"]))
        self.assertIsNone(found.to_dict()["solids"])
        with self.assertRaisesRegex(moldlight.Error, "solids=True"):
            found.bodies

    def test_pieces_as_solids(self):
        part = moldlight.Part.read(CLIP, unit="mm")
        with tempfile.TemporaryDirectory() as folder:
            found = part.pieces(solids=True, margin=8)
            files = found.write(folder, as_3mf=True, as_step=True)
            self.check(found, "pieces", CLIP, "--unit", "mm", "--margin", "8", "--html",
                       os.path.join(folder, "pieces.html"))
            self.assertTrue(all(os.path.getsize(name) > 84 for name in files), files)
            self.assertTrue(os.path.exists(os.path.join(folder, "mold.3mf")))
            self.assertTrue(os.path.exists(os.path.join(folder, "mold.step")))
        self.assertEqual(found.refusal, "")
        self.assertEqual([body["name"] for body in found.bodies],
                         [body["name"] for body in found.to_dict()["solids"]["bodies"]])
        self.assertTrue(all(body["closed"] for body in found.bodies))
        self.assertEqual(found.frame.shape, (4, 4))
        self.assertIn("Open the mold", found.to_html())

    def test_classify_by_maps_with_draft(self):
        part = moldlight.Part.read(LID, unit="in", repair="full")
        self.check(part.classify("-y", readout="samples", resolution=512, samples=20000, compare_maps=True,
                                 required_draft_deg=1.5),
                   "classify", LID, "--unit", "in", "--repair", "full", "--direction=-y", "--readout", "samples",
                   "--resolution", "512", "--samples", "20000", "--compare-maps", "--required-draft", "1.5")

    def test_best_direction(self):
        self.check(moldlight.Part.read(CLIP).classify("best"), "classify", CLIP, "--direction", "best")

    def test_sweep_with_proof(self):
        part = moldlight.Part.read(CLIP, unit="mm")
        found = part.sweep(directions=50, top=3, candidates=["axis", "uniform"], prove=True,
                           user_directions=["x", (1, 2, 3)], actions=True, clearance_mm=2)
        self.check(found, "sweep", CLIP, "--unit", "mm", "--directions", "50", "--top", "3", "--candidates",
                   "axis,uniform", "--prove", "--direction", "x", "--direction", "1,2,3", "--actions", "--clearance",
                   "2")
        self.assertTrue(found.complete)
        self.assertEqual(list(found.best_direction), found.to_dict()["candidates"][0]["direction"])
        self.assertEqual(len(found.scored_undercut), found.to_dict()["evaluated"])

    def test_actions(self):
        part = moldlight.Part.read(LID, unit="mm")
        found = part.actions("z", lifter_angle_deg=5)
        self.check(found, "actions", LID, "--unit", "mm", "--direction", "z", "--lifter-angle", "5")
        self.assertEqual(found.actions, found.to_dict()["actions"])
        bodies = found.bodies()
        self.assertGreater(len(bodies), 0)
        for body in bodies:
            self.assertTrue(moldlight.Part(body["vertices"], body["faces"]).health.closed)

    def test_mold(self):
        part = moldlight.Part.read(LID, unit="mm")
        found = part.mold("z", fill_undercut=True, shrink_pct=0.6, actions=True)
        self.check(found, "mold", LID, "--unit", "mm", "--direction", "z", "--fill-undercut", "--shrink", "0.6",
                   "--actions")
        self.assertEqual(found.refusal, "")
        volumes = {}
        for body in found.bodies:
            self.assertTrue(body["closed"])
            volumes[body["name"]] = moldlight.Part(body["vertices"], body["faces"]).health.volume
        halves = found.to_dict()["halves"]
        self.assertAlmostEqual(sum(volumes.values()) + halves["part_volume"] + halves["specks_volume"],
                               halves["block_volume"], delta=1e-5 * halves["block_volume"])
        with tempfile.TemporaryDirectory() as folder:
            files = found.write(folder + "/out", as_3mf=True)
            self.assertEqual(len(files), len(found.bodies))
            found.write_line(folder + "/line.dxf")
            program_folder = folder + "/program"
            support.program("mold", LID, "--unit", "mm", "--direction", "z", "--fill-undercut", "--shrink", "0.6",
                            "--actions", "--out", program_folder, "--lines", folder + "/program.dxf", "--quiet")
            for name in (file.rsplit("/", 1)[1] for file in files):
                with open(f"{folder}/out/{name}", "rb") as own, open(f"{program_folder}/{name}", "rb") as noted:
                    self.assertEqual(own.read(), noted.read(), name)
            with open(folder + "/line.dxf", "rb") as own, open(folder + "/program.dxf", "rb") as noted:
                self.assertEqual(own.read(), noted.read())

    def test_mold_that_is_refused(self):
        found = moldlight.Part.read(LID, unit="mm").mold("z")
        self.assertIn("fill_undercut", found.refusal)
        with self.assertRaisesRegex(moldlight.Error, "undercuts hide"):
            found.write("nowhere")

    def test_arrays_give_what_the_file_gives(self):
        read = moldlight.Part.read(LID, unit="mm")
        made = moldlight.Part(read.vertices, read.faces, unit="mm")
        direction = (0.3, -0.4, 0.6)
        noted, found = (support.untimed(part.classify(direction).to_dict()) for part in (read, made))
        self.assertEqual((found["part"].pop("file"), found["part"].pop("format")), ("", "arrays"))
        del noted["part"]["file"], noted["part"]["format"]
        self.assertEqual(found, noted)

    def test_step_has_its_cad_faces(self):
        shared = support.shared_folder()
        if shared is None:
            self.skipTest("the folder of real parts is not there")
        step = shared / "parts" / "m5_watch_bottom.stp"
        try:
            part = moldlight.Part.read(step)
        except moldlight.FileError as error:
            self.skipTest(str(error))
        found = part.classify("z")
        self.check(found, "classify", step, "--direction", "z")
        numbers, areas = found.face_areas
        noted = found.to_dict()["faces"]
        self.assertEqual(list(numbers), [face["face"] for face in noted])
        self.assertEqual(areas[:, 3].tolist(), [face["undercut"] for face in noted])
        self.assertEqual(len(part.face_of_facet), len(part.faces))

    def test_pictures(self):
        part = moldlight.Part.read(CLIP, unit="mm")
        size, kind = (400, 300), ("--size", "400x300", "--theme", "dark")
        with tempfile.TemporaryDirectory() as folder:
            for name, found, arguments in (("classify", part.classify("z"), ("--view", "iso", "--palette", "safe")),
                                           ("actions", part.actions("z"), ("--view", "iso", "--palette", "safe")),
                                           ("mold", part.mold("y"), ("--view", "iso", "--palette", "safe"))):
                path = f"{folder}/{name}.png"
                support.program(name, CLIP, "--unit", "mm", "--direction", "y" if name == "mold" else "z", "--image",
                                path, "--quiet", *kind, *arguments)
                own = found.picture(size=size, theme="dark", view="iso", palette="safe")
                self.assertEqual((own.shape, own.dtype), ((300, 400, 4), np.uint8))
                noted = support.png_pixels(path)
                differing = np.abs(own[..., :3].astype(int) - noted[..., :3]).max(axis=2) > 2
                self.assertLess(differing.mean(), 1e-3, name)
            sweep = part.sweep(directions=20, top=1, thorough=True)
            self.assertEqual(sweep.picture(size="300x200").shape, (200, 300, 4))


if __name__ == "__main__":
    unittest.main()
