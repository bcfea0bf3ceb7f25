#include <algorithm>
#include <functional>
#include <limits>
#include <limn/features/OutlinedObjects.h>

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

const void* GroupOf(const GameObject* object, OutlineGrouping grouping)
{
    return grouping == OutlineGrouping::Together ? nullptr
           : grouping == OutlineGrouping::PerGroup
               ? static_cast<const void*>(RootOf(object->transform))
               : object;
}

/// Numbers the groups in the order of their first objects, and sorts the objects by their group, in
/// their order before within each.
void SortIntoGroups(std::vector<OutlinedObject>& objects, OutlineGrouping grouping)
{
    struct Member
    {
        const void* group;
        std::size_t place;
        std::size_t first; ///< the place of the first object of the group
    };
    // Kept from frame to frame: a steady frame asks for no memory.
    thread_local std::vector<Member> members;
    thread_local std::vector<OutlinedObject> sorted;
    members.clear();
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        members.push_back({GroupOf(objects[i].item.object, grouping), i, i});
    }
    std::ranges::sort(
        members, [](const Member& a, const Member& b)
        { return a.group != b.group ? std::less<>()(a.group, b.group) : a.place < b.place; });
    for (std::size_t i = 1; i < members.size(); ++i)
    {
        if (members[i].group == members[i - 1].group)
        {
            members[i].first = members[i - 1].first;
        }
    }
    std::ranges::sort(members, [](const Member& a, const Member& b)
                      { return a.first != b.first ? a.first < b.first : a.place < b.place; });
    int group = -1;
    sorted.clear();
    for (const Member& member : members)
    {
        group += member.place == member.first ? 1 : 0;
        sorted.push_back({objects[member.place].item, group});
    }
    objects.swap(sorted);
    sorted.clear();
}

} // namespace

bool IsAlphaTested(const Material& material)
{
    constexpr RenderQueueRange k_AlphaTest(2450, 2500);
    return material.IsKeywordEnabled("_ALPHATEST_ON") ||
           k_AlphaTest.Contains(material.renderQueue());
}

void FindOutlinedObjects(const RenderingData& renderingData, const OutlineSettings& settings,
                         OutlineGrouping grouping, OutlinedObjects& found)
{
    DrawingSettings drawing;
    drawing.shaderTagIds.assign(ForwardShaderTags().begin(), ForwardShaderTags().end());
    const FilteringSettings filtering = settings.filtering();
    const JudgedItems judged = Judge(renderingData.cullResults.items, filtering, drawing);
    if (renderingData.report != nullptr)
    {
        renderingData.report->filters.push_back({{}, filtering, drawing, judged.counts});
    }
    found.objects.clear();
    for (const RendererItem& item : judged.drawn)
    {
        found.objects.push_back({item, 0});
    }
    SortIntoGroups(found.objects, grouping);
    found.why = found.objects.empty() ? Describe(judged.counts, filtering) : "";
}

void FindGroupsByDepth(const OutlinedObjects& found, const glm::dmat4& viewMatrix,
                       std::vector<OutlinedGroup>& groups)
{
    groups.clear();
    ForEachGroup(found.objects,
                 [&](std::span<const OutlinedObject> objects)
                 {
                     double depth = std::numeric_limits<double>::infinity();
                     for (const OutlinedObject& object : objects)
                     {
                         const glm::dvec4 middle(object.item.boundsCenter, 1.0);
                         depth = std::min(depth, -(viewMatrix * middle).z);
                     }
                     groups.push_back({objects, depth});
                 });
    std::ranges::sort(
        groups, [](const OutlinedGroup& a, const OutlinedGroup& b)
        { return a.depth != b.depth ? a.depth > b.depth : a.objects.data() < b.objects.data(); });
}

} // namespace limn
