#include <limn/core/FrameCommands.h>

namespace limn
{

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
