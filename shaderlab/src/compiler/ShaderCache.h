#pragma once

#include <limn/base/FileCache.h>
#include <limn/shaderlab/ShaderProgram.h>

#include "includes/IncludeResolver.h"

#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A cache of compiled passes in a FileCache.
class ShaderCache
{
public:
    /// Takes the parameters of a FileCache.
    ShaderCache(std::filesystem::path folder, std::uintmax_t limit);

    bool isEnabled() const { return m_Files.isEnabled(); }

    /// Returns the pass stored under `key`, if every file from which it was compiled is still the
    /// same.
    /// @param dependencies  is set to these files
    std::optional<ShaderProgram> Load(const std::string& key,
                                      std::vector<IncludeDependency>& dependencies) const;
    void Store(const std::string& key, const ShaderProgram& pass,
               const std::vector<IncludeDependency>& dependencies) const;

private:
    FileCache m_Files;
};

} // namespace limn
