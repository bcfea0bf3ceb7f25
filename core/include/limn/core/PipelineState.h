#pragma once

#include <array>
#include <limn/shaderlab/RenderState.h>

namespace limn
{

/// Selects the primitives that vertices form, with Unity's values. Unity: UnityEngine.MeshTopology
/// (2022.3).
enum class MeshTopology
{
    Triangles = 0,
    Quads = 2, ///< four vertices each, drawn as the triangles 0 1 2 and 0 2 3
    Lines = 3,
    LineStrip = 4,
    Points = 5 ///< of one texel, unless the vertex function writes PSIZE
};

/// The state that a draw uses: a pass's RenderState with every `[_Property]` replaced by the
/// material's value. Depth compares are Unity's (nearer = Less); the device inverts them for
/// reversed Z.
struct PipelineState
{
    CullMode cull = CullMode::Back;
    /// If true, counter-clockwise triangles face front. That is so in a texture, whose projection
    /// is flipped, if the transform does not mirror, and in a back buffer if it does.
    bool frontFaceFlipped = false;
    CompareFunction zTest = CompareFunction::LessEqual; ///< Disabled = no depth test and no write
    bool zWrite = true;
    bool zClip = true;
    float offsetFactor = 0.0f; ///< positive = farther, as in Unity
    float offsetUnits = 0.0f;
    bool alphaToMask = false;
    bool conservative = false; ///< draws every pixel that a triangle touches, where the device can
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
