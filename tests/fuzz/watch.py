#!/usr/bin/env python3
"""Saves mutated shaders under one `limn watch` and looks whether it lives on.

After every fiftieth save a right shader of one of four colours is saved, and the picture must be the
one that `limn render` makes of it. Exit code 1 if watch ends, falls silent for TIMEOUT seconds, or
shows another picture.

Usage: tests/fuzz/watch.py [--limn PROGRAM] [--count N] [--seed N]
"""

import argparse
import os
import pathlib
import random
import select
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from mutations import mutate_text  # noqa: E402
from project import INCLUDE, ROOT, SHADER  # noqa: E402

TIMEOUT = 90  # a compilation may take 30 s, and a shader has several passes
SCENE = """size: [16, 9]
camera: {position: [0, 0, -4]}
materials: {own: {shader: own.shader}}
objects: [{name: Piece, mesh: cube, material: own}]
"""
COLOURS = ["1, 0, 0, 1", "0, 1, 0, 1", "0, 0, 1, 1", "1, 1, 0, 1"]


def right_shader(colour):
    return SHADER.replace("(1, 1, 1, 1)", f"({colour})").encode()


def others():
    """What pieces of other shaders come from."""
    files = sorted((ROOT / "tests/shaderlab/corpus").rglob("*.shader")) or [pathlib.Path(__file__)]
    return [file.read_bytes() for file in files]


class Watch:
    def __init__(self, limn, folder, environment):
        self.folder = folder
        self.process = subprocess.Popen(
            [limn, "watch", "s.scene.yaml", "-o", "out.png", "--no-cache"], cwd=folder, env=environment,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.said = b""

    def save(self, data):
        """Saves a shader and waits until watch has answered. Returns what it said."""
        fresh = self.folder / "own.shader.new"
        fresh.write_bytes(data)
        fresh.rename(self.folder / "own.shader")
        return self.answer()

    def answer(self):
        self.said = b""
        wait = TIMEOUT
        while select.select([self.process.stdout], [], [], wait)[0]:
            piece = os.read(self.process.stdout.fileno(), 1 << 16)
            if not piece:
                raise SystemExit(f"watch ended with exit code {self.process.wait()}: {self.said.decode()}")
            self.said += piece
            wait = 0.05
        return self.said


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limn", default=str(ROOT / "build/release/editor_stub/limn"))
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    limn = str(pathlib.Path(options.limn).resolve())
    rng = random.Random(options.seed)
    seeds = others()
    with tempfile.TemporaryDirectory(prefix="limn-watch-") as name:
        folder = pathlib.Path(name)
        environment = {**os.environ, "HOME": name, "XDG_CACHE_HOME": f"{name}/cache"}
        (folder / "s.scene.yaml").write_text(SCENE)
        (folder / "Tint.hlsl").write_text(INCLUDE)
        pictures = []
        for colour in COLOURS:
            (folder / "own.shader").write_bytes(right_shader(colour))
            subprocess.run([limn, "render", "s.scene.yaml", "-o", "right.png", "--no-cache"], cwd=folder,
                           env=environment, check=True, capture_output=True)
            pictures.append((folder / "right.png").read_bytes())
        assert len(set(pictures)) == len(COLOURS), "the colours do not show"
        watch = Watch(limn, folder, environment)
        watch.answer()
        drawn = failed = crashed = 0
        for number in range(1, options.count + 1):
            mutant = right_shader(rng.choice(COLOURS))
            for _ in range(rng.randrange(1, 4)):
                mutant = mutate_text(mutant, rng, rng.choice(seeds))
            said = watch.save(mutant)
            if not said:
                raise SystemExit(f"save {number}: watch said nothing for {TIMEOUT} s")
            crashed += b"the HLSL compiler" in said
            failed += b"error:" in said
            drawn += b"error:" not in said
            if number % 50 == 0 or number == options.count:
                which = rng.randrange(len(COLOURS))
                said = watch.save(right_shader(COLOURS[which]))
                while (folder / "out.png").read_bytes() != pictures[which]:
                    said = watch.answer() # what came before may have been said late
                    if not said:
                        shutil.copytree(folder, "watch-finding", dirs_exist_ok=True)
                        raise SystemExit(f"save {number}: the picture is another one")
        watch.process.terminate()
        code = watch.process.wait(TIMEOUT)
        print(f"{options.count} saves: {drawn} drawn, {failed} refused, of these {crashed} by the "
              f"compiler's end; watch ended with {code}")
        sys.exit(code != 0)


if __name__ == "__main__":
    main()
