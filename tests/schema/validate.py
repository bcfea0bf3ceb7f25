#!/usr/bin/env python3
"""Holds the schemas of `limn schema` against the sample files and against broken ones.

usage: validate.py LIMN SOURCE_DIR PLUGIN

PLUGIN is that of the samples which have features of their own.
"""
import json
import pathlib
import subprocess
import sys

import jsonschema
import yaml

GOOD = {
    "profile": [
        "ScreenSpaceOutline: {outlineWidth: 1, m_OutlineColor: '#12aBcd', enable: 1}",
        "ScreenSpaceOutline: {m_OutlineColor: [1, 0.5, 0], active: false}",
        "ScreenSpaceOutline:",
        "{}",
    ],
    "material": [
        "{shader: x.shader, renderQueue: 3000, _Width: 2, _Tint: '#12aBcd', _Map: wood.png}",
        "_Other: [1, 0, 0]\n_Offset: {x: 1, y: 2, z: 3, w: 4}\n_Bump: bump",
        "{_Sky: {faces: [a.png, b.png, c.png, d.png, e.png, f.png]}, _Fog: {slices: [a.png]}}",
        "shader: Universal Render Pipeline/Lit",
        "{renderQueue: -1, _Map: green}",
        "{}",
    ],
    "scene": [
        "camera: {}",
        "camera:",
        "{camera: {cullingMask: Furniture, volumeLayerMask: Everything}}",
        "{camera: {cullingMask: {m_Bits: 64}, volumeLayerMask: 4294967295}}",
        "{camera: {cullingMask: [Default, 3]}, objects: [{name: A, mesh: cube, scale: 2}]}",
        "{camera: {}, renderer: {rendererData: a.asset}}",
        "{camera: {}, renderer: a.asset}",
        "{camera: {}, renderer: {features: [{type: ScreenSpaceOutlineRenderFeature, "
        "renderPassEvent: AfterRenderingOpaques + 1, layerMask: Everything}]}}",
        "{camera: {}, volumes: [{profile: a.yaml, colliders: [{size: [1, 2, 3]}, "
        "{type: sphere, radius: 2, center: [0, 1, 0]}, {type: mesh, mesh: a.glb, enabled: false}, "
        "{type: capsule, radius: 1, height: 3, direction: y}]}]}",
        "{camera: {}, materials: {a: {shader: x.shader, renderQueue: 3000, _Width: 2, "
        "_Tint: '#12aBcd', _Other: [1, 0, 0], _Offset: {x: 1, y: 2, z: 3, w: 4}, "
        "_Map: wood.png, _Bump: bump}, b: , oak: oak.material.yaml}}",
    ],
}
# What is broken, and the path at which a validator has to say so.
BROKEN = {
    "profile": [
        ("ScreenSpaceOutline: {outlineWidth: 14}", "ScreenSpaceOutline/outlineWidth"),
        ("ScreenSpaceOutline: {m_OutlineWidth: 0.5}", "ScreenSpaceOutline/m_OutlineWidth"),
        ("ScreenSpaceOutline: {outlineWidth: wide}", "ScreenSpaceOutline/outlineWidth"),
        ("ScreenSpaceOutline: {outlineColor: '#12'}", "ScreenSpaceOutline/outlineColor"),
        ("ScreenSpaceOutline: {outlineColor: [1, 2]}", "ScreenSpaceOutline/outlineColor"),
        ("ScreenSpaceOutline: {enable: maybe}", "ScreenSpaceOutline/enable"),
        ("ScreenSpaceOutline: {outlneWidth: 4}", "ScreenSpaceOutline"),
        ("ScreenSpaceOutline: {outlineWidth: 4, m_OutlineWidth: 4}", "ScreenSpaceOutline"),
        ("ScreenSpaceOutlin: {}", ""),
        ("[]", ""),
    ],
    "material": [
        ("renderQueue: 5001", "renderQueue"),
        ("renderQueue: 0.5", "renderQueue"),
        ("shader: [x.shader]", "shader"),
        ("_Tint: '#12'", "_Tint"),
        ("_Tint: [1, 2]", "_Tint"),
        ("_Offset: {x: 1, y: 2, z: 3}", "_Offset"),
        ("_Map: wood.bmp", "_Map"),
        ("_Sky: {faces: [a.png, b.png]}", "_Sky"),
        ("_Sky: {faces: [a.png], slices: [a.png]}", "_Sky"),
        ("_Fog: {slices: [a.bmp]}", "_Fog"),
        ("_Fog: {slices: []}", "_Fog"),
        ("_On: true", "_On"),
        ("[]", ""),
        ("text", ""),
    ],
    "scene": [
        ("{}", ""),
        ("{camera: {}, objcts: []}", ""),
        ("camera: {fieldOfView: 200}", "camera/fieldOfView"),
        ("camera: {position: [1, 2]}", "camera/position"),
        ("camera: {clearFlags: Sky}", "camera/clearFlags"),
        ("camera: {cullingMask: -1}", "camera/cullingMask"),
        ("camera: {cullingMask: [32]}", "camera/cullingMask"),
        ("{camera: {}, size: [0, 720]}", "size/0"),
        ("{camera: {}, layers: {32: A}}", "layers"),
        ("{camera: {}, objects: [{mesh: cube}]}", "objects/0"),
        ("{camera: {}, objects: [{name: A, children: [{name: B, colour: 1}]}]}",
         "objects/0/children/0"),
        ("{camera: {}, volumes: [{isGlobal: true}]}", "volumes/0"),
        ("{camera: {}, volumes: [{profile: a, weight: 2}]}", "volumes/0/weight"),
        ("{camera: {}, volumes: [{profile: a, colliders: [{radius: 1}]}]}",
         "volumes/0/colliders/0"),
        ("{camera: {}, volumes: [{profile: a, colliders: [{type: sphere, size: [1, 1, 1]}]}]}",
         "volumes/0/colliders/0"),
        ("{camera: {}, volumes: [{profile: a, colliders: [{type: capsule, direction: w}]}]}",
         "volumes/0/colliders/0/direction"),
        ("{camera: {}, volumes: [{profile: a, colliders: [{type: mesh}]}]}",
         "volumes/0/colliders/0"),
        ("{camera: {}, volumes: [{profile: a, colliders: [{type: cone}]}]}",
         "volumes/0/colliders/0/type"),
        ("{camera: {}, materials: {a: {_Tint: '#12'}}}", "materials/a/_Tint"),
        ("{camera: {}, materials: {a: {_Tint: [1, 2]}}}", "materials/a/_Tint"),
        ("{camera: {}, materials: {a: {_Map: wood.bmp}}}", "materials/a/_Map"),
        ("{camera: {}, materials: {a: {_Map: {path: wood.png}}}}", "materials/a/_Map"),
        ("{camera: {}, materials: {a: {_On: true}}}", "materials/a/_On"),
        ("{camera: {}, materials: {a: {renderQueue: 6000}}}", "materials/a/renderQueue"),
        ("{camera: {}, renderer: {features: [{type: Outline}]}}", "renderer/features/0/type"),
        ("{camera: {}, renderer: {features: [{type: ScreenSpaceOutlineRenderFeature, "
         "renderingLayerMask: 32}]}}", "renderer/features/0/renderingLayerMask"),
        ("{camera: {}, renderer: {features: [{type: ScreenSpaceOutlineRenderFeature, "
         "m_Layermask: 1}]}}", "renderer/features/0"),
    ],
}


def load(text):
    """YAML as a JSON validator sees it: every key is text."""
    return json.loads(json.dumps(yaml.safe_load(text)))


def paths(validator, text):
    return ["/".join(map(str, error.absolute_path)) for error in validator.iter_errors(load(text))]


def main(limn, source, plugin):
    failures = []
    for kind in ("profile", "scene", "material"):
        schema = json.loads(subprocess.check_output([limn, "schema", kind, "--plugin", plugin]))
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        samples = sorted(pathlib.Path(source, "samples").rglob(f"*.{kind}.yaml"))
        if not samples and kind != "material":  # the samples' scenes hold their materials
            failures.append(f"no sample of a {kind} found below {source}/samples")
        for sample in samples:
            for error in validator.iter_errors(load(sample.read_text())):
                failures.append(f"{sample}: {error.json_path}: {error.message}")
        for text in GOOD[kind]:
            if found := paths(validator, text):
                failures.append(f"{kind} '{text}' is good but refused at {found}")
        for text, path in BROKEN[kind]:
            found = paths(validator, text)
            if path not in found:
                failures.append(f"{kind} '{text}' is refused at {found}, not at '{path}'")
    print("\n".join(failures) or "every sample passes, every broken file is refused")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
