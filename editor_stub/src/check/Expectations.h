#pragma once

#include "check/SceneFacts.h"

#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>

namespace limn
{

/// The result of one expectation.
struct Expectation
{
    std::string name;              ///< "features.Outline.drawn"
    SourceLocation location;       ///< the place of its key
    std::vector<std::string> diff; ///< lines that begin with "- " or "+ "; none if it holds
    YamlNode value;                ///< as the file has it
    bool isList = false;
    /// The value that would hold: items, or the one text of a value.
    std::vector<std::string> truth;

    bool holds() const { return diff.empty(); }
};

/// The treatment of names of objects that the scene does not have.
enum class UnknownObjects
{
    AreErrors,
    AreDifferences ///< differences of the expectation, which can be written anew
};

/// Compares the expectations of a file's text with a scene, in the order of the file.
/// @param file  the file's name in errors
/// @throws AssetError with every problem of the text: broken YAML, unknown keys and names, values
///     of the wrong type
std::vector<Expectation> CompareExpectations(const std::string& text, const std::string& file,
                                             SceneFacts& facts, UnknownObjects unknown);

/// Returns whether two values are the same as files spell them, numbers within a tolerance.
/// @param tolerance  the largest difference between two numbers; if it is not given, a millionth of
///     them
bool IsSameValue(std::string_view a, std::string_view b, std::optional<double> tolerance);

} // namespace limn
