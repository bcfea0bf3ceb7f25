#include "Mentions.h"
#include "core/ThrownMessage.h"
#include "core/scene/TestScene.h"

#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/RenderObjects.h>

using namespace limn;
using test::Mentions;
using testing::ElementsAre;
using testing::IsEmpty;

namespace
{

using Mode = RenderObjectsSettings::OverrideMaterialMode;

constexpr int k_Layer = 3;

/// A cube in layer 3 with a forward pass, and one more pass with LightMode StencilMask.
std::shared_ptr<const Shader> TwoPassShader()
{
    static const auto shader = test::ShaderOf(
        "Shader \"Test/Two\" { Properties { _Tint (\"\", Float) = 2 } SubShader {\n"
        "Pass { Name \"Fill\" Tags { \"LightMode\" = \"UniversalForward\" } Cull Back " +
        test::Program() + "}\nPass { Name \"Mask\" Tags { \"LightMode\" = \"StencilMask\" } Cull " +
        "Front Stencil { Ref 9 Pass Replace } " + test::Program() + "} } }");
    return shader;
}

class RenderObjectsFeature : public testing::Test
{
protected:
    RenderObjectsFeature()
    {
        settings.filterSettings.LayerMask = LayerMask::FromIndex(k_Layer);
        test::AddCube(scene, "inside", {0, 0, 5}, {material}).layer = k_Layer;
        test::AddCube(scene, "outside", {1, 0, 5}, {material});
    }

    RenderResult Render()
    {
        UniversalRenderer renderer(test::Compiler());
        renderer.AddFeature(std::make_unique<RenderObjects>(settings));
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = 64;
        request.height = 32;
        return pipeline.RenderSingleCamera(renderer, request);
    }

    /// What is drawn between the pass's samples is set up with.
    std::vector<DrawSetup> Draws(const RenderResult& result) const
    {
        std::vector<DrawSetup> draws;
        int depth = 0;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                if (const auto* begin = std::get_if<BeginSampleCommand>(&command))
                {
                    depth += depth > 0 || begin->name == settings.passTag ? 1 : 0;
                }
                else if (std::holds_alternative<EndSampleCommand>(command))
                {
                    depth -= depth > 0 ? 1 : 0;
                }
                else if (const auto* draw = std::get_if<DrawCommand>(&command); draw && depth > 0)
                {
                    draws.push_back(result.frame->Setup(*draw));
                }
            }
        }
        return draws;
    }

    RenderObjectsSettings settings;
    Scene scene;
    Camera camera;
    const std::shared_ptr<Material> material = std::make_shared<Material>(TwoPassShader());
    RecordingDevice device;
    UniversalRenderPipeline pipeline{device};
};

TEST_F(RenderObjectsFeature, HasUnitysDefaults)
{
    const RenderObjectsSettings defaults;
    EXPECT_EQ(defaults.passTag, "RenderObjectsFeature");
    EXPECT_EQ(defaults.Event, RenderPassEvent::AfterRenderingOpaques);
    EXPECT_EQ(defaults.filterSettings.RenderQueueType, RenderQueueType::Opaque);
    EXPECT_EQ(defaults.filterSettings.LayerMask, LayerMask::Nothing());
    EXPECT_EQ(defaults.overrideMode, Mode::Material);
    EXPECT_FALSE(defaults.overrideDepthState);
    EXPECT_EQ(defaults.depthCompareFunction, CompareFunction::LessEqual);
    EXPECT_TRUE(defaults.enableWrite);
    EXPECT_FALSE(defaults.stencilSettings.overrideStencilState);
    EXPECT_TRUE(defaults.cameraSettings.restoreCamera);
    EXPECT_EQ(defaults.cameraSettings.cameraFieldOfView, 60.0f);
}

TEST_F(RenderObjectsFeature, DrawsTheFilteredObjectsOnceMore)
{
    const RenderResult result = Render();
    EXPECT_EQ(Draws(result).size(), 1u);
    EXPECT_EQ(result.report.draws.at(1).counts, (FilterCounts{1, 0, 1, 0, 0}));
}

TEST_F(RenderObjectsFeature, DrawsNothingUntilLayersAreChosenAndSaysSo)
{
    settings.filterSettings.LayerMask = LayerMask::Nothing();
    const RenderResult result = Render();
    EXPECT_THAT(Draws(result), IsEmpty());
    EXPECT_THAT(result.report.notes,
                ElementsAre(Mentions("RenderObjectsFeature", "0 of 2", "layer mask leaves out 2",
                                     "layerMask is 0")));
}

TEST_F(RenderObjectsFeature, DrawsThePassesOfTheNamesItIsGiven)
{
    settings.filterSettings.PassNames = {"StencilMask"};
    const auto draws = Draws(Render());
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Front);
    EXPECT_EQ(draws[0].state.stencilReference, 9);
}

TEST_F(RenderObjectsFeature, NamesTheLightModesThereAreWhereANameFitsNone)
{
    settings.filterSettings.PassNames = {"StencilMsak"};
    EXPECT_THAT(Render().report.notes,
                testing::Contains(Mentions("RenderObjectsFeature", "filterSettings.PassNames",
                                           "'StencilMsak'", "'StencilMask'")));
}

TEST_F(RenderObjectsFeature, ReplacesDepthAndStencilOnlyWhereAsked)
{
    settings.filterSettings.PassNames = {"StencilMask"};
    settings.enableWrite = false;
    settings.stencilSettings.stencilReference = 4;
    EXPECT_EQ(Draws(Render()).at(0).state.stencilReference, 9);
    EXPECT_TRUE(Draws(Render()).at(0).state.zWrite);

    settings.overrideDepthState = true;
    settings.stencilSettings.overrideStencilState = true;
    settings.stencilSettings.zFailOperation = StencilOp::Invert;
    const PipelineState state = Draws(Render()).at(0).state;
    EXPECT_FALSE(state.zWrite);
    EXPECT_EQ(state.zTest, CompareFunction::LessEqual);
    EXPECT_EQ(state.stencilReference, 4);
    EXPECT_EQ(state.stencilFront, (StencilFace{CompareFunction::Always, StencilOp::Keep,
                                               StencilOp::Keep, StencilOp::Invert}));
    EXPECT_EQ(state.stencilReadMask, 255);
}

TEST_F(RenderObjectsFeature, DrawsWithAMaterialOrAShaderInsteadByItsMode)
{
    settings.overrideMaterial =
        std::make_shared<Material>(test::ShaderWithProgram("", "", "1", "Cull Off"));
    settings.overrideShader = test::ShaderWithProgram("", "", "1", "ZWrite Off");
    EXPECT_EQ(Draws(Render()).at(0).state.cull, CullMode::Off);
    settings.overrideMode = Mode::Shader;
    EXPECT_EQ(Draws(Render()).at(0).state.cull, CullMode::Back);
    EXPECT_FALSE(Draws(Render()).at(0).state.zWrite);
    settings.overrideMode = Mode::None;
    EXPECT_TRUE(Draws(Render()).at(0).state.zWrite);
}

TEST_F(RenderObjectsFeature, RefusesAPassThatTheOverrideDoesNotHave)
{
    settings.overrideMaterial = material;
    settings.overrideMaterialPassIndex = 2;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                Mentions("RenderObjects", "overrideMaterialPassIndex is 2", "'Test/Two'", "0...1"));
    settings.overrideMode = Mode::Shader;
    settings.overrideShader = TwoPassShader();
    settings.overrideShaderPassIndex = -1;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Render(); }),
                Mentions("RenderObjects", "overrideShaderPassIndex is -1", "'Test/Two'", "0...1"));
}

TEST_F(RenderObjectsFeature, RunsNoEarlierThanThePrepasses)
{
    settings.Event = RenderPassEvent::BeforeRendering;
    RenderObjects feature(settings);
    feature.Create();
    EXPECT_EQ(feature.settings.Event, RenderPassEvent::BeforeRenderingPrePasses);
}

TEST_F(RenderObjectsFeature, TakesTransparentObjectsByQueue)
{
    settings.filterSettings.RenderQueueType = RenderQueueType::Transparent;
    EXPECT_THAT(Draws(Render()), IsEmpty());
    material->SetRenderQueue(3000);
    EXPECT_EQ(Draws(Render()).size(), 1u);
}

/// Where the origin of view space ends up in clip space, by the matrices in force at each draw.
class RenderObjectsCamera : public RenderObjectsFeature
{
protected:
    RenderObjectsCamera()
    {
        auto shader = test::ShaderOf(
            "Shader \"Test/View\" { SubShader { Pass { Tags { \"LightMode\" = "
            "\"UniversalForward\" } " +
            test::Program("float4x4 unity_MatrixV; float4x4 glstate_matrix_projection;",
                          "unity_MatrixV[0] + glstate_matrix_projection[0]") +
            "} } }");
        seen = std::make_shared<Material>(std::move(shader));
        scene.Find("inside")->renderer->sharedMaterials = {seen};
        scene.Find("outside")->activeSelf = false;
        settings.Event = RenderPassEvent::BeforeRenderingOpaques;
        settings.cameraSettings.overrideCamera = true;
        settings.cameraSettings.cameraFieldOfView = 90.0f;
        settings.cameraSettings.offset = {0, 0, 2, 0};
        camera.fieldOfView = 60.0f;
    }

    /// The z of the view translation, and the vertical scale of the projection, which is turned
    /// over for a texture, draw by draw.
    std::vector<std::pair<float, float>> Seen()
    {
        const RenderResult result = Render();
        std::vector<std::pair<float, float>> values;
        for (const CompiledRenderPass& pass : result.frame->passes)
        {
            for (const PassCommand& command : pass.commands)
            {
                const auto* draw = std::get_if<DrawCommand>(&command);
                if (draw == nullptr || draw->mesh == DrawCommand::k_NoMesh)
                {
                    continue;
                }
                values.emplace_back(
                    Member(*result.frame, *draw, "unity_MatrixV", 3, 2),
                    Member(*result.frame, *draw, "glstate_matrix_projection", 1, 1));
            }
        }
        return values;
    }

    static float Member(const CompiledFrame& frame, const DrawCommand& draw, const char* name,
                        int column, int row)
    {
        for (const UniformBuffer& buffer : frame.Setup(draw).program->layout.buffers)
        {
            for (const UniformMember& member : buffer.members)
            {
                for (const UniformSlice& slice : frame.Setup(draw).bindings->uniforms)
                {
                    if (member.name == name && slice.binding == buffer.binding)
                    {
                        float value = 0.0f;
                        const std::size_t element = static_cast<std::size_t>(column * 4 + row);
                        std::memcpy(&value,
                                    frame.uniformData.data() + slice.offset + member.offset +
                                        element * sizeof value,
                                    sizeof value);
                        return value;
                    }
                }
            }
        }
        ADD_FAILURE() << name << " is not bound";
        return 0.0f;
    }

    std::shared_ptr<const Material> seen;
};

TEST_F(RenderObjectsCamera, IsItsOwnForItsObjectsAndRestoredAfterwards)
{
    // The cotangents of half of 90 and of half of 60 degrees.
    const auto values = Seen();
    ASSERT_EQ(values.size(), 2u);
    EXPECT_NEAR(values[0].first, 2.0f, 1e-6);
    EXPECT_NEAR(values[0].second, -1.0f, 1e-6);
    EXPECT_NEAR(values[1].first, 0.0f, 1e-6);
    EXPECT_NEAR(values[1].second, -1.7320508f, 1e-6);
}

TEST_F(RenderObjectsCamera, StaysWhereItIsNotRestored)
{
    settings.cameraSettings.restoreCamera = false;
    const auto values = Seen();
    ASSERT_EQ(values.size(), 2u);
    EXPECT_NEAR(values[1].first, 2.0f, 1e-6);
    EXPECT_NEAR(values[1].second, -1.0f, 1e-6);
}

} // namespace
