#!/usr/bin/env python3
"""Feeds `limn` files that were good until something happened to them, and counts how it ends.

Every input stands within a small project that refers to it (kinds.py): a file of the samples or tests
with one to four mutations, a folder of results that was tampered with, something that is no plug-in, a
list of odd arguments. The verb that reads it runs with limits on time and memory. First come the
inputs made by hand (HOSTILE), each with the answer it should get. The same seed gives the same inputs,
whatever the number of jobs. Exit code 1, and the inputs are kept, if one of them ends in a way that
FAILURES names, or writes anything but what the command names.

Usage: tests/fuzz/mutate.py [--limn PROGRAM] [--count N] [--seed N] [--kinds KIND,KIND] [--jobs N]
    [--case N] [--keep DIR]
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
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from hostile import HOSTILE  # noqa: E402
from kinds import KINDS, RESUME  # noqa: E402
from project import ROOT, SECRET, make_project  # noqa: E402


def make_input(options, number, folder):
    """Writes an input into a project; returns its kind and the command that reads it."""
    if number < 0:
        kind, file, content, command = HOSTILE[-number - 1][:4]
        content = content()
        (folder / file).write_bytes(content if isinstance(content, bytes) else content.encode())
        return kind, command
    rng = random.Random(f"{options.seed}:{number}")
    kind = rng.choices(options.kinds, [KINDS[kind][0] for kind in options.kinds])[0]
    return kind, KINDS[kind][1](rng, folder, options)


# ---------------------------------------------------------------- running and judging

FAILURES = ["crash", "hang", "sanitizer report", "raw exception", "bug in limn", "wrong exit code",
            "error but exit code 0", "refused without a word", "left a temporary file", "wrote what was not named",
            "partial output", "copied a secret", "control characters", "not the answer"]
RAW = re.compile(r"json\.exception|std::|bad_alloc|basic_string|vector::|_M_|filesystem error|terminate called"
                 r"|map::at|error: (stoi|stof|stod|unordered_map)|regex_error|Assertion|pure virtual")
CONTROL = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]")
LACKS = re.compile(r"device|memory|cannot be written: |standard output|File name too long|'dot'|Vulkan")


def execute(options, command, folder):
    """The exit code (negative: the signal, None: too long), stdout and stderr."""
    outside = folder.parent
    # Without gnuplot, which takes longer than limn, but for some.
    path = os.environ["PATH"] if command[0] != "report" or options.plots else str(outside)
    environment = {"PATH": path, "HOME": str(outside / "home"), "TMPDIR": str(outside / "temporary"), "TERM": "dumb",
                   "LANG": "C.UTF-8", "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1"}
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
    """Everything that lies below a folder: what it holds, or what it is."""
    found = {}
    for place, folders, files in os.walk(folder):
        for name in folders + files:
            path = pathlib.Path(place) / name
            found[path] = (b"link to " + os.fsencode(os.readlink(path)) if path.is_symlink() else
                           b"folder" if path.is_dir() else
                           b"sparse" if path.stat().st_size > 1 << 24 else
                           path.read_bytes() if path.is_file() else b"special")
    return found


def outputs_of(kind, command, folder):
    """The files and folders that a command names as what it may write."""
    words = [os.fsdecode(word) for word in command]
    names = words[1:2] if words[0] == "set" else words[words.index("-o") + 1:][:1] if "-o" in words else []
    if kind == "arguments":  # any word may name one
        names = [name for word in words for name in (word, word[2:], word.split("=", 1)[-1]) if len(name) < 4000]
    return {pathlib.Path(os.path.realpath(folder / name)) for name in names if name}


def problem_of_files(kind, command, code, folder, before, after):
    """What is wrong with the files that a run left; "" if nothing is."""
    changed = {path for path in before.keys() | after.keys()
               if before.get(path) != after.get(path) and not path.is_relative_to(folder.parent / "home") and
               path.name != "shader_validation_cache-0.bin"}  # the Vulkan validation layer's
    names = outputs_of(kind, command, folder)

    def may_change(path):
        return any(path.is_relative_to(name) or (after.get(path) == b"folder" and name.is_relative_to(path))
                   for name in [*names, folder.parent / "home"])
    if any(path.name.startswith((".limn-", "limn-")) for path in after.keys() - before.keys()):
        return "left a temporary file"
    if any(SECRET in after.get(path, b"") for path in changed):
        return "copied a secret"
    if stray := [path for path in changed if not may_change(path)]:
        print(f"not named: {', '.join(map(str, stray[:3]))}", flush=True)
        return "wrote what was not named"
    is_torn = any(path.suffix == ".png" and path.parent.name != "pictures" and path in after and
                  not after[path].endswith((b"IEND\xaeB`\x82", b"folder")) for path in changed)
    # What a report measured before it failed, the next one goes on with.
    is_left = code != 0 and changed and kind not in ("arguments", "results", "resumed")
    return "partial output" if is_torn or is_left else ""


def has_said_why(command, text, out):
    return (re.search(r"(?m)^error: |: error: |warning: .*missing: ", text) is not None or
            ("--compare" in command and out != b"") or '"severity": "error"' in out.decode("utf-8", "replace"))


def classify(kind, command, code, out, err, file_problem):
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
    if file_problem:
        return file_problem
    if code == 3 and LACKS.search(text + out.decode("utf-8", "replace")):
        return "the machine lacks something"
    if code == 2 and kind == "arguments" and ("usage: " in text or text.startswith("error: ")):
        return "wrong usage"
    if code not in (0, 1):
        return "wrong exit code"
    if CONTROL.search(err) or text.encode() != err:
        return "control characters"
    if code == 0:
        return "error but exit code 0" if re.search(r"(?m)^(?:\S*: )?error: ", text) else "ok"
    if re.search(r":\d+(:\d+)?: error: ", text) or re.search(r'"line": ?[1-9]', out.decode("utf-8", "replace")):
        return "refused, with file:line"
    if ": error: " in text:
        return "refused, with file"
    return "refused" if has_said_why(command, text, out) else "refused without a word"


def judge(options, number, folder):
    """Makes an input in a project, runs it: its kind, command, exit code, stderr, what it came to."""
    make_project(folder)
    (folder.parent / "temporary").mkdir()
    kind, command = make_input(options, number, folder)
    before = snapshot(folder.parent)
    options.plots = number % 16 == 0
    code, out, err = execute(options, command, folder)
    file_problem = problem_of_files(kind, command, code, folder, before, snapshot(folder.parent))
    outcome = classify(kind, command, code, out, err, file_problem)
    if number < 0:
        exit_code, pattern = HOSTILE[-number - 1][4:]
        said = (out + err).decode("utf-8", "replace")
        is_bad = outcome in FAILURES and not (outcome == "wrong exit code" and code == exit_code)
        is_right = code == exit_code and re.search(pattern, said)
        outcome = outcome if is_bad else "as expected" if is_right else "not the answer"
    return kind, command, code, err.decode("utf-8", "backslashreplace"), outcome


def run_case(options, number):
    """Of a number below 0, one made by hand; else a mutated one."""
    with tempfile.TemporaryDirectory(prefix="mutate-") as name:
        kind, command, code, err, outcome = judge(options, number, pathlib.Path(name) / "project")
    line = shlex.join(os.fsdecode(word) for word in command).encode("utf-8", "backslashreplace").decode()
    if outcome in FAILURES or options.case is not None:
        kept = pathlib.Path(options.keep) / f"{'hostile' if number < 0 else options.seed}_{abs(number)}"
        shutil.rmtree(kept, ignore_errors=True)
        make_project(kept / "project")
        make_input(options, number, kept / "project")
        (kept / "RUN").write_text(f"cd {kept / 'project'} && {options.limn} {line}\n# {outcome}, exit code {code}\n"
                                  f"{err[-4000:]}", errors="backslashreplace")
    return kind, outcome, line, err


def make_genuine_results(options, folder):
    """What runs of the kind "resumed" begin with, if they are asked for."""
    options.genuine = folder / "project/out"
    if "resumed" not in options.kinds or (options.case is not None and options.case < 0):
        return
    make_project(folder / "project")
    run = subprocess.run([options.limn, *RESUME], cwd=folder / "project", stderr=subprocess.PIPE, check=False,
                         stdout=subprocess.DEVNULL)
    if run.returncode != 0:
        print(f"no runs that go on: {run.stderr.decode('utf-8', 'replace')}", file=sys.stderr)
        options.kinds.remove("resumed")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--limn", default=str(ROOT / "build/release/editor_stub/limn"), help="the program")
    parser.add_argument("--count", type=int, default=2000, help="mutated inputs")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", default=",".join(KINDS), help="only these, a comma between two")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--case", type=int, help="only this input, and keep it; below 0: one made by hand")
    parser.add_argument("--keep", default=str(ROOT / "build/mutants"), help="where inputs that fail are kept")
    parser.add_argument("--seconds", type=int, default=10, help="processor time of one run")
    parser.add_argument("--megabytes", type=int, default=2048, help="memory of one run; 0 under a sanitizer")
    options = parser.parse_args()
    options.limn = os.path.abspath(options.limn)
    options.keep = os.path.abspath(options.keep)
    options.kinds = options.kinds.split(",")
    if unknown := set(options.kinds) - KINDS.keys():
        parser.error(f"unknown kinds {', '.join(unknown)}; known are {', '.join(KINDS)}")

    with tempfile.TemporaryDirectory(prefix="mutate-") as name:
        make_genuine_results(options, pathlib.Path(name))
        return run_all(options)


def run_all(options):
    numbers = [options.case] if options.case is not None else \
        [*range(-len(HOSTILE), 0), *range(options.count)]
    begin = time.monotonic()
    counts = collections.defaultdict(collections.Counter)
    failed = []
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        results = pool.map(functools.partial(run_case, options), numbers, chunksize=4)
        for number, (kind, outcome, line, err) in zip(numbers, results):
            counts["made by hand" if number < 0 else kind][outcome] += 1
            if outcome in FAILURES:
                failed.append(number)
                print(f"input {number} ({kind}): {outcome}: limn {line[:300]}\n    " +
                      "\n    ".join(text[:300] for text in err.splitlines()[:3]), flush=True)
            elif options.case is not None:
                print(f"{outcome}: limn {line}\n{err}")

    outcomes = sorted({outcome for counter in counts.values() for outcome in counter})
    print(f"seed {options.seed}: {len(numbers)} inputs in {time.monotonic() - begin:.1f} s, {options.jobs} at a time")
    for kind, counter in counts.items():
        print(f"  {kind:14}", *(f"{outcome}: {counter[outcome]}" for outcome in outcomes if counter[outcome]), sep="  ")
    total = sum(counts.values(), collections.Counter())
    print(f"  {'all':14}", *(f"{outcome}: {total[outcome]}" for outcome in outcomes), sep="  ")
    if failed:
        print(f"{len(failed)} failed; kept in {options.keep}; again: tests/fuzz/mutate.py --seed {options.seed} "
              f"--kinds '{','.join(options.kinds)}' --case {failed[0]}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
