#pragma once

#include "GraphText.h"
#include "Mentions.h"
#include "TemporaryFolder.h"
#include "shader_graph/GraphShader.h"

#include <gmock/gmock.h>

namespace limn::test
{

/// A folder of graphs, found by guids that are their names without an ending.
class GraphFolder : public testing::Test
{
protected:
    void Write(const std::string& name, const std::string& text)
    {
        m_Folder.Write(name, text);
        m_Files[name.substr(0, name.find('.'))] = m_Folder / name;
    }
    TranslatedGraph Translate(const GraphText& graph)
    {
        Write("a.shadergraph", graph.text());
        return TranslateGraph(m_Folder / "a.shadergraph",
                              [this](const std::string& guid) { return m_Files[guid]; });
    }
    ShaderLabDocument Parsed(const GraphText& graph)
    {
        const std::string text = Translate(graph).shaderLab;
        ShaderLabParseResult result = ParseShaderLab(text, (m_Folder / "a.shadergraph"));
        EXPECT_EQ(result.diagnostics, std::vector<Diagnostic>()) << text;
        return result.TakeDocument();
    }
    /// Returns what is wrong with a file.
    std::vector<std::string> Problems(const std::string& text)
    {
        std::vector<std::string> problems;
        Write("a.shadergraph", text);
        try
        {
            TranslateGraph(m_Folder / "a.shadergraph",
                           [this](const std::string& guid) { return m_Files[guid]; });
        }
        catch (const AssetError& error)
        {
            for (const Diagnostic& problem : error.diagnostics())
            {
                problems.push_back(problem.message);
            }
        }
        return problems;
    }

    TemporaryFolder m_Folder;
    std::map<std::string, std::filesystem::path> m_Files;
};

} // namespace limn::test
