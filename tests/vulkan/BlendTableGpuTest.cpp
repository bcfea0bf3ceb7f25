#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include <glm/gtc/packing.hpp>

namespace limn::test
{

namespace
{

using Float4 = std::array<float, 4>;
using Double4 = std::array<double, 4>;

/// A shader's output and what the target holds before. Targets can hold each destination exactly.
struct Pair
{
    Float4 source;
    Float4 destination;
};

constexpr std::array<Pair, 6> k_Pairs = {{
    {{0.5f, 0.25f, 1.0f, 0.5f}, {0.25f, 1.0f, 0.5f, 0.25f}},
    {{0.0f, 1.0f, 0.75f, 0.0f}, {1.0f, 0.0f, 0.125f, 1.0f}},
    {{1.0f, 0.125f, 0.625f, 1.0f}, {0.5f, 0.75f, 1.0f, 0.0f}},
    {{2.5f, -0.5f, 1.5f, 0.75f}, {3.0f, 0.5f, -1.0f, 0.5f}}, // what only float targets hold
    {{0.25f, 4.0f, 1.0f, 2.0f}, {1.5f, 0.25f, 2.0f, 1.5f}},
    {{0.2f, 0.4f, 0.6f, 0.8f}, {0.625f, 0.1875f, 0.8125f, 0.375f}},
}};
constexpr int k_Rows = static_cast<int>(k_Pairs.size());

// The blend equation, written anew from the names of Unity's factors.

double Factor(BlendMode mode, const Double4& source, const Double4& destination, std::size_t c)
{
    switch (mode)
    {
    case BlendMode::Zero:
        return 0.0;
    case BlendMode::One:
        return 1.0;
    case BlendMode::DstColor:
        return destination[c];
    case BlendMode::SrcColor:
        return source[c];
    case BlendMode::OneMinusDstColor:
        return 1.0 - destination[c];
    case BlendMode::SrcAlpha:
        return source[3];
    case BlendMode::OneMinusSrcColor:
        return 1.0 - source[c];
    case BlendMode::DstAlpha:
        return destination[3];
    case BlendMode::OneMinusDstAlpha:
        return 1.0 - destination[3];
    case BlendMode::SrcAlphaSaturate:
        return c == 3 ? 1.0 : std::min(source[3], 1.0 - destination[3]);
    case BlendMode::OneMinusSrcAlpha:
        return 1.0 - source[3];
    }
    return 0.0;
}

/// A blended channel and the size of its larger term, which its rounding error goes with.
struct Blended
{
    double value = 0.0;
    double scale = 0.0;
};

Blended Blend(const TargetBlend& blend, const Double4& source, const Double4& destination,
              std::size_t c)
{
    const bool alpha = c == 3;
    const BlendOp op = alpha ? blend.alphaOp : blend.colorOp;
    if (op == BlendOp::Min || op == BlendOp::Max)
    {
        const auto [least, most] = std::minmax(source[c], destination[c]);
        return {op == BlendOp::Min ? least : most, std::max(std::abs(least), std::abs(most))};
    }
    const double src =
        source[c] * Factor(alpha ? blend.srcAlpha : blend.srcColor, source, destination, c);
    const double dst =
        destination[c] * Factor(alpha ? blend.dstAlpha : blend.dstColor, source, destination, c);
    const double scale = std::max(std::abs(src), std::abs(dst));
    switch (op)
    {
    case BlendOp::Subtract:
        return {src - dst, scale};
    case BlendOp::ReverseSubtract:
        return {dst - src, scale};
    default:
        return {src + dst, scale};
    }
}

/// What differs between formats: what they hold, and how exactly.
struct FormatRule
{
    GraphicsFormat format;
    bool unorm;
    double unit; ///< the spacing of values next to 1
};

constexpr std::array<FormatRule, 3> k_Formats = {{
    {GraphicsFormat::R8G8B8A8_UNorm, true, 1.0 / 255.0},
    {GraphicsFormat::R16G16B16A16_SFloat, false, 0x1p-10},
    {GraphicsFormat::R32G32B32A32_SFloat, false, 0x1p-23},
}};

/// What the target makes of a value that is put into it.
Double4 Held(const Float4& value, const FormatRule& rule, bool stored)
{
    Double4 held{};
    for (std::size_t c = 0; c < 4; ++c)
    {
        const double v = static_cast<double>(value[c]);
        const double clamped = std::clamp(v, 0.0, 1.0);
        held[c] = !rule.unorm ? v : stored ? std::round(clamped * 255.0) / 255.0 : clamped;
    }
    return held;
}

Float4 TexelOf(const Image& image, int x, int y)
{
    const auto texel = static_cast<std::size_t>(y * image.width + x);
    if (image.format == GraphicsFormat::R8G8B8A8_UNorm)
    {
        const Rgba8 bytes = Texel8(image, x, y);
        Float4 result{};
        std::transform(bytes.begin(), bytes.end(), result.begin(),
                       [](int byte) { return static_cast<float>(byte) / 255.0f; });
        return result;
    }
    if (image.format == GraphicsFormat::R16G16B16A16_SFloat)
    {
        std::uint64_t packed = 0;
        std::memcpy(&packed, &image.texels.at(texel * 8), 8);
        const glm::vec4 v = glm::unpackHalf4x16(packed);
        return {v.x, v.y, v.z, v.w};
    }
    return TexelFloat(image, x, y);
}

/// The 11 x 11 x 5 combinations of two factors and an operation.
constexpr int k_Combinations = 11 * 11 * 5;

struct Combination
{
    BlendMode source;
    BlendMode destination;
    BlendOp op;
};

Combination CombinationAt(int index)
{
    return {static_cast<BlendMode>(index % 11), static_cast<BlendMode>(index / 11 % 11),
            static_cast<BlendOp>(index / 121)};
}

/// Over all indices colour and alpha each meet every combination, never the same one at a time.
TargetBlend BlendAt(int index)
{
    const Combination color = CombinationAt(index % k_Combinations);
    const Combination alpha = CombinationAt((index * 7 + 3) % k_Combinations);
    TargetBlend blend;
    blend.enabled = true;
    blend.srcColor = color.source;
    blend.dstColor = color.destination;
    blend.colorOp = color.op;
    blend.srcAlpha = alpha.source;
    blend.dstAlpha = alpha.destination;
    blend.alphaOp = alpha.op;
    return blend;
}

/// Target t is that many combinations ahead of the first.
int IndexOf(int column, std::size_t t)
{
    return column + 200 * static_cast<int>(t);
}

std::string Describe(const TargetBlend& b)
{
    const auto number = [](auto value)
    {
        return std::to_string(static_cast<int>(value)) + " ";
    };
    return "Blend " + number(b.srcColor) + number(b.dstColor) + ", " + number(b.srcAlpha) +
           number(b.dstAlpha) + "BlendOp " + number(b.colorOp) + ", " + number(b.alphaOp);
}

/// Writes the row's source to three targets.
PassPtr RowPass()
{
    static const PassPtr pass = CompilePass(R"(
        cbuffer Rows { float4 _Sources[6]; };
        struct Outputs { float4 a : SV_Target0; float4 b : SV_Target1; float4 c : SV_Target2; };
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        Outputs frag(float4 position : SV_POSITION)
        {
            Outputs o;
            o.a = _Sources[(uint)position.y];
            o.b = o.a;
            o.c = o.a;
            return o;
        })");
    return pass;
}

/// A column for each combination, a row for each pair; all formats in one pass.
std::vector<Image> DrawTable()
{
    std::vector<TargetPtr> targets;
    CompiledRenderPass pass;
    pass.name = "blend table";
    pass.width = k_Combinations;
    pass.height = k_Rows;
    CompiledFrame frame;
    for (const FormatRule& rule : k_Formats)
    {
        const TargetPtr target = MakeTarget(k_Combinations, k_Rows, rule.format);
        targets.push_back(target);
        pass.barriers.push_back({target, TextureUsage::Undefined, TextureUsage::ColorAttachment});
        pass.colors.push_back({target, LoadOp::Clear, StoreOp::Store, {}});
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
    }
    std::array<Float4, k_Pairs.size()> sources{};
    for (int row = 0; row < k_Rows; ++row)
    {
        const Pair& pair = k_Pairs.at(static_cast<std::size_t>(row));
        const Float4& d = pair.destination;
        sources.at(static_cast<std::size_t>(row)) = pair.source;
        pass.commands.emplace_back(SetViewportCommand{{0, row, k_Combinations, 1}});
        pass.commands.emplace_back(ClearCommand{ClearFlag::Color, {d[0], d[1], d[2], d[3]}});
    }
    DrawBindings bindings;
    bindings.uniforms = {AddUniform(frame, RowPass()->layout.buffers.at(0).binding, sources)};
    DrawCommand draw = MakeDraw(RowPass(), MakeQuad(), PlainState(), bindings);
    for (int column = 0; column < k_Combinations; ++column)
    {
        for (std::size_t t = 0; t < targets.size(); ++t)
        {
            draw.state.targets.at(t) = BlendAt(IndexOf(column, t));
        }
        pass.commands.emplace_back(SetViewportCommand{{column, 0, 1, k_Rows}});
        pass.commands.emplace_back(draw);
    }
    frame.passes.push_back(std::move(pass));
    SharedDevice().Execute(frame);
    std::vector<Image> images;
    for (const TargetPtr& target : targets)
    {
        images.push_back(SharedDevice().ReadBack(*target));
    }
    return images;
}

/// The largest error of one texel in units of its tolerance.
double ErrorOf(const Image& image, const FormatRule& rule, const TargetBlend& blend, int x, int row)
{
    const Pair& pair = k_Pairs.at(static_cast<std::size_t>(row));
    const Double4 source = Held(pair.source, rule, false);
    const Double4 destination = Held(pair.destination, rule, true);
    const Float4 actual = TexelOf(image, x, row);
    double worst = 0.0;
    for (std::size_t c = 0; c < 4; ++c)
    {
        Blended expected = Blend(blend, source, destination, c);
        double tolerance = 2.0 * rule.unit * expected.scale; // 2 ulp of the larger term
        if (rule.unorm)
        {
            expected.value = std::clamp(expected.value, 0.0, 1.0);
            tolerance = 1.001 * rule.unit; // 1/255, and what float takes to write it
        }
        const double error = std::abs(static_cast<double>(actual.at(c)) - expected.value);
        worst = std::max(worst, error == 0.0 ? 0.0 : error / tolerance);
    }
    return worst;
}

} // namespace

using BlendTable = GpuTest;

TEST_F(BlendTable, AgreesWithTheEquationForEveryFactorPairAndOperationOnEveryKindOfTarget)
{
    const std::vector<Image> images = DrawTable();
    for (std::size_t t = 0; t < k_Formats.size(); ++t)
    {
        int wrong = 0;
        for (int i = 0; i < k_Combinations * k_Rows; ++i)
        {
            const int column = i % k_Combinations;
            const TargetBlend blend = BlendAt(IndexOf(column, t));
            const double error =
                ErrorOf(images.at(t), k_Formats.at(t), blend, column, i / k_Combinations);
            if (!(error <= 1.0) && ++wrong == 1)
            {
                ADD_FAILURE() << ToString(k_Formats.at(t).format) << ", " << Describe(blend)
                              << ", pair " << i / k_Combinations << ": " << error
                              << " times the tolerance";
            }
        }
        EXPECT_EQ(0, wrong) << "of " << k_Combinations * k_Rows << " texels of "
                            << ToString(k_Formats.at(t).format);
    }
}

} // namespace limn::test
