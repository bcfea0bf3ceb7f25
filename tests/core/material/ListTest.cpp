#include <gtest/gtest.h>
#include <limn/core/List.h>
#include <span>

#include "ThrownMessage.h"

namespace limn
{
namespace
{

TEST(List, DoesWhatLinesOfCSharpAskOfIt)
{
    List<int> list = List<int>{3, 1};
    list.Add(4);
    list.AddRange(std::vector<int>{1, 5});
    EXPECT_EQ(list, (List<int>{3, 1, 4, 1, 5}));
    EXPECT_EQ(list.Count(), 5);
    EXPECT_EQ(list.IndexOf(1), 1);
    EXPECT_EQ(list.IndexOf(9), -1);
    EXPECT_TRUE(list.Contains(4));
    EXPECT_TRUE(list.Remove(1)) << "the first of two";
    EXPECT_FALSE(list.Remove(9));
    list.Insert(0, 7);
    list.Insert(list.Count(), 8);
    list.RemoveAt(2);
    EXPECT_EQ(list, (List<int>{7, 3, 1, 5, 8}));
    list.Clear();
    EXPECT_EQ(list.Count(), 0);
}

TEST(List, IsAVectorWhereOneIsTaken)
{
    const auto sum = [](std::span<const int> numbers)
    {
        int total = 0;
        for (const int number : numbers)
        {
            total += number;
        }
        return total;
    };
    const List<int> list = std::vector<int>{1, 2};
    EXPECT_EQ(sum(list), 3);
    const std::vector<int>& vector = list;
    EXPECT_EQ(vector.size(), 2u);
}

TEST(List, NamesAnIndexThatItDoesNotHave)
{
    List<int> list{1};
    EXPECT_EQ(test::ThrownMessage<std::out_of_range>([&] { list.RemoveAt(1); }),
              "List: index 1 of 0...0");
    EXPECT_EQ(test::ThrownMessage<std::out_of_range>([&] { list.Insert(-1, 2); }),
              "List: index -1 of 0...1");
}

} // namespace
} // namespace limn
