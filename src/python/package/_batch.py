"""The same call of many parts."""

import collections
import os
import threading
from concurrent.futures import ThreadPoolExecutor

from ._core import Error, Part, UsageError, settings

_CALLS = ("classify", "draft", "sweep", "actions", "mold", "pieces")
BatchResult = collections.namedtuple("BatchResult", "source part result error")
BatchResult.__doc__ = "What batch() found of one part."
BatchResult.source.__doc__ = "The part as it was given."
BatchResult.part.__doc__ = "The Part; None where it could not be read."
BatchResult.result.__doc__ = "What the call returned; None where it failed."
BatchResult.error.__doc__ = "The moldlight.Error where it failed, else None."


def batch(parts, call, jobs=None, **keywords):
    """Reads many parts and calls each, several at a time: yields a BatchResult for each, in their order.

    parts: names, or whatever Part.read takes; they are taken as they are needed.
    call: "classify", "draft", "sweep", "actions", "mold" or "pieces".
    jobs: how many at a time; the number of cores if left out.
    keywords: those of Part.read and of the call, direction among them.

    A part that fails has an error and holds up no other. Leaving the loop ends what still runs.
    """
    if call not in _CALLS:
        raise UsageError(f"batch: {call!r} is no call of a part; name one of {', '.join(_CALLS)}")
    names = {"format", *(setting["key"] for setting in settings("read"))}
    reading = {name: keywords.pop(name) for name in names & keywords.keys()}
    return _results(parts, call, jobs or os.cpu_count() or 1, reading, keywords)


def _results(parts, call, jobs, reading, keywords):
    left = threading.Event()

    def goes_on(*_):
        return not left.is_set()

    def found(source):
        part = None
        try:
            part = Part.read(source, progress=goes_on, **reading)
            return BatchResult(source, part, getattr(part, call)(progress=goes_on, **keywords), None)
        except UsageError:
            raise  # of all parts
        except Error as error:
            return BatchResult(source, part, None, error)

    waiting = collections.deque()
    with ThreadPoolExecutor(jobs) as threads:
        try:
            for source in parts:
                waiting.append(threads.submit(found, source))
                if len(waiting) > jobs:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            left.set()
            for each in waiting:
                each.cancel()
