#include "port/PortFolder.h"

#include "console/Texts.h"
#include "port/PortedCode.h"

#include <limn/base/EmbeddedFile.h>
#include <limn/base/WordList.h>

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

FoundFilter FindFilter(const PortModel& model)
{
    FoundFilter found;
    for (const CSharpClass* one : model.classes())
    {
        const auto findIn = [&](CSharpWords words)
        {
            for (std::size_t i = 0; i + 1 < words.size() && !found.owner; ++i)
            {
                const CSharpToken& open = words[i + 1];
                if (words[i].Is("FilteringSettings") && open.Is("(") && !open.Inside().empty())
                {
                    found = {one, {&words[i], open.Behind()}, SplitArguments(open.Inside())};
                }
            }
        };
        std::ranges::for_each(one->fields, findIn, &CSharpField::value);
        std::ranges::for_each(one->methods, findIn, &CSharpMethod::body);
    }
    return found;
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
        std::string csharp = model.Text(*found.owner, found.words);
        std::ranges::replace(csharp, '\\', '/'); // a comment that ends in one goes on
        text = "    // C#: " + model.Place(*found.owner, found.words.front().location) + ": " +
               Joined(SplitWords(csharp), " ") + "\n";
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

/// Makes the feature say in its Create that the port is not whole.
std::string WithWarning(std::string source, const CSharpClass& feature, int todos)
{
    const std::string head = "void " + PortModel::ClassName(feature) + "::Create()\n{\n";
    const std::size_t at = source.find(head);
    if (todos > 0 && at != std::string::npos)
    {
        source.insert(at + head.size(),
                      "    // Delete this line with the last TODO.\n    Debug::LogWarning(\"" +
                          feature.name + ": the port still has " + std::to_string(todos) +
                          (todos == 1 ? " TODO" : " TODOs") +
                          ", so its picture may lack something\");\n");
    }
    return source;
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

constexpr std::size_t k_MostPlaces = 8;

/// Returns the text for a cell of a Markdown table.
std::string Cell(std::string_view text)
{
    return Replaced(Replaced(Replaced(std::string(text), "|", "\\|"), "\n", " "), "\r", " ");
}

std::string Code(std::string_view text)
{
    return text.empty() ? "" : "`" + Cell(text) + "`";
}

/// Returns how much work a use asks of the porter.
int Weight(const UsedMember& use)
{
    return use.entry ? 3 - static_cast<int>(use.entry->verdict) : -1;
}

/// Returns at most `most` places as text: "A.cs:12, 14, B.cs:3".
std::string PlacesText(const std::vector<CSharpPlace>& places, std::size_t most)
{
    std::string text;
    const CSharpFile* file = nullptr;
    for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    {
        text += i == 0 ? "" : ", ";
        if (places[i].file != file)
        {
            file = places[i].file;
            text += file->name() + ":";
        }
        text += std::to_string(places[i].location.line) + ":" +
                std::to_string(places[i].location.column);
    }
    return places.size() > most ? text + " and " + std::to_string(places.size() - most) + " more"
                                : text;
}

std::string UseRow(const UsedMember& use)
{
    return "| " + Code(use.key) + " | " + PlacesText(use.places, k_MostPlaces) + " | " +
           (use.entry ? ToString(use.entry->verdict) : "**unknown**") + " | " +
           (use.entry ? use.entry->words : use.problem) + " |\n";
}

/// Returns the text of PORTING.md: what each thing became, and every use with its verdict.
std::string PortingReport(const PortModel& model, const std::vector<PortedThing>& things,
                          std::vector<UsedMember> uses)
{
    std::string text =
        "# Porting " + model.name() +
        "\n\nA row that says TODO is a comment in the C++; the TODO there says why. Other lines "
        "that limn could not write stand below TODOs, too.\n\n"
        "## What the C# says of itself\n\n| | C# | | at | |\n| --- | --- | --- | --- "
        "| --- |\n";
    for (const PortedThing& thing : things)
    {
        text += "| " + thing.what + " | " + Code(thing.name) + " | " + Code(thing.text) + " | " +
                thing.place + " | " + (thing.isDone ? "done" : "TODO") + " |\n";
    }
    for (const auto& file : model.files())
    {
        for (const CSharpCondition& condition : file->tokens.conditions)
        {
            text += "| condition | " + Code("#if " + condition.text) + " | " +
                    (condition.isTrue ? "read" : "left out") + " | " +
                    PlacesText({{file.get(), condition.location}}, 1) + " | |\n";
        }
    }
    text +=
        "\n## What it uses\n\nEvery type, member and attribute, by what there is to do.\n\n| Unity "
        "| at | here | |\n| --- | --- | --- | --- |\n";
    std::ranges::stable_sort(uses, {}, Weight);
    return text + Joined(uses, "", UseRow);
}

} // namespace

PortFolder PortFeature(const CSharpFiles& files, const PortingTable& table)
{
    PortFolder folder;
    folder.uses = UsedMembersOf(files, table);
    MarkPropertyIds(files);
    PortModel model(files, table);
    PortedCode code(model);
    const CSharpClass& feature = *model.TopLevel(PortRole::Feature).front();
    folder.files.push_back({feature.name + ".h", PortedHeader(code)});
    folder.files.push_back({feature.name + ".cpp", PortedSource(code)});
    folder.left = CountTodos(folder.files[0].text) + CountTodos(folder.files[1].text);
    folder.files[1].text = WithWarning(std::move(folder.files[1].text), feature, folder.left);
    AddTemplate(model, feature, folder.files);
    folder.files.push_back({"PORTING.md", PortingReport(model, code.things(), folder.uses)});
    folder.done = static_cast<int>(std::ranges::count(code.things(), true, &PortedThing::isDone));
    return folder;
}

} // namespace limn
