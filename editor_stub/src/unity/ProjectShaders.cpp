#include "unity/ProjectShaders.h"

#include <limn/core/Resources.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

namespace
{

/// The shaders of a project by name, which are read when one of them is asked for, and the files
/// of its folders Resources.
class ProjectShaders final : public ResourceFolders
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

    std::shared_ptr<const Shader> FindShader(std::string_view path) override
    {
        if (const auto file = FindResource(path, {".shader"}); !file.empty())
        {
            return m_Assets.LoadShader(file);
        }
        const auto graph = m_Graph ? FindResource(path, {".shadergraph"}) : std::filesystem::path();
        return graph.empty() ? nullptr : m_Graph(graph, m_Assets);
    }
    std::shared_ptr<const Texture> FindTexture(std::string_view path) override
    {
        const auto file = FindResource(path, {".png", ".tga", ".jpg", ".jpeg", ".tif", ".tiff",
                                              ".bmp", ".psd", ".exr", ".hdr"});
        return file.empty() ? nullptr : m_Assets.LoadTexture(file);
    }
    std::shared_ptr<ComputeShader> FindComputeShader(std::string_view path) override
    {
        const auto file = FindResource(path, {".compute"});
        return file.empty() ? nullptr : ComputeShader::Load(file, m_Assets.compiler());
    }

private:
    /// Returns the file of a folder Resources, or "" if there is none.
    std::filesystem::path FindResource(std::string_view path,
                                       std::initializer_list<std::string_view> extensions) const
    {
        const std::string end = "/Resources/" + std::string(path);
        for (const std::string_view extension : extensions)
        {
            for (const std::filesystem::path& file : m_Project.FilesOf(extension))
            {
                const std::string name =
                    std::filesystem::path(file).replace_extension().generic_string();
                if (name.ends_with(end))
                {
                    return file;
                }
            }
        }
        return {};
    }
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
    assets.shaderSource()->SetResources(shaders);
}

} // namespace limn
