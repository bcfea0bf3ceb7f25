#include "shader_graph/OldGraph.h"

#include "console/Texts.h"
#include "shader_graph/GraphFile.h"

namespace limn
{

namespace
{

constexpr const char* k_Namespace = "UnityEditor.ShaderGraph.";

/// Reads an object that stands as text in another one, with its type beside it.
Json ReadInner(const Json& element)
{
    Json object = Json::parse(TextIn(element, "JSONnodeData"));
    object["m_Type"] = TextIn(PartOf(element, "typeInfo"), "fullName");
    return object;
}

Json Reference(const std::string& id)
{
    return {{"m_Id", id}};
}

/// Returns the block that a slot of a master node became: "SurfaceDescription.BaseColor".
std::string BlockOf(const std::string& slot)
{
    if (slot.starts_with("Vertex ") || slot == "Position")
    {
        return "VertexDescription." + slot.substr(slot.find(' ') + 1);
    }
    return "SurfaceDescription." + (slot == "Albedo" || slot == "Color" ? "BaseColor"
                                    : slot == "Normal"                  ? "NormalTS"
                                                                        : slot);
}

/// The objects of the later form, as they are made.
class Upgrade
{
public:
    std::vector<Json> Objects(const Json& old);

private:
    void AddNode(Json node);
    void AddMaster(const Json& master, const std::vector<Json>& slots);
    /// Adds objects of a list and returns references to them.
    Json AddAll(const Json& list);
    void AddEdge(const Json& edge);
    bool IsConnected(const std::string& node, int slot) const;

    std::vector<Json> m_Objects;
    Json m_Graph{{"m_Type", "UnityEditor.ShaderGraph.GraphData"},
                 {"m_Nodes", Json::array()},
                 {"m_Edges", Json::array()},
                 {"m_ActiveTargets", Json::array()}};
    Json m_VertexBlocks = Json::array();
    Json m_FragmentBlocks = Json::array();
    std::string m_Master; ///< the id of the master node
};

Json Upgrade::AddAll(const Json& list)
{
    Json references = Json::array();
    for (const Json& element : list)
    {
        Json object = ReadInner(element);
        const std::string id = TextIn(PartOf(object, "m_Guid"), "m_GuidSerialized");
        const std::string type = TextIn(object, "m_Type");
        object["m_Type"] = Replaced(type, ".TextureShaderProperty", ".Texture2DShaderProperty");
        object["m_ObjectId"] = id;
        references.push_back(Reference(id));
        m_Objects.push_back(std::move(object));
    }
    return references;
}

void Upgrade::AddNode(Json node)
{
    const std::string id = TextIn(node, "m_GuidSerialized");
    std::vector<Json> slots;
    Json references = Json::array();
    for (const Json& element : PartOf(node, "m_SerializableSlots"))
    {
        Json slot = ReadInner(element);
        slot["m_ObjectId"] = id + " " + std::to_string(IntIn(slot, "m_Id"));
        slot["m_BareResource"] = true; // functions took textures themselves then
        if (TextIn(slot, "m_ShaderOutputName") == "Input")
        {
            slot["m_ShaderOutputName"] = "In"; // the name that the node Split has later
        }
        references.push_back(Reference(TextIn(slot, "m_ObjectId")));
        slots.push_back(slot);
        m_Objects.push_back(std::move(slot));
    }
    if (TextIn(node, "m_Type").ends_with("MasterNode"))
    {
        m_Master = id;
        AddMaster(node, slots);
        return;
    }
    node["m_ObjectId"] = id;
    node["m_Slots"] = std::move(references);
    node["m_Property"] = Reference(TextIn(node, "m_PropertyGuidSerialized"));
    node["m_Keyword"] = Reference(TextIn(node, "m_KeywordGuidSerialized"));
    m_Graph["m_Nodes"].push_back(Reference(id));
    m_Objects.push_back(std::move(node));
}

/// Adds the target, and a block for each slot. A block has the id of its slot in the master node,
/// with "block" before it.
void Upgrade::AddMaster(const Json& master, const std::vector<Json>& slots)
{
    bool isCut = false;
    for (const Json& slot : slots)
    {
        const std::string block = BlockOf(TextIn(slot, "m_ShaderOutputName"));
        const std::string id = "block " + TextIn(slot, "m_ObjectId");
        isCut = isCut ||
                (block.ends_with("AlphaClipThreshold") &&
                 (NumberIn(slot, "m_Value") > 0.0 || IsConnected(m_Master, IntIn(slot, "m_Id"))));
        (block.starts_with("Vertex") ? m_VertexBlocks : m_FragmentBlocks).push_back(Reference(id));
        m_Objects.push_back({{"m_Type", std::string(k_Namespace) + "BlockNode"},
                             {"m_ObjectId", id},
                             {"m_Name", block},
                             {"m_SerializedDescriptor", block},
                             {"m_Slots", Json::array({Reference(TextIn(slot, "m_ObjectId"))})}});
    }
    const std::string type = TextIn(master, "m_Type");
    const std::string kind = type.ends_with(".PBRMasterNode")     ? "UniversalLitSubTarget"
                             : type.ends_with(".UnlitMasterNode") ? "UniversalUnlitSubTarget"
                             : type.find(".Sprite") != std::string::npos
                                 ? "UniversalSpriteUnlitSubTarget"
                                 : type;
    m_Objects.push_back({{"m_Type", kind},
                         {"m_ObjectId", "target's kind"},
                         {"m_WorkflowMode", IntIn(master, "m_Model")}});
    m_Objects.push_back({{"m_Type", "UniversalTarget"},
                         {"m_ObjectId", "target"},
                         {"m_ActiveSubTarget", Reference("target's kind")},
                         {"m_SurfaceType", IntIn(master, "m_SurfaceType")},
                         {"m_AlphaMode", IntIn(master, "m_AlphaMode")},
                         {"m_TwoSided", NumberIn(master, "m_TwoSided") != 0.0},
                         {"m_AlphaClip", isCut}});
    m_Graph["m_ActiveTargets"].push_back(Reference("target"));
}

bool Upgrade::IsConnected(const std::string& node, int slot) const
{
    return std::ranges::any_of(m_Graph["m_Edges"],
                               [&](const Json& edge)
                               {
                                   const Json& to = PartOf(edge, "m_InputSlot");
                                   return TextIn(PartOf(to, "m_Node"), "m_Id") == node &&
                                          IntIn(to, "m_SlotId") == slot;
                               });
}

void Upgrade::AddEdge(const Json& edge)
{
    Json upgraded;
    for (const char* end : {"m_OutputSlot", "m_InputSlot"})
    {
        const Json& old = PartOf(edge, end);
        upgraded[end] = {{"m_Node", Reference(TextIn(old, "m_NodeGUIDSerialized"))},
                         {"m_SlotId", IntIn(old, "m_SlotId")}};
    }
    m_Graph["m_Edges"].push_back(std::move(upgraded));
}

std::vector<Json> Upgrade::Objects(const Json& old)
{
    m_Graph["m_Path"] = TextIn(old, "m_Path");
    m_Graph["m_ConcretePrecision"] = IntIn(old, "m_ConcretePrecision");
    m_Graph["m_Properties"] = AddAll(PartOf(old, "m_SerializedProperties"));
    m_Graph["m_Keywords"] = AddAll(PartOf(old, "m_SerializedKeywords"));
    for (const Json& edge : PartOf(old, "m_SerializableEdges"))
    {
        AddEdge(ReadInner(edge));
    }
    for (const Json& node : PartOf(old, "m_SerializableNodes"))
    {
        AddNode(ReadInner(node));
    }
    for (Json& edge : m_Graph["m_Edges"]) // what led to the master node leads to its blocks
    {
        Json& to = edge["m_InputSlot"];
        if (TextIn(PartOf(to, "m_Node"), "m_Id") == m_Master)
        {
            to["m_Node"] =
                Reference("block " + m_Master + " " + std::to_string(IntIn(to, "m_SlotId")));
        }
    }
    m_Graph["m_VertexContext"] = {{"m_Blocks", m_VertexBlocks}};
    m_Graph["m_FragmentContext"] = {{"m_Blocks", m_FragmentBlocks}};
    m_Objects.push_back(m_Graph);
    return std::move(m_Objects);
}

} // namespace

bool IsOldGraph(const Json& graph)
{
    return graph.contains("m_SerializableNodes");
}

std::vector<Json> UpgradeGraph(const Json& graph)
{
    return Upgrade().Objects(graph);
}

} // namespace limn
