#pragma once

#include <string>
#include <vector>

namespace limn
{

/// Runs a program, found by PATH, and waits for its end.
/// @param words  the program's name and its arguments
/// @param input  what it reads from its standard input
/// @param need   said where it cannot be started: what it is for and where it is to be had
/// @return what it prints
/// @throws std::system_error  if it cannot be started
/// @throws std::runtime_error naming it and what it complains of, if it fails
std::string RunProgram(std::vector<std::string> words, const std::string& input,
                       const std::string& need);

} // namespace limn
