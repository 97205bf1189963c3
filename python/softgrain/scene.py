# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Scenes built in Python. Sections and parameters are those that the program lists, so that none is
unknown here or outdated; what values may be is checked by the program, as it checks a file.

    scene = softgrain.Scene()
    scene.materials.add("gel", law="neo_hookean", density=1000, youngs_modulus=1e6)
    scene.packing(number=100, upper=(20e-3, 20e-3), seed=3)
    scene.contact.friction = 0.3
    scene.write("scene.prm")
"""

import copy
import difflib
import os
import re
from collections.abc import Mapping
from typing import Dict, Iterable, Iterator, List, Optional

import numpy as np

from .errors import InputError, MissingName
from .listing import NAMES, Listed, listing, python_name
from .made_by import PATHS, UNREAD, entries_of, moved
from .parameters import plain
from .programs import call, find_program, run
from .scene_text import grains_text, scene_text, value_text


class MissingParameter(MissingName, AttributeError):
    """There is no such parameter or section; Python asks for attributes that need not be there."""


class Section:
    """
    A section of a scene. Its parameters and subsections are attributes, with the names of files in
    small letters: `scene.mesh.cell_size` is 'Mesh/Cell size'. Calling it sets several, and one that
    is not set has the default.
    """

    def __init__(self, listed: Listed, path: str, scene: "Scene", name: str = ""):
        self.__dict__.update(
            _listed=listed, _path=path, _scene=scene, _name=name, _values={}, _sections={}
        )

    # --- names ---

    def _own(self) -> Dict[str, str]:
        """Names in files by those in Python, without the list of names, which `add` keeps."""
        return {
            python_name(name): name
            for name in [*self._listed.sections, *self._listed.entries]
            if name != NAMES
        }

    def _law(self) -> Optional["Section"]:
        """Of a material the section of its law: its parameters are found in the material, too."""
        law = (
            self._values.get("Law", self._listed.entries["Law"].default)
            if "Law" in self._listed.entries
            else None
        )
        name = next(
            (
                name
                for name in self._listed.sections
                if law is not None and plain(name) == plain(law)
            ),
            None,
        )
        return self._section(name) if name else None

    def _section(self, name: str) -> "Section":
        if name not in self._sections:
            listed = self._listed.sections.get(name) or self._listed.named
            self._sections[name] = (Group if NAMES in listed.entries else Section)(
                listed, f"{self._path}{name}/", self._scene, name
            )
        return self._sections[name]

    def _is_named(self, name: str) -> bool:
        """Whether it is a subsection with a name of one's own: of a stage that of a wall."""
        return self._listed.named is not None and name in self._scene.walls

    def _known(self) -> List[str]:
        law = self._law()
        return [*self._own(), *(law._own() if law else [])]

    def _missing(self, name: str, known: Iterable[str] = ()) -> MissingParameter:
        """@known: the names that there are, of files; else those that Python has."""
        known = list(known) or self._known()
        near = difflib.get_close_matches(name, known, 1, 0.6)
        where = f"'{self._path.rstrip('/')}'" if self._path else "a scene"
        return MissingParameter(
            f"{where} has no '{name}'"
            + (
                f"; did you mean '{near[0]}'?"
                if near
                else f"; there are {', '.join(sorted(known)) or 'none'}"
            )
        )

    # --- values ---

    def __getattr__(self, name: str):
        if name.startswith("_"):
            raise AttributeError(name)
        own = self._own().get(name)
        if own is not None and own in self._listed.sections:
            return self._section(own)
        if own is not None:
            return self._values.get(own, self._listed.entries[own].default)
        if self._is_named(name):
            return self._section(name)
        if (law := self._law()) is not None and name in law._own():
            return getattr(law, name)
        raise self._missing(name)

    def __setattr__(self, name: str, value) -> None:
        own = self._own().get(name)
        section = (
            own
            if own in self._listed.sections
            else name if own is None and self._is_named(name) else None
        )
        if section is not None:
            if not isinstance(value, Mapping):
                raise InputError(
                    f"'{self._path}{section}' is a section: a dict of its parameters can be given,"
                    f" not {value!r}"
                )
            self._section(section)(**value)
        elif own is not None and value is None:
            self._values.pop(own, None)  # its default
        elif own is not None:
            self._values[own] = value_text(value, self._listed.entries[own])
        elif (law := self._law()) is not None and name in law._own():
            setattr(law, name, value)
        else:
            raise self._missing(name)

    def __delattr__(self, name: str) -> None:
        """The parameter has its default again, the section is empty."""
        own = self._own().get(name)
        if own is None:
            raise self._missing(name)
        self._values.pop(own, None)
        self._sections.pop(own, None)

    def __call__(self, **values) -> "Section":
        """
        Sets several parameters; those of a subsection as a dict, `stop={"end_time": 1}`. Returns
        the section.
        """
        for name, value in sorted(
            values.items(), key=lambda one: one[0] != "law"
        ):  # the law says what else there is
            setattr(self, name, value)
        return self

    def __dir__(self):
        return [*super().__dir__(), *self._own()]

    def __repr__(self):
        lines = [f"{name} = {value}" for name, value in self._all()]
        return f"<{self._path.rstrip('/') or 'scene'}: {'; '.join(lines) or 'all defaults'}>"

    def _all(self, path: str = "") -> Iterator:
        """(name, text) of all that is set here and below, in the order of the listing."""
        for name in self._listed.entries:
            if name in self._values:
                yield path + name, self._values[name]
        for name in [
            *self._listed.sections,
            *(name for name in self._sections if name not in self._listed.sections),
        ]:
            if name in self._sections:
                yield from self._sections[name]._all(f"{path}{name}/")

    def help(self, name: str = "") -> str:
        """What the parameters mean, or the one of this name, in lines."""
        if name and name not in self._own():
            raise self._missing(name)
        lines = []
        for own, listed in self._own().items():
            if listed in self._listed.entries and name in ("", own):
                entry = self._listed.entries[listed]
                lines.append(
                    f"{own} (default: {entry.default or 'empty'}; {entry.allowed})\n   "
                    f" {entry.meaning}"
                )
        return "\n".join(lines)


class Group(Section):
    """Materials, bodies, walls, obstacles or stages: each an attribute and an item by its name."""

    def _is_named(self, name: str) -> bool:
        return name in self._sections

    def _known(self) -> List[str]:
        return list(self._sections)

    def add(self, name: str, **values) -> Section:
        """A new one; values as those of a section."""
        if name in self._sections:
            raise InputError(f"'{self._path}{name}' is there already")
        self._sections[name] = Section(
            self._listed.named, f"{self._path}{name}/", self._scene, name
        )
        try:
            return self._sections[name](**values)
        except MissingName:
            del self._sections[name]
            raise

    def __call__(self, **values) -> "Group":
        """Adds or changes several, each by a dict of its values."""
        for name, own in values.items():
            self.add(name, **own) if name not in self else self[name](**own)
        return self

    def __getitem__(self, name: str) -> Section:
        if name not in self._sections:
            raise MissingName(
                f"'{self._path.rstrip('/')}' has no '{name}'; there are"
                f" {', '.join(self._sections) or 'none'}"
            )
        return self._sections[name]

    def __delitem__(self, name: str) -> None:
        del self._sections[self[name]._name]

    def __contains__(self, name) -> bool:
        return name in self._sections

    def __iter__(self) -> Iterator[str]:
        return iter(self._sections)

    def __len__(self) -> int:
        return len(self._sections)

    def _all(self, path: str = "") -> Iterator:
        if self._sections:
            yield path + NAMES, ", ".join(self._sections)
        yield from super()._all(path)


class Scene(Section):
    """
    A scene. Beside attributes it has the names of files: `scene["Contact/Friction"] = 0.3`.

    >>> scene = Scene()
    >>> gel = scene.materials.add("gel", youngs_modulus=1e6)
    >>> scene.stop.end_time = 1e-3
    >>> print(scene.text)
    subsection Materials
      set Names = gel
      subsection gel
        subsection Neo-Hookean
          set Young's modulus = 1e6
        end
      end
    end
    <BLANKLINE>
    subsection Stop
      set End time = 1e-3
    end
    <BLANKLINE>
    """

    def __init__(
        self, model: Optional[str] = None, program: Optional[str] = None, dimension: int = 2
    ):
        """dimension: 3 for a scene in space"""
        super().__init__(listing(model or "mpm", program, dimension), "", self)
        self.__dict__.update(_program=program, _grains=[], title="")
        if dimension != 2:
            self._values["Dimension"] = str(dimension)
        if model:
            self._values["Model"] = model

    def __setattr__(self, name: str, value) -> None:
        if name == "model" and value != self.model:
            raise InputError(
                f"the model of a scene decides what parameters it has: say Scene('{value}')"
            )
        if name == "dimension" and str(value) != self.dimension:
            raise InputError(
                "the dimension of a scene decides what parameters it has: say"
                f" Scene(dimension={value})"
            )
        if name == "title":
            self.__dict__[name] = value
        else:
            super().__setattr__(name, value)

    @classmethod
    def read(cls, path: str, program: Optional[str] = None) -> "Scene":
        """The scene of a parameter file, with what it includes."""
        entries = {
            name: moved(text, folder) if name in PATHS and folder else text
            for name, (text, folder) in entries_of(os.fspath(path)).items()
        }
        if UNREAD in entries:
            call([find_program(program), "check", os.fspath(path)])  # says what is wrong with it
        dimension = 3 if entries.pop("Dimension", "2").strip() == "3" else 2
        scene = cls(entries.pop("Model", None), program, dimension)
        for name in sorted(entries, key=lambda name: not name.endswith(f"/{NAMES}")):
            scene[name] = entries[name]
        return scene

    def copy(self) -> "Scene":
        """Another scene with the same in it."""
        return copy.deepcopy(self)

    # --- by the names of files ---

    def _at(self, path: str, make: bool = False):
        """(section, name) of a parameter by its name in files."""
        *sections, name = path.split("/")
        section: Section = self
        for one in sections:
            listed = section._listed
            if isinstance(section, Group):
                section = section.add(one) if make and one not in section else section[one]
            elif one in listed.sections or listed.named is not None:
                section = section._section(one)
            else:
                raise section._missing(one, section._listed.sections)
        if name not in section._listed.entries:
            raise section._missing(name, [*section._listed.entries, *section._listed.sections])
        return section, name

    def __setitem__(self, path: str, value) -> None:
        section, name = self._at(path, make=True)
        if name != NAMES:
            setattr(section, python_name(name), value)
            return
        for one in value.split(",") if isinstance(value, str) else value:
            if one.strip() not in section:
                section.add(one.strip())

    def __getitem__(self, path: str):
        section, name = self._at(path)
        return ", ".join(section) if name == NAMES else getattr(section, python_name(name))

    # --- grains ---

    def place(self, x, y, radius, material=None) -> None:
        """
        Disks at places of one's own [m]: numbers, or arrays of one length. @material: a name for
        each, or one for all. They are written to a table beside the file of the scene, which
        'Packing/File' names.
        """
        names = value_text(material, None) if isinstance(material, (str, Section)) else material
        try:
            columns = np.broadcast_arrays(
                *(np.atleast_1d(np.asarray(one, dtype=float)) for one in (x, y, radius)),
                np.atleast_1d(np.asarray(names if names is not None else "", dtype=str)),
            )
        except ValueError as error:
            raise InputError(
                "x, y, radius and material must be numbers and names, or arrays of one length:"
                f" {error}"
            ) from error
        self._grains.extend(zip(*(column.tolist() for column in columns)))

    @property
    def grains(self) -> list:
        """The disks that were placed: x, y, radius, name of the material, '' without one."""
        return list(self._grains)

    # --- what the program gets ---

    @property
    def text(self) -> str:
        """The scene as a parameter file, without what has its default."""
        return scene_text(dict(self._all()), self.title)

    def check(self) -> str:
        """
        Lets the program read the scene; returns what it says of the size of the job. What is wrong
        is an InputError with the program's own lines.
        """
        path = f".check-{os.getpid()}.prm"
        try:
            return self._put(path)
        finally:
            for one in (path, grains_path(path)):
                if os.path.exists(one):
                    os.remove(one)

    def write(self, path: str, check: bool = True) -> str:
        """
        Writes the scene as a parameter file, and its grains as a table beside it, once the program
        has read it and refuses nothing; @check=False leaves that to the run. Returns the path.
        """
        path = os.fspath(path)
        if not path.endswith(".prm"):
            raise InputError(f"the name of a parameter file ends with .prm, not {path}")
        os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
        if check:
            self.check()
        self._put(path, check=False)
        return path

    def _put(self, path: str, check: bool = True) -> str:
        scene = self
        if self._grains and self.packing.file:
            raise InputError(
                f"disks are placed, and 'Packing/File' = '{self.packing.file}' is another packing:"
                " leave one out"
            )
        if self._grains:
            table = grains_path(path)
            with open(table, "w", encoding="utf-8") as file:
                file.write(grains_text(self._grains))
            scene = self.copy()
            scene.packing.file = table
        # What counts from here counts from the folder of the file there.
        folder = os.path.relpath(".", os.path.dirname(path) or ".")
        entries = {
            name: moved(text, folder) if name in PATHS and folder != "." else text
            for name, text in scene._all()
        }
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene_text(entries, scene.title))
        if not check:
            return ""
        try:
            return call([find_program(self._program), "check", path])
        except InputError as error:
            raise InputError(re.sub(re.escape(path) + r":(\d+: )?", "", str(error))) from error

    def run(self, output: str, **options):
        """
        Writes the scene as @output with '.prm' at its end, runs it into this folder, and returns
        the finished run; @options are those of softgrain.run.
        """
        if not output:
            raise InputError("a Scene has no folder by itself: say output=")
        options["program"] = options.get("program") or self._program
        return run(self.write(f"{os.fspath(output)}.prm", check=False), output=output, **options)


def grains_path(path: str) -> str:
    """Where the table of the grains of a scene is."""
    return f"{os.path.splitext(path)[0]}_grains.csv"
