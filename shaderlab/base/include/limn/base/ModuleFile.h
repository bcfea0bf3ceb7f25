#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limn
{

/// "" unless the bytes are those of a module that ends too early, whose missing rest the system's
/// loader would map and crash upon; what else is wrong with one, the loader says.
std::string ModuleProblem(std::string_view bytes);

/// Whether there is a file, and no module of which a part is missing.
bool IsWholeModule(const std::filesystem::path& path);

/// Loads a module, for as long as the process lives, and finds a symbol in it.
/// @param name      what errors call the module
/// @param isCopied  a copy of the file is loaded, so that the file can be written anew and loaded
/// again
/// @return null if it has no such symbol
/// @throws AssetError if it cannot be loaded
const void* OpenModule(const std::filesystem::path& path, const std::string& name, bool isCopied,
                       const char* symbol);

/// Returns where the module is loaded that a symbol lies in; null if it lies in none.
const void* ModuleOf(const void* symbol);

} // namespace limn
