"""A client of `moldlight serve` that knows the protocol's text alone: a message a line, answers in any order."""

import json
import os
import pathlib
import queue
import subprocess
import threading
import time

MOLDLIGHT = os.environ["MOLDLIGHT_BINARY"]
ASSETS = pathlib.Path(__file__).parents[2] / "assets"
VERSION = "2025-06-18"


class Client:
    """A running server; what it says is kept as bytes and as messages."""

    def __init__(self, folder=ASSETS, version=VERSION):
        self.process = subprocess.Popen([MOLDLIGHT, "serve", "--stdio", "--folder", str(folder)],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.lines, self.arrived = [], queue.Queue()
        self.answers, self.notices, self.errors = [], [], []
        self.readers = [threading.Thread(target=self._read, daemon=True),
                        threading.Thread(target=lambda: self.errors.extend(self.process.stderr), daemon=True)]
        for reader in self.readers:
            reader.start()
        self.last_id = 0
        if version:
            self.hello = self.ask("initialize", {"protocolVersion": version, "capabilities": {},
                                                 "clientInfo": {"name": "test", "version": "1"}})
            self.send({"jsonrpc": "2.0", "method": "notifications/initialized"})

    def _read(self):
        for line in self.process.stdout:
            self.lines.append(line)
            message = json.loads(line.decode("utf-8"))
            if isinstance(message, dict) and "method" in message:
                self.notices.append((time.monotonic(), message))
            else:
                self.arrived.put(message)
        self.arrived.put(None)

    def send_bytes(self, line):
        self.process.stdin.write(line + b"\n")
        self.process.stdin.flush()

    def send(self, message):
        self.send_bytes(json.dumps(message).encode())

    def request(self, method, params=None):
        """Sends it; the id by which the answer is known."""
        self.last_id += 1
        message = {"jsonrpc": "2.0", "id": self.last_id, "method": method}
        self.send(message if params is None else {**message, "params": params})
        return self.last_id

    def next_message(self, timeout=60):
        """The next answer, or None at the end."""
        return self.arrived.get(timeout=timeout)

    def answer_to(self, asked, timeout=60):
        """Keeps what comes before it."""
        end = time.monotonic() + timeout
        for k, answer in enumerate(self.answers):
            if isinstance(answer, dict) and answer.get("id") == asked:
                return self.answers.pop(k)
        while True:
            message = self.next_message(max(0.0, end - time.monotonic()))
            if message is None:
                raise EOFError(b"".join(self.errors).decode())
            if isinstance(message, dict) and message.get("id") == asked:
                return message
            self.answers.append(message)

    def ask(self, method, params=None, timeout=60):
        return self.answer_to(self.request(method, params), timeout)

    def call(self, tool, timeout=60, **arguments):
        return self.ask("tools/call", {"name": tool, "arguments": arguments}, timeout)

    def peak_kib(self):
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text(encoding="ascii")
        return int(status.split("VmHWM:")[1].split()[0])

    def processor_s(self):
        """Seconds that it has computed, whatever else the machine does."""
        stat = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
        return (int(stat[11]) + int(stat[12])) / os.sysconf("SC_CLK_TCK")

    def close(self, timeout=60):
        """Ends the input; the exit code."""
        if not self.process.stdin.closed:
            self.process.stdin.close()
        code = self.process.wait(timeout)
        for reader in self.readers:
            reader.join(timeout)
        self.process.stdout.close()
        self.process.stderr.close()
        return code

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        try:
            self.close()
        except BrokenPipeError:
            pass
