#include "view/ChangeBatch.h"

#include <limn/base/ModuleFile.h>

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

/// The events of one save are closer together.
constexpr auto k_Quiet = std::chrono::milliseconds(5);

/// Two frames of a screen: longer, and a dragged slider no longer feels as if it moved the picture.
constexpr auto k_Longest = std::chrono::milliseconds(30);

/// Linkers take the old file away first, then write the new one piece by piece.
constexpr auto k_LongestOfModules = std::chrono::milliseconds(500);

bool IsBeingBuilt(const std::filesystem::path& file)
{
    return file.extension() == ".so" && !IsWholeModule(file);
}

bool IsFileThere(const std::filesystem::path& file)
{
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

} // namespace

void ChangeBatch::Add(const std::set<std::filesystem::path>& files, Clock::time_point now)
{
    if (files.empty())
    {
        return;
    }
    m_First = m_Files.empty() ? now : m_First;
    m_Last = now;
    m_Files.insert(files.begin(), files.end());
}

std::optional<std::chrono::milliseconds> ChangeBatch::Remaining(Clock::time_point now) const
{
    if (m_Files.empty())
    {
        return std::nullopt;
    }
    const bool areAllThere = std::ranges::all_of(m_Files, IsFileThere);
    const bool isModuleBuilt = std::ranges::any_of(m_Files, IsBeingBuilt);
    const auto latest = m_First + (isModuleBuilt ? k_LongestOfModules : k_Longest);
    const auto end = areAllThere && !isModuleBuilt ? std::min(m_Last + k_Quiet, latest) : latest;
    return std::max(std::chrono::ceil<std::chrono::milliseconds>(end - now),
                    std::chrono::milliseconds(0));
}

std::set<std::filesystem::path> ChangeBatch::Take()
{
    return std::exchange(m_Files, {});
}

} // namespace limn
