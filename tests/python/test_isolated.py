"""Calls in a process of their own, and what is left when that process dies."""

import inspect
import os
import pathlib
import pickle
import signal
import unittest

import numpy as np

import moldlight
import support

LID = support.ASSETS / "enclosure_lid.stl"
REVISION = support.SOURCE / "assets" / "revisions" / "enclosure_lid_b.stl"
LONG = {"thorough": True, "directions": 100000, "scoring_samples": 1000000}


def children():
    """Processes that this one has started and that still run."""
    found = set()
    for task in pathlib.Path("/proc/self/task").iterdir():
        found |= {int(word) for word in (task / "children").read_text(encoding="ascii").split()}
    return found


class Isolated(unittest.TestCase):
    def setUp(self):
        self.part = moldlight.Part.read(LID, unit="mm")

    def test_it_finds_the_same(self):
        for name, arguments in (("classify", ("z",)), ("actions", ("z",)), ("mold", ("z",)), ("sweep", ())):
            alone = getattr(self.part, name)(*arguments)
            found = getattr(self.part, name)(*arguments, isolated=True)
            self.assertIsInstance(found, type(alone))
            self.assertEqual(support.untimed(found.to_dict()), support.untimed(alone.to_dict()))
            self.assertEqual(found.verdict.sentence, alone.verdict.sentence)
            self.assertEqual(repr(found), repr(alone))
            self.assertLessEqual({name for name in dir(alone) if name[0] != "_"}, set(dir(found)))

    def test_arrays_and_what_results_have_in_turn(self):
        alone, found = self.part.classify("z"), self.part.classify("z", isolated=True)
        np.testing.assert_array_equal(found.facet_areas, alone.facet_areas)
        split, other = alone.split_mesh(), found.split_mesh()
        np.testing.assert_array_equal(other.vertices, split.vertices)
        self.assertEqual([border.left for border in other.borders], [border.left for border in split.borders])
        with self.assertRaises(AttributeError):
            found.nothing

    def test_a_result_is_pickled(self):
        found = self.part.classify("z", isolated=True)
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual(again.areas, found.areas)

    def test_what_fails_raises_the_same(self):
        with self.assertRaisesRegex(moldlight.UsageError, "^tau_deg: 11 is out of range"):
            self.part.classify("z", tau_deg=11, isolated=True)
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'tau'"):
            self.part.classify("z", tau=1, isolated=True)
        found = self.part.classify("z", isolated=True)
        with open(os.devnull, "w", encoding="utf-8") as file:
            with self.assertRaisesRegex(moldlight.UsageError, "^to_html: an isolated call takes names"):
                found.to_html(file)
        self.assertGreater(found.areas["undercut"], 0)

    def test_progress_and_cancelling(self):
        heard = []
        self.part.classify("z", isolated=True, progress=lambda stage, share: heard.append(stage))
        self.assertTrue(all(isinstance(stage, str) for stage in heard))
        with self.assertRaises(moldlight.Cancelled):
            self.part.pieces(isolated=True, progress=lambda stage, share: False)
        ended = self.part.sweep(isolated=True, progress=lambda stage, share: False, **LONG)
        self.assertFalse(ended.complete)

        def refuses(stage, share):
            raise ValueError(stage)

        with self.assertRaises(ValueError):
            self.part.sweep(isolated=True, progress=refuses, **LONG)

    def test_a_death_at_work_is_an_error(self):
        before = children()

        def kills(stage, share):
            for child in children() - before:
                os.kill(child, signal.SIGSEGV)

        with self.assertRaisesRegex(moldlight.Error, "ended by SIGSEGV; nothing but its result is lost"):
            self.part.sweep(isolated=True, progress=kills, **LONG)
        self.assertEqual(self.part.classify("z").verdict.state, "undercuts")

    def test_a_death_later_takes_nothing(self):
        kept = self.part.classify("z", isolated=True)
        before = children()
        lost = self.part.classify("x", isolated=True)
        split = lost.split_mesh()
        noted = lost.areas
        for child in children() - before:
            os.kill(child, signal.SIGKILL)
            os.waitid(os.P_PID, child, os.WEXITED | os.WNOWAIT)
        with self.assertRaisesRegex(moldlight.Error, "ended by SIGKILL; nothing but its result is lost"):
            split.faces
        self.assertEqual(lost.areas, noted)  # found again
        self.assertEqual(len(lost.split_mesh().faces), len(self.part.classify("x").split_mesh().faces))
        self.assertGreater(kept.areas["core"], 0)

    def test_a_process_ends_with_its_result(self):
        before = children()
        found = self.part.classify("z", isolated=True)
        border = found.split_mesh().borders[0]
        self.assertEqual(len(children() - before), 1)
        del found
        self.assertGreater(len(border.points), 0)
        del border
        self.assertEqual(children() - before, set())

    def test_interrupt(self):
        def interrupts(stage, share):
            os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            self.part.sweep(isolated=True, progress=interrupts, **LONG)

    def test_revisions_and_batches(self):
        after = moldlight.Part.read(REVISION, unit="mm")
        alone, found = (moldlight.compare(self.part, after, "z", actions=False, isolated=isolated)
                        for isolated in (False, True))
        self.assertEqual(support.untimed(found.to_dict()), support.untimed(alone.to_dict()))
        self.assertEqual(found.met("undercut > +1%"), alone.met("undercut > +1%"))
        for each in moldlight.batch([LID, LID], "classify", direction="z", unit="mm", isolated=True):
            self.assertIsNone(each.error)
            self.assertEqual(each.result.areas, self.part.classify("z").areas)

    def test_it_is_in_the_signature(self):
        self.assertTrue(moldlight.can_isolate())
        for call in (moldlight.Part.classify, moldlight.Part.pieces, moldlight.compare):
            self.assertIs(inspect.signature(call).parameters["isolated"].default, False)


if __name__ == "__main__":
    unittest.main()
