#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limn/features/OutlineTechnique.h>
#include <utility>

namespace limn
{

namespace
{

// The cost of a pixel in reads of a texture (1.2 ns), from the times of outline_benchmark on
// lavapipe with two cores.
constexpr double k_ReadsOfStroke = 15.0;
constexpr double k_ReadsOfOwnDepth = 7.0; ///< and the composite
constexpr double k_ReadsOfFloodStep = 8.5;
constexpr double k_ReadsOfSeeds = 30.0; ///< the mask, the places on its edge, and the composite

double CostOfStrokes(const OutlineWork& work)
{
    return work.strokeArea * k_ReadsOfStroke + work.regionArea * k_ReadsOfOwnDepth;
}

double CostOfSeparable(const OutlineWork& work)
{
    return work.regionArea * (k_ReadsOfSeeds + 2.0 * (2.0 * std::ceil(work.width) + 1.0));
}

double CostOfJumpFlood(const OutlineWork& work)
{
    const double steps = 1.0 + std::ceil(std::log2(work.width + 1.0));
    return work.regionArea * (k_ReadsOfSeeds + k_ReadsOfFloodStep * steps);
}

/// Appends "0.25 million".
void AppendMillions(PooledString& text, double number)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number * 1e-6,
                                   std::chars_format::general, number < 1e6 ? 2 : 3);
    text.append(digits.data(), end.ptr).append(" million");
}

} // namespace

const char* ToString(OutlineTechnique technique)
{
    switch (technique)
    {
    case OutlineTechnique::Auto:
        return "Auto";
    case OutlineTechnique::Strokes:
        return "Strokes";
    case OutlineTechnique::Separable:
        return "Separable";
    case OutlineTechnique::JumpFlood:
        return "JumpFlood";
    }
    return "?";
}

OutlineChoice ChooseOutlineTechnique(const OutlineWork& work)
{
    const double separable = CostOfSeparable(work);
    const double flood = CostOfJumpFlood(work);
    const double transform = std::min(separable, flood);
    const OutlineTechnique best =
        separable <= flood ? OutlineTechnique::Separable : OutlineTechnique::JumpFlood;
    if (work.isAlphaTested)
    {
        return {best,
                "a material is alpha-tested, so the mesh's silhouette is not the one that is seen"};
    }
    const double strokes = CostOfStrokes(work);
    std::array<char, 16> edges{};
    const auto end = std::to_chars(edges.data(), edges.data() + edges.size(), work.edgeCount);
    PooledString costs(edges.data(), end.ptr);
    costs.append(" silhouette edges cost about ");
    AppendMillions(costs, strokes);
    costs.append(" texture reads, a distance transform ");
    AppendMillions(costs, transform);
    return {strokes <= transform ? OutlineTechnique::Strokes : best, std::move(costs)};
}

} // namespace limn
