#pragma once

#include <limn/shaderlab/CompiledPass.h>

#include "IncludeResolver.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A folder of compiled passes, one file each. Nothing that is wrong with it is an error: a
/// missing, torn or foreign file counts as absent, and a folder that cannot be written keeps
/// nothing.
class ShaderCache
{
public:
    /// @param folder  empty = no cache
    explicit ShaderCache(std::filesystem::path folder) : m_Folder(std::move(folder)) {}

    bool isEnabled() const { return !m_Folder.empty(); }

    /// The pass stored under `key`, if every file it was compiled from is still the same.
    /// @param dependencies  is set to these files
    std::optional<CompiledPass> Load(const std::string& key,
                                     std::vector<IncludeDependency>& dependencies) const;
    void Store(const std::string& key, const CompiledPass& pass,
               const std::vector<IncludeDependency>& dependencies) const;

private:
    std::filesystem::path m_Folder;
};

} // namespace limn
