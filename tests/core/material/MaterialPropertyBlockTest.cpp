#include <gtest/gtest.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <map>
#include <random>

namespace limn
{
namespace
{

TEST(MaterialPropertyBlock, HoldsTheLastValueOfEachNameThatIsNotRemoved)
{
    std::mt19937 random(1);
    std::vector<ShaderPropertyId> ids;
    for (int i = 0; i < 12; ++i)
    {
        ids.emplace_back("HoldsTheLastValue" + std::to_string(i));
    }
    MaterialPropertyBlock block;
    std::map<ShaderPropertyId, float> expected;
    for (int step = 0; step < 5000; ++step)
    {
        const ShaderPropertyId id = ids[random() % ids.size()];
        const auto value = static_cast<float>(step);
        if (const auto kind = random() % 100; kind == 0)
        {
            block.Clear();
            expected.clear();
        }
        else if (kind < 5)
        {
            MaterialPropertyBlock other;
            other.SetFloat(id, value);
            other.SetFloat(ids.front(), value + 0.5f);
            block.SetAll(other);
            expected[id] = value;
            expected[ids.front()] = value + 0.5f;
        }
        else if (kind < 50)
        {
            block.Remove(id);
            expected.erase(id);
        }
        else
        {
            block.SetFloat(id, value);
            expected[id] = value;
        }
        ASSERT_EQ(block.isEmpty(), expected.empty());
        for (const ShaderPropertyId each : ids)
        {
            const ShaderPropertyValue* found = block.Find(each);
            ASSERT_EQ(found != nullptr, expected.contains(each)) << "step " << step;
            ASSERT_TRUE(found == nullptr || std::get<float>(*found) == expected[each]);
        }
    }
}

} // namespace
} // namespace limn
