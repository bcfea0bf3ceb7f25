#!/usr/bin/env python3
"""How much of a C# feature goes over into C++ as it is.

    samples/porting/share.py [-v] [FILE.cs... FILE.h FILE.cpp...]...    all ports of this folder without files

C# files and the C++ behind them are one port; further C# begins the next. Whether the C++ is one
header or a header with sources makes no difference: a method counts where its class is, and of a method
that is declared and defined the definition. -v prints the lines that changed; one port alone does, too.

A line of C# counts where it holds code, more than a bracket, and no using directive, namespace or
region, and where Unity 2022.3 outside of the editor compiles it. It goes over as
it is if each of its statements is found in the C++, in their order, with the same names, numbers and
operators, after what is spelled otherwise in all C++: `.` (and `?.`) for `->` and `::`, `new T(` for
make_unique<T>( and make_shared<T>(, `T x = new(` for `T x(`, references and pointers (`ref`, `in`,
`out`; `&`, `*`), words that say who may see or change something, types of variables that are
`var` or `auto`, `null`, the f behind numbers, `()` behind a property, brackets around a body, and
`using (T x = f(out var y))`, which is `T x = f(y)` at the head of a block (`scope` where it has no name).
"""

import difflib
import pathlib
import re
import sys

WORDS_OF_A_DECLARATION = set(
    "public private protected internal static readonly const constexpr inline override virtual sealed "
    "final explicit class struct ref in out new std shared_ptr unique_ptr Shared".split())
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


def without_using(raw):
    """The tokens with `scope = T(a);` for `using (new T(a))`, `T x = a;` for `using (T x = a)`."""
    result = list(raw)
    for i in range(len(raw) - 1):
        if (raw[i][0], raw[i + 1][0]) != ("using", "("):
            continue
        depth = 0
        for end in range(i + 1, len(raw)):
            depth += (raw[end][0] == "(") - (raw[end][0] == ")")
            if depth == 0:
                break
        is_named = raw[i + 2][0] != "new"
        result[i] = ("" if is_named else "scope", raw[i][1])
        result[i + 1] = ("" if is_named else "=", raw[i + 1][1])
        result[end] = (";", raw[end][1])
    return [token for i, token in enumerate(result)
            if token[0] and not (token[0] == "var" and i > 0 and result[i - 1][0] == "out")]


def spelled_alike(raw):
    raw = without_using(raw)
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
        if token in ("shared_ptr", "unique_ptr", "Shared"):
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


CLASS = re.compile(r"\b(?:class|struct)\s+(\w+)[^;{}()]*\{")


NESTED = re.compile(r"\b(class|struct)\s+((?:\w+::)+)(\w+)([^;{}()]*)\{")


def closing(text, at):
    """Where the bracket closes that opens at `at`; strings and comments are gone or harmless here."""
    pairs = {"{": "}", "(": ")"}
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == text[at]) - (text[i] == pairs[text[at]])
        if depth == 0:
            return i
    return len(text)


def definitions(text):
    """Those of methods outside of their class: (first, last, class, method, what stands in its place)."""
    blocks = [(match.end(), closing(text, match.end() - 1)) for match in CLASS.finditer(text)]
    for match in re.finditer(r"(?:^|(?<=[;{}\n]))[ \t]*(?P<type>[\w:<>,&*\t ]*?)\b(?P<owner>(?:\w+::)*?\w+)::(?P<name>~?\w+)\s*\(", text):
        if any(first < match.start() < end for first, end in blocks):
            continue
        last = closing(text, match.end() - 1)
        body = re.compile(r"[^;{}]*?(\{|;|=\s*default\s*;)").match(text, last + 1)
        # `: a(1), b{2}` may stand before the body.
        if body is None or body.group(1) == ";":
            continue
        end = body.end()
        if body.group(1) == "{":
            end = closing(text, body.end() - 1) + 1
            while re.match(r"\s*[,{]", text[end:]):  # it was the brace of a member's value
                end = closing(text, text.index("{", end)) + 1
        owner = match.group("owner").split("::")[-1]
        shown = match.group("type") + match.group("name") + text[match.end() - 1:end]
        yield match.start(), end, owner, match.group("name"), shown


def classes_home(text):
    """The C++ with `class Outer::Inner {...};` where Outer says `class Inner;`."""
    while match := NESTED.search(text):
        end = closing(text, match.end() - 1)
        last = end + 1 + (text[end + 1:end + 2] == ";")
        shown = f"{match[1]} {match[3]}{match[4]}{text[match.end() - 1:last]}"
        text = text[:match.start()] + text[last:]
        outer = match[2].split("::")[-2]
        place = next((m for m in CLASS.finditer(text) if m.group(1) == outer), None)
        if place is None:
            text += "\n" + shown
            continue
        close = closing(text, place.end() - 1)
        declared = re.compile(r"\b(?:class|struct)\s+" + match[3] + r"\s*;").search(text, place.end(), close)
        begin, rest = (declared.start(), declared.end()) if declared else (close, close)
        text = text[:begin] + "\n" + shown + "\n" + text[rest:]
    return text


def csharp_text(path):
    """Line by line, without those that are no line of the feature."""
    lines = []
    taken = []  # by #if that is open: whether this branch is compiled, and whether one was before
    for line in path.read_text(encoding="utf-8-sig").split("\n"):
        word = line.strip()
        if word.startswith("#if"):
            is_taken = not re.search(r"(?<!!)(?:UNITY_EDITOR|UNITY_6000_\d+_OR_NEWER)", word)
            taken.append((is_taken, is_taken))
        elif word.startswith("#el") and taken:
            taken[-1] = (not taken[-1][1], True)
        elif word.startswith("#endif") and taken:
            taken.pop()
        is_out = word.startswith(("#", "namespace ")) or not all(branch for branch, _ in taken)
        lines.append("" if is_out else line.replace("?.", "."))
    return "\n".join(lines)


def brought_home(text):
    """The C++ with each method where its class declares it, as in one header: the order of the C#."""
    text = without_comments(text)
    text = re.sub(r"^[ \t]*#.*$", "", text, flags=re.M)
    text = classes_home(text)
    found = list(definitions(text))
    for first, last, owner, name, shown in reversed(found):
        text = text[:first] + "\n" + text[last:]
    for first, last, owner, name, shown in found:
        place = next((m for m in CLASS.finditer(text) if m.group(1) == owner), None)
        if place is None:
            text += "\n" + shown
            continue
        end = closing(text, place.end() - 1)
        arguments = parameters(shown)
        for declared in re.finditer(r"(?<![\w~.>])(?<!::)" + re.escape(name) + r"\s*\(", text[place.end():end]):
            begin = place.end() + declared.start()
            close = closing(text, place.end() + declared.end() - 1)
            rest = re.match(r"[^;{}]*;", text[close + 1:])
            if rest and parameters(text[begin:close + 1]) == arguments:
                start = max(text.rfind(c, 0, begin) for c in ";{}:\n") + 1
                # What is left out where it is called stands in the declaration alone.
                if "=" in text[begin:close]:
                    open_ = shown.index("(")
                    shown = shown[:open_] + text[text.index("(", begin):close + 1] + shown[closing(shown, open_) + 1:]
                text = text[:start] + " " + shown + text[close + 1 + rest.end():]
                break
        else:
            text = text[:end] + shown + "\n" + text[end:]
    return without_declarations(text)


def parameters(text):
    """How many a method has, by its text from the name on."""
    open_ = text.index("(")
    inner = text[open_ + 1:closing(text, open_)].strip()
    return 0 if not inner or inner == "void" else len(re.sub(r"<[^<>]*>|\([^()]*\)", "", inner).split(","))


def without_declarations(text):
    """Without `class X;` and using lines, which C# has none of."""
    return re.sub(r"^[ \t]*(?:class|struct|enum class)\s+\w+\s*;|^[ \t]*using\s[^;]*;", "", text, flags=re.M)


def counted_lines(text):
    lines = without_comments(text).split("\n")
    return {number for number, line in enumerate(lines, 1)
            if re.search(r"\w", line) and not line.strip().startswith("using Unity")
            and not line.strip().startswith("using System")}


def measure(csharp, cpp):
    text = "\n".join(csharp_text(path) for path in csharp)
    theirs = list(statements(text))
    ours = list(statements(brought_home("\n".join(path.read_text() for path in cpp))))
    matcher = difflib.SequenceMatcher(None, [s for s, _ in theirs], [s for s, _ in ours], autojunk=False)
    kept = {i for block in matcher.get_matching_blocks() for i in range(block.a, block.a + block.size)}
    counted = counted_lines(text)
    changed = set()
    for i, (_, lines) in enumerate(theirs):
        if i not in kept:
            changed |= lines
    return counted, counted & changed


def ports(arguments):
    """The C# and the C++ of each, in their order."""
    found = []
    for path in map(pathlib.Path, arguments):
        if path.suffix == ".cs" and (not found or found[-1][1]):
            found.append(([], []))
        if not found:
            sys.exit(f"{path}: the C# is expected before its C++: share.py FEATURE.cs FEATURE.h FEATURE.cpp")
        found[-1][path.suffix != ".cs"].append(path)
    for csharp, cpp in found:
        if not cpp:
            sys.exit(f"{csharp[-1]}: its C++ is expected behind it")
    return found


def main():
    here = pathlib.Path(__file__).parent
    arguments = [argument for argument in sys.argv[1:] if argument != "-v"]
    pairs = ports(arguments) or [([path], [path.with_suffix(".h")]) for path in sorted(here.glob("*/*.cs"))]
    total = total_changed = 0
    for csharp, cpp in pairs:
        counted, changed = measure(csharp, cpp)
        total += len(counted)
        total_changed += len(changed)
        print(f"{csharp[0].stem:28} {len(counted):4} lines, {100 * (1 - len(changed) / len(counted)):5.1f} % as they are")
        if "-v" in sys.argv or len(pairs) == 1:
            lines = "\n".join(csharp_text(path) for path in csharp).split("\n")
            for number in sorted(changed):
                print(f"    {number:4}: {lines[number - 1].strip()}")
    print(f"{'all':28} {total:4} lines, {100 * (1 - total_changed / total):5.1f} % as they are")


if __name__ == "__main__":
    main()
