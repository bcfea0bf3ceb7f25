#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/FrameCompiler.h>

#include "frame/FrameBuilder.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::FrameBuilder;
using test::RenderTexturePtr;
using testing::ElementsAre;

/// A mask and a picture that samples it, frame after frame.
class FramesOfOneStructure : public testing::Test
{
protected:
    FrameCommands Record()
    {
        FrameBuilder frame;
        frame.Begin("Outline").Bind(m_Mask).Clear(ClearFlag::Color).Draw(1).lastDraw().mesh = 0;
        frame.Bind(m_Camera).Clear(ClearFlag::Color, Color::white).Draw(2, {m_Mask}).End();
        FrameCommands commands = frame.Take();
        commands.meshes = {test::Cube()};
        commands.uniformData.resize(16, std::byte{m_Byte++});
        return commands;
    }

    std::shared_ptr<const CompiledFrame> Compile(FrameCommands commands)
    {
        auto frame = m_Cache.Compile(commands, m_States, m_Outputs, m_Options);
        m_States = frame->states;
        return frame;
    }

    /// Frames until nothing of the first ones is left to learn.
    void Settle()
    {
        for (int i = 0; i < 3; ++i)
        {
            Compile(Record());
        }
    }

    const RenderTexturePtr m_Mask = test::Target("Mask", 8, 4, true);
    const RenderTexturePtr m_Camera = test::Target("Camera");
    std::vector<RenderTexturePtr> m_Outputs{m_Camera};
    FrameCompilerOptions m_Options;
    TextureStates m_States;
    FrameCache m_Cache;
    std::uint8_t m_Byte = 0;
};

TEST_F(FramesOfOneStructure, AreWorkedOutOnce)
{
    Settle();
    const std::uint64_t structure = Compile(Record())->structure;
    EXPECT_NE(structure, 0u);
    EXPECT_EQ(Compile(Record())->structure, structure);
}

TEST_F(FramesOfOneStructure, HaveTheirOwnUniformAndPerDrawData)
{
    Settle();
    FrameCommands commands = Record();
    commands.uniformData.assign(16, std::byte{42});
    commands.instances = {7};
    const auto first = Compile(commands);
    commands.uniformData.assign(16, std::byte{43});
    commands.instances = {8};
    const auto second = Compile(commands);
    EXPECT_EQ(second->structure, first->structure);
    EXPECT_EQ(first->uniformData, std::vector<std::byte>(16, std::byte{42})) << "it is still held";
    EXPECT_THAT(first->instances, ElementsAre(7u));
    EXPECT_EQ(second->uniformData, std::vector<std::byte>(16, std::byte{43}));
    EXPECT_THAT(second->instances, ElementsAre(8u));
    EXPECT_EQ(second->passes.size(), 2u);
}

TEST_F(FramesOfOneStructure, LeaveTheListsMemoryWithTheirCommands)
{
    Settle();
    FrameCommands commands = Record();
    m_Cache.Compile(commands, m_States, m_Outputs, m_Options);
    EXPECT_GT(commands.commands.capacity(), 0u);
    EXPECT_EQ(commands.uniformData.size(), 16u) << "of the frame before";
}

TEST_F(FramesOfOneStructure, AreNoneWhereAnythingThatCountsIsAnother)
{
    const auto drawOf = [](FrameCommands& commands) -> DrawCommand&
    {
        return std::get<DrawCommand>(
            *std::ranges::find_if(commands.commands, [](const FrameCommand& command)
                                  { return std::holds_alternative<DrawCommand>(command); }));
    };
    const std::pair<const char*, std::function<void(FrameCommands&)>> k_Changes[] = {
        {"a command",
         [](auto& c)
         {
             c.commands.pop_back();
         }},
        {"a sample's name",
         [](auto& c)
         {
             std::get<BeginSampleCommand>(c.commands[0]).name = SampleName("Other");
         }},
        {"how often a draw is drawn",
         [&](auto& c)
         {
             ++drawOf(c).instanceCount;
         }},
        {"where a draw is seen",
         [&](auto& c)
         {
             drawOf(c).bounds = TargetRegion{0, 0, 0.5, 1};
         }},
        {"a draw's state",
         [](auto& c)
         {
             c.setups[0].state.cull = CullMode::Off;
         }},
        {"a draw's shader pass",
         [](auto& c)
         {
             c.setups[0].shaderPass = 1;
         }},
        {"a uniform's place",
         [](auto& c)
         {
             auto bindings = std::make_shared<DrawBindings>(*c.setups[0].bindings);
             bindings->uniforms.push_back({0, 0, 16});
             c.setups[0].bindings = bindings;
         }},
        {"what a draw promises",
         [](auto& c)
         {
             c.setups[1].fullScreen = std::make_shared<FullScreenPromise>();
         }},
        {"a mesh",
         [](auto& c)
         {
             c.meshes = {CreatePrimitive(PrimitiveType::Quad)};
         }},
        {"how many uniform bytes",
         [](auto& c)
         {
             c.uniformData.resize(32);
         }},
        {"how many instances",
         [](auto& c)
         {
             c.instances.resize(1);
         }},
        {"how many per-draw elements",
         [](auto& c)
         {
             c.perDraw.resize(1);
         }},
    };
    for (const auto& [what, change] : k_Changes)
    {
        Settle();
        const std::uint64_t structure = Compile(Record())->structure;
        FrameCommands commands = Record();
        change(commands);
        EXPECT_NE(Compile(commands)->structure, structure) << what;
    }
}

TEST_F(FramesOfOneStructure, AreNoneWithOtherOutputsOrOptions)
{
    Settle();
    const std::uint64_t first = Compile(Record())->structure;
    m_Outputs.push_back(m_Mask);
    const std::uint64_t second = Compile(Record())->structure;
    EXPECT_NE(second, first);
    m_Outputs.pop_back();
    Settle();
    const std::uint64_t third = Compile(Record())->structure;
    m_Options.limitsRegions = false;
    EXPECT_NE(Compile(Record())->structure, third);
}

TEST_F(FramesOfOneStructure, AreNoneWhereTexturesAreLeftOtherwise)
{
    Settle();
    const std::uint64_t structure = Compile(Record())->structure;
    m_States.textures[m_Camera->id()].usage = TextureUsage::ShaderRead;
    const auto frame = Compile(Record());
    EXPECT_NE(frame->structure, structure);
    EXPECT_EQ(frame->passes.back().barriers.at(1).before, TextureUsage::ShaderRead);
}

TEST_F(FramesOfOneStructure, AreNoneWhereATextureOfEarlierFramesIsGone)
{
    {
        FrameBuilder frame;
        const RenderTexturePtr dying = test::Target("Dying");
        frame.Bind(dying).Clear(ClearFlag::Color).Draw(1);
        Compile(frame.Take());
        Settle();
        ASSERT_EQ(m_States.textures.size(), 3u);
    }
    EXPECT_EQ(Compile(Record())->states.textures.size(), 2u);
}

} // namespace
} // namespace limn
