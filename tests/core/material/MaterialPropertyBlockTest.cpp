#include <gtest/gtest.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <malloc.h>
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
    for (int i = 0; i < 120; ++i)
    {
        ids.emplace_back("HoldsTheLastValue" + std::to_string(i));
    }
    MaterialPropertyBlock block;
    std::map<ShaderPropertyId, float> expected;
    for (int step = 0; step < 5000; ++step)
    {
        const ShaderPropertyId id = ids[random() % ids.size()];
        const auto value = static_cast<float>(step);
        if (const auto kind = random() % 1000; kind == 0)
        {
            block.Clear();
            expected.clear();
        }
        else if (kind < 20)
        {
            MaterialPropertyBlock other;
            other.SetFloat(id, value);
            other.SetFloat(ids.front(), value + 0.5f);
            block.SetAll(other);
            expected[id] = value;
            expected[ids.front()] = value + 0.5f;
        }
        else if (kind < 400)
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

TEST(MaterialPropertyBlock, TakesMemoryForItsValuesWhateverTheNumbersOfTheirNames)
{
    for (int i = 0; i < 20'000; ++i)
    {
        ShaderPropertyId("TakesMemory" + std::to_string(i)); // interned for good
    }
    const auto allocated = []
    {
        const struct mallinfo2 info = mallinfo2();
        return info.uordblks + info.hblkhd;
    };
    const std::size_t before = allocated();
    std::vector<MaterialPropertyBlock> blocks(100);
    for (MaterialPropertyBlock& block : blocks)
    {
        for (int i = 0; i < 20; ++i)
        {
            block.SetFloat(ShaderPropertyId("TakesMemory" + std::to_string(19'999 - i)), 1.0f);
        }
    }
    EXPECT_LT(allocated() - before, 100 * 20 * 400u);
}

TEST(MaterialPropertyBlock, GivesWhatWasSetAndElseNothing)
{
    const ShaderPropertyId id{"GivesWhatWasSet"};
    MaterialPropertyBlock block;
    EXPECT_FALSE(block.HasProperty(id));
    EXPECT_EQ(block.GetFloat(id), 0.0f);
    EXPECT_EQ(block.GetColor(id), Color::clear);
    EXPECT_EQ(block.GetMatrix(id), glm::mat4(0.0f));
    EXPECT_EQ(block.GetTexture(id), nullptr);
    EXPECT_TRUE(block.GetFloatArray(id).empty());
    block.SetFloat(id, 2.75f);
    EXPECT_EQ(block.GetFloat(id), 2.75f);
    EXPECT_EQ(block.GetInt(id), 2);
    EXPECT_TRUE(block.HasFloat(id));
    EXPECT_FALSE(block.HasInt(id));
    EXPECT_EQ(block.GetVector(id), glm::vec4(0.0f)) << "of another kind";
    block.SetFloat(id, 1e20f);
    EXPECT_EQ(block.GetInt(id), std::numeric_limits<int>::max()) << "as Material::GetInt";
    block.SetInteger(id, -3);
    EXPECT_EQ(block.GetInteger(id), -3);
    EXPECT_EQ(block.GetFloat(id), -3.0f);
    block.SetVector(id, {1, 2, 3, 4});
    EXPECT_EQ(block.GetVector(id), glm::vec4(1, 2, 3, 4));
    EXPECT_TRUE(block.HasVector(id));
    EXPECT_FALSE(block.HasColor(id));
    block.SetColor(id, {0.5f, 1.0f, 0.0f, 0.25f});
    EXPECT_EQ(block.GetColor(id), Color(0.5f, 1.0f, 0.0f, 0.25f));
    EXPECT_NEAR(block.GetVector(id).x, 0.21404114, 1e-6) << "((0.5 + 0.055) / 1.055)^2.4";
    EXPECT_EQ(block.GetVector(id).w, 0.25f);
    block.SetVectorArray(id, {glm::vec4(1), glm::vec4(2)});
    EXPECT_EQ(block.GetVectorArray(id), (std::vector<glm::vec4>{glm::vec4(1), glm::vec4(2)}));
}

TEST(MaterialPropertyBlock, MakesAFloatOfAWholeNumber)
{
    const ShaderPropertyId id("_Get");
    MaterialPropertyBlock block;
    const int width = 6;
    block.SetFloat(id, width);
    EXPECT_TRUE(block.HasFloat(id)) << "as in C#, where an int is a float's argument";
    EXPECT_EQ(block.GetFloat(id), 6.0f);
    static_assert(requires { block.SetFloat(id, 3u); });
}

} // namespace
} // namespace limn
