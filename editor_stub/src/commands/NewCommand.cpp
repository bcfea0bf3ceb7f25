#include "commands/Commands.h"

#include "assets/FeatureFolder.h"
#include "console/Texts.h"

#include <algorithm>
#include <limn/base/EmbeddedFile.h>
#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Features.h>
#include <map>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> FeatureTemplate();
}

namespace
{

constexpr std::size_t k_LongestName = 40;

bool isClassName(const std::string& name)
{
    const auto isIn = [](char c, char first, char last)
    {
        return c >= first && c <= last;
    };
    return !name.empty() && name.size() <= k_LongestName && isIn(name[0], 'A', 'Z') &&
           std::ranges::all_of(
               name,
               [&](char c) { return isIn(c, 'A', 'Z') || isIn(c, 'a', 'z') || isIn(c, '0', '9'); });
}

/// What is wrong with the name; "" if nothing is.
std::string NameProblem(const std::string& name)
{
    if (!isClassName(name))
    {
        return "'" + name +
               "' cannot be the name of a feature; a capital letter, then letters and "
               "digits, up to 40 in all, are expected: DepthFog";
    }
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    const bool isTaken =
        components.Find(name) != nullptr || features.Create(name + "RendererFeature") != nullptr;
    return isTaken ? "limn has a feature of the name '" + name + "'; take another" : "";
}

/// The template's files by their names: those of the style, and those that all styles have.
std::map<std::string_view, std::string_view> FilesOf(const std::string& style)
{
    std::map<std::string_view, std::string_view> files;
    for (const EmbeddedFile& file : embedded::FeatureTemplate())
    {
        const std::size_t slash = file.path.find('/');
        if (slash == std::string_view::npos)
        {
            files.emplace(file.path, file.text);
        }
        else if (file.path.substr(0, slash) == style)
        {
            files[file.path.substr(slash + 1)] = file.text;
        }
    }
    return files;
}

/// "NameTest.cpp.in" → "DepthFogTest.cpp"
std::string FileName(std::string_view file, const std::string& name)
{
    std::string result(file.substr(0, file.size() - 3));
    return result.starts_with("Name") ? name + result.substr(4) : result;
}

} // namespace

int RunNew(const NewOptions& options, Console& console)
{
    const std::string problem = NameProblem(options.name);
    if (!problem.empty())
    {
        console.Error(problem);
        return static_cast<int>(ExitCode::WrongUsage);
    }
    std::vector<NewFile> files;
    for (const auto& [file, text] : FilesOf(options.style))
    {
        files.push_back(
            {FileName(file, options.name), Replaced(std::string(text), "@NAME@", options.name)});
    }
    WriteFeatureFolder(options.folder, files, console);
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
