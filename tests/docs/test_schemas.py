"""Reports against the JSON Schemas of docs/schemas: those of the page on JSON, and of the shared parts where they are."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import documents
import json_page
import runs

try:
    import jsonschema
except ImportError:
    print("jsonschema is not installed")
    sys.exit(77)

FOLDER = documents.ROOT / "docs" / "schemas"
SHARED = documents.ROOT.parent / "shared" / "parts"
COMMANDS = {"classify": ["-d", "y"], "actions": ["-d", "y"], "mold": ["-d", "y"], "info": []}


def validator(heading):
    schema = json.loads((FOLDER / (heading.replace("/", "-") + ".schema.json")).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


class Schemas(unittest.TestCase):
    def check(self, report, what):
        faults = [f"{'/'.join(map(str, fault.absolute_path))}: {fault.message[:160]}"
                  for fault in validator(report["schema"]).iter_errors(report)]
        self.assertEqual(faults[:5], [], what)

    def test_reports_of_the_page(self):
        checked = 0
        session = runs.Session()
        self.addCleanup(session.close)
        for heading, consoles, _ in json_page.sections():
            if heading.startswith("moldlight."):
                for report in json_page.reports(session, consoles):
                    self.check(report, heading)
                    checked += 1
        self.assertGreaterEqual(checked, 9)

    def test_shared_parts(self):
        parts = sorted(file for file in SHARED.glob("*.*") if file.suffix in (".stl", ".obj", ".ply", ".3mf", ".off")
                       and file.stat().st_size < 120_000) if SHARED.is_dir() else []
        print(f"{len(parts)} shared parts")
        with tempfile.TemporaryDirectory() as folder:
            for part in parts:
                for command, flags in COMMANDS.items():
                    out = pathlib.Path(folder) / "out.json"
                    out.unlink(missing_ok=True)
                    subprocess.run([runs.program(), command, part, *flags, "--json", out], check=False,
                                   capture_output=True, timeout=runs.TIME_LIMIT_S)
                    with self.subTest(command=command, part=part.name):
                        self.assertTrue(out.exists())
                        self.check(json.loads(out.read_text(encoding="utf-8")), f"{command} {part.name}")

    def test_refuse_another_report(self):
        session = runs.Session()
        self.addCleanup(session.close)
        session.command("moldlight classify parts/bottle_cap.stl --unit mm -d z --json out.json")
        report = json.loads((session.folder / "out.json").read_text(encoding="utf-8"))
        self.check(report, "as it is")
        for spoil in (lambda r: r.pop("areas"), lambda r: r["areas"].update(core="much"),
                      lambda r: r["verdict"].pop("state"), lambda r: r.update(schema="moldlight.classify/9")):
            spoiled = copy.deepcopy(report)
            spoil(spoiled)
            self.assertFalse(validator("moldlight.classify/2").is_valid(spoiled))


if __name__ == "__main__":
    unittest.main()
