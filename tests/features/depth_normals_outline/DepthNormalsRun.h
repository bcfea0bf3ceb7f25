#pragma once

#include "features/color_edges/PictureRun.h"

#include <bit>
#include <limn/features/DepthNormalsOutlineRendererFeature.h>
#include <limn/features/FullScreenPassRendererFeature.h>

namespace limn::test
{

/// A material that draws what these statements return over the whole picture. They may read
/// _CameraDepthTexture and what limn/outline/OutlineObject.hlsl declares, at input.texcoord.
inline std::shared_ptr<Material> Probe(const std::string& body)
{
    return std::make_shared<Material>(ShaderOf(
        "Shader \"Test/Probe\" { SubShader { Pass { ZTest Always ZWrite Off Cull Off\n"
        "HLSLPROGRAM\n#pragma vertex Vert\n#pragma fragment Frag\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"\n"
        "#include \"Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl\"\n"
        "#include \"limn/outline/OutlineObject.hlsl\"\n"
        "float4 Frag(Varyings input) : SV_Target { float2 uv = input.texcoord;\n" +
        body + "}\nENDHLSL\n} } }"));
}

/// What the probe says of a scene, as half floats.
inline Field Probed(const Scene& scene, const Camera& camera, int width, int height,
                    const std::string& body)
{
    PictureRun run(scene, camera, width, height);
    auto feature = std::make_unique<FullScreenPassRendererFeature>();
    feature->passMaterial = Probe(body);
    feature->requirements = ScriptableRenderPassInput::Depth | ScriptableRenderPassInput::Normal;
    feature->fetchColorBuffer = false;
    run.Add(std::move(feature));
    return run.Color(nullptr);
}

/// _CameraDepthTexture to the bit, of which half floats hold 11 at a time.
inline Field ProbedDepth(const Scene& scene, const Camera& camera, int width, int height)
{
    const Field parts = Probed(scene, camera, width, height,
                               "uint bits = asuint(limn_Depth(uv));"
                               "return float4(bits >> 22, bits >> 11 & 2047, bits & 2047, 1);");
    Field depth{width, height, 1, {}};
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            const auto part = [&](int channel)
            {
                return static_cast<std::uint32_t>(std::lround(parts.At(x, y, channel)));
            };
            const std::uint32_t bits = part(0) << 22 | part(1) << 11 | part(2);
            depth.values.push_back(static_cast<double>(std::bit_cast<float>(bits)));
        }
    }
    return depth;
}

inline Field FirstChannel(const Field& picture)
{
    Field first{picture.width, picture.height, 1, {}};
    for (std::size_t i = 0; i < picture.values.size(); i += 4)
    {
        first.values.push_back(picture.values[i]);
    }
    return first;
}

/// How much of each pixel is an object that `isFiltered`, seen by the camera.
inline Field Coverage(const Scene& scene, const Camera& camera, int width, int height, int samples,
                      const std::function<bool(const GameObject&)>& isFiltered)
{
    std::vector<MeshRenderer> before;
    for (const auto& object : scene.objects())
    {
        before.push_back(*object->renderer);
        object->renderer->sharedMaterials = {Plain(glm::vec3(isFiltered(*object) ? 1.0f : 0.0f))};
    }
    Camera dark = camera;
    dark.backgroundColor = Color::black;
    PictureRun run(scene, dark, width, height);
    run.SetSamples(samples);
    const Field picture = run.Color(nullptr);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
        scene.objects()[i]->renderer = before[i];
    }
    return FirstChannel(picture);
}

/// Draws a scene with lines on all its objects, white on whatever they are.
class LinedRun : public PictureRun
{
public:
    LinedRun(const Scene& scene, const Camera& camera, int width, int height,
             const DepthNormalsOutlineSettings& settings = {})
        : PictureRun(scene, camera, width, height)
    {
        Add(std::make_unique<DepthNormalsOutlineRendererFeature>(settings));
    }

    /// How strong the lines are in each pixel, if the objects are black.
    Field Lines(const std::function<void(DepthNormalsOutline&)>& set)
    {
        return FirstChannel(Color(&m_Volumes.With(
            [&](DepthNormalsOutline& outline)
            {
                outline.m_OutlineColor.Override(::limn::Color::white);
                set(outline);
            })));
    }

private:
    BlendedComponent<DepthNormalsOutline> m_Volumes;
};

} // namespace limn::test
