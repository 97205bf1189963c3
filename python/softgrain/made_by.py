# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What made a run: all that its scene says with includes and changes, the contents of the files that
it names, and the program.

A run that is there already is used again only when all of that is the same. made_by.json in its
folder keeps it.
"""

import glob
import hashlib
import json
import os
import re
from dataclasses import dataclass

from .errors import InputError
from .prm_file import read_prm

NAME = "made_by.json"
PATHS = (
    "Additional shared libraries",
    "Output directory",
    "Packing/File",
    "Packing/Class table",
    "Packing/Save to",
    "Primaries/Library",
    "Contact/Keep failed problems in",
)  # in a file they count from its folder
NOT_READ = (
    "Save to",
    "Library",
)  # last names of parameters whose file is written, or keeps what can be made anew
NO_RESULT = ("Output directory", "Threads")  # where and how, but not what is computed
UNREAD = "its text"  # the only entry of a file that cannot be read
TOLD = 3  # differences in a message


@dataclass(frozen=True)
class Origin:
    """What made a run."""

    parameters: dict  # {"Section/Name": text}, of the scene and what was changed in it
    files: dict  # {path as the scene has it: digest of what is in it}
    program: str

    @property
    def digest(self):
        """A name for all of it."""
        text = repr((sorted(self.parameters.items()), sorted(self.files.items()), self.program))
        return hashlib.sha256(text.encode()).hexdigest()

    def differences(self, asked):
        """
        What is different in this origin from the one that is asked for, as words; nothing when both
        are the same.
        """
        found = [
            f"{name} = {self.parameters.get(name, 'its default')} (asked for:"
            f" {asked.parameters.get(name, 'its default')})"
            for name in {**asked.parameters, **self.parameters}
            if self.parameters.get(name) != asked.parameters.get(name)
        ]
        found += [
            f"another content of {path}"
            for path in {**asked.files, **self.files}
            if path in asked.files and path in self.files and self.files[path] != asked.files[path]
        ]
        if self.program != asked.program:
            found.append("another program")
        return found


def digest_of(path):
    """The digest of what is in a file."""
    found = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            found.update(block)
    return found.hexdigest()[:16]


def moved(text, folder):
    """
    The paths of a value, a list with commas, as they are found from @folder away.

    >>> moved("grains.csv, /data/b.csv", "../scenes"), moved("libgel.so", "..")
    ('../scenes/grains.csv, /data/b.csv', 'libgel.so')
    """
    paths = [one.strip() for one in text.split(",") if one.strip()]
    return ", ".join(
        (
            os.path.normpath(os.path.join(folder, one))
            if "/" in one or ".so" not in one or os.path.isfile(os.path.join(folder, one))
            else one
        )
        for one in paths
    )


def entries_of(scene):
    """
    {"Section/Name": (text, folder of the file that says it)} of a parameter file with its includes,
    .prm or .json. Of one that cannot be read there is only what stands in it: the program says what
    is wrong.
    """
    folder = os.path.dirname(scene)
    try:
        if scene.endswith(".json"):
            with open(scene, encoding="utf-8") as file:
                return {name: (text, folder) for name, text in flattened(json.load(file))}
        return {
            "/".join(key): (item.text, os.path.dirname(item.where.rpartition(":")[0]))
            for key, item in read_prm(scene).items()
        }
    except (InputError, ValueError, AttributeError):
        return {UNREAD: (digest_of(scene), folder)}


def flattened(found, path=()):
    """(path, text) of every value of a parameter file in JSON."""
    for name, value in found.items():
        if isinstance(value, dict) and "value" in value:
            value = value["value"]
        if isinstance(value, dict):
            yield from flattened(value, (*path, name))
        else:
            yield "/".join((*path, name)), value if isinstance(value, str) else json.dumps(value)


def files_named(text, folders):
    """
    Files that a value names, in the folders where they may be.

    >>> open("grains.csv", "w").close()
    >>> files_named("grains.csv, none.csv, 3", ("", "nowhere"))
    ['grains.csv']
    """
    names = [one.strip() for one in re.split("[,;]", text)]
    places = [
        os.path.join(folder, name) for name in names if name for folder in dict.fromkeys(folders)
    ]
    return [place for place in places if os.path.isfile(place)]


def program_digest(program):
    """The digest of a program and of its library."""
    place = os.path.dirname(os.path.dirname(os.path.realpath(program)))
    libraries = {
        os.path.realpath(path)
        for pattern in ("lib*/libsoftgrain*", "lib*/*/libsoftgrain*")
        for path in glob.glob(os.path.join(glob.escape(place), pattern))
        if os.path.isfile(path)
    }
    return " ".join(map(digest_of, [program, *sorted(libraries)]))


class Origins:
    """The origins of runs of a scene by a program; what both are is read once."""

    def __init__(self, scene, program):
        self.entries, self.program, self.digests = (
            entries_of(os.fspath(scene)),
            program_digest(program),
            {},
        )

    def digest(self, path):
        if path not in self.digests:
            self.digests[path] = digest_of(path)
        return self.digests[path]

    def of(self, changes):
        """The Origin with @changes {"Section/Name": text}."""
        entries = {**self.entries, **{name: (text, "") for name, text in changes.items()}}
        entries = {name: found for name, found in entries.items() if name not in NO_RESULT}
        files = {
            path: self.digest(path)
            for name, (text, folder) in entries.items()
            if name.rpartition("/")[2] not in NOT_READ
            for path in files_named(text, (folder,))
        }
        return Origin({name: text for name, (text, _) in entries.items()}, files, self.program)


def write_origin(folder, origin):
    """Keeps in the folder of a run what made it; where nothing was begun there is none."""
    written = os.path.join(folder, "parameters.prm")
    if not os.path.isfile(written):
        return
    data = {**vars(origin), "digest": origin.digest, "parameters.prm": digest_of(written)}
    with open(os.path.join(folder, f"{NAME}.part"), "w", encoding="utf-8") as file:
        json.dump(data, file, indent=1)
    os.replace(os.path.join(folder, f"{NAME}.part"), os.path.join(folder, NAME))


def read_origin(folder):
    """
    (what made the run in a folder, digest of its parameters.prm then); None when it does not say.
    """
    path = os.path.join(folder, NAME)
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        return Origin(data["parameters"], data["files"], data["program"]), data["parameters.prm"]
    except FileNotFoundError:
        return None
    except (ValueError, KeyError, TypeError) as error:
        raise InputError(f"{path} is damaged: {error!r}") from error


def why_not(folder, origin):
    """
    Why the run in a folder is none of this origin, as words; '' when it is. None when nobody knows
    what made it.
    """
    found = read_origin(folder)
    if found is None:
        return None
    there, written = found
    path = os.path.join(folder, "parameters.prm")
    if not os.path.isfile(path) or digest_of(path) != written:
        return "other parameters, put there since"
    found = there.differences(origin)
    return "; ".join(found[:TOLD]) + (
        f" and {len(found) - TOLD} more differences" if len(found) > TOLD else ""
    )
