#include "commands/Commands.h"

#include "assets/FeatureFolder.h"
#include "assets/FileKind.h"
#include "console/Texts.h"
#include "port/PortFolder.h"
#include "port/ProjectScripts.h"

#include <algorithm>
#include <array>
#include <limn/base/ReadFile.h>

namespace limn
{

namespace
{

/// The paths and texts of C# files.
using CSharpTexts = std::vector<std::pair<std::string, std::string>>;

/// The classes of C# and the Unity that its conditions were answered for.
struct ReadCSharpFiles
{
    CSharpFiles files;
    CSharpTarget target;
};

CSharpFiles ReadFor(const CSharpTexts& texts, const CSharpTarget& target)
{
    CSharpFiles files;
    for (const auto& [path, text] : texts)
    {
        auto file = std::make_unique<CSharpFile>();
        file->path = path;
        file->text = text;
        ParseCSharp(*file, target);
        files.push_back(std::move(file));
    }
    return files;
}

bool HasFeature(const CSharpFiles& files)
{
    const auto isFeature = [](const CSharpClass& one)
    {
        return one.Derives("ScriptableRendererFeature");
    };
    return std::ranges::any_of(files, [&](const auto& file)
                               { return std::ranges::any_of(file->classes, isFeature); });
}

bool HasConditions(const CSharpFiles& files)
{
    return std::ranges::any_of(files,
                               [](const auto& file) { return !file->tokens.conditions.empty(); });
}

/// Reads C# for Unity 2022.3, whose URP 14 limn mirrors. Where no render feature is left by the
/// conditions of that version, for Unity 6, and then with all symbols of a project defined.
/// @throws AssetError if one is no C#
ReadCSharpFiles ReadCSharp(const CSharpTexts& texts)
{
    ReadCSharpFiles first{ReadFor(texts, {}), {}};
    if (HasFeature(first.files) || !HasConditions(first.files))
    {
        return first;
    }
    for (const CSharpTarget& target :
         {CSharpTarget{6000, 0, false}, CSharpTarget{2022, 3, true}, CSharpTarget{6000, 0, true}})
    {
        ReadCSharpFiles read{ReadFor(texts, target), target};
        if (HasFeature(read.files))
        {
            return read;
        }
    }
    return first;
}

/// "12 the same, 3 differ, 1 unknown"
std::string Counts(const std::vector<UsedMember>& uses)
{
    constexpr std::array<const char*, 5> names = {"the same", "differ", "refused", "missing",
                                                  "unknown"};
    std::array<int, 5> counts{};
    for (const UsedMember& use : uses)
    {
        ++counts[use.entry ? static_cast<std::size_t>(use.entry->verdict) : 4];
    }
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        text += counts[i] == 0
                    ? ""
                    : (text.empty() ? "" : ", ") + std::to_string(counts[i]) + " " + names[i];
    }
    return text.empty() ? "nothing" : text;
}

/// Returns whether a script of the project declares something that limn can have, at least in part.
/// The behaviours of a game, its assets and its other features have no place in a port.
bool CanBePorted(const std::string& path, const std::string& text, std::string_view name,
                 const CSharpTarget& target)
try
{
    const CSharpFiles files = ReadFor({{path, text}}, target);
    const std::vector<CSharpClass>& classes = files.front()->classes;
    const auto found = std::ranges::find(classes, name, &CSharpClass::name);
    return found != classes.end() && found->keyword != "interface" &&
           std::ranges::none_of(std::array{"MonoBehaviour", "ScriptableObject", "Editor",
                                           "ScriptableRendererFeature"},
                                [&](const char* base) { return found->Derives(base); });
}
catch (const AssetError&)
{
    return false; // the user has not named this file
}

/// Adds the files of the Unity project that declare what the classes use and no file declares.
/// @return "Assets/Glow.cs for GlowPass", one for each file
std::vector<std::string> AddDeclarations(const PortFolder& port, const CSharpTarget& target,
                                         const ProjectScripts& scripts, CSharpTexts& texts)
{
    const bool isRelative = std::filesystem::path(texts.front().first).is_relative();
    const std::filesystem::path folder = isRelative ? std::filesystem::current_path() : "";
    const auto isThere = [&](const ProjectScript& script)
    {
        return std::ranges::any_of(
            texts,
            [&](const auto& file) { return std::filesystem::equivalent(file.first, script.path); });
    };
    std::vector<std::string> added;
    for (const UsedMember& use : port.uses)
    {
        const auto found =
            use.entry ? std::vector<const ProjectScript*>() : scripts.FindDeclarations(use.key);
        for (const ProjectScript* script : found)
        {
            if (isThere(*script))
            {
                break; // the conditions of the file have left it out
            }
            const std::filesystem::path& whole = script->path;
            const std::string path =
                (isRelative ? whole.lexically_relative(folder) : whole).generic_string();
            if (CanBePorted(path, script->text, use.key, target))
            {
                texts.emplace_back(path, script->text);
                added.push_back(path + " for " + use.key);
                break;
            }
        }
    }
    return added;
}

void PrintUse(const UsedMember& use, Console& console)
{
    const CSharpPlace& first = use.places.front();
    const bool isOnce = use.places.size() == 1;
    console.Print({Severity::Warning, first.file->path, first.location,
                   "unknown: '" + use.key + "': " + use.problem +
                       (isOnce ? "" : "; " + std::to_string(use.places.size()) + " times")});
}

/// "#if X is left out", "is read", once each.
void NoteConditions(const ReadCSharpFiles& read, Console& console)
{
    std::vector<std::string> said;
    for (const auto& file : read.files)
    {
        for (const CSharpCondition& condition : file->tokens.conditions)
        {
            AddOnce("'" + condition.text + "' is " + (condition.isTrue ? "true" : "false"), said);
        }
    }
    if (!said.empty())
    {
        console.Note("the C# is read for " + read.target.name() + ": " + Joined(said, ", "));
    }
}

} // namespace

ExitCode RunPort(const PortOptions& options, Console& console)
{
    CSharpTexts texts;
    for (const std::string& path : options.files)
    {
        RequireKind(path, {FileKind::CSharp}, "port");
        texts.emplace_back(path, ReadFile(path));
    }
    ReadCSharpFiles read = ReadCSharp(texts);
    PortFolder port = PortFeature(read.files, UnityPortingTable());
    const ProjectScripts scripts(options.files.front());
    std::vector<std::string> taken;
    for (auto more = AddDeclarations(port, read.target, scripts, texts); !more.empty();
         more = AddDeclarations(port, read.target, scripts, texts))
    {
        taken.insert(taken.end(), more.begin(), more.end());
        read.files = ReadFor(texts, read.target);
        port = PortFeature(read.files, UnityPortingTable());
    }
    WriteFeatureFolder(options.folder, port.files, console);
    for (const UsedMember& use : port.uses)
    {
        if (!use.entry)
        {
            PrintUse(use, console);
        }
    }
    if (!taken.empty())
    {
        console.Note("these files are read, too: " + Joined(taken, ", "));
    }
    NoteConditions(read, console);
    console.Note("the C# uses " + std::to_string(port.uses.size()) +
                 " names of Unity: " + Counts(port.uses) + "; " + std::to_string(port.done) +
                 " of its settings, passes and events are C++, and " + std::to_string(port.left) +
                 (port.left == 1 ? " TODO is" : " TODOs are") + " left; see PORTING.md");
    return ExitCode::Done;
}

} // namespace limn
