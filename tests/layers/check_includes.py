#!/usr/bin/env python3
"""Fails where a layer includes one above it (or beside it), where two folders of one layer include each other, also by
way of others, and where a library or a header of the operating system is included by a layer that may not.

Usage: check_includes.py ROOT_OF_LIMN. Before it looks at the tree it looks at made-up ones, so that a check that
finds nothing can be believed.
"""
import re
import sys
import tempfile
from pathlib import Path

# Each layer and what it may include besides itself. core/vulkan stands beside core; nobody but editor_stub and samples
# sees it.
LAYERS = {
    "shaderlab/base": [],
    "shaderlab": ["shaderlab/base"],
    "core/vulkan": ["core", "shaderlab", "shaderlab/base"],
    "core": ["shaderlab", "shaderlab/base"],
    "volume": ["core", "shaderlab", "shaderlab/base"],
    "features": ["volume", "core", "shaderlab", "shaderlab/base"],
    "editor_stub": ["features", "core/vulkan", "volume", "core", "shaderlab", "shaderlab/base"],
    "samples": ["editor_stub", "features", "core/vulkan", "volume", "core", "shaderlab", "shaderlab/base"],
}
# <limn/...> headers by the folder behind limn/; limn/limn.h is the features'.
LAYER_OF_HEADERS = {"vulkan": "core/vulkan", "limn.h": "features", "limn_fwd.h": "features", "testing.h": "features", "base": "shaderlab/base"}
# Libraries that stay inside the layers named; any other may include what its target links.
LIBRARIES = {
    "vulkan/": ["core/vulkan"],
    "glslang/": ["shaderlab"],
    "SPIRV/": ["shaderlab"],
    "spirv-tools/": ["shaderlab"],
    "spirv_cross/": ["shaderlab", "editor_stub"],
    "spirv_cross/spirv.hpp": ["core/vulkan"],  # nothing but the numbers of SPIR-V
    "yaml-cpp/": ["volume"],
}
# What knows the operating system lies in these folders; its headers may be included there alone.
PLATFORM = ["shaderlab/base/src/platform"]
SYSTEM_HEADERS = re.compile(
    r"(sys|linux|arpa|netinet)/.*|(unistd|fcntl|poll|spawn|dlfcn|link|pthread|signal|termios|dirent|pwd|windows)\.h")
RAW_STRING = re.compile(r'R"([^\s()]*)\(.*?\)\1"', re.DOTALL)  # HLSL text has includes of its own
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)


def layer_of(path):
    """The layer of a file by its path below the root; None for tests and build files."""
    return next((layer for layer in LAYERS if path.as_posix().startswith(layer + "/")), None)


def own_header(root, file, layer, name):
    """Whether an include in quotes names a header of the file's own layer."""
    places = [file.parent] + [root / folder / "src" for folder in [layer, *folders_of(root, layer)]]
    found = next((place / name for place in places if (place / name).is_file()), None)
    return found is not None and layer_of(found.resolve().relative_to(root.resolve())) == layer


def folders_of(root, layer):
    """features has one folder a feature, each with its src."""
    return [f"{layer}/{folder.name}" for folder in sorted((root / layer).iterdir()) if (folder / "src").is_dir()]


def why_not(root, file, layer, quote, name):
    """What is wrong with an include; None if it is fine."""
    if quote == '"':
        return None if own_header(root, file, layer, name) else f"is no header of {layer} itself"
    if name.startswith("limn/"):
        first = name.split("/")[1]
        target = LAYER_OF_HEADERS.get(first, first)
        return None if target == layer or target in LAYERS[layer] else f"{layer} may not include {target}"
    if SYSTEM_HEADERS.fullmatch(name) and not any(root / folder in file.parents for folder in PLATFORM):
        return f"only {' and '.join(PLATFORM)} may include headers of the operating system"
    library = max((one for one in LIBRARIES if name.startswith(one)), key=len, default=None)
    if library and layer not in LIBRARIES[library]:
        return f"only {' and '.join(LIBRARIES[library])} may include {library.rstrip('/')}"
    return None


def circles(edges):
    """Returns the sets of folders that include each other, each sorted, by Tarjan's algorithm."""
    index, low, stack, found = {}, {}, [], []

    def visit(folder):
        index[folder] = low[folder] = len(index)
        stack.append(folder)
        for other in edges.get(folder, ()):
            if other not in index:
                visit(other)
                low[folder] = min(low[folder], low[other])
            elif other in stack:
                low[folder] = min(low[folder], index[other])
        if low[folder] == index[folder]:
            circle = stack[stack.index(folder) :]
            del stack[stack.index(folder) :]
            if len(circle) > 1:
                found.append(sorted(circle))

    for folder in sorted(edges):
        if folder not in index:
            visit(folder)
    return found


def circle_problems(root, layer, edges):
    """What is wrong with the folders of a layer; edges: {folder: {other folder: an include, 'file:line: name'}}."""
    problems = []
    for circle in circles(edges):
        for folder in circle:
            for other in sorted(set(edges[folder]) & set(circle)):
                problems.append(f"{edges[folder][other]}: {layer}/src/{other} includes {folder}, directly or by way of others")
    return problems


def check(root):
    """How many includes there are, and 'file:line: what is wrong' for the bad ones."""
    count, problems = 0, []
    folders = {}  # {layer: {folder: {other: include}}}
    for layer in ["shaderlab", "core", "volume", "features", "editor_stub", "samples"]:
        files = sorted(p for p in (root / layer).rglob("*") if p.suffix in (".h", ".cpp", ".hpp", ".inl"))
        for file in files:
            text = RAW_STRING.sub(lambda match: "\n" * match[0].count("\n"), file.read_text(encoding="utf-8"))
            for match in INCLUDE.finditer(text):
                count += 1
                path = file.relative_to(root)
                line = text.count("\n", 0, match.start(2)) + 1
                place = f"{path.as_posix()}:{line}: {match[2]}"
                reason = why_not(root, file, layer_of(path), match[1], match[2])
                if reason:
                    problems.append(f"{place}: {reason}")
                source = root / layer_of(path) / "src"
                if match[1] == '"' and (source / match[2]).is_file() and source in file.parents:
                    folder, other = file.parent.relative_to(source), Path(match[2]).parent
                    if folder != other:
                        edges = folders.setdefault(layer_of(path), {}).setdefault(folder.as_posix(), {})
                        edges.setdefault(other.as_posix(), place)
    for layer, edges in folders.items():
        problems += circle_problems(root, layer, edges)
    return count, problems


def self_check():
    """Made-up files, each with one include, and whether it must be refused."""
    cases = [
        ("shaderlab/src/a/A.cpp", "<limn/core/Mesh.h>", True),
        ("core/include/limn/core/B.h", "<limn/volume/Volume.h>", True),
        ("core/src/C.cpp", "<limn/vulkan/VulkanDevice.h>", True),
        ("core/src/D.cpp", "<vulkan/vulkan.h>", True),
        ("core/vulkan/src/E.cpp", "<limn/volume/Volume.h>", True),
        ("volume/src/F.cpp", "<limn/limn.h>", True),
        ("features/glow/src/G.cpp", "<limn/editor_stub/RunLimn.h>", True),
        ("volume/src/H.cpp", '"../../core/src/Own.h"', True),
        ("core/src/deep/I.cpp", '"E2.h"', True),
        ("editor_stub/src/J.cpp", "<yaml-cpp/yaml.h>", True),
        ("core/src/a/Q.h", '"b/R.h"', True),  # a, b and c go round in a circle
        ("core/src/b/R.h", '"c/S.h"', True),
        ("core/src/c/S.h", '"a/Q.h"', True),
        ("core/src/deep/K.cpp", '"Own.h"', False),
        ("core/src/deep/T.cpp", '"a/Q.h"', False),
        ("features/glow/src/L.cpp", '"Glow.h"', False),
        ("core/vulkan/src/M.cpp", "<vulkan/vulkan.h>", False),
        ("editor_stub/src/U.cpp", "<sys/stat.h>", True),
        ("core/src/V.cpp", "<unistd.h>", True),
        ("shaderlab/base/src/platform/posix/W.cpp", "<unistd.h>", False),
        ("editor_stub/src/N.cpp", "<limn/vulkan/VulkanDevice.h>", False),
        ("volume/src/O.cpp", "<limn/core/Mesh.h>", False),
        ("samples/hello/P.cpp", "<limn/limn.h>", False),
    ]
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name in ["core/src/Own.h", "core/vulkan/src/E2.h", "features/glow/src/Glow.h"]:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text("// nothing\n", encoding="utf-8")
        for name, include, _ in cases:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            text = f'auto hlsl = R"(\n#include "A.hlsl"\n)";\n#  include {include}\n'
            (root / name).write_text(text, encoding="utf-8")
        found = {problem.split(":")[0] for problem in check(root)[1]}
    expected = {name for name, _, refused in cases if refused}
    if found != expected:
        sys.exit(f"the check itself is wrong: missed {sorted(expected - found)}, refused {sorted(found - expected)}")


def main():
    self_check()
    count, problems = check(Path(sys.argv[1]))
    if count < 1000:
        sys.exit(f"only {count} includes found below {sys.argv[1]}; is that limn?")
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"{count} includes, {len(problems)} against the layers")
    sys.exit(1 if problems else 0)


main()
