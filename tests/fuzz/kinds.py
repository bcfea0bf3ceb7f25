"""The kinds of inputs: each writes one into a project, by a random number generator, and says what reads it."""

import functools
import os
import pathlib
import re
import shutil
import socket
import subprocess
import tempfile

from mutations import NUMBERS, TEXTS, mutate_bytes, mutate_text, with_checksums
from project import ROOT, png, write_results

# ---------------------------------------------------------------- one file that was good

# kind: (share of all inputs, file, verbs one of which runs, further files to begin with)
PROFILE = "Assets/Scenes/SampleSceneProfile.asset"
RENDERER = "Assets/Settings/UniversalRenderer.asset"
SET = ["ScreenSpaceOutline.outlineWidth=4"]
FILES = {
    "scene": (20, "s.scene.yaml", [["inspect"], ["explain", "--json"]],
              ["samples/furniture/furniture.scene.yaml"]),
    "profile": (12, "p.profile.yaml", [["inspect"], ["set", *SET], ["inspect", "--json"]],
                ["samples/furniture/cannot_place.profile.yaml"]),
    "shader text": (18, "own.shader", [["shader", "--parse-only"], ["shader", "--parse-only", "--json"]],
                    ["tests/fuzz/parser_seeds", "tests/shaderlab/corpus"]),
    "shader": (8, "own.shader", [["shader"], ["shader", "--json"], ["inspect", "s.scene.yaml"]], []),
    "include": (5, "Tint.hlsl", [["shader", "own.shader"]], []),
    "compute": (6, "own.compute", [["shader"], ["shader", "--keywords", "_EXTRA"], ["shader", "--parse-only"]],
                ["samples/porting/distance_outline/DistanceOutline.compute"]),
    "C#": (16, "own.cs", [["port", "-o", "out"], ["port", "more.cs", "-o", "out"]],
           ["tests/port_corpus", "tests/editor_stub/data/port", "samples/porting"]),
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
    endings = {".shader", ".cs", ".compute"}
    paths = [path for name in FILES[kind][3] for path in [ROOT / name, *sorted((ROOT / name).rglob("*"))]
             if path.is_file() and (path.suffix in endings or path == ROOT / name)]
    return [path.read_bytes() for path in paths if ".expected." not in path.name]


def repeated(data, rng):
    """With thousands of one line, which differ in a number: what takes time by their square shows."""
    lines = data.decode("utf-8", "surrogateescape").splitlines(keepends=True) or [""]
    at = rng.randrange(len(lines))
    many = [re.sub(r"\b([A-Za-z_]\w*)\b(?=[^\w]*$|\s*[=;,(])", rf"\g<1>{i}", lines[at], count=1) for i in range(3000)]
    return "".join(lines[:at] + many + lines[at + 1:]).encode("utf-8", "surrogateescape")


def mutated_file(kind, rng, folder, options):
    file, verbs = FILES[kind][1:3]
    seeds = [(folder / file).read_bytes()] * max(1, len(files_of(kind))) + files_of(kind)
    data = rng.choice(seeds)
    mutate = mutate_bytes if kind in ("png", "buffer", "glb") and rng.random() < 0.8 else mutate_text
    for _ in range(rng.choice([1, 1, 1, 2, 2, 3, 4])):
        data = mutate(data, rng, rng.choice(seeds))
    if kind == "C#" and rng.random() < 0.05:
        data = repeated(data, rng)
    if kind == "png" and rng.random() < 0.7:
        data = with_checksums(data)
    (folder / file).write_bytes(data)
    verb = rng.choice(verbs)
    has_own = any(word.endswith((".yaml", ".shader", ".asset")) for word in verb)
    return verb if has_own else [verb[0], file, *verb[1:]]


# ---------------------------------------------------------------- what stands where a file is expected

def replace(path, rng):
    """Something else in the place of a file; its folder may be something else already."""
    choice = rng.randrange(9)
    if path.parent.is_symlink() or not path.parent.is_dir():
        return
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)
    if choice == 0:
        path.mkdir()
    elif choice == 1:
        os.mkfifo(path)
    elif choice == 2:
        with socket.socket(socket.AF_UNIX) as server:
            place = os.open(path.parent, os.O_PATH)  # names of sockets are short
            server.bind(f"/proc/self/fd/{place}/{path.name}")
            os.close(place)
    elif choice == 3:
        path.write_bytes(b"")
    elif choice < 8:
        path.symlink_to(rng.choice([path.name, "nowhere", "/dev/zero", "/dev/null", "/dev/full", "..", ".",
                                    "../victim.txt", "../../victim.txt", "../../secret.txt", "../../../secret.txt",
                                    str(path.parents[1] / "victim.txt"), "/proc/self/mem", "../t.png"]))
    # else it is not there


# ---------------------------------------------------------------- folders of results

PICTURES = ["../victim.txt", "../secret.txt", "../../victim.txt", "/dev/null", "", ".", "..", "pictures", "pictures/",
            "pictures/..", "pictures/../../victim.png", "pictures/a.png", "pictures//a.png", "./pictures/a.png",
            "pictures/\\u0000.png", "pictures/a\\n.png", "pictures/" + "a" * 300 + ".png", "study.json", "cells.jsonl",
            "report.html", "pictures/.png", "pictures/a.PNG", "pictures/\\u202e.png", "pictures/b.png/../a.png"]


def tamper(folder, rng):
    """Changes one thing of a folder of results."""
    path = folder / rng.choice(["study.json", "cells.jsonl", "cells.jsonl", "pictures/a.png"])
    choice = rng.randrange(10)
    if choice == 0:
        replace(path, rng)
    elif choice == 1:
        replace(folder / rng.choice(["pictures", "plots", "report.html", "results.json", "."]), rng)
    elif path.is_file() and not path.is_symlink():
        data = path.read_bytes()
        names = re.findall(rb'"pictures/[^"]*"', data)
        if names and choice < 5:
            data = data.replace(rng.choice(names), b'"' + rng.choice(PICTURES).encode() + b'"', rng.choice([1, -1]))
        else:
            data = (mutate_bytes if path.suffix == ".png" else mutate_text)(data, rng, data)
        path.write_bytes(data)


def results(rng, folder, options):
    """`report --merge` and `--compare` of folders somebody else made, into what may be there already."""
    parts = ["a", "b"][:rng.choice([1, 2, 2])]
    shown = [[part for part in ("Strokes", "Rim") if rng.random() < 0.8] for _ in parts]
    for part, techniques in zip(parts, shown):
        write_results(folder / part, techniques)
    if rng.random() < 0.2:
        write_results(folder / "out", shown[0])
        parts_and_output = [*parts, "out"]
    else:
        parts_and_output = parts
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        tampered = folder / rng.choice(parts_and_output)
        if tampered.is_dir():
            tamper(tampered, rng)
    if rng.random() < 0.1:
        replace(folder / "out", rng)
    if rng.random() < 0.2:
        return ["report", "--compare", parts[0], parts[-1]]
    return ["report", "--merge", *parts, "-o", rng.choice(["out"] * 8 + ["out/below", parts[0]])]


RESUME = ["report", "s.scene.yaml", "--quick", "--technique", "Rim", "-o", "out"]


def resumed(rng, folder, options):
    """A run of `report` that goes on in the folder of a whole one, which was tampered with."""
    shutil.copytree(options.genuine, folder / "out")
    for _ in range(rng.choice([1, 1, 2])):
        if (folder / "out").is_dir():
            tamper(folder / "out", rng)
    return RESUME


# ---------------------------------------------------------------- modules of features

@functools.lru_cache(maxsize=None)
def modules():
    """Libraries, none of which limn can use, so that no changed code of theirs runs."""
    sources = [ROOT / "tests/plugins/no_plugin.c", ROOT / "tests/plugins/old_plugin.c"]
    found = []
    with tempfile.TemporaryDirectory() as name:
        for source in sources:
            for flags in (["-shared", "-fPIC"], ["-c"]):
                output = pathlib.Path(name) / "module"
                subprocess.run(["cc", *flags, str(source), "-o", str(output)], check=True)
                found.append(output.read_bytes())
    return found


def plugin(rng, folder, options):
    library = rng.choice(modules())
    choice = rng.randrange(8)
    path = folder / "x.so"
    if choice == 0:
        path.write_bytes(mutate_text(rng.choice([b"no library\n", png(), b"!<arch>\n", b"\x7fELF", b"#!/bin/sh\nid\n"]),
                                     rng, library))
    elif choice < 3:
        path.write_bytes(library[:rng.choice([rng.randrange(len(library)), rng.randrange(200)])])
    elif choice == 3:
        path.write_bytes(library[:4] + rng.randbytes(12) + library[16:])  # class, byte order, system
    elif choice == 4:
        at = rng.choice([16, 18, 20, 32, 40, 52, 54, 56, 58, 60, 62])  # kind, machine, where its tables are
        path.write_bytes(library[:at] + rng.choice([b"\0\0", b"\xff\xff", b"\1\0", b"\0\x10"]) + library[at + 2:])
    elif choice == 5:
        path.write_bytes(library)
    else:
        replace(path, rng)
    if rng.random() < 0.05 and path.is_file() and not path.is_symlink():
        os.truncate(path, rng.choice([1 << 29, (1 << 29) + 1, 1 << 40]))
    if rng.random() < 0.4:
        scene = folder / "s.scene.yaml"
        scene.write_text(scene.read_text() + "plugins: [x.so]\n")
        return ["inspect", "s.scene.yaml"]
    name = rng.choice(["x.so", "./x.so", str(path), "x.so/", "../project/x.so"])
    return rng.choice([["inspect", "s.scene.yaml", "--plugin", name], ["schema", "scene", f"--plugin={name}"],
                       ["set", "p.profile.yaml", *SET, "--plugin", name],
                       ["explain", "s.scene.yaml", "--plugin", name, "--plugin", name]])


# ---------------------------------------------------------------- arguments

VERBS = ["render", "inspect", "explain", "report", "set", "schema", "shader", "new", "port", "doctor", "completion",
         "complete", "help", "version"]  # `watch` never ends
PATHS = ["s.scene.yaml", "unity.scene.yaml", "p.profile.yaml", "own.shader", "own.cs", "own.compute", "t.png", "m.gltf",
         "u.asset", "a", "b", ".", "..", "nope", "nope/nope", "out", "out.png", "out/out.png", "out.json", "./out.png",
         "p.profile.yaml/x", "/dev/null", "/dev/full", "-", "Assets", RENDERER, "x" * 300, "x" * 5000, "a.svg", "a.dot"]
WORDS = ["feature", "scene", "profile", "material", "DepthFog", "bash", "zsh", "fish", "spirv", "hlsl", "software",
         "urp14", "unity6", "auto", "always", "never", "Red", "1/2", "2/1", "0/0", "16x9", "16384x16384", "0x0", "1x",
         "99999x1", "Piece", "3,4", "_EXTRA", "A,B,", "ScreenSpaceOutline.outlineWidth=4", "Outline.m_LayerMask=6",
         "Nope.x=1", "=", "a=", "=b", "a=b=c", "com.unity.render-pipelines.core=.", "core=nope", *SET]
ODD = ["", " ", "-", "--", "---", "-=", "--=", "--=x", "-x", "-oo", "-o=", "--output", "--output=", "--no-such",
       "--h", "--he", "-hV", "-qv", "-vq", "--quiet=1", "--version=2", "\xff\xfe", "\u202e", "\u00e9\u0301", "\n",
       "a\nb", "\t", "\x1b[31m", "\x07", "%s%n%d", "$(id)", "~", "*", "'", '"', "\\", "@own.cs", "/", "/help",
       "A" * 100_000, "-" + "A" * 3000, "--" + "A" * 3000, "--set=" + "A" * 3000, "[1,2]", "{}", "[", "]", "%%", "++"]


@functools.lru_cache(maxsize=None)
def flags_of(limn, verb):
    text = subprocess.run([limn, "help", verb], capture_output=True, text=True, check=True).stdout
    return re.findall(r"(?<![\w-])-{1,2}[A-Za-z][\w-]*", text)


def arguments(rng, folder, options):
    """Words in any order. A report measures nothing: that takes a minute."""
    write_results(folder / "a", ["Strokes"])
    write_results(folder / "b", ["Rim"])
    verb = rng.choice(VERBS)

    def value():
        return rng.choice(rng.choice([PATHS, PATHS, WORDS, WORDS, NUMBERS, ODD, TEXTS]))
    words = []
    for _ in range(rng.choice([0, 1, 2, 3, 4, 5, 8, 12, 200 if rng.random() < 0.1 else 6])):
        flag = rng.choice(flags_of(options.limn, rng.choice([verb] * 9 + VERBS)))
        words += rng.choice([[flag, value()], [flag + "=" + value()], [flag], [value()], [value()],
                             [flag[:rng.randrange(1, len(flag) + 1)], value()], [flag + value()]])
    words.insert(0 if rng.random() < 0.9 else rng.randrange(len(words) + 1), verb)
    if rng.random() < 0.05:
        words.insert(0, rng.choice(ODD + TEXTS))
    if "report" in words:
        words.insert(rng.randrange(words.index("report") + 1, len(words) + 1), rng.choice(["--merge", "--compare"]))
        words = [word for word in words if word != "--"]  # behind which the flag would be a name
    return [word.encode("utf-8", "surrogateescape").replace(b"\0", b"") if word != "\xff\xfe" else b"\xff\xfe"
            for word in words if word != "watch"]


# ---------------------------------------------------------------- all of them

# kind: (share of all inputs, what writes one)
KINDS = {kind: (entry[0], functools.partial(mutated_file, kind)) for kind, entry in FILES.items()}
KINDS |= {"results": (14, results), "resumed": (1, resumed), "plug-in": (6, plugin), "arguments": (20, arguments)}
