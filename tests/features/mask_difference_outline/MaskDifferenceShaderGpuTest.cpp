#include "features/color_edges/PictureRun.h"

#include <array>
#include <cstring>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <random>

namespace limn::test
{
namespace
{

constexpr int k_TexturePass = 1;          // "Outline"
constexpr int k_FramebufferFetchPass = 2; // "Outline Framebuffer Fetch"

std::shared_ptr<const Texture> ToTexture(const char* name, const Field& field)
{
    std::vector<std::byte> texels(field.values.size() * sizeof(float));
    for (std::size_t i = 0; i < field.values.size(); ++i)
    {
        const auto value = static_cast<float>(field.values[i]);
        std::memcpy(texels.data() + i * sizeof(float), &value, sizeof(float));
    }
    return std::make_shared<const Texture2D>(
        name, field.width, field.height,
        field.channels == 4 ? GraphicsFormat::R32G32B32A32_SFloat : GraphicsFormat::R32_SFloat,
        std::move(texels));
}

/// What a depth of 0 near ... 1 far is called.
struct DepthConvention
{
    std::vector<std::string> keywords;
    double near;
    double far;
};
const DepthConvention k_Conventions[] = {
    {{}, 0.0, 1.0},
    {{"SYSTEM_DEPTH_RANGE_NEGATIVE"}, -1.0, 1.0},
    {{"USE_REVERSED_Z"}, 1.0, 0.0},
    {{"SYSTEM_DEPTH_RANGE_NEGATIVE", "USE_REVERSED_Z"}, 1.0, -1.0}};

/// The shader over inputs of every kind, without the feature that makes them.
class MaskDifferenceShaderGpu : public GpuTest,
                                public testing::WithParamInterface<std::pair<int, int>>
{
protected:
    MaskDifferenceShaderGpu() : m_Flat(m_Width, m_Height)
    {
        // Blocks, so that many neighbours are alike; eighths, so that means of different ones can
        // be one of them.
        std::uniform_int_distribution<int> eighth(0, 8);
        std::array<std::array<double, 4>, 64> blocks{};
        for (auto& block : blocks)
        {
            const bool isEmpty = eighth(m_Random) < 3;
            for (double& value : block)
            {
                value = isEmpty ? 0.0 : eighth(m_Random) / 8.0;
            }
        }
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (int y = 0; y < m_Height; ++y)
        {
            for (int x = 0; x < m_Width; ++x)
            {
                const auto& block = blocks[static_cast<std::size_t>((y / 3 * 7 + x / 3) % 64)];
                m_Mask.values.insert(m_Mask.values.end(), block.begin(), block.end());
                m_Depth.values.push_back(unit(m_Random));
                for (int channel = 0; channel < 4; ++channel)
                {
                    m_Picture.values.push_back(unit(m_Random));
                }
            }
        }
    }

    /// @param base  the picture without lines
    Field Reference(const Field& base, int width, double threshold) const
    {
        Field result = base;
        for (int y = 0; y < m_Height; ++y)
        {
            for (int x = 0; x < m_Width; ++x)
            {
                const auto line = Line(x, y, width);
                for (int channel = 0; channel < 3; ++channel)
                {
                    result.At(x, y, channel) += m_Depth.At(x, y) < threshold
                                                    ? line[static_cast<std::size_t>(channel)]
                                                    : 0.0;
                }
            }
        }
        return result;
    }

    std::array<double, 3> Line(int x, int y, int width) const
    {
        const auto mask = [&](int dx, int dy, int channel)
        {
            return m_Mask.At(std::clamp(x + dx, 0, m_Width - 1),
                             std::clamp(y + dy, 0, m_Height - 1), channel);
        };
        std::array<double, 3> color{};
        bool isEdge = false;
        for (int channel = 0; channel < 4; ++channel)
        {
            const std::array<double, 4> taps{mask(0, -width, channel), mask(0, width, channel),
                                             mask(-width, 0, channel), mask(width, 0, channel)};
            const double sum = taps[0] + taps[1] + taps[2] + taps[3];
            isEdge = isEdge || mask(0, 0, channel) != sum / 4.0;
            if (channel < 3)
            {
                color[static_cast<std::size_t>(channel)] = *std::ranges::max_element(taps);
            }
        }
        return isEdge ? color : std::array<double, 3>{};
    }

    void SetInputs(Material& material, const DepthConvention& convention, int width,
                   double threshold) const
    {
        for (const auto& other : {"SYSTEM_DEPTH_RANGE_NEGATIVE", "USE_REVERSED_Z"})
        {
            material.DisableKeyword(other);
        }
        for (const std::string& keyword : convention.keywords)
        {
            material.EnableKeyword(keyword);
        }
        Field depth = m_Depth;
        for (double& value : depth.values)
        {
            value = convention.near + (convention.far - convention.near) * value;
        }
        const glm::vec2 size(m_Width, m_Height);
        material.SetTexture(ShaderPropertyId("t_tex0"), ToTexture("mask", m_Mask));
        material.SetTexture(ShaderPropertyId("t_tex1"), ToTexture("picture", m_Picture));
        material.SetTexture(ShaderPropertyId("_CameraDepthTexture"), ToTexture("depth", depth));
        material.SetVector(ShaderPropertyId("u_rt_size"), {size, 1.0f / size});
        material.SetFloat(ShaderPropertyId("width"), static_cast<float>(width));
        material.SetFloat(ShaderPropertyId("outline_depth_threshold_clip_player"),
                          static_cast<float>(threshold));
    }

    /// Compares all depth conventions, widths and thresholds.
    /// @param base  of the pass: the camera's picture or t_tex1
    void ExpectReference(int passIndex, const Field* base)
    {
        const auto material = std::make_shared<Material>(
            FindShippedShader("Hidden/Limn/MaskDifferenceOutline", Compiler()));
        PictureRun run(m_Flat.scene, m_Flat.camera, m_Width, m_Height);
        auto& feature = run.Add(std::make_unique<FullScreenPassRendererFeature>());
        const Field background = run.ColorRows(nullptr);
        feature.fetchColorBuffer = false;
        feature.passMaterial = material;
        feature.passIndex = passIndex;
        for (const int width : {0, 1, 2, 5})
        {
            for (const double threshold : {0.0, 0.3, 0.9, 1.5})
            {
                const Field expected =
                    Reference(base != nullptr ? *base : background, width, threshold);
                std::optional<Field> first;
                for (const DepthConvention& convention : k_Conventions)
                {
                    SetInputs(*material, convention, width, threshold);
                    const Field picture = run.ColorRows(nullptr);
                    EXPECT_GE(ShareWithinTwo(picture, expected), 0.999)
                        << "width " << width << ", threshold " << threshold;
                    first = first ? first : picture;
                    EXPECT_EQ(CountDifferent(picture, *first), 0) << convention.far;
                }
            }
        }
    }

    const int m_Width = GetParam().first;
    const int m_Height = GetParam().second;
    FlatScene m_Flat;
    Field m_Mask{m_Width, m_Height, 4, {}};
    Field m_Depth{m_Width, m_Height, 1, {}};
    Field m_Picture{m_Width, m_Height, 4, {}};
    std::mt19937 m_Random{7};
};

TEST_P(MaskDifferenceShaderGpu, AddsWhatTheReferenceSaysInPlaceForEveryKindOfDepth)
{
    m_Flat.camera.backgroundColor = Color{0.3f, 0.5f, 0.7f, 0.25f};
    ExpectReference(k_FramebufferFetchPass, nullptr);
}

TEST_P(MaskDifferenceShaderGpu, AddsWhatTheReferenceSaysToATextureForEveryKindOfDepth)
{
    ExpectReference(k_TexturePass, &m_Picture);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MaskDifferenceShaderGpu,
                         testing::Values(std::pair(32, 24), std::pair(37, 23), std::pair(15, 41),
                                         std::pair(1, 1), std::pair(1, 19), std::pair(19, 1)),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

} // namespace
} // namespace limn::test
