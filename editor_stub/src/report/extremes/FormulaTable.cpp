#include "report/extremes/Stability.h"

#include "console/Texts.h"
#include "report/measure/StudyPicture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limn/base/EmbeddedFile.h>
#include <limn/core/OutlineNormals.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <limn/features/OutlineEffect.h>
#include <sstream>

namespace limn::embedded
{
std::span<const EmbeddedFile> FormulaShader();
}

namespace limn::study
{

namespace
{

std::string TextOf(std::span<const FormulaCell> cells)
{
    std::ostringstream inputs;
    std::ostringstream code;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
        inputs << "float4 _Input" << i << ";\n";
        // Beyond 1e38 it is too large for a float by now.
        code << "    if (cell == " << i << ")\n    {\n        float4 v = _Input" << i
             << ";\n        v = abs(v) > 1e38 ? v * 100.0 : v;\n"
                "        float a = v.x, b = v.y, c = v.z, d = v.w;\n        first = "
             << cells[i].articleText << ";\n        second = " << cells[i].oursText << ";\n    }\n";
    }
    const std::string text(embedded::FormulaShader().front().text);
    return Replaced(Replaced(text, "@INPUTS@", inputs.str()), "@CELLS@", code.str());
}

double NumberAt(const Coverage (&channels)[3], int x, int y)
{
    const auto part = [&](int channel)
    {
        return static_cast<std::uint32_t>(std::lround(channels[channel].At(x, y)));
    };
    return static_cast<double>(std::bit_cast<float>(part(0) << 22 | part(1) << 11 | part(2)));
}

/// The inputs `a` to `d` of one formula, and the right result.
struct FormulaInput
{
    const char* text;
    glm::vec4 values; ///< beyond 1e38: infinite
    double meant;
    bool articleHolds = false;
};

constexpr float k_Infinite = 3e38f;
constexpr float k_NaNBits = 2143289344.0f; ///< 0x7FC00000 as a number

/// The selection's colour t seconds after its start, as both shaders get it.
FormulaInput TimeInput(const char* text, double seconds, bool articleHolds)
{
    return {text,
            {static_cast<float>(2.0 * seconds), static_cast<float>(OutlineEffect::Phase(seconds)),
             0.0f, 0.0f},
            std::sin(2.0 * seconds),
            articleHolds};
}

void AddShaderFormulas(std::vector<FormulaCell>& cells)
{
    const auto add = [&cells](const char* formula, const char* where, const char* article,
                              const char* ours, double tolerance,
                              const std::vector<FormulaInput>& inputs, const char* reason)
    {
        for (const FormulaInput& input : inputs)
        {
            cells.push_back({formula, where, input.text, input.meant, tolerance, 0.0, 0.0,
                             input.articleHolds, reason, article, ours, input.values});
        }
    };
    add("pow(x, y), y = 2", "Depth and normals (article)", "pow(a, b)", "a * a", 1e-6,
        {{"x = 0.5", {0.5, 2, 0, 0}, 0.25, true},
         {"x = -0.5", {-0.5, 2, 0, 0}, 0.25},
         {"x = -0.001", {-0.001, 2, 0, 0}, 1e-6}},
        "a power is exp2(y log2(x)), and negative differences have no logarithm, unless a driver "
        "makes a square of a constant 2, as lavapipe does; ours is a product");
    add("difference > depth / sensitivity", "Depth and normals (article)",
        "b > (1.0 / a) * c ? 1.0 : 0.0", "a > 0.0 && b * a > c ? 1.0 : 0.0", 0.0,
        {{"sensitivity 0.2, difference 0.1, depth 0.5", {0.2, 0.1, 0.5, 0}, 0.0, true},
         {"sensitivity 0", {0.0, 0.1, 0.5, 0}, 0.0, true},
         {"sensitivity -0", {-0.0, 0.1, 0.5, 0}, 0.0},
         {"sensitivity -1", {-1.0, 0.1, 0.5, 0}, 0.0},
         {"sensitivity infinite", {k_Infinite, 0.1, 0.5, 0}, 1.0, true}},
        "1 / -0 is -infinity, which everything is above: the whole object is a line; ours "
        "multiplies, and finds nothing where the sensitivity is not above 0");
    add("sin(2 t)", "Selection", "sin(a)", "sin(b)", 1.0 / 255.0,
        {TimeInput("t = 1 minute", 60.3, true), TimeInput("t = 1 week", 604801.4, true),
         TimeInput("t = 1 month", 2592000.7, false), TimeInput("t = 1e7 s", 1e7 + 0.1, false),
         TimeInput("t = 1e9 s", 1e9 + 0.1, false)},
        "a float counts the angle in steps of 0.1 after a week and of 2 after 1e7 s; ours takes "
        "whole turns off in double precision, before the shader");
    add("angle after 8 bits, degrees off", "Depth and normals (article)", "limn_StereoError(a)",
        "limn_ComponentError(a)", 1.5,
        {{"normal 0 degrees from the view", {0, 0, 0, 0}, 0.0, true},
         {"60 degrees", {60, 0, 0, 0}, 0.0, true},
         {"110 degrees", {110, 0, 0, 0}, 0.0, true},
         {"150 degrees", {150, 0, 0, 0}, 0.0},
         {"179 degrees", {179, 0, 0, 0}, 0.0}},
        "stereographic projection sends the far pole to infinity, and has no place beyond 121 "
        "degrees; ours keeps three components");
    add("edge of three depths in a row", "Depth and normals (article)",
        "abs(c - a) * 100.0 * 0.2 > b ? 1.0 : 0.0",
        "limn_Step(a, b, c, min(abs(b - a), abs(c - b)) / 64.0) > 0.1 ? 1.0 : 0.0", 0.0,
        {{"a plane head on: 0.5, 0.5, 0.5", {0.5, 0.5, 0.5, 0}, 0.0, true},
         {"a grazing plane: 0.0090, 0.0100, 0.0110", {0.009, 0.01, 0.011, 0}, 0.0},
         {"a plane more grazing: 0.001, 0.010, 0.019", {0.001, 0.01, 0.019, 0}, 0.0},
         {"a step: 0.010, 0.010, 0.002", {0.01, 0.01, 0.002, 0}, 1.0, true}},
        "the change of depth depends on the angle at which a plane is seen; ours takes the "
        "distance of three depths from a plane, whose depth is affine in the picture");
    add("normalize(v).x", "hulls", "normalize(float3(a, b, c)).x",
        "SafeNormalize(float3(a, b, c)).x", 1e-6,
        {{"v = (3, 0, 4)", {3, 0, 4, 0}, 0.6, true}, {"v = (0, 0, 0)", {0, 0, 0, 0}, 0.0}},
        "0 / 0; ours keeps no direction as none");
    add("smoothstep(a, a, x)", "soft thresholds", "smoothstep(a, a, b)", "limn_Above(b, a, 0.0)",
        1e-6,
        {{"a = 0.5, x = 0.4", {0.5, 0.4, 0, 0}, 0.0, true},
         {"a = 0.5, x = 0.5", {0.5, 0.5, 0, 0}, 0.0, true},
         {"a = 0.5, x = 0.6", {0.5, 0.6, 0, 0}, 1.0}},
        "it is undefined, a division by 0; lavapipe finds nothing above the threshold. Ours "
        "divides by no less than 1e-6");
    add("which way a hull's vertex moves", "hulls", "sign(limn_ExtrudedInClipSpace(a))",
        "sign(limn_HullMoved(a))", 0.0,
        {{"2 m before the camera", {2, 0, 0, 0}, 1.0, true},
         {"0.1 m behind the camera", {-0.1, 0, 0, 0}, 1.0},
         {"100 m behind the camera", {-100, 0, 0, 0}, 1.0}},
        "an offset times w changes its direction where w is below 0; ours moves vertices behind "
        "the near plane in space");
    add("picture + line", "additive lines", "limn_Special(a) + b",
        "limn_Shown(limn_Special(a)) + b", 1e-6,
        {{"0.5 + 0.25", {0.5, 0.25, 0, 0}, 0.75, true},
         {"NaN + 0.25", {k_NaNBits, 0.25, 0, 0}, 0.25},
         {"infinite + 0.25", {k_Infinite, 0.25, 0, 0}, 1.25}},
        "a sum with a value that is not a number is none, too; ours lets no value into its "
        "textures that the screen could not show");
}

/// The last pixel of a picture so wide in texels of a mask, from the left.
double LastTexel(int picture, int mask)
{
    return (picture - 0.5) / picture * mask;
}

void AddHalfSizes(std::vector<FormulaCell>& cells)
{
    for (const int width : {1920, 1919, 3, 1})
    {
        const int half = width / 2;
        cells.push_back(
            {"drift of a mask's texels, pixels", "Screen space", std::to_string(width) + " pixels",
             0.0, 1e-6,
             half > 0 ? LastTexel(width, half) * 2.0 - (width - 0.5)
                      : std::nan(""), // no texel: Vulkan refuses the texture
             LastTexel(width, width) - (width - 0.5), width % 2 == 0,
             "half of an odd size is rounded down, so that texels drift away from their pixels, "
             "and a picture of one pixel has no mask; our masks are as large as the picture"});
    }
}

/// Four sides of a bar: a corner of two faces.
std::shared_ptr<const Mesh> Bar()
{
    MeshData data;
    data.vertices = {{-1, -1, -9}, {1, -1, -9}, {1, 1, -9}, {-1, 1, -9},
                     {-1, -1, 9},  {1, -1, 9},  {1, 1, 9},  {-1, 1, 9}};
    for (const std::uint32_t i : {0u, 1u, 2u, 3u})
    {
        const std::uint32_t next = (i + 1) % 4;
        data.triangles.insert(data.triangles.end(), {i, next, i + 4, next, next + 4, i + 4});
    }
    return std::make_shared<const Mesh>("bar", std::move(data));
}

void AddCorners(std::vector<FormulaCell>& cells)
{
    const auto add = [&](const char* input, const std::shared_ptr<const Mesh>& mesh)
    {
        const glm::vec3 outline = BakeOutlineNormals(*mesh).front();
        // A side of the bar or the cube has one of the axes for its normal.
        const auto side = static_cast<double>(std::abs(outline.x));
        cells.push_back({"how far a hull of 1 moves a side", "hulls", input, 1.0, 1e-5,
                         side / static_cast<double>(glm::length(outline)), side, false,
                         "the mean of the normals is as long as each of them, and a side moves by "
                         "its cosine: 29 % thin at two faces, 42 % at three; ours is as long as "
                         "the corner needs"});
    };
    add("a corner of two faces at 90 degrees", Bar());
    add("a cube's corner", CreatePrimitive(PrimitiveType::Cube));
}

} // namespace

bool FormulaCell::IsGood(double value) const
{
    return std::isfinite(value) && std::abs(value - meant) <= tolerance;
}

std::vector<FormulaCell> Formulas()
{
    std::vector<FormulaCell> cells;
    AddShaderFormulas(cells);
    AddHalfSizes(cells);
    AddCorners(cells);
    return cells;
}

std::vector<FormulaCell> EvaluateFormulas(AssetContext& assets, GraphicsDevice& device)
{
    std::vector<FormulaCell> cells = Formulas();
    const auto isOfShader = [](const FormulaCell& cell)
    {
        return !cell.oursText.empty();
    };
    const auto others = std::ranges::partition_point(cells, isOfShader);
    const std::span<FormulaCell> ofShaders(cells.begin(), others);
    const auto material = std::make_shared<Material>(
        Shader::FromText(TextOf(ofShaders), "formulas", assets.compiler()));
    for (std::size_t i = 0; i < ofShaders.size(); ++i)
    {
        material->SetVector(ShaderPropertyId("_Input" + std::to_string(i)), ofShaders[i].values);
    }
    auto feature = std::make_unique<FullScreenPassRendererFeature>();
    feature->name = "Formulas";
    feature->passMaterial = material;
    feature->requirements = ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal;
    feature->fetchColorBuffer = false;
    SceneAsset asset = EmptyPicture(static_cast<int>(ofShaders.size()), 2);
    asset.camera.orthographic = false;
    asset.camera.nearClipPlane = 0.1f;
    asset.camera.transform.localPosition = glm::vec3(0.0f);
    asset.renderer.features.push_back(std::move(feature));
    StudyPicture picture(std::move(asset), assets, device);
    const Image colors = picture.Colors();
    const Coverage channels[3] = {ChannelOf(colors, 0), ChannelOf(colors, 1), ChannelOf(colors, 2)};
    for (int x = 0; x < colors.width; ++x)
    {
        FormulaCell& cell = ofShaders[static_cast<std::size_t>(x)];
        cell.article = NumberAt(channels, x, 0);
        cell.ours = NumberAt(channels, x, 1);
    }
    return cells;
}

} // namespace limn::study
