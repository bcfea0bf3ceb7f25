#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "renderers/SortItems.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using testing::ElementsAre;

TEST(SortingCriteria, HasUnitysNumbers)
{
    EXPECT_EQ(static_cast<int>(SortingCriteria::CommonOpaque), 59);
    EXPECT_EQ(static_cast<int>(SortingCriteria::CommonTransparent), 23);
    using enum SortingCriteria;
    EXPECT_EQ(CommonOpaque, SortingLayer | RenderQueue | QuantizedFrontToBack |
                                OptimizeStateChanges | CanvasOrder);
    EXPECT_EQ(CommonTransparent, SortingLayer | RenderQueue | BackToFront | OptimizeStateChanges);
}

/// Items at given places, sorted from a camera at the origin that looks along +z.
class Sorting : public testing::Test
{
protected:
    void Add(const glm::vec3& center, int queue = 2000,
             std::shared_ptr<const Material> material = nullptr)
    {
        RendererItem item;
        item.object = &test::AddCube(m_Scene, "cube", center, {});
        item.material = material ? std::move(material) : m_Material;
        item.filter.renderQueue = queue;
        item.boundsCenter = center;
        m_Items.push_back(std::move(item));
    }
    std::vector<int> SortBy(SortingCriteria criteria,
                            DistanceMetric metric = DistanceMetric::Perspective,
                            const glm::vec3& axis = {0, 0, 1})
    {
        std::vector<int> indices(m_Items.size());
        std::iota(indices.begin(), indices.end(), 0);
        SortingSettings settings;
        settings.criteria = criteria;
        settings.distanceMetric = metric;
        settings.customAxis = axis;
        test::SortItems(m_Items, settings, indices);
        return indices;
    }

    const std::shared_ptr<const Material> m_Material =
        std::make_shared<Material>(test::ShaderWithModes({"A"}));
    Scene m_Scene;
    std::vector<RendererItem> m_Items;
};

TEST_F(Sorting, KeepsTheScenesOrderWithoutCriteria)
{
    Add({0, 0, 9}, 3000);
    Add({0, 0, 1}, 1000);
    EXPECT_THAT(SortBy(SortingCriteria::None), ElementsAre(0, 1));
}

TEST_F(Sorting, GoesByQueueBeforeDistance)
{
    Add({0, 0, 1}, 3000);
    Add({0, 0, 100}, 2000);
    Add({0, 0, 10}, 2450);
    EXPECT_THAT(SortBy(SortingCriteria::CommonOpaque), ElementsAre(1, 2, 0));
    EXPECT_THAT(SortBy(SortingCriteria::CommonTransparent), ElementsAre(1, 2, 0));
}

TEST_F(Sorting, DrawsTransparentObjectsFromBackToFront)
{
    Add({0, 0, 2.0f});
    Add({0, 0, 2.01f});
    Add({0, 0, 1.0f});
    EXPECT_THAT(SortBy(SortingCriteria::CommonTransparent), ElementsAre(1, 0, 2));
}

TEST_F(Sorting, DrawsOpaqueObjectsFromFrontToBack)
{
    Add({0, 0, 100});
    Add({0, 0, 1});
    Add({0, 0, 10});
    EXPECT_THAT(SortBy(SortingCriteria::CommonOpaque), ElementsAre(1, 2, 0));
}

TEST_F(Sorting, CountsDistancesOfTheSameEighthOfAnOctaveAsEqual)
{
    // 8 * log2: 17 is in step 32 (16 ... 17.448), 16.5 too, 18 in the next.
    Add({0, 0, 18});
    Add({0, 0, 17});
    Add({0, 0, 16.5f});
    EXPECT_THAT(SortBy(SortingCriteria::QuantizedFrontToBack), ElementsAre(1, 2, 0));
}

TEST_F(Sorting, KeepsEqualItemsInTheScenesOrder)
{
    for (int i = 0; i < 5; ++i)
    {
        Add({0, 0, 10});
    }
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront), ElementsAre(0, 1, 2, 3, 4));
    EXPECT_THAT(SortBy(SortingCriteria::QuantizedFrontToBack), ElementsAre(0, 1, 2, 3, 4));
}

TEST_F(Sorting, BringsEqualMaterialsTogether)
{
    const auto other = std::make_shared<Material>(m_Material->shader());
    Add({0, 0, 10}, 2000, other);
    Add({0, 0, 10}, 2000, m_Material);
    Add({0, 0, 10}, 2000, other);
    Add({0, 0, 10}, 2000, m_Material);
    EXPECT_THAT(SortBy(SortingCriteria::OptimizeStateChanges), ElementsAre(1, 3, 0, 2));
}

TEST_F(Sorting, MeasuresFromTheCameraOrAlongItsView)
{
    Add({10, 0, 1});
    Add({0, 0, 5});
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront), ElementsAre(0, 1));
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront, DistanceMetric::Orthographic),
                ElementsAre(1, 0));
}

// As Unity's games seen from above do it: what is higher up is behind.
TEST_F(Sorting, MeasuresAlongACustomAxisWhereverTheCameraLooks)
{
    Add({0, -2, 9});
    Add({5, 1, 1});
    Add({-5, 3, 4});
    constexpr auto k_Custom = DistanceMetric::CustomAxis;
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront, k_Custom, {0, 1, 0}), ElementsAre(2, 1, 0));
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront, k_Custom, {0, -0.5f, 0}),
                ElementsAre(0, 1, 2));
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront, k_Custom, {1, 0, 0}), ElementsAre(1, 0, 2));
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront, k_Custom, {0, 0, 0}), ElementsAre(0, 1, 2))
        << "all are equal";
}

TEST_F(Sorting, OrdersPlacesBehindAnOrthographicCamera)
{
    Add({0, 0, -5});
    Add({0, 0, 5});
    Add({0, 0, -1});
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront, DistanceMetric::Orthographic),
                ElementsAre(1, 2, 0));
}

TEST_F(Sorting, PutsPlacesThatAreNoNumbersAtTheFarEnd)
{
    constexpr float k_Nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float k_Infinity = std::numeric_limits<float>::infinity();
    Add({0, 0, 10});
    Add({k_Nan, 0, 0});
    Add({0, 0, 5});
    Add({k_Infinity, 0, 0});
    EXPECT_THAT(SortBy(SortingCriteria::BackToFront), ElementsAre(1, 3, 0, 2));
    EXPECT_THAT(SortBy(SortingCriteria::QuantizedFrontToBack), ElementsAre(2, 0, 1, 3));
}

TEST_F(Sorting, OrdersOnlyTheItemsThatTakePart)
{
    Add({0, 0, 1});
    Add({0, 0, 2});
    Add({0, 0, 3});
    std::vector<int> indices{0, 2};
    SortingSettings settings;
    settings.criteria = SortingCriteria::BackToFront;
    test::SortItems(m_Items, settings, indices);
    EXPECT_THAT(indices, ElementsAre(2, 0));
}

} // namespace
} // namespace limn
