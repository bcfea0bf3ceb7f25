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

/// Returns the text with only the values that do not hold written anew. All other bytes stay.
/// @param file  the file's name in errors
/// @throws AssetError if a value cannot be replaced, such as one that an alias repeats
std::string UpdateExpectations(const std::string& text, const std::string& file,
                               const std::vector<Expectation>& expectations);

/// Returns a file that expects all that is true of a scene now: what each feature draws, the volume
/// values at the camera, the passes, the textures that are drawn into, and what is left out.
/// @param head  a comment for its beginning, without the '#'
std::string FullExpectations(SceneFacts& facts, const std::string& head);

/// Returns one line for each expectation that fails, with its differences below it, and a summary:
/// "5 expectations, 1 failed".
/// @param failed  the summary's word for expectations that do not hold
std::string CheckText(const std::vector<Expectation>& expectations, const std::string& file,
                      const std::string& failed, bool isLong);

/// Returns {scene, file, expectations: [{name, line, column, holds, diff}], failed}.
std::string CheckJson(const std::vector<Expectation>& expectations, const std::string& file,
                      const std::string& scene);

/// Returns the XML that continuous integration reads as the results of tests.
std::string JUnitXml(const std::vector<Expectation>& expectations, const std::string& file,
                     const std::string& scene);

} // namespace limn
