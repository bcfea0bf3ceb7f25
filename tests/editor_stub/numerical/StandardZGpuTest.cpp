#include "Mentions.h"
#include "NumericalRun.h"

#include "Paths.h"

#include <cmath>
#include <cstring>
#include <limn/core/DrawError.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/editor_stub/Overrides.h>

namespace limn::study
{
namespace
{

/// The scene of the article on selection, small, with a technique.
Image DrawSelection(const Technique& technique, const std::vector<std::string>& changes,
                    bool isReversed)
{
    AssetContext& assets = AssetsWithDepth(isReversed);
    SceneAsset asset =
        LoadScene(test::SourcePath("samples/selection/selection.scene.yaml"), assets);
    MarkOutlined(asset);
    UseTechnique(asset, technique, 3.0, assets);
    ApplyOverrides(asset, changes, assets);
    asset.width = 96;
    asset.height = 60;
    return StudyPicture(std::move(asset), assets, NumericalDevice()).Output();
}

/// How many pixels differ by more than one step of 8 bits in a channel.
int CountDifferent(const Image& a, const Image& b)
{
    int count = 0;
    for (std::size_t i = 0; i < a.texels.size(); i += 4)
    {
        bool differs = false;
        for (std::size_t channel = 0; channel < 4; ++channel)
        {
            differs = differs || std::abs(std::to_integer<int>(a.texels[i + channel]) -
                                          std::to_integer<int>(b.texels[i + channel])) > 1;
        }
        count += differs ? 1 : 0;
    }
    return count;
}

TEST(StandardZGpu, GivesThePictureOfReversedZWithEachTechnique)
{
    for (const Technique& technique : AssetsWithDepth(true).features().techniques())
    {
        std::vector<std::vector<std::string>> variants = {{}};
        if (technique.component == "StrokeOutline" || technique.component == "WideOutline")
        {
            variants.push_back({"Outline.m_Occlusion=Visible"});
        }
        for (const auto& changes : variants)
        {
            SCOPED_TRACE(technique.name + (changes.empty() ? "" : ", " + changes.front()));
            EXPECT_LE(CountDifferent(DrawSelection(technique, changes, true),
                                     DrawSelection(technique, changes, false)),
                      96 * 60 / 1000);
        }
    }
    EXPECT_TRUE(NumericalDevice().validationMessages().empty());
}

constexpr double k_Near = 1e-3f; // as a float has it
constexpr double k_Far = 1e5;
constexpr int k_Tiles = 32;

/// From 0.002 to 50 000 m.
double DistanceOf(int tile)
{
    return 0.002 * std::pow(2.5e7, tile / (k_Tiles - 1.0));
}

/// What the depth buffer says of squares side by side, each at a distance of its own.
std::vector<double> DrawnDepths(bool isReversed)
{
    AssetContext& assets = AssetsWithDepth(isReversed);
    SceneAsset asset = EmptyPicture(k_Tiles, 1);
    asset.camera.transform.localPosition = glm::vec3(0.0f);
    asset.camera.orthographic = false;
    asset.camera.fieldOfView = 90.0f;
    asset.camera.nearClipPlane = static_cast<float>(k_Near);
    asset.camera.farClipPlane = static_cast<float>(k_Far);
    for (int tile = 0; tile < k_Tiles; ++tile)
    {
        // A pixel is twice as wide as it is far away.
        const double distance = DistanceOf(tile);
        GameObject& object =
            AddOutlined(asset, std::to_string(tile), CreatePrimitive(PrimitiveType::Quad), assets);
        object.transform.localPosition =
            glm::vec3(glm::dvec3(distance * (2.0 * tile + 1.0 - k_Tiles), 0.0, distance));
        object.transform.localScale = glm::vec3(glm::dvec3(2.0 * distance));
    }
    RenderRequest request;
    request.scene = &asset.scene;
    request.camera = &asset.camera;
    request.width = k_Tiles;
    request.height = 1;
    request.compile.leavesOut = false;
    UniversalRenderPipeline pipeline(NumericalDevice());
    UniversalRenderer renderer(assets.compiler());
    const RenderResult first = pipeline.RenderSingleCamera(renderer, request);
    for (const CompiledRenderPass& pass : first.frame->passes)
    {
        if (pass.depth)
        {
            request.alsoReadBack = {RTHandle(pass.depth->texture)};
        }
    }
    pipeline.RenderSingleCamera(renderer, request);
    const Image image = NumericalDevice().ReadBack(*request.alsoReadBack.at(0).rt());
    std::vector<float> texels(k_Tiles);
    std::memcpy(texels.data(), image.texels.data(), texels.size() * sizeof(float));
    return {texels.begin(), texels.end()};
}

double ExactDepth(double distance, bool isReversed)
{
    const double nearness = k_Near * (k_Far - distance) / (distance * (k_Far - k_Near));
    return isReversed ? nearness : 1.0 - nearness;
}

/// Inverse of ExactDepth, metres.
double DistanceAt(double depth, bool isReversed)
{
    const double nearness = isReversed ? depth : 1.0 - depth;
    return k_Near * k_Far / (nearness * (k_Far - k_Near) + k_Near);
}

/// From a float to the next.
double StepAt(double depth)
{
    const auto rounded = static_cast<float>(depth);
    return static_cast<double>(std::nextafter(rounded, 2.0f)) - static_cast<double>(rounded);
}

TEST(StandardZGpu, LosesFarAwayWhatReversedZKeeps)
{
    const std::vector<double> reversed = DrawnDepths(true);
    const std::vector<double> standard = DrawnDepths(false);
    double worstReversed = 0.0;
    double worstStandard = 0.0;
    for (std::size_t tile = 0; tile < k_Tiles; ++tile)
    {
        const double distance = DistanceOf(static_cast<int>(tile));
        SCOPED_TRACE(distance);
        // The matrix, z, w and their quotient are rounded.
        const double exactReversed = ExactDepth(distance, true);
        EXPECT_NEAR(reversed[tile], exactReversed, 4.0 * StepAt(exactReversed));
        const double exactStandard = ExactDepth(distance, false);
        EXPECT_NEAR(standard[tile], exactStandard, 4.0 * StepAt(exactStandard));
        // What that is in metres: a step of a depth near 1 is 6e-8, and grows with distance^2.
        const double fromReversed = std::abs(DistanceAt(reversed[tile], true) / distance - 1.0);
        const double fromStandard = std::abs(DistanceAt(standard[tile], false) / distance - 1.0);
        worstReversed = std::max(worstReversed, fromReversed);
        worstStandard = std::max(worstStandard, fromStandard);
    }
    EXPECT_LT(worstReversed, 5e-7);
    EXPECT_GT(worstStandard, 0.5) << "half the distance is lost";
}

TEST(StandardZGpu, TakesNoShaderOfTheOtherDirection)
{
    AssetContext& assets = AssetsWithDepth(true);
    SceneAsset asset = EmptyPicture(8, 8);
    AddOutlined(asset, "ball", CreatePrimitive(PrimitiveType::Sphere), assets);
    StudyPicture picture(std::move(asset), AssetsWithDepth(false), NumericalDevice());
    try
    {
        picture.Render();
        FAIL();
    }
    catch (const DrawError& error)
    {
        EXPECT_THAT(error.what(), test::Mentions("shader 'Universal Render Pipeline/Unlit'",
                                                 "1 near", "0 near", "shaderCompiler()"));
    }
}

} // namespace
} // namespace limn::study
