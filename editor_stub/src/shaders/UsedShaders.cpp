#include "shaders/UsedShaders.h"

#include "console/Texts.h"
#include "plugins/LoadPlugin.h"

#include <algorithm>
#include <future>
#include <map>
#include <set>

namespace limn
{

namespace
{

constexpr const char* k_Text = R"(Shader "Hidden/Core/FallbackError"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Place
            #pragma fragment Paint
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

            float4 Place(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half4 Paint() : SV_Target
            {
                return half4(@COLOR@);
            }
            ENDHLSL
        }
    }
}
)";

using ShaderPasses = std::map<std::shared_ptr<const Shader>, std::set<int>>;

void AddAllPasses(const std::shared_ptr<const Shader>& shader, ShaderPasses& passes)
{
    for (int pass = 0; shader && pass < shader->passCount(); ++pass)
    {
        passes[shader].insert(pass);
    }
}

/// Finds the shaders among a feature's settings.
class ShaderFinder final : public Inspector
{
public:
    explicit ShaderFinder(ShaderPasses& passes) : m_Passes(passes) {}

    void Field(const FieldInfo&, FieldValue value) override
    {
        if (const auto* shader = std::get_if<std::shared_ptr<const Shader>*>(&value))
        {
            AddAllPasses(**shader, m_Passes);
        }
        if (const auto* material = std::get_if<std::shared_ptr<const Material>*>(&value))
        {
            AddAllPasses(**material ? (**material)->shader() : nullptr, m_Passes);
        }
    }

private:
    ShaderPasses& m_Passes;
};

/// Adds the shaders of the objects and of the sky.
void AddSceneShaders(const Scene& scene, ShaderPasses& passes)
{
    AddAllPasses(scene.skybox ? scene.skybox->shader() : nullptr, passes);
    for (const auto& object : scene.objects())
    {
        if (!object->activeSelf || !object->renderer)
        {
            continue;
        }
        for (const auto& material : object->renderer->sharedMaterials)
        {
            for (const ShaderTagId tag : ForwardShaderTags())
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

/// Adds the errors of a shader or a material whose pass does not compile.
template <typename Passes>
void AddErrorsOf(const Passes& compiled, int pass, std::vector<Diagnostic>& problems)
{
    try
    {
        compiled.Compile(pass);
    }
    catch (const AssetError& error)
    {
        problems.insert(problems.end(), error.diagnostics().begin(), error.diagnostics().end());
    }
}

std::vector<Diagnostic> Compile(const Shader& shader, const std::set<int>& passes)
{
    std::vector<Diagnostic> problems;
    for (const int pass : passes)
    {
        AddErrorsOf(shader, pass, problems);
    }
    return problems;
}

using ShaderProblems = std::map<std::shared_ptr<const Shader>, std::vector<Diagnostic>>;

/// Returns the errors of the shaders that do not compile.
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

/// Adds the passes of objects that take other primitives than the triangles of a mesh.
void AddUnfittingGeometry(const ShaderPasses& passes, ShaderProblems& problems)
{
    for (const auto& [shader, indices] : passes)
    {
        for (const int pass : problems.count(shader) == 0 ? indices : std::set<int>())
        {
            const GeometryInput taken = shader->Compile(pass)->layout.geometryInput;
            if (taken != GeometryInput::None && taken != GeometryInput::Triangle)
            {
                const ShaderLabDocument& document = shader->document();
                problems[shader].push_back(
                    {Severity::Error, document.file,
                     shader->subShader().passes[static_cast<std::size_t>(pass)].location,
                     "Pass: its geometry function takes no triangles, but meshes have nothing "
                     "else; write 'triangle' and an array of 3"});
            }
        }
    }
}

ShaderProblems FindProblems(const SceneAsset& asset, const ShaderPasses& ofFeatures)
{
    ShaderPasses passes = ofFeatures;
    AddSceneShaders(asset.scene, passes);
    ShaderProblems problems = CompileAll(passes);
    ShaderPasses ofObjects;
    AddSceneShaders(asset.scene, ofObjects);
    AddUnfittingGeometry(ofObjects, problems);
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

ShaderPasses ShadersOf(ScriptableRendererFeature& feature)
{
    ShaderPasses passes;
    ShaderFinder finder(passes);
    if (feature.isActive())
    {
        DescribeFeature(feature, finder);
    }
    return passes;
}

ShaderPasses FeatureShaders(const SceneAsset& asset)
{
    ShaderPasses passes;
    for (const auto& feature : asset.renderer.features)
    {
        passes.merge(ShadersOf(*feature));
    }
    return passes;
}

void ReplaceShaders(Scene& scene, const ShaderProblems& broken,
                    const std::shared_ptr<ShaderCompiler>& compiler)
{
    const std::shared_ptr<const Shader> magenta = MakeErrorShader(compiler);
    std::map<const Material*, std::shared_ptr<const Material>> replaced;
    const auto replace = [&](std::shared_ptr<const Material>& material)
    {
        if (!material || broken.count(material->shader()) == 0)
        {
            return;
        }
        std::shared_ptr<const Material>& replacement = replaced[material.get()];
        if (!replacement)
        {
            auto made = std::make_shared<Material>(magenta, material->name());
            made->SetRenderQueue(material->renderQueue());
            replacement = std::move(made);
        }
        material = replacement;
    };
    replace(scene.skybox);
    for (const auto& object : scene.objects())
    {
        if (object->renderer)
        {
            std::ranges::for_each(object->renderer->sharedMaterials, replace);
        }
    }
}

/// Makes objects magenta and features inactive whose shaders do not compile.
std::vector<Diagnostic> LeaveBrokenOut(SceneAsset& asset, const ShaderProblems& broken)
{
    std::vector<Diagnostic> notes;
    for (Diagnostic& problem : AllOf(broken)) // of several passes, which may have the same ones
    {
        problem.severity = Severity::Note;
        AddOnce(problem, notes);
    }
    for (const auto& [shader, problems] : broken)
    {
        notes.push_back({Severity::Note,
                         shader->document().file,
                         {},
                         "shader '" + shader->name() +
                             "' cannot be drawn, as the notes before explain, so the objects that "
                             "have it are magenta"});
    }
    for (const auto& feature : asset.renderer.features)
    {
        for (const auto& [shader, passes] : ShadersOf(*feature))
        {
            if (broken.count(shader) > 0)
            {
                feature->SetActive(false);
                notes.push_back({Severity::Note,
                                 shader->document().file,
                                 {},
                                 feature->name + ": it is left out; its shader '" + shader->name() +
                                     "' cannot be drawn"});
            }
        }
    }
    ReplaceShaders(asset.scene, broken, broken.begin()->first->compiler());
    return notes;
}

} // namespace

std::string BuiltInPassOf(const Shader& shader)
{
    std::string found;
    for (const ShaderLabPass& pass : shader.subShader().passes)
    {
        const std::string_view mode = pass.lightMode();
        if (std::ranges::count(ForwardShaderTags(), ShaderTagId(mode)) > 0)
        {
            return "";
        }
        if (found.empty() && IsIn(mode, {"Always", "ForwardBase", "PrepassBase", "Vertex",
                                         "VertexLMRGBM", "VertexLM"}))
        {
            found =
                (pass.isSurface ? "it has a surface shader"
                                : "it has a pass of the light mode '" + std::string(mode) + "'") +
                std::string(", which is of Unity's built-in pipeline and not drawn, and no "
                            "pass of the Universal Render Pipeline");
        }
    }
    return found;
}

std::shared_ptr<const Shader> MakeErrorShader(const std::shared_ptr<ShaderCompiler>& compiler)
{
    return MakePlainShader("1, 0, 1, 1", compiler);
}

std::shared_ptr<const Shader> MakePlainShader(const std::string& color,
                                              const std::shared_ptr<ShaderCompiler>& compiler)
{
    return Shader::FromText(Replaced(k_Text, "@COLOR@", color), "FallbackError.shader", compiler);
}

std::vector<Diagnostic> CompileUsedShaders(SceneAsset& asset)
{
    const ShaderProblems problems = FindProblems(asset, FeatureShaders(asset));
    if (problems.empty())
    {
        return {};
    }
    if (!asset.isUnityScene)
    {
        throw AssetError(AllOf(problems));
    }
    return LeaveBrokenOut(asset, problems);
}

std::vector<Diagnostic> ReplaceBrokenShaders(SceneAsset& asset)
{
    ShaderProblems problems;
    for (const auto& object : asset.scene.objects())
    {
        if (!object->activeSelf || !object->renderer)
        {
            continue;
        }
        for (const auto& material : object->renderer->sharedMaterials)
        {
            std::vector<Diagnostic> found;
            for (int pass = 0; pass < material->shader()->passCount(); ++pass)
            {
                AddErrorsOf(*material, pass, found);
            }
            if (!found.empty())
            {
                problems[material->shader()] = std::move(found);
            }
        }
    }
    return problems.empty() ? std::vector<Diagnostic>() : LeaveBrokenOut(asset, problems);
}

std::vector<Diagnostic> CompileOrReplaceShaders(SceneAsset& asset,
                                                const std::shared_ptr<ShaderCompiler>& compiler)
{
    const ShaderPasses ofFeatures = FeatureShaders(asset);
    const ShaderProblems problems = FindProblems(asset, ofFeatures);
    const bool hasFeature = std::ranges::any_of(problems, [&](const auto& problem)
                                                { return ofFeatures.count(problem.first) > 0; });
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
