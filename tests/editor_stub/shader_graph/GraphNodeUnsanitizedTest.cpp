// All nodes that limn knows, compiled with the slots that Unity gives them.

#include "GraphFixture.h"
#include "Paths.h"

#include <limn/base/ReadFile.h>
#include <limn/shaderlab/ShaderCompiler.h>

namespace limn::test
{
namespace
{

using NodeOfAGraph = GraphFolder;

struct NodeLine
{
    std::string type;
    std::string slots;
    std::string fields;
};

std::vector<NodeLine> NodeLines()
{
    std::vector<NodeLine> nodes;
    std::istringstream lines(ReadFile(SourcePath("tests/editor_stub/data/graph_nodes.txt")));
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream parts(line);
        NodeLine node;
        if (line.front() != '#' && std::getline(parts, node.type, '|') &&
            std::getline(parts, node.slots, '|'))
        {
            std::getline(parts, node.fields);
            nodes.push_back(node);
        }
    }
    return nodes;
}

/// Adds all outputs of the node to the sum behind them: the node and output that it ends with.
void AddOutputs(const NodeLine& line, GraphText& graph, std::pair<std::string, int>& sum)
{
    const std::string node = graph.Node(line.type, line.slots, line.fields);
    std::istringstream slots(line.slots);
    for (std::string slot; std::getline(slots, slot, ',');)
    {
        const std::size_t output = slot.find('>');
        const bool isTexture = slot.find("Texture2D") != std::string::npos;
        if (output == std::string::npos || isTexture)
        {
            continue;
        }
        // A product with a number first, which takes matrices, too.
        const std::string product =
            graph.Node("Multiply", "0 A DynamicValue, 1 B DynamicValue, >2 Out DynamicValue");
        graph.Connect(node, std::stoi(slot.substr(output + 1)), product, 0);
        const std::string added = graph.Node("Add", "0 A Vector1, 1 B Vector1, >2 Out Vector1");
        graph.Connect(product, 2, added, 0);
        graph.Connect(sum.first, sum.second, added, 1);
        sum = {added, 2};
    }
}

TEST_F(NodeOfAGraph, CompilesWithTheSlotsThatUnityGivesIt)
{
    const std::vector<NodeLine> nodes = NodeLines();
    ASSERT_GT(nodes.size(), 100u);
    ShaderCompiler compiler;
    for (const char* target : {"Unlit", "Fullscreen"})
    {
        for (std::size_t first = 0; first < nodes.size(); first += 30)
        {
            GraphText graph(target);
            std::pair<std::string, int> sum{graph.Node("Vector1", "1 X Vector1, >0 Out Vector1"),
                                            0};
            for (std::size_t i = first; i < std::min(first + 30, nodes.size()); ++i)
            {
                AddOutputs(nodes[i], graph, sum);
            }
            graph.Connect(sum.first, sum.second,
                          graph.Block("SurfaceDescription.BaseColor", "0 BaseColor ColorRGB"), 0);
            const ShaderLabDocument document = Parsed(graph);
            const PassProgram& program = *document.subShaders.front().passes.front().program;
            EXPECT_NO_THROW(compiler.Compile(compiler.ReadPragmas(program), {}))
                << target << " from " << nodes[first].type;
        }
    }
}

} // namespace
} // namespace limn::test
