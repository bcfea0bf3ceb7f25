#include "renderers/ObjectDraws.h"
#include "renderers/SortEntries.h"
#include "scene/RendererTable.h"
#include "support/ParallelFor.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <limn/core/Culling.h>

namespace limn
{

namespace
{

/// Sorts the rows of a call. Its lists are kept from call to call, because new memory would cost as
/// much as the work on it.
class RowSorter
{
public:
    RowSorter(RendererItems& items, const SortingSettings& sorting, std::vector<ClassRun>& runs)
        : m_Table(*items.table()),
          m_Order(m_Table.order()),
          m_Sorting(sorting),
          m_Camera(sorting.cameraPosition - m_Table.origin()),
          m_IsByState(sorting.criteria & SortingCriteria::OptimizeStateChanges),
          m_Rows(items.rows()),
          m_Runs(runs)
    {
    }

    void Sort()
    {
        static thread_local std::vector<std::uint64_t> classWords;
        // Few rows are not worth a look at all classes.
        if (m_Rows.size() * 4 >= m_Table.classes().size() && MakeClassWords(classWords))
        {
            SortWords(classWords.data());
        }
        else
        {
            SortEntries();
        }
    }

private:
    /// Entries of one word each, if there is room. From its highest bits on: queue, distance,
    /// material index and rank of the state, as of a SortEntry; behind what is sorted by, the first
    /// class and the row.
    /// @param words  gets by class what is the same for all its rows
    bool MakeClassWords(std::vector<std::uint64_t>& words)
    {
        const SortingCriteria criteria = m_Sorting.criteria;
        const bool byQueue = criteria & SortingCriteria::RenderQueue;
        const bool byIndex = criteria & SortingCriteria::BackToFront;
        int leastQueue = std::numeric_limits<int>::max();
        int mostQueue = 0;
        unsigned mostIndex = 0;
        for (const RendererTable::DrawKey& own : m_Table.classes())
        {
            leastQueue = std::min(leastQueue, QueueOf(own));
            mostQueue = std::max(mostQueue, QueueOf(own));
            mostIndex = std::max<unsigned>(mostIndex, own.materialIndex);
        }
        const auto bits = [](bool counts, auto most)
        {
            return counts ? static_cast<int>(std::bit_width(static_cast<std::size_t>(most))) : 0;
        };
        m_FirstShift = bits(true, m_Table.rowCount());
        m_RankShift = m_FirstShift + bits(true, m_Table.classes().size());
        const int indexShift = m_RankShift + (m_IsByState ? m_Order.rankBits : 0);
        m_DistanceShift = indexShift + bits(byIndex, mostIndex);
        const int queueShift = m_DistanceShift + DistanceKeyBits(criteria);
        const int end = queueShift + bits(byQueue, mostQueue - leastQueue);
        if (end > 63)
        {
            return false;
        }
        words.clear();
        for (std::size_t i = 0; i < m_Table.classes().size(); ++i)
        {
            const RendererTable::DrawKey& own = m_Table.classes()[i];
            const auto queue = static_cast<std::uint64_t>(QueueOf(own) - leastQueue);
            words.push_back((byQueue ? queue << queueShift : 0) |
                            (byIndex ? std::uint64_t{own.materialIndex} << indexShift : 0) |
                            (m_IsByState ? std::uint64_t{m_Order.ranks[i]} << m_RankShift : 0) |
                            std::uint64_t{m_Order.firsts[i]} << m_FirstShift);
        }
        return true;
    }

    void SortWords(const std::uint64_t* classWords)
    {
        static thread_local std::vector<std::uint64_t> words;
        static thread_local std::vector<std::uint64_t> spare;
        words.resize(m_Rows.size());
        Fill(words,
             [&](std::uint32_t row, float distance)
             {
                 const std::uint64_t key = DistanceKey(m_Sorting.criteria, distance);
                 return classWords[m_Table.classOf()[row]] | key << m_DistanceShift | row;
             });
        RadixSort(words, spare, m_RankShift);
        const std::uint64_t rowMask = (std::uint64_t{1} << m_FirstShift) - 1;
        const std::uint64_t firstMask = (std::uint64_t{1} << (m_RankShift - m_FirstShift)) - 1;
        for (std::size_t i = 0; i < words.size(); ++i)
        {
            m_Rows[i] = static_cast<std::uint32_t>(words[i] & rowMask);
            AddToRuns(static_cast<std::uint32_t>(words[i] >> m_FirstShift & firstMask), i);
        }
    }

    void SortEntries()
    {
        static thread_local std::vector<SortEntry> entries;
        static thread_local std::vector<SortEntry> spare;
        entries.resize(m_Rows.size());
        Fill(entries,
             [&](std::uint32_t row, float distance)
             {
                 const std::uint32_t index = m_Table.classOf()[row];
                 const RendererTable::DrawKey& own = m_Table.classes()[index];
                 const std::uint64_t key =
                     SortKey(m_Sorting.criteria, QueueOf(own), distance, own.materialIndex);
                 return SortEntry{key, m_Order.ranks[index], row};
             });
        RadixSort(entries, spare, m_IsByState ? m_Order.rankBits : 0);
        for (std::size_t i = 0; i < entries.size(); ++i)
        {
            m_Rows[i] = entries[i].index;
            AddToRuns(m_Order.firsts[m_Table.classOf()[m_Rows[i]]], i);
        }
    }

    /// @param make  (row, distance) → the row's entry; on any thread
    template <typename Entry, typename Make>
    void Fill(std::vector<Entry>& entries, const Make& make)
    {
        const float* x = m_Table.centers(0).data();
        const float* y = m_Table.centers(1).data();
        const float* z = m_Table.centers(2).data();
        const auto fill = [&, out = entries.data()](std::size_t, std::size_t begin, std::size_t end)
        {
            const SortingSettings sorting = m_Sorting;
            const glm::dvec3 camera = m_Camera;
            for (std::size_t i = begin; i < end; ++i)
            {
                const std::uint32_t row = m_Rows[i];
                const glm::dvec3 offset = glm::dvec3(x[row], y[row], z[row]) - camera;
                out[i] = make(row, SortDistance(offset, sorting));
            }
        };
        ForEachPart(m_Rows.size(), PartsOf(m_Rows.size()), fill);
    }

    void AddToRuns(std::uint32_t first, std::size_t place)
    {
        if (m_Runs.empty() || m_Runs.back().rowClass != first)
        {
            m_Runs.push_back({first, static_cast<std::uint32_t>(place), 0, first});
        }
        ++m_Runs.back().count;
    }

    static int QueueOf(const RendererTable::DrawKey& rowClass)
    {
        return rowClass.material ? rowClass.material->renderQueue() : 0;
    }

    const RendererTable& m_Table;
    const BatchOrder& m_Order;
    const SortingSettings& m_Sorting;
    const glm::dvec3 m_Camera; ///< relative to the table's origin
    const bool m_IsByState;
    std::vector<std::uint32_t>& m_Rows;
    std::vector<ClassRun>& m_Runs;
    // The lowest bits of a word's parts; the row has the bits from 0 on.
    int m_FirstShift = 0;
    int m_RankShift = 0;
    int m_DistanceShift = 0;
};

} // namespace

std::span<const ClassRun> SortIntoRuns(RendererItems& items, const SortingSettings& sorting)
{
    static thread_local std::vector<ClassRun> runs;
    runs.clear();
    if (!items.empty())
    {
        RowSorter(items, sorting, runs).Sort();
    }
    return runs;
}

} // namespace limn
