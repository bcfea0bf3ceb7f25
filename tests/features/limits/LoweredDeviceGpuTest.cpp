#include "CachedCompiler.h"
#include "limits/Lowered.h"
#include "report/measure/StudyPicture.h"
#include "vulkan/GpuTestDevice.h"

#include <cstdio>
#include <limn/core/DrawError.h>
#include <limn/editor_stub/Overrides.h>

namespace limn::test
{

namespace
{

/// A scene of the samples, and the profile that makes it show an outline; "" = its own.
struct Sample
{
    const char* scene;
    const char* profile;
};

constexpr Sample k_SampleScenes[] = {{"furniture/furniture", "furniture/cannot_place"},
                                     {"translucent_solid/translucent_solid", ""},
                                     {"selection/selection", "selection/auto"},
                                     {"selection/selection", "selection/color_edges"},
                                     {"selection/selection", "selection/depth_normals"},
                                     {"selection/selection", "selection/inflated"},
                                     {"selection/selection", "selection/mask_difference"},
                                     {"selection/selection", "selection/rim"},
                                     {"selection/selection", "selection/screen_space"},
                                     {"selection/selection", "selection/selection"},
                                     {"selection/selection", "selection/strokes"},
                                     {"selection/selection", "selection/wide"}};

struct Lack
{
    const char* name;
    const char* lowered;
};

constexpr Lack k_Lacks[] = {
    {"what Vulkan promises of a stage and a set",
     "maxPerStageDescriptorSamplers=16,maxPerStageDescriptorUniformBuffers=12,"
     "maxPerStageDescriptorStorageBuffers=4,maxPerStageDescriptorSampledImages=16,"
     "maxPerStageDescriptorStorageImages=4,maxPerStageResources=128,maxDescriptorSetSamplers=96,"
     "maxDescriptorSetUniformBuffers=72,maxDescriptorSetStorageBuffers=24,"
     "maxDescriptorSetSampledImages=96,maxDescriptorSetStorageImages=24,maxBoundDescriptorSets=4,"
     "maxFragmentCombinedOutputResources=4,maxVertexInputAttributes=16,maxVertexInputBindings=16"},
    {"128 bytes of push constants", "maxPushConstantsSize=128"},
    {"no geometry programs", "geometryShader=0"},
    {"no fillModeNonSolid", "fillModeNonSolid=0"},
    {"no anisotropy", "samplerAnisotropy=0"},
    {"no wide lines", "wideLines=0"},
    {"no stores of vertex and fragment functions",
     "vertexPipelineStoresAndAtomics=0,fragmentStoresAndAtomics=0"},
    {"4 000 samplers", "maxSamplerAllocationCount=4000"},
    {"a device heap that is full", "fullHeap=1"},
    {"a portability subset as on macOS", "portability=2"},
    {"the barest portability subset", "portability=1"}};

AssetContext& Assets()
{
    static AssetContext s_Assets(CachedCompiler());
    return s_Assets;
}

std::string PathOf(const char* name, const char* ending)
{
    return SourcePath(std::string("samples/") + name + ending);
}

Image Draw(const Sample& sample, VulkanDevice& device)
{
    SceneAsset asset = LoadScene(PathOf(sample.scene, ".scene.yaml"), Assets());
    if (*sample.profile != '\0')
    {
        ReplaceProfile(asset, PathOf(sample.profile, ".profile.yaml"), Assets());
    }
    asset.width = 96;
    asset.height = 54;
    return study::StudyPicture(std::move(asset), Assets(), device).Output();
}

/// "drawn as before", or why not.
std::string Outcome(const Sample& sample, VulkanDevice& device, const Image& before)
{
    try
    {
        return Draw(sample, device).texels == before.texels ? "drawn as before" : "drawn otherwise";
    }
    catch (const DrawError& error)
    {
        return error.what();
    }
}

/// How many of the samples end how. Validation must be silent.
std::map<std::string, std::size_t> Outcomes(const Lack& lack, const std::vector<Image>& pictures)
{
    const Lowered lowered(lack.lowered);
    VulkanDeviceOptions options;
    options.device = SharedDevice().deviceName();
    options.validation = true;
    VulkanDevice device(options);
    std::map<std::string, std::size_t> outcomes;
    for (std::size_t i = 0; i < pictures.size(); ++i)
    {
        ++outcomes[Outcome(k_SampleScenes[i], device, pictures[i])];
    }
    EXPECT_EQ("", Text(device.validationMessages())) << lack.name;
    return outcomes;
}

class LoweredDevice : public GpuTest
{
};

} // namespace

// The lacks one at a time, with their table, take LIMN_LIMITS_TABLE=1 and half a minute; all at
// once here.
TEST_F(LoweredDevice, DrawsEveryOutlineAsBefore)
{
    const bool isTable = std::getenv("LIMN_LIMITS_TABLE") != nullptr;
    std::string all;
    for (const Lack& lack : k_Lacks)
    {
        all += (all.empty() ? "" : ",") + std::string(lack.lowered);
    }
    const std::vector<Lack> atOnce{{"all at once", all.c_str()}};
    std::vector<Image> pictures;
    for (const Sample& sample : k_SampleScenes)
    {
        pictures.push_back(Draw(sample, SharedDevice()));
    }
    for (const Lack& lack : isTable ? std::vector(std::begin(k_Lacks), std::end(k_Lacks)) : atOnce)
    {
        const auto outcomes = Outcomes(lack, pictures);
        EXPECT_EQ(
            (std::map<std::string, std::size_t>{{"drawn as before", std::size(k_SampleScenes)}}),
            outcomes)
            << lack.name;
        for (auto outcome = outcomes.begin(); isTable && outcome != outcomes.end(); ++outcome)
        {
            std::printf("%s | %s (%zu)\n", lack.name, outcome->first.c_str(), outcome->second);
        }
    }
}

} // namespace limn::test
