"""The shared libraries that programs and modules need, carried beside them: copied, found there, with their licences.

What every Linux has is left to it: glibc and the runtime of GCC. Renamed copies keep a process that has other versions of
them open from mixing the two.
"""

import os
import pathlib
import re
import shutil
import subprocess

OF_THE_SYSTEM = re.compile(r"(linux-vdso|.*/ld-linux-|lib(c|m|dl|pthread|rt|resolv|util|stdc\+\+|gcc_s)\.so)")
# Where Debian has the licences that many packages share.
COMMON_LICENSES = pathlib.Path("/usr/share/common-licenses")


def ran(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed(files):
    """The libraries of files and, in turn, of these: where each is, by the name under which it is asked for."""
    found = {}
    for line in ran("ldd", *files).splitlines():
        name, arrow, place = line.strip().partition(" => ")
        if not arrow or OF_THE_SYSTEM.match(name):
            continue
        if place.startswith("not found"):
            raise FileNotFoundError(f"{name} is not found")
        found[name] = pathlib.Path(place.split(" (")[0]).resolve()
    return found


def own_name(name):
    stem, dot, version = name.partition(".so")
    return f"{stem}-moldlight{dot}{version}"


def looks_in(file, folder):
    """Makes a file find libraries in a folder wherever both are moved together. DT_RPATH holds for what it opens, too."""
    way = os.path.join("$ORIGIN", os.path.relpath(folder, file.parent))
    subprocess.run(["patchelf", "--force-rpath", "--set-rpath", way.removesuffix("/."), file], check=True)


def copied(source, target):
    shutil.copyfile(source, target)
    target.chmod(0o755)
    return target


def packages_of(files):
    """The Debian packages that files come from; some name theirs without /usr."""
    names = {file: (str(file), str(file).removeprefix("/usr")) for file in files}
    asked = [name for pair in names.values() for name in pair]
    answer = subprocess.run(["dpkg-query", "-S", *asked], capture_output=True, text=True).stdout
    owners = {file: owner.split(":")[0] for owner, _, file in (line.rpartition(": ") for line in answer.splitlines())}
    for file, pair in names.items():
        if not owners.keys() & set(pair):
            raise FileNotFoundError(f"{file} belongs to no package, so its licence is not known")
    return sorted(set(owners.values()))


def add_licences(sources, folder):
    """The licence of each package that a file comes from, and the common ones that these refer to."""
    folder.mkdir(parents=True, exist_ok=True)
    for package in packages_of(sources):
        text = pathlib.Path("/usr/share/doc", package, "copyright").read_text(encoding="utf-8", errors="replace")
        (folder / package).write_text(text, encoding="utf-8")
        for name in set(re.findall(rf"{COMMON_LICENSES}/([\w.-]*\w)", text)):
            shutil.copyfile(COMMON_LICENSES / name, folder / name)


def carry(files, folder, rename=False, there=()):
    """Copies what the files need into the folder, but for names that are `there`. Returns where the copies are from."""
    folder.mkdir(parents=True, exist_ok=True)
    libraries = {name: source for name, source in needed(files).items() if name not in there}
    names = {name: own_name(name) if rename else name for name in libraries}
    copies = [copied(source, folder / names[name]) for name, source in libraries.items()]
    if rename:
        for name, copy in zip(libraries, copies):
            subprocess.run(["patchelf", "--set-soname", names[name], copy], check=True)
        for file in (*copies, *files):
            asked = set(ran("patchelf", "--print-needed", file).split()) & set(names)
            changes = [word for name in asked for word in ("--replace-needed", name, names[name])]
            if changes:
                subprocess.run(["patchelf", *changes, file], check=True)
    for file in (*copies, *files):
        looks_in(file, folder)
    return list(libraries.values())
