#pragma once

#include <string>
#include <string_view>

namespace limn::test
{

/// The absolute path of a file of this checkout:
/// SourcePath("samples/furniture/furniture.scene.yaml").
std::string SourcePath(std::string_view relative);

/// The absolute path of the `limn` program of this build.
std::string LimnExecutable();
/// It does but in builds with sanitizers.
bool LimnCountsAllocations();

/// Where the Vulkan layer of the tests is.
std::string LayersFolder();

} // namespace limn::test
