#pragma once

#include <string_view>

namespace limn
{

/// Whether a version lies in a range as PackageRequirements writes it: "1.2" (this or later),
/// "[1.2]" (this one), "[1.0,2.0)" and the like (an end left out is open), several with ';' between
/// them; "" holds for every version. A pre-release ("-preview.3") comes before its release.
/// A range that cannot be read holds for none. Unity: package version expressions (2022.3).
///
/// @param version  "14.0.11", "2022.3.10f1"
bool isInPackageRange(std::string_view version, std::string_view range);

} // namespace limn
