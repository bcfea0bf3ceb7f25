#include <gtest/gtest.h>
#include <limn/core/Mesh.h>

namespace limn::test
{

TEST(VertexAttributes, NameEveryArrayOfAMeshOnce)
{
    MeshData data;
    data.vertices = {{1, 2, 3}};
    data.normals = {{4, 5, 6}, {7, 8, 9}};
    data.tangents = {{10, 11, 12, 13}};
    data.colors = {{14, 15, 16, 17}};
    data.uv = {{18, 19}};
    data.uv2 = {{20, 21, 22, 23}};
    data.uv3 = {{24, 25, 26, 27}};
    data.uv4 = {{28, 29, 30, 31}};
    data.uv5 = {{32, 33, 34, 35}};
    data.uv6 = {{36, 37, 38, 39}};
    data.uv7 = {{40, 41, 42, 43}};
    data.uv8 = {{44, 45, 46}};
    std::vector<float> all;
    for (const VertexAttribute& attribute : VertexAttributes())
    {
        const std::span<const float> values = attribute.values(data);
        EXPECT_EQ(0u, values.size() % attribute.components) << attribute.array;
        all.insert(all.end(), values.begin(), values.end());
    }
    std::vector<float> expected;
    for (int i = 1; i <= 46; ++i)
    {
        expected.push_back(static_cast<float>(i));
    }
    EXPECT_EQ(expected, all);
    EXPECT_TRUE(VertexAttributes()[4].values(MeshData()).empty());
}

} // namespace limn::test
