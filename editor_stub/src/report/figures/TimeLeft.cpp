#include "report/figures/TimeLeft.h"

#include "report/figures/Numbers.h"

#include <algorithm>

namespace limn::study
{

TimeLeft::TimeLeft(std::size_t steps, double work, Clock clock)
    : m_Clock(std::move(clock)), m_Start(m_Clock()), m_Steps(steps), m_Work(work)
{
}

void TimeLeft::Skip(double work)
{
    ++m_StepsDone;
    m_Skipped += work;
}

void TimeLeft::Add(double work)
{
    ++m_StepsDone;
    m_Done += work;
}

double TimeLeft::done() const
{
    return m_Work > 0.0 ? std::clamp((m_Skipped + m_Done) / m_Work, 0.0, 1.0) : 1.0;
}

std::optional<double> TimeLeft::seconds() const
{
    if (!(m_Done > 0.0))
    {
        return std::nullopt;
    }
    const std::chrono::duration<double> elapsed = m_Clock() - m_Start;
    return elapsed.count() * std::max(m_Work - m_Skipped - m_Done, 0.0) / m_Done;
}

std::string TimeLeft::Line(const std::string& now) const
{
    constexpr std::size_t k_Length = 20;
    const auto filled = static_cast<std::size_t>(done() * static_cast<double>(k_Length));
    const std::string percent = std::to_string(static_cast<int>(done() * 100.0));
    const std::optional<double> left = seconds();
    return "[" + std::string(filled, '#') + std::string(k_Length - filled, '.') + "] " +
           std::string(3 - percent.size(), ' ') + percent + " %, " + std::to_string(m_StepsDone) +
           " of " + std::to_string(m_Steps) + (left ? ", " + Duration(*left) + " left" : "") +
           ": " + now;
}

} // namespace limn::study
