"""Help, signatures, stubs and settings: made from one table, and complete."""

import ast
import importlib.util
import inspect
import os
import pathlib
import pydoc
import re
import subprocess
import sys
import tempfile
import unittest

import moldlight
import support

CALLS = {"Part": moldlight.Part, "read": moldlight.Part.read, "classify": moldlight.Part.classify,
         "draft": moldlight.Part.draft, "sweep": moldlight.Part.sweep, "actions": moldlight.Part.actions,
         "mold": moldlight.Part.mold, "compare": moldlight.compare, "picture": moldlight.Classification.picture,
         "to_html": moldlight.Draft.to_html, "to_pdf": moldlight.Draft.to_pdf}
STUB = pathlib.Path(moldlight.__file__).with_name("__init__.pyi")


class Help(unittest.TestCase):
    def test_signatures_have_every_setting_with_its_default(self):
        for name, call in CALLS.items():
            signature = inspect.signature(call)
            for setting in moldlight.settings(name):
                with self.subTest(call=name, setting=setting["key"]):
                    parameter = signature.parameters[setting["key"]]
                    self.assertEqual(parameter.kind, inspect.Parameter.KEYWORD_ONLY)
                    self.assertEqual(parameter.default, setting["default"])

    def test_help_has_the_help_of_every_setting(self):
        for name, call in CALLS.items():
            lines = pydoc.render_doc(call, renderer=pydoc.plaintext).split()
            text = " ".join(word for word in lines if word != "|")
            for setting in moldlight.settings(name):
                with self.subTest(call=name, setting=setting["key"]):
                    self.assertIn(setting["help"], text)

    def test_every_default_is_taken(self):
        part = moldlight.Part(*support.box())
        for name in ("classify", "actions", "mold"):
            # Kernel and tolerance replace each other, unset as they are.
            defaults = {setting["key"]: setting["default"] for setting in moldlight.settings(name)}
            found = getattr(part, name)("z", **defaults)
            self.assertEqual(support.untimed(found.to_dict()), support.untimed(getattr(part, name)("z").to_dict()))

    def test_everything_is_told_of(self):
        text = pydoc.render_doc(moldlight, renderer=pydoc.plaintext)
        for name in moldlight.__all__:
            self.assertIn(name, text)
            value = getattr(moldlight, name)
            if inspect.isclass(value):
                self.assertEqual(value.__module__, "moldlight")
                self.assertTrue(value.__doc__, name)

    def test_settings_of_another_name_are_refused(self):
        with self.assertRaisesRegex(moldlight.UsageError, "classify"):
            moldlight.settings("cast")

    def test_unknown_keywords_are_refused_with_those_there_are(self):
        with self.assertRaisesRegex(TypeError, "unexpected keyword argument 'tau'.*tau_deg"):
            moldlight.Part(*support.box()).classify("z", tau=1)

    def test_messages_name_keywords(self):
        part = moldlight.Part(*support.box())
        for keywords, text in (({"tau_deg": 11}, "^tau_deg: 11 is out of range, 0 to 10$"),
                               ({"tolerance": 99.0}, "^tolerance: 99 is more than the whole part"),
                               ({"readout": "facet-id", "kernel_shape": "symmetric"}, "kernel_shape symmetric")):
            with self.assertRaisesRegex(moldlight.UsageError, text):
                part.classify("z", **keywords)


class Stub(unittest.TestCase):
    def setUp(self):
        self.tree = ast.parse(STUB.read_text(encoding="utf-8"))

    def test_it_has_what_the_module_has(self):
        noted = {node.name: node for node in self.tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(set(noted) | {"REGIONS", "REGION_COLOURS"}, set(moldlight.__all__))
        for name, node in noted.items():
            if not isinstance(node, ast.ClassDef) or issubclass(getattr(moldlight, name), Exception):
                continue
            members = {member.name if isinstance(member, ast.FunctionDef) else member.target.id
                       for member in node.body} - {"__init__"}
            own = {member for member in vars(getattr(moldlight, name)) if not member.startswith("_")}
            self.assertEqual(members, own, name)

    def test_calls_have_the_settings(self):
        for node in ast.walk(self.tree):
            if isinstance(node, ast.FunctionDef) and node.name in CALLS:
                # Pages of some results alone can be live.
                noted = {argument.arg for argument in node.args.kwonlyargs} - {"live"}
                self.assertEqual(noted, {parameter.name for parameter in
                                        inspect.signature(CALLS[node.name]).parameters.values()
                                        if parameter.kind is inspect.Parameter.KEYWORD_ONLY})

    def test_typed(self):
        self.assertTrue(STUB.with_name("py.typed").exists())

    def test_the_manuals_snippets_are_typed(self):
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("mypy is not there")
        page = (support.SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
        snippets = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        self.assertGreater(len(snippets), 2)
        with tempfile.TemporaryDirectory() as folder:
            files = [pathlib.Path(folder) / f"snippet_{number}.py" for number in range(len(snippets))]
            for file, text in zip(files, snippets):
                file.write_text(text, encoding="utf-8")
            done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", folder, *files],
                                  env={**os.environ, "MYPYPATH": str(STUB.parent.parent)}, capture_output=True,
                                  text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
