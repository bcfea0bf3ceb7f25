"""Inputs made by hand, each of which once ended limn, or ended it badly, with the answer it should get."""

from project import GLTF, SCENE, SHADER, UNITY_FILE, UNITY_SCENE, glb


def chain(count, scenes=', "scenes": [{"nodes": [0]}]'):
    nodes = "".join('{"children": [%d]}, ' % i for i in range(1, count)) + '{"mesh": 0}'
    head = GLTF[:GLTF.index('"nodes"')].replace("BUFFER", '"uri": "m.bin", ')
    return head + '"nodes": [' + nodes + "]" + scenes + "}"


def deep(opening, closing, depth=100_000, inner="0", json=GLTF.replace("BUFFER", '"uri": "m.bin", ')):
    return json.rstrip()[:-1] + ', "extras": ' + opening * depth + inner + closing * depth + "}"


def transforms(count):
    return UNITY_FILE + "".join(f"--- !u!4 &{i + 1000}{' stripped' if i % 7 == 0 else ''}\nTransform:\n"
                                f"  m_LocalPosition: {{x: {i}, y: 0, z: -0}}\n" for i in range(count))


def feature(members):
    return "class F : ScriptableRendererFeature\n{\n" + members + "}\n"


SET = ["ScreenSpaceOutline.outlineWidth=4"]
PLACE = r":\d+:\d+: error: "
TOO_DEEP = "lists and objects are nested more than 64 levels deep"
NO_OBJECT = "this document is no Unity object"
# (what, file, content, command, exit code, a regular expression that stdout or stderr matches)
HOSTILE = [
    ("nothing", "s.scene.yaml", lambda: SCENE, ["inspect", "s.scene.yaml"], 0, "Outline"),
    ("nothing, in Unity's files", "unity.scene.yaml", lambda: UNITY_SCENE, ["inspect", "unity.scene.yaml"], 0,
     "Outline"),
    ("nothing, in a shader", "own.shader", lambda: SHADER, ["shader", "own.shader"], 0, "_Factor"),
    ("a chain of 20 000 nodes", "m.gltf", lambda: chain(20_000), ["inspect", "s.scene.yaml"], 0, "Outline"),
    ("such a chain without a scene", "m.gltf", lambda: chain(20_000, ""), ["inspect", "s.scene.yaml"], 0,
     "Outline"),
    ("a ring of nodes", "m.gltf", lambda: chain(3).replace('{"mesh": 0}]', '{"children": [0]}]'),
     ["inspect", "s.scene.yaml"], 1, "node 0: it does not exist or has two parents"),
    ("lists nested 100 000 deep", "m.gltf", lambda: deep("[", "]"), ["inspect", "s.scene.yaml"], 1,
     PLACE + TOO_DEEP),
    ("objects nested 100 000 deep", "m.gltf", lambda: deep('{"a": ', "}"), ["inspect", "s.scene.yaml"], 1,
     PLACE + TOO_DEEP),
    ("lists that never end", "m.gltf", lambda: deep("[", "", inner=""), ["inspect", "s.scene.yaml"], 1,
     PLACE + TOO_DEEP),
    ("lists nested 100 000 deep, binary", "m.glb",
     lambda: glb(deep("[", "]", json=GLTF.replace("BUFFER", ""))), ["inspect", "s.scene.yaml"], 1,
     "m.glb: error: " + TOO_DEEP),
    ("a number beyond a double", "m.gltf", lambda: deep("", "", inner="1e400"), ["inspect", "s.scene.yaml"], 1,
     "m.gltf: error: the file is not glTF 2.0: number overflow parsing '1e400'"),
    ("a Unity scene", "u.asset", lambda: UNITY_FILE, ["inspect", "u.asset"], 0, "ScreenSpaceOutline"),
    ("a value of a Unity scene", "u.asset", lambda: UNITY_FILE, ["set", "u.asset", *SET], 0, ""),
    ("a Unity scene of 40 000 objects", "u.asset", lambda: transforms(40_000), ["inspect", "u.asset"], 0,
     "ScreenSpaceOutline"),
    ("a Unity scene by its own name", "u.unity", lambda: UNITY_FILE, ["inspect", "u.unity"], 1,
     "u.unity: error: .*Unity"),
    ("a fileID beyond 64 bits", "u.asset", lambda: UNITY_FILE.replace("&100", "&99999999999999999999"),
     ["inspect", "u.asset"], 1, ":3:1: error: " + NO_OBJECT),
    ("a word that is not 'stripped'", "u.asset", lambda: UNITY_FILE.replace("stripped", "striped"),
     ["inspect", "u.asset"], 1, ":8:1: error: " + NO_OBJECT),
    ("two objects with one id", "u.asset", lambda: UNITY_FILE.replace("&100", "&7"), ["inspect", "u.asset"], 1,
     ":17:1: error: duplicate fileID 7"),
    ("a broken body that is asked for", "u.asset", lambda: UNITY_FILE.replace("active: 1", "active: ["),
     ["inspect", "u.asset"], 1, PLACE),
    ("a broken body that nobody asks for", "u.asset", lambda: UNITY_FILE.replace("300}", "["),
     ["inspect", "u.asset"], 0, "ScreenSpaceOutline"),
    ("an enum of 50 000 members, each from the one before", "own.cs",
     lambda: feature("enum E { M0, " + ", ".join(f"M{i} = M{i - 1} + 1" for i in range(1, 50_000)) + " }\n"),
     ["port", "own.cs", "-o", "out"], 0, r"out/F\.h"),
    ("10 000 classes, each of which needs the one before", "own.cs",
     lambda: feature("") + "class C0 { }\n" + "".join(f"class C{i} {{ public C{i - 1} c; }}\n"
                                                       for i in range(1, 10_000)),
     ["port", "own.cs", "-o", "out"], 0, r"out/F\.h"),
    ("100 000 signs before a member of an enum", "own.cs", lambda: feature("enum E { M = " + "-" * 100_000 + "1 }\n"),
     ["port", "own.cs", "-o", "out"], 0, r"out/F\.h"),
    ("a folder of results that is not there", "own.cs", lambda: "", ["report", "--merge", "nope", "-o", "out"], 1,
     "nope: error: there is no such folder"),
    ("a time that is no float", "s.scene.yaml", lambda: SCENE,
     ["render", "s.scene.yaml", "-o", "out.png", "--time", "1e39"], 2, "1e39"),
]
