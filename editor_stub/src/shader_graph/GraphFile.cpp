#include "shader_graph/GraphFile.h"

#include "console/Texts.h"
#include "shader_graph/OldGraph.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/ReadFile.h>
#include <sstream>

namespace limn
{

std::string GraphTypeOf(const Json& fields)
{
    std::string type = TextIn(fields, "m_Type");
    type.erase(0, type.rfind('.') + 1);
    for (const std::string_view ending : {"Node", "MaterialSlot", "ShaderProperty"})
    {
        if (type.ends_with(ending))
        {
            type.resize(type.size() - ending.size());
            break;
        }
    }
    return type;
}

std::string TextIn(const Json& fields, const char* key)
{
    const auto found = fields.find(key);
    return found != fields.end() && found->is_string() ? found->get<std::string>() : "";
}

double NumberIn(const Json& fields, const char* key)
{
    const auto found = fields.find(key);
    if (found != fields.end() && found->is_boolean())
    {
        return found->get<bool>() ? 1.0 : 0.0;
    }
    return found != fields.end() && found->is_number() ? found->get<double>() : 0.0;
}

int IntIn(const Json& fields, const char* key)
{
    return static_cast<int>(std::clamp(NumberIn(fields, key), -2147483648.0, 2147483647.0));
}

const Json& PartOf(const Json& fields, const char* key)
{
    static const Json nothing = Json::object();
    const auto found = fields.find(key);
    return found != fields.end() && found->is_structured() ? *found : nothing;
}

const GraphSlot* GraphNode::FindSlot(int slotId) const
{
    const auto found = std::ranges::find(slots, slotId, &GraphSlot::id);
    return found == slots.end() ? nullptr : &*found;
}

const GraphSlot* GraphNode::FindSlot(std::string_view name, bool isOutput) const
{
    const auto found =
        std::ranges::find_if(slots, [&](const GraphSlot& slot)
                             { return slot.name == name && slot.isOutput == isOutput; });
    return found == slots.end() ? nullptr : &*found;
}

GraphFile::GraphFile(const std::filesystem::path& path) : m_Path(path)
{
    ReadObjects(ReadFile(path));
    for (const std::unique_ptr<const Json>& object : m_Objects)
    {
        if (object->contains("m_Slots"))
        {
            GraphNode node = ReadNode(*object);
            m_Nodes.emplace(node.id, std::move(node));
        }
    }
    FindAll(PartOf(graph(), "m_Nodes")); // an error if one is missing
    ReadEdges();
}

void GraphFile::ReadObjects(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<Json> objects;
    try
    {
        while (stream >> std::ws && !stream.eof())
        {
            Json object;
            stream >> object;
            if (object.is_object())
            {
                objects.push_back(std::move(object));
            }
        }
        if (objects.size() == 1 && IsOldGraph(objects.front()))
        {
            objects = UpgradeGraph(objects.front());
        }
    }
    catch (const Json::exception&)
    {
        throw AssetError(m_Path.generic_string(), {},
                         "it is no shader graph, which is JSON; the object that begins behind "
                         "number " +
                             std::to_string(objects.size()) + " cannot be read");
    }
    for (Json& object : objects)
    {
        m_Objects.push_back(std::make_unique<const Json>(std::move(object)));
        m_ById.emplace(TextIn(*m_Objects.back(), "m_ObjectId"), m_Objects.back().get());
    }
    m_Graph = FindOfType("GraphData");
    if (m_Graph == nullptr)
    {
        throw AssetError(m_Path.generic_string(), {},
                         "it is no shader graph; one has an object of the type GraphData, or "
                         "before Unity 2020.2 the key m_SerializableNodes");
    }
}

GraphNode GraphFile::ReadNode(const Json& fields) const
{
    GraphNode node{
        TextIn(fields, "m_ObjectId"), GraphTypeOf(fields), TextIn(fields, "m_Name"), &fields, {}};
    for (const Json* slot : FindAll(PartOf(fields, "m_Slots")))
    {
        std::string kind = GraphTypeOf(*slot);
        if (kind.ends_with("Input")) // as in Texture2DInput
        {
            kind.resize(kind.size() - std::string_view("Input").size());
        }
        node.slots.push_back({IntIn(*slot, "m_Id"),
                              Replaced(TextIn(*slot, "m_ShaderOutputName"), " ", ""), kind,
                              NumberIn(*slot, "m_SlotType") == 1.0, slot});
    }
    return node;
}

void GraphFile::ReadEdges()
{
    for (const Json& edge : PartOf(graph(), "m_Edges"))
    {
        const Json& from = PartOf(edge, "m_OutputSlot");
        const Json& to = PartOf(edge, "m_InputSlot");
        const GraphNode* source = FindNode(PartOf(from, "m_Node"));
        const GraphNode* target = FindNode(PartOf(to, "m_Node"));
        if (source != nullptr && target != nullptr)
        {
            m_Sources[{target->id, IntIn(to, "m_SlotId")}] = {source, IntIn(from, "m_SlotId")};
        }
    }
}

const Json* GraphFile::Find(const Json& reference) const
{
    const auto found = m_ById.find(TextIn(reference, "m_Id"));
    return found == m_ById.end() ? nullptr : found->second;
}

std::vector<const Json*> GraphFile::FindAll(const Json& references) const
{
    std::vector<const Json*> found;
    for (const Json& reference : references)
    {
        const Json* object = Find(reference);
        if (object == nullptr)
        {
            throw AssetError(m_Path.generic_string(), {},
                             "the graph refers to an object that the file does not have (m_Id " +
                                 TextIn(reference, "m_Id") + ")");
        }
        found.push_back(object);
    }
    return found;
}

const Json* GraphFile::FindOfType(std::string_view type) const
{
    const auto found = std::ranges::find_if(m_Objects, [&](const auto& object)
                                            { return GraphTypeOf(*object) == type; });
    return found == m_Objects.end() ? nullptr : found->get();
}

const GraphNode* GraphFile::FindNode(const Json& reference) const
{
    const auto found = m_Nodes.find(TextIn(reference, "m_Id"));
    return found == m_Nodes.end() ? nullptr : &found->second;
}

const GraphNode* GraphFile::FindNodeOfType(std::string_view type) const
{
    const auto found =
        std::ranges::find_if(m_Nodes, [&](const auto& item) { return item.second.type == type; });
    return found == m_Nodes.end() ? nullptr : &found->second;
}

std::optional<GraphOutput> GraphFile::SourceOf(const GraphNode& node, int slot) const
{
    const auto found = m_Sources.find({node.id, slot});
    return found == m_Sources.end() ? std::nullopt : std::optional(found->second);
}

} // namespace limn
