# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A scene of the storm: the values of a parameter file by their path, and the tables that it reads.

A value is kept as the text that stands in the file, so that a scene read from a file is the scene that was written.
Numbers are written with all their digits: what is read again has the same bits.
"""
import re


def number(value):
    """The shortest text from which the same double is read again."""
    return repr(float(value))


def numbers(values):
    return ", ".join(number(value) for value in values)


def points(values):
    return "; ".join(numbers(value) for value in values)


class Scene:
    """Values by path, as "Bodies/a/Radius", in the order in which they were set, and files by name."""

    def __init__(self, values=(), files=(), notes=()):
        self.values = dict(values)
        self.files = dict(files)
        self.notes = list(notes)  # lines at the head of the file, as "relation: mirror"

    def copy(self):
        return Scene(self.values, self.files, self.notes)

    def __eq__(self, other):
        return self.values == other.values and self.files == other.files

    def set(self, path, value):
        """Sets a value: text as it is, numbers and lists of them with all their digits."""
        if isinstance(value, bool):
            value = "true" if value else "false"
        elif isinstance(value, int):
            value = str(value)
        elif isinstance(value, float):
            value = number(value)
        elif not isinstance(value, str):
            value = points(value) if isinstance(value[0], (tuple, list)) else numbers(value)
        self.values[path] = value

    def get(self, path, default=None):
        return self.values.get(path, default)

    def number(self, path, default=0.0):
        return float(self.values[path]) if path in self.values else default

    def point(self, path, default=(0.0, 0.0)):
        return tuple(float(word) for word in self.values[path].split(",")) if path in self.values else default

    def names(self, section):
        return [name.strip() for name in self.get(f"{section}/Names", "").split(",") if name.strip()]

    def note(self, key):
        """The text behind "key: " at the head of the file, or nothing."""
        return next((line[len(key) + 2:] for line in self.notes if line.startswith(key + ": ")), "")

    def remove_section(self, prefix):
        for path in [path for path in self.values if path.startswith(prefix + "/")]:
            del self.values[path]

    def remove_name(self, section, name):
        """Takes a body, a wall, an obstacle or a stage out of the scene, with all that is said of it."""
        left = [other for other in self.names(section) if other != name]
        self.remove_section(f"{section}/{name}")
        if section == "Walls":
            for stage in self.names("Stages"):
                self.remove_section(f"Stages/{stage}/{name}")
        if left:
            self.values[f"{section}/Names"] = ", ".join(left)
        else:
            self.values.pop(f"{section}/Names", None)
        for key in ("Contact/Friction of pairs", "Contact/Adhesion of pairs"):
            entries = [entry for entry in self.get(key, "").split(";")
                       if entry.strip() and name not in re.split(r"\s*[/:]\s*", entry.strip())]
            if key in self.values:
                self.values[key] = "; ".join(entry.strip() for entry in entries)
                if not entries:
                    del self.values[key]

    def write(self):
        """The parameter file."""
        lines = [f"# {note}" for note in self.notes]
        tree = {}
        for path, value in self.values.items():
            *sections, name = path.split("/")
            branch = tree
            for section in sections:
                branch = branch.setdefault(section, {})
                if not isinstance(branch, dict):
                    raise ValueError(f"{path}: a section has the name of a parameter")
            branch[name] = value
        write_section(tree, lines, "")
        return "\n".join(lines) + "\n"

    def save(self, folder, name="scene.prm"):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(self.write())
        for file, text in self.files.items():
            (folder / file).write_text(text)
        return folder / name


def write_section(tree, lines, indent):
    for name, value in tree.items():
        if not isinstance(value, dict):
            lines.append(f"{indent}set {name} = {value}")
    for name, value in tree.items():
        if isinstance(value, dict):
            lines.append(f"{indent}subsection {name}")
            write_section(value, lines, indent + "  ")
            lines.append(f"{indent}end")


def read(path):
    """The scene of a file that write() has written."""
    scene = Scene()
    sections = []
    for line in path.read_text().splitlines():
        line = line.strip()
        if line.startswith("# "):
            scene.notes.append(line[2:])
        elif line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, value = line[len("set "):].split("=", 1)
            scene.values["/".join([*sections, name.strip()])] = value.strip()
    for key in ("Packing/File", "Primaries/Library"):
        name = scene.get(key)
        if name and (path.parent / name).exists():
            scene.files[name] = (path.parent / name).read_text()
    return scene
