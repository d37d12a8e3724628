"""The protocol of `moldlight serve`: cancelling, progress, faults by the book, ten thousand hostile messages."""

import collections
import json
import os
import random
import signal
import subprocess
import time
import unittest

from client import ASSETS, MOLDLIGHT, Client

LID = "parts/enclosure_lid.stl"
# Minutes, if nothing ends it.
LONG = {"name": "recommend_direction",
        "arguments": {"part": LID, "directions": 20000, "scoring_samples": 200000, "thorough": True, "top": 50}}
# A second on each of the processor's cores.
MOST_LATE_S = 1.0 * os.cpu_count()
SHORT = {"name": "classify", "arguments": {"part": "parts/cable_clip.stl", "direction": "y"}}


def cancel(client, asked):
    client.send({"jsonrpc": "2.0", "method": "notifications/cancelled",
                 "params": {"requestId": asked, "reason": "test"}})


class Calls(unittest.TestCase):
    def test_pings_are_answered_while_a_call_runs_and_a_cancelled_one_ends_within_a_second(self):
        with Client() as client:
            client.call(**SHORT["arguments"], tool="classify")
            for wait_s in (0.0, 0.3, 2.0):
                long_one = client.request("tools/call", LONG)
                waiting = client.request("tools/call", SHORT)
                time.sleep(wait_s)
                self.assertEqual(client.ask("ping")["result"], {})
                begin = client.processor_s()
                cancel(client, long_one)
                self.assertIn("structuredContent", client.answer_to(waiting)["result"])
                self.assertLess(client.processor_s() - begin, MOST_LATE_S + 1.0, "a second, and the call that waited")
            self.assertEqual(client.close(), 0)
            # The protocol has no answer to what was cancelled.
            self.assertEqual([one for one in client.answers if one.get("id") == long_one], [])

    def test_a_call_that_waits_is_cancelled(self):
        with Client() as client:
            long_one, waiting = client.request("tools/call", LONG), client.request("tools/call", SHORT)
            cancel(client, waiting)
            cancel(client, 12345)
            cancel(client, long_one)
            self.assertIn("result", client.ask("tools/call", SHORT))
            self.assertNotIn(waiting, [one["id"] for one in client.answers])

    def test_the_answer_after_a_cancelled_one_is_whole(self):
        asked = {"part": "parts/tilted_bracket.stl", "directions": 200, "top": 3}
        with Client() as client:
            first = client.request("tools/call", {"name": "recommend_direction", "arguments": asked})
            time.sleep(0.5)
            cancel(client, first)
            report = client.call("recommend_direction", timeout=120, **asked)["result"]["structuredContent"]
            self.assertEqual(report["verdict"]["state"], "two-plate")
            self.assertEqual(len(report["candidates"]), 3)

    def test_progress_rises_and_ends_before_the_answer(self):
        with Client() as client:
            for token, directions in (("a token", 60), (7, 61)):
                client.notices.clear()
                answer = client.ask("tools/call", {"name": "recommend_direction", "_meta": {"progressToken": token},
                                                   "arguments": {"part": LID, "directions": directions, "top": 2}}, 120)
                answered = time.monotonic()
                self.assertIn("result", answer)
                self.assertEqual(client.ask("ping")["result"], {})
                shares = [notice["params"]["progress"] for _, notice in client.notices]
                self.assertGreater(len(shares), 2)
                self.assertEqual(shares, sorted(set(shares)))
                for at, notice in client.notices:
                    self.assertLess(at, answered)
                    self.assertEqual(notice["method"], "notifications/progress")
                    self.assertEqual(notice["params"]["progressToken"], token)
                    self.assertNotIn("id", notice)
            client.notices.clear()
            client.ask("tools/call", SHORT)
            self.assertEqual(client.notices, [])

    def test_too_many_calls_are_refused_not_kept(self):
        with Client() as client:
            for _ in range(60):
                client.request("tools/call", LONG)
            # One works and 32 wait; which of them depends on when the first begins.
            refused = [client.next_message()["error"]["code"] for _ in range(60 - 33)]
            self.assertEqual(set(refused), {-32000})
            client.process.send_signal(signal.SIGTERM)
            self.assertEqual(client.process.wait(60), 0)

    def test_what_was_asked_is_answered_at_the_end_of_the_input(self):
        with Client() as client:
            asked = client.request("tools/call", SHORT)
            self.assertEqual(client.close(), 0)
            self.assertIn("result", client.answer_to(asked))

    def test_sigterm_ends_a_call(self):
        with Client() as client:
            client.request("tools/call", LONG)
            time.sleep(0.5)
            begin = client.processor_s()
            client.process.send_signal(signal.SIGTERM)
            _, status, used = os.wait4(client.process.pid, 0)
            client.process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(client.process.returncode, 0)
            self.assertLess(used.ru_utime + used.ru_stime - begin, MOST_LATE_S)

    def test_a_client_that_is_gone_ends_it(self):
        """Also in the midst of a call, which nobody would get the answer of."""
        process = subprocess.Popen([MOLDLIGHT, "serve", "--stdio", "--folder", str(ASSETS)], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        hello = {"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"protocolVersion": "2025-06-18"}}
        for message in (hello, {"jsonrpc": "2.0", "id": 2, "method": "tools/call", "params": LONG}):
            process.stdin.write(json.dumps(message).encode() + b"\n")
        process.stdin.flush()
        process.stdout.readline()
        process.stdout.close()
        process.stdin.close()
        process.wait(60)


class Faults(unittest.TestCase):
    def fault(self, client, line):
        """Code and id of the only answer."""
        client.send_bytes(line)
        client.request("ping")
        answer = client.next_message()
        self.assertEqual(client.next_message(), {"jsonrpc": "2.0", "id": client.last_id, "result": {}})
        return answer["error"]["code"], answer["id"]

    def test_by_the_book(self):
        with Client() as client:
            for code, asked, line in (
                    (-32700, None, b"{"), (-32700, None, b"no JSON"), (-32700, None, b'{"a":"\xff"}'),
                    (-32700, None, b'{"jsonrpc":"2.0","id":1,"method":"ping"}\0{'), (-32700, None, b"[" * 100000),
                    (-32700, None, b'{"jsonrpc":"2.0","id":1,"method":"\xed\xa0\x80"}'),
                    (-32700, None, b'"' + b"x" * 3000000 + b'"'), (-32700, None, b"1e999"),
                    (-32600, None, b"5"), (-32600, None, b"null"), (-32600, None, b"{}"), (-32600, None, b"[]"),
                    (-32600, None, b'[{"jsonrpc":"2.0","id":1,"method":"ping"}]'),
                    (-32600, None, b'{"jsonrpc":"2.0","id":null,"method":"ping"}'),
                    (-32600, None, b'{"jsonrpc":"2.0","id":[1],"method":"ping"}'),
                    (-32600, None, b'{"jsonrpc":"2.0","method":1}'), (-32600, 4, b'{"id":4,"method":"ping"}'),
                    (-32600, 4, b'{"jsonrpc":"1.0","id":4,"method":"ping"}'),
                    (-32600, "x", b'{"jsonrpc":"2.0","id":"x","method":"ping","params":3}'),
                    (-32601, 4, b'{"jsonrpc":"2.0","id":4,"method":"resources/list"}'),
                    (-32601, 4, b'{"jsonrpc":"2.0","id":4,"method":"notifications/cancelled","params":{}}'),
                    (-32602, 4, b'{"jsonrpc":"2.0","id":4,"method":"tools/call","params":[1]}'),
                    (-32602, 4, b'{"jsonrpc":"2.0","id":4,"method":"tools/call"}'),
                    (-32602, 4, b'{"jsonrpc":"2.0","id":4,"method":"tools/list","params":{"cursor":"x"}}'),
                    (-32602, 4, b'{"jsonrpc":"2.0","id":4,"method":"initialize","params":{}}'),
                    (-32602, 4, b'{"jsonrpc":"2.0","id":4,"method":"tools/call","params":'
                                b'{"name":"mold","arguments":[]}}')):
                self.assertEqual(self.fault(client, line), (code, asked), line[:80])
            self.assertEqual(client.close(), 0)

    def test_what_has_no_answer(self):
        with Client() as client:
            for line in (b"", b"  \r", b'{"jsonrpc":"2.0","method":"no/such"}',
                         b'{"jsonrpc":"2.0","method":"tools/call"}',
                         b'{"jsonrpc":"2.0","id":9,"result":{}}',
                         b'{"jsonrpc":"2.0","method":"notifications/cancelled","params":[]}'):
                client.send_bytes(line)
            self.assertEqual(client.ask("ping")["result"], {})
            self.assertEqual(client.close(), 0)
            self.assertEqual(client.answers, [])

    def test_tools_wait_for_the_handshake(self):
        with Client(version=None) as client:
            self.assertEqual(client.ask("ping")["result"], {})
            self.assertEqual(client.ask("tools/list")["error"]["code"], -32600)

    def test_arrays_in_the_version_that_has_them(self):
        with Client(version="2025-03-26") as client:
            client.send([{"jsonrpc": "2.0", "id": "a", "method": "tools/call", "params": SHORT},
                         {"jsonrpc": "2.0", "method": "notifications/initialized"}, 1,
                         {"jsonrpc": "2.0", "id": "b", "method": "ping"}])
            answers = {str(one["id"]): one for one in client.next_message()}
            self.assertEqual(set(answers), {"a", "b", "None"})
            self.assertIn("result", answers["a"])
            self.assertEqual(answers["None"]["error"]["code"], -32600)
            client.send([{"jsonrpc": "2.0", "method": "notifications/initialized"}])
            client.send([])
            self.assertEqual(client.next_message()["error"]["code"], -32600)
            client.send([{"jsonrpc": "2.0", "id": 1, "method": "ping"}] * 1000)
            self.assertEqual(client.next_message()["error"]["code"], -32600)


class Hostile(unittest.TestCase):
    def test_large_messages_take_no_time(self):
        ping = b'{"jsonrpc":"2.0","id":%d,"method":"ping","params":{"a":%s}}'
        with Client() as client:
            before_kib = client.peak_kib()
            for number, value in enumerate((b"[" + b"{}," * 300000 + b"1]", b"[" + b"[]," * 300000 + b"1]",
                                            b"{" + b",".join(b'"%d":1' % k for k in range(90000)) + b"}",
                                            b'"' + b"\\u00e9" * 150000 + b'"', b"9" * 900000 + b"e-900000"), 100):
                client.send_bytes(ping % (number, value))
                self.assertIn("result", client.answer_to(number, 5))
            self.assertLess(client.peak_kib() - before_kib, 100 * 1024)

    MESSAGES, SEED = 10000, 20251126

    def made(self, chance, number):
        """A message that may be sound: most name a method or a tool, and have some of what it takes."""
        ask = chance.choice
        params = ask([None, {}, [], 1, "x", {"name": "classify"}, {"protocolVersion": "2025-06-18"},
                      {"cursor": ""}, {"requestId": -chance.randrange(20000)}, {"_meta": {"progressToken": {}}}])
        if chance.random() < 0.6:
            part = ask([LID, "../x", "/etc/passwd", "", "parts", 1, None, "no.stl", "\0", "é" * 300])
            arguments = {"part": part, "direction": ask(["z", "up", "best best", [0, 0, 0], [1, 2], {}, 9e99])}
            key = ask(["tau_deg", "samples", "kernel", "unit", "prices", "size", "of", "side_directions", "candidates"])
            arguments[key] = ask([0, -1, 1e308, "", "nan", True, None, [], [[]], {"a": {}}, "x" * 1000, [[1, 2, 3]]])
            params = {"name": ask(["classify", "mold", "picture", "compare", "side_actions", "none", 5]),
                      "arguments": ask([arguments, arguments, arguments, [], None, "z"])}
        message = {"jsonrpc": ask(["2.0"] * 9 + ["1.0"]), "id": number, "params": params,
                   "method": ask(["tools/call"] * 6 + ["tools/list", "ping", "notifications/cancelled", "x", "", 4])}
        for key in list(message):
            if chance.random() < 0.05:
                del message[key]
        return message

    def mutated(self, chance, line):
        data = bytearray(line)
        for _ in range(chance.randrange(1, 6)):
            at = chance.randrange(len(data))
            kind = chance.randrange(4)
            if kind == 0:
                data[at] = chance.randrange(256)
            elif kind == 1:
                del data[at:at + chance.randrange(1, 20)]
            elif kind == 2:
                data[at:at] = data[at:at + chance.randrange(1, 40)]
            else:
                data[at:at] = bytes(chance.choice(b'{}[]",:\\0\x00\xff\xc0e-') for _ in range(3))
            if not data:
                data = bytearray(b"{")
        return bytes(data).replace(b"\n", b" ")

    @staticmethod
    def ids_of(line):
        """The number that an answer is known by, where the line is JSON and has one."""
        try:
            sent = json.loads(line.decode(), parse_constant=int)
        except (UnicodeDecodeError, ValueError, RecursionError):
            return []
        asked = sent.get("id") if isinstance(sent, dict) else None
        return [asked] if isinstance(asked, (int, float)) and not isinstance(asked, bool) else []

    def test_every_request_has_one_answer_and_memory_stays(self):
        chance = random.Random(self.SEED)
        asked, answered = collections.Counter(), collections.Counter()
        with Client() as client:
            client.ask("tools/call", SHORT)
            before_kib = client.peak_kib()
            for number in range(1, self.MESSAGES + 1):
                message = self.made(chance, number)
                line = json.dumps(message, ensure_ascii=chance.random() < 0.5).encode()
                if chance.random() < 0.4:
                    line = self.mutated(chance, line)
                if chance.random() < 0.001:
                    line = chance.choice([b"[" * 2000000, b'{"a":' * 100000, b" " * 1100000 + b"{}"])
                client.send_bytes(line)
                asked.update(self.ids_of(line))
                if number % 25 == 0:
                    client.send({"jsonrpc": "2.0", "id": f"ping {number}", "method": "ping"})
                    client.answer_to(f"ping {number}", 120)
            client.send_bytes(b"\xff" * 100)
            after_kib = client.peak_kib()
            self.assertEqual(client.close(), 0)
            while (answer := client.next_message()) is not None:
                client.answers.append(answer)
            for answer in client.answers:
                self.assertEqual(answer["jsonrpc"], "2.0")
                self.assertEqual(("result" in answer) + ("error" in answer), 1)
                if isinstance(answer["id"], (int, float)):
                    answered[answer["id"]] += 1
            self.assertGreater(asked.total(), self.MESSAGES // 2)
            # Mutations may have given two messages one id.
            self.assertEqual(answered, asked)
            self.assertEqual(client.errors, [])
            self.assertLess(after_kib - before_kib, 400 * 1024)


if __name__ == "__main__":
    unittest.main()
