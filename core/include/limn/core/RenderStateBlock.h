#pragma once

#include <limn/core/Flags.h>
#include <limn/core/PipelineState.h>

namespace limn
{

/// The groups of state that a RenderStateBlock replaces; bit flags.
/// Unity: UnityEngine.Rendering.RenderStateMask (2022.3).
enum class RenderStateMask
{
    Nothing = 0,
    Blend = 1,
    Raster = 2,
    Depth = 4,
    Stencil = 8,
    Everything = 15
};
template <>
inline constexpr bool k_IsFlags<RenderStateMask> = true;
constexpr RenderStateMask& operator|=(RenderStateMask& a, RenderStateMask b)
{
    return a = a | b;
}

/// Unity: UnityEngine.Rendering.BlendState (2022.3).
struct BlendState
{
    bool separateMRTBlendStates = false; ///< false: blendStates[0] holds for all targets
    bool alphaToMask = false;
    std::array<RenderTargetBlendState, 8> blendStates; ///< Unity: blendState0 ... blendState7

    static const BlendState defaultValue;

    bool operator==(const BlendState&) const = default;
};

/// Unity: UnityEngine.Rendering.RasterState (2022.3).
struct RasterState
{
    CullMode cullingMode = CullMode::Back;
    float offsetUnits = 0.0f;
    float offsetFactor = 0.0f;
    bool depthClip = true;
    bool conservative = false;

    static const RasterState defaultValue;

    bool operator==(const RasterState&) const = default;
};

/// Unity: UnityEngine.Rendering.DepthState (2022.3). Its default compares with Less, not with
/// ShaderLab's LessEqual.
struct DepthState
{
    bool writeEnabled = true;
    CompareFunction compareFunction = CompareFunction::Less;

    static const DepthState defaultValue;

    constexpr DepthState() = default;
    constexpr DepthState(bool write, CompareFunction compare)
        : writeEnabled(write), compareFunction(compare)
    {
    }
    bool operator==(const DepthState&) const = default;
};

/// The stencil state of a block. A default-constructed value is Unity's defaultValue; C#'s `new
/// StencilState()`, disabled and all zero, must be written out.
/// Unity: UnityEngine.Rendering.StencilState (2022.3).
struct StencilState
{
    bool enabled = true;
    int readMask = 255;  ///< 0...255
    int writeMask = 255; ///< 0...255
    StencilFace front;
    StencilFace back;

    static const StencilState defaultValue;

    /// These set both faces, as Unity's do.
    void SetCompareFunction(CompareFunction value) { front.compare = back.compare = value; }
    void SetPassOperation(StencilOp value) { front.pass = back.pass = value; }
    void SetFailOperation(StencilOp value) { front.fail = back.fail = value; }
    void SetZFailOperation(StencilOp value) { front.zFail = back.zFail = value; }

    bool operator==(const StencilState&) const = default;
};

inline constexpr BlendState BlendState::defaultValue{};
inline constexpr RasterState RasterState::defaultValue{};
inline constexpr DepthState DepthState::defaultValue{};
inline constexpr StencilState StencilState::defaultValue{};

/// The state that a DrawRenderers call uses in place of the shader passes' own. Each group in
/// `mask` is replaced as a whole: Depth replaces ZWrite and ZTest, Stencil the reference, both
/// masks and all operations. Groups outside `mask` stay as the pass has them.
/// Unity: UnityEngine.Rendering.RenderStateBlock (2022.3).
struct RenderStateBlock
{
    explicit RenderStateBlock(RenderStateMask replaced = RenderStateMask::Nothing) : mask(replaced)
    {
    }

    RenderStateMask mask;
    BlendState blendState;
    RasterState rasterState;
    DepthState depthState;
    StencilState stencilState;
    int stencilReference = 0; ///< 0...255

    bool operator==(const RenderStateBlock&) const = default;
};

/// Returns `state` with the block's groups in place of its own.
/// @throws ContractError if a stencil reference or mask is outside 0...255, or a writeMask outside
///         0...15
PipelineState Override(const PipelineState& state, const RenderStateBlock& block);

} // namespace limn
