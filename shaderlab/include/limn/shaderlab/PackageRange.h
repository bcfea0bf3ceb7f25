#pragma once

#include <string_view>

namespace limn
{

/// Returns whether a version lies in a range of PackageRequirements: "1.2" (this or later), "[1.2]"
/// (only this one), "[1.0,2.0)" and the like (a missing end is open), or several ranges separated
/// by ';'. "" contains every version. A pre-release ("-preview.3") comes before its release. A
/// range that cannot be read contains none. Unity: package version expressions (2022.3).
///
/// @param version  "14.0.11", "2022.3.10f1"
bool isInPackageRange(std::string_view version, std::string_view range);

} // namespace limn
