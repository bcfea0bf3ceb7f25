#!/usr/bin/env python3
"""Draws the pictures of samples/ anew and compares them with those that are checked in.

usage: pictures.py REPOSITORY LIMN [FOLDER]     (FOLDER: where they are drawn; left out, they are not kept)

LIMN_UPDATE_GOLDEN=1 writes what was drawn over what is checked in: look at it.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from png import difference

# Each picture, the command that draws it to OUT, and how far the software drivers lavapipe and
# SwiftShader are apart in it: the mean difference of a channel, of 255, measured on 27 November 2026.
# They place edges otherwise by less than a pixel. Lavapipe drew what is checked in.
PICTURES = {
    "furniture/furniture.png": (0.079, "LIMN render furniture/furniture.scene.yaml -o OUT"),
    "furniture/outlines.png": (0.131, "furniture/outlines.sh OUT LIMN"),
    "selection/techniques.png": (0.042, "selection/contact_sheet.sh OUT LIMN"),
    "translucent_solid/translucent_solid.png": (
        0.028, "LIMN render translucent_solid/translucent_solid.scene.yaml -o OUT"),
}
MARGIN = 1.5  # for another release of either driver
# consumer/run.sh draws the program's picture. The plot is of times, which nothing measures twice. What
# the guides show is drawn by run.py.
ELSEWHERE = ("guide/program/torus.png", "furniture/error_time.svg")


def main():
    samples, limn = pathlib.Path(sys.argv[1]).resolve() / "samples", str(pathlib.Path(sys.argv[2]).resolve())
    guides = "".join(page.read_text() for page in samples.glob("guide/*.md"))
    problems = [f"samples/{name}: nothing draws this picture anew" for file in samples.rglob("*")
                for name in [str(file.relative_to(samples))] if file.suffix in (".png", ".svg")
                and name not in PICTURES and name not in ELSEWHERE and f"/{file.name})" not in guides]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else temporary).resolve()
        for name, (apart, command) in PICTURES.items():
            drawn, shown = folder / name, samples / name
            drawn.parent.mkdir(parents=True, exist_ok=True)
            words = {"LIMN": limn, "OUT": str(drawn)}
            subprocess.run([words.get(word, word) for word in command.split()], check=True,
                           stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL, cwd=samples)
            mean = difference(drawn, shown) if shown.exists() else float("inf")
            print(f"samples/{name}: {mean:.4f} of 255")
            if os.environ.get("LIMN_UPDATE_GOLDEN") and mean > 0:
                shutil.copy(drawn, shown)
            elif mean > MARGIN * apart:
                problems.append(f"samples/{name} is drawn otherwise than it is checked in: the mean difference "
                                f"is {mean:.4f} of 255, more than {MARGIN * apart:.4f}; LIMN_UPDATE_GOLDEN=1 writes it")
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
