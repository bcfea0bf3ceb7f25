#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/FixedList.h>
#include <memory>
#include <vector>

namespace limn
{
namespace
{

using testing::ElementsAre;

TEST(FixedLists, HoldWhatTheyAreGivenInItsOrder)
{
    FixedList<int, 3> list{1, 2};
    EXPECT_THAT(list, ElementsAre(1, 2));
    list.push_back(3);
    EXPECT_THAT(list, ElementsAre(1, 2, 3));
    EXPECT_TRUE(list.full());
    const std::vector<int> others{7};
    list.assign(others.begin(), others.end());
    EXPECT_THAT(list, ElementsAre(7));
    EXPECT_EQ(list, (FixedList<int, 3>{7}));
    EXPECT_FALSE(list == (FixedList<int, 3>{7, 0}));
}

TEST(FixedLists, GrowByValuesAsNew)
{
    FixedList<int, 3> list{1, 2, 3};
    list.resize(1);
    list.resize(3);
    EXPECT_THAT(list, ElementsAre(1, 0, 0));
}

TEST(FixedLists, LetGoOfWhatTheyHoldNoMore)
{
    const auto value = std::make_shared<int>(1);
    FixedList<std::shared_ptr<int>, 2> list{value, value};
    list.resize(1);
    EXPECT_EQ(value.use_count(), 2);
    list.clear();
    EXPECT_EQ(value.use_count(), 1);
}

TEST(FixedLists, RefuseMoreThanTheyHaveRoomFor)
{
    FixedList<int, 2> list{1, 2};
    EXPECT_THROW(list.push_back(3), ContractError);
    EXPECT_THROW(list.resize(3), ContractError);
    EXPECT_THAT(list, ElementsAre(1, 2));
}

} // namespace
} // namespace limn
