"""Calls with isolated=True: a process of its own does the work and keeps the result. What ends that process is an
Error here, and nothing else is lost."""

import functools
import io
import itertools
import os
import pickle
import queue
import select
import shutil
import signal
import struct
import subprocess
import sys
import threading
import weakref

from . import _core

_HEAD = struct.Struct("<Q")
_RESULT = 0  # the place of what the call found; results of that have others
_START = "import sys; sys.path[:] = {path!r}; from moldlight import _isolated; _isolated.serve()"
# What stays in the process that found it; parts and errors go over as they are.
_KEPT = tuple(value for value in vars(_core).values()
              if isinstance(value, type) and not issubclass(value, (BaseException, _core.Part)))


def _interpreter():
    """The Python that such a process runs: this one, or that of the version which a program has in it. None where
    there is none."""
    version = "python%d.%d" % sys.version_info[:2]
    own = sys.executable if os.path.basename(sys.executable or "").startswith("python") else None
    for name in (own, os.path.join(sys.exec_prefix, "bin", version), shutil.which(version)):
        if name and os.access(name, os.X_OK):
            return name
    return None


def can_isolate():
    """Whether isolated=True can be asked for: a program that has Python in itself may have no other one beside it."""
    return _interpreter() is not None


def _packed(value, persistent_id):
    packed = io.BytesIO()
    pickler = pickle.Pickler(packed, pickle.HIGHEST_PROTOCOL)
    pickler.persistent_id = persistent_id
    pickler.dump(value)
    return packed.getvalue()


def _unpacked(packed, persistent_load):
    unpickler = pickle.Unpickler(io.BytesIO(packed))
    unpickler.persistent_load = persistent_load
    return unpickler.load()


class _Process:
    """One such process, and the questions that it answers one after another: first the call, then what its result is
    asked for. Where it has ended before a question comes, another one finds the result again."""

    def __init__(self):
        self._lock = threading.Lock()
        self._call = None  # as it was sent
        self._released = []
        self._start()

    def _start(self):
        program = _interpreter()
        if program is None:
            raise _core.Error("isolated: there is no Python to start another process with; leave isolated out")
        self._child = subprocess.Popen([program, "-c", _START.format(path=sys.path)], stdin=subprocess.PIPE,
                                       stdout=subprocess.PIPE, bufsize=0, start_new_session=True)
        self._read = bytearray()
        self._whole = True  # nothing of a question or an answer is on its way
        self._released.clear()
        weakref.finalize(self, _end, self._child, os.getpid())

    def ask(self, place, name, arguments=(), keywords=None, listener=None):
        """What the result at `place` has by that name, called with the arguments unless they are None."""
        question = (os.getcwd(), place, name, arguments, keywords or {}, listener is not None)
        try:
            packed = _packed(question, lambda value: None)
        except (pickle.PicklingError, TypeError, AttributeError) as error:
            raise _core.UsageError(f"{name}: an isolated call takes names, numbers and arrays alone ({error})") from None
        with self._lock:
            if place is None:
                self._call = packed
            elif self._child.poll() is not None:
                if place != _RESULT:
                    raise _core.Error(str(_Ended(self._child.returncode)))
                self._start()
                self._put(self._call, lambda *_: None, lambda kept: None)
            return self._put(packed, listener, lambda kept: self._result(*kept))

    def _put(self, packed, listener, load):
        released, self._released[:] = self._released[:], []
        self._whole = False
        try:
            self._send(b"free", _packed(released, lambda value: None))
            self._send(b"call", packed)
            return self._answer(listener, load)
        except KeyboardInterrupt:
            if not self._whole:
                self._child.kill()  # half a question was sent, or half an answer taken
            raise

    def _answer(self, listener, load):
        raised = None
        while True:
            try:
                packed = self._receive()
            except _Ended as ended:
                raise _core.Error(str(ended)) from None
            except BaseException as error:  # of a signal's handler
                if raised is not None:
                    raise  # whoever asks twice does not wait
                raised = error
                self._send(b"stop", b"")
                continue
            kind, value = _unpacked(packed, load)
            if kind == "progress":
                if raised is None:
                    raised = self._told(listener, value)
                continue
            self._whole = True
            if raised is not None or kind == "raised":
                raise raised or value
            return value

    def _told(self, listener, report):
        """What the listener raised."""
        try:
            if listener(*report) is False:
                self._send(b"quit", b"")
        except BaseException as error:
            self._send(b"stop", b"")
            return error
        return None

    def _result(self, owner, place):
        result = Isolated(self, owner, place)
        if place != _RESULT:
            weakref.finalize(result, self._released.append, place)
        return result

    def _send(self, kind, packed):
        try:
            for data in (kind + _HEAD.pack(len(packed)), packed):
                while data:
                    data = data[self._child.stdin.write(data):]
        except BrokenPipeError:
            pass  # the answer gives the reason

    def _receive(self):
        # A signal's handler may raise between two looks; what was read stays.
        while True:
            if len(self._read) >= _HEAD.size:
                end = _HEAD.size + _HEAD.unpack_from(self._read)[0]
                if len(self._read) >= end:
                    packed = bytes(self._read[_HEAD.size:end])
                    del self._read[:end]
                    return packed
            select.select([self._child.stdout], [], [])
            some = os.read(self._child.stdout.fileno(), 1 << 20)
            if not some:
                raise _Ended(self._child.wait())
            self._read += some


class _Ended(Exception):
    def __init__(self, code):
        names = {number.value: number.name for number in signal.Signals}
        how = f"by {names.get(-code, -code)}" if code < 0 else f"with exit code {code}"
        super().__init__(f"the process that did the work ended {how}; nothing but its result is lost")


def _end(child, owner):
    if os.getpid() != owner:
        return  # a fork of it
    child.stdin.close()
    child.stdout.close()
    child.kill()
    child.wait()


class Isolated:
    """A result in the process that found it. It has what the class of that name has; arrays are copies."""

    def __init__(self, process, owner, place):
        self._process, self._owner, self._place = process, getattr(_core, owner), place

    __class__ = property(lambda self: self._owner)

    def __getattr__(self, name):
        if name.startswith("__") or name in ("_process", "_owner", "_place"):
            raise AttributeError(name)
        member = getattr(self._owner, name)
        if isinstance(member, property):
            return self._process.ask(self._place, name, None)

        def call(*arguments, progress=None, **keywords):
            return self._process.ask(self._place, name, arguments, keywords, progress)

        return functools.wraps(member)(call)

    def __dir__(self):
        return dir(self._owner)

    def __repr__(self):
        return self._process.ask(self._place, "__repr__")

    def __reduce__(self):
        return pickle.loads, (self._process.ask(self._place, "pickled"),)


def isolating(call):
    """The call with the keyword isolated."""

    @functools.wraps(call)
    def either(*arguments, isolated=False, **keywords):
        if not isolated:
            return call(*arguments, **keywords)
        listener = keywords.pop("progress", None)
        return _Process().ask(None, call.__name__, arguments, keywords, listener)

    return either


# In the process:

class _Work:
    runs = False  # else there is nothing to stop
    goes_on = True  # what the listener says


def serve():
    """Answers what is asked over the pipe, until it is closed."""
    answers = os.fdopen(os.dup(1), "wb")
    questions = os.fdopen(os.dup(0), "rb")
    os.dup2(2, 1)  # what is printed belongs to no answer
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    _give_way()
    signal.signal(signal.SIGINT, _stop)
    kept, asked, places = {}, queue.SimpleQueue(), itertools.count()
    threading.Thread(target=_listen, args=(questions, asked, kept), daemon=True).start()

    def persistent_id(value):
        if not isinstance(value, _KEPT):
            return None
        place = next(places)
        kept[place] = value
        return type(value).__name__, place

    def send(kind, value):
        packed = _packed((kind, value), persistent_id)
        answers.write(_HEAD.pack(len(packed)) + packed)
        answers.flush()

    while True:
        question = asked.get()
        try:
            _Work.runs = True
            answer = "value", _found(question, kept, send)
            _Work.runs = False
        except BaseException as error:
            _Work.runs = False
            answer = "raised", error
        try:
            send(*answer)
        except (pickle.PicklingError, TypeError, AttributeError) as error:
            send("raised", _core.Error(f"{answer[1]!r} does not go from process to process: {error}"))


def _found(question, kept, send):
    folder, place, name, arguments, keywords, listened_to = pickle.loads(question)
    os.chdir(folder)
    if listened_to:
        keywords["progress"] = lambda stage, share: send("progress", (stage, share)) or _Work.goes_on
    if place is None:
        owner = _core if hasattr(_core, name) else _core.Part
        return getattr(owner, name)(*arguments, **keywords)
    if name == "pickled":
        return pickle.dumps(kept[place])
    member = getattr(kept[place], name)
    return member if arguments is None else member(*arguments, **keywords)


def _listen(questions, asked, kept):
    while True:
        head = questions.read(4 + _HEAD.size)
        if len(head) < 4 + _HEAD.size:
            os._exit(0)  # nobody asks any more
        packed = questions.read(_HEAD.unpack_from(head, 4)[0])
        if head[:4] == b"stop":
            signal.raise_signal(signal.SIGINT)
        elif head[:4] == b"quit":
            _Work.goes_on = False
        elif head[:4] == b"free":
            for place in pickle.loads(packed):
                kept.pop(place, None)
        else:
            _Work.goes_on = True
            asked.put(packed)


def _stop(*_):
    if _Work.runs:
        raise KeyboardInterrupt


def _give_way():
    """Where memory runs out, this process ends and not the one that asks."""
    try:
        with open("/proc/self/oom_score_adj", "w", encoding="ascii") as file:
            file.write("1000")
    except OSError:
        pass
