#include "port/PortFolder.h"

#include "console/Texts.h"
#include "port/PortedCode.h"

#include <filesystem>
#include <limn/base/EmbeddedFile.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> PortTemplate();
}

namespace
{

/// The arguments of the C# code, in the order of the constructor of Unity's FilteringSettings.
struct FoundFilter
{
    const CSharpClass* owner = nullptr;
    CSharpWords words; ///< FilteringSettings(...)
    std::vector<CSharpWords> arguments;
};

void FindIn(CSharpWords words, const CSharpClass& owner, FoundFilter& found)
{
    for (std::size_t i = 0; i + 1 < words.size() && !found.owner; ++i)
    {
        const CSharpToken& open = words[i + 1];
        if (words[i].Is("FilteringSettings") && open.Is("(") && !open.Inside().empty())
        {
            found = {&owner, {&words[i], open.Behind()}, SplitArguments(open.Inside())};
        }
    }
}

FoundFilter FindFilter(const PortModel& model)
{
    FoundFilter found;
    for (const CSharpClass* one : model.classes())
    {
        for (const CSharpField& field : one->fields)
        {
            FindIn(field.value, *one, found);
        }
        for (const CSharpMethod& method : one->methods)
        {
            FindIn(method.body, *one, found);
        }
    }
    return found;
}

/// Returns the text on one line, for a comment.
std::string Flat(std::string_view text)
{
    std::string flat;
    for (const char c : text)
    {
        const bool isSpace = static_cast<unsigned char>(c) <= ' ';
        flat += !isSpace                              ? std::string(1, c == '\\' ? '/' : c)
                : !flat.empty() && flat.back() != ' ' ? " "
                                                      : "";
    }
    return flat;
}

/// The lines of a generated test that say which objects the feature's filter takes: what the first
/// `new FilteringSettings(...)` of the C# says where that is known, everything elsewhere.
std::string FilterLines(const PortModel& model)
{
    constexpr const char* k_Members[] = {"renderQueueRange", "layerMask", "renderingLayerMask"};
    constexpr const char* k_Types[] = {"RenderQueueRange", "LayerMask", "RenderingLayerMask"};
    const FoundFilter found = FindFilter(model);
    std::string text;
    if (found.owner)
    {
        text = "    // C#: " + model.Place(*found.owner, found.words.front().location) + ": " +
               Flat(model.Text(*found.owner, found.words)) + "\n";
    }
    for (std::size_t i = 0; i < std::size(k_Types); ++i)
    {
        const auto value = i < found.arguments.size()
                               ? Translate(model, {}, found.arguments[i], k_Types[i])
                               : std::nullopt;
        text += "    filtering." + std::string(k_Members[i]) + " = " +
                (value    ? value->cpp
                 : i == 0 ? "RenderQueueRange::all"
                          : k_Types[i] + std::string("::Everything()")) +
                ";\n";
    }
    return text;
}

/// Returns the number of things that the porter has left to do.
int CountTodos(const std::string& text)
{
    int count = 0;
    for (std::size_t at = text.find("// TODO"); at != std::string::npos;
         at = text.find("// TODO", at + 1))
    {
        ++count;
    }
    return count;
}

/// The files of the template that every ported feature has.
void AddTemplate(const PortModel& model, const CSharpClass& feature, std::vector<NewFile>& files)
{
    const auto components = model.Of(PortRole::Component);
    const std::string volumes = components.empty() ? ""
                                                   : "volumes:\n  - {name: " + model.name() +
                                                         ", profile: " + model.name() +
                                                         ".profile.yaml, isGlobal: true}\n";
    for (const EmbeddedFile& file : embedded::PortTemplate())
    {
        std::string name(file.path.substr(0, file.path.size() - 3)); // .in
        name = name.starts_with("Name") ? model.name() + name.substr(4) : name;
        std::string text = Replaced(std::string(file.text), "@NAME@", model.name());
        text = Replaced(std::move(text), "@FEATURE@", feature.name);
        text = Replaced(std::move(text), "@FILTER@\n", FilterLines(model));
        text = Replaced(std::move(text), "@REGISTERED@", RegisteredName(feature));
        files.push_back({name, Replaced(std::move(text), "@VOLUMES@\n", volumes)});
    }
    const std::string profile =
        Joined(model.TopLevel(PortRole::Component), "",
               [](const CSharpClass* component) { return RegisteredName(*component) + ": {}\n"; });
    if (!profile.empty())
    {
        files.push_back({model.name() + ".profile.yaml", profile});
    }
}

} // namespace

PortFolder PortFeature(const CSharpFiles& files, const PortingTable& table)
{
    PortFolder folder;
    folder.uses = UsedMembersOf(files, table);
    MarkPropertyIds(files);
    PortModel model(files, table);
    PortedCode code(model);
    std::vector<std::string> sources;
    for (const auto& file : files)
    {
        sources.push_back(std::filesystem::path(file->path).filename().string());
    }
    const CSharpClass& feature = *model.TopLevel(PortRole::Feature).front();
    folder.files.push_back({feature.name + ".h", PortedHeader(code, sources)});
    folder.files.push_back({feature.name + ".cpp", PortedSource(code)});
    folder.left = CountTodos(folder.files[0].text) + CountTodos(folder.files[1].text);
    AddTemplate(model, feature, folder.files);
    folder.files.push_back({"PORTING.md", PortingReport(model, code.things(), folder.uses)});
    folder.done = static_cast<int>(std::ranges::count(code.things(), true, &PortedThing::isDone));
    return folder;
}

} // namespace limn
