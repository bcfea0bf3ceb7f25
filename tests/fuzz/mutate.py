#!/usr/bin/env python3
"""Feeds `limn` files that were good until something happened to them, and counts how it ends.

Every input is a file of the samples or tests with one to four mutations, within a small project that
refers to it; the verb that reads such a file runs on it with limits on time and memory. First come
the inputs made by hand (HOSTILE), each with the answer it should get. The same seed gives the same
inputs, whatever the number of jobs. Exit code 1, and the inputs are kept, if one of them ends in a
way that FAILURES names.

Usage: tests/fuzz/mutate.py [--limn PROGRAM] [--count N] [--seed N] [--jobs N] [--case N] [--keep DIR]
"""

import argparse
import collections
import concurrent.futures
import functools
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib

sys.dont_write_bytecode = True
from hostile import HOSTILE  # noqa: E402
from project import ROOT, make_project  # noqa: E402

# ---------------------------------------------------------------- kinds of files and how they are read

# kind: (share of all inputs, file, verbs one of which runs, further files to begin with)
PROFILE = "Assets/Scenes/SampleSceneProfile.asset"
RENDERER = "Assets/Settings/UniversalRenderer.asset"
SET = ["ScreenSpaceOutline.outlineWidth=4"]
KINDS = {
    "scene": (20, "s.scene.yaml", [["inspect"], ["explain", "--json"]],
              ["samples/furniture/furniture.scene.yaml"]),
    "profile": (12, "p.profile.yaml", [["inspect"], ["set", *SET], ["inspect", "--json"]],
                ["samples/furniture/cannot_place.profile.yaml"]),
    "shader text": (18, "own.shader", [["shader", "--parse-only"], ["shader", "--parse-only", "--json"]],
                    ["tests/fuzz/parser_seeds", "tests/shaderlab/corpus"]),
    "shader": (8, "own.shader", [["shader"], ["shader", "--json"], ["inspect", "s.scene.yaml"]], []),
    "include": (5, "Tint.hlsl", [["shader", "own.shader"]], []),
    "glTF": (10, "m.gltf", [["inspect", "s.scene.yaml"]], ["samples/translucent_solid/torus_knot.gltf"]),
    "glb": (5, "m.glb", [["inspect", "s.scene.yaml"]], []),
    "buffer": (2, "m.bin", [["inspect", "s.scene.yaml"]], []),
    "png": (6, "t.png", [["inspect", "s.scene.yaml"]], []),
    "renderer asset": (6, RENDERER, [["inspect"], ["inspect", "unity.scene.yaml"]], []),
    "profile asset": (6, PROFILE, [["inspect"], ["set", *SET], ["inspect", "unity.scene.yaml"]],
                      ["tests/volume/data/SampleSceneProfile.asset"]),
    "Unity scene": (3, "u.asset", [["inspect"], ["set", *SET]], []),
    "drawn scene": (1, "s.scene.yaml", [["render", "s.scene.yaml", "-o", "out.png", "--no-cache"]], []),
    "meta": (3, "Assets/_Project/ScreenSpaceOutline/Shaders/ScreenSpaceOutline.shader.meta",
             [["inspect", RENDERER]], []),
}


@functools.lru_cache(maxsize=None)
def files_of(kind):
    paths = [path for name in KINDS[kind][3] for path in [ROOT / name, *sorted((ROOT / name).rglob("*.shader"))]]
    return [path.read_bytes() for path in paths if path.is_file() and ".expected." not in path.name]


def seeds_of(kind, project):
    """The contents a kind's inputs begin with; the project's own file is half of them."""
    files = files_of(kind)
    return [(project / KINDS[kind][1]).read_bytes()] * max(1, len(files)) + files


# ---------------------------------------------------------------- mutations

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


def make_input(seed, number, project):
    """The kind, the verb and the content of an input; the same for the same seed and number."""
    rng = random.Random(f"{seed}:{number}")
    kind = rng.choices(list(KINDS), [entry[0] for entry in KINDS.values()])[0]
    seeds = seeds_of(kind, project)
    data = rng.choice(seeds)
    mutate = mutate_bytes if kind in ("png", "buffer", "glb") and rng.random() < 0.8 else mutate_text
    for _ in range(rng.choice([1, 1, 1, 2, 2, 3, 4])):
        data = mutate(data, rng, rng.choice(seeds))
    if kind == "png" and rng.random() < 0.7:
        data = with_checksums(data)
    return kind, rng.choice(KINDS[kind][2]), data


# ---------------------------------------------------------------- running and judging

FAILURES = ["crash", "hang", "sanitizer report", "raw exception", "bug in limn", "wrong exit code",
            "error but exit code 0", "refused without a word", "partial output", "control characters",
            "not the answer"]
RAW = re.compile(r"json\.exception|std::|bad_alloc|basic_string|vector::|_M_|filesystem error|terminate called"
                 r"|map::at|error: (stoi|stof|stod|unordered_map)|regex_error|Assertion|pure virtual")
CONTROL = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]")


def execute(options, command, folder):
    """The exit code (negative: the signal, None: too long), stdout and stderr."""
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder / "home"), "TERM": "dumb", "LANG": "C.UTF-8",
                   "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1"}
    process = subprocess.Popen([options.limn, *command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    resource.prlimit(process.pid, resource.RLIMIT_CPU, (options.seconds, options.seconds))
    if options.megabytes:
        resource.prlimit(process.pid, resource.RLIMIT_AS, (options.megabytes << 20,) * 2)
    try:
        out, err = process.communicate(timeout=10 * options.seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        out, err = process.communicate()
        return None, out, err
    code = process.returncode
    return (None if code in (-signal.SIGXCPU, -signal.SIGKILL) else code), out, err


def snapshot(folder):
    return {path: path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and "home" not in path.relative_to(folder).parts}


def is_whole(command, code, before, after):
    """Whether the files are as before but for what the command was to write, if it says that it did."""
    done = code == 0
    wanted = {path for path in after if "-o" in command and path.name == "out.png"}
    may_change = done and command[0] == "set"
    return (after.keys() - before.keys() == (wanted if done else set()) and before.keys() <= after.keys() and
            all(after[path].endswith(b"IEND\xaeB`\x82") for path in wanted) and
            (may_change or all(after[path] == content for path, content in before.items())))


def classify(command, code, out, err, before, after):
    text = err.decode("utf-8", "replace")
    if code is None:
        return "hang"
    if "Sanitizer" in text or "runtime error: " in text:
        return "sanitizer report"
    if code < 0:
        return "crash"
    if RAW.search(text):
        return "raw exception"
    if "bug in limn" in text:
        return "bug in limn"
    if not is_whole(command, code, before, after):
        return "partial output"
    if code == 3 and "device" in text:
        return "no device"
    if code not in (0, 1):
        return "wrong exit code"
    if CONTROL.search(err) or text.encode() != err:
        return "control characters"
    if code == 0:
        return "error but exit code 0" if re.search(r"(?m)^(?:\S*: )?error: ", text) else "ok"
    if re.search(r":\d+(:\d+)?: error: ", text) or re.search(r'"line": ?[1-9]', out.decode("utf-8", "replace")):
        return "refused, with file:line"
    return "refused, with file" if ": error: " in text else "refused without a word"


def run_case(options, number):
    """Of a number below 0, one made by hand; else a mutated one."""
    with tempfile.TemporaryDirectory(prefix="limn-mutate-") as name:
        folder = pathlib.Path(name)
        make_project(folder)
        expected = None
        if number < 0:
            kind, file, content, command, *expected = HOSTILE[-number - 1]
            content = content()
            data = content if isinstance(content, bytes) else content.encode()
        else:
            kind, verb, data = make_input(options.seed, number, folder)
            file = KINDS[kind][1]
            has_own = any(word.endswith((".yaml", ".shader", ".asset")) for word in verb)
            command = verb if has_own else [verb[0], file, *verb[1:]]
        (folder / file).write_bytes(data)
        before = snapshot(folder)
        code, out, err = execute(options, command, folder)
        outcome = classify(command, code, out, err, before, snapshot(folder))
        if expected:
            said = (out + err).decode("utf-8", "replace")
            is_bad = outcome in FAILURES and not (outcome == "wrong exit code" and code == expected[0])
            is_right = code == expected[0] and re.search(expected[1], said)
            outcome = outcome if is_bad else "as expected" if is_right else "not the answer"
        if outcome in FAILURES or options.case is not None:
            kept = pathlib.Path(options.keep) / f"{'hostile' if number < 0 else options.seed}_{abs(number)}"
            shutil.rmtree(kept, ignore_errors=True)
            make_project(kept)
            (kept / file).write_bytes(data)
            (kept / "RUN").write_text(f"cd {kept} && {options.limn} {' '.join(command)}\n# {outcome}, exit code {code}"
                                      f"\n{err.decode('utf-8', 'replace')[-4000:]}")
        return kind, outcome, command, err.decode("utf-8", "backslashreplace")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--limn", default=str(ROOT / "build/release/editor_stub/limn"), help="the program")
    parser.add_argument("--count", type=int, default=2000, help="mutated inputs")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--case", type=int, help="only this input, and keep it; below 0: one made by hand")
    parser.add_argument("--keep", default=str(ROOT / "build/mutants"), help="where inputs that fail are kept")
    parser.add_argument("--seconds", type=int, default=10, help="processor time of one run")
    parser.add_argument("--megabytes", type=int, default=2048, help="memory of one run; 0 under a sanitizer")
    options = parser.parse_args()
    options.limn = os.path.abspath(options.limn)
    options.keep = os.path.abspath(options.keep)

    numbers = [options.case] if options.case is not None else \
        [*range(-len(HOSTILE), 0), *range(options.count)]
    begin = time.monotonic()
    counts = collections.defaultdict(collections.Counter)
    failed = []
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        results = pool.map(functools.partial(run_case, options), numbers, chunksize=4)
        for number, (kind, outcome, command, err) in zip(numbers, results):
            counts["made by hand" if number < 0 else kind][outcome] += 1
            if outcome in FAILURES:
                failed.append(number)
                print(f"input {number} ({kind}): {outcome}: limn {' '.join(command)}\n    " +
                      "\n    ".join(line[:300] for line in err.splitlines()[:3]), flush=True)
            elif options.case is not None:
                print(f"{outcome}: limn {' '.join(command)}\n{err}")

    outcomes = sorted({outcome for counter in counts.values() for outcome in counter})
    print(f"seed {options.seed}: {len(numbers)} inputs in {time.monotonic() - begin:.1f} s, {options.jobs} at a time")
    for kind, counter in counts.items():
        print(f"  {kind:15}", *(f"{outcome}: {counter[outcome]}" for outcome in outcomes if counter[outcome]), sep="  ")
    total = sum(counts.values(), collections.Counter())
    print(f"  {'all':15}", *(f"{outcome}: {total[outcome]}" for outcome in outcomes), sep="  ")
    if failed:
        print(f"{len(failed)} failed; kept in {options.keep}; again: tests/fuzz/mutate.py --seed {options.seed} "
              f"--case {failed[0]}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
