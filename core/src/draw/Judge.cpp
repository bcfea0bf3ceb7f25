#include "scene/RendererTable.h"

#include <algorithm>
#include <functional>
#include <limn/core/Culling.h>
#include <limn/core/Shader.h>
#include <numeric>

namespace limn
{

const char* ToString(FilterVerdict verdict)
{
    switch (verdict)
    {
    case FilterVerdict::Drawn:
        return "drawn";
    case FilterVerdict::QueueOutOfRange:
        return "render queue";
    case FilterVerdict::LayerMaskMiss:
        return "layer mask";
    case FilterVerdict::RenderingLayerMaskMiss:
        return "rendering layer mask";
    case FilterVerdict::NoMatchingPass:
        return "no pass with a wanted LightMode";
    }
    return "?";
}

FilterVerdict Judge(const FilterItem& item, const FilteringSettings& filtering,
                    const DrawingSettings& drawing)
{
    const FilterVerdict masks = JudgeMasks(item, filtering);
    if (masks != FilterVerdict::Drawn)
    {
        return masks;
    }
    for (const ShaderTagId tag : drawing.shaderTagIds)
    {
        if (item.shader->FindPassByLightMode(tag) >= 0)
        {
            return FilterVerdict::Drawn;
        }
    }
    return FilterVerdict::NoMatchingPass;
}

JudgedItems Judge(const RendererItems& items, const FilteringSettings& filtering,
                  const DrawingSettings& drawing)
{
    JudgedItems judged;
    if (items.empty())
    {
        return judged;
    }
    const RendererTable& table = *items.table();
    static thread_local std::vector<std::uint8_t> verdicts; // by class
    verdicts.clear();
    for (const RendererTable::RowClass& kind : table.classes())
    {
        verdicts.push_back(static_cast<std::uint8_t>(
            kind.material ? Judge(kind.item(), filtering, drawing) : FilterVerdict::Drawn));
    }
    std::vector<std::uint32_t> drawn = table.spareRows().Take(items.size());
    // Counted in turns: a counter that was just written is not ready to be read.
    constexpr std::size_t k_Turns = 4;
    std::array<std::array<int, k_FilterVerdictCount>, k_Turns> counts{};
    std::size_t count = 0;
    const std::uint32_t* classOf = table.classOf().data();
    const std::uint8_t* verdictOf = verdicts.data();
    const std::vector<std::uint32_t>& rows = items.rows();
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const std::uint8_t verdict = verdictOf[classOf[rows[i]]];
        ++counts[i % k_Turns][verdict];
        drawn[count] = rows[i];
        count += verdict == static_cast<std::uint8_t>(FilterVerdict::Drawn);
    }
    for (const auto& turn : counts)
    {
        std::ranges::transform(turn, judged.counts, judged.counts.begin(), std::plus());
    }
    drawn.resize(count);
    judged.drawn = RendererItems(items.table(), std::move(drawn));
    return judged;
}

std::string Describe(const FilterCounts& counts, const FilteringSettings& filtering)
{
    const int total = std::accumulate(counts.begin(), counts.end(), 0);
    std::string text = std::to_string(counts[0]) + " of " + std::to_string(total) +
                       (total == 1 ? " renderer drawn" : " renderers drawn");
    const char* separator = ": ";
    for (std::size_t i = 1; i < counts.size(); ++i)
    {
        if (counts[i] != 0)
        {
            text += separator + std::to_string(counts[i]) + ' ' +
                    ToString(static_cast<FilterVerdict>(i));
            separator = ", ";
        }
    }
    if (total == 0)
    {
        text += ": the camera sees no renderer at all";
    }
    if (filtering.layerMask == LayerMask::Nothing())
    {
        text += "; the filter's layerMask is 0 (Nothing)";
    }
    if (filtering.renderingLayerMask == RenderingLayerMask::Nothing())
    {
        text += "; the filter's renderingLayerMask is 0 (Nothing)";
    }
    return text;
}

} // namespace limn
