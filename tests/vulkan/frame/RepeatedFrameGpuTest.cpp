#include "frame/RepeatedFrames.h"

#include <algorithm>

namespace limn::test
{

using RepeatedFrame = GpuTest;

TEST_F(RepeatedFrame, IsRecordedOnceForEachFrameInFlight)
{
    ColorFrames frames;
    const std::uint64_t structure = NewStructure();
    const std::uint64_t before = RecordedFrames();
    for (int i = 0; i < 5; ++i)
    {
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
        EXPECT_EQ(k_OnlyGreen, frames.Draw(Color::green, structure));
    }
    // The first frame finds its target as it never is again.
    EXPECT_LE(RecordedFrames() - before, 3u);
}

TEST_F(RepeatedFrame, IsRecordedEachTimeWithoutAStructure)
{
    ColorFrames frames;
    const std::uint64_t before = RecordedFrames();
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, 0));
    }
    EXPECT_EQ(4u, RecordedFrames() - before);
}

TEST_F(RepeatedFrame, GoesInTurnWithFramesOfOtherStructures)
{
    ColorFrames colors;
    CopyFrames copies;
    const std::uint64_t one = NewStructure();
    const std::uint64_t other = NewStructure();
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(k_OnlyRed, colors.Draw(Color::red, one));
        EXPECT_EQ(k_OnlyBlue, copies.Draw(Color{0.0f, 0.0f, 1.0f, 1.0f}, other));
        EXPECT_EQ(k_OnlyGreen, colors.Draw(Color::green, i % 2 == 0 ? one : 0));
    }
}

TEST_F(RepeatedFrame, IsNotRecordedAgainWhereFourStructuresTakeTurns)
{
    constexpr int k_Count = 4;
    std::array<ColorFrames, k_Count> frames;
    std::array<std::uint64_t, k_Count> structures{};
    std::ranges::generate(structures, NewStructure);
    std::uint64_t before = 0;
    for (int round = 0; round < 8; ++round)
    {
        before = round == 5 ? RecordedFrames() : before; // those before make slots and fill them
        for (std::size_t i = 0; i < k_Count; ++i)
        {
            EXPECT_EQ(k_OnlyRed, frames.at(i).Draw(Color::red, structures.at(i)));
        }
    }
    EXPECT_EQ(before, RecordedFrames());
}

TEST_F(RepeatedFrame, TakesNoMoreMemoryWhereEachHasAStructureOfItsOwn)
{
    VulkanDevice device;
    ColorFrames frames;
    std::uint64_t before = 0;
    for (int i = 0; i < 8; ++i)
    {
        device.Execute(frames.Make(Color::red, NewStructure()));
        before = i == 3 ? device.statistics().usedBytes : before;
    }
    device.Wait();
    EXPECT_EQ(before, device.statistics().usedBytes);
}

TEST_F(RepeatedFrame, KeepsWhatNobodyOwnsUntilItIsDone)
{
    // Slow, so that the validation layer finds it in use where it is freed too early.
    const PassPtr slow = CompilePass(R"(
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag(float4 p : SV_POSITION) : SV_Target
        {
            float sum = 0;
            for (int i = 0; i < 200; ++i)
            {
                sum += frac(sin(p.x * i) * p.y);
            }
            return sum;
        })");
    ColorFrames others;
    others.Draw(Color::red, 0);
    std::optional<CompiledFrame> frame(std::in_place);
    {
        const TargetPtr target = MakeTarget(512, 512);
        CompiledRenderPass pass = ClearPass(target);
        pass.commands.emplace_back(MakeDraw(*frame, slow, MakeQuad()));
        frame->passes.push_back(std::move(pass));
        frame->structure = NewStructure();
    }
    const std::uint64_t before = RecordedFrames();
    for (int i = 0; i < 6; ++i)
    {
        SharedDevice().Execute(*frame);
    }
    EXPECT_GE(3u, RecordedFrames() - before);
    frame.reset();
    SharedDevice().Execute(others.Make(Color::green, 0));
    EXPECT_EQ(k_OnlyGreen, TexelOf(others.target));
}

TEST_F(RepeatedFrame, GivesUpItsImagesWhenNobodyOwnsThem)
{
    SharedDevice().Wait();
    ColorFrames others;
    others.Draw(Color::red, 0);
    others.Draw(Color::red, 0);
    const std::size_t images = SharedDevice().statistics().images;
    std::optional<CopyFrames> frames(std::in_place);
    const std::uint64_t structure = NewStructure();
    for (int i = 0; i < 6; ++i)
    {
        frames->Draw(Color::red, structure);
    }
    EXPECT_EQ(images + 2, SharedDevice().statistics().images);
    frames.reset();
    for (int i = 0; i < 3; ++i)
    {
        others.Draw(Color::red, 0);
    }
    EXPECT_EQ(images, SharedDevice().statistics().images);
}

TEST_F(RepeatedFrame, KeepsWhatItDrawsWithFromFrameToFrame)
{
    ColorFrames frames;
    const std::uint64_t structure = NewStructure();
    std::optional<CompiledFrame> owner = frames.Make(Color::red, structure);
    for (int i = 0; i < 8; ++i)
    {
        SharedDevice().Execute(*owner);
    }
    owner.reset(); // its uses are the last ones recorded
    EXPECT_EQ(k_OnlyRed, TexelOf(frames.target));
}

TEST_F(RepeatedFrame, ShowsObjectsAsTheyAreNow)
{
    ObjectFrames frames;
    const std::uint64_t structure = NewStructure();
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(Gray(10), frames.Draw(0, structure));
    }
    const std::uint64_t before = RecordedFrames();
    EXPECT_EQ(Gray(20), frames.Draw(1, structure)); // another instance
    frames.table->Set({11.0f, 22.0f, 33.0f});
    EXPECT_EQ(Gray(11), frames.Draw(0, structure));
    EXPECT_EQ(Gray(33), frames.Draw(2, structure));
    EXPECT_EQ(before, RecordedFrames());
    std::vector<float> more(100, 44.0f); // the buffer grows
    frames.table->Set(more);
    EXPECT_EQ(Gray(44), frames.Draw(99, structure));
    frames.table->Set({1.0f, 2.0f, 3.0f}); // as many as at first, in another buffer
    EXPECT_EQ(Gray(1), frames.Draw(0, structure));
    EXPECT_EQ(Gray(2), frames.Draw(1, structure));
    EXPECT_EQ(Gray(3), frames.Draw(2, structure));
}

TEST_F(RepeatedFrame, ShowsTheObjectsOfItsOwnTable)
{
    ObjectFrames frames;
    const std::uint64_t structure = NewStructure();
    const auto one = frames.table;
    const auto other = std::make_shared<ValueTable>(std::vector<float>{50.0f, 60.0f, 70.0f});
    for (int i = 0; i < 4; ++i)
    {
        frames.table = one;
        EXPECT_EQ(Gray(10), frames.Draw(0, structure));
        EXPECT_EQ(Gray(20), frames.Draw(1, structure));
        frames.table = other;
        EXPECT_EQ(Gray(50), frames.Draw(0, structure));
    }
}

TEST_F(RepeatedFrame, ReadsATextureInTheFunctionsThatItsBarrierNames)
{
    const PassPtr reader = CompilePass(R"(
        Texture2D _Source;
        struct Varyings { float4 position : SV_POSITION; float4 color : TEXCOORD0; };
        Varyings vert(float3 position : POSITION)
        {
            Varyings result;
            result.position = float4(position, 1);
            result.color = _Source.Load(int3(0, 0, 0));
            return result;
        }
        float4 frag(Varyings v) : SV_Target { return v.color; })");
    const TargetPtr source = MakeTarget(1, 1);
    const TargetPtr target = MakeTarget(1, 1);
    const auto draw = [&](ShaderStage readers)
    {
        CompiledFrame frame;
        CompiledRenderPass pass = ClearPass(target);
        pass.barriers.push_back(
            {source, TextureUsage::ColorAttachment, TextureUsage::ShaderRead, readers});
        DrawBindings bindings;
        bindings.textures.push_back({reader->layout.textures.at(0).binding, source, {}});
        pass.commands.emplace_back(
            MakeDraw(frame, reader, MakeQuad(), PlainState(), std::move(bindings)));
        frame.passes = {ClearPass(source, Color::green), pass};
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        SharedDevice().Execute(frame);
        return TexelOf(target);
    };
    EXPECT_EQ(k_OnlyGreen, draw(ShaderStage::Vertex));
    EXPECT_EQ(k_OnlyGreen, draw(ShaderStage::Both));
    EXPECT_EQ(k_OnlyGreen, draw(ShaderStage::None));
    EXPECT_THROW(draw(ShaderStage::Fragment), ContractError);
}

TEST_F(RepeatedFrame, IsTimed)
{
    ColorFrames frames;
    const std::uint64_t structure = NewStructure();
    for (int i = 0; i < 6; ++i)
    {
        frames.Draw(Color::red, structure);
        SharedDevice().Wait();
        const std::vector<PassTiming> timings = SharedDevice().LastFrameTimings();
        ASSERT_EQ(1u, timings.size());
        EXPECT_EQ("test pass", timings[0].name);
        EXPECT_GT(timings[0].milliseconds, 0.0);
    }
}

} // namespace limn::test
