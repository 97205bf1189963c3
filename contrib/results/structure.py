#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Counts of doc/results/structure.md: long functions, classes with many public members, files that know of ranks, readers of time
schemes and of what a rigid partner of bodies is. Files are laid out by clang-format, so that a brace on a line of its own opens what ends with the brace below it.

    contrib/results/structure.py [--root FOLDER] [--list]
"""
import argparse
import pathlib
import re

LONGEST, MOST = 60, 15
FOLDERS = "source", "include", "bpm"
NO_FUNCTION = re.compile(r"(?:\[\[.*?\]\]\s*)?(?:template\s*<[^{]*>\s*)?(?:inline\s+|static\s+|extern\s+)*"
                         r"(?:namespace|class|struct|enum|union|if|else|for|while|do|switch|try|catch|case|default)\b|.*[=,(]\s*$")
TYPE = re.compile(r"(?:template\s*<[^{;]*>\s*)?(?:class|struct)\s+(\w+)(?:<[^{]*>)?(?:\s+final)?(?:\s*:[^{]*)?\s*$")
PARAMETERS = re.compile(r"Settings$|Parameters$")
MODELS = re.compile(r"^bpm/|/(?:mpm|contact)/")
RANKS = re.compile(r"\b(?:[Rr]anks?|MPI_\w+|MPISession)\b|\b(?:n_)?ranks\w*\b")
SCHEME = re.compile(r"scheme\.(?:inertia|implicit|theta|name)\b")
ASKED = re.compile(r"\b(?:ends_in_balance|solves_equations)\(\)")

# Whether a partner is a plane, a slab, a side of a cell, a wall that is free or an obstacle. "Rooms" are files that may know.
KINDS = re.compile(r"\b(?:slides_freely|is_side_of_cell|prescribed)\(|\bwall\w*(?:\[\w+\])?(?:\.|->)repeats\(\)|\bno_body\b|"
                   r"\b(?:\w*row|rows\[\w+\])\.obstacle\b|\bwall (?:-|>=|<) (?:\w+\.)?(?:n_)?walls\b")
ROOMS = re.compile(r"(?:source|include/softgrain)/(?:driving|scene)/|/plane_partners\.|/row_velocity\.cc|/(?:wall|obstacle)_rows\.cc")
OF_PARTNERS = re.compile(r"\bis_free\((?:\w+\.)*(?:wall|side)|\b(?:freedoms_of|is_plane|is_met|any_sides|for_sides|for_met|for_slabs|length_across|ahead_of|told_rates|expected_rates)\(|\bPartnerNumbers\(")


def code(text):
    """@text without comments and strings; the lines stay."""
    keep = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
    return keep.sub(lambda found: re.sub(r"[^\n]", " ", found[0]) if found[0][0] == "/" else '""', text)


def blocks(lines):
    """(head, first line, last line) of all that stands between braces on lines of their own, outermost first."""
    for number, line in enumerate(lines):
        if line.strip() != "{":
            continue
        indent = line[:line.index("{")]
        first = number
        while first > 0 and (before := lines[first - 1].strip()) and not before.endswith((";", "{", "}")) and not re.fullmatch(
                r"(?:public|private|protected):|#.*", before):
            first -= 1
        last = next((n for n in range(number + 1, len(lines)) if re.match(indent + r"\}", lines[n])), len(lines) - 1)
        yield " ".join(part.strip() for part in lines[first:number]), first, last


def long_functions(lines):
    end = -1
    for head, first, last in blocks(lines):
        if first <= end or NO_FUNCTION.match(head) or "(" not in head:
            continue
        end = last
        if last - first + 1 > LONGEST:
            yield re.sub(r"\s*\(.*", "", head).split()[-1], last - first + 1


def public_members(lines, first, last, is_class):
    """Names of members that a user of a type sees: no types, constructors, operators, friends, and nothing that its base has."""
    name = TYPE.match(" ".join(line.strip() for line in lines[first:last]).split("{")[0].strip())[1]
    public, depth, statement, names = not is_class, 0, "", []
    body = next(n for n in range(first, last) if lines[n].strip() == "{")
    for line in lines[body + 1:last]:
        text = line.strip()
        if depth == 0 and re.fullmatch(r"(?:public|private|protected):", text):
            public, statement = text == "public:", ""
            continue
        before = depth
        depth += text.count("{") - text.count("}")
        if before == 0:
            statement += " " + text
        if depth > 0 or not (text.endswith((";", "}")) or before > 0):
            continue
        words, statement = statement.strip(), ""
        if not public or not words or re.match(r"(?:template\s*<[^>]*>\s*)?(?:using|typedef|friend|class|struct|enum|static_assert)\b", words):
            continue
        if re.search(rf"\boperator\b|\boverride\b|~|^(?:explicit |constexpr )*{name}\s*\(", words):
            continue
        if function := re.search(r"(\w+)\s*\(", words):
            names.append(function[1])
        else:
            names += re.findall(r"(\w+)\s*(?:\{[^}]*\}|\[[^\]]*\])?\s*(?:=[^,;]*)?(?=[,;])", re.sub(r"<[^;]*>|\{[^}]*\}", "", words))
    return name, names


def crowded_types(lines):
    for head, first, last in blocks(lines):
        if TYPE.match(head) and not PARAMETERS.search(TYPE.match(head)[1]):
            name, names = public_members(lines, first, last, bool(re.search(r"\bclass\b", head)))
            if len(names) > MOST:
                yield name, len(names)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--list", action="store_true", help="name what is counted")
    arguments = parser.parse_args()
    functions, types, words, knowing, flags, asking, kinds, partners = [], [], [], [], {}, {}, {}, {}
    for file in sorted(file for folder in FOLDERS for end in ("h", "cc") for file in (arguments.root / folder).rglob("*." + end)):
        text, name = file.read_text(), str(file.relative_to(arguments.root))
        bare = code(text)
        lines = bare.split("\n")
        functions += [(length, name, function) for function, length in long_functions(lines)]
        types += [(n, name, kind) for kind, n in crowded_types(lines)]
        if re.search(r"\branks?\b|Ranks|MPI_", text):
            words.append(name)
        if RANKS.search(bare):
            knowing.append(name)
        for pattern, found in ((SCHEME, flags), (ASKED, asking)):
            if n := len(pattern.findall(bare)):
                found[name] = n
        for pattern, found in ((KINDS, kinds), (OF_PARTNERS, partners)):
            if n := 0 if ROOMS.search(name) else len(pattern.findall(bare)):
                found[name] = n
    rows = ((f"functions of more than {LONGEST} lines", len(functions)),
            (f"classes with more than {MOST} public members that are no parameters", len(types)),
            ("files that mention ranks, in comments too", len(words)),
            ("files whose code names ranks, of the models and their contact", f"{len(knowing)}, {sum(map(bool, map(MODELS.search, knowing)))}"),
            ("reads of the flags and numbers of a time scheme, files", f"{sum(flags.values())}, {len(flags)}"),
            ("questions to a time scheme, files", f"{sum(asking.values())}, {len(asking)}"),
            ("reads of the kind of a rigid partner outside of its rooms, files", f"{sum(kinds.values())}, {len(kinds)}"),
            ("questions to partners in place of kinds, files", f"{sum(partners.values())}, {len(partners)}"))
    for what, value in rows:
        print(f"| {what} | {value} |")
    if arguments.list:
        for n, file, name in sorted(functions + types, reverse=True):
            print(f"{n:4} {file}: {name}")
        print(*knowing, sep="\n")
        print(*(f"{n:3} {file}" for found in (flags, asking, kinds, partners) for file, n in found.items()), sep="\n")


if __name__ == "__main__":
    main()
