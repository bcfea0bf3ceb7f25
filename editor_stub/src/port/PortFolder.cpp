#include "port/PortFolder.h"

#include "port/FilterLines.h"
#include "port/PortedCode.h"
#include "port/PropertyIds.h"

#include <algorithm>
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

std::string Replaced(std::string text, std::string_view placeholder, const std::string& value)
{
    for (std::size_t at = text.find(placeholder); at != std::string::npos;
         at = text.find(placeholder, at + value.size()))
    {
        text.replace(at, placeholder.size(), value);
    }
    return text;
}

/// How many things the porter has left to do.
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
void AddTemplate(const PortModel& model, const CSharpClass& feature, std::vector<PortedFile>& files)
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
    std::string profile;
    for (const CSharpClass* component : components)
    {
        profile += model.OuterOf(*component) ? "" : RegisteredName(*component) + ": {}\n";
    }
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
    auto features = model.Of(PortRole::Feature);
    std::erase_if(features, [&](const CSharpClass* one) { return model.OuterOf(*one) != nullptr; });
    const CSharpClass& feature = *features.front();
    folder.files.push_back({feature.name + ".h", PortedHeader(code, sources)});
    folder.files.push_back({feature.name + ".cpp", PortedSource(code)});
    folder.left = CountTodos(folder.files[0].text) + CountTodos(folder.files[1].text);
    AddTemplate(model, feature, folder.files);
    folder.files.push_back({"PORTING.md", PortingReport(model, code.things(), folder.uses)});
    for (const PortedThing& thing : code.things())
    {
        folder.done += thing.isDone ? 1 : 0;
    }
    return folder;
}

} // namespace limn
