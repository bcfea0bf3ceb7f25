#include "scene/RendererTable.h"

#include <array>
#include <bit>
#include <cstring>

namespace limn
{

namespace
{

/// Odd numbers, each a function of its own: known beforehand, so that no word waits for another's.
constexpr std::array<std::uint64_t, 32> k_WordFactors = []
{
    std::array<std::uint64_t, 32> factors{};
    std::uint64_t factor = 0xD6E8FEB86659FD93u;
    for (std::uint64_t& own : factors)
    {
        own = factor;
        factor = factor * 0x9E3779B97F4A7C15u + 2;
    }
    return factors;
}();

/// A sum of products with these numbers: which 64-bit words there were, in which order.
class WordHash
{
public:
    void Add(std::uint64_t word)
    {
        const std::uint64_t factor = k_WordFactors[m_Count % k_WordFactors.size()];
        m_Count += 1;
        // Behind the last number they begin anew, and what there is so far makes the difference.
        m_Sum = m_Count % k_WordFactors.size() == 0 ? std::rotl(m_Sum, 1) : m_Sum;
        m_Sum += std::rotl((word ^ factor) * factor, 29);
    }

    void AddPointer(const void* pointer) { Add(reinterpret_cast<std::uintptr_t>(pointer)); }

    template <typename T>
    void AddBytes(const T& value)
    {
        static_assert(sizeof(T) % sizeof(std::uint64_t) == 0);
        std::array<std::uint64_t, sizeof(T) / sizeof(std::uint64_t)> words;
        std::memcpy(words.data(), &value, sizeof value);
        for (const std::uint64_t word : words)
        {
            Add(word);
        }
    }

    std::uint64_t value() const { return m_Sum; }

private:
    std::uint64_t m_Sum = 0;
    std::size_t m_Count = 0;
};

/// Rows keep the blocks: no other is in the place of one.
void AddTo(WordHash& hash, const RendererPropertyBlocks& blocks)
{
    hash.AddPointer(blocks.ofRenderer().get());
    for (std::size_t slot = 0; slot < blocks.materialCount(); ++slot)
    {
        hash.AddPointer(blocks.OfMaterial(slot).get());
    }
}

} // namespace

ObjectHash HashOf(const GameObject& object, WorldMatrices& matrices)
{
    WordHash place;
    place.AddBytes(object.transform); // no padding: its size is that of its members
    static_assert(sizeof(Transform) == 10 * sizeof(float) + sizeof(void*));
    if (object.transform.parent != nullptr)
    {
        place.AddBytes(matrices.OfParent(object.transform));
    }
    WordHash hash;
    hash.Add(static_cast<std::uint64_t>(object.layer) << 2 |
             static_cast<std::uint64_t>(object.activeSelf) << 1 |
             static_cast<std::uint64_t>(object.renderer.has_value()));
    if (object.renderer)
    {
        const MeshRenderer& renderer = *object.renderer;
        hash.AddPointer(renderer.mesh.get());
        hash.Add(static_cast<std::uint64_t>(renderer.shadowCastingMode) << 33 |
                 std::uint64_t{renderer.renderingLayerMask.bits} << 1 |
                 static_cast<std::uint64_t>(renderer.enabled));
        for (const auto& material : renderer.sharedMaterials)
        {
            hash.AddPointer(material.get());
        }
        if (!renderer.propertyBlocks.isEmpty())
        {
            AddTo(hash, renderer.propertyBlocks);
        }
    }
    return {place.value(), hash.value()};
}

} // namespace limn
