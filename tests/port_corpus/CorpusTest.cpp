#include "Paths.h"
#include "PortedUnit.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <limn/core/Inspector.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/core/UniversalRenderer.h>
#include <limn/features/Features.h>
#include <limn/volume/VolumeManager.h>
#include <map>
#include <set>

namespace limn::test
{

namespace
{

/// The skeletons of all C# files of the folder.
struct Corpus
{
    FeatureRegistry features;
    VolumeComponentRegistry components;

    Corpus()
    {
        for (const auto& entry :
             std::filesystem::directory_iterator(SourcePath("tests/port_corpus")))
        {
            if (entry.path().extension() == ".cs")
            {
                const std::string name = entry.path().stem().string();
                RegisterPorted(name, features, components, name.c_str());
            }
        }
    }
};

/// The paths of settings that a feature describes.
class SettingNames : public Inspector
{
public:
    using Inspector::Field;
    void Field(const FieldInfo& field, FieldValue) override
    {
        names.push_back(m_Group + std::string(field.name));
    }
    void BeginGroup(std::string_view name) override { m_Group += std::string(name) + "."; }
    void EndGroup() override { m_Group.erase(m_Group.rfind('.', m_Group.size() - 2) + 1); }

    std::vector<std::string> names;

private:
    std::string m_Group;
};

/// Gives a feature a material and a shader wherever it has a setting for one.
class MaterialGiver : public Inspector
{
public:
    explicit MaterialGiver(std::shared_ptr<const Shader> shader)
        : m_Shader(std::move(shader)), m_Material(std::make_shared<Material>(m_Shader))
    {
    }
    using Inspector::Field;
    void Field(const FieldInfo&, FieldValue value) override
    {
        if (const auto* shader = std::get_if<std::shared_ptr<const Shader>*>(&value))
        {
            **shader = m_Shader;
        }
        else if (const auto* material = std::get_if<std::shared_ptr<const Material>*>(&value))
        {
            **material = m_Material;
        }
    }

private:
    std::shared_ptr<const Shader> m_Shader;
    std::shared_ptr<Material> m_Material;
};

std::vector<std::string> SettingsOf(const Corpus& corpus, std::string_view feature)
{
    SettingNames inspector;
    const auto one = corpus.features.Create(feature);
    if (one)
    {
        one->Describe(inspector);
    }
    return inspector.names;
}

/// Features that cannot be drawn here, with a part of the reason. Each would fail in Unity, too:
/// the test's one shader has one pass, and lines that limn could not write would set what is null
/// or empty.
const std::map<std::string_view, const char*> k_Problems{
    {"DualBlurFeature", "range_check"},
    {"HighlightFeature", "a 'Material' is used that is null"},
    {"MaskGlowFeature", "is both source and destination"},
    {"TiltShiftFeature", "has no pass 1"},
    {"TrailFeature", "History' is used that is null"},
    {"VeilFeature", "a 'Material' is used that is null"}};

} // namespace

TEST(PortCorpus, HoldsAFeatureOfEachFile)
{
    const Corpus corpus;
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SourcePath("tests/port_corpus")))
    {
        files += entry.path().extension() == ".cs" ? 1 : 0;
        const std::string name = entry.path().stem().string();
        EXPECT_TRUE(entry.path().extension() != ".cs" || corpus.features.Create(name)) << name;
    }
    EXPECT_EQ(files, corpus.features.names().size());
    EXPECT_GE(files, 20u);
}

TEST(PortCorpus, DrawsAFrameWithEachFeature)
{
    const Corpus corpus;
    const auto compiler = std::make_shared<ShaderCompiler>();
    MaterialGiver giver(Shader::FromText(R"(Shader "Corpus/Any"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            float4 Vertex(float4 position : POSITION) : SV_POSITION { return position; }
            float4 Fragment() : SV_Target { return 1; }
            ENDHLSL
        }
    }
})",
                                         "any.shader", compiler));
    for (const std::string_view name : corpus.features.names())
    {
        RecordingDevice device;
        UniversalRenderPipeline pipeline(device);
        UniversalRenderer renderer(compiler);
        VolumeManager volumes(corpus.components);
        const VolumeStack stack = volumes.CreateStack();
        Scene scene;
        Camera camera;
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = 8;
        request.height = 8;
        request.volumeStack = &stack;
        std::string problem;
        try
        {
            auto feature = corpus.features.Create(name);
            feature->Describe(giver);
            renderer.AddFeature(std::move(feature)).name = name;
            pipeline.RenderSingleCamera(renderer, request);
            pipeline.RenderSingleCamera(renderer, request);
        }
        catch (const std::exception& error)
        {
            problem = error.what();
        }
        const auto known = k_Problems.find(name);
        EXPECT_THAT(problem, known == k_Problems.end() ? testing::Matcher<std::string>("")
                                                       : testing::HasSubstr(known->second))
            << name;
    }
}

TEST(PortCorpus, DescribesSettingsInSettingsByUnitysPaths)
{
    const Corpus corpus;
    EXPECT_THAT(SettingsOf(corpus, "MaskGlowFeature"),
                testing::ElementsAre(
                    "settings.passTag", "settings.Event", "settings.filterSettings.RenderQueueType",
                    "settings.filterSettings.LayerMask", "settings.filterSettings.PassNames",
                    "settings.glowColor", "settings.overrideMaterial",
                    "settings.overrideMaterialPassIndex"));
    EXPECT_THAT(SettingsOf(corpus, "LayerTintFeature"),
                testing::ElementsAre("m_RenderingLayerMask", "m_Other", "m_Mask", "m_LayerMask",
                                     "m_Material"));
}

} // namespace limn::test
