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

TEST(PortCorpus, DrawsAFrameWithEachSkeleton)
{
    const Corpus corpus;
    const auto compiler = std::make_shared<ShaderCompiler>();
    for (const std::string_view name : corpus.features.names())
    {
        RecordingDevice device;
        UniversalRenderPipeline pipeline(device);
        UniversalRenderer renderer(compiler);
        ScriptableRendererFeature& feature = renderer.AddFeature(corpus.features.Create(name));
        feature.name = name;
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
        for (int frame = 0; frame < 2; ++frame)
        {
            EXPECT_NO_THROW(pipeline.RenderSingleCamera(renderer, request)) << name;
        }
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
