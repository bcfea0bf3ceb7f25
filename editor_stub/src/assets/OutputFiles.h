#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

namespace limn
{

/// @param outputs  what is to be written; "" for none
/// @param inputs   what was read for it
/// @throws AssetError if an output is one of the inputs, by whatever name, or two outputs are one
///     file; devices and pipes may be both
void RequireOwnFiles(std::span<const std::string> outputs,
                     const std::set<std::filesystem::path>& inputs);

} // namespace limn
