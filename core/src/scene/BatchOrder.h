#pragma once

#include <algorithm>
#include <cstdint>
#include <limn/core/Material.h>
#include <limn/core/Mesh.h>
#include <tuple>
#include <vector>

namespace limn
{

class RendererTable;

/// What judging and the order of draws need to know of each class of a table.
struct BatchOrder
{
    /// By class: its rank by what OptimizeStateChanges brings together.
    std::vector<std::uint32_t> ranks;
    /// By class: the first that draws the same, layers and masks having been looked at before.
    std::vector<std::uint32_t> firsts;
    int rankBits = 0; ///< that the ranks take
    /// By class: a number for what filtering looks at, which many classes share: they differ in the
    /// mesh.
    std::vector<std::uint32_t> looks;
    std::vector<std::uint32_t> classOfLook; ///< one of them

    void Update(const RendererTable& table);
};

/// Numbers 0, 1 ... in the order of `values`, equal ones for equal values.
template <typename Value>
std::vector<std::uint32_t> Ranks(const std::vector<Value>& values)
{
    std::vector<Value> sorted = values;
    std::ranges::sort(sorted);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    std::vector<std::uint32_t> ranks;
    for (const Value& value : values)
    {
        ranks.push_back(
            static_cast<std::uint32_t>(std::ranges::lower_bound(sorted, value) - sorted.begin()));
    }
    return ranks;
}

/// What OptimizeStateChanges brings together: first the shader, then the material, then the mesh.
using StateId = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;

inline StateId StateOf(const Material* material, const Mesh* mesh)
{
    return {material ? material->shader()->id() : 0, material ? material->id() : 0,
            mesh ? mesh->id() : 0};
}

} // namespace limn
