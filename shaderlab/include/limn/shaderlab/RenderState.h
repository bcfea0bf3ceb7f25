#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <utility>

namespace limn
{

// The values are Unity's (UnityEngine.Rendering, GraphicsEnums.cs), because materials hold them as
// numbers.

enum class CompareFunction
{
    Disabled = 0,
    Never = 1,
    Less = 2,
    Equal = 3,
    LessEqual = 4,
    Greater = 5,
    NotEqual = 6,
    GreaterEqual = 7,
    Always = 8
};

enum class StencilOp
{
    Keep = 0,
    Zero = 1,
    Replace = 2,
    IncrementSaturate = 3,
    DecrementSaturate = 4,
    Invert = 5,
    IncrementWrap = 6,
    DecrementWrap = 7
};

enum class BlendMode
{
    Zero = 0,
    One = 1,
    DstColor = 2,
    SrcColor = 3,
    OneMinusDstColor = 4,
    SrcAlpha = 5,
    OneMinusSrcColor = 6,
    DstAlpha = 7,
    OneMinusDstAlpha = 8,
    SrcAlphaSaturate = 9,
    OneMinusSrcAlpha = 10
};

/// The operations of blending. Every device has the first five. The logical ones combine the drawn
/// bits with those of a target of integers or normalized integers, in place of blending; the
/// advanced ones, from Multiply on, mix colours like painting programs. Both must be the same for
/// colour and alpha of all targets. Unity: UnityEngine.Rendering.BlendOp (2022.3).
enum class BlendOp
{
    Add = 0,
    Subtract = 1,
    ReverseSubtract = 2,
    Min = 3,
    Max = 4,
    LogicalClear = 5,
    LogicalSet = 6,
    LogicalCopy = 7,
    LogicalCopyInverted = 8,
    LogicalNoop = 9,
    LogicalInvert = 10,
    LogicalAnd = 11,
    LogicalNand = 12,
    LogicalOr = 13,
    LogicalNor = 14,
    LogicalXor = 15,
    LogicalEquivalence = 16,
    LogicalAndReverse = 17,
    LogicalAndInverted = 18,
    LogicalOrReverse = 19,
    LogicalOrInverted = 20,
    Multiply = 21,
    Screen = 22,
    Overlay = 23,
    Darken = 24,
    Lighten = 25,
    ColorDodge = 26,
    ColorBurn = 27,
    HardLight = 28,
    SoftLight = 29,
    Difference = 30,
    Exclusion = 31,
    HSLHue = 32,
    HSLSaturation = 33,
    HSLColor = 34,
    HSLLuminosity = 35
};

enum class CullMode
{
    Off = 0,
    Front = 1,
    Back = 2
};

/// The bits of ColorMask; red is the high bit, as in Unity.
/// Unity: UnityEngine.Rendering.ColorWriteMask (2022.3).
struct ColorWriteMask
{
    static constexpr int Alpha = 1;
    static constexpr int Blue = 2;
    static constexpr int Green = 4;
    static constexpr int Red = 8;
    static constexpr int All = 15;

    int bits = 0;

    constexpr ColorWriteMask() = default;
    constexpr ColorWriteMask(int value) : bits(value) {}
    constexpr operator int() const { return bits; }
    constexpr ColorWriteMask& operator|=(ColorWriteMask other) { return *this = bits | other.bits; }
    constexpr ColorWriteMask& operator&=(ColorWriteMask other) { return *this = bits & other.bits; }
};

/// A value of a fixed-function command. It is written out, or taken from a material property at
/// draw time (`Cull [_Cull]`; Unity's enum integers, rounded).
template <typename T>
struct StateValue
{
    T value{};
    std::string property; ///< "" = `value` holds

    StateValue() = default;
    StateValue(T v) : value(v) {}
    static StateValue FromProperty(std::string name)
    {
        StateValue result;
        result.property = std::move(name);
        return result;
    }
    bool operator==(const StateValue&) const = default;
};

// The state in a pass's text, if Value<T> is StateValue<T>, or the state that a draw uses after the
// properties are read, if Value<T> is T.

template <template <typename> typename Value>
struct BasicStencilFace
{
    Value<CompareFunction> compare = CompareFunction::Always;
    Value<StencilOp> pass = StencilOp::Keep;
    Value<StencilOp> fail = StencilOp::Keep;
    Value<StencilOp> zFail = StencilOp::Keep;

    bool operator==(const BasicStencilFace&) const = default;
};
using StencilFaceState = BasicStencilFace<StateValue>;
using StencilFace = BasicStencilFace<std::type_identity_t>;

/// The blending of the drawn colour with one target's; the defaults mean no blending.
template <template <typename> typename Value>
struct BasicTargetBlend
{
    Value<int> writeMask = ColorWriteMask::All; ///< ColorWriteMask bits
    Value<BlendMode> sourceColorBlendMode = BlendMode::One;
    Value<BlendMode> destinationColorBlendMode = BlendMode::Zero;
    Value<BlendMode> sourceAlphaBlendMode = BlendMode::One;
    Value<BlendMode> destinationAlphaBlendMode = BlendMode::Zero;
    Value<BlendOp> colorBlendOperation = BlendOp::Add;
    Value<BlendOp> alphaBlendOperation = BlendOp::Add;

    bool operator==(const BasicTargetBlend&) const = default;
};
/// Unity: UnityEngine.Rendering.RenderTargetBlendState (2022.3).
using RenderTargetBlendState = BasicTargetBlend<std::type_identity_t>;

struct PassBlendState : BasicTargetBlend<StateValue>
{
    bool enabled = false; ///< `Blend` names factors; without it BlendOp has no effect

    bool operator==(const PassBlendState&) const = default;
};

struct PassStencilState
{
    bool enabled = false; ///< the pass has a Stencil block
    StateValue<int> reference = 0;
    StateValue<int> readMask = 255;
    StateValue<int> writeMask = 255;
    StencilFaceState front;
    StencilFaceState back;

    bool operator==(const PassStencilState&) const = default;
};

/// The fixed state of a ShaderLab pass; the defaults are ShaderLab's.
/// Unity: the render-state commands of ShaderLab (2022.3).
struct RenderState
{
    StateValue<CullMode> cull = CullMode::Back;
    StateValue<CompareFunction> zTest = CompareFunction::LessEqual;
    StateValue<bool> zWrite = true;
    StateValue<bool> zClip = true;
    StateValue<float> offsetFactor = 0.0f;
    StateValue<float> offsetUnits = 0.0f;
    StateValue<bool> alphaToMask = false;
    StateValue<bool> conservative = false;
    std::array<PassBlendState, 8> targets;
    bool separateBlend = false; ///< the targets differ
    PassStencilState stencil;

    bool operator==(const RenderState&) const = default;
};

} // namespace limn
