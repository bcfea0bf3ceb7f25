#pragma once

#include <array>
#include <cstring>
#include <limn/core/CompiledFrame.h>
#include <limn/core/Image.h>
#include <limn/core/Mesh.h>
#include <limn/shaderlab/ShaderCompiler.h>

namespace limn::test
{

using TargetPtr = std::shared_ptr<const RenderTexture>;
using PassPtr = std::shared_ptr<const ShaderProgram>;
using MeshPtr = std::shared_ptr<const Mesh>;

/// Compiles HLSL with the functions `vert` and `frag`.
inline PassPtr CompilePass(const std::string& hlsl, ShaderCompiler& compiler)
{
    PassProgram program;
    program.file = "test.shader";
    program.chunks = {{hlsl, 1}};
    program.vertex.name = "vert";
    program.fragment.name = "frag";
    return compiler.Compile(program);
}
/// The same with a compiler that ends with the call, so that nothing but the caller keeps the
/// result.
inline PassPtr CompilePass(const std::string& hlsl)
{
    ShaderCompiler compiler;
    return CompilePass(hlsl, compiler);
}

inline TargetPtr MakeTarget(int width, int height,
                            GraphicsFormat format = GraphicsFormat::R8G8B8A8_UNorm,
                            const std::string& name = "target")
{
    return std::make_shared<RenderTexture>(name, RenderTextureDescriptor(width, height, format));
}

/// A depth target, with a stencil where asked for.
inline TargetPtr MakeDepth(int width, int height, bool stencil = false)
{
    return std::make_shared<RenderTexture>(
        "depth", RenderTextureDescriptor(width, height,
                                         stencil ? GraphicsFormat::D32_SFloat_S8_UInt
                                                 : GraphicsFormat::D32_SFloat));
}

/// A pass that clears one colour target, barrier and resolve included.
inline CompiledRenderPass ClearPass(const TargetPtr& target, Color color = {})
{
    CompiledRenderPass pass;
    pass.name = "test pass";
    pass.width = target->width();
    pass.height = target->height();
    pass.barriers.push_back({target, TextureUsage::Undefined, TextureUsage::ColorAttachment});
    pass.colors.push_back({target, LoadOp::Clear, StoreOp::Store, color,
                           target->descriptor().msaaSamples > 1 ? target : nullptr});
    return pass;
}

/// Adds a depth target that is cleared to far and stencil 0.
inline void AddDepth(CompiledRenderPass& pass, const TargetPtr& depth)
{
    pass.barriers.push_back({depth, TextureUsage::Undefined, TextureUsage::DepthStencilAttachment});
    DepthAttachment attachment;
    attachment.texture = depth;
    attachment.load = LoadOp::Clear;
    attachment.stencilLoad = LoadOp::Clear;
    pass.depth = attachment;
}

/// Ends the frame with `target` ready to be read back.
inline CompiledFrame FrameOf(std::vector<CompiledRenderPass> passes, const TargetPtr& target)
{
    CompiledFrame frame;
    frame.passes = std::move(passes);
    const TextureUsage last = IsDepthFormat(target->graphicsFormat())
                                  ? TextureUsage::DepthStencilAttachment
                                  : TextureUsage::ColorAttachment;
    frame.finalBarriers.push_back({target, last, TextureUsage::CopySource});
    return frame;
}

/// Draws whatever faces whichever way, over everything.
inline PipelineState PlainState()
{
    PipelineState state;
    state.cull = CullMode::Off;
    state.zTest = CompareFunction::Always;
    state.zWrite = false;
    return state;
}

/// One uniform buffer's bytes, appended to the frame's.
template <typename T>
UniformSlice AddUniform(CompiledFrame& frame, std::uint32_t binding, const T& value)
{
    const std::size_t offset = (frame.uniformData.size() + 255) / 256 * 256;
    frame.uniformData.resize(offset + sizeof(T));
    std::memcpy(frame.uniformData.data() + offset, &value, sizeof(T));
    return {binding, static_cast<std::uint32_t>(offset), sizeof(T)};
}

/// A draw of the frame that is yet to be put into one of its passes.
inline DrawCommand MakeDraw(FrameTables& frame, PassPtr pass, MeshPtr mesh,
                            PipelineState state = PlainState(), DrawBindings bindings = {})
{
    DrawCommand draw;
    draw.setup = static_cast<std::uint32_t>(frame.setups.size());
    DrawSetup& setup = frame.setups.emplace_back();
    setup.program = std::move(pass);
    setup.bindings = std::make_shared<DrawBindings>(std::move(bindings));
    setup.state = state;
    if (mesh)
    {
        draw.mesh = static_cast<std::uint32_t>(frame.meshes.size());
        frame.meshes.push_back(std::move(mesh));
    }
    return draw;
}

/// The same draw in another state.
inline DrawCommand WithState(FrameTables& frame, DrawCommand draw, const PipelineState& state)
{
    frame.setups.push_back(frame.Setup(draw));
    frame.setups.back().state = state;
    draw.setup = static_cast<std::uint32_t>(frame.setups.size() - 1);
    return draw;
}

/// A quad over [left, right] x [bottom, top] of clip space at depth z, clockwise on screen.
inline MeshPtr MakeQuad(float left = -1.0f, float bottom = -1.0f, float right = 1.0f,
                        float top = 1.0f, float z = 0.5f)
{
    MeshData data;
    data.vertices = {{left, bottom, z}, {left, top, z}, {right, top, z}, {right, bottom, z}};
    data.triangles = {0, 1, 2, 0, 2, 3};
    return std::make_shared<Mesh>("quad", std::move(data));
}

using Rgba8 = std::array<int, 4>;

inline constexpr Rgba8 k_Red = {255, 0, 0, 255};
inline constexpr Rgba8 k_Green = {0, 255, 0, 255};

inline std::vector<std::byte> Bytes(std::initializer_list<int> values)
{
    std::vector<std::byte> bytes;
    for (const int value : values)
    {
        bytes.push_back(static_cast<std::byte>(value));
    }
    return bytes;
}

inline Rgba8 Texel8(const Image& image, int x, int y)
{
    const auto index = static_cast<std::size_t>(y * image.width + x) * 4;
    Rgba8 result{};
    for (std::size_t i = 0; i < 4; ++i)
    {
        result[i] = std::to_integer<int>(image.texels.at(index + i));
    }
    return result;
}

/// A texel of a format made of 32-bit floats.
template <std::size_t Channels = 4>
std::array<float, Channels> TexelFloat(const Image& image, int x, int y)
{
    std::array<float, Channels> result{};
    const auto index = static_cast<std::size_t>(y * image.width + x) * sizeof(result);
    std::memcpy(result.data(), &image.texels.at(index), sizeof(result));
    return result;
}

/// Vertices in clip space as the mesh has them; every texel `_Color`.
inline PassPtr ColorPass()
{
    static const PassPtr pass = CompilePass(R"(
        cbuffer Material { float4 _Color; };
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag() : SV_Target { return _Color; })");
    return pass;
}

/// A draw of ColorPass.
inline DrawCommand MakeColorDraw(CompiledFrame& frame, const MeshPtr& mesh, Color color,
                                 PipelineState state = PlainState())
{
    DrawBindings bindings;
    const std::uint32_t binding = ColorPass()->layout.buffers.at(0).binding;
    bindings.uniforms.push_back(AddUniform(frame, binding, color.vector()));
    return MakeDraw(frame, ColorPass(), mesh, state, std::move(bindings));
}

} // namespace limn::test
