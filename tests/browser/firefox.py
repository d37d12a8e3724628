"""Firefox on a display of its own, asked over WebDriver BiDi, so that the policy of a page holds and yet tests can ask it."""

import base64
import json
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import time

PROGRAM = shutil.which("firefox-esr") or shutil.which("firefox")
IS_THERE = bool(PROGRAM and shutil.which("Xvfb"))
PATIENCE_S = 120  # for its start, and for each answer


class Firefox:
    """With one page. `messages` are the errors of the page that is loaded; `requests` counts what it asked a network for."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        folder = pathlib.Path(self._folder.name)
        # Without a graphics card it draws by the processor only where that is asked for.
        (folder / "user.js").write_text('user_pref("webgl.force-enabled", true);\n')
        display = self._display()
        self._said = (folder / "said").open("w+")
        self._process = subprocess.Popen(
            [PROGRAM, "--remote-debugging-port", "0", "--no-remote", "--profile", str(folder)],
            env=os.environ | {"DISPLAY": display, "HOME": str(folder)},
            stdout=subprocess.DEVNULL,
            stderr=self._said,
        )
        self._unread, self._calls, self.messages, self.requests = b"", 0, [], 0
        self._connect()
        self._call("session.new", {"capabilities": {}})
        self._call("session.subscribe", {"events": ["log.entryAdded", "network.beforeRequestSent"]})
        self._context = self._call("browsingContext.getTree", {})["contexts"][0]["context"]

    def close(self):
        for process in (self._process, self._server):
            process.terminate()
            process.wait()
        self._said.close()
        self._socket.close()
        self._folder.cleanup()

    def load(self, page):
        """A file in place of the page before, until it has been read."""
        self.messages, self.requests = [], 0
        self._call("browsingContext.navigate", {"context": self._context, "url": page.as_uri(), "wait": "complete"})

    def resize(self, width, height):
        self._call("browsingContext.setViewport", {"context": self._context, "viewport": {"width": width, "height": height}})

    def value(self, expression):
        """What an expression is in the page, once that is known where it is a promise."""
        expression = f"Promise.resolve({expression}).then((found) => JSON.stringify(found) ?? 'null')"
        target = {"context": self._context}
        answer = self._call("script.evaluate", {"expression": expression, "target": target, "awaitPromise": True})
        if answer["type"] != "success":
            raise RuntimeError(answer["exceptionDetails"]["text"])
        return json.loads(answer["result"]["value"])

    def picture(self):
        """What the page shows, as PNG."""
        return base64.b64decode(self._call("browsingContext.captureScreenshot", {"context": self._context})["data"])

    def _display(self):
        read, write = os.pipe()
        words = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x1000x24", "-nolisten", "tcp"]
        self._server = subprocess.Popen(words, pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            return ":" + answer.readline().strip()

    def _connect(self):
        end = time.monotonic() + PATIENCE_S
        while not (found := re.search(r"ws://127\.0\.0\.1:(\d+)", pathlib.Path(self._said.name).read_text())):
            if time.monotonic() > end or self._process.poll() is not None:
                raise RuntimeError("Firefox does not start")
            time.sleep(0.05)
        self._socket = socket.create_connection(("127.0.0.1", int(found[1])), timeout=PATIENCE_S)
        key = base64.b64encode(os.urandom(16)).decode()
        lines = ["GET /session HTTP/1.1", f"Host: 127.0.0.1:{found[1]}", "Upgrade: websocket", "Connection: Upgrade"]
        lines += [f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13", "", ""]
        self._socket.sendall("\r\n".join(lines).encode())
        while b"\r\n\r\n" not in self._unread:
            self._unread += self._socket.recv(4096)
        self._unread = self._unread.partition(b"\r\n\r\n")[2]

    def _call(self, method, parameters):
        self._calls += 1
        self._send(json.dumps({"id": self._calls, "method": method, "params": parameters}).encode())
        while True:
            message = json.loads(self._message())
            if message.get("id") != self._calls:
                self._note(message)
                continue
            if message["type"] == "error":
                raise RuntimeError(message["message"])
            return message["result"]

    def _note(self, event):
        if event.get("method") == "log.entryAdded":
            self.messages.append(event["params"]["text"])
        elif event.get("method") == "network.beforeRequestSent":
            self.requests += event["params"]["request"]["url"].startswith("http")

    def _send(self, data):
        size = len(data)
        if size < 126:
            length = struct.pack(">B", 0x80 | size)
        elif size < 65536:
            length = struct.pack(">BH", 0x80 | 126, size)
        else:
            length = struct.pack(">BQ", 0x80 | 127, size)
        mask = os.urandom(4)
        masked = bytes(byte ^ mask[k % 4] for k, byte in enumerate(data))
        self._socket.sendall(b"\x81" + length + mask + masked)

    def _message(self):
        whole = b""
        while True:
            first, size = self._taken(2)
            size &= 127
            if size == 126:
                size = struct.unpack(">H", self._taken(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self._taken(8))[0]
            whole += self._taken(size)
            if first & 128:
                return whole

    def _taken(self, count):
        while len(self._unread) < count:
            more = self._socket.recv(1 << 20)
            if not more:
                raise RuntimeError("Firefox has ended")
            self._unread += more
        taken, self._unread = self._unread[:count], self._unread[count:]
        return taken
