#include "UsedShaders.h"

#include <future>
#include <limn/core/Inspector.h>
#include <map>
#include <set>

namespace limn
{

namespace
{

using ShaderPasses = std::map<std::shared_ptr<const Shader>, std::set<int>>;

/// Finds the shaders among a feature's settings.
class ShaderFinder final : public Inspector
{
public:
    explicit ShaderFinder(ShaderPasses& passes) : m_Passes(passes) {}

    void Header(std::string_view) override {}
    void Field(std::string_view, bool&, std::string_view) override {}
    void Field(std::string_view, int&, FieldRange, std::string_view) override {}
    void Field(std::string_view, float&, FieldRange, std::string_view) override {}
    void Field(std::string_view, Color&, std::string_view) override {}
    void Field(std::string_view, LayerMask&, std::string_view) override {}
    void Field(std::string_view, RenderPassEvent&, std::string_view) override {}
    void Field(std::string_view, std::shared_ptr<const Shader>& shader, std::string_view) override
    {
        for (int pass = 0; shader && pass < shader->passCount(); ++pass)
        {
            m_Passes[shader].insert(pass);
        }
    }
    void Field(std::string_view, std::shared_ptr<const Material>& material,
               std::string_view) override
    {
        for (int pass = 0; material && pass < material->passCount(); ++pass)
        {
            m_Passes[material->shader()].insert(pass);
        }
    }
    void Field(std::string_view, glm::vec4&, std::string_view) override {}
    void Field(std::string_view, std::string&, std::string_view) override {}
    void Field(std::string_view, std::vector<std::string>&, std::string_view) override {}
    void BeginGroup(std::string_view) override {}
    void EndGroup() override {}
    void RenderingLayerIndex(std::string_view, int&, std::string_view) override {}
    void EnumField(std::string_view, int&, std::span<const EnumEntry>, std::string_view) override {}

private:
    ShaderPasses& m_Passes;
};

/// The LightMode tags that UniversalRenderer draws objects with.
const ShaderTagId k_DrawnTags[] = {ShaderTagId("SRPDefaultUnlit"), ShaderTagId("UniversalForward"),
                                   ShaderTagId("UniversalForwardOnly")};

void AddObjectShaders(const Scene& scene, ShaderPasses& passes)
{
    for (const auto& object : scene.objects())
    {
        if (!object->activeSelf || !object->renderer)
        {
            continue;
        }
        for (const auto& material : object->renderer->sharedMaterials)
        {
            for (const ShaderTagId tag : k_DrawnTags)
            {
                const int pass = material->shader()->FindPassByLightMode(tag);
                if (pass >= 0)
                {
                    passes[material->shader()].insert(pass);
                }
            }
        }
    }
}

std::vector<Diagnostic> Compile(const Shader& shader, const std::set<int>& passes)
{
    std::vector<Diagnostic> problems;
    for (const int pass : passes)
    {
        try
        {
            shader.Compile(pass);
        }
        catch (const AssetError& error)
        {
            problems.insert(problems.end(), error.diagnostics().begin(), error.diagnostics().end());
        }
    }
    return problems;
}

} // namespace

void CompileUsedShaders(const SceneAsset& asset)
{
    ShaderPasses passes;
    AddObjectShaders(asset.scene, passes);
    ShaderFinder finder(passes);
    for (const auto& feature : asset.renderer.features)
    {
        if (feature->isActive())
        {
            feature->Describe(finder);
        }
    }
    std::vector<std::future<std::vector<Diagnostic>>> running;
    for (const auto& [shader, indices] : passes)
    {
        running.push_back(
            std::async(std::launch::async, Compile, std::cref(*shader), std::cref(indices)));
    }
    std::vector<Diagnostic> problems;
    for (auto& compilation : running)
    {
        const std::vector<Diagnostic> found = compilation.get();
        problems.insert(problems.end(), found.begin(), found.end());
    }
    if (!problems.empty())
    {
        throw AssetError(std::move(problems));
    }
}

} // namespace limn
