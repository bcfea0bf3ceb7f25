"""A small project with a file of every kind that limn reads; all of them are good."""

import json
import pathlib
import shutil
import struct
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = """size: [16, 9]
layers: {6: Furniture}
renderingLayers: {8: Selected}
camera: {position: [0, 0.5, -4], rotation: [5, 0, 0], fieldOfView: 60, backgroundColor: "#102030"}
light: {color: [1, 0.9, 0.8], intensity: 1.5, rotation: [50, -30, 0]}
renderer:
  features:
    - type: ScreenSpaceOutlineRenderFeature
      name: Outline
      m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline
      m_LayerMask: [Furniture]
      m_RenderingLayerMask: Selected
volumes:
  - {name: All, profile: p.profile.yaml}
  - {name: Unity, profile: Assets/Scenes/SampleSceneProfile.asset, priority: 2, weight: 0.5}
materials:
  own: {shader: own.shader, _BaseMap: t.png, _Tint: "#ff8000", _Factor: 0.5}
  lit: {shader: Universal Render Pipeline/Lit, _BaseColor: [0.2, 0.4, 0.6, 1], _Smoothness: 0.3}
objects:
  - {name: Piece, mesh: m.gltf, material: own, layer: Furniture, renderingLayerMask: [Selected]}
  - {name: Knot, mesh: m.glb, material: lit, position: [1, 0, -1], turn: [0, 90, 0]}
  - name: Table
    position: [0, -1, 0]
    scale: [2, 0.1, 2]
    children:
      - {name: Cup, mesh: sphere, material: lit, rotation: [0, 45, 0], active: false}
"""
UNITY_SCENE = """size: [16, 9]
camera: {position: [0, 0, -4]}
renderer: {rendererData: Assets/Settings/UniversalRenderer.asset}
volumes: [{name: All, profile: Assets/Scenes/SampleSceneProfile.asset}]
objects: [{name: Piece, mesh: cube}]
"""
SHADER = """Shader "Test/Own"
{
    Properties
    {
        _BaseMap ("Texture", 2D) = "white" {}
        _Tint ("Tint", Color) = (1, 1, 1, 1)
        [PowerSlider(2)] _Factor ("Factor", Range(0, 1)) = 1
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry+10" }
        Pass
        {
            Name "Own"
            Tags { "LightMode" = "UniversalForward" }
            Cull Off ZTest LEqual Blend SrcAlpha OneMinusSrcAlpha
            Stencil { Ref 2 Comp Always Pass Replace }
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile _ _EXTRA
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Tint.hlsl"
            TEXTURE2D(_BaseMap);
            SAMPLER(sampler_BaseMap);
            CBUFFER_START(UnityPerMaterial)
            float4 _Tint;
            float _Factor;
            CBUFFER_END
            struct Varyings { float4 position : SV_POSITION; float2 uv : TEXCOORD0; };
            Varyings Vertex(float4 positionOS : POSITION, float2 uv : TEXCOORD0)
            {
                Varyings output;
                output.position = TransformObjectToHClip(positionOS.xyz);
                output.uv = uv;
                return output;
            }
            half4 Fragment(Varyings input) : SV_Target
            {
                half4 color = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _Tint;
            #ifdef _EXTRA
                color.rgb *= 0.5;
            #endif
                for (int i = 0; i < 3; ++i) { color.rgb += Tint(i) * _Factor; }
                return half4(color.rgb, 1.0);
            }
            ENDHLSL
        }
    }
    FallBack "Universal Render Pipeline/Unlit"
}
"""
INCLUDE = """#ifndef TINT_INCLUDED
#define TINT_INCLUDED
#define SCALE(x) ((x) * 0.25)
static const float3 k_Colors[3] = { float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1) };
half3 Tint(int index)
{
    float3x3 turn = float3x3(1, 0, 0, 0, 0, 1, 0, 1, 0);
    return (half3)mul(turn, SCALE(k_Colors[index])).xyz;
}
#endif
"""
PROFILE_FILE = """ScreenSpaceOutline:
  m_Enable: true
  m_OutlineColor: "#00A2FF"  # the article's
  m_OutlineWidth: 10
"""
UNITY_FILE = """%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!1 &100
GameObject:
  m_Component:
  - component: {fileID: 102}
  m_Name: 'Hammer: 2'
--- !u!4 &101 stripped
Transform:
  m_CorrespondingSourceObject: {fileID: -8679921383154817045, guid: 0a, type: 3}
  m_PrefabInstance: {fileID: 300}
--- !u!114 &11400000
MonoBehaviour:
  m_Name: P
  components:
  - {fileID: 7}
--- !u!114 &7
MonoBehaviour:
  m_Name: ScreenSpaceOutline
  active: 1
  m_OutlineWidth:
    m_OverrideState: 1
    m_Value: 5
"""


def png():
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes((x * 40, y * 60, 128, 255)[i] for x in range(4) for i in range(4))
                    for y in range(4))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4, 4, 8, 6, 0, 0, 0)) +
            chunk(b"gAMA", struct.pack(">I", 45455)) + chunk(b"IDAT", zlib.compress(rows)) +
            chunk(b"IEND", b""))


TRIANGLE = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0) + struct.pack("<3H", 0, 1, 2) + b"\0\0"
GLTF = """{"asset": {"version": "2.0"}, "buffers": [{BUFFER"byteLength": 44}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
    "min": [-1, -1, 0], "max": [1, 1, 0]},
    {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
"materials": [{"name": "m", "extras": {"a": [1, 2, {"b": null}]}}],
"meshes": [{"name": "shape", "primitives": [
    {"attributes": {"POSITION": 0}, "indices": 1, "mode": 4, "material": 0}]}],
"nodes": [{"children": [1, 2], "rotation": [0, 0, 0, 1]}, {"mesh": 0, "scale": [1, 2, 1]},
    {"mesh": 0, "translation": [0, 1, 0]}],
"scenes": [{"nodes": [0]}], "scene": 0}
"""


def glb(json, binary=TRIANGLE):
    json = json.encode() + b" " * (-len(json) % 4)
    chunks = (struct.pack("<I", len(json)) + b"JSON" + json +
              struct.pack("<I", len(binary)) + b"BIN\0" + binary)
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


SECRET = b"what nobody is to copy"
CSHARP = """using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

public class TintFeature : ScriptableRendererFeature
{
    public enum Mode { Off, On = 1 << 2, Both = On | 1, }
    [System.Serializable]
    public class Settings
    {
        [Header("Look"), Tooltip("Its colour.")] public Color color = new Color(1f, 0.5f, 0f, 1f);
        [Range(0f, 10f)] public float width = 3f;
        public Mode mode = Mode.On;
        public LayerMask layers = 1 << 6;
        public RenderPassEvent when = RenderPassEvent.AfterRenderingOpaques;
    }
    public Settings settings = new Settings();
    private TintPass m_Pass;

    public override void Create() => m_Pass = new TintPass(settings) { renderPassEvent = settings.when + 1 };
    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData)
    {
        if (renderingData.cameraData.cameraType != CameraType.Game) return;
        renderer.EnqueuePass(m_Pass);
    }
}
"""
MORE_CSHARP = """class TintPass : ScriptableRenderPass
{
    static readonly int k_Color = Shader.PropertyToID("_Color");
    readonly TintFeature.Settings m_Settings;
    FilteringSettings m_Filtering = new FilteringSettings(RenderQueueRange.opaque);

    public TintPass(TintFeature.Settings settings) { m_Settings = settings; }
    public override void Execute(ScriptableRenderContext context, ref RenderingData data)
    {
        CommandBuffer cmd = CommandBufferPool.Get($"Tint {m_Settings.width:0.0}");
#if UNITY_2022_3_OR_NEWER
        cmd.SetGlobalColor(k_Color, m_Settings.color);
#endif
        context.ExecuteCommandBuffer(cmd);
        CommandBufferPool.Release(cmd);
    }
}
"""
COMPUTE = """#pragma kernel Fill COUNT=8
#pragma kernel Sum
#pragma multi_compile _ _EXTRA
#include "Tint.hlsl"
RWTexture2D<float4> _Result;
RWStructuredBuffer<float> _Sums;
float4 _Size;
#ifndef COUNT
#define COUNT 4
#endif
groupshared float s_Part[COUNT];

[numthreads(COUNT, 8, 1)]
void Fill(uint3 id : SV_DispatchThreadID)
{
    _Result[id.xy] = float4(Tint(id.x % 3) * _Size.x, 1.0);
}

[numthreads(COUNT, 1, 1)]
void Sum(uint3 id : SV_DispatchThreadID, uint index : SV_GroupIndex)
{
    s_Part[index] = _Result[id.xy].r;
    GroupMemoryBarrierWithGroupSync();
    if (index == 0) { for (int i = 0; i < COUNT; ++i) { _Sums[id.x] += s_Part[i]; } }
}
"""


def write_results(folder, techniques):
    """A folder that `limn report` could have left, with the cells of some techniques."""
    names = ["Strokes", "Rim"]
    planned = [{"kind": kind, "technique": name, "subject": subject, "width": width, "size": [24, 16], "variant": ""}
               for kind, subject in (("geometry", "disc"), ("cost", "scene"), ("temporal", "needle"))
               for width in (2, 8) for name in names]
    study = {"format": 2, "scene": "s.scene.yaml", "sceneHash": "12", "device": "llvmpipe",
             "machine": "a CPU", "limnVersion": "0.1.0",
             "options": "error and cost, 24x16", "started": "2024-01-01T00:00:00Z", "loadAverage": 0.5,
             "copyBandwidth": 1e10, "planned": planned,
             "techniques": [{"name": name, "feature": f"{name}Feature", "summary": f"draws {name}", "isArticle": False,
                             "noWidth": "" if name == "Strokes" else "it has no width"} for name in names]}
    values = {"geometry": {"meanAbsoluteError": 0.25, "hausdorff": "inf", "bandPixels": 90},
              "cost": {"gpuAddedMilliseconds": 1.5, "gpuAddedUncertainty": 0.25, "quietPart": 0.5, "quietMilliseconds": 3,
                       "busyMilliseconds": 9, "otherPrograms": 1, "passes": 3, "movedBytes": 24883200.0},
              "temporal": {"flicker": 0.125, "areaLow": "nan", "contourSwim": 1e-3}}
    cells = [{"id": cell, "values": values[cell["kind"]], "notes": ["a note"] if cell["width"] == 8 else [],
              "quartiles": {"gpuAddedMilliseconds": [1.25, 2]} if cell["kind"] == "cost" else {},
              "pictures": {"picture": "pictures/a.png"} if cell["kind"] == "geometry" else {}}
             for cell in planned if cell["technique"] in techniques]
    (folder / "pictures").mkdir(parents=True)
    (folder / "pictures/a.png").write_bytes(png())
    (folder / "study.json").write_text(json.dumps(study, indent=1))
    (folder / "cells.jsonl").write_text("".join(json.dumps(cell) + "\n" for cell in cells))


def make_project(folder):
    """The files, and beside their folder two that no input may lead to."""
    shutil.copytree(ROOT / "tests/editor_stub/data/unity_project", folder, dirs_exist_ok=True)
    files = {"s.scene.yaml": SCENE, "unity.scene.yaml": UNITY_SCENE, "own.shader": SHADER,
             "Tint.hlsl": INCLUDE, "m.gltf": GLTF.replace("BUFFER", '"uri": "m.bin", '),
             "m.glb": glb(GLTF.replace("BUFFER", "")), "m.bin": TRIANGLE, "t.png": png(),
             "u.asset": UNITY_FILE, "p.profile.yaml": PROFILE_FILE,
             "own.cs": CSHARP, "more.cs": MORE_CSHARP, "own.compute": COMPUTE,
             "../secret.txt": SECRET, "../victim.txt": b"precious",
             "can_place.profile.yaml": PROFILE_FILE, "torus_knot.bin": b"\0" * 64512}
    for name, content in files.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
