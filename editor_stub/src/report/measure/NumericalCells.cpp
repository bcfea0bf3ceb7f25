
#include "report/measure/StudyBench.h"
#include "report/measure/StudyScene.h"
#include "report/truth/twins/Twins.h"

#include <algorithm>
#include <cmath>

namespace limn::study
{

namespace
{

constexpr const char* k_Half = "half";
constexpr const char* k_StandardZ = "standard Z";
constexpr const char* k_SmallTarget = "R8 targets";

std::map<std::string, double> DifferenceOf(const Coverage& drawn, const Coverage& other)
{
    const OutlineScore score = ScoreOutline(drawn, other);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < drawn.values.size(); ++i)
    {
        differing += std::abs(drawn.values[i] - other.values[i]) > 1.0 / 255.0 ? 1u : 0u;
    }
    const double pixels = std::max(static_cast<double>(score.bandPixels), 1.0);
    return {{"numericalMean", score.meanAbsoluteError},
            {"numericalPercentile99", score.percentile99},
            {"numericalLargest", score.largest},
            {"numericalDiffering", static_cast<double>(differing) / pixels}};
}

/// Returns the number of places that a device has for a corner along a pixel's side.
double CornerGrid(const VulkanDevice& device)
{
    for (const VulkanDeviceInfo& info : EnumerateVulkanDevices())
    {
        if (info.name == device.deviceName())
        {
            return std::exp2(info.subPixelPrecisionBits);
        }
    }
    throw ContractError("no Vulkan device is called " + device.deviceName() + " any more");
}

/// Repeats what the device does, which puts corners at the nearest place that it has, and whose
/// targets have the bottom row of the picture first: the shapes are turned over before, and the
/// picture back again.
/// @param grid  how many places a pixel's side has for a corner
Coverage DrawTwin(const Twin& twin, const CellId& id, double grid)
{
    ScreenTriangles triangles = ShapeTriangles(id.subject, id.pictureWidth, id.pictureHeight);
    for (auto& triangle : triangles)
    {
        for (glm::dvec2& corner : triangle)
        {
            corner.y = id.pictureHeight - corner.y;
            corner = DrawsItsEdges(id.technique) ? glm::round(corner * grid) / grid : corner;
        }
    }
    Coverage picture = twin(Silhouette(triangles), id.width, id.pictureWidth, id.pictureHeight);
    for (int row = 0; row < picture.height / 2; ++row)
    {
        double* const upper = &picture.At(0, row);
        std::swap_ranges(upper, upper + picture.width, &picture.At(0, picture.height - 1 - row));
    }
    return picture;
}

} // namespace

const std::vector<std::string>& NumericalVariants()
{
    static const std::vector<std::string> variants = {"", k_Half, k_StandardZ, k_SmallTarget};
    return variants;
}

AssetContext& NumericalBench::AssetsFor(const std::string& variant)
{
    if (variant != k_Half && variant != k_StandardZ)
    {
        return m_Assets;
    }
    std::unique_ptr<AssetContext>& assets = m_Others[variant];
    if (!assets)
    {
        ShaderCompilerOptions options = m_Assets.compiler()->options();
        options.halfIs16Bit = variant == k_Half;
        options.usesReversedZBuffer = variant != k_StandardZ;
        options.missingFeatures = m_Device.missingShaderFeatures();
        assets = std::make_unique<AssetContext>(std::move(options));
        assets->LoadPluginsOf(m_Assets);
    }
    return *assets;
}

Coverage NumericalBench::Draw(const CellId& id, AssetContext& assets, bool allowHDR)
{
    SceneAsset asset = MakeSubject(id, true, {}, assets);
    UseTechnique(asset, RequireTechnique(assets, id.technique), id.width, assets);
    asset.camera.allowHDR = allowHDR;
    return StudyPicture(std::move(asset), assets, m_Device).Alpha();
}

CellResult NumericalBench::Measure(const CellId& id)
{
    if (!IsShape(id.subject) || std::ranges::count(NumericalVariants(), id.variant) == 0)
    {
        throw ContractError(id.Name() + ": its subject or its variant is not known");
    }
    if (const std::string why = WhyNotDrawn(id, m_Assets); !why.empty())
    {
        return {id, {}, {}, {why}};
    }
    const Twin twin = FindTwin(id.technique);
    if (id.variant.empty() && !twin)
    {
        return {id, {}, {}, {"no twin: nothing repeats its arithmetic in double precision"}};
    }
    try
    {
        AssetsFor(id.variant);
    }
    catch (const ContractError& error) // the device lacks something
    {
        return {id, {}, {}, {std::string("not drawn: ") + error.what()}};
    }
    const bool isSmall = id.variant == k_SmallTarget;
    const Coverage drawn = Draw(id, AssetsFor(id.variant), !isSmall);
    if (id.variant.empty())
    {
        return {id, DifferenceOf(drawn, DrawTwin(twin, id, CornerGrid(m_Device)))};
    }
    Coverage usual = Draw(id, m_Assets, true);
    if (isSmall)
    {
        std::ranges::transform(usual.values, usual.values.begin(),
                               [](double value) { return std::min(value, 1.0); });
    }
    return {
        id, DifferenceOf(drawn, usual), {}, {"the difference between two pictures of the device"}};
}

} // namespace limn::study
