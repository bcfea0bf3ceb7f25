#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/BuiltinShaders.h>
#include <set>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "frame/FrameBuilder.h"
#include "pipeline/PipelineTest.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

using test::Mentions;

using testing::ElementsAre;
using testing::UnorderedElementsAre;
using enum TextureUsage;

/// Two cubes before a camera, rendered at 64 x 32 pixels on a device that draws nothing.
class Pipeline : public test::PipelineTest<>
{
protected:
    Pipeline() : PipelineTest(64, 32)
    {
        test::AddCube(m_Scene, "left", {-1, 0, 10}, {m_Opaque});
        test::AddCube(m_Scene, "right", {1, 0, 10}, {m_Opaque});
        m_Request.compile.leavesOut = false; // what leaving out makes of it: LeanPipelineTest.cpp
    }

    const std::shared_ptr<Material> m_Opaque =
        std::make_shared<Material>(test::ShaderWithProgram("", "float4 _Value;", "_Value"));
};

std::vector<test::SeenDraw> DrawsOf(const CompiledFrame& frame, std::size_t pass)
{
    std::vector<test::SeenDraw> draws;
    for (const PassCommand& command : frame.passes.at(pass).commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            draws.emplace_back(*draw, frame);
        }
    }
    return draws;
}

//   Draw Opaque Objects ─▶ _CameraColorAttachmentA ─▶ Final Blit ─▶ limn_Output ─▶ read back
//                       └▶ _CameraDepthAttachment (not stored)
TEST_F(Pipeline, DrawsASceneInOnePassAndCopiesItToTheOutput)
{
    const RenderResult result = Render();
    ASSERT_EQ(result.frame->passes.size(), 2u);
    const CompiledRenderPass& scene = result.frame->passes[0];
    EXPECT_EQ(scene.name, "Draw Opaque Objects");
    EXPECT_EQ(scene.width, 64);
    EXPECT_EQ(scene.height, 32);
    ASSERT_EQ(scene.colors.size(), 1u);
    EXPECT_EQ(scene.colors[0].texture->graphicsFormat(), GraphicsFormat::R16G16B16A16_SFloat);
    EXPECT_EQ(scene.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(scene.colors[0].store, StoreOp::Store);
    ASSERT_TRUE(scene.depth);
    EXPECT_EQ(scene.depth->texture->graphicsFormat(), GraphicsFormat::D32_SFloat);
    EXPECT_EQ(scene.depth->load, LoadOp::Clear);
    EXPECT_EQ(scene.depth->clearDepth, 1.0f);

    const CompiledRenderPass& blit = result.frame->passes[1];
    EXPECT_EQ(blit.name, "Final Blit");
    ASSERT_EQ(blit.colors.size(), 1u);
    EXPECT_EQ(blit.colors[0].texture, result.output.rt());
    EXPECT_EQ(blit.colors[0].store, StoreOp::Store);
    EXPECT_FALSE(blit.depth);
}

TEST_F(Pipeline, DoesNotStoreTheDepthThatNobodyReads)
{
    const CompiledRenderPass pass = Render().frame->passes.at(0);
    EXPECT_EQ(pass.depth->store, StoreOp::DontCare);
    EXPECT_EQ(pass.depth->stencilStore, StoreOp::DontCare);
}

TEST_F(Pipeline, DrawsEqualCubesAsInstances)
{
    const RenderResult result = Render();
    const auto draws = DrawsOf(*result.frame, 0);
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].mesh, test::Cube());
    EXPECT_EQ(draws[0].instanceCount, 2u);
    EXPECT_EQ(result.frame->PerDraw(draws[0]).objectToWorld[12], -1.0f);
}

TEST_F(Pipeline, AddsNoPassForASceneWithoutTransparentObjects)
{
    const RenderResult opaque = Render();
    const auto transparent = std::make_shared<Material>(m_Opaque->shader());
    transparent->SetRenderQueue(3000);
    test::AddCube(m_Scene, "glass", {0, 0, 5}, {transparent});
    const RenderResult mixed = Render();
    EXPECT_EQ(opaque.frame->passes.size(), 2u);
    EXPECT_EQ(mixed.frame->passes.size(), 2u);
    EXPECT_THAT(DrawsOf(*opaque.frame, 0).size(), 1u);
    EXPECT_THAT(DrawsOf(*mixed.frame, 0).size(), 2u);
}

TEST_F(Pipeline, RunsTheBuiltInPassesAtTheirEvents)
{
    std::vector<std::pair<std::string, int>> passes;
    for (const ExecutedPassReport& pass : Render().report.passes)
    {
        passes.emplace_back(pass.name.name(), static_cast<int>(pass.renderPassEvent));
    }
    EXPECT_THAT(passes, ElementsAre(std::pair{"Draw Opaque Objects", 250},
                                    std::pair{"Draw Transparent Objects", 450},
                                    std::pair{"Final Blit", 1001}));
}

TEST_F(Pipeline, MakesTheOutputReadableBehindTheFrame)
{
    const RenderResult result = Render();
    EXPECT_EQ(result.output.rt()->graphicsFormat(), GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_EQ(result.output.rt()->width(), 64);
    EXPECT_THAT(result.frame->finalBarriers,
                ElementsAre(TextureBarrier{result.output.rt(), ColorAttachment, CopySource}));
}

TEST_F(Pipeline, WaitsForTheSceneBeforeTheCopy)
{
    const RenderResult result = Render();
    const auto& color = result.frame->passes.at(0).colors.at(0).texture;
    EXPECT_THAT(result.frame->passes.at(1).barriers,
                UnorderedElementsAre(
                    TextureBarrier{color, ColorAttachment, ShaderRead, ShaderStage::Fragment},
                    TextureBarrier{result.output.rt(), Undefined, ColorAttachment}));
}

TEST_F(Pipeline, GivesTheDeviceTheFrameThatItReturns)
{
    const RenderResult result = Render();
    ASSERT_EQ(m_Device.frames().size(), 1u);
    EXPECT_EQ(m_Device.frames()[0].passes.size(), result.frame->passes.size());
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { m_Device.ReadBack(*result.output.rt()); }),
                Mentions("RecordingDevice", "draws nothing", "'limn_Output'"));
}

TEST_F(Pipeline, KeepsItsTexturesBetweenFrames)
{
    const RenderResult first = Render();
    const RenderResult second = Render();
    EXPECT_EQ(first.output, second.output);
    EXPECT_EQ(first.frame->passes[0].colors[0].texture, second.frame->passes[0].colors[0].texture);
    EXPECT_EQ(second.frame->passes[0].colors[0].load, LoadOp::Clear);
}

TEST_F(Pipeline, MakesNewTexturesForAnotherSize)
{
    const RenderResult first = Render();
    m_Request.width = 1;
    m_Request.height = 1;
    const RenderResult second = Render();
    EXPECT_NE(first.output, second.output);
    EXPECT_EQ(second.output.rt()->width(), 1);
    EXPECT_EQ(second.frame->passes[0].colors[0].texture->height(), 1);
}

TEST_F(Pipeline, UsesALowRangeTargetForACameraWithoutHdr)
{
    m_Camera.allowHDR = false;
    EXPECT_EQ(Render().frame->passes.at(0).colors[0].texture->graphicsFormat(),
              GraphicsFormat::R8G8B8A8_SRGB);
}

TEST_F(Pipeline, ClearsToTheBackgroundOfAnEmptyScene)
{
    m_Scene = Scene();
    m_Camera.backgroundColor = {1, 0, 0, 0.5f};
    const CompiledRenderPass pass = Render().frame->passes.at(0);
    EXPECT_EQ(pass.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(pass.colors[0].clearColor, (Color{1, 0, 0, 0.5f}));
}

TEST_F(Pipeline, LeavesOutWhatTheRenderersLayerMasksLeaveOut)
{
    m_Renderer.opaqueLayerMask = LayerMask::FromIndex(3);
    EXPECT_TRUE(DrawsOf(*Render().frame, 0).empty());
    m_Renderer.opaqueLayerMask = LayerMask::FromIndex(0);
    EXPECT_EQ(DrawsOf(*Render().frame, 0).size(), 1u);
}

TEST_F(Pipeline, TellsShadersTheRenderingLayersOfTheMainLight)
{
    const auto masked = std::make_shared<Material>(test::ShaderWithProgram(
        "", "uint _MainLightLayerMask;", "float4(_MainLightLayerMask, 0, 0, 1)"));
    m_Scene = Scene();
    test::AddCube(m_Scene, "cube", {0, 0, 10}, {masked});
    const auto mask = [&]
    {
        const CompiledFrame frame = *Render().frame;
        FrameCommands values;
        values.uniformData = frame.uniformData;
        return test::ReadUniform<std::uint32_t>(values, DrawsOf(frame, 0).at(0),
                                                "_MainLightLayerMask", 1);
    };
    EXPECT_THAT(mask(), ElementsAre(1u));
    m_Scene.mainLight.renderingLayerMask = RenderingLayerMask{0x80000004u};
    EXPECT_THAT(mask(), ElementsAre(0x80000004u));
}

TEST_F(Pipeline, NotesOnceWhatShadersUseThatLimnDoesNotHave)
{
    const auto add = [&](const std::string& name)
    {
        const auto shader = test::ShaderOf(
            "Shader \"" + name + "\" { SubShader { Pass {\n" +
            test::Program("#include \"Packages/com.unity.render-pipelines.universal/"
                          "ShaderLibrary/Lighting.hlsl\"\n",
                          "float4(SampleLightmap(float2(0, 0), float3(0, 1, 0)), 1)") +
            "} } }");
        test::AddCube(m_Scene, name, {0, 0, 10}, {std::make_shared<Material>(shader)});
        test::AddCube(m_Scene, name, {0, 1, 10}, {std::make_shared<Material>(shader)});
    };
    add("Test/Baked");
    EXPECT_THAT(Render().report.notes,
                ElementsAre(Mentions("'Test/Baked':", "light maps", "white")));
    for (const char* name : {"B", "C", "D"})
    {
        add(name);
    }
    EXPECT_THAT(Render().report.notes,
                ElementsAre(Mentions("'Test/Baked'", "'B', 'C', 'D')", "light maps")));
    add("E");
    EXPECT_THAT(Render().report.notes,
                ElementsAre(Mentions("'Test/Baked'", "'B', 'C', 'D', …)", "light maps")));
}

TEST_F(Pipeline, RendersAnOrthographicCameraWithAPlaneAtZero)
{
    m_Camera.orthographic = true;
    m_Camera.nearClipPlane = 0.0f;
    EXPECT_EQ(DrawsOf(*Render().frame, 0).size(), 1u);
    m_Camera.nearClipPlane = -20.0f;
    m_Camera.farClipPlane = 0.0f;
    EXPECT_NO_THROW(Render());
}

TEST_F(Pipeline, RefusesACameraThatIsNowhere)
{
    m_Camera.transform.localPosition.x = std::nanf("");
    EXPECT_THROW(Render(), ContractError);
}

TEST_F(Pipeline, RefusesARequestThatCannotBeRendered)
{
    m_Request.width = 0;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                Mentions("RenderSingleCamera", "0x32", "greater than 0"));
    m_Request.width = 64;
    m_Request.alsoReadBack = {RTHandle()};
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                Mentions("RenderSingleCamera", "alsoReadBack[0]", "empty"));
    m_Request.alsoReadBack.clear();
    m_Request.scene = nullptr;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                Mentions("RenderSingleCamera", "scene and camera"));
    EXPECT_TRUE(m_Device.frames().empty());
}

/// The floats of a global that the scene's shader reads as `_Value`'s neighbour.
std::vector<float> GlobalOf(UniversalRenderPipeline& pipeline, UniversalRenderer& renderer,
                            const Camera& camera, const std::string& name, double time = 0.0)
{
    Scene scene;
    const auto material =
        std::make_shared<Material>(test::ShaderWithProgram("", "float4 " + name + ";", name));
    const glm::vec3 ahead = camera.transform.position() + camera.transform.forward() * 5.0f;
    test::AddCube(scene, "probe", ahead, {material});
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = 64;
    request.height = 32;
    request.time = time;
    const CompiledFrame frame = *pipeline.RenderSingleCamera(renderer, request).frame;
    FrameCommands data;
    data.uniformData = frame.uniformData;
    return test::ReadUniform<float>(data, DrawsOf(frame, 0).at(0), name, 4);
}

TEST_F(Pipeline, TellsShadersHowToReadDepth)
{
    m_Camera.nearClipPlane = 0.3f;
    m_Camera.farClipPlane = 1000.0f;
    const auto params = GlobalOf(m_Pipeline, m_Renderer, m_Camera, "_ZBufferParams");
    EXPECT_NEAR(params[0], 3332.333, 0.001);
    EXPECT_EQ(params[1], 1.0f);
    EXPECT_NEAR(params[2], 3.332333, 1e-6);
    EXPECT_NEAR(params[3], 0.001, 1e-9);
    EXPECT_NEAR(1.0 / (params[2] * 1.0 + params[3]), 0.3, 1e-6) << "LinearEyeDepth at near";
    EXPECT_NEAR(1.0 / (params[2] * 0.0 + params[3]), 1000.0, 1e-3) << "LinearEyeDepth at far";
}

TEST_F(Pipeline, TellsShadersHowLongTheLastFrameTook)
{
    const auto at = [&](double time)
    {
        return GlobalOf(m_Pipeline, m_Renderer, m_Camera, "unity_DeltaTime", time);
    };
    const std::vector<float> none = {0, 0, 0, 0};
    EXPECT_EQ(at(2.0), none) << "the first frame has none before it";
    EXPECT_EQ(at(2.25), std::vector<float>({0.25f, 4.0f, 0.25f, 4.0f}));
    EXPECT_EQ(at(2.25), none) << "time stands still";
    EXPECT_EQ(at(1.0), none) << "time goes back";
    EXPECT_EQ(at(1.125), std::vector<float>({0.125f, 8.0f, 0.125f, 8.0f}));
    EXPECT_FLOAT_EQ(at(1e38)[0], 1.0f / 3.0f) << "no frame counts for longer";
}

TEST_F(Pipeline, TellsShadersAboutCameraScreenAndTime)
{
    m_Camera.transform.localPosition = {1, 2, 3};
    const auto global = [&](const char* name)
    {
        return GlobalOf(m_Pipeline, m_Renderer, m_Camera, name, 2.0);
    };
    EXPECT_THAT(global("_WorldSpaceCameraPos"), ElementsAre(1, 2, 3, 0));
    EXPECT_THAT(global("limn_Origin"), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(global("_ScreenParams"), ElementsAre(64, 32, 1.015625f, 1.03125f));
    EXPECT_THAT(global("_ProjectionParams"), ElementsAre(-1, 0.3f, 1000, 0.001f));
    EXPECT_THAT(global("_ScaleBiasRt"), ElementsAre(-1, 1, -1, 1));
    EXPECT_THAT(global("_Time"), ElementsAre(0.1f, 2, 4, 6));
    EXPECT_NEAR(global("_SinTime")[3], std::sin(2.0), 1e-6);
}

TEST_F(Pipeline, TellsShadersPlacesRelativeToACameraThatIsFarAway)
{
    Transform away;
    away.localPosition = {1e8f, -1e8f, 1e8f};
    m_Camera.transform.parent = &away;
    m_Camera.transform.localPosition = {0.25f, 0.5f, -0.75f};
    test::AddCube(m_Scene, "far", {1, 2, 5}, {m_Opaque}).transform.parent = &away;
    const CompiledFrame frame = *Render().frame;
    const auto draws = DrawsOf(frame, 0);
    ASSERT_EQ(draws.size(), 1u);
    ASSERT_EQ(draws[0].instanceCount, 1u) << "what stayed at the origin is out of sight";
    EXPECT_THAT(frame.PerDraw(draws[0]).worldTransformParams, ElementsAre(1, 2, 5, 1));

    const auto global = [&](const char* name)
    {
        return GlobalOf(m_Pipeline, m_Renderer, m_Camera, name);
    };
    EXPECT_THAT(global("limn_Origin"), ElementsAre(1e8f, -1e8f, 1e8f, 1));
    EXPECT_THAT(global("limn_CameraPos"), ElementsAre(0.25f, 0.5f, -0.75f, 0));
    // The camera looks along +z, and along -z in its own space.
    EXPECT_THAT(global("limn_OriginVS"), ElementsAre(-0.25f, -0.5f, -0.75f, 1));
    const glm::mat4 projection = m_Camera.gpuProjectionMatrix(2.0f);
    EXPECT_THAT(global("limn_OriginCS"),
                ElementsAre(-0.25f * projection[0][0], 0.5f * projection[1][1], // turned over
                            -0.75f * projection[2][2] + projection[3][2], 0.75f));
}

TEST_F(Pipeline, SaysWhatIsBeyondAFloat)
{
    Transform huge;
    huge.localScale = glm::vec3(1e30f);
    test::AddCube(m_Scene, "Moon", {0, 0, 1e10f}, {}).transform.parent = &huge;
    EXPECT_THAT(Render().report.notes,
                ElementsAre(Mentions("'Moon':", "nothing", "float", "3.4e38")));
    test::AddCube(m_Scene, "Mars", {0, 1e10f, 0}, {}).transform.parent = &huge;
    EXPECT_THAT(Render().report.notes,
                ElementsAre(Mentions("'Moon' and 1", "nothing", "float", "3.4e38")));
}

TEST_F(Pipeline, KeepsTheTimeInDoubleUntilAShaderGetsIt)
{
    const double t = 1e7 + 0.3; // as a float 1e7
    const auto sines = GlobalOf(m_Pipeline, m_Renderer, m_Camera, "_SinTime", t);
    const auto parameters = GlobalOf(m_Pipeline, m_Renderer, m_Camera, "_TimeParameters", t);
    EXPECT_NEAR(sines[0], std::sin(t / 8), 1e-6);
    EXPECT_NEAR(sines[3], std::sin(t), 1e-6);
    EXPECT_NEAR(parameters[1], std::sin(t), 1e-6);
    EXPECT_NEAR(parameters[2], std::cos(t), 1e-6);
}

TEST_F(Pipeline, RefusesATimeThatIsNoFloatInAShader)
{
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double time : {1.1e38, -1e39, infinity, std::nan("")})
    {
        m_Request.time = time;
        EXPECT_THROW(Render(), ContractError) << time;
    }
    m_Request.time = -1e38;
    EXPECT_NO_THROW(Render());
}

TEST_F(Pipeline, TellsShadersOfBothPipelinesTheColorOfTheMainLight)
{
    for (const char* name : {"_MainLightColor", "_LightColor0"})
    {
        EXPECT_THAT(GlobalOf(m_Pipeline, m_Renderer, m_Camera, name), ElementsAre(1, 1, 1, 1))
            << name;
    }
}

TEST_F(Pipeline, DoesNotLoadTheLastPictureIntoTheOutput)
{
    Render();
    const RenderResult second = Render();
    EXPECT_EQ(second.frame->passes.back().colors[0].texture->name(), "limn_Output");
    EXPECT_EQ(second.frame->passes.back().colors[0].load, LoadOp::DontCare);
}

/// Refuses frames while told to.
class RefusingDevice final : public GraphicsDevice
{
public:
    bool m_Refuses = false;
    void Execute(const CompiledFrame& frame) override
    {
        if (m_Refuses)
        {
            throw ContractError("refused");
        }
        m_States = frame.states;
    }
    const TextureStates& textureStates() const override { return m_States; }
    Image ReadBack(const RenderTexture&) override { return {}; }
    int GetRenderTextureSupportedMSAASampleCount(const RenderTextureDescriptor&) const override
    {
        return 1;
    }
    std::vector<PassTiming> LastFrameTimings() override { return {}; }

private:
    TextureStates m_States;
};

TEST_F(Pipeline, ForgetsAFrameThatTheDeviceRefused)
{
    RefusingDevice device;
    UniversalRenderPipeline pipeline(device);
    pipeline.RenderSingleCamera(m_Renderer, m_Request);
    device.m_Refuses = true;
    m_Request.width = 32; // new textures, which the device never made
    EXPECT_THROW(pipeline.RenderSingleCamera(m_Renderer, m_Request), ContractError);
    device.m_Refuses = false;
    const RenderResult result = pipeline.RenderSingleCamera(m_Renderer, m_Request);
    for (const TextureBarrier& barrier : result.frame->passes[0].barriers)
    {
        EXPECT_EQ(barrier.before, Undefined) << barrier.texture->name();
    }
    EXPECT_EQ(result.frame->passes[0].barriers.size(), 2u);
}

TEST_F(Pipeline, CountsOnNoContentsOfAnotherDevice)
{
    const RTHandle kept(test::Target("Kept"));
    m_Request.alsoReadBack = {kept};
    Render();
    RecordingDevice other;
    m_Pipeline.SetDevice(other);
    Render();
    EXPECT_EQ(m_Device.frames().size(), 1u);
    ASSERT_EQ(other.frames().size(), 1u);
    std::set<std::shared_ptr<const Texture>> seen;
    const auto expectUnknown = [&](const std::vector<TextureBarrier>& barriers)
    {
        for (const TextureBarrier& barrier : barriers)
        {
            const bool isFirst = seen.insert(barrier.texture).second;
            EXPECT_EQ(isFirst, barrier.before == Undefined) << barrier.texture->name();
        }
    };
    for (const CompiledRenderPass& pass : other.frames()[0].passes)
    {
        expectUnknown(pass.barriers);
        for (const auto& color : pass.colors)
        {
            EXPECT_NE(color.load, LoadOp::Load) << color.texture->name();
        }
    }
    expectUnknown(other.frames()[0].finalBarriers);
    EXPECT_TRUE(seen.contains(kept.rt()));
}

TEST_F(Pipeline, ReflectsNothingWithoutAReflectionProbe)
{
    Scene scene;
    test::AddCube(scene, "mirror", {0, 0, 10},
                  {std::make_shared<Material>(test::ShaderWithProgram(
                      "", "TextureCube unity_SpecCube0; SamplerState samplerunity_SpecCube0;",
                      "unity_SpecCube0.Sample(samplerunity_SpecCube0, float3(0, 0, 1))"))});
    m_Request.scene = &scene;
    const RenderResult result = Render();
    const std::vector<test::SeenDraw> draws = DrawsOf(*result.frame, 0);
    ASSERT_EQ(draws.size(), 1u);
    ASSERT_EQ(draws[0].bindings->textures.size(), 1u);
    EXPECT_EQ(draws[0].bindings->textures[0].texture,
              DefaultTexture("black", TextureDimension::Cube));
}

} // namespace
} // namespace limn
