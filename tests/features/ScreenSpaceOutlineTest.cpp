#include "Mentions.h"
#include "features/OutlineScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/Inspector.h>
#include <limn/core/RecordingDevice.h>

using namespace limn;
using namespace limn::test;
using test::Mentions;
using testing::ElementsAre;
using testing::IsEmpty;

namespace
{

struct Rendered
{
    RecordingDevice device;
    UniversalRenderPipeline pipeline{device};
    UniversalRenderer renderer{Compiler()};
    OutlineScene content;
    BlendedOutline volumes;
    bool leavesOut = false; ///< off: frames as recorded

    RenderResult Render(const VolumeStack* stack, int width = 64, int height = 48)
    {
        RenderRequest request;
        request.scene = &content.scene;
        request.camera = &content.camera;
        request.width = width;
        request.height = height;
        request.volumeStack = stack;
        request.compile.leavesOut = leavesOut;
        return pipeline.RenderSingleCamera(renderer, request);
    }
};

std::vector<std::string> PassNames(const RenderResult& result)
{
    std::vector<std::string> names;
    for (const ExecutedPassReport& pass : result.report.passes)
    {
        names.push_back(pass.name.name());
    }
    return names;
}

std::vector<std::string> TargetNames(const RenderResult& result)
{
    std::vector<std::string> names;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        names.push_back(pass.colors.front().texture->name());
    }
    return names;
}

TEST(ScreenSpaceOutline, HasTheArticlesDefaultsAndRange)
{
    const ScreenSpaceOutline component;
    EXPECT_FALSE(component.m_Enable.value());
    EXPECT_EQ(component.m_OutlineColor.value(), Color::white);
    EXPECT_EQ(component.m_OutlineWidth.value(), 3.0f);
    EXPECT_EQ(component.m_OutlineWidth.range(), (ValueRange{1.0, 10.0}));
    EXPECT_FALSE(component.IsActive());
    EXPECT_FALSE(component.IsTileCompatible());
}

TEST(ScreenSpaceOutlineSettings, HasTheArticlesDefaults)
{
    const ScreenSpaceOutlineSettings settings;
    EXPECT_EQ(settings.m_RenderPassEvent, RenderPassEvent::AfterRenderingTransparents);
    EXPECT_EQ(settings.m_ScreenSpaceOutlineShader, nullptr);
    EXPECT_EQ(settings.m_RenderQueueRange, ScreenSpaceOutlineSettings::RenderQueueRange::Opaque);
    EXPECT_EQ(settings.m_LayerMask, LayerMask::Nothing());
    EXPECT_EQ(settings.m_RenderingLayerMask, 0);
}

TEST(ScreenSpaceOutlineRenderFeature, DrawsMaskEdgesAndCompositeInThatOrder)
{
    Rendered r;
    AddOutline(r.renderer);
    const RenderResult result = r.Render(&r.volumes.With(true, Color::green, 4.0f));
    EXPECT_THAT(PassNames(result), ElementsAre("Draw Opaque Objects", "Draw Transparent Objects",
                                               "Screen Space Outline", "Final Blit"));
    EXPECT_THAT(TargetNames(result),
                ElementsAre("_CameraColorAttachmentA", "_RendererDrawingTexture", "_OutlineTexture",
                            "_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes, IsEmpty());
    EXPECT_EQ(result.report.passes[2].renderPassEvent, RenderPassEvent(500));

    const CompiledRenderPass& mask = result.frame->passes[1];
    EXPECT_EQ(mask.width, 32);
    EXPECT_EQ(mask.height, 24);
    EXPECT_EQ(mask.colors[0].texture->graphicsFormat(), GraphicsFormat::R8_UNorm);
    EXPECT_EQ(mask.colors[0].load, LoadOp::Clear);
    EXPECT_EQ(mask.colors[0].clearColor, Color::clear);
    EXPECT_FALSE(mask.depth.has_value());
    EXPECT_EQ(result.frame->passes[3].colors[0].load, LoadOp::Load);
}

TEST(ScreenSpaceOutlineRenderFeature, DrawsTheMaskOnceForEachMesh)
{
    Rendered r;
    AddOutline(r.renderer);
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (int i = 0; i < 10; ++i)
    {
        meshes.push_back(CreatePrimitive(i % 2 == 0 ? PrimitiveType::Cube : PrimitiveType::Quad));
    }
    const auto material = r.content.scene.Find("Cube")->renderer->sharedMaterials.at(0);
    r.content.scene = Scene();
    for (int i = 0; i < 10000; ++i)
    {
        // Anywhere, so that meshes and distances have nothing to do with each other.
        const float across = static_cast<float>(i * 37 % 100) * 0.02f - 1.0f;
        r.content.Add("cube", PrimitiveType::Quad,
                      {across, 0.0f, static_cast<float>(i * 61 % 10007) * 1e-3f}, material, true);
        r.content.scene.objects().back()->renderer->mesh = meshes[static_cast<std::size_t>(i) % 10];
    }
    const RenderResult result = r.Render(&r.volumes.With(true, Color::green, 4.0f));
    const CompiledRenderPass& mask = result.frame->passes.at(1);
    ASSERT_EQ(mask.colors[0].texture->name(), "_RendererDrawingTexture");
    std::size_t draws = 0;
    std::uint32_t instances = 0;
    for (const PassCommand& command : mask.commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            ++draws;
            instances += draw->instanceCount;
        }
    }
    EXPECT_EQ(draws, 10u);
    EXPECT_EQ(instances, 10000u);
}

/// Names of the outline's textures that a device has to make for the frame.
std::vector<std::string> OutlineTextures(const CompiledFrame& frame)
{
    std::vector<std::string> names;
    for (const CompiledRenderPass& pass : frame.passes)
    {
        for (const TextureBarrier& barrier : pass.barriers)
        {
            const std::string& name = barrier.texture->name();
            if (name == "_RendererDrawingTexture" || name == "_OutlineTexture")
            {
                names.push_back(name);
            }
        }
    }
    return names;
}

struct NothingToDraw
{
    const char* name;
    Color color;
    float width;
    std::function<void(OutlineScene&)> change;
};

//   Draw Opaque Objects ─▶ limn_Output, and nothing else
TEST(ScreenSpaceOutlineRenderFeature, CostsNoPassAndNoTextureWhereItDrawsNothing)
{
    const NothingToDraw cases[] = {
        {"nothing is selected", Color::green, 4.0f,
         [](OutlineScene& content)
         {
             for (const auto& object : content.scene.objects())
             {
                 object->renderer->renderingLayerMask = RenderingLayerMask::FromIndex(0);
             }
         }},
        {"what is selected is off the screen", Color::green, 4.0f,
         [](OutlineScene& content)
         {
             content.scene.Find("Torus")->transform.localPosition.x = 100.0f;
             content.scene.Find("Cube")->transform.localPosition.x = -100.0f;
         }},
        {"the colour is 0", Color::clear, 4.0f,
         [](OutlineScene&) {
         }},
        {"the width is 0", Color::green, 0.0f, [](OutlineScene&) {
         }}};
    for (const NothingToDraw& c : cases)
    {
        Rendered r;
        r.leavesOut = true;
        AddOutline(r.renderer);
        c.change(r.content);
        const VolumeStack& stack = r.volumes.With(true, c.color, c.width);
        for (int frame = 0; frame < 3; ++frame)
        {
            const RenderResult result = r.Render(&stack);
            EXPECT_THAT(TargetNames(result), ElementsAre("limn_Output"))
                << c.name << ", frame " << frame;
            EXPECT_THAT(OutlineTextures(*result.frame), IsEmpty()) << c.name << ", frame " << frame;
        }
    }
}

TEST(ScreenSpaceOutlineRenderFeature, CostsNoPassAndNoTextureWhereNoVolumeEnablesIt)
{
    Rendered r;
    r.leavesOut = true;
    AddOutline(r.renderer);
    const VolumeStack* stacks[] = {&r.volumes.With(false, Color::green, 4.0f), nullptr};
    for (const VolumeStack* stack : stacks)
    {
        const RenderResult result = r.Render(stack);
        EXPECT_THAT(TargetNames(result), ElementsAre("limn_Output"));
        EXPECT_THAT(OutlineTextures(*result.frame), IsEmpty());
    }
}

TEST(ScreenSpaceOutlineRenderFeature, IsDrawnAsBeforeWhereThereIsSomething)
{
    Rendered r;
    r.leavesOut = true;
    AddOutline(r.renderer);
    const RenderResult result = r.Render(&r.volumes.With(true, Color::green, 4.0f));
    EXPECT_THAT(TargetNames(result), ElementsAre("_RendererDrawingTexture", "_OutlineTexture",
                                                 "_CameraColorAttachmentA", "limn_Output"))
        << "the camera's passes wait for the edges, so that they are one";
    EXPECT_EQ(LoadOp::DontCare, result.frame->passes[1].colors[0].load) << "it is covered";
}

TEST(ScreenSpaceOutlineRenderFeature, FiltersByQueueLayerAndRenderingLayer)
{
    Rendered r;
    AddOutline(r.renderer);
    const RenderResult result = r.Render(&r.volumes.With(true, Color::green, 4.0f));
    const DrawRenderersReport* draw = nullptr;
    for (const DrawRenderersReport& candidate : result.report.draws)
    {
        if (candidate.pass == "Screen Space Outline")
        {
            draw = &candidate;
        }
    }
    ASSERT_NE(draw, nullptr);
    EXPECT_EQ(draw->filtering, FilteringSettings(RenderQueueRange(0, 2500), LayerMask(1u << 6),
                                                 RenderingLayerMask(1u << 8)));
    EXPECT_EQ(draw->counts, (FilterCounts{2, 0, 0, 1, 0})); // the sphere is not selected
}

TEST(ScreenSpaceOutlineRenderFeature, EnqueuesNothingAndAllocatesNothingWhenTheVolumeDisablesIt)
{
    Rendered r;
    AddOutline(r.renderer);
    const RenderResult result = r.Render(&r.volumes.With(false, Color::green, 4.0f));
    EXPECT_THAT(PassNames(result),
                ElementsAre("Draw Opaque Objects", "Draw Transparent Objects", "Final Blit"));
    EXPECT_THAT(TargetNames(result), ElementsAre("_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes,
                ElementsAre(Mentions("Screen Space Outline", "not drawn", "a volume",
                                     "ScreenSpaceOutline.m_Enable", "false")));
}

TEST(ScreenSpaceOutlineRenderFeature, SaysThatNoVolumeEnablesIt)
{
    Rendered r;
    AddOutline(r.renderer);
    const RenderResult result = r.Render(&r.volumes.WithoutVolumes());
    EXPECT_THAT(TargetNames(result), ElementsAre("_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes,
                ElementsAre(Mentions("Screen Space Outline", "not drawn", "no volume",
                                     "ScreenSpaceOutline.m_Enable", "default")));
}

TEST(ScreenSpaceOutlineRenderFeature, TakesNoVolumeStackForOneWithoutVolumes)
{
    Rendered r;
    AddOutline(r.renderer);
    EXPECT_THAT(r.Render(nullptr).report.notes,
                ElementsAre(Mentions("Screen Space Outline", "not drawn", "no volume",
                                     "ScreenSpaceOutline.m_Enable", "default")));
}

TEST(ScreenSpaceOutlineRenderFeature, SaysThatItsComponentWasNotRegistered)
{
    Rendered r;
    AddOutline(r.renderer);
    const VolumeComponentRegistry registry;
    const VolumeStack stack = VolumeManager(registry).CreateStack();
    EXPECT_THAT(r.Render(&stack).report.notes,
                ElementsAre(Mentions("Screen Space Outline", "not drawn", "ScreenSpaceOutline",
                                     "not registered")));
}

TEST(ScreenSpaceOutlineRenderFeature, SaysThatItIsInactive)
{
    Rendered r;
    AddOutline(r.renderer).SetActive(false);
    const RenderResult result = r.Render(&r.volumes.With(true, Color::green, 4.0f));
    EXPECT_THAT(TargetNames(result), ElementsAre("_CameraColorAttachmentA", "limn_Output"));
    EXPECT_THAT(result.report.notes,
                ElementsAre(Mentions("Screen Space Outline", "not drawn", "inactive")));
}

TEST(ScreenSpaceOutlineRenderFeature, SaysWhyWhenNothingPassesTheFilter)
{
    Rendered r;
    ScreenSpaceOutlineSettings settings = Settings();
    settings.m_LayerMask = LayerMask::Nothing(); // the article's default
    AddOutline(r.renderer, settings);
    EXPECT_THAT(r.Render(&r.volumes.With(true, Color::green, 4.0f)).report.notes,
                ElementsAre(Mentions("Screen Space Outline", "0 of 3", "layer mask leaves out 3",
                                     "layerMask is 0")));
}

TEST(ScreenSpaceOutlineRenderFeature, SaysThatItHasNoShader)
{
    Rendered r;
    ScreenSpaceOutlineSettings settings = Settings();
    settings.m_ScreenSpaceOutlineShader = nullptr;
    AddOutline(r.renderer, settings);
    EXPECT_THAT(
        r.Render(&r.volumes.With(true, Color::green, 4.0f)).report.notes,
        ElementsAre(Mentions("Screen Space Outline", "not drawn", "m_ScreenSpaceOutlineShader",
                             "assign Hidden/ScreenSpaceOutline")));
}

TEST(ScreenSpaceOutlineRenderFeature, RefusesRenderingLayer32)
{
    ScreenSpaceOutlineSettings settings = Settings();
    settings.m_RenderingLayerMask = 32;
    UniversalRenderer renderer(Compiler());
    try
    {
        AddOutline(renderer, settings);
        FAIL() << "index 32 was accepted";
    }
    catch (const ContractError& error)
    {
        EXPECT_STREQ(error.what(), "rendering layer index 32 is outside 0...31");
    }
}

TEST(ScreenSpaceOutlineRenderFeature, KeepsItsTexturesBetweenFramesAndReplacesThemOnAResize)
{
    Rendered r;
    AddOutline(r.renderer);
    const VolumeStack& stack = r.volumes.With(true, Color::green, 4.0f);
    const RenderResult first = r.Render(&stack);
    const RenderResult second = r.Render(&stack);
    EXPECT_EQ(first.frame->passes[1].colors[0].texture, second.frame->passes[1].colors[0].texture);
    const RenderResult larger = r.Render(&stack, 128, 96);
    EXPECT_NE(first.frame->passes[1].colors[0].texture, larger.frame->passes[1].colors[0].texture);
    EXPECT_EQ(larger.frame->passes[1].width, 64);
}

TEST(ScreenSpaceOutlineRenderFeature, NeverMakesATextureSmallerThanOneTexel)
{
    Rendered r;
    AddOutline(r.renderer);
    const RenderResult result = r.Render(&r.volumes.With(true, Color::green, 4.0f), 1, 1);
    EXPECT_EQ(result.frame->passes[1].width, 1);
    EXPECT_EQ(result.frame->passes[1].height, 1);
}

} // namespace
