#include "command_line/Checks.h"

#include "explain/FrameGraph.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limn/base/Case.h>
#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/FindPackages.h>

namespace limn
{

namespace
{

/// Shaders get up to three times the time as a float.
constexpr double k_MaxTime = 1e38;

} // namespace

std::map<std::string, std::string> ReadPackages(const std::string& text)
{
    std::map<std::string, std::string> packages;
    for (const auto& [name, folder] : FindPackages(text))
    {
        packages[name] = folder.string();
    }
    const std::size_t equals = text.find('=');
    const bool isPair = equals != std::string::npos && equals > 0 && equals + 1 < text.size();
    if (packages.empty() && isPair)
    {
        packages[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return packages;
}

std::string CheckPackage(const std::string& text)
{
    return !ReadPackages(text).empty()
               ? std::string()
               : "'" + text +
                     "' is no package; a folder with a package.json is expected, or NAME=DIR: "
                     "com.unity.render-pipelines.core=DIR";
}

std::string CheckTime(const std::string& text)
{
    double seconds = 0.0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, seconds);
    const bool isNumber = error == std::errc{} && rest == end && !std::isnan(seconds);
    if (isNumber && std::abs(seconds) > k_MaxTime)
    {
        return "'" + text + "' is too large for a shader's float; at most 1e38 s are expected";
    }
    return isNumber ? std::string() : "'" + text + "' is no time; seconds are expected: 1.5";
}

std::function<std::string(const std::string&)> CheckCount(int most)
{
    return [most](const std::string& text)
    {
        int number = 0;
        const char* end = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), end, number);
        const bool isGood = error == std::errc{} && rest == end && number >= 1 && number <= most;
        return isGood ? std::string()
                      : "'" + text + "' is no number from 1 to " + std::to_string(most);
    };
}

std::function<std::string(const std::string&)> CheckChoice(const std::string& words)
{
    return [words](const std::string& text)
    {
        const std::vector<std::string> known = CLI::detail::split(words, '|');
        const bool isGood = std::find(known.begin(), known.end(), text) != known.end();
        return isGood ? std::string()
                      : "unknown word " + UnknownName(text, {known.begin(), known.end()});
    };
}

/// Devices and pipes have no ending, which is why a name without one will do.
std::string CheckPicture(const std::string& text)
{
    const std::string ending = ToLower(std::filesystem::path(text).extension().string());
    return ending.empty() || ending == ".png"
               ? std::string()
               : "'" + text +
                     "' would not be a PNG by its name; PNG is what limn writes: a.png, "
                     "or - for stdout";
}

std::string CheckGraph(const std::string& text)
{
    return IsGraphFile(text) ? std::string()
                             : "'" + text + "' is no graph by its name: .svg, .png, .pdf or .dot";
}

} // namespace limn
