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
/// Whether this build has sanitizers: they take memory and descriptors of their own, so limits on
/// those do not hold for limn alone.
bool LimnHasSanitizers();

/// Where the Vulkan layer of the tests is.
std::string LayersFolder();

} // namespace limn::test
