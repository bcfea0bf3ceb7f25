// Finds the draws that may be drawn at once.
#include "renderers/ObjectDraws.h"
#include "scene/RendererTable.h"

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

/// Puts runs of rows into batches.
class BatchMaker
{
public:
    BatchMaker(const RendererTable& table, const std::vector<std::uint32_t>& commutes)
        : m_Table(table), m_Commutes(commutes), m_Parts(table.meshParts().size())
    {
        const std::size_t kinds = commutes.size() * m_Parts * 2;
        m_Remembers = kinds <= k_MostKinds;
        if (m_Remembers && kinds > m_Memory.seen.size())
        {
            m_Memory.seen.resize(kinds);
        }
        constexpr std::uint32_t k_Most = std::uint32_t{1} << 31;
        if (m_Memory.stretch > k_Most)
        {
            std::ranges::fill(m_Memory.seen, Seen());
            m_Memory.stretch = 0;
        }
        ++m_Memory.stretch;
    }

    /// Rows of one class that follow upon each other, for one pass.
    void Add(std::uint32_t pass, std::uint32_t classIndex, std::uint32_t first, std::uint32_t count)
    {
        const RendererTable::DrawKey& rowClass = m_Table.classes()[classIndex];
        const std::size_t kind =
            (pass * m_Parts + rowClass.meshPart) * 2 + (rowClass.isMirrored ? 1 : 0);
        if (m_Runs.empty() || kind != m_LastKind)
        {
            m_LastKind = kind;
            m_Batch = BatchOf(kind, pass, rowClass);
        }
        m_Batches[m_Batch].count += count;
        m_Runs.push_back({m_Batch, first, count});
    }

    /// @param rows     what the runs are of
    /// @param batched  those of the batches are appended
    std::span<const ObjectBatch> Take(const std::vector<std::uint32_t>& rows,
                                      std::vector<std::uint32_t>& batched)
    {
        std::uint32_t first = 0;
        for (ObjectBatch& batch : m_Batches)
        {
            batch.first = first;
            first += std::exchange(batch.count, 0);
        }
        const std::size_t offset = batched.size();
        batched.resize(offset + first);
        std::uint32_t* out = batched.data() + offset;
        for (const Run& run : m_Runs)
        {
            ObjectBatch& batch = m_Batches[run.batch];
            std::copy_n(rows.begin() + run.first, run.count, out + batch.first + batch.count);
            batch.count += run.count;
        }
        return m_Batches;
    }

private:
    struct Run
    {
        std::uint32_t batch = 0;
        std::uint32_t first = 0; ///< among the items
        std::uint32_t count = 0;
    };
    /// The batch of a kind, if it belongs to the current stretch of draws that may change places.
    struct Seen
    {
        std::uint32_t stretch = 0;
        std::uint32_t batch = 0;
    };
    /// The memory of all calls. Each call begins a stretch of its own, so that a few draws of many
    /// kinds need no clearing.
    struct Memory
    {
        std::vector<Seen> seen; ///< by kind
        std::uint32_t stretch = 0;
    };
    static Memory& MemoryOfThread()
    {
        static thread_local Memory memory;
        return memory;
    }
    /// The greatest number of kinds; with more, only neighbours are put together.
    static constexpr std::size_t k_MostKinds = 1 << 22;

    std::uint32_t BatchOf(std::size_t kind, std::uint32_t pass,
                          const RendererTable::DrawKey& rowClass)
    {
        const std::uint32_t number = rowClass.isAgain ? 0 : m_Commutes[pass];
        m_Memory.stretch += number == 0 || number != m_Number || !m_Remembers ? 1 : 0;
        m_Number = number;
        if (m_Remembers && m_Memory.seen[kind].stretch == m_Memory.stretch)
        {
            return m_Memory.seen[kind].batch;
        }
        m_Batches.push_back({pass, rowClass.meshPart, rowClass.isMirrored, 0, 0});
        const auto batch = static_cast<std::uint32_t>(m_Batches.size() - 1);
        if (m_Remembers)
        {
            m_Memory.seen[kind] = {m_Memory.stretch, batch};
        }
        return batch;
    }

    const RendererTable& m_Table;
    const std::vector<std::uint32_t>& m_Commutes;
    const std::size_t m_Parts;
    Memory& m_Memory = MemoryOfThread();
    bool m_Remembers = false; ///< kinds that were not the last
    std::vector<Run>& m_Runs = ThreadScratch<Run>();
    std::vector<ObjectBatch>& m_Batches = ThreadScratch<ObjectBatch>();
    std::size_t m_LastKind = 0;
    std::uint32_t m_Batch = 0;
    std::uint32_t m_Number = 0;
};

} // namespace

std::span<const ObjectBatch> MakeBatches(const RendererItems& items, std::span<const ClassRun> runs,
                                         const std::pmr::vector<PassNumbers>& passesOf,
                                         const std::vector<std::uint32_t>& commutes,
                                         std::vector<std::uint32_t>& rows)
{
    BatchMaker maker(*items.table(), commutes);
    for (const ClassRun& run : runs)
    {
        const PassNumbers& passes = passesOf[run.passes];
        if (passes.size() == 1)
        {
            maker.Add(passes.front(), run.rowClass, run.first, run.count);
            continue;
        }
        for (std::uint32_t row = run.first; row < run.first + run.count; ++row)
        {
            for (const std::uint32_t pass : passes)
            {
                maker.Add(pass, run.rowClass, row, 1);
            }
        }
    }
    return maker.Take(items.rows(), rows);
}

} // namespace limn
