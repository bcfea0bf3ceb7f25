#pragma once

#include "check/Expectations.h"

namespace limn
{

/// Returns the text with only the values that do not hold written anew. All other bytes stay.
/// @param file  the file's name in errors
/// @throws AssetError if a value cannot be replaced, such as one that an alias repeats
std::string UpdateExpectations(const std::string& text, const std::string& file,
                               const std::vector<Expectation>& expectations);

/// Returns a file that expects all that is true of a scene now: what each feature draws, the volume
/// values at the camera, the passes, the textures that are drawn into, and what is left out.
/// @param head  a comment for its beginning, without the '#'
std::string FullExpectations(SceneFacts& facts, const std::string& head);

} // namespace limn
