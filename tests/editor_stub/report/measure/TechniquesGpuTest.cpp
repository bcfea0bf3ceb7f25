#include "CachedCompiler.h"
#include "editor_stub/report/measure/UntidyScene.h"
#include "report/measure/StudyBench.h"

#include <cctype>
#include <gtest/gtest.h>
#include <limn/features/StrokeOutlineRendererFeature.h>
#include <limn/vulkan/VulkanDevice.h>
#include <numbers>
#include <optional>

namespace limn::study
{
namespace
{

VulkanDevice& Device()
{
    static VulkanDevice device({"", true, {}});
    return device;
}

AssetContext& Assets()
{
    static AssetContext assets(test::CachedCompiler());
    return assets;
}

std::string NameOf(const testing::TestParamInfo<const Technique*>& info)
{
    std::string name;
    for (const char letter : info.param->name)
    {
        name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? std::string(1, letter) : "";
    }
    return name;
}

std::vector<const Technique*> AllTechniques()
{
    std::vector<const Technique*> all;
    for (const Technique& technique : Assets().features().techniques())
    {
        all.push_back(&technique);
    }
    return all;
}

class EachTechniqueGpu : public testing::TestWithParam<const Technique*>
{
};

/// A ball, for techniques that look at normals, before a camera that sees a unit a pixel.
SceneAsset Ball()
{
    SceneAsset asset = EmptyPicture(96, 64);
    AddOutlined(asset, "ball", CreatePrimitive(PrimitiveType::Sphere), Assets())
        .transform.localScale = glm::vec3(36.0f);
    return asset;
}

TEST_P(EachTechniqueGpu, DrawsWhiteOnBlackAroundWhatIsOutlined)
{
    SceneAsset asset = Ball();
    UseTechnique(asset, *GetParam(), 4.0, Assets());
    StudyPicture picture(std::move(asset), Assets(), Device());
    const Coverage alpha = picture.Alpha();
    const double perimeter = 2.0 * std::numbers::pi * 18.0;
    EXPECT_EQ(alpha.At(2, 2), 0.0);
    EXPECT_LT(alpha.Sum(), 12.0 * perimeter);
    if (GetParam()->name == "Color edges")
    {
        EXPECT_EQ(alpha.Sum(), 0.0) << "nothing differs from anything in a black picture";
    }
    else
    {
        EXPECT_GT(alpha.Sum(), 2.0 * perimeter);
    }
}

TEST_P(EachTechniqueGpu, IsRefusedAWidthThatIsNoNumber)
{
    SceneAsset asset = Ball();
    EXPECT_THROW(UseTechnique(asset, *GetParam(), std::nan(""), Assets()), AssetError);
}

/// The mean error that a technique's README states for an outline of 8 pixels of such meshes; none
/// where it states none.
std::optional<double> StatedError(const std::string& technique, PrimitiveType type,
                                  Untidiness untidiness)
{
    if (technique == "Strokes") // the last two kinds have tips sharper than a pixel
    {
        return untidiness < Untidiness::Open ? 0.002 : 0.004;
    }
    // wide_outline/README.md, the largest of its row for 8 pixels; parts thinner than a hair, as
    // fins have them, fall between its samples. Auto is strokes or this.
    if ((technique == "Separable" || technique == "Jump flood" || technique == "Auto") &&
        untidiness != Untidiness::Fins)
    {
        return 0.032;
    }
    // translucent_outline/README.md: a closed, smooth mesh, faces turned the right way.
    const bool isTurned =
        untidiness == Untidiness::OneTriangleTurned || untidiness == Untidiness::OneFaceTurned ||
        untidiness == Untidiness::TurnedAtRandom || untidiness == Untidiness::Soup;
    if (technique == "Inflated" && type == PrimitiveType::Sphere && !isTurned &&
        untidiness < Untidiness::Open)
    {
        return (0.25 + 2.0 * 1.27 * 0.25) / 9.0;
    }
    return std::nullopt;
}

double ErrorOf(const Technique& technique, PrimitiveType type, Untidiness untidiness)
{
    constexpr double k_Width = 8.0; // pixels
    const SceneAsset model = test::TidyScene(type, untidiness, Assets());
    SceneAsset asset = test::UntidyScene(type, untidiness, Assets());
    UseTechnique(asset, technique, k_Width, Assets());
    return ScoreOutline(StudyPicture(std::move(asset), Assets(), Device()).Alpha(),
                        ExactOutlineCoverage(OutlinedSilhouette(model), {k_Width}, model.width,
                                             model.height))
        .meanAbsoluteError;
}

TEST(TechniquesGpu, HoldTheirStatedErrorsForEveryKindOfMesh)
{
    std::size_t checked = 0;
    for (const Technique& technique : Assets().features().techniques())
    {
        for (const PrimitiveType type :
             {PrimitiveType::Cube, PrimitiveType::Torus, PrimitiveType::Sphere})
        {
            for (std::size_t i = 0; i < k_UntidinessNames.size(); ++i)
            {
                const auto untidiness = static_cast<Untidiness>(i);
                const auto stated = StatedError(technique.name, type, untidiness);
                if (stated)
                {
                    EXPECT_LE(ErrorOf(technique, type, untidiness), *stated)
                        << technique.name << ", " << k_UntidinessNames[i] << ", "
                        << static_cast<int>(type);
                    ++checked;
                }
            }
        }
    }
    // Strokes: all 12 kinds; three techniques: all but fins; the hull: 6 kinds of a ball.
    EXPECT_EQ(checked, 3u * 12 + 3 * 3 * 11 + 6);
}

TEST(TechniquesGpu, OfAFeatureThatIsNotLimnsAreMeasuredByWhatItRegisters)
{
    AssetContext assets(test::CachedCompiler());
    Technique own;
    own.name = "Own";
    own.component = "StrokeOutline";
    own.settings = {"Outline.m_Grouping=Together"};
    assets.features().Register<StrokeOutlineRendererFeature>("OwnFeature", {own});
    StudyBench bench("", "", assets, Device());
    const CellId cell{CellKind::Geometry, "own", "disc", 4.0, 64, 48, ""};
    CellId strokes = cell;
    strokes.technique = "Strokes";
    EXPECT_EQ(bench.Measure(cell).values, bench.Measure(strokes).values);
    CellId unknown = cell;
    unknown.technique = "Crayon";
    EXPECT_THROW(bench.Measure(unknown), ContractError);
}

INSTANTIATE_TEST_SUITE_P(Catalog, EachTechniqueGpu, testing::ValuesIn(AllTechniques()), NameOf);

} // namespace
} // namespace limn::study
