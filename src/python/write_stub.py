"""Writes the type stub of the package: the settings in it come from the module's own option tables.

    PYTHONPATH=<folder of the package> python3 write_stub.py <template> <stub>
"""

import re
import sys

import moldlight


def arguments(call):
    return ", ".join(f"{setting['key']}: Optional[{setting['type']}] = ..." for setting in moldlight.settings(call))


def main(template, stub):
    with open(template, encoding="utf-8") as file:
        text = file.read()
    head, rest = text.split('"""\n', 1)
    rest = re.sub(r"\{(\w+)\}", lambda call: arguments(call[1]), rest)
    with open(stub, "w", encoding="utf-8") as file:
        file.write('"""What type checkers know of moldlight."""\n' + rest)


if __name__ == "__main__":
    main(*sys.argv[1:])
