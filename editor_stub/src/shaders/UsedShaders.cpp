#include "shaders/UsedShaders.h"

#include "shaders/ErrorShader.h"

#include <algorithm>
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

using ShaderProblems = std::map<std::shared_ptr<const Shader>, std::vector<Diagnostic>>;

/// What is wrong with those that do not compile.
ShaderProblems CompileAll(const ShaderPasses& passes)
{
    std::vector<std::future<std::vector<Diagnostic>>> running;
    for (const auto& [shader, indices] : passes)
    {
        running.push_back(
            std::async(std::launch::async, Compile, std::cref(*shader), std::cref(indices)));
    }
    ShaderProblems problems;
    auto compilation = running.begin();
    for (const auto& [shader, indices] : passes)
    {
        std::vector<Diagnostic> found = (compilation++)->get();
        if (!found.empty())
        {
            problems[shader] = std::move(found);
        }
    }
    return problems;
}

std::vector<Diagnostic> AllOf(const ShaderProblems& problems)
{
    std::vector<Diagnostic> all;
    for (const auto& [shader, found] : problems)
    {
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

ShaderPasses FeatureShaders(const SceneAsset& asset)
{
    ShaderPasses passes;
    ShaderFinder finder(passes);
    for (const auto& feature : asset.renderer.features)
    {
        if (feature->isActive())
        {
            feature->Describe(finder);
        }
    }
    return passes;
}

void ReplaceShaders(Scene& scene, const ShaderProblems& broken,
                    const std::shared_ptr<ShaderCompiler>& compiler)
{
    const std::shared_ptr<const Shader> magenta = MakeErrorShader(compiler);
    std::map<const Material*, std::shared_ptr<const Material>> replaced;
    for (const auto& object : scene.objects())
    {
        if (!object->renderer)
        {
            continue;
        }
        for (std::shared_ptr<const Material>& material : object->renderer->sharedMaterials)
        {
            if (broken.count(material->shader()) == 0)
            {
                continue;
            }
            std::shared_ptr<const Material>& replacement = replaced[material.get()];
            if (!replacement)
            {
                auto made = std::make_shared<Material>(magenta, material->name());
                made->SetRenderQueue(material->renderQueue());
                replacement = std::move(made);
            }
            material = replacement;
        }
    }
}

} // namespace

void CompileUsedShaders(const SceneAsset& asset)
{
    ShaderPasses passes = FeatureShaders(asset);
    AddObjectShaders(asset.scene, passes);
    const ShaderProblems problems = CompileAll(passes);
    if (!problems.empty())
    {
        throw AssetError(AllOf(problems));
    }
}

std::vector<Diagnostic> CompileOrReplaceShaders(SceneAsset& asset,
                                                const std::shared_ptr<ShaderCompiler>& compiler)
{
    const ShaderPasses ofFeatures = FeatureShaders(asset);
    ShaderPasses passes = ofFeatures;
    AddObjectShaders(asset.scene, passes);
    const ShaderProblems problems = CompileAll(passes);
    const bool hasFeature =
        std::any_of(problems.begin(), problems.end(),
                    [&](const auto& problem) { return ofFeatures.count(problem.first) > 0; });
    if (hasFeature)
    {
        throw AssetError(AllOf(problems));
    }
    if (!problems.empty())
    {
        ReplaceShaders(asset.scene, problems, compiler);
    }
    return AllOf(problems);
}

} // namespace limn
