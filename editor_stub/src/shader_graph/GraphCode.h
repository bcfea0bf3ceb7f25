#pragma once

#include "shader_graph/GraphNodes.h"
#include "shader_graph/GraphValue.h"

#include <functional>
#include <set>

namespace limn
{

/// Files of a project, by their guids. Returns "" for one that it does not have.
using GraphFiles = std::function<std::filesystem::path(const std::string& guid)>;

/// A texture that a graph itself names.
struct GraphTexture
{
    std::string property;
    std::string dimension;   ///< "2D", "Cube" ...
    std::string defaultName; ///< "white" ...; "" for a cube and the like
    std::string guid;        ///< "" if the graph names none
    std::int64_t fileID = 0;
};

/// The declarations that the code of all stages of a graph needs around it.
struct GraphSurroundings
{
    const GraphFiles& files;
    std::map<std::string, std::unique_ptr<const GraphFile>> subGraphs{}; ///< by guid
    std::map<std::string, GraphTexture> textures{};                      ///< by property
    std::set<std::string> samplers{};
    std::vector<std::string> includes{};           ///< files of custom functions
    std::vector<std::string> functions{};          ///< the text of custom functions
    std::set<std::string> problems{};              ///< why the graph cannot be translated
    std::map<std::string, const Json*> keywords{}; ///< by name
};

class GraphScope;

/// The code of one stage of a graph.
class GraphCode
{
public:
    GraphCode(const GraphFile& file, GraphStage stage, GraphSurroundings& around);
    ~GraphCode();
    GraphCode(const GraphCode&) = delete;
    GraphCode& operator=(const GraphCode&) = delete;

    /// Returns the value of a node's input, in its type, and adds the code that computes it.
    GraphValue InputOf(const GraphNode& node, const GraphSlot& slot);

    /// Returns the statements that have been added.
    const std::string& body() const { return m_Body; }
    /// Returns the names of inputs.txt that the code uses, each behind those that it uses itself.
    const std::vector<std::string>& inputs() const { return m_Inputs; }

private:
    // Each returns a value and adds the code that computes it.
    GraphValue Input(GraphScope& scope, const GraphNode& node, const GraphSlot& slot);
    GraphValue Output(GraphScope& scope, const GraphNode& node, int slot);
    GraphValue Evaluate(GraphScope& scope, const GraphNode& node, const GraphSlot& slot);
    GraphValue FromTable(GraphScope& scope, const GraphNode& node, const GraphSlot& slot);
    GraphValue Between(GraphScope& scope, const GraphNode& node, const std::string& name,
                       const NodeExpression& expression);
    /// Returns an expression of nodes.txt with values in place of names.
    std::string Expand(GraphScope& scope, const GraphNode& node, const std::string& text);
    std::string Named(GraphScope& scope, const GraphNode& node, const std::string& word);
    // The type of a slot; of those that take what is connected with them, that of the node.
    std::string TypeOf(GraphScope& scope, const GraphNode& node, const GraphSlot& slot);
    std::string DynamicType(GraphScope& scope, const GraphNode& node);
    GraphValue Unconnected(GraphScope& scope, const GraphNode& node, const GraphSlot& slot);
    // Nodes and slots that no line of nodes.txt describes.
    GraphValue Geometry(const char* node, const Json& fields);
    GraphValue TextureOf(const GraphNode& node, const GraphSlot& slot);
    GraphValue Sampler(const Json& fields);
    const GraphSlot* SlotOfProperty(const GraphScope& scope, const GraphNode& node) const;
    GraphValue Property(GraphScope& scope, const GraphNode& node);
    GraphValue Multiplied(GraphScope& scope, const GraphNode& node);
    GraphValue SubGraph(GraphScope& scope, const GraphNode& node, int slot);
    GraphValue CustomFunction(GraphScope& scope, const GraphNode& node, const GraphSlot& slot);
    GraphValue Keyword(GraphScope& scope, const GraphNode& node);
    GraphValue Dropdown(GraphScope& scope, const GraphNode& node);
    /// Adds a variable.
    GraphValue Declared(const std::string& type, const std::string& text);
    /// Notes that the code uses a value of inputs.txt. Returns its name in the code.
    std::string Use(const std::string& input);
    /// Notes why the graph cannot be translated. Returns a value to go on with.
    GraphValue Problem(const GraphNode& node, const std::string& type, const std::string& why);
    const GraphFile* FindSubGraph(const std::string& guid, const GraphNode& node);
    void AddFunction(const GraphNode& node, const std::string& name);

    GraphStage m_Stage;
    GraphSurroundings& m_Around;
    std::unique_ptr<GraphScope> m_Root;
    std::string m_Body;
    std::vector<std::string> m_Inputs;
    int m_Count = 0; ///< of variables
    int m_Depth = 0; ///< of the nodes that are being evaluated
};

} // namespace limn
