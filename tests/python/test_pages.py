"""Draft, comparisons, pages, what is read from memory, pickling, and other packages' meshes."""

import copy
import io
import os
import pathlib
import pickle
import sys
import tempfile
import types
import unittest
from unittest import mock

import moldlight
import numpy as np
import support

LID = support.ASSETS / "enclosure_lid.stl"
CLIP = support.ASSETS / "cable_clip.stl"
REVISION = support.SOURCE / "assets" / "revisions" / "enclosure_lid_b.stl"
STEP = support.SOURCE / "tests" / "data" / "pin_and_block_inch.step"


def notched(depth):
    """A box with a groove of this depth in its side: an undercut along z."""
    profile = [(0, 0), (10, 0), (10, 4), (10 - depth, 4), (10 - depth, 6), (10, 6), (10, 10), (0, 10)]
    fan = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 7), (4, 5, 6), (4, 6, 7)]
    n = len(profile)
    vertices = [(x, y, z) for y in (0, 8) for x, z in profile]
    faces = list(fan) + [(c + n, b + n, a + n) for a, b, c in fan]
    faces += [face for k in range(n) for face in ((k, k + n, (k + 1) % n), ((k + 1) % n, k + n, (k + 1) % n + n))]
    return np.array(vertices, float), np.array(faces)


class Verdicts(unittest.TestCase):
    def test_it_has_attributes_and_is_the_reports_dict(self):
        part = moldlight.Part(*notched(2), unit="mm")
        for found in (part.classify("z"), part.actions("z"), part.mold("z"), part.draft("z", required_draft_deg=1),
                      part.sweep(directions=10, top=1), part.pieces()):
            noted = found.to_dict()["verdict"]
            self.assertEqual((found.verdict.state, found.verdict.sentence), (noted["state"], noted["sentence"]))
            self.assertEqual(found.verdict, noted)
            self.assertEqual(found.verdict.undercuts, noted.get("undercuts"))
        with self.assertRaises(AttributeError):
            part.classify("z").verdict.colour
        self.assertEqual(part.classify("z").verdict.undercuts, 1)


class Draft(unittest.TestCase):
    def test_it_is_what_classify_reports(self):
        part = moldlight.Part.read(LID, unit="mm")
        found = part.draft("z", required_draft_deg=1.5)
        noted = support.report("classify", LID, "--unit", "mm", "--direction", "z", "--required-draft", "1.5")
        self.assertEqual(support.untimed(found.to_dict()), support.untimed(noted))
        self.assertEqual(found.walls, noted["draft"]["faces"])
        self.assertGreater(len(found.walls), 10)
        self.assertIn(str(len([wall for wall in found.walls if wall["side"] == "core"])), found.sentence)

    def test_finishes(self):
        part = moldlight.Part(*support.box())
        noted = part.draft("z", finish={"*": "draft 2"})
        self.assertEqual([one["finish"] for one in noted.finishes], ["draft 2"])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "finish.csv"
            file.write_text("*,draft 2\n", encoding="utf-8")
            self.assertEqual(support.untimed(part.draft("z", finish=file).to_dict()), support.untimed(noted.to_dict()))
        with self.assertRaisesRegex(moldlight.Error, "shiny"):
            part.draft("z", finish={0: "shiny"})
        with self.assertRaisesRegex(moldlight.UsageError, "required_draft_deg"):
            part.draft("z")


class Compare(unittest.TestCase):
    def test_it_is_what_the_command_reports(self):
        a, b = (moldlight.Part.read(file, unit="mm") for file in (LID, REVISION))
        found = moldlight.compare(a, b, "z", actions=False)
        noted = support.report("compare", LID, REVISION, "--unit", "mm", "--direction", "z", "--actions", "off")
        self.assertEqual(support.untimed(found.to_dict()), support.untimed(noted))
        self.assertEqual(found.verdict.sentence, noted["verdict"])
        self.assertEqual(len(found.places), len(noted["places"]))
        self.assertEqual(found.figures["undercut"]["after"], noted["regions"]["b"]["undercut"])
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual(support.untimed(again.to_dict()), support.untimed(noted))

    def test_small_parts(self):
        a, b = moldlight.Part(*notched(2), unit="mm"), moldlight.Part(*notched(3), unit="mm")
        for direction in ("z", (0, 0, 2), "best", "each"):
            found = moldlight.compare(a, b, direction)
            self.assertIsInstance(found.verdict.state, str)
            self.assertEqual(found.verdicts["b"].state, found.verdict.state)
        found = moldlight.compare(a, b, "z")
        self.assertEqual(len(found.met("undercut > +1%, undercut > 90%")), 1)
        with self.assertRaisesRegex(moldlight.UsageError, "beauty"):
            found.met("beauty > 1")
        with self.assertRaises(TypeError):
            moldlight.compare(a, "part.stl")
        self.assertEqual(moldlight.compare(a, a, "z").met("undercut > +0"), [])


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = moldlight.Part.read(CLIP, unit="mm").classify("y", tau_deg=2)
        cls.page = cls.found.to_html()

    def test_the_page_is_the_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "page.html"
            support.program("classify", CLIP, "--unit", "mm", "--direction", "y", "--tau", "2", "--html", file,
                            "--revision", "C", "--json", pathlib.Path(folder) / "found.json")
            noted = file.read_text(encoding="utf-8")
        page = self.found.to_html(revision="C")

        def lines(text):  # but for the line that repeats it
            return [line for line in text.splitlines() if 'class="command"' not in line]

        self.assertEqual(lines(page), lines(noted))
        self.assertIn("part.classify(&#39;y&#39;, tau_deg=2)", page)

    def test_where_it_goes(self):
        page = self.page
        text, data = io.StringIO(), io.BytesIO()
        self.assertIsNone(self.found.to_html(text))
        self.assertIsNone(self.found.to_html(data))
        with tempfile.NamedTemporaryFile("w+", encoding="utf-8") as file:
            self.found.to_html(file)
            file.seek(0)
            self.assertEqual(file.read(), page)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "page.html"
            self.assertIsNone(self.found.to_html(file))
            self.assertEqual(file.read_text(encoding="utf-8"), page)
            with self.assertRaises(moldlight.FileError):
                self.found.to_html(pathlib.Path(folder) / "none" / "page.html")
        self.assertEqual((text.getvalue(), data.getvalue().decode()), (page, page))
        self.assertGreater(len(self.found.to_html(live=True)), len(page))

    def test_pdf(self):
        data = io.BytesIO()
        self.found.to_pdf(data)
        self.assertTrue(data.getvalue().startswith(b"%PDF-"))
        self.assertEqual(self.found.to_pdf(), data.getvalue())
        self.assertNotEqual(self.found.to_pdf(paper="letter"), data.getvalue())
        for keywords, text in (({"paper": "a3"}, "^paper: 'a3'"), ({"date": "today"}, "^date: 'today'")):
            with self.assertRaisesRegex(moldlight.UsageError, text):
                self.found.to_pdf(**keywords)

    def test_every_result_that_the_command_has_a_page_of(self):
        part = moldlight.Part(*notched(2), unit="mm")
        other = moldlight.Part(*notched(3), unit="mm")
        for found, word in ((part.mold("z"), "Mold"), (part.draft("z", required_draft_deg=1), "Draft"),
                            (moldlight.compare(part, other, "z"), "gone"), (part.pieces(), "Seams")):
            self.assertIn(word, found.to_html(), type(found))
        for made in (moldlight.Actions, moldlight.Sweep):
            self.assertTrue(callable(made.to_html) and callable(made.to_pdf))

    def test_notebooks(self):
        picture = self.found._repr_png_()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "picture.png"
            file.write_bytes(picture)
            self.assertEqual(support.png_pixels(file).tolist(),
                             self.found.picture(size=(800, 500))[..., :support.png_pixels(file).shape[2]].tolist())
        frame = self.found._repr_html_()
        self.assertTrue(frame.startswith("<iframe srcdoc=") and frame.endswith("</iframe>"))
        self.assertEqual(frame.count('"'), 10)  # the page's own are escaped
        table = moldlight.Part(*support.box(), name="<b>")._repr_html_()
        self.assertIn("&lt;b&gt;", table)
        self.assertIn(">12<", table)


class Reading(unittest.TestCase):
    def test_bytes_and_what_can_be_read(self):
        noted = moldlight.Part.read(LID)
        data = LID.read_bytes()
        for given in (data, bytearray(data), memoryview(data), io.BytesIO(data), os.fspath(LID)):
            part = moldlight.Part.read(given)
            self.assertEqual(part.faces.tolist(), noted.faces.tolist())
        with open(LID, "rb") as file:
            self.assertEqual(moldlight.Part.read(file).file, str(LID))
        self.assertEqual(moldlight.Part.read(data).format, noted.format)

    def test_a_file_that_is_open_as_text(self):
        with open(LID, encoding="utf-8") as file, self.assertRaisesRegex(moldlight.UsageError, "mode 'rb'"):
            moldlight.Part.read(file)

    def test_text(self):
        lines = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
        self.assertTrue(moldlight.Part.read(io.StringIO(lines)).health.closed)

    def test_the_format_where_nothing_else_says_it(self):
        text = b"# from a tool\n\n1 2 3 4 5\n"
        with self.assertRaisesRegex(moldlight.FileError, "^bytes: byte 0: is not a part file"):
            moldlight.Part.read(text)
        with self.assertRaisesRegex(moldlight.FileError, "^bytes: line 3"):
            moldlight.Part.read(text, format="off")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "part.dat"
            file.write_bytes(text)
            with self.assertRaisesRegex(moldlight.FileError, "line 3"):
                moldlight.Part.read(file, format="OFF")
        with self.assertRaisesRegex(moldlight.UsageError, "^format: 'doc' is none of STL"):
            moldlight.Part.read(text, format="doc")

    def test_failures_are_one_line(self):
        class Broken:
            def read(self):
                return 3

        for given, error, text in ((b"", moldlight.FileError, "empty"), (Broken(), moldlight.UsageError, "neither"),
                                   (3, moldlight.UsageError, "int"), (b"solid x\n", moldlight.FileError, "bytes")):
            with self.assertRaisesRegex(error, text) as raised:
                moldlight.Part.read(given)
            self.assertEqual(len(str(raised.exception).splitlines()), 1)

    def test_step(self):
        try:
            noted = moldlight.Part.read(STEP)
        except moldlight.FileError as error:
            self.skipTest(str(error))
        for given in (STEP.read_bytes(), io.StringIO(STEP.read_text(encoding="utf-8"))):
            part = moldlight.Part.read(given)
            self.assertEqual(part.vertices.tolist(), noted.vertices.tolist())
            self.assertEqual(part.face_of_facet.tolist(), noted.face_of_facet.tolist())


class Copies(unittest.TestCase):
    def check(self, found):
        again = pickle.loads(pickle.dumps(found))
        self.assertIs(type(again), type(found))
        self.assertEqual(support.untimed(again.to_dict()), support.untimed(found.to_dict()))
        self.assertIs(copy.copy(found), found)
        self.assertIs(copy.deepcopy(found), found)
        return again

    def test_parts(self):
        for part in (moldlight.Part.read(LID, unit="mm"), moldlight.Part(*support.box(), name="é", repair="full")):
            again = self.check(part)
            for name in ("vertices", "faces", "facet_areas", "facet_normals"):
                self.assertEqual(getattr(again, name).tolist(), getattr(part, name).tolist())
            self.assertEqual((again.file, again.unit, again.repairs, again.warnings),
                             (part.file, part.unit, part.repairs, part.warnings))
            self.assertEqual(again.classify("z").areas, part.classify("z").areas)

    def test_a_part_that_was_inside_out_says_so_still(self):
        vertices, faces = support.box()
        part = moldlight.Part(vertices, faces[:, ::-1])
        self.assertEqual(len(part.warnings), 1)
        self.assertEqual(self.check(part).warnings, part.warnings)

    def test_results(self):
        part = moldlight.Part(*notched(2), unit="mm")
        for found in (part.classify(np.array([0.1, 0, 1]), tau_deg=2), part.actions("z", clearance_mm=1.0),
                      part.mold("z", actions=True), part.draft("z", required_draft_deg=2),
                      part.pieces(), part.sweep(directions=10, top=1)):
            self.check(found)

    def test_the_direction_is_that_of_the_call(self):
        direction = np.array([0.0, 0.0, 1.0])
        found = moldlight.Part(*notched(2)).classify(direction, progress=lambda stage, share: True)
        direction[:] = (1, 0, 0)
        self.assertEqual(pickle.loads(pickle.dumps(found)).direction, (0, 0, 1))

    def test_a_sweep_that_was_ended_is_not_pickled(self):
        part = moldlight.Part.read(LID)
        found = part.sweep(thorough=True, directions=100000, progress=lambda stage, share: False)
        with self.assertRaisesRegex(moldlight.Error, "ended early"):
            pickle.dumps(found)

    def test_what_holds_nothing(self):
        for made in (moldlight.Part, moldlight.Classification, moldlight.Comparison, moldlight.Draft):
            empty = made.__new__(made)
            for use in (pickle.dumps, repr, lambda empty: empty.to_json()):
                with self.assertRaises(TypeError):
                    use(empty)

    def test_a_damaged_pickle(self):
        part = moldlight.Part(*support.box())
        state = part.__getstate__()
        vertices, faces = state[0]
        for broken in ((vertices, faces + 100), (vertices, faces[:3])):
            with self.assertRaises(moldlight.UsageError):
                moldlight.Part.__new__(moldlight.Part).__setstate__((broken, *state[1:]))


class Packages(unittest.TestCase):
    """What other packages are given; stand-ins keep it."""

    def setUp(self):
        self.part = moldlight.Part(*notched(2))
        self.found = self.part.classify("z")

    def stand_in(self, name, kind):
        module = types.ModuleType(name)
        setattr(module, kind, lambda *given, **named: (given, named))
        return mock.patch.dict(sys.modules, {name: module})

    def test_trimesh(self):
        with self.stand_in("trimesh", "Trimesh"):
            (vertices, faces), named = self.part.to_trimesh()
            self.assertEqual((vertices.tolist(), faces.tolist(), named["process"]),
                             (self.part.vertices.tolist(), self.part.faces.tolist(), False))
            (vertices, faces), named = self.found.to_trimesh(palette="safe")
        split = self.found.split_mesh()
        self.assertEqual(faces.tolist(), split.faces.tolist())
        colours = moldlight.REGION_COLOURS["safe"]
        self.assertEqual([tuple(colour) for colour in named["face_colors"]], [colours[k] for k in split.regions])
        self.assertEqual(named["face_attributes"]["facet"].tolist(), split.facets.tolist())

    def test_meshio(self):
        with self.stand_in("meshio", "Mesh"):
            (vertices, cells), named = self.found.to_meshio()
            (_, part_cells), part_named = self.part.to_meshio()
        split = self.found.split_mesh()
        self.assertEqual((cells[0][0], cells[0][1].tolist()), ("triangle", split.faces.tolist()))
        self.assertEqual(named["cell_data"]["region"][0].tolist(), split.regions.tolist())
        self.assertEqual((part_cells[0][1].tolist(), part_named["cell_data"]), (self.part.faces.tolist(), {}))

    def test_a_package_that_is_not_there(self):
        for name in ("trimesh", "meshio"):
            with mock.patch.dict(sys.modules, {name: None}):
                for owner in (self.part, self.found):
                    with self.assertRaisesRegex(ImportError, f"needs the package {name}.*pip install {name}"):
                        getattr(owner, f"to_{name}")()

    def test_pyvista(self):
        for mesh in (self.part, self.found.split_mesh()):
            flat = mesh.pyvista_faces
            self.assertEqual((flat.ndim, flat.dtype), (1, np.int64))
            self.assertEqual(flat.reshape(-1, 4)[:, 1:].tolist(), mesh.faces.tolist())
            self.assertEqual(set(flat[::4]), {3})


if __name__ == "__main__":
    unittest.main()
