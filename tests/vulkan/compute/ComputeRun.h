#pragma once

#include "vulkan/GpuTestDevice.h"
#include "vulkan/GpuTestFrame.h"

#include <functional>
#include <limn/core/CommandBuffer.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/FrameCompiler.h>
#include <limn/core/ScriptableRenderContext.h>
#include <string>
#include <vector>

namespace limn::test
{

inline const std::shared_ptr<ShaderCompiler>& ComputeCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return compiler;
}

inline std::shared_ptr<ComputeShader> MakeCompute(const std::string& text)
{
    return ComputeShader::FromText(text, "Test.compute", ComputeCompiler());
}

/// A kernel K of `threads`, "8, 8, 1", whose body is `body`; `id` is SV_DispatchThreadID.
inline std::shared_ptr<ComputeShader>
MakeKernel(const std::string& threads, const std::string& declarations, const std::string& body)
{
    return MakeCompute("#pragma kernel K\n" + declarations + "\n[numthreads(" + threads +
                       ")]\nvoid K(uint3 id : SV_DispatchThreadID, uint3 local : "
                       "SV_GroupThreadID, uint3 group : SV_GroupID, uint index : SV_GroupIndex)\n"
                       "{\n" +
                       body + "\n}\n");
}

/// Compiles what the buffer holds into a frame, and runs it on the device that all tests share.
inline CompiledFrame RunCommands(const CommandBuffer& cmd,
                                 const std::vector<TargetPtr>& outputs = {})
{
    RenderReport report;
    ScriptableRenderContext context(report);
    context.ExecuteCommandBuffer(cmd);
    CompiledFrame frame =
        CompileFrame(context.TakeCommands(), SharedDevice().textureStates(), outputs);
    SharedDevice().Execute(frame);
    return frame;
}

template <typename Element>
std::shared_ptr<GraphicsBuffer>
MakeBuffer(const std::vector<Element>& data,
           GraphicsBuffer::Target target = GraphicsBuffer::Target::Structured)
{
    const bool isRaw = target == GraphicsBuffer::Target::Raw;
    const auto stride = static_cast<int>(isRaw ? 4 : sizeof(Element));
    const auto count = static_cast<int>(data.size() * sizeof(Element)) / stride;
    auto buffer = std::make_shared<GraphicsBuffer>(target, count, stride);
    buffer->SetData(data);
    return buffer;
}

/// All of what the device has in the buffer.
template <typename Element>
std::vector<Element> DataOf(const GraphicsBuffer& buffer)
{
    std::vector<Element> data(buffer.size() / sizeof(Element));
    buffer.GetData(SharedDevice(), data);
    return data;
}

inline TargetPtr MakeWritable(int width, int height,
                              GraphicsFormat format = GraphicsFormat::R32G32B32A32_SFloat,
                              const std::string& name = "writable")
{
    RenderTextureDescriptor descriptor(width, height, format);
    descriptor.enableRandomWrite = true;
    return std::make_shared<RenderTexture>(name, descriptor);
}

/// What commands draw into a cleared target whose red they add 0.2 to: of each row a text, how
/// often each texel was drawn, "." for not at all.
inline std::vector<std::string> CountDrawn(int width, int height,
                                           const std::function<void(CommandBuffer&)>& record)
{
    const RTHandle target(MakeTarget(width, height));
    CommandBuffer cmd;
    cmd.SetRenderTarget(target);
    cmd.ClearRenderTarget(ClearFlag::Color, Color::clear);
    record(cmd);
    RunCommands(cmd, {std::const_pointer_cast<RenderTexture>(target.rt())});
    const Image image = ReadRows(*target.rt());
    std::vector<std::string> rows;
    for (int y = 0; y < height; ++y)
    {
        std::string& row = rows.emplace_back();
        for (int x = 0; x < width; ++x)
        {
            const int times = Texel8(image, x, y)[0] / 51; // 51 = 0.2
            row += times == 0 ? "." : std::to_string(times);
        }
    }
    return rows;
}

} // namespace limn::test
