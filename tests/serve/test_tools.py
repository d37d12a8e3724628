"""The tools of `moldlight serve` on the shipped parts: their schemas, and figures that are those of the commands."""

import base64
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

from client import ASSETS, MOLDLIGHT, Client

LID = "parts/enclosure_lid.stl"
LID_B = "revisions/enclosure_lid_b.stl"
CLIP = "parts/cable_clip.stl"


def command(*words):
    """What --json writes."""
    done = subprocess.run([MOLDLIGHT, *words, "--json", "-"], cwd=ASSETS, capture_output=True, check=True, timeout=300)
    return json.loads(done.stdout)


def without_times(report):
    """Figures alone: how long something took is another each time."""
    if isinstance(report, dict):
        return {key: without_times(value) for key, value in report.items()
                if not key.startswith("timings") and not key.endswith(("_ms", "seconds", "elapsed_s", "per_second"))}
    return [without_times(one) for one in report] if isinstance(report, list) else report


def failure_line(*words):
    """What the command prints, without the program's name."""
    done = subprocess.run([MOLDLIGHT, *words], cwd=ASSETS, capture_output=True, timeout=60, check=False)
    return done.stderr.decode().strip().removeprefix("moldlight: ")


class Lists(unittest.TestCase):
    def test_handshake(self):
        for asked, used in (("2025-06-18", "2025-06-18"), ("2025-03-26", "2025-03-26"), ("2024-11-05", "2024-11-05"),
                            ("1999-01-01", "2025-06-18")):
            with Client(version=asked) as client:
                result = client.hello["result"]
                self.assertEqual(result["protocolVersion"], used)
                self.assertEqual(result["serverInfo"]["name"], "moldlight")
                self.assertIn("tools", result["capabilities"])
                self.assertEqual(client.ask("ping")["result"], {})
                self.assertEqual(client.close(), 0)
                self.assertEqual(client.errors, [])

    def test_schemas_are_valid_and_say_what_is_taken(self):
        with Client() as client:
            tools = {tool["name"]: tool for tool in client.ask("tools/list")["result"]["tools"]}
        self.assertEqual(set(tools), {"classify", "recommend_direction", "side_actions", "mold", "compare", "picture"})
        for tool in tools.values():
            self.assertTrue(tool["description"].endswith("."))
            self.assertEqual(tool["inputSchema"]["type"], "object")
            for key in tool["inputSchema"]["required"]:
                self.assertIn(key, tool["inputSchema"]["properties"])
        tau = tools["classify"]["inputSchema"]["properties"]["tau_deg"]
        self.assertEqual((tau["type"], tau["minimum"], tau["maximum"], tau["default"]), ("number", 0.0, 10.0, 1.0))
        self.assertEqual(tools["mold"]["inputSchema"]["required"], ["part", "direction"])
        try:
            import jsonschema
        except ImportError:
            self.skipTest("jsonschema is not installed")
        for tool in tools.values():
            schema = tool["inputSchema"]
            jsonschema.Draft202012Validator.check_schema(schema)
            validator = jsonschema.Draft202012Validator(schema)
            defaults = {key: value["default"] for key, value in schema["properties"].items() if "default" in value}
            paths = {key: "z" for key in schema["required"]}
            self.assertEqual(list(validator.iter_errors({**defaults, **paths})), [], tool["name"])
            self.assertNotEqual(list(validator.iter_errors({**paths, "no_such": 1})), [])

    def test_arguments_that_the_schema_refuses(self):
        asked = {"part": LID, "direction": "z"}
        with Client() as client:
            for wrong in ({"tau_deg": 99}, {"tau_deg": "1"}, {"kernel": 2}, {"readout": "by eye"}, {"no_such": 1},
                          {"direction": "up"}, {"direction": [0, 0]}, {"part": 5}, {"samples": 1e300},
                          {"unit": ""}, {"couple_kernel": 1}, {"body": None}):
                error = client.call("classify", **{**asked, **wrong})["error"]
                self.assertEqual(error["code"], -32602, wrong)
                self.assertIn(next(iter(wrong)), error["message"])
            self.assertEqual(client.call("classify", part=LID)["error"]["code"], -32602)
            self.assertEqual(client.call("no_such_tool")["error"]["code"], -32602)
            prices = client.call("side_actions", **asked, prices="/etc/prices.json")["error"]
            self.assertEqual(prices["code"], -32602)
            self.assertIn("not a file", prices["message"])
            self.assertEqual(client.close(), 0)


class Figures(unittest.TestCase):
    def check(self, client, tool, arguments, words):
        result = client.call(tool, timeout=300, **arguments)["result"]
        self.assertNotIn("isError", result)
        self.assertEqual(result["content"][0]["type"], "text")
        report = result["structuredContent"]
        self.assertEqual(without_times(report), without_times(command(*words)))
        verdict = report["verdict"]
        self.assertTrue(result["content"][0]["text"].startswith(
            verdict["sentence"] if isinstance(verdict, dict) else verdict))
        return result

    def test_each_tool_says_what_its_command_says(self):
        asked = {"part": LID, "unit": "mm", "direction": "z"}
        words = (LID, "--unit", "mm", "-d", "z")
        with Client() as client:
            # In an order in which answers are kept from call to call.
            self.check(client, "side_actions", asked, ("actions", *words))
            self.check(client, "classify", asked, ("classify", *words))
            self.check(client, "classify", {**asked, "required_draft_deg": 1.5, "tau_deg": 2},
                       ("classify", *words, "--required-draft", "1.5", "--tau", "2"))
            self.check(client, "classify", {**asked, "direction": [0, 1, 2.5]}, ("classify", *words[:-1], "0,1,2.5"))
            self.check(client, "mold", {**asked, "part": CLIP, "direction": "y", "fill_undercut": True},
                       ("mold", CLIP, "--unit", "mm", "-d", "y", "--fill-undercut"))
            self.check(client, "mold", {**asked, "part": CLIP, "direction": "y", "actions": True},
                       ("mold", CLIP, "--unit", "mm", "-d", "y", "--actions"))
            self.check(client, "recommend_direction", {"part": CLIP, "directions": 50, "top": 3},
                       ("sweep", CLIP, "--directions", "50", "--top", "3"))
            self.check(client, "compare", {"a": LID, "b": LID_B, "unit": "mm", "direction": "z"},
                       ("compare", LID, LID_B, "--unit", "mm", "-d", "z"))
            best = self.check(client, "classify", {"part": CLIP, "direction": "best"}, ("classify", CLIP, "-d", "best"))
            self.assertIn("best_direction", best["structuredContent"])
            self.assertEqual(client.close(), 0)

    def test_a_part_is_read_once(self):
        asked = {"part": LID, "direction": "z", "unit": "mm"}
        with Client() as client:
            begin = client.processor_s()
            first = client.call("side_actions", **asked)
            between = client.processor_s()
            again = client.call("side_actions", **asked)
            self.assertLess(client.processor_s() - between, 0.5 * (between - begin))
            self.assertEqual(again["result"], first["result"])

    def test_a_part_that_changed_is_read_anew(self):
        with tempfile.TemporaryDirectory() as folder:
            part = pathlib.Path(folder) / "part.stl"
            shutil.copy(ASSETS / LID, part)
            with Client(folder) as client:
                first = client.call("classify", part="part.stl", direction="z")["result"]["structuredContent"]
                shutil.copy(ASSETS / CLIP, part)
                second = client.call("classify", part="part.stl", direction="z")["result"]["structuredContent"]
                self.assertNotEqual(first["part"]["facets"], second["part"]["facets"])
            self.assertEqual(os.listdir(folder), ["part.stl"], "nothing is written")

    def test_pictures(self):
        with Client() as client:
            for of in ("regions", "side_actions", "mold"):
                answer = client.call("picture", timeout=300, part=CLIP, direction="y", size="320x200", of=of)
                image = answer["result"]["content"][0]
                self.assertEqual((image["type"], image["mimeType"]), ("image", "image/png"))
                png = base64.b64decode(image["data"], validate=True)
                self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
                self.assertEqual([int.from_bytes(png[k:k + 4], "big") for k in (16, 20)], [320, 200])
                if of == "regions":
                    with tempfile.TemporaryDirectory() as folder:
                        file = pathlib.Path(folder) / "clip.png"
                        command("classify", CLIP, "-d", "y", "--size", "320x200", "--image", str(file))
                        self.assertEqual(png, file.read_bytes())
            refused = client.call("picture", part=CLIP, direction="y", size="9000x9000")
            self.assertEqual(refused["error"]["code"], -32602)

    def test_older_versions_get_the_report_as_text(self):
        with Client(version="2024-11-05") as client:
            content = client.call("classify", part=CLIP, direction="y")["result"]["content"]
            self.assertEqual(json.loads(content[1]["text"])["schema"], "moldlight.classify/2")


class Paths(unittest.TestCase):
    def line_of(self, client, path):
        result = client.call("classify", part=path, direction="z")["result"]
        self.assertIs(result["isError"], True, path)
        return result["content"][0]["text"]

    def test_what_cannot_be_read_has_the_line_of_the_command(self):
        with Client() as client:
            for path in ("parts/no_such.stl", "README.md", "parts", "CMakeLists.txt"):
                self.assertEqual(self.line_of(client, path), failure_line("classify", path, "-d", "z"))
            result = client.call("classify", part=LID, direction="z", tolerance=1e6)["result"]
            self.assertIs(result["isError"], True)
            self.assertEqual(result["content"][0]["text"],
                             failure_line("classify", LID, "-d", "z", "--tolerance", "1e6"))
            self.assertEqual(client.ask("ping")["result"], {})

    def test_nothing_outside_of_the_folder_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            inside, outside = pathlib.Path(folder) / "in", pathlib.Path(folder) / "out"
            (inside / "deep").mkdir(parents=True)
            outside.mkdir()
            for place in (inside / "part.stl", inside / "deep" / "part.stl", outside / "part.stl"):
                shutil.copy(ASSETS / CLIP, place)
            (inside / "link.stl").symlink_to(outside / "part.stl")
            (inside / "links").symlink_to(outside)
            (inside / "good.stl").symlink_to(inside / "deep" / "part.stl")
            (inside / "loop.stl").symlink_to("loop.stl")
            os.mkfifo(inside / "pipe.stl")
            with Client(inside) as client:
                for path in ("part.stl", "deep/../part.stl", "./deep/part.stl", "good.stl", str(inside / "part.stl"),
                             "../in/part.stl"):
                    result = client.call("classify", part=path, direction="y")["result"]
                    self.assertIn("structuredContent", result, path)
                for path in ("../out/part.stl", str(outside / "part.stl"), "link.stl", "links/part.stl",
                             "deep/../../out/part.stl", "no/../../out/part.stl", "/etc/passwd", "/", "..", "../..",
                             "/proc/self/root" + str(outside) + "/part.stl", "links/../in2", str(inside) + "2/x"):
                    self.assertIn("outside of the folder", self.line_of(client, path), path)
                # The same whether or not there is such a file.
                self.assertEqual(self.line_of(client, "../out/part.stl").split(": ", 1)[1],
                                 self.line_of(client, "../out/none.stl").split(": ", 1)[1])
                for path in ("part.stl\0.png", "loop.stl", "pipe.stl", "", ".", "x" * 5000, "a\nb", "\u202e"):
                    self.assertNotIn("\n", self.line_of(client, path))
                self.assertEqual(client.close(), 0)


if __name__ == "__main__":
    unittest.main()
