#pragma once

#include "check/Expectations.h"

namespace limn
{

/// Returns the text with the values that do not hold written anew, and not a byte besides.
/// @param file  what errors call it
/// @throws AssetError where a value cannot be replaced, such as one that an alias repeats
std::string UpdateExpectations(const std::string& text, const std::string& file,
                               const std::vector<Expectation>& expectations);

/// Returns a file that expects all that is true of a scene now: what each feature draws, the volume
/// values at the camera, the passes, the textures drawn into, what is left out.
/// @param head  a comment for its beginning, without the '#'
std::string FullExpectations(SceneFacts& facts, const std::string& head);

} // namespace limn
