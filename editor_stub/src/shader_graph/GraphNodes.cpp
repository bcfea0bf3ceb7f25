#include "shader_graph/GraphNodes.h"

#include "console/Texts.h"
#include "shader_graph/GraphFile.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/EmbeddedFile.h>
#include <limn/base/NumberText.h>
#include <map>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> ShaderGraphTables();
}

namespace
{

/// A line of nodes.txt.
struct NodeLine
{
    std::vector<std::pair<std::string, std::string>> conditions; ///< paths and what stands there
    std::map<std::string, NodeExpression, std::less<>> outputs;

    bool Holds(const Json& fields) const
    {
        return std::ranges::all_of(
            conditions, [&](const auto& condition)
            { return GraphFieldText(fields, condition.first) == condition.second; });
    }
};

/// Calls `use` for each line of an embedded table that is no comment.
template <typename Use>
void ForEachLine(std::string_view name, const Use& use)
{
    for (const EmbeddedFile& file : embedded::ShaderGraphTables())
    {
        for (const std::string& line : SplitText(std::string(file.text), '\n'))
        {
            if (file.path == name && !line.empty() && line.front() != '#')
            {
                use(line);
            }
        }
    }
}

/// Cuts off what stands before the separator, and the separator.
std::string CutTo(std::string& text, std::string_view separator)
{
    const std::size_t end = text.find(separator);
    if (end == std::string::npos)
    {
        throw ContractError("a line of the shader graphs' tables lacks '" + std::string(separator) +
                            "': " + text);
    }
    const std::string cut = text.substr(0, end);
    text.erase(0, end + separator.size());
    return cut;
}

NodeLine ReadNodeLine(std::string conditions, std::string rest)
{
    NodeLine line;
    while (!conditions.empty())
    {
        conditions += ' ';
        std::string condition = CutTo(conditions, " ");
        conditions = conditions.substr(0, conditions.find_last_not_of(' ') + 1);
        const std::string path = CutTo(condition, "=");
        line.conditions.emplace_back(path, condition);
    }
    rest += "; ";
    while (!rest.empty())
    {
        std::string expression = CutTo(rest, "; ");
        std::string name = CutTo(expression, " = ");
        const std::size_t space = name.find(' ');
        const std::string type = space == std::string::npos ? "" : name.substr(0, space);
        line.outputs[name.substr(space + 1)] = {type, expression};
    }
    return line;
}

using NodeTable = std::map<std::string, std::vector<NodeLine>, std::less<>>;

NodeTable ReadNodeTable()
{
    NodeTable table;
    ForEachLine("nodes.txt",
                [&](std::string line)
                {
                    std::string key = CutTo(line, ": ") + " ";
                    const std::string node = CutTo(key, " ");
                    key = key.substr(0, key.find_last_not_of(' ') + 1);
                    table[node].push_back(ReadNodeLine(key, line));
                });
    return table;
}

using InputTable = std::map<std::pair<std::string, std::string>, StageInput, std::less<>>;

InputTable ReadInputTable()
{
    InputTable table;
    ForEachLine("inputs.txt",
                [&](std::string line)
                {
                    const std::string stage = CutTo(line, " ");
                    const std::string name = CutTo(line, " ");
                    const std::string type = CutTo(line, " = ");
                    table[{stage, name}] = {type, line};
                });
    return table;
}

} // namespace

std::optional<NodeExpression> FindNodeExpression(std::string_view node, const Json& fields,
                                                 std::string_view output)
{
    static const NodeTable table = ReadNodeTable();
    const auto lines = table.find(node);
    if (lines == table.end())
    {
        return std::nullopt;
    }
    for (const NodeLine& line : lines->second)
    {
        const auto found = line.outputs.find(output);
        if (found != line.outputs.end() && line.Holds(fields))
        {
            return found->second;
        }
    }
    return std::nullopt;
}

std::string GraphFieldText(const Json& fields, const std::string& path)
{
    const Json* field = &fields;
    for (const std::string& key : SplitText(path, '.'))
    {
        if (key == "rgb")
        {
            return NumberText(NumberIn(*field, "r")) + ", " + NumberText(NumberIn(*field, "g")) +
                   ", " + NumberText(NumberIn(*field, "b"));
        }
        const auto found = field->find(key);
        if (found == field->end())
        {
            return "0"; // the field came with a later version, or is at its default
        }
        field = &*found;
    }
    if (field->is_string())
    {
        return field->get<std::string>();
    }
    return field->is_boolean()  ? (field->get<bool>() ? "1" : "0")
           : field->is_number() ? NumberText(field->get<double>())
                                : "0";
}

std::optional<StageInput> FindStageInput(std::string_view name, GraphStage stage)
{
    static const InputTable table = ReadInputTable();
    const char* own = stage == GraphStage::Vertex     ? "vertex"
                      : stage == GraphStage::Fragment ? "fragment"
                                                      : "screen";
    for (const char* place : {own, "any"})
    {
        const auto found = table.find({place, std::string(name)});
        if (found != table.end())
        {
            return found->second;
        }
    }
    return std::nullopt;
}

} // namespace limn
