#include "Mentions.h"
#include "explain/pixel/PixelTest.h"

#include <limn/core/ComputeShader.h>
#include <limn/core/RTHandle.h>

namespace limn::test
{

using testing::ElementsAre;
using testing::FloatNear;
using testing::IsEmpty;
using testing::Pointwise;

TEST_F(PixelHistoryGpu, TellsWhatIsDrawnAndWhatIsBehindIt)
{
    Paint("red", "", "1, 0, 0, 1");
    Paint("green", "", "0, 1, 0, 1", 2001);
    Quad("Front", "red", "position: [0, 0, 0]");
    Quad("Back", "green", "position: [0, 0, 2]");
    const PixelHistory history = Trace(10, 10);

    ASSERT_EQ(4u, history.events.size());
    EXPECT_EQ(PixelFate::Cleared, history.events[0].fate);
    EXPECT_THAT(history.events[0].colors.at(0).after, Pointwise(FloatNear(0), k_Black));
    EXPECT_EQ(Floats{0}, history.events[0].depth->after);

    const PixelEvent front = EventOf(history, "Front");
    EXPECT_EQ(PixelFate::Drawn, front.fate);
    EXPECT_EQ("Draw Opaque Objects", front.pass);
    EXPECT_EQ("red", front.material);
    EXPECT_EQ("Test/red", front.shader);
    EXPECT_EQ("Paint", front.shaderPassName);
    EXPECT_EQ("", front.reason);
    EXPECT_EQ(k_Black, front.colors.at(0).before);
    EXPECT_EQ(k_Red, front.colors.at(0).after);
    EXPECT_EQ(Floats{0}, front.depth->before);
    EXPECT_THAT(front.depth->after, ElementsAre(FloatNear(0.6f, 1e-6f)));

    const PixelEvent back = EventOf(history, "Back");
    EXPECT_EQ(PixelFate::Depth, back.fate);
    EXPECT_THAT(back.reason, Mentions("behind", "0.4", "0.6", "ZTest LEqual"));
    EXPECT_FALSE(back.colors.at(0).isChanged());
    EXPECT_FALSE(back.depth->isChanged());

    EXPECT_EQ(k_Red, history.color);
    EXPECT_THAT(history.written, ElementsAre(255, 0, 0));
    EXPECT_THAT(history.uncovered, IsEmpty());
}

TEST_F(PixelHistoryGpu, CountsFromTheTopLeftAndNamesWhatIsElsewhere)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Up", "red", "position: [-0.75, 0.75, 0], scale: [0.5, 0.5, 1]"); // 0...5 x 0...5
    Quad("Down", "red", "position: [0.75, -0.75, 0], scale: [0.5, 0.5, 1]");
    const PixelHistory corner = Trace(4, 4);
    EXPECT_EQ(PixelFate::Drawn, EventOf(corner, "Up").fate);
    EXPECT_EQ(Names{"Down"}, corner.uncovered);
    const PixelHistory beside = Trace(5, 4);
    EXPECT_EQ((Names{"Up", "Down"}), beside.uncovered);
    EXPECT_THAT(beside.written, ElementsAre(0, 0, 0));
    EXPECT_EQ(Names{"Up"}, Trace(19, 19).uncovered);
}

TEST_F(PixelHistoryGpu, TellsWhatTheStencilRejectsAndWhatWritesNoColour)
{
    Paint("mask", "ColorMask 0 ZWrite Off Stencil { Ref 3 Pass Replace }", "1, 1, 1, 1", 2000);
    Paint("red", "ZTest Always Stencil { Ref 3 Comp Equal }", "1, 0, 0, 1", 2001);
    Quad("Mask", "mask", "position: [-0.5, 0, 0], scale: [1, 2, 1]"); // the left half
    Quad("Seen", "red", "position: [0, 0, 1], scale: [2, 2, 1]");
    const PixelHistory left = Trace(5, 10);
    const PixelEvent mask = EventOf(left, "Mask");
    EXPECT_EQ(PixelFate::ColorMask, mask.fate);
    EXPECT_EQ("it writes no colour: ColorMask 0", mask.reason);
    EXPECT_EQ(Floats{0}, mask.stencil->before);
    EXPECT_EQ(Floats{3}, mask.stencil->after);
    EXPECT_EQ(PixelFate::Drawn, EventOf(left, "Seen").fate);
    EXPECT_EQ(k_Red, left.color);

    const PixelHistory right = Trace(15, 10);
    EXPECT_EQ(Names{"Mask"}, right.uncovered);
    const PixelEvent seen = EventOf(right, "Seen");
    EXPECT_EQ(PixelFate::Stencil, seen.fate);
    EXPECT_THAT(seen.reason, Mentions("stencil", "Ref 3 Comp Equal", "0 is there"));
    EXPECT_EQ(k_Black, right.color);
}

TEST_F(PixelHistoryGpu, NamesTheFirstOfSeveralTestsThatReject)
{
    // Behind and without a stencil: the stencil is looked at first.
    Paint("red", "", "1, 0, 0, 1");
    Paint("both", "Stencil { Ref 1 ReadMask 3 Comp Less }", "0, 1, 0, 1", 2001);
    Quad("Front", "red");
    Quad("Back", "both", "position: [0, 0, 2]");
    const PixelEvent back = EventOf(Trace(10, 10), "Back");
    EXPECT_EQ(PixelFate::Stencil, back.fate);
    EXPECT_THAT(back.reason, Mentions("stencil", "Ref 1 Comp Less", "0 is there", "ReadMask 3"));
}

TEST_F(PixelHistoryGpu, TellsWhichSideIsCulled)
{
    Paint("back", "Cull Back", "1, 0, 0, 1");
    Paint("front", "Cull Front", "1, 0, 0, 1");
    Paint("off", "Cull Off", "0, 1, 0, 1");
    Quad("Turned", "back", "rotation: [0, 180, 0]");
    Quad("Facing", "front");
    Quad("Both", "off", "position: [0, 0, 1], rotation: [0, 180, 0]");
    const PixelHistory history = Trace(8, 8);
    EXPECT_EQ(PixelFate::Culled, EventOf(history, "Turned").fate);
    EXPECT_THAT(EventOf(history, "Turned").reason, Mentions("its back", "Cull Back"));
    EXPECT_EQ(PixelFate::Culled, EventOf(history, "Facing").fate);
    EXPECT_THAT(EventOf(history, "Facing").reason, Mentions("its front", "Cull Front"));
    EXPECT_EQ(PixelFate::Drawn, EventOf(history, "Both").fate);
    EXPECT_EQ(k_Green, history.color);
}

TEST_F(PixelHistoryGpu, TellsWhatTheShaderDiscards)
{
    Paint("holes", "", "1, 0, 0, 1", 2000, "clip(p.x - 10.0);");
    Quad("Cut", "holes");
    EXPECT_EQ(PixelFate::Drawn, EventOf(Trace(12, 10), "Cut").fate);
    const PixelEvent cut = EventOf(Trace(8, 10), "Cut");
    EXPECT_EQ(PixelFate::Discarded, cut.fate);
    EXPECT_THAT(cut.reason, Mentions("shader", "clip", "alpha test"));
    EXPECT_FALSE(cut.depth->isChanged());
}

TEST_F(PixelHistoryGpu, TellsWhatBlendingLeavesAsItWas)
{
    const std::string blend = "ZWrite Off Blend SrcAlpha OneMinusSrcAlpha";
    Paint("green", "", "0, 1, 0, 1");
    Paint("clear", blend, "1, 0.5, 0, 0", 3000);
    Paint("kept", "ZWrite Off Blend Zero One", "1, 0, 0, 1", 3001);
    Paint("again", "ZWrite Off", "0, 1, 0, 1", 3002);
    Paint("half", blend, "1, 0, 0, 0.5", 3003);
    Quad("Ground", "green");
    Quad("Clear", "clear", "position: [0, 0, -1]");
    Quad("Kept", "kept", "position: [0, 0, -1.1]");
    Quad("Again", "again", "position: [0, 0, -1.2]");
    Quad("Half", "half", "position: [0, 0, -1.3]");
    const PixelHistory history = Trace(10, 10);
    EXPECT_EQ(PixelFate::Blend, EventOf(history, "Clear").fate);
    EXPECT_THAT(EventOf(history, "Clear").reason,
                Mentions("adds nothing", "alpha is 0", "(1, 0.5, 0, 0)"));
    EXPECT_EQ(PixelFate::Blend, EventOf(history, "Kept").fate);
    EXPECT_THAT(EventOf(history, "Kept").reason,
                Mentions("adds nothing", "blending", "(1, 0, 0, 1)"));
    EXPECT_EQ(PixelFate::Same, EventOf(history, "Again").fate);
    EXPECT_THAT(EventOf(history, "Again").reason, Mentions("already", "(0, 1, 0, 1)"));
    const PixelEvent half = EventOf(history, "Half");
    EXPECT_EQ(PixelFate::Drawn, half.fate);
    EXPECT_EQ("Draw Transparent Objects", half.pass);
    EXPECT_EQ(k_Green, half.colors.at(0).before);
    EXPECT_THAT(half.colors.at(0).after, Pointwise(FloatNear(1e-3f), Floats{0.5f, 0.5f, 0, 0.75f}));
}

TEST_F(PixelHistoryGpu, TellsWhatTheScissorLeavesOut)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Wide", "red", "scale: [2, 2, 1]");
    const auto load = [&]
    {
        SceneAsset asset = Load();
        // The rows of a texture begin at the bottom of the picture: these are its lowest five.
        asset.renderer.features.push_back(Commands(RenderPassEvent::BeforeRenderingOpaques, "Cut",
                                                   [](CommandBuffer& cmd) {
                                                       cmd.EnableScissorRect({0, 0, 20, 5});
                                                   }));
        asset.renderer.features.push_back(Commands(RenderPassEvent::AfterRenderingOpaques, "Mend",
                                                   [](CommandBuffer& cmd)
                                                   { cmd.DisableScissorRect(); }));
        return asset;
    };
    EXPECT_EQ(PixelFate::Drawn, EventOf(Trace(load(), 10, 15), "Wide").fate);
    const PixelEvent wide = EventOf(Trace(load(), 10, 14), "Wide");
    EXPECT_EQ(PixelFate::Scissor, wide.fate);
    EXPECT_EQ("the scissor leaves the pixel out", wide.reason);
}

TEST_F(PixelHistoryGpu, TellsWhoWouldBeThereButIsNotDrawn)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Masked", "red", "layer: Hidden");
    Quad("Off", "red", "active: false, rotation: [0, 180, 0]");
    Quad("OffElsewhere", "red", "active: false, position: [0.7, 0.7, 0], scale: [0.2, 0.2, 1]");
    Quad("Behind", "red", "position: [0, 0, 20]");
    const PixelHistory history = Trace(10, 10);
    Names absent;
    for (const PixelAbsent& one : history.absent)
    {
        absent.push_back(one.object + (one.isHere ? " here: " : " elsewhere: ") + one.reason);
    }
    EXPECT_THAT(absent, ElementsAre(Mentions("Masked here:", "layer", "culling mask"),
                                    "Off here: inactive", "OffElsewhere elsewhere: inactive",
                                    Mentions("Behind here:", "outside", "frustum")));
    EXPECT_THAT(history.uncovered, IsEmpty());
}

TEST_F(PixelHistoryGpu, TellsWhichOfManyEqualObjectsItIs)
{
    Paint("red", "", "1, 0, 0, 1");
    for (int i = 0; i < 100; ++i) // one for each square of 2x2 pixels, drawn as instances
    {
        Quad("Q" + std::to_string(i), "red",
             "scale: [0.2, 0.2, 1], position: [" + std::to_string((i % 10) * 0.2 - 0.9) + ", " +
                 std::to_string(0.9 - (i / 10) * 0.2) + ", 0]");
    }
    const PixelHistory history = Trace(14, 7);
    EXPECT_EQ(PixelFate::Drawn, EventOf(history, "Q37").fate);
    EXPECT_EQ(99u, history.uncovered.size());
    EXPECT_EQ(3u, history.events.size()) << "the clear, the quad and the copy into the picture";
}

TEST_F(PixelHistoryGpu, FindsWhatCoversAPartOfAPixelWithSeveralSamples)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Left", "red", "position: [-0.98, 0, 0], scale: [1, 2, 1]"); // up to x = 5.2
    const auto load = [&](int samples)
    {
        return Load(std::string(k_Camera) + "msaaSampleCount: " + std::to_string(samples) + "\n");
    };
    EXPECT_EQ(Names{"Left"}, Trace(load(1), 5, 10).uncovered);
    const PixelHistory history = Trace(load(4), 5, 10);
    // One of the four standard places lies left of 0.2.
    const PixelEvent left = EventOf(history, "Left");
    EXPECT_EQ(PixelFate::Drawn, left.fate);
    EXPECT_THAT(left.colors.at(0).after, Pointwise(FloatNear(1e-3f), Floats{0.25f, 0, 0, 1}));
    EXPECT_EQ(Names{"Left"}, Trace(load(4), 6, 10).uncovered);
}

TEST_F(PixelHistoryGpu, LooksAtTheSamePlaceWhereTheCameraDrawsSmaller)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Low", "red", "position: [0.5, -0.5, 0]"); // x, y = 10 ... 20
    const PixelHistory history = Trace(Load(std::string(k_Camera) + "renderScale: 0.5\n"), 15, 16);
    const PixelValue color = EventOf(history, "Low").colors.at(0);
    EXPECT_EQ(7, color.x);
    EXPECT_EQ(8, color.y);
    EXPECT_EQ(10, color.width);
    EXPECT_EQ(10, color.height);
    const PixelEvent& last = history.events.back();
    EXPECT_EQ("Final Blit", last.pass);
    EXPECT_EQ(20, last.colors.at(0).width);
    EXPECT_EQ(k_Red, last.colors.at(0).after);
}

TEST_F(PixelHistoryGpu, DoesNotTakeAShadowMapForThePicture)
{
    Paint("red", "", "1, 0, 0, 1");
    const PixelHistory history = Trace(folder.Load("size: [64, 64]\n"
                                                   "camera: {position: [0, 0, -5]}\n"
                                                   "light: {shadows: Hard}\n"
                                                   "shadows: {mainLightShadowmapResolution: 256}\n"
                                                   "objects:\n"
                                                   "  - {name: Caster, mesh: cube}\n"),
                                       32, 32);
    ASSERT_EQ(1u, history.elsewhere.size());
    EXPECT_EQ("MainLightShadow", history.elsewhere[0].pass);
    EXPECT_EQ("256x256", history.elsewhere[0].size);
    EXPECT_EQ(PixelFate::Drawn, EventOf(history, "Caster").fate);
}

TEST_F(PixelHistoryGpu, NamesObjectsThatCommandsDraw)
{
    Paint("red", "", "1, 0, 0, 1");
    Paint("green", "ZTest Always", "0, 1, 0, 1");
    Quad("Left", "red", "position: [-0.5, 0, 0]");
    Quad("Right", "red", "position: [0.5, 0, 0]");
    Quad("Paint", "green", "active: false");
    SceneAsset asset = Load();
    const GameObject* right = asset.scene.Find("Right");
    const auto green = asset.scene.Find("Paint")->renderer->sharedMaterial();
    asset.renderer.features.push_back(Commands(RenderPassEvent::AfterRenderingOpaques, "Own",
                                               [=](CommandBuffer& cmd)
                                               { cmd.DrawRenderer(*right, green); }));
    const PixelHistory history = Trace(std::move(asset), 15, 10);
    ASSERT_TRUE(HasEvent(history, "Own", PixelFate::Drawn));
    for (const PixelEvent& event : history.events)
    {
        if (event.pass == "Own")
        {
            EXPECT_EQ(Names{"Right"}, event.objects);
            EXPECT_EQ("Test/green", event.shader);
            EXPECT_EQ(k_Red, event.colors.at(0).before);
            EXPECT_EQ(k_Green, event.colors.at(0).after);
        }
    }
    EXPECT_EQ(Names{"Left"}, history.uncovered);
}

TEST_F(PixelHistoryGpu, ShowsDepthWhereAPassHasNoColour)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Front", "red");
    Quad("Back", "red", "position: [0, 0, 2]");
    SceneAsset asset = Load();
    const GameObject* front = asset.scene.Find("Front");
    const GameObject* back = asset.scene.Find("Back");
    const auto red = front->renderer->sharedMaterial();
    RenderTextureDescriptor descriptor(20, 20, GraphicsFormat::None);
    descriptor.depthBufferBits = 32;
    const RTHandle depth =
        RTHandles::Alloc(descriptor, FilterMode::Point, TextureWrapMode::Clamp, "OwnDepth");
    asset.renderer.features.push_back(Commands(RenderPassEvent::BeforeRenderingOpaques, "Depths",
                                               [=](CommandBuffer& cmd)
                                               {
                                                   cmd.SetRenderTarget(depth);
                                                   cmd.ClearRenderTarget(true, false, Color::black);
                                                   cmd.DrawRenderer(*front, red);
                                                   cmd.DrawRenderer(*back, red);
                                               }));
    const PixelHistory history = Trace(std::move(asset), 10, 10);
    std::vector<PixelEvent> events;
    std::ranges::copy_if(history.events, std::back_inserter(events),
                         [](const PixelEvent& event)
                         { return event.depth && event.depth->texture == "OwnDepth"; });
    ASSERT_EQ(3u, events.size());
    EXPECT_EQ(PixelFate::Cleared, events[0].fate);
    EXPECT_EQ(PixelFate::Drawn, events[1].fate);
    EXPECT_EQ("Depths", events[1].pass);
    EXPECT_THAT(events[1].colors, IsEmpty());
    EXPECT_EQ(Floats{0}, events[1].depth->before);
    EXPECT_THAT(events[1].depth->after, ElementsAre(FloatNear(0.6f, 1e-6f)));
    EXPECT_EQ(PixelFate::Depth, events[2].fate);
    EXPECT_FALSE(events[1].isRun) << "nothing reads that depth";
}

TEST_F(PixelHistoryGpu, TakesATargetThatHeldNothingForWritten)
{
    Paint("clear", "ZTest Always", "0, 0, 0, 0");
    Paint("never", "ZTest Never", "1, 1, 1, 1");
    Quad("Zero", "clear");
    Quad("Never", "never");
    SceneAsset asset = Load();
    const GameObject* zero = asset.scene.Find("Zero");
    const GameObject* never = asset.scene.Find("Never");
    RenderTextureDescriptor descriptor(20, 20, GraphicsFormat::R8G8B8A8_UNorm);
    const RTHandle own =
        RTHandles::Alloc(descriptor, FilterMode::Point, TextureWrapMode::Clamp, "Own");
    asset.renderer.features.push_back(
        Commands(RenderPassEvent::BeforeRenderingOpaques, "Fill",
                 [=](CommandBuffer& cmd)
                 {
                     cmd.SetRenderTarget(own, RTHandle());
                     cmd.DrawRenderer(*zero, zero->renderer->sharedMaterial());
                     cmd.DrawRenderer(*never, never->renderer->sharedMaterial());
                 }));
    const PixelHistory history = Trace(std::move(asset), 10, 10);
    std::vector<PixelEvent> events;
    std::ranges::copy_if(history.events, std::back_inserter(events),
                         [](const PixelEvent& event)
                         { return !event.colors.empty() && event.colors[0].texture == "Own"; });
    ASSERT_EQ(2u, events.size());
    EXPECT_EQ(PixelFate::Drawn, events[0].fate);
    EXPECT_THAT(events[0].colors.at(0).before, IsEmpty());
    EXPECT_EQ((Floats{0, 0, 0, 0}), events[0].colors.at(0).after);
    // Without a depth to test against, every test passes.
    EXPECT_EQ(PixelFate::Drawn, events[1].fate);
    EXPECT_EQ((Floats{1, 1, 1, 1}), events[1].colors.at(0).after);
}

TEST_F(PixelHistoryGpu, SeesBuffersAsTheFirstFrameDoesHoweverOftenItIsDrawnAgain)
{
    Paint("red", "", "1, 0, 0, 1");
    Quad("Quad", "red");
    const auto kernels = ComputeShader::FromText("#pragma kernel Count\n#pragma kernel Fill\n"
                                                 "RWStructuredBuffer<uint> _Count;\n"
                                                 "RWTexture2D<float> _Result;\n"
                                                 "[numthreads(1, 1, 1)] void Count()\n"
                                                 "{ _Count[0] += 1; }\n"
                                                 "[numthreads(1, 1, 1)] void Fill(uint3 id : "
                                                 "SV_DispatchThreadID)\n"
                                                 "{ _Result[id.xy] = _Count[0] * 0.25; }\n",
                                                 "count.compute", folder.assets.compiler());
    const auto count = std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 1, 4);
    count->SetData(std::vector<std::uint32_t>{1});
    RenderTextureDescriptor descriptor(20, 20, GraphicsFormat::R32_SFloat);
    descriptor.enableRandomWrite = true;
    const RTHandle result =
        RTHandles::Alloc(descriptor, FilterMode::Point, TextureWrapMode::Clamp, "Result");
    SceneAsset asset = Load();
    asset.renderer.features.push_back(
        Commands(RenderPassEvent::BeforeRenderingOpaques, "Kernels",
                 [=](CommandBuffer& cmd)
                 {
                     cmd.SetComputeBufferParam(kernels, 0, "_Count", count);
                     cmd.SetComputeBufferParam(kernels, 1, "_Count", count);
                     cmd.SetComputeTextureParam(kernels, 1, "_Result", result.nameID());
                     cmd.DispatchCompute(kernels, 0, 1, 1, 1);
                     cmd.DispatchCompute(kernels, 1, 20, 20, 1);
                     cmd.DispatchCompute(kernels, 1, 20, 20, 1);
                     cmd.DispatchCompute(kernels, 0, 1, 1, 1);
                     cmd.DispatchCompute(kernels, 1, 20, 20, 1);
                 }));
    const PixelHistory history = Trace(std::move(asset), 10, 10);
    std::vector<std::pair<PixelFate, Floats>> seen;
    for (const PixelEvent& event : history.events)
    {
        if (event.shader == "count" || event.shaderPassName == "Fill")
        {
            seen.emplace_back(event.fate, event.colors.at(0).after);
        }
    }
    using Seen = std::pair<PixelFate, Floats>;
    EXPECT_THAT(seen,
                ElementsAre(Seen{PixelFate::Dispatched, {0.5f}}, Seen{PixelFate::Same, {0.5f}},
                            Seen{PixelFate::Dispatched, {0.75f}}));
}

TEST_F(PixelHistoryGpu, KnowsWhatAnOverlayCameraDraws)
{
    Paint("red", "", "1, 0, 0, 1");
    Paint("green", "", "0, 1, 0, 1");
    Quad("Ground", "red");
    Quad("Above", "green", "layer: Hidden, position: [0, 0, 1]");
    SceneAsset asset = Load();
    auto overlay = std::make_shared<Camera>(asset.camera);
    overlay->renderType = CameraRenderType::Overlay;
    overlay->cullingMask = LayerMask::FromIndex(7);
    asset.camera.cameraStack.push_back(overlay);
    const PixelHistory history = Trace(std::move(asset), 10, 10);
    EXPECT_EQ(PixelFate::Drawn, EventOf(history, "Ground").fate);
    EXPECT_EQ(PixelFate::Drawn, EventOf(history, "Above").fate);
    EXPECT_THAT(history.absent, IsEmpty());
    EXPECT_EQ(k_Green, history.color);
}

} // namespace limn::test
