#include "scene/BatchOrder.h"

#include "scene/RendererTable.h"

#include <bit>

namespace limn
{

void BatchOrder::Update(const RendererTable& table)
{
    std::vector<StateId> ids;
    std::map<std::tuple<const Material*, const MaterialPropertyBlock*, std::uint32_t, bool, bool>,
             std::uint32_t>
        known;
    std::map<std::tuple<const Material*, int, std::uint32_t>, std::uint32_t> knownLooks;
    firsts.clear();
    looks.clear();
    classOfLook.clear();
    for (const RendererTable::DrawKey& own : table.classes())
    {
        const Material* material = own.material.get();
        ids.push_back(StateOf(material, table.meshParts()[own.meshPart].mesh.get()));
        const auto first = known.try_emplace(
            {material, own.properties.get(), own.meshPart, own.isMirrored, own.isAgain},
            static_cast<std::uint32_t>(firsts.size()));
        const auto look = knownLooks.try_emplace({material, own.layer, own.renderingLayerMask.bits},
                                                 static_cast<std::uint32_t>(classOfLook.size()));
        if (look.second)
        {
            classOfLook.push_back(static_cast<std::uint32_t>(firsts.size()));
        }
        looks.push_back(look.first->second);
        firsts.push_back(first.first->second);
    }
    ranks = Ranks(ids);
    rankBits =
        ranks.empty() ? 0 : static_cast<int>(std::bit_width(*std::ranges::max_element(ranks)));
}

} // namespace limn
