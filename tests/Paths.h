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

} // namespace limn::test
