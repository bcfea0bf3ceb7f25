#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace limn::study
{

/// How much of a long run is done and how long the rest will take, as Console::Progress shows it.
/// Steps may differ in their work, which is in any unit.
class TimeLeft
{
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;

    /// The time runs from here.
    /// @param steps, work  of the whole run, with what an earlier one did
    explicit TimeLeft(std::size_t steps, double work, Clock clock = std::chrono::steady_clock::now);

    /// A step that an earlier run did: it took none of this run's time.
    void Skip(double work);
    /// A step is done.
    void Add(double work);

    /// Of the whole work, 0...1; 1 if there is none.
    double done() const;
    /// At the speed so far; nothing before this run has done any work.
    std::optional<double> seconds() const;
    /// "[######......]  51 %, 12 of 34, 1 min 20 s left: what is being done".
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
