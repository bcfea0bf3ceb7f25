#pragma once

#include "frame/FrameBuilder.h"

#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderer.h>
#include <memory>
#include <string>
#include <vector>

#include "scene/TestScene.h"

namespace limn::test
{

using Log = std::vector<std::string>;

/// A pass that writes down which of its functions is called.
class LoggingPass : public ScriptableRenderPass
{
public:
    LoggingPass(std::string name, RenderPassEvent event, Log& log)
        : m_Name(std::move(name)), m_Log(log)
    {
        profilingSampler = ProfilingSampler(m_Name);
        renderPassEvent = event;
    }

    void OnCameraSetup(CommandBuffer&, RenderingData&) override { Write("OnCameraSetup"); }
    void Configure(CommandBuffer&, const RenderTextureDescriptor&) override { Write("Configure"); }
    void Execute(ScriptableRenderContext&, RenderingData&) override { Write("Execute"); }
    void OnCameraCleanup(CommandBuffer&) override { Write("OnCameraCleanup"); }

protected:
    void Write(const std::string& function) { m_Log.push_back(m_Name + "." + function); }

private:
    std::string m_Name;
    Log& m_Log;
};

/// A feature that writes down which of its functions is called, and enqueues these passes.
class LoggingFeature : public ScriptableRendererFeature
{
public:
    LoggingFeature(std::string featureName, Log& log,
                   std::vector<ScriptableRenderPass*> passes = {})
        : m_Log(log), m_Passes(std::move(passes))
    {
        name = std::move(featureName);
    }

    void Create() override { Write("Create"); }
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        Write("AddRenderPasses");
        for (ScriptableRenderPass* pass : m_Passes)
        {
            renderer.EnqueuePass(*pass);
        }
    }
    void SetupRenderPasses(ScriptableRenderer&, const RenderingData&) override
    {
        Write("SetupRenderPasses");
    }

private:
    void Write(const std::string& function) { m_Log.push_back(name + "." + function); }

    Log& m_Log;
    std::vector<ScriptableRenderPass*> m_Passes;
};

/// A renderer with given targets and built-in passes.
class TestRenderer final : public ScriptableRenderer
{
public:
    const RTHandle color{Target("CameraColor")};
    const RTHandle depth{DepthTarget("CameraDepth")};
    std::vector<ScriptableRenderPass*> builtIn;
    Log* log = nullptr; ///< where Setup is written down

protected:
    void Setup(ScriptableRenderContext&, RenderingData&) override
    {
        if (log != nullptr)
        {
            log->push_back("Setup");
        }
        ConfigureCameraTarget(color, depth);
        for (ScriptableRenderPass* pass : builtIn)
        {
            EnqueuePass(*pass);
        }
    }
};

/// Keeps what a feature is told of each camera.
class CamerasReader : public ScriptableRendererFeature
{
public:
    explicit CamerasReader(std::vector<CameraData>& seen) : m_Seen(seen) {}
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData& data) override
    {
        m_Seen.push_back(data.cameraData);
    }

private:
    std::vector<CameraData>& m_Seen;
};

/// Renders one camera of 8 x 4 pixels with a TestRenderer, as often as asked.
class RendererHarness
{
public:
    TestRenderer renderer;
    Camera camera;
    CullingResults cullResults; ///< what the passes may draw
    RenderReport report;        ///< of the last Render
    RenderTexturePool temporaryTextures;
    bool enableRenderCompatibilityMode = false;

    /// @param leavesOut  see FrameCompiler
    CompiledFrame Render(bool leavesOut = false)
    {
        report = {};
        ScriptableRenderContext context(report);
        RenderingData data;
        data.cameraData.camera = &camera;
        data.cameraData.cameraType = camera.cameraType;
        data.cameraData.cameraTargetDescriptor = {8, 4, GraphicsFormat::R8G8B8A8_UNorm, 32};
        data.cameraData.pixelWidth = 8;
        data.cameraData.pixelHeight = 4;
        data.cameraData.aspectRatio = 2.0f;
        data.cameraData.renderer = &renderer;
        data.cullResults = cullResults;
        data.report = &report;
        data.enableRenderCompatibilityMode = enableRenderCompatibilityMode;
        data.temporaryTextures = &temporaryTextures;
        renderer.RenderCamera(context, data);
        return (leavesOut ? m_LeanCompiler : m_Compiler).Compile(context.TakeCommands());
    }

    void AddFeature(const std::string& name, Log& log, std::vector<ScriptableRenderPass*> passes)
    {
        renderer.AddFeature(std::make_unique<LoggingFeature>(name, log, std::move(passes)));
    }

private:
    FrameCompiler m_Compiler;
    FrameCompiler m_LeanCompiler{true};
};

} // namespace limn::test
