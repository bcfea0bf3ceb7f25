#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

namespace limn
{

/// Requires that no output overwrites an input or another output.
/// @param outputs  the files to write; "" for none
/// @param inputs   the files that were read for them
/// @throws AssetError if an output is one of the inputs, by whatever name, or if two outputs are
///     the same file; devices and pipes may be both
void RequireOwnFiles(std::span<const std::string> outputs,
                     const std::set<std::filesystem::path>& inputs);

} // namespace limn
