#include "unity/ProjectShaders.h"

#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

namespace
{

/// The shaders of a project by name, which are read when one of them is asked for.
class ProjectShaders
{
public:
    ProjectShaders(const UnityProject& project, AssetContext& assets, GraphTranslator graph)
        : m_Project(project), m_Assets(assets), m_Graph(std::move(graph))
    {
    }

    std::shared_ptr<const Shader> Find(std::string_view name)
    {
        if (!m_IsRead)
        {
            m_IsRead = true;
            ReadNames();
        }
        if (const auto file = m_Files.find(name); file != m_Files.end())
        {
            return m_Assets.LoadShader(file->second);
        }
        const auto [graph, isNew] = m_Graphs.try_emplace(std::string(name));
        graph->second = isNew ? FindGraph(name) : graph->second;
        return graph->second;
    }

private:
    void ReadNames()
    {
        for (const std::filesystem::path& file : m_Project.FilesOf(".shader"))
        {
            try
            {
                m_Files.emplace(LoadShaderLab(file).name, file);
            }
            catch (const AssetError&) // it says so where the shader is used
            {
            }
        }
    }

    /// A graph's name ends with its file's: "Shader Graphs/Water".
    std::shared_ptr<const Shader> FindGraph(std::string_view name)
    {
        const std::string_view stem = name.substr(name.rfind('/') + 1); // of npos as well
        for (const std::filesystem::path& file : m_Project.FilesOf(".shadergraph"))
        {
            auto shader = m_Graph && file.stem() == stem ? m_Graph(file, m_Assets)
                                                         : std::shared_ptr<const Shader>();
            if (shader && shader->name() == name)
            {
                return shader;
            }
        }
        return nullptr;
    }

    const UnityProject m_Project;
    AssetContext& m_Assets;
    const GraphTranslator m_Graph;
    bool m_IsRead = false;
    std::map<std::string, std::filesystem::path, std::less<>> m_Files;
    std::map<std::string, std::shared_ptr<const Shader>, std::less<>> m_Graphs;
};

} // namespace

void UseShadersOf(const UnityProject& project, AssetContext& assets, GraphTranslator graph)
{
    const auto shaders = std::make_shared<ProjectShaders>(project, assets, std::move(graph));
    assets.shaderSource()->SetOthers([shaders](std::string_view name)
                                     { return shaders->Find(name); });
}

} // namespace limn
