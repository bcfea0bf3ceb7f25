#include "scene/TestScene.h"

#include <gtest/gtest.h>
#include <limn/core/Scene.h>
#include <random>

namespace limn
{
namespace
{

using Materials = std::vector<std::shared_ptr<const Material>>;

Materials ElementsOf(const MaterialList& list)
{
    return {list.begin(), list.end()};
}

TEST(MaterialList, IsAVector)
{
    std::mt19937 random(1);
    Materials some{nullptr};
    for (int i = 0; i < 4; ++i)
    {
        some.push_back(std::make_shared<Material>(test::ShaderWithModes({"A"})));
    }
    const auto any = [&]
    {
        return some[random() % some.size()];
    };
    {
        MaterialList lists[2];
        Materials vectors[2];
        for (int step = 0; step < 2000; ++step)
        {
            SCOPED_TRACE(step);
            const std::size_t i = random() % 2;
            const auto material = any();
            const std::size_t count = random() % 4;
            switch (random() % 8)
            {
            case 0:
                lists[i].push_back(material);
                vectors[i].push_back(material);
                break;
            case 1:
                lists[i].resize(count, material);
                vectors[i].resize(count, material);
                break;
            case 2:
                lists[i] = lists[1 - i];
                vectors[i] = vectors[1 - i];
                break;
            case 3:
                lists[i] = std::move(lists[1 - i]);
                vectors[i] = std::exchange(vectors[1 - i], {});
                break;
            case 4:
                lists[i] = {material, some[1]};
                vectors[i] = {material, some[1]};
                break;
            case 5:
                vectors[i].assign(count, material);
                lists[i] = vectors[i];
                break;
            case 6:
                lists[i].clear();
                vectors[i].clear();
                break;
            default:
                if (!vectors[i].empty())
                {
                    lists[i].back() = material;
                    vectors[i].back() = material;
                }
                break;
            }
            ASSERT_EQ(ElementsOf(lists[0]), vectors[0]);
            ASSERT_EQ(ElementsOf(lists[1]), vectors[1]);
            ASSERT_EQ(lists[0].size(), vectors[0].size());
            ASSERT_EQ(lists[0] == lists[1], vectors[0] == vectors[1]);
        }
    }
    for (std::size_t i = 1; i < some.size(); ++i)
    {
        EXPECT_EQ(some[i].use_count(), 1);
    }
}

TEST(MaterialList, SaysWhichMaterialThereIsNot)
{
    MaterialList list{nullptr};
    EXPECT_EQ(list.at(0), nullptr);
    EXPECT_THROW(list.at(1), std::out_of_range);
}

} // namespace
} // namespace limn
