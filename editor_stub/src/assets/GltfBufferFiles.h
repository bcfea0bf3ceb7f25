#pragma once

#include <filesystem>
#include <set>

namespace limn
{

/// The files beside a .gltf file that hold its buffers, there or not; normal paths. None for a file
/// that is missing or no JSON: who loads the mesh says so.
std::set<std::filesystem::path> GltfBufferFiles(const std::filesystem::path& path);

} // namespace limn
