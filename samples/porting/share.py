#!/usr/bin/env python3
"""How much of a C# feature goes over into C++ as it is.

    samples/porting/share.py [FEATURE.cs FEATURE.h]...     all pairs of this folder without arguments

A line of C# counts where it holds code, more than a bracket, and no using directive. It goes over as
it is if each of its statements is found in the C++, in their order, with the same names, numbers and
operators, after what is spelled otherwise in all C++: `.` for `->` and `::`, `new T(` for
make_unique<T>( and make_shared<T>(, `T x = new(` for `T x(`, references and pointers (`ref`, `in`,
`out`; `&`, `*`), words that say who may see or change something, types of variables that are
`var` or `auto`, `null`, the f behind numbers, `()` behind a property, and brackets around a body.
"""

import difflib
import pathlib
import re
import sys

WORDS_OF_A_DECLARATION = set(
    "public private protected internal static readonly const constexpr inline override virtual sealed "
    "final explicit class struct ref in out new std shared_ptr unique_ptr".split())
CONDITIONS = ("if", "for", "foreach", "while")
TOKEN = re.compile(r"""\s+|"(?:\\.|[^"\\])*"|\d+(?:\.\d*)?[fF]?|\w+|->|::|=>|==|!=|<=|>=|&&|\|\||\+\+|.""")


def without_comments(text):
    text = text.replace("[[maybe_unused]]", "")
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def tokens(text):
    """Each with the number of the line that it is on, as both languages would spell it."""
    result = []
    line = 1
    for match in TOKEN.finditer(text):
        token = match.group()
        if not token.isspace():
            result.append((token, line))
        line += token.count("\n")
    return result


def opens_a_body(raw, i):
    while i < len(raw) and raw[i][0] in WORDS_OF_A_DECLARATION:
        i += 1
    return i < len(raw) and raw[i][0] in ("{", ":", "=>")


def spelled_alike(raw):
    out = []
    i = 0
    while i < len(raw):
        token, line = raw[i]
        word = token
        if token in ("->", "::"):
            word = "."
        elif token in ("null", "nullptr"):
            word = "null"
        elif re.fullmatch(r"\d.*", token):
            word = repr(float(token.rstrip("fF")))
        if token in ("make_unique", "make_shared"):
            # make_unique<T>( is new T(
            end = next(j for j in range(i, len(raw)) if raw[j][0] == ">")
            out.extend(raw[i + 2:end])
            i = end + 1
            continue
        if token in ("shared_ptr", "unique_ptr"):
            end = next(j for j in range(i, len(raw)) if raw[j][0] == ">")
            out.extend((t, n) for t, n in raw[i + 2:end] if t not in WORDS_OF_A_DECLARATION)
            i = end + 1
            continue
        if token in WORDS_OF_A_DECLARATION or token in ("&", "*"):
            i += 1
            if raw[i:] and token in ("public", "private", "protected") and raw[i][0] == ":":
                i += 1
            if i < len(raw) and token == "std" and raw[i][0] == "::":
                i += 1
            continue
        if token == "(" and raw[i + 1:i + 2] and raw[i + 1][0] == ")" and not opens_a_body(raw, i + 2):
            i += 2  # a property
            continue
        out.append((word, line))
        i += 1
    return out


def statements(text):
    """Each as (words, lines)."""
    current = []
    depth = 0
    outer = []  # depths around the braces that are open
    attribute = 0
    for token, line in spelled_alike(tokens(without_comments(text))):
        depth += (token == "(") - (token == ")")
        attribute += (token == "[") - (token == "]") if attribute or not current else 0
        ends = token in "{}" or (token == ";" and depth == 0) or (token == "]" and not attribute and current[0][0] == "[")
        if not ends or token == "]":
            current.append((token, line))
        # A condition ends with its bracket, whether or not there are braces behind it.
        ends = ends or (token == ")" and depth == 0 and current[0][0] in CONDITIONS) or token == "else"
        if ends and current:
            yield statement(current)
            current = []
            attribute = 0
        if token == "{":
            outer.append(depth)
            depth = 0
        elif token == "}":
            depth = outer.pop() if outer else 0


def statement(words):
    names = [word for word, _ in words]
    # The type of a variable may be var or auto: T x = ... is x = ...; T x(...) is x = T(...).
    match = re.match(r"^(\w+(?: \. \w+)*(?: < .+? >)?) (\w+) = (.*)$", " ".join(names))
    if match and match.group(1) not in ("return", "else"):
        value = match.group(3)
        value = re.sub(r"^\( ", match.group(1) + " ( ", value)
        names = [match.group(2), "="] + value.split(" ")
    else:
        match = re.match(r"^(\w+(?: \. \w+)*) (\w+) (\( .+)$", " ".join(names))
        if match and match.group(1) not in ("return", "else", "if", "for", "while", "using", "void"):
            names = [match.group(2), "=", match.group(1)] + match.group(3).split(" ")
    return " ".join(names), {line for _, line in words}


def counted_lines(text):
    lines = without_comments(text).split("\n")
    return {number for number, line in enumerate(lines, 1)
            if re.search(r"\w", line) and not line.strip().startswith("using Unity")
            and not line.strip().startswith("using System")}


def measure(csharp, cpp):
    text = csharp.read_text()
    theirs = list(statements(text))
    ours = list(statements(cpp.read_text()))
    matcher = difflib.SequenceMatcher(None, [s for s, _ in theirs], [s for s, _ in ours], autojunk=False)
    kept = {i for block in matcher.get_matching_blocks() for i in range(block.a, block.a + block.size)}
    counted = counted_lines(text)
    changed = set()
    for i, (_, lines) in enumerate(theirs):
        if i not in kept:
            changed |= lines
    return counted, counted & changed


def main():
    here = pathlib.Path(__file__).parent
    arguments = [pathlib.Path(a) for a in sys.argv[1:]]
    pairs = list(zip(arguments[::2], arguments[1::2])) or \
        [(path, path.with_suffix(".h")) for path in sorted(here.glob("*/*.cs"))]
    total = total_changed = 0
    for csharp, cpp in pairs:
        counted, changed = measure(csharp, cpp)
        total += len(counted)
        total_changed += len(changed)
        print(f"{csharp.stem:28} {len(counted):4} lines, {100 * (1 - len(changed) / len(counted)):5.1f} % as they are")
        if "-v" in sys.argv or len(pairs) == 1:
            lines = csharp.read_text().split("\n")
            for number in sorted(changed):
                print(f"    {number:4}: {lines[number - 1].strip()}")
    print(f"{'all':28} {total:4} lines, {100 * (1 - total_changed / total):5.1f} % as they are")


if __name__ == "__main__":
    main()
