#!/usr/bin/env python3
"""Splits a feature that is one header into a header and a source, as most C++ is written.

    split.py FEATURE.h FOLDER     writes FOLDER/FEATURE.h and FOLDER/FEATURE.cpp

Bodies of methods move behind the classes, the last one first, under their qualified names and without
the words that only a declaration has. Comments are lost.
"""

import pathlib
import re
import sys

HEAD = re.compile(r"\s*(?:(?:class|struct)\s+(?P<name>\w+)[^;{}()]*\{|(?P<label>(?:public|private|protected)\s*:)|(?P<other>[^;{}]*))")


def matching(text, at):
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in "{(") - (text[i] in "})")
        if depth == 0:
            return i
    raise SystemExit("a bracket is never closed")


def definition(head, body, owner):
    head = re.sub(r"\b(?:static|virtual|explicit|override|inline)\b\s*|\[\[maybe_unused\]\]\s*", "", head.strip())
    head = re.sub(r"\s*=\s*[^,()]+(?=[,)])", "", head)  # default arguments
    name = re.search(r"~?\w+\s*\(", head)
    return head[:name.start()] + "::".join(owner) + "::" + head[name.start():].rstrip() + "\n" + body + "\n"


def split(text, owner):
    """What stays in a class, and the definitions of what goes."""
    stays, goes, at = "", [], 0
    while at < len(text):
        head = HEAD.match(text, at)
        if head.group("name"):
            end = matching(text, head.end() - 1)
            inner, moved = split(text[head.end():end], owner + [head.group("name")])
            stays += head.group() + inner + "}"
            goes += moved
            at = end + 1
        elif head.group("label"):
            stays += head.group()
            at = head.end()
        elif head.end() < len(text) and text[head.end()] == "{":
            end = matching(text, head.end()) + 1
            member = head.group("other")
            isMethod = owner and re.search(r"\)\s*(?:const|override|\s)*(?::[^:].*)?$", member, re.S) and "=" not in member.split("(")[0]
            if isMethod:
                declaration = re.sub(r"\)\s*:[^:].*$", ")", member, flags=re.S)  # without what it begins with
                stays += declaration.rstrip() + ";"
                goes.append(definition(member, text[head.end():end], owner))
            else:
                stays += member + text[head.end():end]
            at = end
        else:
            stays += text[at:head.end() + 1]
            at = head.end() + 1
    return stays, goes


def main():
    source, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    text = re.sub(r"/\*.*?\*/|//[^\n]*|^[ \t]*#[^\n]*$", "", source.read_text(), flags=re.S | re.M)
    space = list(re.finditer(r"namespace\s+\w+\s*\{", text))[-1]
    stays, goes = split(text[space.end():matching(text, space.end() - 1)], [])
    if len(goes) < 3:
        raise SystemExit(f"{source}: only {len(goes)} methods were found")
    opening = space.group()
    (folder / source.name).write_text(f"#pragma once\n{text[:space.start()]}{opening}\n{stays}\n}}\n")
    (folder / (source.stem + ".cpp")).write_text(f'#include "{source.name}"\n{opening}\n' + "\n".join(reversed(goes)) + "\n}\n")


if __name__ == "__main__":
    main()
