#!/usr/bin/env python3
"""Says whether the picture of a new feature's scene is what geometry says: a green ball and a gray
one of half a metre, a metre left and right of the middle, 16 pixels a metre.

usage: check_picture.py PNG
       check_picture.py PNG EXPECTED   whether the two are the same but for how devices round
"""
import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "readme"))
from png import read_png


def rows_of(path):
    """Rows of RGBA bytes."""
    rows, channels = read_png(path)
    assert channels == 4, f"{path} has {channels} channels"
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
        compare(rows_of(sys.argv[1]), rows_of(sys.argv[2]))
        return
    rows = rows_of(sys.argv[1])
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
