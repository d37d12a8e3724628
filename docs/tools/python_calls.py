"""Prints every class and call of the Python module as Markdown, from the module's own docstrings."""

import inspect
import re
import textwrap

import moldlight


def paragraphs(text):
    """A docstring without its signature: settings as a list, signatures and examples as they stand."""
    text = inspect.cleandoc(text or "").split("--\n\n", 1)[-1]
    body, _, settings = text.partition("Settings; None leaves the default:\n")
    lines = [re.sub(r"([_*<|])", r"\\\1", line) for line in body.rstrip().splitlines()]
    lines = [line if not line or index + 1 == len(lines) or not lines[index + 1] else line + "\\"
             if re.match(r"\w+: ", lines[index + 1]) else line for index, line in enumerate(lines)]
    if settings:
        lines += ["", "Settings:", ""]
        for setting in re.split(r"\n(?=    \w)", settings.rstrip()):
            name, _, meaning = re.sub(r"\s+", " ", setting).strip().partition(": ")
            key, _, facts = name.partition(" (")
            facts = f" ({facts.removesuffix(')')})" if facts else ""
            lines += item(f"`{key}`{facts}: {meaning}")
    return "\n".join(lines)


def item(text):
    return textwrap.wrap(text, 110, initial_indent="- ", subsequent_indent="  ", break_long_words=False,
                         break_on_hyphens=False)


def signature(name, value):
    """Positional arguments and the first keywords; the settings stand in the table."""
    try:
        parameters = inspect.signature(value).parameters.values()
    except (TypeError, ValueError):
        return name
    call = name.rpartition(".")[2]
    known = {setting["key"] for setting in moldlight.settings(call)} if call in CALLS else set()
    kept = [str(each) for each in parameters if each.name not in known and each.name != "self"]
    more = ", …" if known else ""
    return f"{name}({', '.join(kept)}{more})"


CALLS = ("Part", "read", "classify", "draft", "sweep", "actions", "mold", "compare", "picture", "to_html", "to_pdf")


def members(owner):
    own = [(name, value) for name, value in vars(owner).items() if not name.startswith("_")]
    values = [(name, value) for name, value in own if inspect.isdatadescriptor(value)]
    calls = [(name, getattr(owner, name)) for name, value in own if not inspect.isdatadescriptor(value)]
    if values:
        print("\nValues:\n")
        for name, value in values:
            text = re.sub(r"\s+", " ", inspect.cleandoc(value.__doc__ or "")).strip()
            print("\n".join(item(f"`{name}`: {text}" if text else f"`{name}`")))
    for name, value in calls:
        print(f"\n#### `{signature(owner.__name__ + '.' + name, value)}`\n\n{paragraphs(value.__doc__)}")


def main():
    for name in moldlight.__all__:
        value = getattr(moldlight, name)
        if inspect.isclass(value):
            print(f"\n### `{signature(name, value)}`\n\n{paragraphs(value.__doc__)}")
            if not issubclass(value, Exception):
                members(value)
        elif callable(value):
            print(f"\n### `{signature(name, value)}`\n\n{paragraphs(value.__doc__)}")
        else:
            print(f"\n### `{name}`\n\n`{value}`")


if __name__ == "__main__":
    main()
