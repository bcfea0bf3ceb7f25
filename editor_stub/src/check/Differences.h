#pragma once

#include "check/SceneFacts.h"

namespace limn
{

/// The meaning of a list of names.
enum class ListKind
{
    Exact,   ///< exactly these names
    AtLeast, ///< these names and maybe others
    None     ///< none of these names
};

/// The difference between a list and what is true.
struct NameDifference
{
    std::vector<std::string> lines; ///< lines that begin with "- " or "+ "; none if the list holds
    std::vector<std::string> truth; ///< the list that would hold
};

NameDifference CompareRenderers(const ObjectNames& objects, const std::vector<std::string>& items,
                                const DrawnFacts& facts, ListKind kind);

/// The words behind a name that is missing or is not expected.
struct NameWords
{
    ListKind kind = ListKind::Exact;
    std::string missing;
    std::string extra;
};

/// Compares names. Their order counts.
NameDifference CompareNames(const std::vector<std::string>& items,
                            const std::vector<std::string>& actual, const NameWords& words);

/// Compares what a frame leaves out, in any order: an item is a pass's name, a reason, or
/// "pass: reason".
NameDifference CompareLeftOut(const std::vector<std::string>& items,
                              const std::vector<LeftOut>& actual, ListKind kind);

} // namespace limn
