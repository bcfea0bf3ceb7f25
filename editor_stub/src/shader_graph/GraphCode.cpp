#include "shader_graph/GraphCode.h"

#include "console/Texts.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/NumberText.h>

namespace limn
{

/// A graph, or a sub graph where a node of another one uses it.
class GraphScope
{
public:
    explicit GraphScope(const GraphFile& graph) : file(graph) {}
    GraphScope(const GraphFile& graph, GraphScope& outer, const GraphNode& node)
        : file(graph), parent(&outer), caller(&node), depth(outer.depth + 1)
    {
    }

    const GraphFile& file;
    GraphScope* parent = nullptr;      ///< null for the graph itself
    const GraphNode* caller = nullptr; ///< the node of `parent`
    int depth = 0;
    std::map<std::pair<std::string, std::string>, GraphValue> values; ///< by node and output
    std::map<std::string, std::string> dynamicTypes;                  ///< by node
    std::map<std::string, std::unique_ptr<GraphScope>> inner;         ///< by node
};

namespace
{

constexpr int k_MaxDepth = 32;  ///< of sub graphs in sub graphs
constexpr int k_MaxNodes = 500; ///< one behind another
constexpr const char* k_FieldBytes =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";

/// Returns slots in the order of a function's parameters.
std::vector<GraphSlot> InputsFirst(std::vector<GraphSlot> slots)
{
    std::ranges::stable_sort(slots, {}, &GraphSlot::isOutput);
    return slots;
}

/// Returns the first part of a node's id, as far as a name can have it.
std::string NameOfNode(const GraphNode& node)
{
    std::string name = node.id.substr(0, 14);
    std::erase_if(name, [](char c) { return c == '-' || c == ' '; });
    return name;
}

/// Returns whether a node computes in half precision, by itself or by its graph.
bool IsHalf(const GraphNode& node, const GraphFile& file)
{
    const int own = IntIn(*node.fields, "m_Precision"); // inherited, single, half
    const Json& graph = file.graph();
    const bool isGraphHalf = graph.contains("m_GraphPrecision")
                                 ? IntIn(graph, "m_GraphPrecision") == 2
                                 : IntIn(graph, "m_ConcretePrecision") == 1; // until 2021
    return own == 2 || (own == 0 && isGraphHalf);
}

} // namespace

GraphCode::GraphCode(const GraphFile& file, GraphStage stage, GraphSurroundings& around)
    : m_Stage(stage), m_Around(around), m_Root(std::make_unique<GraphScope>(file))
{
}

GraphCode::~GraphCode() = default;

GraphValue GraphCode::InputOf(const GraphNode& node, const GraphSlot& slot)
{
    const std::string type = TypeOf(*m_Root, node, slot);
    return {type, ConvertGraphValue(Input(*m_Root, node, slot), type)};
}

GraphValue GraphCode::Declared(const std::string& type, const std::string& text)
{
    const std::string name = "v" + std::to_string(m_Count++);
    m_Body += GraphLine(type + " " + name + " = " + text + ";");
    return {type, name};
}

GraphValue GraphCode::Problem(const GraphNode& node, const std::string& type,
                              const std::string& why)
{
    m_Around.problems.insert("the node '" + node.title + "' " + why);
    return {type, GraphWidth(type) > 0 && type != "bool" ? "((" + type + ")0)" : "false"};
}

std::string GraphCode::Use(const std::string& input)
{
    if (std::ranges::find(m_Inputs, input) == m_Inputs.end())
    {
        if (const std::optional<StageInput> found = FindStageInput(input, m_Stage))
        {
            for (std::size_t at = found->text.find("IN."); at != std::string::npos;
                 at = found->text.find("IN.", at + 1))
            {
                Use(GraphWordAt(found->text, at + 3));
            }
        }
        m_Inputs.push_back(input);
    }
    return "IN." + input;
}

/// Returns the value of an input in the type of what is connected with it, or of the slot.
GraphValue GraphCode::Input(GraphScope& scope, const GraphNode& node, const GraphSlot& slot)
{
    const std::optional<GraphOutput> source = scope.file.SourceOf(node, slot.id);
    if (slot.kind == "PropertyConnectionState")
    {
        const GraphSlot* given = source ? SlotOfProperty(scope, *source->node) : nullptr;
        const bool isGiven =
            given != nullptr && scope.parent->file.SourceOf(*scope.caller, given->id);
        return {"bool", isGiven ? "true" : "false"};
    }
    return source ? Output(scope, *source->node, source->slot) : Unconnected(scope, node, slot);
}

GraphValue GraphCode::Output(GraphScope& scope, const GraphNode& node, int slotId)
{
    const GraphSlot* slot = node.FindSlot(slotId);
    if (slot == nullptr)
    {
        return Problem(node, "float", "has no output " + std::to_string(slotId));
    }
    const std::pair key{node.id, std::to_string(slotId)};
    const auto known = scope.values.find(key);
    if (known != scope.values.end())
    {
        return known->second;
    }
    if (m_Depth >= k_MaxNodes)
    {
        return Problem(node, "float", "stands behind too many others");
    }
    scope.values[key] = {"float", "0"}; // for a circle, which no graph has
    ++m_Depth;
    GraphValue value = Evaluate(scope, node, *slot);
    --m_Depth;
    scope.values[key] = value;
    return value;
}

GraphValue GraphCode::Evaluate(GraphScope& scope, const GraphNode& node, const GraphSlot& slot)
{
    const auto passed = [&]
    {
        const auto input = std::ranges::find(node.slots, false, &GraphSlot::isOutput);
        return input == node.slots.end() ? Problem(node, "float", "has no input")
                                         : Input(scope, node, *input);
    };
    const Json& fields = *node.fields;
    const std::string& type = node.type;
    return type == "Property"         ? Property(scope, node)
           : type == "SubGraph"       ? SubGraph(scope, node, slot.id)
           : type == "CustomFunction" ? CustomFunction(scope, node, slot)
           : type == "Keyword"        ? Keyword(scope, node)
           : type == "Dropdown"       ? Dropdown(scope, node)
           : type == "SamplerState"   ? Sampler(fields)
           : type == "Gradient"       ? Declared("Gradient", GraphGradientOfNode(fields))
           : type == "RedirectNodeData" || type == "Preview" ? passed()
           : type == "Multiply"                              ? Multiplied(scope, node)
           : type.ends_with("Asset")                         ? TextureOf(node, slot)
                                                             : FromTable(scope, node, slot);
}

GraphValue GraphCode::FromTable(GraphScope& scope, const GraphNode& node, const GraphSlot& slot)
{
    const std::optional<NodeExpression> expression =
        FindNodeExpression(node.type, *node.fields, slot.name);
    const std::string type = TypeOf(scope, node, slot);
    if (!expression)
    {
        return Problem(node, type, "(" + node.type + "), or what it is set to, is unknown to limn");
    }
    return Declared(type, Expand(scope, node, expression->text));
}

/// Returns a value that stands between a node's inputs and outputs.
GraphValue GraphCode::Between(GraphScope& scope, const GraphNode& node, const std::string& name,
                              const NodeExpression& expression)
{
    const std::pair key{node.id, name};
    const auto known = scope.values.find(key);
    if (known != scope.values.end())
    {
        return known->second;
    }
    const GraphValue value = Declared(expression.type, Expand(scope, node, expression.text));
    scope.values[key] = value;
    return value;
}

std::string GraphCode::Expand(GraphScope& scope, const GraphNode& node, const std::string& text)
{
    std::string expanded;
    for (std::size_t at = 0; at < text.size();)
    {
        if (text[at] == '@')
        {
            const std::size_t end = text.find_first_not_of(k_FieldBytes, at + 1);
            expanded += GraphFieldText(*node.fields, text.substr(at + 1, end - at - 1));
            at = std::min(end, text.size());
            continue;
        }
        std::string word = GraphWordAt(text, at);
        if (word == "IN")
        {
            word = GraphWordAt(text, at + 3);
            expanded += Use(word);
            at += 3 + word.size();
            continue;
        }
        const bool isMember = at > 0 && text[at - 1] == '.';
        expanded += word.empty() ? std::string(1, text[at])
                    : isMember   ? word
                                 : Named(scope, node, word);
        at += std::max<std::size_t>(word.size(), 1);
    }
    return expanded;
}

/// Returns the value of a node's input, or of another output, or of what stands between. Returns
/// any other word as it is.
std::string GraphCode::Named(GraphScope& scope, const GraphNode& node, const std::string& word)
{
    if (const GraphSlot* input = node.FindSlot(word, false))
    {
        return ConvertGraphValue(Input(scope, node, *input), TypeOf(scope, node, *input));
    }
    const std::optional<NodeExpression> inner = FindNodeExpression(node.type, *node.fields, word);
    const GraphSlot* output = node.FindSlot(word, true);
    return !inner                 ? word
           : !inner->type.empty() ? Between(scope, node, word, *inner).text
           : output != nullptr    ? Output(scope, node, output->id).text
                                  : word;
}

std::string GraphCode::TypeOf(GraphScope& scope, const GraphNode& node, const GraphSlot& slot)
{
    const std::string type = GraphTypeOfKind(slot.kind);
    const std::string dynamic = type.empty() ? DynamicType(scope, node) : type;
    const bool isRow = slot.kind == "DynamicVector" && IsGraphMatrix(dynamic);
    return isRow ? GraphVectorType(GraphWidth(dynamic)) : dynamic;
}

/// Returns the type of a node's dynamic slots: the shortest of the vectors that are connected with
/// them. Numbers do not count where there is a vector.
std::string GraphCode::DynamicType(GraphScope& scope, const GraphNode& node)
{
    const auto known = scope.dynamicTypes.find(node.id);
    if (known != scope.dynamicTypes.end())
    {
        return known->second;
    }
    int width = 0;
    std::string matrix;
    for (const GraphSlot& slot : node.slots)
    {
        matrix = matrix.empty() && slot.kind == "DynamicMatrix" ? "float4x4" : matrix;
        const std::optional<GraphOutput> source = scope.file.SourceOf(node, slot.id);
        if (!slot.isOutput && slot.isDynamic() && source)
        {
            const std::string type = Output(scope, *source->node, source->slot).type;
            const int own = GraphWidth(type);
            matrix = IsGraphMatrix(type) ? type : matrix;
            width = width <= 1 ? std::max(width, own) : own > 1 ? std::min(width, own) : width;
        }
    }
    return scope.dynamicTypes[node.id] = matrix.empty() ? GraphVectorType(width) : matrix;
}

/// Returns a value of the vertex or pixel, by the line of nodes.txt for a node.
GraphValue GraphCode::Geometry(const char* node, const Json& fields)
{
    const std::optional<NodeExpression> found = FindNodeExpression(node, fields, "Out");
    GraphNode asked;
    asked.fields = &fields;
    return found ? GraphValue{std::string_view(node) == "ScreenPosition" ? "float4" : "float3",
                              Expand(*m_Root, asked, found->text)}
                 : GraphValue{"float3", "float3(0, 0, 0)"};
}

GraphValue GraphCode::Unconnected(GraphScope& scope, const GraphNode& node, const GraphSlot& slot)
{
    const Json& fields = *slot.fields;
    const std::string& kind = slot.kind;
    const std::string type = TypeOf(scope, node, slot);
    if (kind == "UV")
    {
        const int channel = IntIn(fields, "m_Channel");
        return channel < 0 || channel > 3
                   ? Problem(node, "float4", "takes texture coordinates that limn does not have")
                   : GraphValue{"float4", Use("uv" + std::to_string(channel))};
    }
    if (kind == "VertexColor")
    {
        return {"float4", Use("VertexColor")};
    }
    if (kind == "SamplerState")
    {
        const auto texture =
            std::ranges::find_if(node.slots,
                                 [](const GraphSlot& other) {
                                     return !other.isOutput && (other.kind.starts_with("Texture") ||
                                                                other.kind == "Cubemap");
                                 });
        return texture == node.slots.end() || node.type == "CustomFunction"
                   ? Sampler(Json::object())
                   : Input(scope, node, *texture); // it has a sampler of its own
    }
    if (kind == "Gradient")
    {
        return Declared(type, GraphGradient(PartOf(fields, "m_Value")));
    }
    if (!GraphTextureDimension(kind).empty())
    {
        return TextureOf(node, slot);
    }
    if (kind == "ColorRGB" && NumberIn(fields, "m_ColorMode") == 0.0)
    {
        return {type, "limn_GraphColor(" + GraphConstant(type, fields) + ")"};
    }
    return kind == "Position"         ? Geometry("Position", fields)
           : kind == "Normal"         ? Geometry("NormalVector", fields)
           : kind == "Tangent"        ? Geometry("TangentVector", fields)
           : kind == "Bitangent"      ? Geometry("BitangentVector", fields)
           : kind == "ViewDirection"  ? Geometry("ViewDirection", fields)
           : kind == "ScreenPosition" ? Geometry("ScreenPosition", fields)
                                      : GraphValue{type, GraphConstant(type, fields)};
}

/// Returns the texture that a slot or a node names itself.
GraphValue GraphCode::TextureOf(const GraphNode& node, const GraphSlot& slot)
{
    const std::string dimension = GraphTextureDimension(slot.kind);
    if (dimension.empty())
    {
        return Problem(node, "UnityTexture2D", "gives a texture of a kind that limn does not know");
    }
    const Json& fields = slot.isOutput ? *node.fields : *slot.fields;
    const GraphAsset asset = ReadGraphTexture(slot.kind, fields);
    const std::string property =
        "_limn_" + NameOfNode(node) + "_" + std::to_string(slot.id & 0xffff) + "_Texture";
    const std::string type = GraphTypeOfKind(slot.kind);
    const bool isPlain = slot.kind == "Texture2D";
    m_Around.textures[property] = {property, dimension, isPlain ? GraphDefaultTexture(fields) : "",
                                   asset.guid, asset.fileID};
    return Declared(type, "UnityBuild" + type.substr(5) + (isPlain ? "StructNoScale(" : "Struct(") +
                              property + ")");
}

GraphValue GraphCode::Sampler(const Json& fields)
{
    const std::string name = GraphSamplerName(fields);
    m_Around.samplers.insert(name);
    return Declared("UnitySamplerState", "UnityBuildSamplerStateStruct(" + name + ")");
}

/// Returns the slot, of the node that uses a sub graph, that gives one of its properties. Returns
/// null in the graph itself, and for a property that the node does not know.
const GraphSlot* GraphCode::SlotOfProperty(const GraphScope& scope, const GraphNode& node) const
{
    const Json* property = scope.file.Find(PartOf(*node.fields, "m_Property"));
    if (scope.parent == nullptr || property == nullptr)
    {
        return nullptr;
    }
    const std::string guid = TextIn(PartOf(*property, "m_Guid"), "m_GuidSerialized");
    const Json& guids = PartOf(*scope.caller->fields, "m_PropertyGuids");
    const Json& ids = PartOf(*scope.caller->fields, "m_PropertyIds");
    for (std::size_t i = 0; i < guids.size() && i < ids.size(); ++i)
    {
        if (guids[i] == guid && ids[i].is_number_integer())
        {
            return scope.caller->FindSlot(ids[i].get<int>());
        }
    }
    // Until 2019 the node did not list them.
    return scope.caller->FindSlot(GraphReferenceName(*property), false);
}

GraphValue GraphCode::Property(GraphScope& scope, const GraphNode& node)
{
    const Json* property = scope.file.Find(PartOf(*node.fields, "m_Property"));
    const auto output = std::ranges::find(node.slots, true, &GraphSlot::isOutput);
    if (property == nullptr || output == node.slots.end())
    {
        return Problem(node, "float", "is a property that the graph does not have");
    }
    if (const GraphSlot* slot = SlotOfProperty(scope, node))
    {
        const std::string type = TypeOf(*scope.parent, *scope.caller, *slot);
        return {type, ConvertGraphValue(Input(*scope.parent, *scope.caller, *slot), type)};
    }
    const std::string type = GraphTypeOfKind(output->kind);
    const std::string kind = GraphTypeOf(*property);
    const std::string name = GraphReferenceName(*property);
    if (kind == "SamplerState")
    {
        return Sampler(PartOf(*property, "m_Value"));
    }
    if (kind == "Gradient")
    {
        return Declared(type, GraphGradient(PartOf(*property, "m_Value")));
    }
    if (scope.parent != nullptr)
    {
        return GraphWidth(type) > 0
                   ? GraphValue{type, GraphConstant(type, *property)}
                   : Problem(node, type, "is a property of a sub graph that nothing gives");
    }
    if (kind == "Texture2D")
    {
        return Declared(type, (NumberIn(*property, "useTilingAndOffset") != 0.0
                                   ? "UnityBuildTexture2DStruct("
                                   : "UnityBuildTexture2DStructNoScale(") +
                                  name + ")");
    }
    if (type.starts_with("Unity"))
    {
        return Declared(type, "UnityBuild" + type.substr(5) + "Struct(" + name + ")");
    }
    return {type, type == "bool" ? "(" + name + " != 0)" : name};
}

/// Multiplies numbers, or matrices with vectors and matrices.
GraphValue GraphCode::Multiplied(GraphScope& scope, const GraphNode& node)
{
    const GraphSlot* a = node.FindSlot("A", false);
    const GraphSlot* b = node.FindSlot("B", false);
    if (a == nullptr || b == nullptr)
    {
        return Problem(node, "float", "has no inputs A and B");
    }
    const std::string type = DynamicType(scope, node);
    const auto operand = [&](const GraphSlot& slot)
    {
        const GraphValue value = Input(scope, node, slot);
        const std::string own =
            IsGraphMatrix(type) && !IsGraphMatrix(value.type) && scope.file.SourceOf(node, slot.id)
                ? GraphVectorType(GraphWidth(type))
                : type;
        return GraphValue{own, ConvertGraphValue(value, own)};
    };
    const GraphValue left = operand(*a);
    const GraphValue right = operand(*b);
    if (!IsGraphMatrix(type))
    {
        return Declared(type, left.text + " * " + right.text);
    }
    const std::string result = !IsGraphMatrix(left.type)    ? left.type
                               : !IsGraphMatrix(right.type) ? right.type
                                                            : type;
    return Declared(result, "mul(" + left.text + ", " + right.text + ")");
}

const GraphFile* GraphCode::FindSubGraph(const std::string& guid, const GraphNode& node)
{
    const auto [known, isNew] = m_Around.subGraphs.try_emplace(guid);
    if (isNew)
    {
        const std::filesystem::path path = m_Around.files(guid);
        if (!path.empty())
        {
            known->second = std::make_unique<const GraphFile>(path);
        }
        else
        {
            Problem(node, "float",
                    "is a sub graph that the project does not have (guid " + guid + ")");
        }
    }
    return known->second.get();
}

GraphValue GraphCode::SubGraph(GraphScope& scope, const GraphNode& node, int slot)
{
    const std::string type = TypeOf(scope, node, *node.FindSlot(slot));
    const GraphFile* file =
        FindSubGraph(ReadGraphAsset(TextIn(*node.fields, "m_SerializedSubGraph")).guid, node);
    if (file == nullptr || scope.depth >= k_MaxDepth)
    {
        return file == nullptr ? GraphValue{type, "((" + type + ")0)"}
                               : Problem(node, type, "uses itself");
    }
    std::unique_ptr<GraphScope>& inner = scope.inner[node.id];
    if (!inner)
    {
        inner = std::make_unique<GraphScope>(*file, scope, node);
    }
    const GraphNode* output = file->FindNodeOfType("SubGraphOutput");
    const GraphSlot* result = output != nullptr ? output->FindSlot(slot) : nullptr;
    if (result == nullptr)
    {
        return Problem(node, type, "has an output that its sub graph lacks");
    }
    return {type, ConvertGraphValue(Input(*inner, *output, *result), type)};
}

/// Adds the text or the file of a custom function.
void GraphCode::AddFunction(const GraphNode& node, const std::string& name)
{
    const Json& fields = *node.fields;
    if (NumberIn(fields, "m_SourceType") == 0.0)
    {
        const std::string guid = TextIn(fields, "m_FunctionSource");
        const std::filesystem::path path = guid.empty() ? "" : m_Around.files(guid);
        if (path.empty())
        {
            Problem(node, "float",
                    "calls a function of a file that the project does not have (guid " + guid +
                        ")");
        }
        else if (std::ranges::find(m_Around.includes, path.generic_string()) ==
                 m_Around.includes.end())
        {
            m_Around.includes.push_back(path.generic_string());
        }
        return;
    }
    std::string parameters;
    for (const GraphSlot& slot : InputsFirst(node.slots))
    {
        const std::string type = GraphTypeOfKind(slot.kind);
        const bool isBare = NumberIn(*slot.fields, "m_BareResource") != 0.0;
        parameters += (parameters.empty() ? "" : ", ") + std::string(slot.isOutput ? "out " : "") +
                      (isBare && type.starts_with("Unity") ? type.substr(5) : type) + " " +
                      slot.name;
    }
    const std::string text = "        void " + name + "(" + parameters + ")\n        {\n" +
                             Replaced(TextIn(fields, "m_FunctionBody"), "$precision", "float") +
                             "\n        }\n";
    if (std::ranges::find(m_Around.functions, text) == m_Around.functions.end())
    {
        m_Around.functions.push_back(text);
    }
}

/// Calls a function of the author's.
GraphValue GraphCode::CustomFunction(GraphScope& scope, const GraphNode& node,
                                     const GraphSlot& asked)
{
    const bool isFile = NumberIn(*node.fields, "m_SourceType") == 0.0;
    std::string name = TextIn(*node.fields, "m_FunctionName");
    name += isFile ? (IsHalf(node, scope.file) ? "_half" : "_float") : "_" + NameOfNode(node);
    AddFunction(node, name);
    std::string arguments;
    std::string results;
    for (const GraphSlot& slot : InputsFirst(node.slots))
    {
        const std::string type = GraphTypeOfKind(slot.kind);
        std::string argument;
        if (slot.isOutput)
        {
            argument = "v" + std::to_string(m_Count++);
            results += "            " + type + " " + argument + " = (" + type + ")0;\n";
            scope.values[{node.id, std::to_string(slot.id)}] = {type, argument};
        }
        else
        {
            argument = ConvertGraphValue(Input(scope, node, slot), type);
            const bool isBare = NumberIn(*slot.fields, "m_BareResource") != 0.0;
            argument += !isBare || !type.starts_with("Unity") ? ""
                        : type == "UnitySamplerState"         ? ".samplerstate"
                                                              : ".tex";
        }
        arguments += (arguments.empty() ? "" : ", ") + argument;
    }
    m_Body += results + "            " + name + "(" + arguments + ");\n";
    return scope.values[{node.id, std::to_string(asked.id)}];
}

/// Chooses by a keyword of the shader: On, Off or the entry's slot.
GraphValue GraphCode::Keyword(GraphScope& scope, const GraphNode& node)
{
    const Json* keyword = scope.file.Find(PartOf(*node.fields, "m_Keyword"));
    const GraphSlot* output = node.FindSlot(0);
    if (keyword == nullptr || output == nullptr)
    {
        return Problem(node, "float", "is a keyword that the graph does not have");
    }
    const std::string name = GraphReferenceName(*keyword);
    m_Around.keywords[name] = keyword;
    const std::string type = TypeOf(scope, node, *output);
    const bool isEnum = NumberIn(*keyword, "m_KeywordType") == 1.0;
    std::vector<std::pair<std::string, std::string>> choices; // a condition and a value
    for (const GraphSlot& slot : node.slots)
    {
        if (!slot.isOutput)
        {
            std::string condition = slot.name == "On" ? name : "";
            for (const Json& entry : PartOf(*keyword, "m_Entries"))
            {
                if (isEnum && NumberIn(entry, "id") == slot.id)
                {
                    condition = name + "_" + TextIn(entry, "referenceName");
                }
            }
            choices.emplace_back(condition, ConvertGraphValue(Input(scope, node, slot), type));
        }
    }
    // The last choice, Off or the last entry, counts if no keyword is set.
    const std::string result = Declared(type, choices.empty() ? "0" : choices.back().second).text;
    for (const auto& [condition, value] : choices)
    {
        if (!condition.empty())
        {
            m_Body += "            #if defined(" + condition + ")\n            " + result + " = " +
                      value + ";\n            #endif\n";
        }
    }
    return {type, result};
}

/// Chooses by the entry that the node of the sub graph has selected.
GraphValue GraphCode::Dropdown(GraphScope& scope, const GraphNode& node)
{
    const Json* dropdown = scope.file.Find(PartOf(*node.fields, "m_Dropdown"));
    if (dropdown == nullptr)
    {
        return Problem(node, "float", "is a dropdown that the graph does not have");
    }
    const Json& entries = PartOf(*dropdown, "m_Entries");
    const auto index = static_cast<std::size_t>(std::max(IntIn(*dropdown, "m_Value"), 0));
    double id = index < entries.size() ? NumberIn(entries[index], "id") : 0.0;
    const Json none = Json::object();
    const Json& caller = scope.caller != nullptr ? *scope.caller->fields : none;
    const Json& names = PartOf(caller, "m_Dropdowns");
    const Json& selected = PartOf(caller, "m_DropdownSelectedEntries");
    for (std::size_t i = 0; i < names.size() && i < selected.size(); ++i)
    {
        for (const Json& entry : entries)
        {
            if (names[i] == GraphReferenceName(*dropdown) &&
                selected[i] == TextIn(entry, "displayName"))
            {
                id = NumberIn(entry, "id");
            }
        }
    }
    const GraphSlot* slot = node.FindSlot(static_cast<int>(id));
    return slot == nullptr || slot->isOutput ? Problem(node, "float", "has no such entry")
                                             : Input(scope, node, *slot);
}

} // namespace limn
