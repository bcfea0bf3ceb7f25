#include <algorithm>
#include <limn/features/OutlinedObjects.h>
#include <unordered_map>

namespace limn
{

namespace
{

const Transform* RootOf(const Transform& transform)
{
    const Transform* root = &transform;
    while (root->parent != nullptr)
    {
        root = root->parent;
    }
    return root;
}

} // namespace

bool IsAlphaTested(const Material& material)
{
    constexpr RenderQueueRange k_AlphaTest(2450, 2500);
    return material.IsKeywordEnabled("_ALPHATEST_ON") ||
           k_AlphaTest.Contains(material.renderQueue());
}

OutlinedObjects FindOutlinedObjects(const RenderingData& renderingData,
                                    const OutlineSettings& settings, OutlineGrouping grouping)
{
    DrawingSettings drawing;
    drawing.shaderTagIds.assign(ForwardShaderTags().begin(), ForwardShaderTags().end());
    const FilteringSettings filtering = settings.filtering();
    const JudgedItems judged = Judge(renderingData.cullResults.items, filtering, drawing);
    if (renderingData.report != nullptr)
    {
        renderingData.report->filters.push_back({{}, filtering, drawing, judged.counts});
    }

    OutlinedObjects found;
    std::unordered_map<const void*, int> groups;
    for (const RendererItem& item : judged.drawn)
    {
        const void* key = grouping == OutlineGrouping::Together ? nullptr
                          : grouping == OutlineGrouping::PerGroup
                              ? static_cast<const void*>(RootOf(item.object->transform))
                              : item.object;
        const auto [group, isNew] = groups.try_emplace(key, found.groupCount);
        found.groupCount += isNew;
        found.objects.push_back({item, group->second});
    }
    std::ranges::stable_sort(found.objects, {}, &OutlinedObject::group);
    if (found.objects.empty())
    {
        found.why = Describe(judged.counts, filtering);
    }
    return found;
}

} // namespace limn
