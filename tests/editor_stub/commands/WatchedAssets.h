#pragma once

#include "TemporaryFolder.h"

#include <cstring>
#include <limn/core/Image.h>

namespace limn::test
{

// A scene that reaches a file of every kind: a triangle that fills the picture, its shader's text
// being _BaseMap times the included Tint().

inline constexpr const char* k_AssetScene =
    "size: [32, 18]\n"
    "camera: {position: [0, 0, -4], backgroundColor: \"#000000\"}\n"
    "volumes: [{name: All, profile: p.profile.yaml}]\n"
    "materials: {own: {shader: own.shader, _BaseMap: t.png}}\n"
    "objects: [{name: Piece, mesh: m.gltf, material: own}]\n";

inline std::string ShaderText(const std::string& factor)
{
    return R"(Shader "Test/Own"
{
    Properties { _BaseMap ("Texture", 2D) = "white" {} }
    SubShader { Pass {
        Cull Off
        HLSLPROGRAM
        #pragma vertex Vertex
        #pragma fragment Fragment
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "Tint.hlsl"
        TEXTURE2D(_BaseMap);
        SAMPLER(sampler_BaseMap);
        float4 Vertex(float4 positionOS : POSITION) : SV_POSITION
        {
            return TransformObjectToHClip(positionOS.xyz);
        }
        half4 Fragment() : SV_Target
        {
            half3 color = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, float2(0.5, 0.5)).rgb;
            return half4(color * Tint() * )" +
           factor + R"(, 1);
        }
        ENDHLSL
    } }
}
)";
}

inline std::string TintText(const std::string& color)
{
    return "half3 Tint() { return half3(" + color + "); }\n";
}

/// One triangle whose corners are in m.bin.
inline std::string GltfText(const std::string& translation)
{
    return R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "m.bin", "byteLength": 36}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
    "min": [-99, -99, 0], "max": [99, 99, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"nodes": [{"mesh": 0, "translation": [)" +
           translation + R"(]}], "scenes": [{"nodes": [0]}], "scene": 0})";
}

/// The corners of a large triangle around (x, 0, 0).
inline std::string CornerBytes(float x)
{
    const float corners[9] = {x - 20, -20, 0, x + 20, -20, 0, x, 40, 0};
    std::string bytes(sizeof(corners), '\0');
    std::memcpy(bytes.data(), corners, sizeof(corners));
    return bytes;
}

inline void WriteTexture(const std::filesystem::path& path, int r, int g, int b)
{
    Image image;
    image.width = 1;
    image.height = 1;
    image.format = GraphicsFormat::R8G8B8A8_SRGB;
    image.texels = {static_cast<std::byte>(r), static_cast<std::byte>(g), static_cast<std::byte>(b),
                    std::byte{255}};
    WritePng(path, image);
}

/// s.scene.yaml and all that it reaches; the picture is white.
inline void WriteAssets(const TemporaryFolder& folder)
{
    folder.Write("s.scene.yaml", k_AssetScene);
    folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_Enable: false}\n");
    folder.Write("own.shader", ShaderText("1"));
    folder.Write("Tint.hlsl", TintText("1, 1, 1"));
    folder.Write("m.gltf", GltfText("0, 0, 0"));
    folder.Write("m.bin", CornerBytes(0.0f));
    WriteTexture(folder / "t.png", 255, 255, 255);
}

/// The colour at a place of a picture, 0...1 from the left and half way up, as "#rrggbb"; "" while
/// there is no picture.
inline std::string ColorAt(const std::filesystem::path& png, double x = 0.5)
{
    if (!std::filesystem::exists(png))
    {
        return {};
    }
    const Image image = ReadPng(png);
    const auto column = static_cast<std::size_t>(x * image.width);
    const auto row = static_cast<std::size_t>(image.height / 2);
    const std::size_t at = (row * static_cast<std::size_t>(image.width) + column) * 4;
    std::string color = "#";
    for (std::size_t i = at; i < at + 3; ++i)
    {
        const int value = std::to_integer<int>(image.texels[i]);
        color += "0123456789abcdef"[value / 16];
        color += "0123456789abcdef"[value % 16];
    }
    return color;
}

} // namespace limn::test
