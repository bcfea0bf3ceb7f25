#pragma once

#include <array>
#include <limn/shaderlab/RenderState.h>

namespace limn
{

/// What vertices make up, values Unity's. Unity: UnityEngine.MeshTopology (2022.3).
enum class MeshTopology
{
    Triangles = 0,
    Quads = 2, ///< four vertices each, drawn as the triangles 0 1 2 and 0 2 3
    Lines = 3,
    LineStrip = 4,
    Points = 5 ///< of one texel, unless the vertex function says PSIZE
};

/// A pass's RenderState with every `[_Property]` replaced by the material's value: what a draw
/// really uses. Depth compares are Unity's (nearer = Less); the device turns them for reversed Z.
struct PipelineState
{
    CullMode cull = CullMode::Back;
    /// Counter-clockwise triangles face front: into a texture, whose projection is flipped, where
    /// the transform does not mirror, and into a back buffer where it does.
    bool frontFaceFlipped = false;
    CompareFunction zTest = CompareFunction::LessEqual; ///< Disabled = no depth test and no write
    bool zWrite = true;
    bool zClip = true;
    float offsetFactor = 0.0f; ///< positive = farther, as in Unity
    float offsetUnits = 0.0f;
    bool alphaToMask = false;
    bool conservative = false; ///< every pixel a triangle touches, where the device can
    std::array<RenderTargetBlendState, 8> targets;
    bool stencilEnabled = false;
    int stencilReference = 0;
    int stencilReadMask = 255;
    int stencilWriteMask = 255;
    StencilFace stencilFront;
    StencilFace stencilBack;
    MeshTopology topology = MeshTopology::Triangles; ///< of the draw, not of the pass

    bool operator==(const PipelineState&) const = default;
};

} // namespace limn
