"""What the sweep, the side actions and the mold have in common: a question about the part of mold regions, its answer
kept while neither changes, and its report in the document."""

import json

from . import progress, properties, regions
from .engine import isolated, translate


class Analysis(properties.Proxy):
    """`call` is the part's method, `keys` the settings that the object has as properties. Regions give the rest."""

    call = ""
    keys = ()
    title = ""
    follows_direction = True
    _found = None  # (part, asked, answer)

    def add_properties(self, obj):
        properties.add_link(obj, "Regions", translate("Moldlight", "The mold regions that it belongs to"))
        properties.add_settings(obj, self.call, self.keys)
        properties.add_result(obj, "App::PropertyString", "Report",
                              translate("Moldlight", "The report of moldlight, as JSON"), hidden=True)

    def found(self, obj, listener=None):
        """(part, answer), asked anew if body, direction or settings have changed."""
        asked_of = regions.of_result(obj)
        part = asked_of.Proxy.faceted_part(asked_of, listener)
        along = (tuple(regions.direction(asked_of)),) if self.follows_direction else ()
        settings = properties.settings(asked_of, "classify", regions.CLASSIFY_KEYS)
        settings.update(properties.settings(obj, self.call, self.keys))
        if self._found is None or self._found[0] is not part or self._found[1] != (along, settings):
            answer = getattr(part.part, self.call)(*along, isolated=isolated(), progress=listener, **settings)
            self._found = (part, (along, settings), answer)
        return part, self._found[2]

    def prepare(self, obj, listener):
        self.found(obj, listener)

    def execute(self, obj):
        with progress.shown(translate("Moldlight", self.title)) as listener:
            part, answer = self.found(obj, listener)
            obj.Report = answer.to_json()
            self.show(obj, part, answer, listener)

    def show(self, obj, part, answer, listener):
        """Sets what the object shows of the answer."""


def report(obj):
    """The report of an analysis as a dict; empty before the first one."""
    return json.loads(obj.Report) if obj.Report else {}
