#include <gtest/gtest.h>
#include <limn/core/Transform.h>
#include <vector>

namespace limn
{

TEST(Transform, HasAsManyParentsAsMemoryHolds)
{
    std::vector<Transform> chain(1000000);
    for (std::size_t i = 0; i < chain.size(); ++i)
    {
        chain[i].localPosition.x = i % 2 == 0 ? 1.0f : 0.0f;
        chain[i].parent = i > 0 ? &chain[i - 1] : nullptr;
    }
    EXPECT_EQ(chain.back().position(), glm::vec3(500000, 0, 0));
    EXPECT_EQ(chain.back().forward(), glm::vec3(0, 0, 1));
}

} // namespace limn
