#include "features/color_edges/PictureRun.h"
#include "vulkan/GpuTestFrame.h"

#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

constexpr int k_ScaledSide = 16;
constexpr glm::dvec3 k_Inside{0.75, 0.0, 0.25};
constexpr glm::dvec3 k_Outside{0.0, 0.0, 1.0};

/// A rectangle from 4 to 12 of 16 pixels, which is on whole texels at half and at twice the size.
class RenderScaleGpu : public GpuTest
{
protected:
    RenderScaleGpu() : m_Flat(k_ScaledSide, k_ScaledSide)
    {
        m_Flat.Add({4, 4}, {12, 12}, 5.0f, Plain(glm::vec3(k_Inside)));
        m_Flat.camera.backgroundColor = Color(0.0f, 0.0f, 1.0f, 1.0f);
    }

    Image Draw(float scale, bool leavesOut)
    {
        RenderRequest request;
        request.scene = &m_Flat.scene;
        request.camera = &m_Flat.camera;
        request.width = k_ScaledSide;
        request.height = k_ScaledSide;
        request.compile.leavesOut = leavesOut;
        m_Pipeline.renderScale = scale;
        m_Pipeline.RenderSingleCamera(m_Renderer, request);
        const RenderResult result = m_Pipeline.RenderSingleCamera(m_Renderer, request);
        return SharedDevice().ReadBack(*result.output.rt());
    }

    /// A texel of the target of this side, linear.
    static glm::dvec3 Texel(int x, int y, int side)
    {
        const auto isIn = [side](int i)
        {
            const int texel = std::clamp(i, 0, side - 1);
            return texel * k_ScaledSide >= 4 * side && texel * k_ScaledSide < 12 * side;
        };
        return isIn(x) && isIn(y) ? k_Inside : k_Outside;
    }

    /// Bilinear filtering by its definition.
    static glm::dvec3 Sample(int x, int y, int side)
    {
        const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) * (1.0 * side / k_ScaledSide) - 0.5;
        const glm::ivec2 low(glm::floor(place));
        const glm::dvec2 part = place - glm::dvec2(low);
        return glm::mix(
            glm::mix(Texel(low.x, low.y, side), Texel(low.x + 1, low.y, side), part.x),
            glm::mix(Texel(low.x, low.y + 1, side), Texel(low.x + 1, low.y + 1, side), part.x),
            part.y);
    }

    static double Encoded(double x)
    {
        return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
    }

    void ExpectSampled(float scale, int side)
    {
        for (const bool leavesOut : {false, true})
        {
            const Image picture = Draw(scale, leavesOut);
            double worst = 0.0;
            for (int y = 0; y < k_ScaledSide; ++y)
            {
                for (int x = 0; x < k_ScaledSide; ++x)
                {
                    const glm::dvec3 wanted = Sample(x, y, side);
                    const Rgba8 texel = Texel8(picture, x, y);
                    for (int channel = 0; channel < 3; ++channel)
                    {
                        const double found = texel[static_cast<std::size_t>(channel)];
                        worst = std::max(worst, std::abs(found - Encoded(wanted[channel])));
                    }
                }
            }
            EXPECT_LE(worst, 1.5) << "steps of 255, leavesOut " << leavesOut;
        }
    }

    FlatScene m_Flat;
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
    UniversalRenderer m_Renderer{Compiler()};
};

TEST_F(RenderScaleGpu, ASmallerTargetIsSampledBilinearly)
{
    ExpectSampled(0.5f, 8);
}

TEST_F(RenderScaleGpu, ALargerTargetIsSampledBilinearly)
{
    ExpectSampled(2.0f, 32);
}

TEST_F(RenderScaleGpu, TheSameSizeIsNotSampledAtAll)
{
    ExpectSampled(1.0f, 16);
}

TEST_F(RenderScaleGpu, SeveralSamplesATexelAreResolvedBefore)
{
    m_Pipeline.msaaSampleCount = 4;
    ExpectSampled(0.5f, 8);
}

} // namespace
} // namespace limn::test
