"""Run by freecadcmd: all test_*.py beside it. MOLDLIGHT_SOURCE is the source tree; ends with 1 if one failed."""

import os
import sys
import traceback
import unittest

status = 1
try:
    here = os.path.join(os.environ["MOLDLIGHT_SOURCE"], "tests", "freecad")
    sys.path[:0] = [os.path.join(os.environ["MOLDLIGHT_SOURCE"], "src", "freecad"), here]
    names = os.environ.get("MOLDLIGHT_TESTS", "").split()
    suite = unittest.defaultTestLoader.loadTestsFromNames(names) if names else unittest.defaultTestLoader.discover(here)
    outcome = unittest.TextTestRunner(stream=sys.stderr, verbosity=2).run(suite)
    status = 0 if outcome.wasSuccessful() and outcome.testsRun else 1
except BaseException:
    traceback.print_exc()
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)  # FreeCAD would go on as a console
