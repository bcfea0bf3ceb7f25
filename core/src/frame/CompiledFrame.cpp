#include <limn/core/CompiledFrame.h>

#include <algorithm>
#include <array>
#include <limn/core/FrameCommands.h>
#include <memory_resource>

namespace limn
{

namespace
{

/// Calls `visit` with the pass's name and those of its samples, each once.
template <typename Visit>
void ForEachSample(const CompiledRenderPass& pass, const Visit& visit)
{
    std::array<std::byte, 256> buffer;
    std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
    std::pmr::vector<SampleName> known(&memory);
    if (!pass.name.empty())
    {
        visit(pass.name);
    }
    for (const PassCommand& command : pass.commands)
    {
        const auto* sample = std::get_if<BeginSampleCommand>(&command);
        if (sample != nullptr && sample->name != SampleName() && sample->name != pass.name &&
            std::ranges::find(known, sample->name) == known.end())
        {
            known.push_back(sample->name);
            visit(sample->name.name());
        }
    }
}

} // namespace

std::vector<std::string> CompiledRenderPass::SampleNames() const
{
    std::vector<std::string> names;
    ForEachSample(*this, [&](const std::string& sample) { names.push_back(sample); });
    return names;
}

void CompiledRenderPass::WriteTitle(std::string& title) const
{
    title.clear();
    ForEachSample(*this,
                  [&](const std::string& sample)
                  {
                      title += title.empty() ? "" : " + ";
                      title += sample;
                  });
}

std::string CompiledRenderPass::Title() const
{
    std::string title;
    WriteTitle(title);
    return title;
}

const std::shared_ptr<const Mesh>& FrameTables::MeshOf(const DrawCommand& draw) const
{
    static const std::shared_ptr<const Mesh> none;
    return draw.mesh == DrawCommand::k_NoMesh ? none : meshes[draw.mesh];
}

PerDrawData FrameTables::PerDraw(const DrawCommand& draw, std::uint32_t instance) const
{
    const std::uint32_t element = Element(draw.firstInstance + instance);
    return draw.drawsObjects ? objects->Get(element) : perDraw.at(element);
}

} // namespace limn
