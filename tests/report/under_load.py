#!/usr/bin/env python3
"""Takes times with `limn report` on a machine at rest and while busy loops are switched on and off, and
compares them. It is run by hand, not by CI: it needs minutes, and a machine that does little else.

Usage: under_load.py LIMN SCENE FOLDER [RUNS]
       RUNS pairs of a run at rest and one under load, 10 if not given. FOLDER keeps the results.
"""
import json
import multiprocessing
import os
import pathlib
import random
import subprocess
import sys
import time

TECHNIQUES = ("Strokes", "Screen space")
WORDS = ["--size", "192x108"] + [word for name in TECHNIQUES for word in ("--technique", name)]


def spin():
    while True:
        pass


class Load:
    """Busy loops, one a processor, that are switched on and off at random while this is entered."""

    def __init__(self, seed):
        self.seed = seed

    def switch(self, stop):
        source = random.Random(self.seed)
        while not stop.is_set():
            loops = [multiprocessing.Process(target=spin, daemon=True)
                     for _ in range(source.randint(1, 2 * os.cpu_count()))]
            for loop in loops:
                loop.start()
            stop.wait(source.uniform(0.05, 1.0))
            for loop in loops:
                loop.kill()
                loop.join()
            stop.wait(source.uniform(0.05, 1.0))

    def __enter__(self):
        self.stop = multiprocessing.Event()
        self.process = multiprocessing.Process(target=self.switch, args=(self.stop,))
        self.process.start()

    def __exit__(self, *unused):
        self.stop.set()
        self.process.join()


def unit_of_costs(limn, scene, folder):
    """The shard that holds nothing but the times of the scene, and how many shards there are then."""
    shards = 1000  # more than there are units: one shard one unit, most of them none
    subprocess.run([limn, "report", scene, "-o", folder, "--shard", f"{shards}/{shards}"] + WORDS,
                   check=True, stdout=subprocess.DEVNULL)
    units = []
    for cell in json.loads((folder / "study.json").read_text())["planned"]:
        what = {key: value for key, value in cell.items() if key != "technique"}
        if not (units and cell["kind"] == "cost" and units[-1] == what):
            units.append(what)
    wanted = [i for i, unit in enumerate(units)
              if unit["kind"] == "cost" and unit["subject"] == "scene" and unit["width"] == 4]
    return wanted[0] + 1, shards


def measure(limn, scene, folder, shard, shards):
    """The time that each technique adds and what it is known to, all that is known of the run, and
    how long it took."""
    begin = time.monotonic()
    subprocess.run([limn, "report", scene, "-o", folder, "--shard", f"{shard}/{shards}"] + WORDS,
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seconds = time.monotonic() - begin
    cells = [json.loads(line) for line in (folder / "cells.jsonl").read_text().splitlines()]
    values = {cell["id"]["technique"]: cell["values"] for cell in cells}
    return {name: (values[name]["gpuAddedMilliseconds"],
                   values[name].get("gpuAddedUncertainty")) for name in TECHNIQUES}, \
        values[TECHNIQUES[0]], seconds


def exact(value):
    return float(value)  # "nan" where the system does not tell


def text(figure):
    added, bound = figure
    return f"{added:7.3f} ± " + ("?     " if bound is None else f"{bound:<6.3f}")


def main():
    limn, scene, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    runs = int(sys.argv[4]) if len(sys.argv) > 4 else 10
    shard, shards = unit_of_costs(limn, scene, folder / "plan")
    results = {"rest": [], "load": []}
    for run in range(runs):
        for kind in results:
            where = folder / f"{kind}{run}"
            if kind == "load":
                with Load(run):
                    result = measure(limn, scene, where, shard, shards)
            else:
                result = measure(limn, scene, where, shard, shards)
            results[kind].append(result)
            figures, cell, seconds = result
            print(f"{kind} {run:2}: " + ", ".join(f"{name} {text(figures[name])} ms"
                                                  for name in TECHNIQUES) +
                  f"; {100 * cell['quietPart']:3.0f} % quiet, others "
                  f"{exact(cell['otherPrograms']):.2f}, {seconds:.0f} s", flush=True)
    for name in TECHNIQUES:
        true, bound = min((figures[name] for figures, _, _ in results["rest"] if figures[name][1]),
                          key=lambda figure: figure[1])
        print(f"{name}: {true:.3f} ± {bound:.3f} ms is the narrowest bound at rest")
        for kind, measured in results.items():
            known = [figures[name] for figures, _, _ in measured if figures[name][1] is not None]
            held = sum(abs(added - true) <= bound for added, bound in known)
            changed = sum(cell["quietPart"] < 0.9 for _, cell, _ in measured)
            print(f"  {kind}: within the bound in {held} of {len(known)} runs that have one, of "
                  f"{len(measured)}; the load changed in {changed}")


if __name__ == "__main__":
    main()
