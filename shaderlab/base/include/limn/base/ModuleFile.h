#pragma once

#include <filesystem>
#include <string>

namespace limn
{

/// Returns whether the file exists and is not a module of which a part is missing.
bool IsWholeModule(const std::filesystem::path& path);

/// Loads a module, for as long as the process lives, and finds a symbol in it.
/// @param name      the name of the module in errors
/// @param isCopied  true: loads a copy of the file, so that the file can be replaced and loaded
///     again
/// @return null if it has no such symbol
/// @throws AssetError if it cannot be loaded
const void* OpenModule(const std::filesystem::path& path, const std::string& name, bool isCopied,
                       const char* symbol);

/// Returns the address of the loaded module that contains a symbol, or null if none does.
const void* ModuleOf(const void* symbol);

} // namespace limn
