#include "commands/PortCommand.h"

#include "assets/FeatureFolder.h"
#include "assets/FileKind.h"
#include "port/PortFolder.h"
#include "port/ReadCSharp.h"

#include <array>
#include <limn/base/ReadFile.h>
#include <limn/editor_stub/RunLimn.h>
#include <set>

namespace limn
{

namespace
{

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
    std::set<std::string> said;
    std::string text;
    for (const auto& file : read.files)
    {
        for (const CSharpCondition& condition : file->tokens.conditions)
        {
            const std::string one =
                "'" + condition.text + "' is " + (condition.isTrue ? "true" : "false");
            if (said.insert(one).second)
            {
                text += (text.empty() ? "" : ", ") + one;
            }
        }
    }
    if (!said.empty())
    {
        console.Note("the C# is read for " + read.target.name() + ": " + text);
    }
}

} // namespace

int RunPort(const PortOptions& options, Console& console)
{
    std::vector<std::pair<std::string, std::string>> texts;
    for (const std::string& path : options.files)
    {
        RequireKind(path, {FileKind::CSharp}, "port");
        texts.emplace_back(path, ReadFile(path));
    }
    const ReadCSharpFiles read = ReadCSharp(texts);
    const PortFolder port = PortFeature(read.files, UnityPortingTable());
    std::vector<NewFile> files;
    for (const PortedFile& file : port.files)
    {
        files.push_back({file.name, file.text});
    }
    WriteFeatureFolder(options.folder, files, console);
    for (const UsedMember& use : port.uses)
    {
        if (!use.entry)
        {
            PrintUse(use, console);
        }
    }
    NoteConditions(read, console);
    console.Note("of what the C# uses: " + Counts(port.uses) +
                 "; of its settings, passes and "
                 "events " +
                 std::to_string(port.done) + " are C++, and " + std::to_string(port.left) +
                 (port.left == 1 ? " TODO is" : " TODOs are") + " left; see PORTING.md");
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
