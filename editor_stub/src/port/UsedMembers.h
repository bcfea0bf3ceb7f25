#pragma once

#include "port/ClassIndex.h"
#include "port/PortingTable.h"

#include <string>
#include <vector>

namespace limn
{

/// A place in one of several files.
struct CSharpPlace
{
    const CSharpFile* file = nullptr;
    SourceLocation location;
};

/// What C# uses that it does not define itself.
struct UsedMember
{
    std::string key;                  ///< of PortingTable, or what stands in the file
    const PortEntry* entry = nullptr; ///< null = unknown
    std::string problem;              ///< of an unknown one: why
    std::vector<CSharpPlace> places;  ///< in the order of the files
};

/// Every type, member and attribute that the files use and do not define, once each, by name. Types
/// of variables are followed as far as declarations and the table say them; whatever cannot be told
/// is there as unknown.
std::vector<UsedMember> UsedMembersOf(const CSharpFiles& files, const PortingTable& table);

} // namespace limn
