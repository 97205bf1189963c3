#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pages and comments can be read at once: no sentence of a page has more than forty words, and every Doxygen comment in a header
names its thing before it says more.
"""
import re

import common

LONGEST = 40
# Comments that lean on a declaration elsewhere, or begin in the middle of a sentence: the reader has to guess what they are about.
# "The same polygon with ..." has its noun, "The same with ..." has none.
NO_SUBJECT = re.compile(
    r"(?:Of|As|By|From|With|Without|Per|For|At|On|In|To|Over|Along|Between|After|Before|While|If|Also|Likewise|Its|Their|And|Or|But|So"
    r"|Then|Nothing)\b"
    r"|The same(?:[.,;:]|$| (?:a|after|along|and|as|at|before|but|by|for|from|if|in|of|on|over|that|the|there|to|when|where|which|with|without)\b)")
LIST_ITEM = re.compile(r"(?:[-*+]|\d+[.)])\s+")
END = re.compile(r"(?<=[.!?])[\"”')*\]]*\s+")
ABBREVIATION = re.compile(r"\b(eq|eqs|fig|figs|sec|no|e\.g|i\.e|r\.m\.s|cf|vs|et al)\.")


def paragraphs(lines):
    """First line number and text of every paragraph and list item of a page, without code, tables and headings."""
    fenced, start, words = False, 0, []
    for number, line in enumerate([*lines, ""], 1):
        text = line.strip()
        fence = text.startswith(("```", "~~~"))
        fenced ^= fence
        item = LIST_ITEM.match(text)
        plain = not (fence or fenced or not text or text.startswith(("#", "|", "<", "![")) or (line.startswith("    ") and not words))
        if (not plain or item) and words:
            yield start, " ".join(words)
            words = []
        if plain:
            start = start if words else number
            words.append(text[item.end():] if item else text)


def sentences(text):
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`]*`|\$[^$]*\$|https?:\S+", "Code", text)
    text = re.sub(r"Code(?:,? (?:and |or )?Code)+", "Code", text)  # a list of names is read as one
    text = ABBREVIATION.sub(r"\1", text)
    return END.split(text)


def long_sentences(path, lines):
    for number, text in paragraphs(lines):
        for sentence in sentences(text):
            words = [word for word in sentence.split() if re.search(r"\w", word)]
            if len(words) > LONGEST:
                yield f"{path}:{number}: {len(words)} words in a sentence, at most {LONGEST}: {' '.join(words[:6])} ..."


def comments(lines):
    """Line number and text of every Doxygen comment of a header. One behind its member continues the name of that member."""
    block = None
    for number, line in enumerate([*lines, ""], 1):
        text = line.strip()
        own = re.match(r"///(?!<)\s*(.*)", text)
        behind = re.search(r"///<\s*(.*)", line)
        if block is not None and (text.startswith("///<") or not own) and not block[2]:
            yield block[0], " ".join(block[1])
            block = None
        if block is not None and block[2]:
            block[1].append(text.removesuffix("*/").strip("* "))
            if text.endswith("*/"):
                yield block[0], " ".join(word for word in block[1] if word)
                block = None
        elif own:
            block = block or (number, [], False)
            block[1].append(own[1])
        elif text.startswith("/**"):
            block = (number, [text[3:].removesuffix("*/").strip("* ")], True)
            if text.endswith("*/"):
                yield number, block[1][0]
                block = None
        if behind:
            yield number, behind[1]


def without_subject(path, lines):
    for number, text in comments(lines):
        text = re.sub(r"^(?:[@\\](?:brief|name|file)\b.*?\s)?\s*", "", text)
        if found := NO_SUBJECT.match(text):
            yield f"{path}:{number}: a comment that begins with '{found[0]}' has no subject: name the thing first"


def check(root):
    for path in common.files(root, ".md", ".h"):
        lines = common.lines(root, path)
        if path.suffix == ".md" and path.name != "CHANGELOG.md":
            yield from long_sentences(path, lines)
        elif path.suffix == ".h" and "softgrain" in path.parts[:-1]:
            yield from without_subject(path, lines)


common.main(check, __doc__)
