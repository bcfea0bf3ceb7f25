#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limn
{

/// Returns what is wrong if the bytes are those of a module that ends too early, and "" otherwise.
/// The system's loader would map the missing rest and crash; it reports all other problems itself.
std::string ModuleProblem(std::string_view bytes);

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
