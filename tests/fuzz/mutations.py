"""Changes of bytes and of text, chosen by a random number generator."""

import re
import struct
import zlib

NUMBERS = ["0", "-1", "1", "-0", "nan", "inf", "-inf", "1e39", "-1e38", "1e-46", "2147483648", "-2147483649",
           "4294967295", "4294967296", "9223372036854775808", "18446744073709551616", "99999999999999999999999",
           "0.1e400", "0x7fffffff", "1.#INF", "65536", "3.5", "1e", "--1"]
TEXTS = ["", "~", "null", "[]", "{}", "''", '"', "'", "\\", "%s%n", "../../x", "/dev/null", ".", "{", "}", "[", "]",
         "(", ")", ":", ",", "#", "&a", "*a", "!!binary", "|", ">", "--- ", "...", "\t", "\n", "\r\n", "\0", "\ufeff",
         "\u2028", "\u00e9", "\x1b[31m", "A" * 3000, "//", "/*", "*/", "#include \"Tint.hlsl\"", "#if", "#endif",
         "#define A A", "#error x", "ENDHLSL", "CGPROGRAM", "Shader", "Pass {", "%YAML 1.1", "--- !u!114 &1"]
NESTS = [("[", "]"), ("{", "}"), ("(", ")"), ("[{a: ", "}]"), ('{"a": ', "}"), ("- ", ""), ("/*", "*/"),
         ("-", ""), ("#if 1\n", "#endif\n"), ("SubShader {", "}"), ("Category {", "}")]


def span(data, rng, longest=64):
    begin = rng.randrange(len(data) + 1)
    return begin, min(len(data), begin + rng.randrange(1, longest))


def mutate_bytes(data, rng, other):
    begin, end = span(data, rng)
    choice = rng.randrange(8)
    if choice == 0:  # bits
        flipped = bytearray(data)
        for _ in range(rng.randrange(1, 8)):
            if flipped:
                flipped[rng.randrange(len(flipped))] ^= 1 << rng.randrange(8)
        return bytes(flipped)
    if choice == 1:
        return data[:begin]
    if choice == 2:
        return data[:begin] + data[end:]
    if choice == 3:
        return data[:end] + data[begin:end] * rng.randrange(1, 5) + data[end:]
    if choice == 4:
        return data[:begin] + rng.randbytes(end - begin) + data[end:]
    if choice == 5:  # an integer
        value = rng.choice([0, 1, 0x7F, 0xFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0xFFFFFFFC, 65536])
        return data[:begin] + struct.pack(rng.choice(["<I", ">I"]), value) + data[begin + 4:]
    if choice == 6:
        first, last = span(other, rng, 400)
        return data[:begin] + other[first:last] + data[begin:]
    return data + data[begin:end]


def mutate_text(data, rng, other):
    text = data.decode("utf-8", "surrogateescape")
    choice = rng.randrange(-5, 12)
    if choice in (0, 1):
        return mutate_bytes(data, rng, other)
    if choice < 5:  # a number or a word becomes another
        words = list(re.finditer(r"-?\d[\d.eE+-]*" if choice < 0 else r"[A-Za-z_][\w/]*", text))
        word = rng.choice(words) if words else None
        by = rng.choice(NUMBERS if choice < 3 else TEXTS + [w[0] for w in words])
        return (text[:word.start()] + by + text[word.end():]).encode("utf-8", "surrogateescape") if word else data
    lines = text.splitlines(keepends=True) or [""]
    at = rng.randrange(len(lines))
    if choice == 5:
        del lines[at]
    elif choice == 6:
        lines.insert(rng.randrange(len(lines) + 1), lines[at])
    elif choice == 7:
        to = rng.randrange(len(lines))
        lines[at], lines[to] = lines[to], lines[at]
    elif choice == 8:
        lines[at] = " " * rng.randrange(1, 5) + lines[at] if rng.random() < 0.5 else lines[at].lstrip()
    elif choice == 9:
        column = rng.randrange(len(lines[at]) + 1)
        lines[at] = lines[at][:column] + rng.choice(TEXTS + NUMBERS) + lines[at][column:]
    elif choice == 10:
        begin, end = span(other, rng, 400)
        lines.insert(at, other[begin:end].decode("utf-8", "surrogateescape"))
    else:
        opening, closing = rng.choice(NESTS)
        depth = rng.choice([3, 70, 300, 2000])
        inside = lines[at] if rng.random() < 0.5 else "1"
        lines[at] = opening * depth + inside + (closing * depth if rng.random() < 0.7 else "")
    return "".join(lines).encode("utf-8", "surrogateescape")


def with_checksums(data):
    """A PNG whose chunks' checksums are right again, so that what is in them is looked at."""
    result, at = data[:8], 8
    while at + 12 <= len(data):
        length = struct.unpack(">I", data[at:at + 4])[0]
        body = data[at + 4:at + 8 + length]
        result += data[at:at + 4] + body + struct.pack(">I", zlib.crc32(body))
        at += 12 + length
    return result
