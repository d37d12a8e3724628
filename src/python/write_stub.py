"""Writes the type stub of the package: the settings in it come from the module's own option tables.

    PYTHONPATH=<folder of the package> python3 write_stub.py <template> <stub>
"""

import sys

import moldlight

CALLS = ("Part", "read", "classify", "sweep", "actions", "mold", "picture")


def arguments(call):
    return ", ".join(f"{setting['key']}: Optional[{setting['type']}] = ..." for setting in moldlight.settings(call))


def main(template, stub):
    with open(template, encoding="utf-8") as file:
        text = file.read()
    head, rest = text.split('"""\n', 1)
    for call in CALLS:
        rest = rest.replace("{" + call + "}", arguments(call))
    with open(stub, "w", encoding="utf-8") as file:
        file.write('"""What type checkers know of moldlight."""\n' + rest)


if __name__ == "__main__":
    main(*sys.argv[1:])
