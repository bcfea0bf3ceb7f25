// A frame asks for no memory once it is warm, whatever feature is in it, with a camera that stands
// and with one that moves.

#include "ShippedTechniques.h"
#include "editor_stub/SceneFolder.h"
#include "scene/SceneView.h"

#include <atomic>
#include <cstdlib>
#include <gmock/gmock.h>
#include <limn/core/RecordingDevice.h>
#include <limn/editor_stub/Overrides.h>
#include <new>

namespace
{

std::atomic<int> s_Allocations{0};

void* Allocate(std::size_t size)
{
    ++s_Allocations;
    return std::malloc(size == 0 ? 1 : size);
}

} // namespace

// Not inlined: GCC takes the halves of an inlined pair for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    if (void* memory = Allocate(size))
    {
        return memory;
    }
    throw std::bad_alloc();
}

// Replaced as well, or a sanitizer's own version would meet the operator delete below.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return Allocate(size);
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace limn::test
{

namespace
{

/// A device that draws nothing and keeps nothing.
class NoDevice final : public GraphicsDevice
{
public:
    void Execute(const CompiledFrame& frame) override { m_States = frame.states; }
    const TextureStates& textureStates() const override { return m_States; }
    TextureFootprint Footprint(const RenderTexture& texture) override
    {
        return m_Sizes.Footprint(texture);
    }
    bool drawsPictures() const override { return false; }
    Image ReadBack(const RenderTexture&) override { return {}; }
    int GetRenderTextureSupportedMSAASampleCount(
        const RenderTextureDescriptor& descriptor) const override
    {
        return descriptor.msaaSamples;
    }
    bool IsFormatSupported(GraphicsFormat, FormatUsage) const override { return true; }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }

private:
    TextureStates m_States;
    RecordingDevice m_Sizes;
};

struct FrameCase
{
    friend void PrintTo(const FrameCase& frame, std::ostream* out) { *out << frame.name; }

    std::string name;
    std::string feature; ///< one of a scene's features, in YAML
    std::string component;
    std::vector<std::string> settings;
};

std::vector<FrameCase> FrameCases()
{
    std::vector<FrameCase> cases{
        {"No feature", "", "", {}},
        {"SSAO from normals", "{type: ScreenSpaceAmbientOcclusion, name: AO}", "", {}},
        {"SSAO from depth",
         "{type: ScreenSpaceAmbientOcclusion, name: AO, Source: Depth, BlurQuality: Medium}",
         "",
         {}},
        {"SSAO after opaque objects",
         "{type: ScreenSpaceAmbientOcclusion, name: AO, AfterOpaque: true, BlurQuality: Low}",
         "",
         {}}};
    for (const Technique& technique : ShippedTechniques())
    {
        cases.push_back({technique.name, "{type: " + technique.feature + ", name: Outline}",
                         technique.component, technique.settings});
    }
    return cases;
}

/// A small scene with the feature, drawn again and again.
class WarmFrame
{
public:
    explicit WarmFrame(const FrameCase& frame) : m_View(Load(frame), m_Folder.assets)
    {
        m_Request.width = 64;
        m_Request.height = 48;
    }

    /// Returns how often the last of some frames asks for memory.
    int AllocationsAfter(int frames, float step)
    {
        int count = 0;
        for (int i = 0; i < frames; ++i)
        {
            m_View.asset().camera.transform.localPosition.x += step;
            const int before = s_Allocations;
            m_View.Render(m_Pipeline, m_Request, m_Result);
            count = s_Allocations - before;
        }
        return count;
    }

    const std::vector<std::string>& notes() const { return m_Result.report.notes; }

private:
    SceneAsset Load(const FrameCase& frame)
    {
        std::string text =
            "size: [64, 48]\ncamera: {position: [0, 1, -4]}\nlight: {rotation: [50, -30, 0]}\n"
            "materials:\n  gray: {_BaseColor: \"#808080\"}\nobjects:\n"
            "  - {name: Ball, mesh: sphere, material: gray, renderingLayerMask: Everything}\n"
            "  - {name: Box, mesh: cube, material: gray, position: [1, 0, 2]}\n";
        text +=
            frame.feature.empty() ? "" : "renderer:\n  features:\n    - " + frame.feature + "\n";
        SceneAsset asset = m_Folder.Load(text);
        std::vector<std::string> settings = frame.settings;
        if (!frame.component.empty())
        {
            settings.push_back(frame.component + ".m_Enable=true");
        }
        ApplyOverrides(asset, settings, m_Folder.assets);
        return asset;
    }

    SceneFolder m_Folder;
    SceneView m_View;
    NoDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    RenderRequest m_Request;
    RenderResult m_Result;
};

class WarmFrames : public testing::TestWithParam<FrameCase>
{
};

TEST_P(WarmFrames, AskForNoMemoryWhileTheCameraStands)
{
    WarmFrame frame(GetParam());
    EXPECT_GT(frame.AllocationsAfter(1, 0.0f), 0) << "the first frame does, or nothing is counted";
    EXPECT_EQ(frame.AllocationsAfter(8, 0.0f), 0);
    EXPECT_THAT(frame.notes(), testing::IsEmpty()) << "such as that nothing is drawn";
}

TEST_P(WarmFrames, AskForNoMemoryWhileTheCameraMoves)
{
    WarmFrame frame(GetParam());
    EXPECT_EQ(frame.AllocationsAfter(40, 0.001f), 0);
}

INSTANTIATE_TEST_SUITE_P(Features, WarmFrames, testing::ValuesIn(FrameCases()),
                         [](const auto& frame)
                         {
                             std::string name;
                             for (const char c : frame.param.name)
                             {
                                 name += std::isalnum(static_cast<unsigned char>(c)) != 0
                                             ? std::string(1, c)
                                             : "";
                             }
                             return name;
                         });

} // namespace

} // namespace limn::test
