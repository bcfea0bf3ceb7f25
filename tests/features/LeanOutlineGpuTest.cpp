#include "features/OutlineScene.h"
#include "vulkan/GpuTestDevice.h"

#include <algorithm>
#include <random>

using namespace limn;
using namespace limn::test;

namespace
{

/// The outline scene's picture, with and without what the frame compiler saves.
class LeanOutlineGpu : public GpuTest
{
protected:
    LeanOutlineGpu()
    {
        AddOutline(m_Renderer);
        m_Request.scene = &content.scene;
        m_Request.camera = &content.camera;
        m_Request.width = 97;
        m_Request.height = 61;
    }

    std::vector<std::byte> Picture(float width, const FrameCompilerOptions& options)
    {
        m_Request.volumeStack = &m_Volumes.With(true, {0.9f, 0.7f, 0.2f, 1.0f}, width);
        m_Request.compile = options;
        const RenderResult result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        isLimited = false;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                const auto* draw = std::get_if<DrawCommand>(&command);
                isLimited = isLimited || (draw && draw->scissor);
            }
        }
        return SharedDevice().ReadBack(*result.output.rt()).texels;
    }

    OutlineScene content;
    bool isLimited = false; ///< some pass of the last picture was drawn in a part of its target

private:
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    UniversalRenderer m_Renderer{Compiler()};
    BlendedOutline m_Volumes;
    RenderRequest m_Request;
};

int LargestDifference(const std::vector<std::byte>& a, const std::vector<std::byte>& b)
{
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        largest =
            std::max(largest, std::abs(std::to_integer<int>(a[i]) - std::to_integer<int>(b.at(i))));
    }
    return largest;
}

} // namespace

TEST_F(LeanOutlineGpu, DrawsTheSamePixelsInRegionsOnly)
{
    std::mt19937 random(20'261'122);
    std::uniform_real_distribution<float> place(-1.6f, 1.6f);
    std::uniform_real_distribution<float> size(0.02f, 0.7f);
    std::uniform_real_distribution<float> depth(-2.9f, 2.0f); // the nearest are at the camera
    int limited = 0;
    for (int i = 0; i < 60; ++i)
    {
        for (const char* name : {"Torus", "Cube"})
        {
            Transform& transform = content.scene.Find(name)->transform;
            transform.localPosition = {place(random), place(random), depth(random)};
            transform.localScale = glm::vec3(size(random));
            transform.localRotation = EulerToRotation({place(random) * 90, place(random) * 90, 0});
        }
        const float width = 1.0f + static_cast<float>(i % 10);
        const auto all = Picture(width, {.held = {}, .leavesOut = true, .limitsRegions = false});
        const auto inRegions =
            Picture(width, {.held = {}, .leavesOut = true, .limitsRegions = true});
        limited += isLimited ? 1 : 0;
        ASSERT_EQ(all, inRegions) << "picture " << i << ", width " << width;
    }
    EXPECT_GT(limited, 20);
    ExpectNoValidationMessages();
}

// Half-float rounding falls away where the camera's colour is drawn to the output directly.
TEST_F(LeanOutlineGpu, DrawsWithinOne255thWithoutTheCamerasColour)
{
    for (const char* name : {"Torus", "Cube"})
    {
        content.scene.Find(name)->renderer->renderingLayerMask = RenderingLayerMask::FromIndex(0);
    }
    const auto all = Picture(4.0f, {.held = {}, .leavesOut = false, .limitsRegions = false});
    const auto lean = Picture(4.0f, {});
    EXPECT_NE(all, std::vector<std::byte>(all.size(), all.front())) << "something is drawn";
    EXPECT_LE(LargestDifference(all, lean), 1);
    ExpectNoValidationMessages();
}
