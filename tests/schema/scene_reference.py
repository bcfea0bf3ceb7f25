#!/usr/bin/env python3
"""Makes samples/guide/scene_reference.md from `limn schema scene`, and says whether the page is that.

usage: scene_reference.py LIMN SOURCE_DIR      (LIMN_UPDATE_GOLDEN=1 writes the page)
"""
import json
import os
import pathlib
import subprocess
import sys

HEAD = """# Scene files

This page is made from `limn schema scene`, which an editor completes keys by; a test compares both. A scene file (`*.scene.yaml`) is YAML.
[first_scene.md](first_scene.md) begins with one. A key that is not in these tables is an error, and so is a number outside its range.

- **colour**: `"#ff8020"`, `"#ff8020c0"` with alpha, `[1, 0.5, 0.1]` or `{r: 1, g: 0.5, b: 0.1}`; sRGB.
- **two, three, four numbers**: `[0, 1, -4]` or `{x: 0, y: 1, z: -4}`.
- **layer**: a name or an index; **layers**: one of these, a list of them, `Everything` or `Nothing`.
- **event**: when in the frame a pass is drawn, for example `AfterRenderingOpaques` or `AfterRenderingOpaques + 1`.
- **texture**: the path of a picture, or the name of one of the shaders' own, such as `white`.

Keys with `m_` may also be written without it: `m_LayerMask` and `layerMask` are the same.
"""


def number(value):
    return f"{value:g}" if abs(value) < 1e6 else f"{value:.10g}"


def range_of(schema):
    if "minimum" not in schema:
        return ""
    # Far limits only keep numbers finite; they are no news to a reader.
    low, high = schema["minimum"], schema.get("maximum", 1e9)
    return "" if low <= -1e9 and high >= 1e9 else (
        f" from {number(low)}" if high >= 1e9 else f" from {number(low)} to {number(high)}")


def value_of(schema):
    """What may stand behind a key, in words."""
    if "$ref" in schema:
        return "map, see [objects](#objects)"
    if "const" in schema:
        return f"`{schema['const']}`"
    if "enum" in schema:
        return "event" if "BeforeRenderingPrePasses" in schema["enum"] else " or ".join(f"`{name}`" for name in schema["enum"])
    if "anyOf" in schema:
        parts = schema["anyOf"]
        text = json.dumps(parts)
        vector = next((part for part in parts if part.get("type") == "array" and "minItems" in part), None)
        if "m_Bits" in text:
            return "layers"
        if parts[0] == {"type": "integer", "minimum": 0, "maximum": 31}:
            return "layer"
        if "BeforeRenderingPrePasses" in text:
            return "event"
        if '"r"' in text:
            return "colour"
        if vector and vector["items"].get("type") == "number":
            words = {2: "two", 3: "three", 4: "four"}[vector["minItems"]] + " numbers"
            return words + range_of(vector["items"]) + (
                " or one" if any(part.get("type") == "number" for part in parts) else "")
        if parts[0] == {"type": "boolean"}:
            return "`true` or `false`"
        # A number is what Unity's files have for a name; a text is a path or a name of the file's own.
        named = [value_of(part) for part in parts if "enum" in part]
        named += ["text" for part in parts if part.get("type") == "string"]
        named += ["a list of them" for part in parts if "enum" in part.get("items", {})]
        return " or ".join(named) or value_of(parts[0])
    kind = schema.get("type")
    if kind == "array":
        items = schema["items"]
        if schema.get("maxItems") == schema.get("minItems") == 2:
            return "two integers" + range_of(items)
        return "list of maps" if "properties" in items or "allOf" in items or "$ref" in items else "list of texts"
    if kind == "object" or isinstance(kind, list) and "object" in kind:
        return "map or text" if "string" in kind else "map"
    if isinstance(kind, list):
        return "text"
    return {"string": "text", "boolean": "`true` or `false`"}.get(kind, kind) + range_of(schema)


def default_of(schema):
    if "default" not in schema:
        return ""
    value = schema["default"]
    if value_of(schema) == "layers":
        value = {0: "Nothing", 0xFFFFFFFF: "Everything"}.get(value, value)
    text = value if isinstance(value, str) else json.dumps(value)
    return f" Default: `{text or 'nothing'}`."


def table(schema):
    rows = ["| key | value | what it is |", "| --- | --- | --- |"]
    properties = schema["properties"]
    for key, value in properties.items():
        if "m_" + key[:1].upper() + key[1:] in properties:
            continue  # the plain spelling
        needed = " **Needed.**" if key in schema.get("required", []) else ""
        rows.append(f"| `{key}` | {value_of(value)} | {value['description']}.{needed}{default_of(value)} |")
    return "\n".join(rows) + "\n"


def section(title, schema, depth=2, said=""):
    return f"\n{'#' * depth} {title}\n\n" + (said + "\n\n" if said else "") + table(schema)


def groups_of(title, schema):
    """Tables of the maps within a map."""
    text = ""
    for key, value in schema["properties"].items():
        if value.get("type") == "object" and "properties" in value and not (
                "m_" + key[:1].upper() + key[1:] in schema["properties"]):
            text += section(f"{title}.{key}", value, 3) + groups_of(f"{title}.{key}", value)
    return text


def page(schema):
    keys = schema["properties"]
    text = HEAD + section("The file", schema)
    text += section("camera", keys["camera"])
    text += section("camera.cameraStack", keys["camera"]["properties"]["cameraStack"]["items"])
    for name in ("light", "shadows", "renderSettings"):
        text += section(name, keys[name])
    text += section("lights", keys["lights"]["items"])
    volume = keys["volumes"]["items"]
    text += section("volumes", volume)
    for shape in volume["properties"]["colliders"]["items"]["allOf"]:
        name = shape["if"]["properties"]["type"]["const"]
        text += section(f"volumes.colliders, {name}", shape["then"], 3)
    material = keys["materials"]["additionalProperties"]
    said = "Any other key is a property of the shader: a number, a colour, four numbers or a texture."
    if "else" in material:  # a map, or the path of a file with one
        said += " In place of the map a `.material.yaml` file may stand, by its path."
        material = material["else"]
    text += section("materials", material, said=said)
    text += section("objects", schema["$defs"]["object"])
    text += section("renderer", keys["renderer"])
    for feature in keys["renderer"]["properties"]["features"]["items"]["allOf"]:
        name = feature["if"]["properties"]["type"]["const"]
        text += section(name, feature["then"], 3) + groups_of(name, feature["then"])
    return text


def main():
    limn, source = sys.argv[1], pathlib.Path(sys.argv[2])
    schema = json.loads(subprocess.run([limn, "schema", "scene"], check=True, stdout=subprocess.PIPE).stdout)
    path = source / "samples/guide/scene_reference.md"
    text = page(schema)
    if path.exists() and path.read_text() == text:
        print(f"{path.name}: as the schema")
        return
    if os.environ.get("LIMN_UPDATE_GOLDEN"):
        path.write_text(text)
    sys.exit(f"{path} is not what the schema says; LIMN_UPDATE_GOLDEN=1 writes it")


if __name__ == "__main__":
    main()
