#!/usr/bin/env python3
"""Lets allocations of whole programs fail, one in each run.

Usage: memory.py LIMN FAULTY_MALLOC SOURCE_FOLDER [CASE ...]

A run must end by itself, either as ever, or with exit code 3 and a sentence that memory ran out; a
picture is then the old one. LIMN_FAULTS_ALL=N takes every N-th allocation instead of a sample,
which takes hours with 1.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # the source folder stays as it is
import faults  # noqa: E402

LIMN, MODULE, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SENTENCES = ("there is not enough memory", "VK_ERROR_OUT_OF_HOST_MEMORY")
OLD = b"an old picture"
# Who asks for the memory that fails: limn, what is linked into it, and its parsers. Others use what
# they did not get (Vulkan's loader, layers and drivers), end the program (LLVM), or hold locks for
# ever (the dynamic linker).
ASKING = "limn:liblimn:libyaml-cpp:libpng:libtinygltf"

SCENE = """\
size: [8, 8]
camera: {position: [0, 0, -3]}
materials: {red: {shader: Universal Render Pipeline/Unlit, _BaseColor: "#a5483f"}}
objects: [{name: Cube, mesh: cube, material: red}]
"""

CASES = {
    "shader": ["shader", "--parse-only", SOURCE / "features/wide_outline/WideOutline.shader"],
    "scene": ["inspect", SOURCE / "tests/vulkan/faults/everything.scene.yaml"],
    "profile": ["inspect", SOURCE / "samples/selection/strokes.profile.yaml"],
    "asset": ["inspect", SOURCE / "tests/volume/data/SampleSceneProfile.asset"],
    "cold": ["render", "small.scene.yaml", "-o", "out.png"],  # shaders are compiled
    "warm": ["render", "small.scene.yaml", "-o", "out.png"],  # they come from the cache
}
# Of the process that compiles a shader, whose memory is limited: it may be the shader's fault.
COMPILER_SENTENCE = "compiling it takes more memory than there is for it"
# Of allocations that so many callers in a row ask for alike the first one stands for all.
PATHS = {"cold": 4, "warm": 8}
SAMPLES = {"cold": 2, "warm": 6}
CACHE = tempfile.TemporaryDirectory(prefix="limn-memory-")


class Run:
    """The program's end: exit code, output, messages, picture, and who asked for the memory."""

    note = ""

    def __init__(self, case, number, lasts=False):
        with tempfile.TemporaryDirectory(prefix="limn-memory-") as folder:
            folder = pathlib.Path(folder)
            (folder / "small.scene.yaml").write_text(SCENE)
            picture = folder / "out.png"
            picture.write_bytes(OLD)
            report = folder / "report"
            environment = dict(os.environ, LD_PRELOAD=str(MODULE), LIMN_MALLOC_FAIL=str(number),
                               LIMN_MALLOC_OF=ASKING, LIMN_MALLOC_REPORT=str(report),
                               LIMN_MALLOC_PATHS=str(PATHS.get(case, 0)),
                               XDG_CACHE_HOME=CACHE.name if case == "warm" else folder / "cache")
            if lasts:
                environment["LIMN_MALLOC_LASTS"] = "1"
            try:
                ended = subprocess.run([LIMN, *CASES[case]], cwd=folder, env=environment,
                                       capture_output=True, timeout=300)
                self.code = ended.returncode
                self.out = ended.stdout
                self.err = ended.stderr.decode(errors="replace")
            except subprocess.TimeoutExpired:
                self.code, self.out, self.err = "none: it hangs", b"", ""
            self.picture = picture.read_bytes()
            lines = report.read_text().splitlines() if report.exists() else []
            self.counted = [int(line.split()[1]) for line in lines if line.startswith("counted")]
            self.place = [line for line in lines if not line.startswith("counted")][2:]
            self.left = sorted(path.name for path in folder.iterdir()
                               if path.name not in ("small.scene.yaml", "out.png", "report", "cache"))

    def problem(self, good):
        """What is wrong with the end; "" if nothing is."""
        if self.left:
            return "left behind: " + ", ".join(self.left)
        if self.code == 0:
            same = self.out == good.out and self.picture == good.picture
            return "" if same else "another result than ever, without a word"
        if self.code == 3 and any(sentence in self.err for sentence in SENTENCES):
            return "" if self.picture == OLD else "a picture in spite of the error"
        if self.code == 1 and COMPILER_SENTENCE in self.err:
            return ""
        return "exit code " + str(self.code)


def try_case(case):
    if case == "warm":
        Run(case, 0)  # fills the cache
    good = Run(case, 0)
    if good.code != 0 or not good.counted:
        sys.exit(f"{case}: exit code {good.code} without a fault: {good.err}")
    count = good.counted[0]
    step = faults.STEP or max(1, count // SAMPLES.get(case, 8))
    numbers = range(1 + step // 2, count + 1, step)
    return faults.try_numbers(case, "allocation", numbers, count,
                              lambda number: Run(case, number), good)


faults.main(sys.argv[4:] or CASES, try_case)
