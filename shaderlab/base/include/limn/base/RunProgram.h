#pragma once

#include <string>
#include <vector>

namespace limn
{

/// Runs a program, found by PATH, and waits for its end.
/// @param words  the program's name and its arguments
/// @param input  the text of its standard input
/// @param need   the part of the error if it cannot be started: its purpose and where to get it
/// @return its output
/// @throws std::system_error  if it cannot be started
/// @throws std::runtime_error with its name and its message, if it fails
std::string RunProgram(std::vector<std::string> words, const std::string& input,
                       const std::string& need);

} // namespace limn
