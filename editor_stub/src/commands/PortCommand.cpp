#include "commands/Commands.h"

#include "assets/FeatureFolder.h"
#include "assets/FileKind.h"
#include "console/Texts.h"
#include "port/PortFolder.h"

#include <algorithm>
#include <array>
#include <limn/base/ReadFile.h>

namespace limn
{

namespace
{

/// The classes of C# and the Unity that its conditions were answered for.
struct ReadCSharpFiles
{
    CSharpFiles files;
    CSharpTarget target;
};

CSharpFiles ReadFor(const std::vector<std::pair<std::string, std::string>>& texts,
                    const CSharpTarget& target)
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
/// @param texts  path and text of each file
/// @throws AssetError if one is no C#
ReadCSharpFiles ReadCSharp(const std::vector<std::pair<std::string, std::string>>& texts)
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
    std::vector<std::pair<std::string, std::string>> texts;
    for (const std::string& path : options.files)
    {
        RequireKind(path, {FileKind::CSharp}, "port");
        texts.emplace_back(path, ReadFile(path));
    }
    const ReadCSharpFiles read = ReadCSharp(texts);
    const PortFolder port = PortFeature(read.files, UnityPortingTable());
    WriteFeatureFolder(options.folder, port.files, console);
    for (const UsedMember& use : port.uses)
    {
        if (!use.entry)
        {
            PrintUse(use, console);
        }
    }
    NoteConditions(read, console);
    console.Note("the C# uses " + std::to_string(port.uses.size()) +
                 " names of Unity: " + Counts(port.uses) + "; " + std::to_string(port.done) +
                 " of its settings, passes and events are C++, and " + std::to_string(port.left) +
                 (port.left == 1 ? " TODO is" : " TODOs are") + " left; see PORTING.md");
    return ExitCode::Done;
}

} // namespace limn
