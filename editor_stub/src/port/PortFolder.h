#pragma once

#include "assets/FeatureFolder.h"
#include "port/PortModel.h"

#include <string>
#include <vector>

namespace limn
{

/// The folder of a plug-in that is begun.
struct PortFolder
{
    std::vector<NewFile> files;
    std::vector<UsedMember> uses; ///< what PORTING.md has in its table
    int left = 0;                 ///< TODOs in the C++: bodies, members, settings and the like
    int done = 0;                 ///< settings, parameters, passes and the like that are C++
};

/// Writes the C++ of the files' features: settings, parameters, passes, events; bodies as comments.
/// @throws AssetError if there is no feature in the files
/// The types of the files' ints may change, see MarkPropertyIds.
PortFolder PortFeature(const CSharpFiles& files, const PortingTable& table);

/// What stands in PORTING.md: what became of what, and every use with its verdict.
std::string PortingReport(const PortModel& model, const std::vector<struct PortedThing>& things,
                          const std::vector<UsedMember>& uses);

/// "A.cs:12, 14, B.cs:3", at most `most` places.
std::string PlacesText(const std::vector<CSharpPlace>& places, std::size_t most);

} // namespace limn
