#pragma once

#include "check/SceneFacts.h"

#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>

namespace limn
{

/// What became of one expectation.
struct Expectation
{
    std::string name;              ///< "features.Outline.drawn"
    SourceLocation location;       ///< of its key
    std::vector<std::string> diff; ///< lines with "- " or "+ " in front; none where it holds
    YamlNode value;                ///< as the file has it
    bool isList = false;
    std::vector<std::string> truth; ///< what the value would be: items, or the one text of a value

    bool holds() const { return diff.empty(); }
};

/// How names of objects that the scene does not have are treated.
enum class UnknownObjects
{
    AreErrors,
    AreDifferences ///< of the expectation, which can be written anew
};

/// Compares the expectations of a file's text with a scene, in the order of the file.
/// @param file  what errors call it
/// @throws AssetError with every problem of the text: broken YAML, unknown keys and names, values
///     of the wrong type
std::vector<Expectation> CompareExpectations(const std::string& text, const std::string& file,
                                             SceneFacts& facts, UnknownObjects unknown);

/// Returns whether two values are the same as files spell them, numbers within a tolerance.
/// @param tolerance  the largest difference between two numbers; nothing: a millionth of them
bool IsSameValue(std::string_view a, std::string_view b, std::optional<double> tolerance);

} // namespace limn
