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

/// The data of each class of a table that filtering and the order of draws need.
struct BatchOrder
{
    /// The rank of each class in the order of OptimizeStateChanges.
    std::vector<std::uint32_t> ranks;
    /// The first class that draws the same as a class, by class, once layers and masks have been
    /// filtered.
    std::vector<std::uint32_t> firsts;
    int rankBits = 0; ///< the number of bits that the ranks take
    /// A number by class for what filtering looks at. Many classes share one, since they differ
    /// only in the mesh.
    std::vector<std::uint32_t> looks;
    std::vector<std::uint32_t> classOfLook; ///< a class for each of these numbers

    void Update(const RendererTable& table);
};

/// Returns numbers 0, 1 ... in the order of `values`, equal ones for equal values.
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

/// The key by which OptimizeStateChanges groups draws: first the shader, then the material, then
/// the mesh.
using StateId = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;

inline StateId StateOf(const Material* material, const Mesh* mesh)
{
    return {material ? material->shader()->id() : 0, material ? material->id() : 0,
            mesh ? mesh->id() : 0};
}

} // namespace limn
