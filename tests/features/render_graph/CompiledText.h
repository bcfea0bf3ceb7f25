#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <set>
#include <string>
#include <vector>

namespace limn::test
{

/// What a compiled pass is, but for names of passes and which texture objects they are.
inline std::string DescribeCompiled(const CompiledRenderPass& pass)
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

inline std::vector<std::string> PassesOf(const RenderResult& result)
{
    std::vector<std::string> passes;
    for (const CompiledRenderPass& pass : result.frame->passes)
    {
        passes.push_back(DescribeCompiled(pass));
    }
    return passes;
}

/// That the device makes an image for.
inline std::size_t TextureCount(const RenderResult& result)
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

} // namespace limn::test
