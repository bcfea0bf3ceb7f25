#!/usr/bin/env python3
"""Lets calls to Vulkan of whole programs fail, one in each run.

Usage: programs.py LIMN FAULTY_VULKAN [CASE ...]

A run must end by itself: as ever, or with exit code 3, or 1 where the scene asks for what the device
lacks, and with a sentence. No file may be half written, and no object of Vulkan left. `watch` must
draw again when a file changes, or end so. LIMN_FAULTS_ALL=N takes every N-th call instead of a
sample, which takes hours with 1.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the source folder stays as it is
import faults  # noqa: E402

LIMN, MODULE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SCENE = """\
size: [16, 16]
msaaSampleCount: 4
camera: {position: [0, 0, -3], renderPostProcessing: true}
light: {rotation: [50, -30, 0], shadows: Soft}
shadows: {m_MainLightShadowmapResolution: 64}
renderer:
  features: [{type: StrokeOutlineRendererFeature}, {type: PostProcessRendererFeature}]
volumes: [{name: All, profile: small.profile.yaml, isGlobal: true}]
materials: {red: {_BaseColor: "#a5483f"}}
objects:
  - {name: Cube, mesh: cube, material: red, rotation: [10, 30, 0]}
"""
PROFILE = "StrokeOutline: {m_Enable: true, m_OutlineWidth: 2}\nBloom: {intensity: 1}\n"
OLD = b"an old picture"
SECONDS = 300
NO_ERRORS = ("VK_INCOMPLETE", "VK_TIMEOUT")
RESULTS = ("VK_ERROR_OUT_OF_DEVICE_MEMORY", "VK_ERROR_DEVICE_LOST", "VK_ERROR_FORMAT_NOT_SUPPORTED",
           "VK_ERROR_INITIALIZATION_FAILED", *NO_ERRORS)
CASES = {
    "render": ["render", "small.scene.yaml", "-o", "out.png"],
    "watch": ["watch", "small.scene.yaml", "-o", "out.png"],
    "report": ["report", "small.scene.yaml", "-o", "report", "--quick", "--technique", "strokes",
               "--size", "16x16"],
}
# What of it is tried in a sample, one call of each.
SAMPLES = {"render": RESULTS, "watch": RESULTS[:2], "report": RESULTS[:1]}
CACHE = tempfile.TemporaryDirectory(prefix="limn-programs-")


def drawn(out):
    return sum(line.startswith("out.png ") for line in out.read_text().splitlines())


def errors(err):
    return sum(line.startswith("error: ") for line in err.read_text(errors="replace").splitlines())


def watch(process, out, err, profile):
    """Changes a file once a picture or an error is there, and stops the program once another is."""
    for answers in (1, 2):
        end = time.monotonic() + SECONDS
        while drawn(out) + errors(err) < answers and process.poll() is None:
            if time.monotonic() > end:
                return
            time.sleep(0.02)
        profile.write_text(profile.read_text() + "# changed\n")
    process.send_signal(signal.SIGTERM)


class Run:
    """The program's end: exit code, messages, and files."""

    def __init__(self, case, result, number):
        self.result = result
        with tempfile.TemporaryDirectory(prefix="limn-programs-") as folder:
            folder = pathlib.Path(folder)
            (folder / "small.scene.yaml").write_text(SCENE)
            profile = folder / "small.profile.yaml"
            profile.write_text(PROFILE)
            (folder / "out.png").write_bytes(OLD)
            environment = dict(os.environ, LD_PRELOAD=str(MODULE), LIMN_FAULT_CALL=str(number),
                               LIMN_FAULT_RESULT=result, LIMN_FAULT_REPORT=str(folder / "fault"),
                               XDG_CACHE_HOME=CACHE.name)
            with open(folder / "out", "wb") as out, open(folder / "err", "wb") as err:
                process = subprocess.Popen([LIMN, *CASES[case]], cwd=folder, env=environment,
                                           stdout=out, stderr=err)
                try:
                    if case == "watch":
                        watch(process, folder / "out", folder / "err", profile)
                    self.code = process.wait(SECONDS)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
                    self.code = "none: it hangs"
            self.err = (folder / "err").read_text(errors="replace")
            self.pictures = drawn(folder / "out")
            self.errors = errors(folder / "err")
            self.picture = (folder / "out.png").read_bytes()
            fault = folder / "fault"
            report = fault.read_text() if fault.exists() else ""
            if self.code == -signal.SIGTERM and self.errors:
                self.code, report = 3, ""  # the signal came when it was about to end by itself
            ended, *calls = report.splitlines() or ["nothing"]
            failed, *self.objects = ended.split()
            self.place = [failed]
            self.note = ", no call failed" if failed == "nothing" else ""
            self.calls = {line.split()[0]: int(line.split()[1]) for line in calls}
            self.broken = [problem for problem in map(broken, sorted(folder.rglob("*"))) if problem]

    def problem(self, good):
        """What is wrong with the end; "" if nothing is."""
        if self.code not in (0, 1, 3):
            return "exit code " + str(self.code)
        if self.broken:
            return "; ".join(self.broken)
        if self.objects:
            return "left " + " ".join(self.objects)
        if self.picture not in (OLD, good.picture) and "in place of 4" not in self.err:
            return "another picture than ever"
        if self.code == 0 and (self.pictures + self.errors < good.pictures or self.pictures < bool(good.pictures)):
            return "exit code 0 without a picture"
        if self.code != 0 and not self.err.rstrip().splitlines()[-1:][0].startswith("error: "):
            return "no sentence"
        if self.result in NO_ERRORS and self.code != 0:
            return "exit code " + str(self.code) + " without an error"
        if self.code == 1 and "the device" not in self.err:
            return "exit code 1, and the input is right"
        return ""


def broken(path):
    """What is wrong with a file that a program wrote; "" if nothing is."""
    if path.is_dir():
        return ""
    data = path.read_bytes()
    if path.suffix == ".png" and data != OLD and not data.endswith(b"IEND\xaeB`\x82"):
        return path.name + " is half written"
    if path.suffix == ".json":
        try:
            json.loads(data)
        except ValueError as error:
            return path.name + ": " + str(error)
    known = (".png", ".json", ".jsonl", ".csv", ".md", ".html", ".svg", ".gnuplot", ".yaml")
    if path.suffix not in known and path.name not in ("out", "err", "fault"):
        return path.name + " is left behind"
    return ""


def try_case(case):
    good = Run(case, RESULTS[0], 0)
    problem = good.problem(good)
    if good.code != 0 or problem:
        sys.exit(f"{case}: without a fault: {problem} {good.err}")
    results = RESULTS if faults.STEP else SAMPLES[case]
    return all([try_result(case, result, good) for result in results])


def try_result(case, result, good):
    calls = good.calls[result]
    numbers = range(1, calls + 1, faults.STEP) if faults.STEP else [calls * 2 // 3]
    return faults.try_numbers(f"{case}, {result}", "call", numbers, calls,
                              lambda number: Run(case, result, number), good)


faults.main(sys.argv[3:] or CASES, try_case)
