#include "commands/Commands.h"

#include "assets/FeatureFolder.h"
#include "console/Texts.h"
#include "new_files/NewFiles.h"

#include <algorithm>
#include <limn/base/EmbeddedFile.h>
#include <limn/base/WriteFile.h>
#include <limn/editor_stub/AssetContext.h>
#include <limn/features/Features.h>

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
    return !name.empty() && name.size() <= k_LongestName && name[0] >= 'A' && name[0] <= 'Z' &&
           std::ranges::all_of(name,
                               [](char c) { return c != '_' && (isLetter(c) || isDigit(c)); });
}

/// Returns the fault of the name, "" if it has none.
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

ExitCode NewFeature(const NewOptions& options, Console& console)
{
    const std::string problem =
        options.folder.empty()      ? "a feature needs '-o DIR', a new or empty folder"
        : !options.contents.empty() ? "'" + options.contents[0] + "' is one word too many"
                                    : NameProblem(options.name);
    if (!problem.empty())
    {
        console.Error(problem);
        return ExitCode::WrongUsage;
    }
    std::vector<NewFile> files;
    for (const auto& [file, text] : FilesOf(options.style))
    {
        files.push_back(
            {FileName(file, options.name), Replaced(std::string(text), "@NAME@", options.name)});
    }
    WriteFeatureFolder(options.folder, files, console);
    return ExitCode::Done;
}

void RequireAbsent(const std::string& file)
{
    std::error_code ignored;
    if (std::filesystem::exists(std::filesystem::symlink_status(file, ignored)))
    {
        throw AssetError(file, {},
                         "the file is there already, and stays as it is; take another "
                         "name");
    }
}

/// Returns the components that were asked for, or that of the exact outline.
std::vector<std::string> ComponentsOf(const std::vector<std::string>& wanted,
                                      const VolumeComponentRegistry& known)
{
    std::vector<Diagnostic> problems;
    for (const std::string& name : wanted)
    {
        if (!known.Find(name))
        {
            problems.push_back({Severity::Error,
                                name,
                                {},
                                "unknown volume component " + UnknownName(name, known.names())});
        }
    }
    if (!problems.empty())
    {
        throw AssetError(std::move(problems));
    }
    return wanted.empty() ? std::vector<std::string>{"StrokeOutline"} : wanted;
}

std::string MaterialText(const std::vector<std::string>& contents, AssetContext& assets)
{
    const std::string name = contents.empty() ? "Universal Render Pipeline/Lit" : contents.front();
    const std::shared_ptr<const Shader> shader = assets.FindShader(name);
    if (!shader)
    {
        throw AssetError(name, {}, "unknown shader " + assets.shaderSource()->UnknownShader(name));
    }
    return NewMaterial(*shader);
}

ExitCode NewYamlFile(const NewOptions& options, Console& console)
{
    const std::size_t allowed = options.kind == "profile"    ? options.contents.size()
                                : options.kind == "material" ? 1
                                                             : 0;
    if (!options.folder.empty() || !options.style.empty() || options.contents.size() > allowed)
    {
        console.Error(!options.folder.empty()
                          ? "NAME may have a folder in front; -o is for features"
                      : !options.style.empty() ? "--style is for features"
                      : allowed == 1           ? "a material has one shader; quote its name"
                                     : "'" + options.contents[0] + "' is one word too many");
        return ExitCode::WrongUsage;
    }
    AssetContext assets;
    const std::string ending = "." + options.kind + ".yaml"; // which the name may have
    const std::size_t size = options.name.ends_with(ending) ? ending.size() : 0;
    const std::string stem = options.name.substr(0, options.name.size() - size);
    std::vector<NewFile> files;
    if (options.kind == "material")
    {
        files.push_back({stem + ending, MaterialText(options.contents, assets)});
    }
    else
    {
        const std::string profile = stem + ".profile.yaml";
        const VolumeComponentRegistry& known = assets.volumeComponents();
        files.push_back({profile, NewProfile(ComponentsOf(options.contents, known), known)});
        if (options.kind == "scene")
        {
            const std::string name = std::filesystem::path(profile).filename().string();
            files.push_back({stem + ending, NewScene(name)});
        }
    }
    for (const NewFile& newFile : files)
    {
        RequireAbsent(newFile.name);
    }
    for (const NewFile& newFile : files)
    {
        WriteFile(newFile.name, newFile.text);
        console.Result(newFile.name);
    }
    return ExitCode::Done;
}

} // namespace

ExitCode RunNew(const NewOptions& options, Console& console)
{
    return options.kind == "feature" ? NewFeature(options, console) : NewYamlFile(options, console);
}

} // namespace limn
