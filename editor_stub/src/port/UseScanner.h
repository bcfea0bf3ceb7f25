#pragma once

#include "port/PortingTable.h"
#include "port/csharp/CSharpFile.h"

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

/// A member that C# uses and does not define itself.
struct UsedMember
{
    std::string key;                  ///< the key in PortingTable, or the words of the file
    const PortEntry* entry = nullptr; ///< null if it is unknown
    std::string problem;              ///< why it is unknown; "" if it is known
    std::vector<CSharpPlace> places;  ///< in the order of the files
};

/// Returns the type of the context that the function of a graph pass takes, by the name of the call
/// that adds the pass; "" for other calls.
std::string GraphContextOf(std::string_view call);

/// Returns every type, member and attribute that the files use and do not define, once each, by
/// name. Types of variables are followed as far as declarations and the table give them. Whatever
/// cannot be told is in the result as unknown.
std::vector<UsedMember> UsedMembersOf(const CSharpFiles& files, const PortingTable& table);

} // namespace limn
