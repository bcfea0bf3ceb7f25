#pragma once

#include "SceneFolder.h"
#include "explain/pixel/PixelHistory.h"
#include "features/RecordingFeature.h"
#include "vulkan/GpuTestDevice.h"

#include <gmock/gmock.h>

namespace limn::test
{

using Floats = std::vector<float>;
using Names = std::vector<std::string>;
/// 10 pixels a metre, the middle of the picture is the origin; z = -4 ... 6 are depths 1 ... 0.
inline constexpr const char* k_Camera =
    "size: [20, 20]\n"
    "layers: {6: Selectable, 7: Hidden}\n"
    "renderingLayers: {8: Selected}\n"
    "camera: {orthographic: true, orthographicSize: 1, position: "
    "[0, 0, -5], nearClipPlane: 1, farClipPlane: 11,\n"
    "         backgroundColor: \"#000000\", cullingMask: [Default, "
    "Selectable]}\n";

inline const Floats k_Black{0, 0, 0, 1};
inline const Floats k_Red{1, 0, 0, 1};
inline const Floats k_Green{0, 1, 0, 1};

/// Places commands among the passes of the renderer, in one of this name.
inline std::unique_ptr<RecordingFeature> Commands(RenderPassEvent event, const char* passName,
                                                  std::function<void(CommandBuffer&)> record)
{
    return std::make_unique<RecordingFeature>(
        event,
        [=](CommandBuffer& cmd, RenderingData&)
        {
            const ProfilingScope scope(cmd, ProfilingSampler(passName));
            record(cmd);
        },
        passName);
}

class PixelHistoryGpu : public GpuTest
{
protected:
    /// A material of this name whose shader has these states and gives this colour.
    void Paint(const std::string& name, const std::string& state, const std::string& color,
               int queue = 2000, const std::string& before = "")
    {
        folder.Write(name + ".shader",
                     "Shader \"Test/" + name + "\" { SubShader { Pass { Name \"Paint\"\n" + state +
                         "\nHLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
                         "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
                         "Core.hlsl\"\n"
                         "float4 V(float4 p : POSITION) : SV_POSITION\n"
                         "{ return TransformObjectToHClip(p.xyz); }\n"
                         "float4 F(float4 p : SV_POSITION) : SV_Target { " +
                         before + " return float4(" + color + "); }\nENDHLSL\n} } }\n");
        m_Materials += (m_Materials.empty() ? "" : ", ") + name + ": {shader: " + name +
                       ".shader, renderQueue: " + std::to_string(queue) + "}";
    }

    /// An object of the size of a metre that faces the camera, or whatever `more` says.
    void Quad(const std::string& name, const std::string& material, const std::string& more = "")
    {
        m_Objects += "  - {name: " + name + ", mesh: quad, material: " + material +
                     (more.empty() ? "" : ", " + more) + "}\n";
    }

    SceneAsset Load(const std::string& camera = k_Camera)
    {
        return folder.Load(camera + "materials: {" + m_Materials + "}\nobjects:\n" + m_Objects);
    }

    PixelHistory Trace(SceneAsset asset, int x, int y)
    {
        return TracePixel(std::move(asset), folder.assets, SharedDevice(), x, y);
    }
    PixelHistory Trace(int x, int y) { return Trace(Load(), x, y); }

    /// What became of the object, which one draw is of.
    static PixelEvent EventOf(const PixelHistory& history, const std::string& object)
    {
        PixelEvent found;
        int count = 0;
        for (const PixelEvent& event : history.events)
        {
            if (event.objects == Names{object})
            {
                found = event;
                ++count;
            }
        }
        EXPECT_EQ(1, count) << object;
        return found;
    }

    static bool HasEvent(const PixelHistory& history, const std::string& pass, PixelFate fate)
    {
        return std::ranges::any_of(history.events, [&](const PixelEvent& event)
                                   { return event.pass == pass && event.fate == fate; });
    }

    /// Whether the pass draws into the camera's colour there, beside what targets it has of its
    /// own.
    static bool ChangesCamera(const PixelHistory& history, const std::string& pass)
    {
        return std::ranges::any_of(history.events,
                                   [&](const PixelEvent& event)
                                   {
                                       return event.pass == pass &&
                                              event.fate == PixelFate::Drawn &&
                                              event.colors.at(0).texture ==
                                                  "_CameraColorAttachmentA";
                                   });
    }

    SceneFolder folder;

private:
    std::string m_Materials;
    std::string m_Objects;
};

} // namespace limn::test
