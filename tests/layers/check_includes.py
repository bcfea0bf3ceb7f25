#!/usr/bin/env python3
"""Fails where a layer includes one above it (or beside it), or a library that only another one may use.

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
    "shaderlab": [],
    "core/vulkan": ["core", "shaderlab"],
    "core": ["shaderlab"],
    "volume": ["core", "shaderlab"],
    "features": ["volume", "core", "shaderlab"],
    "editor_stub": ["features", "core/vulkan", "volume", "core", "shaderlab"],
    "samples": ["editor_stub", "features", "core/vulkan", "volume", "core", "shaderlab"],
}
# <limn/...> headers by the folder behind limn/; limn/limn.h is the features'.
LAYER_OF_HEADERS = {"vulkan": "core/vulkan", "limn.h": "features"}
# Libraries that stay inside the layers named; any other may include what its target links.
LIBRARIES = {
    "vulkan/": ["core/vulkan"],
    "glslang/": ["shaderlab"],
    "SPIRV/": ["shaderlab"],
    "spirv-tools/": ["shaderlab"],
    "spirv_cross/": ["shaderlab", "editor_stub"],
    "yaml-cpp/": ["volume"],
}
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
    for library, layers in LIBRARIES.items():
        if name.startswith(library) and layer not in layers:
            return f"only {' and '.join(layers)} may include {library.rstrip('/')}"
    return None


def check(root):
    """How many includes there are, and 'file:line: what is wrong' for the bad ones."""
    count, problems = 0, []
    for layer in ["shaderlab", "core", "volume", "features", "editor_stub", "samples"]:
        files = sorted(p for p in (root / layer).rglob("*") if p.suffix in (".h", ".cpp", ".hpp", ".inl"))
        for file in files:
            text = RAW_STRING.sub(lambda match: "\n" * match[0].count("\n"), file.read_text(encoding="utf-8"))
            for match in INCLUDE.finditer(text):
                count += 1
                path = file.relative_to(root)
                reason = why_not(root, file, layer_of(path), match[1], match[2])
                if reason:
                    line = text.count("\n", 0, match.start(2)) + 1
                    problems.append(f"{path.as_posix()}:{line}: {match[2]}: {reason}")
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
        ("core/src/deep/K.cpp", '"Own.h"', False),
        ("features/glow/src/L.cpp", '"Glow.h"', False),
        ("core/vulkan/src/M.cpp", "<vulkan/vulkan.h>", False),
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
