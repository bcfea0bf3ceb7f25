#include <gtest/gtest.h>
#include <limn/core/VertexAttribute.h>

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
    data.uv8 = {{20, 21, 22}};
    std::vector<float> all;
    for (const VertexAttribute& attribute : VertexAttributes())
    {
        const std::span<const float> values = attribute.values(data);
        EXPECT_EQ(0u, values.size() % attribute.components) << attribute.array;
        all.insert(all.end(), values.begin(), values.end());
    }
    std::vector<float> expected;
    for (int i = 1; i <= 22; ++i)
    {
        expected.push_back(static_cast<float>(i));
    }
    EXPECT_EQ(expected, all);
    EXPECT_TRUE(VertexAttributes()[4].values(MeshData()).empty());
}

} // namespace limn::test
