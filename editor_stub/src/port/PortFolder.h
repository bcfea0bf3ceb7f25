#pragma once

#include "assets/FeatureFolder.h"
#include "port/PortModel.h"

#include <string>
#include <vector>

namespace limn
{

/// The folder of a new plug-in.
struct PortFolder
{
    std::vector<NewFile> files;
    std::vector<UsedMember> uses; ///< the rows of the table in PORTING.md
    int left = 0; ///< the number of TODOs in the C++: bodies, members, settings and the like
    int done = 0; ///< the number of settings, parameters, passes and the like that are C++
};

/// Writes the C++ of the files' features: settings, parameters, passes, events, and bodies as
/// comments. May change the types of the files' ints, see MarkPropertyIds.
/// @throws AssetError if there is no feature in the files
PortFolder PortFeature(const CSharpFiles& files, const PortingTable& table);

} // namespace limn
