#include "renderers/ManyRenderers.h"
#include "renderers/ObjectDraws.h"
#include "renderers/SortItems.h"

#include <numeric>

namespace limn
{
namespace
{

TEST_F(ManyRenderers, AreJudgedTogetherAsOneByOne)
{
    for (int i = 0; i < 300; ++i)
    {
        Add();
        Change();
    }
    SeeEverything();
    const RendererItems items = Cull(m_Scene, m_Camera, 1.0f).items;
    ASSERT_GT(items.size(), 100u);
    for (int round = 0; round < 50; ++round)
    {
        const FilteringSettings filtering(RenderQueueRange{1900 + Number(300), 2100 + Number(2000)},
                                          LayerMask(Bits()), RenderingLayerMask(Bits()));
        DrawingSettings drawing;
        drawing.shaderTagIds = {ShaderTagId(Number(4) == 0 ? "B" : "A")};
        FilterCounts counts{};
        std::vector<const Material*> drawn;
        for (const RendererItem& item : items)
        {
            const FilterVerdict verdict = Judge(item.filter, filtering, drawing);
            ++counts[static_cast<std::size_t>(verdict)];
            if (verdict == FilterVerdict::Drawn)
            {
                drawn.push_back(item.material.get());
            }
        }
        const JudgedItems judged = Judge(items, filtering, drawing);
        EXPECT_EQ(judged.counts, counts);
        std::vector<const Material*> together;
        for (const RendererItem& item : judged.drawn)
        {
            together.push_back(item.material.get());
        }
        EXPECT_EQ(together, drawn);
    }
}

TEST_F(ManyRenderers, AreCountedHoweverManyThereAre)
{
    for (int i = 0; i < 9000; ++i)
    {
        GameObject& object = m_Scene.Add("object");
        object.layer = i % 3;
        object.renderer = MeshRenderer{test::Cube(), {m_Materials.front()}};
    }
    SeeEverything();
    const RendererItems items = Cull(m_Scene, m_Camera, 1.0f).items;
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("A")};
    const FilteringSettings first(RenderQueueRange::all, LayerMask(1u));
    const FilteringSettings all(RenderQueueRange::all, LayerMask(7u));
    EXPECT_EQ(Judge(items, first, drawing).counts, (FilterCounts{3000, 0, 6000, 0, 0}));
    EXPECT_EQ(Judge(items, all, drawing).counts, (FilterCounts{9000, 0, 0, 0, 0}));
}

/// Expects that items are in the order of a list of them, by whatever they are sorted.
void ExpectOneOrder(const RendererItems& items)
{
    std::vector<RendererItem> list;
    for (const RendererItem& item : items)
    {
        list.push_back(item);
    }
    for (int criteria = 0; criteria < 64; ++criteria)
    {
        SortingSettings sorting;
        sorting.criteria = static_cast<SortingCriteria>(criteria);
        sorting.distanceMetric =
            criteria % 3 == 0 ? DistanceMetric::Orthographic : DistanceMetric::Perspective;
        RendererItems together = items;
        SortIntoRuns(together, sorting);
        std::vector<int> order(list.size());
        std::iota(order.begin(), order.end(), 0);
        test::SortItems(list, sorting, order);
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            const RendererItem& item = list[static_cast<std::size_t>(order[i])];
            ASSERT_EQ(together[i].object, item.object)
                << "criteria " << criteria << ", place " << i;
            ASSERT_EQ(together[i].materialIndex, item.materialIndex);
        }
    }
}

TEST_F(ManyRenderers, AreSortedTogetherAsAListOfThemIs)
{
    for (int i = 0; i < 300; ++i)
    {
        Add();
        Any().transform.localPosition = glm::vec3(0, 0, Number(20)); // many at equal distances
    }
    SeeEverything();
    ExpectOneOrder(Cull(m_Scene, m_Camera, 1.0f).items);
}

TEST_F(ManyRenderers, AreSortedAsAListWhereFewOfManyKindsAre)
{
    for (int i = 0; i < 300; ++i)
    {
        Add();
        Any().transform.localPosition = glm::vec3(0, 0, Number(5));
    }
    for (std::uint32_t i = 0; i < 300; ++i)
    {
        m_Scene.objects()[i]->renderer->renderingLayerMask = RenderingLayerMask(2 * i);
    }
    for (const std::size_t i : {9u, 37u, 38u, 150u, 151u, 299u})
    {
        MeshRenderer& renderer = *m_Scene.objects()[i]->renderer;
        renderer.renderingLayerMask.bits |= 1;
        renderer.sharedMaterials = {m_Materials[0], m_Materials[i % 4]};
    }
    SeeEverything();
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("A")};
    const JudgedItems judged = Judge(
        Cull(m_Scene, m_Camera, 1.0f).items,
        FilteringSettings(RenderQueueRange::all, LayerMask::Everything(), RenderingLayerMask(1)),
        drawing);
    ASSERT_EQ(judged.drawn.size(), 12u);
    ASSERT_GT(judged.drawn.table()->classes().size(), 200u);
    ExpectOneOrder(judged.drawn);
}

} // namespace
} // namespace limn
