#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace limn::benchmarks
{

/// What drawing many renderers takes at least: loops over arrays of exactly what each step needs,
/// in one thread, with no class in sight.
class PlainLoops
{
public:
    /// @param count  renderers, spread over a box in front of the camera
    explicit PlainLoops(std::size_t count);

    void Cull();
    void Judge();
    void MakeKeys();
    void Sort();
    void WriteIndices();
    /// All of them.
    void Frame();

    std::size_t visibleCount() const { return m_Visible.size(); }
    std::size_t batchCount() const { return m_Batches; }

private:
    struct Entry
    {
        std::uint64_t key = 0;
        std::uint32_t index = 0;
    };

    std::size_t m_Count;
    std::array<std::vector<float>, 3> m_Center;
    std::array<std::vector<float>, 3> m_Extent;
    std::vector<std::uint16_t> m_Queue;
    std::vector<std::uint8_t> m_Layer;
    std::vector<std::uint32_t> m_RenderingLayers;
    std::vector<std::uint16_t> m_Material;
    std::vector<std::uint16_t> m_Mesh;
    std::vector<std::uint32_t> m_Visible;
    std::vector<std::uint32_t> m_Drawn;
    std::vector<Entry> m_Entries;
    std::vector<Entry> m_Spare;
    std::vector<std::uint32_t> m_Indices;
    std::size_t m_Batches = 0;
};

/// Where renderer `index` of a scene for measurements is, metres.
std::array<float, 3> PlaceOf(std::size_t index);

inline constexpr std::size_t k_MeshCount = 10;
inline constexpr std::size_t k_MaterialCount = 10;

} // namespace limn::benchmarks
