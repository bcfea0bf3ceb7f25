#!/usr/bin/env python3
"""Says whether the picture of a new feature's scene is what geometry says: a green ball and a gray
one of half a metre, a metre left and right of the middle, 16 pixels a metre.

usage: check_picture.py PNG
       check_picture.py PNG EXPECTED   whether the two are the same but for how devices round
"""
import math
import struct
import sys
import zlib


def read_png(path):
    """Rows of RGBA bytes."""
    data = open(path, "rb").read()
    at, header, packed = 8, None, b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        header = struct.unpack(">IIBBBBB", body) if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
        at += size + 12
    width, height, depth, color = header[:4]
    assert (depth, color, header[6]) == (8, 6, 0), header
    raw, rows, above = zlib.decompress(packed), [], bytes(width * 4)
    for y in range(height):
        start = y * (width * 4 + 1)
        kind, row = raw[start], bytearray(raw[start + 1 : start + 1 + width * 4])
        for i in range(len(row)):
            a, b, c = (row[i - 4], above[i], above[i - 4]) if i >= 4 else (0, above[i], 0)
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255
        rows.append(row)
        above = row
    return rows


def compare(rows, expected):
    assert [len(row) for row in rows] == [len(row) for row in expected], "sizes differ"
    differing = sum(
        max(abs(a - b) for a, b in zip(row[x : x + 4], other[x : x + 4])) > 2
        for row, other in zip(rows, expected)
        for x in range(0, len(row), 4)
    )
    assert differing <= len(rows), f"{differing} pixels differ"


def main():
    if len(sys.argv) == 3:
        compare(read_png(sys.argv[1]), read_png(sys.argv[2]))
        return
    rows = read_png(sys.argv[1])
    assert (len(rows), len(rows[0])) == (32, 64 * 4), "the picture is not 64x32"
    checked = {}
    for y, row in enumerate(rows):
        for x in range(64):
            left, right = (math.hypot(x + 0.5 - c, y + 0.5 - 16) for c in (16, 48))
            if min(abs(left - 8), abs(right - 8)) < 1:
                continue  # the edge of a ball, which is made of triangles
            want = (0, 255, 0) if left < 8 else (128, 128, 128) if right < 8 else (32, 48, 64)
            got = tuple(row[x * 4 : x * 4 + 3])
            assert max(abs(g - w) for g, w in zip(got, want)) <= 1, (x, y, got, want)
            checked[want] = checked.get(want, 0) + 1
    assert len(checked) == 3 and min(checked.values()) > 100, checked


main()
