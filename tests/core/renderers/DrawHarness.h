#pragma once

#include <cstring>
#include <gtest/gtest.h>
#include <limn/core/ScriptableRenderContext.h>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/TestScene.h"

namespace limn::test
{

/// A draw with what it refers to.
struct SeenDraw : DrawCommand, DrawSetup
{
    SeenDraw(const DrawCommand& draw, const FrameTables& frame)
        : DrawCommand(draw), DrawSetup(frame.Setup(draw)), mesh(frame.MeshOf(draw))
    {
    }

    std::shared_ptr<const Mesh> mesh;
};

/// The draws among a frame's commands, in order.
inline std::vector<SeenDraw> DrawsOf(const FrameCommands& frame)
{
    std::vector<SeenDraw> draws;
    for (const FrameCommand& command : frame.commands)
    {
        if (const auto* draw = std::get_if<DrawCommand>(&command))
        {
            draws.emplace_back(*draw, frame);
        }
    }
    return draws;
}

/// A member of a draw's uniform buffers by its HLSL name; fails the test if there is none.
/// @return  the value and where it comes from: its layout and its first byte
struct UniformBytes
{
    UniformMember member;
    const std::byte* bytes = nullptr;
};
inline UniformBytes FindUniform(const FrameCommands& frame, const SeenDraw& draw,
                                const std::string& name)
{
    for (const UniformBuffer& buffer : draw.program->layout.buffers)
    {
        for (const UniformMember& member : buffer.members)
        {
            if (member.name != name)
            {
                continue;
            }
            for (const UniformSlice& slice : draw.bindings->uniforms)
            {
                if (slice.binding == buffer.binding)
                {
                    return {member, frame.uniformData.data() + slice.offset + member.offset};
                }
            }
        }
    }
    ADD_FAILURE() << "no uniform '" << name << "' is bound";
    return {};
}

/// `count` consecutive floats or ints of a uniform, `offset` bytes behind its beginning.
template <typename T>
std::vector<T> ReadUniform(const FrameCommands& frame, const SeenDraw& draw,
                           const std::string& name, std::size_t count, std::size_t offset = 0)
{
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(count);
    const UniformBytes uniform = FindUniform(frame, draw, name);
    if (uniform.bytes != nullptr)
    {
        std::memcpy(values.data(), uniform.bytes + offset, count * sizeof(T));
    }
    return values;
}

/// Resolves one triangle drawn with a material, and shows what it binds. Each is a frame of one
/// context, which keeps what it may.
class OneDraw
{
public:
    MaterialPropertyBlock block;
    CommandBuffer before; ///< executed first, for globals
    RenderReport report;  ///< of the last Resolve

    /// Resolves; the results of earlier calls are gone.
    void Resolve(const std::shared_ptr<const Material>& material)
    {
        report = {};
        m_Context.Begin(report, glm::dvec3(0.0));
        m_Context.ExecuteCommandBuffer(before);
        CommandBuffer cmd;
        cmd.DrawProcedural(glm::mat4(1.0f), material, 0, 3, block);
        m_Context.ExecuteCommandBuffer(cmd);
        m_Frame = m_Context.TakeCommands();
    }

    SeenDraw draw() const { return DrawsOf(m_Frame).at(0); }
    const FrameCommands& frame() const { return m_Frame; }

    std::vector<float> Floats(const std::string& name, std::size_t count,
                              std::size_t offset = 0) const
    {
        return ReadUniform<float>(m_Frame, draw(), name, count, offset);
    }
    std::vector<std::int32_t> Ints(const std::string& name, std::size_t count) const
    {
        return ReadUniform<std::int32_t>(m_Frame, draw(), name, count);
    }

    /// The texture bound under an HLSL name; null and a failed test if there is none.
    std::shared_ptr<const Texture> TextureNamed(const std::string& name) const
    {
        for (const TextureBinding& binding : draw().program->layout.textures)
        {
            for (const TextureSlot& slot : draw().bindings->textures)
            {
                if (binding.name == name && slot.binding == binding.binding)
                {
                    return slot.texture;
                }
            }
        }
        ADD_FAILURE() << "no texture '" << name << "' is bound";
        return nullptr;
    }

    /// The state of the sampler of an HLSL name.
    SamplerState SamplerNamed(const std::string& name) const
    {
        for (const SamplerBinding& binding : draw().program->layout.samplers)
        {
            for (const SamplerSlot& slot : draw().bindings->samplers)
            {
                if (binding.name == name && slot.binding == binding.binding)
                {
                    return slot.state;
                }
            }
        }
        ADD_FAILURE() << "no sampler '" << name << "' is bound";
        return {};
    }

private:
    ScriptableRenderContext m_Context;
    FrameCommands m_Frame;
};

} // namespace limn::test
