"""Threads side by side, progress, cancelling, Ctrl-C, child processes."""

import io
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import moldlight
import support

LID = support.ASSETS / "enclosure_lid.stl"
CLIP = support.ASSETS / "cable_clip.stl"
LONG = {"thorough": True, "directions": 100000, "scoring_samples": 1000000}


class Threads(unittest.TestCase):
    def test_four_threads_find_what_one_finds(self):
        directions = [(i % 7 - 3, i % 5 - 2, 1 + i % 3) for i in range(100)]
        alone = moldlight.Part.read(CLIP)
        noted = [support.untimed(alone.classify(direction).to_dict()) for direction in directions]
        # A part that nothing was asked of yet: what it makes once, four threads ask for.
        shared = moldlight.Part.read(CLIP)
        with ThreadPoolExecutor(4) as threads:
            found = list(threads.map(lambda d: support.untimed(shared.classify(d).to_dict()), directions))
        self.assertEqual(found, noted)

    def test_a_batch_goes_on_past_parts_that_fail(self):
        sources = [CLIP, support.ASSETS / "none.stl", LID.read_bytes(), io.BytesIO(b"solid of nothing")]
        found = list(moldlight.batch(iter(sources), "classify", jobs=2, direction="z", unit="mm", tau_deg=0.5))
        self.assertEqual([each.source for each in found], sources)
        self.assertEqual([each.error is None for each in found], [True, False, True, False])
        self.assertIsInstance(found[1].error, moldlight.FileError)
        self.assertIsNone(found[1].part)
        alone = moldlight.Part.read(LID, unit="mm").classify("z", tau_deg=0.5)
        self.assertEqual(found[2].result.areas, alone.areas)
        self.assertEqual(found[2].part.unit, "mm")
        for keywords in ({"direction": "z", "tau": 1}, {}, {"direction": "z", "jobs": 2, "unit": "parsec"}):
            with self.assertRaises((moldlight.UsageError, TypeError)):
                next(moldlight.batch([CLIP], "classify", **keywords))
        with self.assertRaisesRegex(moldlight.UsageError, "melt"):
            moldlight.batch([CLIP], "melt")

    def test_leaving_a_batch_ends_it(self):
        begun = time.monotonic()
        for found in moldlight.batch([CLIP] + 20 * [LID], "sweep", jobs=2, unit="mm", directions=400):
            self.assertIsNone(found.error)
            begun = time.monotonic()
            break
        self.assertLess(time.monotonic() - begun, 3.0)

    def test_maps_and_pictures_in_threads(self):
        part = moldlight.Part.read(CLIP)
        looks = {"readout": "samples", "samples": 5000, "resolution": 256}
        noted = support.untimed(part.classify("z", **looks).to_dict())
        picture = part.classify("z").picture(size=(120, 80))
        with ThreadPoolExecutor(4) as threads:
            found = [threads.submit(lambda: support.untimed(part.classify("z", **looks).to_dict()))
                     for _ in range(4)]
            drawn = [threads.submit(lambda: part.classify("z").picture(size=(120, 80))) for _ in range(4)]
        for each in found:
            self.assertEqual(each.result(), noted)
        for each in drawn:
            self.assertEqual(each.result().tolist(), picture.tolist())

    def test_other_threads_run_meanwhile(self):
        part = moldlight.Part.read(LID)
        count, end = 0, threading.Event()
        work = threading.Thread(target=lambda: (part.sweep(directions=100, top=1), end.set()))
        work.start()
        while not end.is_set():
            count += 1
            time.sleep(0.001)
        work.join()
        self.assertGreater(count, 10)

    def test_split_mesh_is_one_for_all(self):
        found = moldlight.Part.read(CLIP).classify("z")
        with ThreadPoolExecutor(4) as threads:
            sizes = set(threads.map(lambda _: len(found.split_mesh().faces), range(8)))
        self.assertEqual(len(sizes), 1)

    @unittest.skipUnless(hasattr(os, "fork"), "needs fork")
    def test_a_forked_child_can_ask_too(self):
        part = moldlight.Part.read(CLIP)
        noted = part.classify("z").areas
        child = os.fork()
        if child == 0:
            code = 1
            try:
                code = 0 if part.classify("z").areas == noted else 2
            finally:
                os._exit(code)
        deadline = time.monotonic() + 60
        ended, status = 0, 0
        while ended == 0 and time.monotonic() < deadline:
            ended, status = os.waitpid(child, os.WNOHANG)
            time.sleep(0.01)
        if ended == 0:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
        self.assertEqual((ended != 0, status), (True, 0))


class Progress(unittest.TestCase):
    def setUp(self):
        self.part = moldlight.Part.read(LID)

    def test_stages_are_told_in_the_callers_thread(self):
        noted = []
        self.part.sweep(**LONG, progress=lambda stage, share: noted.append(
            (stage, share, threading.current_thread())) or len(noted) < 5)
        self.assertGreater(len(noted), 3)
        for stage, share, thread in noted:
            self.assertTrue(stage and 0 <= share <= 1 and thread is threading.main_thread(), noted)

    def test_false_ends_the_work(self):
        began = time.process_time()
        with self.assertRaisesRegex(moldlight.Cancelled, "callback"):
            self.part.classify("best", progress=lambda stage, share: False)
        self.assertLess(time.process_time() - began, 5)
        self.assertEqual(self.part.classify("z").areas, moldlight.Part.read(LID).classify("z").areas)

    def test_false_ends_a_sweep_with_what_is_done(self):
        calls = []
        found = self.part.sweep(**LONG, progress=lambda stage, share: calls.append(stage) or len(calls) < 10)
        self.assertFalse(found.complete)

    def test_what_it_raises_comes_out(self):
        def fail(stage, share):
            raise KeyError(stage)

        with self.assertRaises(KeyError):
            self.part.sweep(**LONG, progress=fail)

    def test_what_cannot_be_called_is_refused(self):
        with self.assertRaisesRegex(moldlight.UsageError, "progress"):
            self.part.classify("z", progress="no")


class Interrupt(unittest.TestCase):
    # A shell has its jobs in the background ignore the signal. Python forgets one that comes while it closes a file
    # that nobody closed.
    SCRIPT = """
import signal, sys, time
import moldlight
signal.signal(signal.SIGINT, signal.default_int_handler)
part = moldlight.Part.read(sys.argv[1])
with open(sys.argv[1], "rb") as file:
    data = file.read()
call = eval(sys.argv[2])
print("ready", flush=True)
try:
    while True:
        call()
except KeyboardInterrupt:
    print("interrupted", time.process_time(), flush=True)
    print(part.classify("z").areas["core"] > 0)
"""

    def interrupt(self, call):
        """Seconds of the processor from Ctrl-C to the exception, whatever else the machine does."""
        work = subprocess.Popen([sys.executable, "-c", self.SCRIPT, str(LID), f"lambda: {call}"],
                                stdout=subprocess.PIPE, text=True)
        with work.stdout:
            self.assertEqual(work.stdout.readline(), "ready\n")
            time.sleep(1.5)
            stat = pathlib.Path(f"/proc/{work.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
            used = (int(stat[11]) + int(stat[12])) / os.sysconf("SC_CLK_TCK")
            work.send_signal(signal.SIGINT)
            word, ended = work.stdout.readline().split()
            self.assertEqual(word, "interrupted")
            self.assertEqual(work.stdout.readline(), "True\n")
        self.assertEqual(work.wait(), 0)
        return float(ended) - used

    def test_ends_a_sweep_within_a_second(self):
        self.assertLess(self.interrupt(f"part.sweep(**{LONG})"), 1.0)

    def test_ends_a_proof_within_a_second(self):
        proof = {"prove": 0.0, "proof": "area", "directions": 10, "top": 1, "candidates": "axis", "refine": 0}
        self.assertLess(self.interrupt(f"part.sweep(**{ {**proof, **LONG} })"), 1.0)

    def test_ends_every_other_call_within_a_second(self):
        # Again and again, so that the signal falls anywhere.
        for call in ("part.mold('z', actions=True)", "part.draft('z', required_draft_deg=1)",
                     "moldlight.compare(part, part, 'z')", "moldlight.Part.read(data)",
                     "part.classify('z').picture()", "part.classify('z').to_html(live=True)"):
            with self.subTest(call=call):
                self.assertLess(max(self.interrupt(call) for _ in range(2)), 1.0)


if __name__ == "__main__":
    unittest.main()
