#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace limn
{

/// Records how long named pieces of work took.
class Timeline
{
public:
    struct Span
    {
        std::string name;
        double start = 0.0;    ///< milliseconds since the timeline was made
        double duration = 0.0; ///< milliseconds
        std::uint64_t allocations = 0;
    };
    /// Returns the heap allocations of the program so far.
    using AllocationCount = std::uint64_t (*)();

    /// @param count  null = allocations are not counted and are 0 in all spans
    explicit Timeline(AllocationCount count = nullptr) : m_Count(count) {}

    /// Runs `work` and records it under `name`.
    template <typename Work>
    auto Measure(std::string name, Work&& work)
    {
        Stopwatch stopwatch{*this, std::move(name), now(), allocations()};
        return work();
    }

    /// Returns the milliseconds of all spans of that name together.
    double Total(const std::string& name) const
    {
        double total = 0.0;
        for (const Span& span : m_Spans)
        {
            total += span.name == name ? span.duration : 0.0;
        }
        return total;
    }
    const std::vector<Span>& spans() const { return m_Spans; } ///< in the order they ended

private:
    struct Stopwatch
    {
        Timeline& timeline;
        std::string name;
        double start;
        std::uint64_t allocations;
        ~Stopwatch()
        {
            const std::uint64_t made = timeline.allocations() - allocations;
            timeline.m_Spans.push_back({std::move(name), start, timeline.now() - start, made});
        }
    };

    std::uint64_t allocations() const { return m_Count != nullptr ? m_Count() : 0; }

    double now() const
    {
        using Milliseconds = std::chrono::duration<double, std::milli>;
        return Milliseconds(std::chrono::steady_clock::now() - m_Begin).count();
    }

    AllocationCount m_Count;
    std::chrono::steady_clock::time_point m_Begin = std::chrono::steady_clock::now();
    std::vector<Span> m_Spans;
};

/// Runs `work` and records it if there is a timeline; without one it costs nothing more.
template <typename Work>
auto Measure(Timeline* timeline, const char* name, Work&& work)
{
    return timeline != nullptr ? timeline->Measure(name, work) : work();
}

} // namespace limn
