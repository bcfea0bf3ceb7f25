#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

namespace limn
{

/// Gathers changed files until it is time to draw. A save or a checkout can be several events, so
/// drawing waits until none came for a moment. It never waits longer than a little after the first
/// one, so that files that are saved without a pause are drawn as well. The caller gives the time.
class ChangeBatch
{
public:
    using Clock = std::chrono::steady_clock;

    void Add(const std::set<std::filesystem::path>& files, Clock::time_point now);

    /// Returns the time that is left for more changes before these are drawn: 0 if they are to be
    /// drawn now, nothing while there are no changes. A file that is missing may be about to be put
    /// back, so the wait for it is the longest. The wait for a plug-in that is not complete yet is
    /// longer still.
    std::optional<std::chrono::milliseconds> Remaining(Clock::time_point now) const;

    /// Returns the files and begins anew.
    std::set<std::filesystem::path> Take();

private:
    std::set<std::filesystem::path> m_Files;
    Clock::time_point m_First;
    Clock::time_point m_Last;
};

} // namespace limn
