#include "command_line/Values.h"

#include "command_line/FlagTable.h"
#include "console/Texts.h"
#include "explain/ExplainedFrame.h"
#include "settings/Keys.h"

#include <cmath>
#include <filesystem>
#include <limn/base/Case.h>
#include <limn/base/ParseWhole.h>
#include <limn/shaderlab/FindPackages.h>
#include <limn/volume/ProfileEdit.h>

namespace limn
{

namespace
{

std::string Unless(bool isGood, const std::string& text, const std::string& problem)
{
    return isGood ? "" : "'" + text + "' " + problem;
}

/// Reads the numbers on both sides of a separator; 0 for one that is none.
void ParsePair(const std::string& text, char separator, int& first, int& second)
{
    const std::vector<std::string> parts = SplitText(text, separator);
    first = parts.size() == 2 ? ParseWhole<int>(parts[0]).value_or(0) : 0;
    second = parts.size() == 2 ? ParseWhole<int>(parts[1]).value_or(0) : 0;
}

} // namespace

StoreValue IntoNumber(int& number, int most)
{
    return [&number, most](const std::string& text)
    {
        number = ParseWhole<int>(text).value_or(0);
        return Unless(number >= 1 && number <= most, text,
                      "is no number from 1 to " + std::to_string(most));
    };
}

StoreValue IntoSize(int& width, int& height)
{
    return [&width, &height](const std::string& text)
    {
        constexpr int k_Most = static_cast<int>(k_PictureSizes.max);
        ParsePair(text, 'x', width, height);
        return Unless(std::min(width, height) >= 1 && std::max(width, height) <= k_Most, text,
                      "is no size; WxH is expected, 1..." + std::to_string(k_Most) +
                          " each: 1280x720");
    };
}

StoreValue IntoTime(double& seconds)
{
    return [&seconds](const std::string& text)
    {
        seconds = ParseWhole<double>(text).value_or(std::nan(""));
        const bool isShort = std::abs(seconds) <= 1e38; // shaders get up to three times the time
        return std::isnan(seconds)
                   ? Unless(false, text, "is no time; seconds are expected: 1.5")
                   : Unless(isShort, text,
                            "is too large for a shader's float; at most 1e38 s are expected");
    };
}

StoreValue IntoBudget(std::optional<double>& milliseconds)
{
    return [&milliseconds](const std::string& text)
    {
        milliseconds = ParseWhole<double>(text);
        return Unless(milliseconds > 0.0 && std::isfinite(*milliseconds), text,
                      "is no time; milliseconds above 0 are expected: 2.5");
    };
}

StoreValue IntoPart(int& index, int& count)
{
    return [&index, &count](const std::string& text)
    {
        constexpr int k_MostParts = 100000;
        ParsePair(text, '/', index, count);
        return Unless(index >= 1 && index <= count && count <= k_MostParts, text,
                      "is no part; I/N is expected, I from 1 to N: 2/8");
    };
}

StoreValue IntoWords(std::vector<std::string>& words)
{
    return [&words](const std::string& text)
    {
        const std::vector<std::string> more = SplitText(text, ',');
        words.insert(words.end(), more.begin(), more.end());
        return std::string();
    };
}

StoreValue IntoPackages(std::map<std::string, std::string>& packages)
{
    return [&packages](const std::string& text)
    {
        auto found = FindPackages(text);
        const std::size_t equals = text.find('=');
        if (found.empty() && equals != std::string::npos && equals > 0 && equals + 1 < text.size())
        {
            found[text.substr(0, equals)] = text.substr(equals + 1);
        }
        for (const auto& [name, folder] : found)
        {
            packages.emplace(name, folder.string());
        }
        return Unless(!found.empty(), text,
                      "is no package; a folder with a package.json is expected, or NAME=DIR: "
                      "com.unity.render-pipelines.core=DIR");
    };
}

StoreValue IntoSelection(std::vector<SelectionStep>& steps, SelectionStep::Kind kind)
{
    return [&steps, kind](const std::string& text)
    {
        steps.push_back({kind, text});
        return Unless(kind == SelectionStep::Kind::Select || ParseClick(text), text,
                      "is no pixel; X,Y from the top left is expected, or X,Y@SECONDS: 640,360");
    };
}

std::string CheckOutput(const std::string& text)
{
    return Unless(!text.empty(), text, "is no name of a file or folder");
}

std::string CheckFolder(const std::string& text)
{
    return text == "-" ? "stdout holds one file only; name a folder" : CheckOutput(text);
}

/// Devices and pipes have no ending, which is why a name without one will do.
std::string CheckPicture(const std::string& text)
{
    const std::string ending = ToLower(std::filesystem::path(text).extension().string());
    const std::string problem =
        Unless(ending.empty() || ending == ".png", text,
               "is no name of a PNG, and limn writes PNG only: a.png, or - for stdout");
    return problem.empty() ? CheckOutput(text) : problem;
}

std::string CheckWatchedPicture(const std::string& text)
{
    return text == "-" ? "stdout holds one picture only; name a file" : CheckPicture(text);
}

std::string CheckGraph(const std::string& text)
{
    return Unless(IsGraphFile(text), text, "is no graph by its name: .svg, .png, .pdf or .dot");
}

std::string CheckPixel(const std::string& text)
{
    return Unless(ParseClick(text) && text.find('@') == std::string::npos, text,
                  "is no pixel; X,Y from the top left is expected: 640,360");
}

std::string CheckAssignment(const std::string& text)
{
    const std::string problem = ValueAssignment::FormProblem(text);
    return problem.empty() ? "" : "'" + text + "': " + problem;
}

} // namespace limn
