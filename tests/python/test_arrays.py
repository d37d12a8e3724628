"""Arrays of every layout mean the same; what makes no sense is refused in words; nothing ends the interpreter."""

import os
import pathlib
import random
import subprocess
import sys
import unittest

import moldlight
import numpy as np
import support

CALLS = int(os.environ.get("MOLDLIGHT_PYTHON_CALLS", "300"))
TELLING = (moldlight.Error, TypeError, MemoryError)


class WithoutInit(unittest.TestCase):
    """Objects that no __init__ has filled raise, whatever is asked of them."""

    def test_every_member_of_every_class(self):
        asked = 0
        for name in ("Part", "Health", "Classification", "SplitMesh", "Border", "Actions", "Mold", "Sweep",
                     "Draft", "Comparison", "Pieces"):
            made = getattr(moldlight, name)
            for member in [*dir(made), "__repr__"]:
                if member.startswith("_") and member != "__repr__":
                    continue
                if isinstance(made.__dict__.get(member), staticmethod) or member == "__repr__" and member not in made.__dict__:
                    continue
                empty = made.__new__(made)
                with self.assertRaises((TypeError, RuntimeError), msg=f"{name}.{member}"):
                    found = getattr(empty, member)
                    found("z") if member in ("classify", "actions", "draft", "mold", "picture", "save", "met") else found()
                asked += 1
        self.assertGreater(asked, 60)

    def test_a_subclass_that_forgets_it(self):
        class Forgetful(moldlight.Part):
            def __new__(cls):
                return moldlight.Part.__new__(cls)

            def __init__(self):
                pass

        with self.assertRaises(TypeError):
            Forgetful().health
        empty = moldlight.Part.__new__(moldlight.Part)
        with self.assertRaisesRegex(TypeError, "Part holds nothing"):
            repr(empty)


class Layouts(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = support.box()

    def areas(self, vertices, faces):
        return moldlight.Part(vertices, faces).classify("z").areas

    def test_types_and_orders_mean_the_same(self):
        noted = self.areas(self.vertices, self.faces)
        self.assertEqual(noted["core"] + noted["cavity"] + noted["both"] + noted["undercut"], 52.0)
        # Of a box the two ends are of one half each, the walls of either.
        self.assertEqual(noted, {"core": 12.0, "cavity": 12.0, "both": 28.0, "undercut": 0.0})
        for order in "CF":
            for real in (np.float16, np.float32, np.float64, np.longdouble, ">f8", np.int32, np.uint8):
                for whole in (np.int8, np.uint8, np.int32, np.int64, np.uint32, np.uint64, ">i4"):
                    vertices = np.array(self.vertices, dtype=real, order=order)
                    faces = np.array(self.faces, dtype=whole, order=order)
                    self.assertEqual(self.areas(vertices, faces), noted, (order, real, whole))
        wide = np.zeros((16, 6))
        wide[::2, ::2] = self.vertices
        self.assertEqual(self.areas(wide[::2, ::2], self.faces[::-1, ::-1][:, ::-1]), noted)
        self.assertEqual(self.areas(self.vertices.tolist(), self.faces.tolist()), noted)

    def test_part_keeps_what_it_was_given(self):
        part = moldlight.Part(self.vertices, self.faces)
        before = part.vertices.copy()
        self.vertices[:] = np.nan
        self.faces[:] = 0
        np.testing.assert_array_equal(part.vertices, before)
        self.assertEqual(part.classify("z").areas["core"], 12.0)

    def test_views_cannot_be_written_and_outlive_the_part(self):
        part = moldlight.Part(self.vertices, self.faces)
        found = part.classify("z")
        split = found.split_mesh()
        views = [part.vertices, part.faces, part.facet_areas, part.facet_normals, found.facet_fractions,
                 split.vertices, split.faces, split.facets, split.regions]
        del part, found, split
        for view in views:
            with self.assertRaises(ValueError):
                view[0] = 0
        self.assertEqual(views[2].sum(), 52.0)
        self.assertEqual(views[4].sum(), 12.0)
        self.assertEqual(views[6].dtype, np.uint32)

    def test_equal_vertices_are_one(self):
        corners = self.vertices[self.faces].reshape(-1, 3)
        part = moldlight.Part(corners, np.arange(len(corners)).reshape(-1, 3))
        self.assertTrue(part.health.closed)
        self.assertEqual(part.vertices.shape, (8, 3))

    def test_units(self):
        part = moldlight.Part(self.vertices, self.faces, unit="in", name="block")
        self.assertEqual((part.unit, part.file, part.format), ("in", "block", "arrays"))


class SplitMesh(unittest.TestCase):
    """A box over a plate: known areas, and a split that is closed and has the same areas."""

    def test_split_mesh_is_closed_and_has_the_areas(self):
        part = moldlight.Part.read(support.ASSETS / "cable_clip.stl", unit="mm")
        found = part.classify((0.2, 0.3, 1))
        split = found.split_mesh()
        corners = split.vertices[split.faces]
        areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        for code, region in enumerate(moldlight.REGIONS):
            self.assertAlmostEqual(areas[split.regions == code].sum(), found.areas[region],
                                   delta=1e-6 * found.total_area)
            self.assertAlmostEqual(found.facet_areas[:, code].sum(), found.areas[region],
                                   delta=1e-9 * found.total_area)
        self.assertTrue(moldlight.Part(split.vertices, split.faces).health.closed)
        self.assertTrue((split.facets < len(part.faces)).all())
        self.assertGreater(len(split.borders), 0)
        for border in split.borders:
            self.assertNotEqual(border.left, border.right)
            np.testing.assert_array_equal(border.points, split.vertices[border.vertices])
            self.assertEqual(border.closed, len(border.vertices) > 2 and border.vertices[0] == border.vertices[-1])
        self.assertTrue(found.identity["agrees"])


class Refusals(unittest.TestCase):
    def test_each_is_told_in_words(self):
        vertices, faces = support.box()

        def changed(array, place, value):
            other = array.copy()
            other[place] = value
            return other

        cases = [
            (np.zeros((0, 3)), faces, "vertices: the array is empty"),
            (vertices, np.zeros((0, 3), int), "faces: the array is empty"),
            ([], [], "vertices: the array is 0, not n x 3"),
            (vertices[:, :2], faces, "vertices: the array is 8 x 2, not n x 3"),
            (vertices.ravel(), faces, "vertices: the array is 24, not n x 3"),
            (vertices, np.zeros((2, 4), int), "faces: the array is 2 x 4, not n x 3"),
            (vertices, faces.astype(float), "faces: an array of float64, not of whole numbers"),
            (vertices.astype(complex), faces, "vertices: an array of complex128, not of numbers"),
            (vertices.astype(str), faces, "vertices: an array of <U32, not of numbers"),
            (vertices.astype(object), faces, "vertices: an array of object, not of numbers"),
            (vertices > 0, faces, "vertices: an array of bool, not of numbers"),
            (changed(vertices, (3, 1), np.nan), faces, r"vertices: row 3 is \(4, nan, 0\); .* finite"),
            (changed(vertices, (3, 1), -np.inf), faces, "vertices: row 3 is .*-inf"),
            (changed(vertices, (7, 2), 1e31), faces, r"vertices: row 7 is .* at most"),
            (vertices, changed(faces, (5, 2), 8), "faces: row 5 names vertex 8, but .* from 0 to 7"),
            (vertices, changed(faces, (0, 0), -1), "faces: row 0 names vertex -1"),
            (vertices, changed(faces.astype(np.uint64), (0, 0), 2**64 - 1),
             "faces: row 0 names vertex 18446744073709551615"),
            (vertices, changed(faces, (11, 1), 2**32), "faces: row 11 names vertex 4294967296"),
            (None, faces, "vertices: "),
            (vertices, "text", "faces: "),
            ({}, faces, "vertices: "),
            ([[1, 2, 3], [4, 5]], faces, "vertices: "),
            (np.broadcast_to(np.zeros(3), (2 * 10**9, 3)), faces, "vertices: needs .* GiB of memory"),
            (vertices, np.broadcast_to(np.zeros(3, int), (10**12, 3)), "faces: more than"),
        ]
        for case, (one, other, text) in enumerate(cases):
            with self.subTest(case=case), self.assertRaisesRegex(moldlight.Error, text):
                moldlight.Part(one, other)

    def test_faults_of_geometry_are_no_errors(self):
        vertices, faces = support.box()
        open_part = moldlight.Part(vertices, faces[:-1])
        self.assertFalse(open_part.health.closed)
        self.assertGreater(len(open_part.warnings), 0)
        flat = moldlight.Part(np.zeros((3, 3)), [[0, 1, 2]])
        self.assertEqual(flat.health.degenerate_facets, 1)
        for part in (open_part, flat):
            part.classify("z").split_mesh()
            part.actions("z")


class Memory(unittest.TestCase):
    def test_it_stays_what_it_is(self):
        # A third of what is measured by hand. With one arena: which thread takes which reports nothing.
        measure = pathlib.Path(__file__).with_name("measure")
        noted = subprocess.run([sys.executable, "-B", measure, "memory", "3000"], capture_output=True, text=True,
                              check=True, env={**os.environ, "MALLOC_ARENA_MAX": "1"}).stdout
        # A part that is kept would cost more than 10 KiB each.
        self.assertLess(int(noted.split("parts: ")[1].split()[0]), 1000, noted)


class Hostile(unittest.TestCase):
    """Random arrays, values and types: each call ends in a result or in an exception that says why."""

    def setUp(self):
        self.random = random.Random(7)

    def shape(self):
        return tuple(self.random.choice((0, 1, 2, 3, 3, 4, 7)) for _ in range(self.random.randrange(4)))

    def any_array(self, whole):
        kind = self.random.choice("fdebBiIlLqQg?FDOSUM") if self.random.random() < 0.4 else "l" if whole else "d"
        shape = self.shape() if self.random.random() < 0.3 else (self.random.randrange(1, 30), 3)
        bits = np.frombuffer(self.random.randbytes(16 * 128), np.uint8)
        if self.random.random() < 0.6:
            array = np.array([self.random.randrange(-1, 9) for _ in range(int(np.prod(shape)))], dtype=float)
            array = array.reshape(shape)
            if self.random.random() < 0.3 and array.size:
                array.flat[self.random.randrange(array.size)] = self.random.choice(
                    (np.nan, np.inf, -np.inf, 1e30, 1e300, 5e-324, -1.0, 2.0**31, 2.0**63))
            with np.errstate(all="ignore"):
                array = array.astype("M8[s]" if kind == "M" else kind)
        else:
            size = max(1, int(np.prod(shape)))
            array = np.frombuffer(bits, kind if kind not in "OSUM" else "d")
            array = np.resize(array, size)[:int(np.prod(shape))].reshape(shape)
        twist = self.random.randrange(6)
        if twist == 1:
            array = np.asfortranarray(array)
        if twist == 2 and array.ndim == 2:
            array = array[::-1, ::-1]
        if twist == 3 and array.ndim == 2:
            array = np.lib.stride_tricks.as_strided(array, array.shape, (0, array.strides[1]))
        if twist == 4:
            array = array.tolist()
        return array

    def any_value(self):
        return self.random.choice((
            None, True, -1, 0, 3, 2**70, 0.5, -0.0, float("nan"), float("inf"), "", "z", "best", "\0", "x" * 1000,
            "\udcff", b"z", [], [[]], [1, 2, 3], (1, 2), [1e400, 0, 1], ["x"], {}, {"core": [1]}, object(), print,
            np.float32(2.5), np.int8(3), np.array([0, 0, 1]), np.zeros(3), np.array(5), range(3), iter("xyz"), 1j))

    def test_random_calls(self):
        ended = {"result": 0, "refusal": 0}
        part = moldlight.Part(*support.box())
        for _ in range(CALLS):
            call = self.random.randrange(4)
            try:
                if call < 2:
                    made = moldlight.Part(self.any_array(False), self.any_array(True))
                    found = made.classify(self.random.choice(("z", (1, 2, 3), self.any_value())))
                    found.split_mesh()
                    found.to_json()
                    made.to_json()
                elif call == 2:
                    setting = self.random.choice(moldlight.settings("classify"))["key"]
                    if setting not in ("readout", "samples", "backend"):
                        part.classify("z", **{setting: self.any_value()})
                else:
                    name = self.random.choice(("actions", "mold"))
                    setting = self.random.choice(moldlight.settings(name))["key"]
                    if setting not in ("readout", "samples", "backend"):
                        getattr(part, name)("z", **{setting: self.any_value()})
                ended["result"] += 1
            except TELLING as error:
                self.assertTrue(str(error))
                ended["refusal"] += 1
        # Neither all refused nor all taken: the arrays test what they should.
        self.assertGreater(min(ended.values()), CALLS // 20, ended)


if __name__ == "__main__":
    unittest.main()
