#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace limn::study
{

/// The progress of a long run and the time that the rest will take, for Console::Progress. Steps
/// may differ in their work, which can be in any unit.
class TimeLeft
{
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// Starts the clock.
    /// @param steps, work  the number of steps and the work of the whole run, including what an
    ///     earlier run did
    explicit TimeLeft(std::size_t steps, double work, Clock clock = std::chrono::steady_clock::now);

    /// Counts a step that an earlier run did. It took none of this run's time.
    void Skip(double work);
    /// Counts a step that is done.
    void Add(double work);

    /// Returns the part of the whole work that is done, 0...1, or 1 if there is no work.
    double done() const;
    /// Returns the seconds left at the speed so far, or nothing before this run has done any work.
    std::optional<double> seconds() const;
    /// Returns a line of progress: "[######......]  51 %, 12 of 34, 1 min 20 s left: what is being
    /// done".
    std::string Line(const std::string& now) const;

private:
    Clock m_Clock;
    std::chrono::steady_clock::time_point m_Start;
    std::size_t m_Steps;
    std::size_t m_StepsDone = 0;
    double m_Work;
    double m_Skipped = 0.0;
    double m_Done = 0.0; ///< by this run
};

} // namespace limn::study
