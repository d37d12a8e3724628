"""Checks the blocks of a page: runs what is to be run, compares what is shown, reads what is only shown.

    python3 page_check.py [--update] PAGE…

`--update` writes the output of now into the pages. The exit code is 1 if a page is wrong.
"""

import functools
import pathlib
import re
import subprocess
import sys

import blocks
import runs
import shown


@functools.cache
def known_flags():
    """The flags of each command, from the completion that the program writes: {"classify": {"--json", …}}."""
    text = subprocess.run([runs.program(), "manual", "--form", "bash"], capture_output=True, text=True,
                          check=True).stdout
    return {name: set(flags.split()) for name, flags in re.findall(r'^ +"([a-z ]+)"\) flags="([^"]*)"', text, re.M)}


def wrong_flags(text):
    """Flags of moldlight commands in a script that the program does not have."""
    found = []
    for line in text.replace("\\\n", " ").splitlines():
        call = re.search(r"\bmoldlight ((?:batch )?[a-z]+)((?:\s[^|;&#]*)?)", line)
        if not call or call.group(1) not in known_flags():
            continue
        # What stands after -- are flags of the batch's work.
        own, _, work = call.group(2).partition(" -- ")
        allowed = known_flags()[call.group(1)]
        found += [flag for flag in re.findall(r"(?<!\S)--[a-z0-9-]+", own) if flag not in allowed | {"--help"}]
        name, _, flags = work.strip().partition(" ")
        if work:
            found += [flag for flag in re.findall(r"(?<!\S)--[a-z0-9-]+", flags) if flag not in known_flags()[name]]
    return found


class PageCheck:
    def __init__(self, page, update):
        self.page, self.update = page, update
        self.lines = blocks.read(page)
        self.changes = []  # (first, last, lines) of the page
        self.faults = []
        self.session = runs.Session()

    def fault(self, line, text):
        self.faults.append(f"{self.page.relative_to(blocks.ROOT)}:{line}: {text}")

    def compare(self, first, last, actual):
        before = "\n".join(self.lines[first:last])
        why = shown.difference(before, actual)
        if why is None:
            return
        after = shown.refreshed(self.lines[first:last], actual) if self.update and before else None
        if after is None or shown.difference("\n".join(after), actual):
            self.fault(first + 1, f"{why}; the command prints:\n{actual}")
        else:
            self.changes.append((first, last, after))

    def console(self, block):
        commands = blocks.commands(block)
        for number, command in enumerate(commands):
            actual = self.session.command(command.text)
            asked = number + 1 < len(commands) and commands[number + 1].text == "echo $?"
            if self.session.status != 0 and not asked:
                self.fault(command.first, f"{command.text}: exit code {self.session.status}: {self.session.errors}")
            elif command.shown:  # a page may also run a command without showing what it prints
                self.compare(command.first, command.last, actual)

    def python(self, block, output):
        actual = self.session.python("\n".join(block.lines))
        if self.session.status != 0:
            self.fault(block.first, self.session.errors)
        elif output:
            self.compare(output.first, output.last, actual)
        elif actual:
            self.fault(block.first, f"its output is not shown:\n{actual}")

    def script(self, block):
        text = "\n".join(block.lines)
        syntax = subprocess.run(["bash", "-n", "-c", text], capture_output=True, text=True, check=False)
        if syntax.returncode != 0:
            self.fault(block.first, syntax.stderr)
        for flag in wrong_flags(text):
            self.fault(block.first, f"{flag} is no flag of that command")

    def workflow(self, block, run):
        """Commands of a build server's job: all of them are run on this page."""
        commands = [line.strip().removeprefix("- ").removeprefix("run: ") for line in block.lines]
        commands = [command for command in commands if command.startswith("moldlight ")]
        for command in commands or ["a command of moldlight"]:
            if command not in run:
                self.fault(block.first, f"{command} is not run on this page")

    def made(self, block):
        actual = self.session.made(block.lines[0]).strip("\n").splitlines()
        if self.session.status != 0:
            self.fault(block.first, self.session.errors)
        elif actual != self.lines[block.first:block.last]:
            if self.update:
                self.changes.append((block.first, block.last, actual))
            else:
                self.fault(block.first, f"differs from what `{block.lines[0]}` prints; docs/update writes it anew")

    def run(self):
        found = blocks.blocks(self.lines)
        run = {command.text for block in found if block.kind == "console" for command in blocks.commands(block)}
        for block, following in zip(found, [*found[1:], None]):
            if block.kind == "console":
                self.console(block)
            elif block.kind == "python":
                self.python(block, following if following and following.kind == "output" else None)
            elif block.kind == "sh":
                self.script(block)
            elif block.kind == "yaml":
                self.workflow(block, run)
            elif block.kind == "made by":
                self.made(block)
        self.session.close()
        for first, last, lines in reversed(self.changes):
            self.lines[first:last] = lines
        if self.changes:
            self.page.write_text("\n".join(self.lines) + "\n", encoding="utf-8")
            print(f"{self.page.relative_to(blocks.ROOT)}: {len(self.changes)} blocks written anew")
        return self.faults


def main(arguments):
    update = "--update" in arguments
    named = [pathlib.Path(each).resolve() for each in arguments if each != "--update"]
    faults = [fault for page in named or blocks.pages() for fault in PageCheck(page, update).run()]
    print("\n".join(faults), file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
