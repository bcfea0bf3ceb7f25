#include "record/Topology.h"

#include <limn/core/DrawError.h>

namespace limn
{

void ExpectTopology(MeshTopology drawn, GeometryInput taken, const Material& material)
{
    static constexpr const char* k_Taken[] = {nullptr,     "points",
                                              "lines",     "lines with neighbours",
                                              "triangles", "triangles with neighbours"};
    const bool isOfPoints = drawn == MeshTopology::Points;
    const bool isOfLines = drawn == MeshTopology::Lines || drawn == MeshTopology::LineStrip;
    const GeometryInput fitting = isOfPoints  ? GeometryInput::Point
                                  : isOfLines ? GeometryInput::Line
                                              : GeometryInput::Triangle;
    if (taken == GeometryInput::None || taken == fitting)
    {
        return;
    }
    throw DrawError("material '" + material.name() +
                    "': the geometry function of its shader takes " +
                    k_Taken[static_cast<std::size_t>(taken)] + ", but " +
                    (isOfPoints  ? "points are drawn"
                     : isOfLines ? "lines are drawn"
                                 : "triangles are drawn; write 'triangle' and an array of 3"));
}

std::shared_ptr<const Mesh> MakeQuads(std::uint32_t count)
{
    MeshData data;
    data.vertices.resize(std::size_t{count} * 4);
    data.triangles.reserve(std::size_t{count} * 6);
    for (std::uint32_t i = 0; i < count; ++i)
    {
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        {
            data.triangles.push_back(i * 4 + corner);
        }
    }
    return std::make_shared<const Mesh>("Quads", std::move(data));
}

} // namespace limn
