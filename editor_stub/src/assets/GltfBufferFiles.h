#pragma once

#include <filesystem>
#include <set>

namespace limn
{

/// Returns the normal paths of the files beside a .gltf file that hold its buffers, whether they
/// exist or not. Returns none for a file that is missing or no JSON; loading its mesh reports that.
std::set<std::filesystem::path> GltfBufferFiles(const std::filesystem::path& path);

} // namespace limn
