#pragma once

#include <limn/shaderlab/ShaderProgram.h>

#include "includes/IncludeResolver.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A folder of compiled passes, one file each. Nothing that is wrong with it is an error: a
/// missing, torn or foreign file counts as absent, and a folder that cannot be written keeps
/// nothing. Any number of processes may use one folder at once.
class ShaderCache
{
public:
    /// @param folder  empty = no cache
    /// @param limit  bytes that the entries may take together; 0 = no limit. What was not used for
    ///     longest goes first. It is looked after whenever an eighth of it has been stored.
    ShaderCache(std::filesystem::path folder, std::uintmax_t limit)
        : m_Folder(std::move(folder)), m_Limit(limit)
    {
    }

    bool isEnabled() const { return !m_Folder.empty(); }

    /// The pass stored under `key`, if every file it was compiled from is still the same.
    /// @param dependencies  is set to these files
    std::optional<ShaderProgram> Load(const std::string& key,
                                      std::vector<IncludeDependency>& dependencies) const;
    void Store(const std::string& key, const ShaderProgram& pass,
               const std::vector<IncludeDependency>& dependencies) const;

private:
    void Trim() const;

    std::filesystem::path m_Folder;
    std::uintmax_t m_Limit;
    mutable std::atomic<std::uintmax_t> m_Stored{0}; ///< bytes since the last Trim
    mutable std::atomic<bool> m_HasTrimmed{false};
};

} // namespace limn
