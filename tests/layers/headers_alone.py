#!/usr/bin/env python3
"""Fails where a public header does not compile unless another one was included before it.

Usage: headers_alone.py COMPILER COMPILE_COMMANDS. A header that another one includes before all else is compiled alone
there, and not once more. Before the script looks at limn's headers it looks at made-up ones, so that a check that finds
nothing can be believed.
"""
import json
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from pathlib import Path

OPTIONS = ["-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror", "-fsyntax-only"]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*<([^>]+)>', re.MULTILINE)


def public_headers(folders):
    """Returns {name: path} of limn's headers; the name is how they are included."""
    return {path.relative_to(folder).as_posix(): path
            for folder in folders if folder.is_dir() for path in sorted((folder / "limn").rglob("*.h"))}


def check(compiler, folders):
    """Returns how many headers there are, and what the compiler says against each that does not compile alone."""
    headers = public_headers(folders)
    first = {next(iter(INCLUDE.findall(path.read_text(encoding="utf-8"))), None) for path in headers.values()}
    command = [compiler, *OPTIONS, *(f"-I{folder}" for folder in folders), "-x", "c++", "-"]

    def compile_alone(name):
        run = subprocess.run(command, input=f"#include <{name}>\n", capture_output=True, text=True, check=False)
        return run.stderr if run.returncode != 0 else None

    with ThreadPoolExecutor(cpu_count()) as pool:
        return len(headers), [text for text in pool.map(compile_alone, sorted(headers.keys() - first)) if text is not None]


def self_check(compiler):
    """Looks at made-up headers, some of which lack an include or give a warning."""
    made = {
        "Good.h": "#include <string>\nstd::string Good();\n",
        "OnGood.h": "#include <limn/Good.h>\ninline std::string OnGood() { return Good(); }\n",
        "OnBoth.h": "#include <limn/OnGood.h>\n#include <vector>\nstd::vector<std::string> OnBoth();\n",
        "Bad.h": "#include <limn/OnGood.h>\nstd::vector<std::string> Bad();\n",
        "BadInsideAnother.h": "std::vector<int> BadInsideAnother();\n",
        "BeginsWithABadOne.h": "#include <limn/BadInsideAnother.h>\n",
        "OnBad.h": "#include <vector>\n#include <limn/Bad.h>\nint OnBad();\n",
        "Warns.h": "#include <string>\ninline int Warns(double value) { return value; }\n",
    }
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "limn").mkdir()
        for name, text in made.items():
            (Path(folder) / "limn" / name).write_text("#pragma once\n" + text, encoding="utf-8")
        said = "".join(check(compiler, [Path(folder)])[1])
    found = {name for name in made if f"limn/{name}:" in said and "error:" in said.split(f"limn/{name}:", 1)[1].split("\n")[0]}
    expected = {"Bad.h", "BadInsideAnother.h", "Warns.h"}
    if found != expected:
        sys.exit(f"the check itself is wrong: it should refuse {sorted(expected)} and refuses {sorted(found)}")


def include_folders(compile_commands):
    """Returns the folders of public headers that any source of the build is compiled with."""
    words = {word for entry in json.loads(Path(compile_commands).read_text(encoding="utf-8"))
             for word in shlex.split(entry["command"])}
    return [Path(word[2:]) for word in sorted(words) if word.startswith("-I") and word.endswith("/include")]


def main():
    compiler, compile_commands = sys.argv[1:]
    self_check(compiler)
    count, problems = check(compiler, include_folders(compile_commands))
    if count < 100:
        sys.exit(f"only {count} public headers found by way of {compile_commands}; is that limn's?")
    for text in problems:
        print(text, file=sys.stderr)
    print(f"{count} public headers, {len(problems)} do not compile alone")
    sys.exit(1 if problems else 0)


main()
