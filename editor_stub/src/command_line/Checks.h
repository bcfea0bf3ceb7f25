#pragma once

#include <functional>
#include <map>
#include <string>

namespace limn
{

/// The folders of packages by their names that the text of --package means: `NAME=DIR`, or a folder
/// that is a package or holds some. Empty if it is none of these.
std::map<std::string, std::string> ReadPackages(const std::string& text);

// What is wrong with the text of an option; "" if nothing.

std::string CheckPackage(const std::string& text);
std::string CheckTime(const std::string& text); ///< seconds that a shader's float holds
std::string CheckPicture(const std::string& text);
std::string CheckGraph(const std::string& text);
/// For options that take a whole number from 1.
std::function<std::string(const std::string&)> CheckCount(int most);
/// For options that take one of a few words, "a|b|c".
std::function<std::string(const std::string&)> CheckChoice(const std::string& words);

} // namespace limn
