#include "frame/RepeatedFrames.h"

#include <functional>
#include <utility>

namespace limn::test
{

using FrameToRecord = GpuTest;

TEST_F(FrameToRecord, IsRecordedAnewWhereATextureIsUsedOtherwiseAtItsBeginning)
{
    ColorFrames frames;
    const std::uint64_t structure = NewStructure();
    const auto draw = [&](TextureUsage before)
    {
        CompiledFrame frame = frames.Make(Color::red, structure);
        frame.passes[0].barriers[0].before = before;
        SharedDevice().Execute(frame);
        EXPECT_EQ(k_OnlyRed, TexelOf(frames.target));
    };
    for (int i = 0; i < 4; ++i)
    {
        draw(i == 0 ? TextureUsage::Undefined : TextureUsage::CopySource);
    }
    CompiledFrame other; // leaves it for shaders to read
    other.passes.push_back(ClearPass(frames.target));
    other.finalBarriers.push_back(
        {frames.target, TextureUsage::ColorAttachment, TextureUsage::ShaderRead});
    SharedDevice().Execute(other);
    const std::uint64_t before = RecordedFrames();
    EXPECT_THROW(draw(TextureUsage::CopySource), ContractError); // and not as if nothing had been
    draw(TextureUsage::ShaderRead);
    EXPECT_LT(before, RecordedFrames());
}

TEST_F(FrameToRecord, IsRecordedAnewWhereATextureHasMoved)
{
    CopyFrames frames;
    const std::uint64_t first = NewStructure();
    const std::uint64_t second = NewStructure();
    for (int i = 0; i < 3; ++i)
    {
        for (int j = 0; j < 3; ++j)
        {
            EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, first, 0));
        }
        for (int j = 0; j < 3; ++j)
        {
            EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, second, 3));
        }
    }
}

TEST_F(FrameToRecord, LeavesTexturesInTheUseThatItSays)
{
    ColorFrames frames;
    const std::uint64_t drawn = NewStructure();
    const std::uint64_t passedOn = NewStructure();
    for (int i = 0; i < 6; ++i)
    {
        CompiledFrame frame = frames.Make(Color::red, drawn);
        frame.finalBarriers[0].after = TextureUsage::ShaderRead;
        SharedDevice().Execute(frame);
        EXPECT_THROW(TexelOf(frames.target), ContractError);
        CompiledFrame next;
        next.finalBarriers.push_back(
            {frames.target, TextureUsage::ShaderRead, TextureUsage::CopySource});
        next.structure = passedOn;
        SharedDevice().Execute(next);
        EXPECT_EQ(k_OnlyRed, TexelOf(frames.target));
    }
}

TEST_F(FrameToRecord, IsRecordedAnewWhereItsDataAreMore)
{
    ColorFrames frames;
    const auto isRecorded = [&](const std::function<void(CompiledFrame&)>& change)
    {
        const std::uint64_t structure = NewStructure();
        CompiledFrame frame = frames.Make(Color::red, structure);
        frame.perDraw.resize(2);
        frame.instances = {0, 1};
        for (int i = 0; i < 4; ++i)
        {
            SharedDevice().Execute(frame);
        }
        change(frame);
        const std::uint64_t before = RecordedFrames();
        SharedDevice().Execute(frame);
        return RecordedFrames() > before;
    };
    EXPECT_FALSE(isRecorded([](CompiledFrame& frame) { frame.instances = {1, 0}; }));
    EXPECT_TRUE(isRecorded([](CompiledFrame& frame) { frame.uniformData.resize(100000); }));
    EXPECT_TRUE(isRecorded([](CompiledFrame& frame) { frame.perDraw.resize(3); }));
    EXPECT_TRUE(isRecorded([](CompiledFrame& frame) { frame.instances.push_back(0); }));
}

TEST_F(FrameToRecord, IsNotTakenForOneOfAnotherStructure)
{
    CopyFrames frames;
    for (int i = 0; i < 12; ++i) // the colour it clears to is in the commands, and all else equal
    {
        const Color color{static_cast<float>(i) / 255.0f, 0.0f, 0.0f, 1.0f};
        EXPECT_EQ((Rgba8{i, 0, 0, 255}), frames.Draw(color, NewStructure()));
    }
}

TEST_F(FrameToRecord, IsRecordedAnewWhereOtherFramesHaveMovedATexture)
{
    for (const bool isDone : {true, false})
    {
        CopyFrames frames;
        const std::uint64_t structure = NewStructure();
        for (int i = 0; i < 4; ++i)
        {
            EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
        }
        const std::uint64_t before = RecordedFrames();
        SharedDevice().Execute(frames.Make(Color::green, 0, 3));
        if (isDone)
        {
            SharedDevice().Wait();
        }
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
        EXPECT_LE(2u, RecordedFrames() - before);
    }
}

TEST_F(FrameToRecord, IsRecordedAnewAfterOneThatMovedATextureAndWasRefused)
{
    CopyFrames frames;
    const std::uint64_t structure = NewStructure();
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
    }
    CompiledFrame refused = frames.Make(Color::green, 0, 3);
    refused.finalBarriers[0].after = TextureUsage::Undefined;
    EXPECT_THROW(SharedDevice().Execute(refused), ContractError);
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
    }
}

TEST_F(FrameToRecord, ShowsObjectsThatAreAddedWhereThereIsRoomForThem)
{
    ObjectFrames frames;
    const std::uint64_t structure = NewStructure();
    EXPECT_EQ(Gray(10), frames.Draw(0, structure));
    frames.table->Set(std::vector<float>(8, 40.0f)); // the buffer grows to half as much again
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(Gray(40), frames.Draw(7, structure));
    }
    frames.table->Set(std::vector<float>(12, 50.0f));
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(Gray(50), frames.Draw(11, structure));
    }
    const auto kept = std::exchange(frames.table, nullptr);
    EXPECT_THROW(frames.Draw(0, structure), ContractError);
}

TEST_F(FrameToRecord, IsRightAfterOneThatWasRefused)
{
    ColorFrames frames;
    CopyFrames copies;
    const std::uint64_t structure = NewStructure();
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, structure));
    }
    for (int i = 0; i < 3; ++i)
    {
        CompiledFrame refused = copies.Make(Color{0.0f, 0.0f, 1.0f, 1.0f}, 0);
        refused.finalBarriers[0].after = TextureUsage::Undefined;
        EXPECT_THROW(SharedDevice().Execute(refused), ContractError);
        EXPECT_EQ(k_OnlyGreen, frames.Draw(Color::green, structure));
    }
}

} // namespace limn::test
