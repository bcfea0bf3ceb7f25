#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

namespace limn
{

/// Gathers changed files until it is time to draw: at once, but a save or a checkout can be several
/// events, so only when none came for a moment; and not later than a little after the first, so
/// that files that are saved without a pause are drawn as well. The caller tells the time.
class ChangeBatch
{
public:
    using Clock = std::chrono::steady_clock;

    void Add(const std::set<std::filesystem::path>& files, Clock::time_point now);

    /// For how long more changes may come before these are drawn, 0 if they are to be drawn now;
    /// nothing while there are none. A file that is not there may be about to be put back, so that
    /// one is waited for the longest; a plug-in that is not there as a whole, longer than that.
    std::optional<std::chrono::milliseconds> Remaining(Clock::time_point now) const;

    /// The files, and begins anew.
    std::set<std::filesystem::path> Take();

private:
    std::set<std::filesystem::path> m_Files;
    Clock::time_point m_First;
    Clock::time_point m_Last;
};

} // namespace limn
