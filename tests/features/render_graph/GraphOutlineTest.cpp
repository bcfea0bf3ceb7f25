#include "features/render_graph/GraphOutline.h"

#include <gmock/gmock.h>
#include <limn/core/RecordingDevice.h>
#include <set>

namespace limn::test
{
namespace
{

/// What a compiled pass is, but for names of passes and which texture objects they are.
std::string Describe(const CompiledRenderPass& pass)
{
    std::string text;
    for (const ColorAttachment& color : pass.colors)
    {
        const Color& clear = color.clearColor;
        text += color.texture->name() + " " + std::to_string(color.texture->width()) + "x" +
                std::to_string(color.texture->height()) + " " +
                ToString(color.texture->graphicsFormat()) + " load " +
                std::to_string(static_cast<int>(color.load)) + " store " +
                std::to_string(static_cast<int>(color.store));
        text += color.load == LoadOp::Clear
                    ? " to " + std::to_string(clear.r) + " " + std::to_string(clear.a)
                    : "";
    }
    text += pass.depth ? ", " + pass.depth->texture->name() : "";
    for (const PassCommand& command : pass.commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            text += ", " + std::to_string(draw->instanceCount) + " of mesh " +
                    std::to_string(draw->mesh);
            text += draw->scissor ? " in " + std::to_string(draw->scissor->x) + " " +
                                        std::to_string(draw->scissor->y) + " " +
                                        std::to_string(draw->scissor->width) + " " +
                                        std::to_string(draw->scissor->height)
                                  : "";
        }
    }
    return text;
}

std::vector<std::string> Passes(const RenderResult& result)
{
    std::vector<std::string> passes;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        passes.push_back(Describe(pass));
    }
    return passes;
}

/// That the device makes an image for.
std::size_t TextureCount(const RenderResult& result)
{
    std::set<std::uint64_t> textures;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        for (const ColorAttachment& color : pass.colors)
        {
            textures.insert(color.texture->id());
        }
        if (pass.depth)
        {
            textures.insert(pass.depth->texture->id());
        }
    }
    return textures.size();
}

} // namespace

TEST(GraphOutline, IsCompiledToTheSamePassesAsTheOldStyle)
{
    RecordingDevice oldDevice;
    RecordingDevice newDevice;
    OutlineOfStyle oldStyle(oldDevice, false);
    OutlineOfStyle newStyle(newDevice, true);
    for (int frame = 0; frame < 4; ++frame)
    {
        const RenderResult expected = oldStyle.Render();
        const RenderResult actual = newStyle.Render();
        EXPECT_THAT(Passes(actual), testing::ElementsAreArray(Passes(expected)))
            << "frame " << frame;
        EXPECT_EQ(Passes(actual).size(), 5u);
        EXPECT_EQ(TextureCount(actual), TextureCount(expected));
        EXPECT_THAT(actual.report.notes, testing::IsEmpty());
    }
}

TEST(GraphOutline, CostsNoPassAndNoTextureWhereNothingIsSelected)
{
    RecordingDevice device;
    OutlineOfStyle style(device, true);
    for (const auto& object : style.content.scene.objects())
    {
        object->renderer->renderingLayerMask = RenderingLayerMask::FromIndex(0);
    }
    for (int frame = 0; frame < 3; ++frame)
    {
        EXPECT_EQ(style.Render().frame->passes.size(), 1u) << "frame " << frame;
    }
}

} // namespace limn::test
