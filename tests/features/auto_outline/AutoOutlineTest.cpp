#include "Mentions.h"
#include "features/outline/TechniquePicture.h"

#include <gmock/gmock.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/RecordingDevice.h>
#include <limn/features/AutoOutlineRendererFeature.h>
#include <random>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A picture of 320 x 240 that nobody draws.
struct AutoPicture
{
    explicit AutoPicture(float width, AutoOutlineSettings settings = {}) : picture(device, 320, 240)
    {
        picture.AddFeature<AutoOutlineRendererFeature>(std::move(settings));
        picture.Enable<AutoOutline>(width);
    }

    const RenderReport& Report() { return picture.Render().report; }

    RecordingDevice device;
    TechniquePicture picture;
};

/// Splinters that lie in a square of 60 pixels, none of which touches another.
ScreenTriangles Splinters(int count)
{
    std::mt19937 random(1);
    const auto number = [&]
    {
        return 130.0 + static_cast<double>(random() % 6000) / 100.0;
    };
    ScreenTriangles triangles;
    for (int i = 0; i < count; ++i)
    {
        const glm::dvec2 p(number(), number());
        triangles.push_back({p, p + glm::dvec2(2.0, 0.3), p + glm::dvec2(0.7, 1.9)});
    }
    return triangles;
}

std::vector<std::string> ChoicesOf(const RenderReport& report)
{
    return {report.choices.begin(), report.choices.end()};
}

TEST(OutlineTechnique, IsChosenByWhatItCosts)
{
    const auto choose = [](double width, double strokeArea, double regionArea, bool isAlphaTested)
    {
        OutlineWork work;
        work.width = width;
        work.strokeArea = strokeArea;
        work.regionArea = regionArea;
        work.isAlphaTested = isAlphaTested;
        return ChooseOutlineTechnique(work).technique;
    };
    // A disc of 400 pixels: 1257 pixels of silhouette in a region of 448 x 448.
    const double disc = 448.0 * 448.0;
    EXPECT_EQ(choose(2.0, 1257.0 * 4.0, disc, false), OutlineTechnique::Strokes);
    EXPECT_EQ(choose(8.0, 1257.0 * 10.0, disc, false), OutlineTechnique::Strokes);
    EXPECT_EQ(choose(64.0, 1257.0 * 66.0, 576.0 * 576.0, false), OutlineTechnique::Strokes);
    // A bush: 20 000 short edges, each with round ends.
    EXPECT_EQ(choose(32.0, 20000.0 * 66.0 * 34.0, disc, false), OutlineTechnique::JumpFlood);
    EXPECT_EQ(choose(3.0, 200000.0 * 8.0 * 5.0, disc, false), OutlineTechnique::Separable);
    // Holes that the mesh does not have.
    EXPECT_EQ(choose(2.0, 1257.0 * 4.0, disc, true), OutlineTechnique::Separable);
    EXPECT_EQ(choose(200.0, 1257.0 * 202.0, disc, true), OutlineTechnique::JumpFlood);
}

TEST(AutoOutline, DrawsASolidObjectWithStrokesAndSaysWhy)
{
    AutoPicture picture(4.0f);
    picture.picture.Add("disc", DiscTriangles({160.0, 120.0}, 50.0));
    const RenderReport& report = picture.Report();
    EXPECT_THAT(report.notes, IsEmpty());
    EXPECT_THAT(ChoicesOf(report), ElementsAre(StartsWith("Outline: Strokes, ")));
}

TEST(AutoOutline, LooksAtAlphaTestedObjectsInsteadOfTheirMeshes)
{
    AutoPicture picture(4.0f);
    GameObject& leaf = picture.picture.Add("leaf", DiscTriangles({160.0, 120.0}, 50.0));
    auto material = std::make_shared<Material>(*leaf.renderer->sharedMaterials.front());
    material->SetRenderQueue(2450);
    leaf.renderer->sharedMaterials = {material};
    EXPECT_THAT(ChoicesOf(picture.Report()),
                ElementsAre(HasSubstr("Separable, a material is alpha-tested")));
}

TEST(AutoOutline, TransformsDistancesWhereThereAreManyShortEdges)
{
    AutoPicture picture(30.0f);
    picture.picture.Add("bush", Splinters(3000));
    EXPECT_THAT(ChoicesOf(picture.Report()), ElementsAre(HasSubstr("JumpFlood, 9000 silhouette")));
}

// Seen askew, a cube is a hexagon. Corners of this one differ by less than two floats near 1 do.
TEST(AutoOutline, CountsTheEdgesOfAMeshThatIsMuchSmallerThanItsObject)
{
    MeshData data = CreatePrimitive(PrimitiveType::Cube)->data();
    for (glm::vec3& vertex : data.vertices)
    {
        vertex *= 1e-9f;
    }
    AutoPicture picture(4.0f);
    GameObject& cube =
        picture.picture.Add("cube", std::make_shared<const Mesh>("cube", std::move(data)));
    cube.transform.localScale = glm::vec3(5e10f); // 50 pixels
    cube.transform.localRotation = EulerToRotation({30.0f, 40.0f, 0.0f});
    EXPECT_THAT(ChoicesOf(picture.Report()), ElementsAre(HasSubstr(" 6 silhouette edges ")));
}

TEST(AutoOutline, DoesAsItIsTold)
{
    for (const auto& [technique, name] :
         {std::pair{OutlineTechnique::Strokes, "Outline: Strokes, as m_Technique requires"},
          {OutlineTechnique::Separable, "Outline: Separable, as m_Technique requires"},
          {OutlineTechnique::JumpFlood, "Outline: JumpFlood, as m_Technique requires"}})
    {
        AutoOutlineSettings settings;
        settings.m_Technique = technique;
        AutoPicture picture(4.0f, settings);
        picture.picture.Add("disc", DiscTriangles({160.0, 120.0}, 50.0));
        EXPECT_THAT(ChoicesOf(picture.Report()), ElementsAre(name));
    }
}

TEST(AutoOutline, ChoosesNothingWhereThereIsNothingToDraw)
{
    AutoOutlineSettings settings;
    settings.m_RenderingLayerMask = 7;
    AutoPicture picture(4.0f, settings);
    picture.picture.Add("disc", DiscTriangles({160.0, 120.0}, 50.0));
    const RenderReport& report = picture.Report();
    EXPECT_THAT(ChoicesOf(report), IsEmpty());
    EXPECT_THAT(report.notes, ElementsAre(Mentions("Outline", "not drawn", "0 of 1",
                                                   "rendering layer mask leaves out 1")));
}

} // namespace
} // namespace limn::test
