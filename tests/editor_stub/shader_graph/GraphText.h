#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace limn::test
{

/// Writes a shader graph as Unity does: JSON objects that refer to each other by id.
class GraphText
{
public:
    /// @param target  the end of the type of the target's kind: "Unlit"
    /// @param fields  JSON of the target, such as "\"m_AlphaClip\": true"
    explicit GraphText(const std::string& target = "Unlit", const std::string& fields = "",
                       const std::string& subTargetFields = "")
    {
        Object("target", "UnityEditor.Rendering.Universal.ShaderGraph.UniversalTarget",
               "\"m_ActiveSubTarget\": {\"m_Id\": \"kind\"}" + Behind(fields));
        Object("kind",
               "UnityEditor.Rendering.Universal.ShaderGraph.Universal" + target + "SubTarget",
               subTargetFields);
    }

    /// Adds a node and returns its id.
    /// @param slots   "0 A DynamicVector, 1 B Vector2 = {\"x\": 3}, >2 Out DynamicVector"
    /// @param fields  JSON of the node
    std::string Node(const std::string& type, const std::string& slots,
                     const std::string& fields = "")
    {
        const std::string id = "node" + std::to_string(m_Nodes.size());
        m_Nodes.push_back(id);
        std::string list;
        for (std::size_t at = 0, end = 0; at < slots.size(); at = end + 1)
        {
            end = at;
            for (int depth = 0; end < slots.size() && (depth > 0 || slots[end] != ','); ++end)
            {
                depth += slots[end] == '{' ? 1 : slots[end] == '}' ? -1 : 0;
            }
            list += (list.empty() ? "" : ", ") + Slot(slots.substr(at, end - at));
        }
        const std::string ending = type == "SampleGradient" ? "" : "Node"; // Unity's own exception
        Object(id, "UnityEditor.ShaderGraph." + type + ending,
               "\"m_Name\": \"" + type + "\", \"m_Slots\": [" + list + "]" + Behind(fields));
        return id;
    }
    /// Adds a block of the fragment's or vertex's context: "SurfaceDescription.BaseColor".
    std::string Block(const std::string& descriptor, const std::string& slot)
    {
        const std::string id =
            Node("Block", slot, "\"m_SerializedDescriptor\": \"" + descriptor + "\"");
        (descriptor.starts_with("Vertex") ? m_VertexBlocks : m_FragmentBlocks).push_back(id);
        return id;
    }
    /// Adds a property and a node of it, whose output is 0. Returns the node's id.
    std::string Property(const std::string& kind, const std::string& name,
                         const std::string& fields, const std::string& slotKind)
    {
        const std::string id = "property" + std::to_string(m_Properties.size());
        m_Properties.push_back(id);
        Object(id, "UnityEditor.ShaderGraph.Internal." + kind + "ShaderProperty",
               "\"m_Guid\": {\"m_GuidSerialized\": \"" + id + "\"}, \"m_Name\": \"" + name +
                   "\", \"m_DefaultReferenceName\": \"" + name +
                   "\", \"m_GeneratePropertyBlock\": true" + Behind(fields));
        return Node("Property", ">0 " + name + " " + slotKind,
                    "\"m_Property\": {\"m_Id\": \"" + id + "\"}");
    }
    /// Adds a keyword.
    void Keyword(const std::string& name, const std::string& fields)
    {
        m_Keywords.push_back("keyword" + name);
        Object("keyword" + name, "UnityEditor.ShaderGraph.ShaderKeyword",
               "\"m_Name\": \"" + name + "\", \"m_DefaultReferenceName\": \"" + name + "\"" +
                   Behind(fields));
    }
    void Connect(const std::string& from, int output, const std::string& to, int input)
    {
        m_Edges += std::string(m_Edges.empty() ? "" : ", ") +
                   "{\"m_OutputSlot\": {\"m_Node\": {\"m_Id\": \"" + from +
                   "\"}, \"m_SlotId\": " + std::to_string(output) +
                   "}, \"m_InputSlot\": {\"m_Node\": {\"m_Id\": \"" + to +
                   "\"}, \"m_SlotId\": " + std::to_string(input) + "}}";
    }
    /// Adds an object that nothing but the graph's file has.
    void Object(const std::string& id, const std::string& type, const std::string& fields)
    {
        m_Objects += "{\"m_ObjectId\": \"" + id + "\", \"m_Type\": \"" + type + "\"" +
                     Behind(fields) + "}\n\n";
    }

    /// @param more  JSON of the graph itself
    std::string text(const std::string& more = "") const
    {
        return "{\"m_SGVersion\": 3, \"m_Type\": \"UnityEditor.ShaderGraph.GraphData\", "
               "\"m_ObjectId\": \"graph\", \"m_Path\": \"Tests\"" +
               Behind(more) +
               ", \"m_ActiveTargets\": "
               "[{\"m_Id\": \"target\"}], \"m_Properties\": " +
               List(m_Properties) + ", \"m_Keywords\": " + List(m_Keywords) +
               ", \"m_Nodes\": " + List(m_Nodes) + ", \"m_Edges\": [" + m_Edges +
               "], \"m_VertexContext\": {\"m_Blocks\": " + List(m_VertexBlocks) +
               "}, \"m_FragmentContext\": {\"m_Blocks\": " + List(m_FragmentBlocks) + "}}\n\n" +
               m_Objects;
    }

private:
    static std::string Behind(const std::string& fields)
    {
        return fields.empty() ? "" : ", " + fields;
    }
    static std::string List(const std::vector<std::string>& ids)
    {
        std::string list;
        for (const std::string& id : ids)
        {
            list += (list.empty() ? "" : ", ") + ("{\"m_Id\": \"" + id + "\"}");
        }
        return "[" + list + "]";
    }
    /// Adds a slot and returns the reference to it.
    std::string Slot(const std::string& text)
    {
        std::istringstream words(text);
        std::string number;
        std::string name;
        std::string kind;
        words >> number >> name >> kind;
        const std::size_t value = text.find('=');
        const bool isOutput = number.front() == '>';
        const std::string id = "slot" + std::to_string(m_Slots++);
        Object(id, "UnityEditor.ShaderGraph." + kind + "MaterialSlot",
               "\"m_Id\": " + number.substr(isOutput ? 1 : 0) + ", \"m_ShaderOutputName\": \"" +
                   name + "\", \"m_SlotType\": " + (isOutput ? "1" : "0") +
                   (value == std::string::npos ? "" : ", \"m_Value\": " + text.substr(value + 1)));
        return "{\"m_Id\": \"" + id + "\"}";
    }

    std::string m_Objects;
    std::string m_Edges;
    std::vector<std::string> m_Nodes;
    std::vector<std::string> m_Properties;
    std::vector<std::string> m_Keywords;
    std::vector<std::string> m_VertexBlocks;
    std::vector<std::string> m_FragmentBlocks;
    int m_Slots = 0;
};

} // namespace limn::test
