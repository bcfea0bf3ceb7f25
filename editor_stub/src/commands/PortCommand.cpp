#include "commands/PortCommand.h"

#include "commands/FeatureFolder.h"
#include "port/PortFolder.h"

#include <array>
#include <limn/editor_stub/RunLimn.h>
#include <limn/shaderlab/ReadFile.h>

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

} // namespace

int RunPort(const PortOptions& options, Console& console)
{
    CSharpFiles files;
    for (const std::string& path : options.files)
    {
        auto file = std::make_unique<CSharpFile>();
        file->path = path;
        file->text = ReadFile(path);
        ParseCSharp(*file);
        files.push_back(std::move(file));
    }
    const PortFolder port = PortFeature(files, UnityPortingTable());
    MakeFeatureFolder(options.folder);
    for (const PortedFile& file : port.files)
    {
        WriteFeatureFile(options.folder, file.name, file.text, console);
    }
    for (const UsedMember& use : port.uses)
    {
        if (!use.entry)
        {
            PrintUse(use, console);
        }
    }
    console.Note("of what the C# uses: " + Counts(port.uses) +
                 "; of its settings, passes and "
                 "events " +
                 std::to_string(port.done) + " are C++, " + std::to_string(port.left) +
                 " are left; see PORTING.md");
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn
