#pragma once

#include "console/Json.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// An input or output of a node.
struct GraphSlot
{
    int id = 0;
    std::string name; ///< as in shaders, without spaces; "" for a slot of a redirect
    std::string kind; ///< "Vector1", "DynamicVector", "UV" ...
    bool isOutput = false;
    const Json* fields = nullptr;

    bool isDynamic() const { return kind.starts_with("Dynamic"); }
};

/// A node of a graph.
struct GraphNode
{
    std::string id;
    std::string type;  ///< "Multiply", "Property", "Block" ...
    std::string title; ///< what the graph's window shows
    const Json* fields = nullptr;
    std::vector<GraphSlot> slots;

    const GraphSlot* FindSlot(int slotId) const;
    const GraphSlot* FindSlot(std::string_view name, bool isOutput) const;
};

/// An output of a node.
struct GraphOutput
{
    const GraphNode* node = nullptr;
    int slot = 0;
};

/// A .shadergraph or .shadersubgraph file: JSON objects one after another that refer to each other
/// by id (Shader Graph 10 to 17). Those of Shader Graph 4 to 8 are one object, and are read as if a
/// later version had saved them.
class GraphFile
{
public:
    /// Reads a file.
    /// @throws AssetError if there is none, or it is no such file
    explicit GraphFile(const std::filesystem::path& path);

    const std::filesystem::path& path() const { return m_Path; }
    /// Returns the object of the graph itself.
    const Json& graph() const { return *m_Graph; }
    /// Returns the object behind {"m_Id": ...}, or null.
    const Json* Find(const Json& reference) const;
    /// Returns the objects behind a list of references.
    /// @throws AssetError if one does not exist
    std::vector<const Json*> FindAll(const Json& references) const;
    /// Returns the first object of a type: "UniversalTarget". Returns null if there is none.
    const Json* FindOfType(std::string_view type) const;
    const GraphNode* FindNode(const Json& reference) const;
    const GraphNode* FindNodeOfType(std::string_view type) const;
    /// Returns what is connected with an input.
    std::optional<GraphOutput> SourceOf(const GraphNode& node, int slot) const;

private:
    void ReadObjects(const std::string& text);
    GraphNode ReadNode(const Json& fields) const;
    void ReadEdges();

    std::filesystem::path m_Path;
    std::vector<std::unique_ptr<const Json>> m_Objects;
    const Json* m_Graph = nullptr;
    std::map<std::string, const Json*, std::less<>> m_ById;
    std::map<std::string, GraphNode, std::less<>> m_Nodes;
    std::map<std::pair<std::string, int>, GraphOutput> m_Sources;
};

/// Returns the last name of an object's type without an ending: "Multiply" for
/// "UnityEditor.ShaderGraph.MultiplyNode".
std::string GraphTypeOf(const Json& fields);
/// Returns a field's text, or "" if there is none.
std::string TextIn(const Json& fields, const char* key);
/// Returns a field's number, or 0 if there is none; true is 1.
double NumberIn(const Json& fields, const char* key);
/// Returns the same as a whole number, the nearest that there is.
int IntIn(const Json& fields, const char* key);
/// Returns an object or list, or an empty object if there is none.
const Json& PartOf(const Json& fields, const char* key);

} // namespace limn
