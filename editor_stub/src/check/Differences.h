#pragma once

#include "check/SceneFacts.h"

namespace limn
{

/// What a list of names says.
enum class ListKind
{
    Exact,   ///< these and no others
    AtLeast, ///< these; there may be others
    None     ///< none of these
};

/// How a list differs from what is true.
struct NameDifference
{
    std::vector<std::string> lines; ///< with "- " or "+ " in front; none where it holds
    std::vector<std::string> truth; ///< the list as it would hold
};

NameDifference CompareRenderers(const ObjectNames& objects, const std::vector<std::string>& items,
                                const DrawnFacts& facts, ListKind kind);

/// What is said behind a name that is missing or too much.
struct NameWords
{
    ListKind kind = ListKind::Exact;
    std::string missing;
    std::string extra;
};

/// Compares names whose order counts.
NameDifference CompareNames(const std::vector<std::string>& items,
                            const std::vector<std::string>& actual, const NameWords& words);

/// Compares what a frame leaves out, in any order: an item is a pass's name, a reason, or
/// "pass: reason".
NameDifference CompareLeftOut(const std::vector<std::string>& items,
                              const std::vector<LeftOut>& actual, ListKind kind);

/// Returns "; did you mean 'X'?" for a name that is not known, or "" where none is near.
std::string NearestHint(const std::string& name, const std::vector<std::string>& known);

} // namespace limn
