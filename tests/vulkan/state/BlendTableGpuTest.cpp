#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "state/BlendModel.h"
#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace limn::test
{

namespace
{

using Float4 = std::array<float, 4>;

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
RenderTargetBlendState BlendAt(int index)
{
    const Combination color = CombinationAt(index % k_Combinations);
    const Combination alpha = CombinationAt((index * 7 + 3) % k_Combinations);
    RenderTargetBlendState blend;
    blend.sourceColorBlendMode = color.source;
    blend.destinationColorBlendMode = color.destination;
    blend.colorBlendOperation = color.op;
    blend.sourceAlphaBlendMode = alpha.source;
    blend.destinationAlphaBlendMode = alpha.destination;
    blend.alphaBlendOperation = alpha.op;
    return blend;
}

// Two targets of each format share the combinations: drivers compile a program for each blend
// state, which takes the time of this test, and a program for more targets takes hardly longer.
constexpr std::size_t k_Targets = 2 * k_Formats.size();
constexpr int k_Columns = (k_Combinations + 1) / 2;

const FormatRule& RuleOf(std::size_t t)
{
    return k_Formats.at(t % k_Formats.size());
}

/// What target t blends with in a column; the formats are at different places in the list.
int IndexOf(int column, std::size_t t)
{
    const auto half = static_cast<int>(t / k_Formats.size());
    return column + k_Columns * half + 200 * static_cast<int>(t % k_Formats.size());
}

std::string Describe(const RenderTargetBlendState& b)
{
    const auto number = [](auto value)
    {
        return std::to_string(static_cast<int>(value)) + " ";
    };
    return "Blend " + number(b.sourceColorBlendMode) + number(b.destinationColorBlendMode) + ", " +
           number(b.sourceAlphaBlendMode) + number(b.destinationAlphaBlendMode) + "BlendOp " +
           number(b.colorBlendOperation) + ", " + number(b.alphaBlendOperation);
}

/// Writes the row's source to six targets.
PassPtr RowPass()
{
    static const PassPtr pass = CompilePass(R"(
        cbuffer Rows { float4 _Sources[6]; };
        struct Outputs
        {
            float4 a : SV_Target0; float4 b : SV_Target1; float4 c : SV_Target2;
            float4 d : SV_Target3; float4 e : SV_Target4; float4 f : SV_Target5;
        };
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        Outputs frag(float4 position : SV_POSITION)
        {
            Outputs o;
            o.a = o.b = o.c = o.d = o.e = o.f = _Sources[(uint)position.y];
            return o;
        })");
    return pass;
}

/// Adds the targets to the pass and the row's destination to each row of them.
std::vector<TargetPtr> AddTargets(CompiledFrame& frame, CompiledRenderPass& pass)
{
    std::vector<TargetPtr> targets;
    for (std::size_t t = 0; t < k_Targets; ++t)
    {
        const TargetPtr target = MakeTarget(k_Columns, k_Rows, RuleOf(t).format);
        targets.push_back(target);
        pass.barriers.push_back({target, TextureUsage::Undefined, TextureUsage::ColorAttachment});
        pass.colors.push_back({target, LoadOp::Clear, StoreOp::Store, {}});
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
    }
    for (int row = 0; row < k_Rows; ++row)
    {
        const Float4& d = k_Pairs.at(static_cast<std::size_t>(row)).destination;
        pass.commands.emplace_back(SetViewportCommand{{0, row, k_Columns, 1}});
        pass.commands.emplace_back(ClearCommand{ClearFlag::Color, {d[0], d[1], d[2], d[3]}});
    }
    return targets;
}

/// A column for each combination, a row for each pair; all targets in one pass.
std::vector<Image> DrawTable()
{
    CompiledFrame frame;
    CompiledRenderPass pass;
    pass.name = "blend table";
    pass.width = k_Columns;
    pass.height = k_Rows;
    const std::vector<TargetPtr> targets = AddTargets(frame, pass);
    std::array<Float4, k_Pairs.size()> sources{};
    std::transform(k_Pairs.begin(), k_Pairs.end(), sources.begin(),
                   [](const Pair& pair) { return pair.source; });
    DrawBindings bindings;
    bindings.uniforms = {AddUniform(frame, RowPass()->layout.buffers.at(0).binding, sources)};
    PipelineState state = PlainState();
    const DrawCommand draw = MakeDraw(frame, RowPass(), MakeQuad(), state, bindings);
    for (int column = 0; column < k_Columns; ++column)
    {
        for (std::size_t t = 0; t < targets.size(); ++t)
        {
            state.targets.at(t) = BlendAt(IndexOf(column, t));
        }
        pass.commands.emplace_back(SetViewportCommand{{column, 0, 1, k_Rows}});
        pass.commands.emplace_back(WithState(frame, draw, state));
    }
    frame.passes.push_back(std::move(pass));
    SharedDevice().Execute(frame);
    std::vector<Image> images;
    for (const TargetPtr& target : targets)
    {
        images.push_back(ReadRows(*target));
    }
    return images;
}

/// The largest error of one texel in units of its tolerance.
double ErrorOf(const Image& image, const FormatRule& rule, const RenderTargetBlendState& blend,
               int x, int row)
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
    for (std::size_t t = 0; t < k_Targets; ++t)
    {
        const std::string format = ToString(RuleOf(t).format);
        int wrong = 0;
        for (int i = 0; i < k_Columns * k_Rows; ++i)
        {
            const int column = i % k_Columns;
            const int row = i / k_Columns;
            const RenderTargetBlendState blend = BlendAt(IndexOf(column, t));
            const double error = ErrorOf(images.at(t), RuleOf(t), blend, column, row);
            if (!(error <= 1.0) && ++wrong == 1)
            {
                ADD_FAILURE() << format << ", " << Describe(blend) << ", pair " << row << ": "
                              << error << " times the tolerance";
            }
        }
        EXPECT_EQ(0, wrong) << "of " << k_Columns * k_Rows << " texels of " << format;
    }
}

} // namespace limn::test
