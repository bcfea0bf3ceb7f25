#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <algorithm>
#include <functional>
#include <limn/core/ObjectTable.h>
#include <optional>

namespace limn::test
{

namespace
{

/// No other test has these.
std::uint64_t NewStructure()
{
    static std::uint64_t last = std::uint64_t{1} << 32U;
    return ++last;
}

Rgba8 TexelOf(const TargetPtr& target)
{
    return Texel8(SharedDevice().ReadBack(*target), 0, 0);
}

std::uint64_t RecordedFrames()
{
    return SharedDevice().statistics().recordedFrames;
}

/// Vertices in clip space; every texel what the texture holds at its place.
PassPtr FetchPass()
{
    static const PassPtr pass = CompilePass(R"(
        Texture2D _Source;
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag(float4 p : SV_POSITION) : SV_Target { return _Source.Load(int3(p.xy, 0)); })");
    return pass;
}

/// Every texel what the third component of the object's place holds, as a fraction of 255.
PassPtr ObjectPass()
{
    static const PassPtr pass = CompilePass(R"(
        struct PerDraw { float4x4 m; float4x4 i; float4 p; uint4 l; };
        StructuredBuffer<PerDraw> limn_PerDraw;
        StructuredBuffer<uint> limn_Instances;
        struct Varyings { float4 position : SV_POSITION; float value : TEXCOORD0; };
        Varyings vert(float3 position : POSITION, uint id : SV_InstanceID)
        {
            Varyings result;
            result.position = float4(position, 1);
            result.value = limn_PerDraw[limn_Instances[id]].p.z;
            return result;
        }
        float4 frag(Varyings v) : SV_Target { return v.value / 255.0; })");
    return pass;
}

/// A target in one colour.
class ColorFrames
{
public:
    CompiledFrame Make(Color color, std::uint64_t structure)
    {
        CompiledFrame frame;
        const DrawCommand draw = MakeColorDraw(frame, m_Quad, color);
        CompiledRenderPass pass = ClearPass(target);
        pass.commands.emplace_back(draw);
        frame.passes.push_back(std::move(pass));
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        frame.structure = structure;
        return frame;
    }

    /// What it draws.
    Rgba8 Draw(Color color, std::uint64_t structure)
    {
        SharedDevice().Execute(Make(color, structure));
        return TexelOf(target);
    }

    TargetPtr target = MakeTarget(2, 2);

private:
    MeshPtr m_Quad = MakeQuad();
};

/// `source` is cleared, and drawn into `target` from where it lies.
class CopyFrames
{
public:
    CompiledFrame Make(Color color, std::uint64_t structure, std::uint64_t offset = 0)
    {
        CompiledFrame frame;
        CompiledRenderPass copy = ClearPass(target);
        copy.barriers.push_back({source, TextureUsage::ColorAttachment, TextureUsage::ShaderRead});
        DrawBindings bindings;
        bindings.textures.push_back({FetchPass()->layout.textures.at(0).binding, source, {}});
        copy.commands.emplace_back(MakeDraw(frame, FetchPass(), m_Quad, PlainState(), bindings));
        frame.passes = {ClearPass(source, color), copy};
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        const TextureFootprint needs = SharedDevice().Footprint(*source);
        frame.placed.push_back({source, needs.kind, offset * needs.alignment, needs.size});
        frame.structure = structure;
        return frame;
    }

    Rgba8 Draw(Color color, std::uint64_t structure, std::uint64_t offset = 0)
    {
        SharedDevice().Execute(Make(color, structure, offset));
        return TexelOf(target);
    }

    TargetPtr source = MakeTarget(2, 2);
    TargetPtr target = MakeTarget(2, 2);

private:
    MeshPtr m_Quad = MakeQuad();
};

/// Objects that may be changed, each with one value.
class ValueTable final : public ObjectTable
{
public:
    explicit ValueTable(std::vector<float> values) : m_Values(std::move(values)) {}

    std::uint64_t id() const override { return m_Id; }
    std::uint64_t version() const override { return m_Version; }
    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_Values.size()); }
    PerDrawData Get(std::uint32_t object) const override
    {
        PerDrawData data{};
        data.worldTransformParams[2] = m_Values.at(object);
        return data;
    }
    std::optional<std::span<const std::uint32_t>> ChangedSince(std::uint64_t version) const override
    {
        return version == m_Version ? std::optional(std::span<const std::uint32_t>{})
                                    : std::nullopt;
    }

    void Set(std::vector<float> values)
    {
        m_Values = std::move(values);
        ++m_Version;
    }

private:
    std::vector<float> m_Values;
    std::uint64_t m_Id = NewStructure();
    std::uint64_t m_Version = 1;
};

/// A target that shows the value of one object.
class ObjectFrames
{
public:
    Rgba8 Draw(std::uint32_t object, std::uint64_t structure)
    {
        CompiledFrame frame;
        DrawBindings bindings;
        for (const StorageBufferBinding& buffer : ObjectPass()->layout.storageBuffers)
        {
            if (buffer.name == "limn_PerDraw")
            {
                bindings.perDrawBinding = buffer.binding;
            }
        }
        DrawCommand draw = MakeDraw(frame, ObjectPass(), m_Quad, PlainState(), bindings);
        draw.drawsObjects = true;
        CompiledRenderPass pass = ClearPass(m_Target);
        pass.commands.emplace_back(draw);
        frame.passes = {pass};
        frame.finalBarriers.push_back(
            {m_Target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        frame.objects = table;
        frame.instances = {object};
        frame.structure = structure;
        SharedDevice().Execute(frame);
        return TexelOf(m_Target);
    }

    std::shared_ptr<ValueTable> table =
        std::make_shared<ValueTable>(std::vector<float>{10.0f, 20.0f, 30.0f});

private:
    TargetPtr m_Target = MakeTarget(1, 1);
    MeshPtr m_Quad = MakeQuad();
};

constexpr Rgba8 k_OnlyRed{255, 0, 0, 255};
constexpr Rgba8 k_OnlyGreen{0, 255, 0, 255};
constexpr Rgba8 k_OnlyBlue{0, 0, 255, 255};

Rgba8 Gray(int value)
{
    return {value, value, value, value};
}

} // namespace

class RepeatedFrame : public GpuTest
{
};

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

TEST_F(RepeatedFrame, IsRecordedAnewWhereATextureIsUsedOtherwiseAtItsBeginning)
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

TEST_F(RepeatedFrame, IsRecordedAnewWhereATextureHasMoved)
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

TEST_F(RepeatedFrame, LeavesTexturesInTheUseThatItSays)
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

TEST_F(RepeatedFrame, IsRecordedAnewWhereItsDataAreMore)
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

TEST_F(RepeatedFrame, IsNotTakenForAnotherStructure)
{
    CopyFrames frames;
    const std::uint64_t one = NewStructure();
    const std::uint64_t other = NewStructure();
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, one));
    }
    for (int i = 0; i < 4; ++i) // the colour it clears to is in the commands, and all else equal
    {
        EXPECT_EQ(k_OnlyGreen, frames.Draw(Color::green, other));
        EXPECT_EQ(k_OnlyRed, frames.Draw(Color::red, one));
    }
}

TEST_F(RepeatedFrame, IsRecordedAnewWhereOtherFramesHaveMovedATexture)
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

TEST_F(RepeatedFrame, IsRecordedAnewAfterOneThatMovedATextureAndWasRefused)
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

TEST_F(RepeatedFrame, ShowsObjectsThatAreAddedWhereThereIsRoomForThem)
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
    EXPECT_EQ(Gray(50), frames.Draw(11, structure));
    EXPECT_EQ(Gray(50), frames.Draw(11, structure));
    frames.table = nullptr;
    EXPECT_THROW(frames.Draw(0, structure), ContractError);
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

TEST_F(RepeatedFrame, IsRightAfterOneThatWasRefused)
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
