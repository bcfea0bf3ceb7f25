#include "port/Differs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<const Material> AnyMaterial()
{
    return std::make_shared<const Material>(DiffersShader());
}

void ExpectCopiesWholeTexturesOfOneKind()
{
    const auto target = [](int width, GraphicsFormat format, int depthBits = 0, int samples = 1)
    {
        RenderTextureDescriptor descriptor(width, 4, format, depthBits);
        descriptor.msaaSamples = samples;
        return RTHandles::Alloc(descriptor);
    };
    constexpr GraphicsFormat format = GraphicsFormat::R8G8B8A8_UNorm;
    const RTHandle source = target(8, format);
    const auto copy = [&](const RTHandle& from, const RTHandle& to)
    {
        return [=](CommandBuffer& cmd)
        {
            cmd.CopyTexture(from.nameID(), to.nameID());
        };
    };
    EXPECT_EQ(RecordedFrame(copy(source, target(8, format))).draws().size(), 1u);
    const RTHandle others[] = {target(4, format), target(8, GraphicsFormat::R8_UNorm),
                               target(8, GraphicsFormat::None, 32), target(8, format, 0, 4)};
    for (const RTHandle& other : others)
    {
        EXPECT_THROW(RecordedFrame(copy(source, other)), ContractError);
    }
}

void ExpectTheBufferGoesBackByItself()
{
    const CommandBuffer* first = nullptr;
    {
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        first = cmd.get();
    }
    EXPECT_EQ(CommandBufferPool::Get().get(), first);
}

void ExpectInstancesWithoutEnableInstancing()
{
    const auto material = AnyMaterial();
    ASSERT_FALSE(material->enableInstancing);
    const auto mesh = CreatePrimitive(PrimitiveType::Quad);
    const std::vector<glm::mat4> matrices(3, glm::mat4(1.0f));
    const auto instances = [&](const MaterialPropertyBlock& properties)
    {
        std::vector<std::uint32_t> counts;
        const RecordedFrame frame(
            [&](CommandBuffer& cmd)
            {
                cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
                cmd.DrawMeshInstanced(mesh, 0, material, 0, matrices, properties);
                cmd.DrawMeshInstanced(mesh, 0, material, 0, matrices, properties);
            });
        std::uint32_t all = 0;
        for (const DrawCommand& draw : frame.draws())
        {
            counts.push_back(draw.instanceCount);
            all += draw.instanceCount;
        }
        EXPECT_EQ(all, 6u);
        return counts;
    };
    MaterialPropertyBlock properties;
    properties.SetFloat("_Width", 3.0f);
    EXPECT_LT(instances({}).size(), instances(properties).size()) << "separate draws";
}

void ExpectTheObjectAsItWasWhenRecorded()
{
    GameObject object;
    const auto mesh = CreatePrimitive(PrimitiveType::Quad);
    object.renderer = MeshRenderer{mesh, {AnyMaterial()}};
    const RecordedFrame frame(
        [&](CommandBuffer& cmd)
        {
            cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
            cmd.DrawRenderer(object, AnyMaterial(), 0, 0);
        },
        [&] { object.renderer->mesh = CreatePrimitive(PrimitiveType::Cube); });
    ASSERT_EQ(frame.draws().size(), 1u);
    EXPECT_EQ(frame.commands.MeshOf(frame.draws()[0]), mesh);
}

void ExpectRectanglesInTexelsFromTheTop()
{
    const RecordedFrame frame(
        [](CommandBuffer& cmd)
        {
            cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
            cmd.SetViewport({1, 0, 4, 2});
            cmd.EnableScissorRect({2, 0, 3, 1});
            cmd.ClearRenderTarget(false, true, Color::black);
            cmd.DrawProcedural(glm::mat4(1.0f), AnyMaterial(), 0, 3);
        });
    ASSERT_EQ(frame.Of<SetViewportCommand>().size(), 1u);
    EXPECT_EQ(frame.Of<SetViewportCommand>()[0].rect, (ViewportRect{1, 0, 4, 2}));
    ASSERT_EQ(frame.draws().size(), 1u);
    EXPECT_EQ(frame.draws()[0].scissor, (ViewportRect{2, 0, 3, 1}));
    EXPECT_EQ(frame.Of<ClearCommand>().size(), 1u) << "which knows of no scissor";
}

void ExpectASentenceForANameThatIsNone()
{
    const RecordedFrame frame([](CommandBuffer& cmd)
                              { cmd.ReleaseTemporaryRT(ShaderPropertyId("_NoSuchTexture")); });
    EXPECT_THAT(frame.report.notes, Contains(HasSubstr("_NoSuchTexture")));
}

void ExpectASentenceForABufferThatIsInUse()
{
    using Target = GraphicsBuffer::Target;
    const auto from =
        std::make_shared<GraphicsBuffer>(Target::Structured | Target::CopySource, 4, 4);
    const auto to =
        std::make_shared<GraphicsBuffer>(Target::Structured | Target::CopyDestination, 4, 4);
    const std::vector<std::uint32_t> data(4);
    EXPECT_NO_THROW(RecordedFrame([&](CommandBuffer& cmd) { cmd.SetBufferData(from, data); }));
    try
    {
        const RecordedFrame frame(
            [&](CommandBuffer& cmd)
            {
                cmd.CopyBuffer(from, to);
                cmd.SetBufferData(from, data);
            });
        ADD_FAILURE() << "nothing is thrown";
    }
    catch (const ContractError& error)
    {
        EXPECT_THAT(error.what(), HasSubstr("this frame uses"));
    }
}

void ExpectTheCamerasColourAndDepth()
{
    const RecordedFrame frame(
        [](CommandBuffer& cmd)
        {
            cmd.SetRenderTarget(BuiltinRenderTextureType::CameraTarget);
            cmd.DrawProcedural(glm::mat4(1.0f), AnyMaterial(), 0, 3);
        });
    const auto targets = frame.Of<SetRenderTargetCommand>();
    ASSERT_EQ(targets.size(), 1u);
    EXPECT_THAT(targets[0].colors, ElementsAre(frame.color.rt()));
    EXPECT_EQ(targets[0].depth, frame.depth.rt());
}

} // namespace

DiffersChecks CommandDiffers()
{
    return {{{"CommandBuffer.CopyTexture"}, ExpectCopiesWholeTexturesOfOneKind},
            {Members("CommandBuffer", {"Dispose", "Release"}), ExpectTheBufferGoesBackByItself},
            {{"CommandBuffer.DrawMeshInstanced"}, ExpectInstancesWithoutEnableInstancing},
            {{"CommandBuffer.DrawRenderer"}, ExpectTheObjectAsItWasWhenRecorded},
            {Members("CommandBuffer", {"SetViewport", "EnableScissorRect"}),
             ExpectRectanglesInTexelsFromTheTop},
            {{"CommandBuffer.ReleaseTemporaryRT"}, ExpectASentenceForANameThatIsNone},
            {{"CommandBuffer.SetBufferData"}, ExpectASentenceForABufferThatIsInUse},
            {{"BuiltinRenderTextureType.CameraTarget"}, ExpectTheCamerasColourAndDepth}};
}

} // namespace limn::test
