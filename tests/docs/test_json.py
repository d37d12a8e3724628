"""The tables of the page on JSON schemas against reports: no key is missing, and none is made up."""

import json
import unittest

import documents
import blocks
import json_page
import runs


def paths(value, before=""):
    """Keys as the page writes them; lists of numbers or points are one key, empty and null values count."""
    if isinstance(value, dict) and value:
        for key, item in value.items():
            yield from paths(item, f"{before}.{key}" if before else key)
    elif isinstance(value, list) and any(isinstance(item, dict) for item in value):
        for item in value:
            yield from paths(item, before + "[]")
    else:
        yield before


def covers(key, path):
    """`a.*` is all below a; a list may be empty, an object null."""
    return path == key or (key.endswith(".*") and path.startswith(key[:-1]))


class Schemas(unittest.TestCase):
    def setUp(self):
        self.session = runs.Session()
        self.addCleanup(self.session.close)

    def test_every_schema_is_in_the_first_table(self):
        files = sorted((documents.ROOT / "docs" / "schemas").iterdir())
        names = [json.loads(file.read_text(encoding="utf-8"))["properties"]["schema"]["const"] for file in files]
        self.assertEqual([file.name for file in files], [name.replace("/", "-") + ".schema.json" for name in names])
        rows = [line.split("`")[1] for line in blocks.read(json_page.PAGE) if line.startswith("| `moldlight.")]
        self.assertEqual(sorted(rows), names)

    def test_tables(self):
        found = list(json_page.sections())
        named = [line.split("`")[1] for line in blocks.read(json_page.PAGE) if line.startswith("| `moldlight.")]
        self.assertEqual(sorted(named), sorted(heading for heading, _, _ in found if heading.startswith("moldlight.")))
        self.assertEqual(len(found), 10)
        for heading, consoles, keys in found:
            reports = json_page.reports(self.session, consoles)
            self.assertTrue(reports, heading)
            if heading.startswith("moldlight."):
                self.assertEqual({report["schema"] for report in reports}, {heading})
            else:
                reports = [report["part"] for report in reports]
                keys = {**keys, "bounds.*": ""}
            written = {path for report in reports for path in paths(report)}
            # An empty list or a null has no keys below it to be described.
            missing = {path for path in written if not any(covers(key, path) for key in keys)
                       and not any(key.startswith((path + "[].", path + ".")) for key in keys)}
            with self.subTest(schema=heading):
                self.assertEqual(sorted(missing), [], "keys that the page does not describe")
                unused = {key for key, meaning in keys.items() if not meaning.startswith("Only ")
                          and not any(covers(key, path) or path.startswith((key + ".", key + "[]"))
                                      for path in written)}
                self.assertEqual(sorted(unused), [], "keys that no report has")


if __name__ == "__main__":
    unittest.main()
