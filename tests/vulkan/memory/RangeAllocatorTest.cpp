#include <gtest/gtest.h>
#include <memory/RangeAllocator.h>
#include <random>
#include <vector>

namespace limn::test
{

using vulkan::RangeAllocator;

TEST(RangeAllocator, TakesTheFirstGapThatFits)
{
    RangeAllocator ranges{100};
    EXPECT_EQ(0u, ranges.Allocate(30, 1));
    EXPECT_EQ(30u, ranges.Allocate(30, 1));
    ranges.Free(0, 30);
    EXPECT_EQ(60u, ranges.Allocate(40, 1)) << "the gap of 30 is too small";
    EXPECT_EQ(0u, ranges.Allocate(10, 1));
}

TEST(RangeAllocator, HasNothingOnceFull)
{
    RangeAllocator ranges{64};
    EXPECT_EQ(0u, ranges.Allocate(64, 1));
    EXPECT_EQ(std::nullopt, ranges.Allocate(1, 1));
    EXPECT_EQ(64u, ranges.usedBytes());
}

TEST(RangeAllocator, RefusesMoreThanItHas)
{
    RangeAllocator ranges{64};
    EXPECT_EQ(std::nullopt, ranges.Allocate(65, 1));
}

TEST(RangeAllocator, AlignsOffsetsAndUsesTheGapBeforeThem)
{
    RangeAllocator ranges{512};
    EXPECT_EQ(0u, ranges.Allocate(10, 1));
    EXPECT_EQ(256u, ranges.Allocate(16, 256));
    EXPECT_EQ(10u, ranges.Allocate(246, 1));
}

TEST(RangeAllocator, RefusesWhereOnlyTheAlignmentDoesNotFit)
{
    RangeAllocator ranges{100};
    EXPECT_EQ(0u, ranges.Allocate(1, 1));
    EXPECT_EQ(std::nullopt, ranges.Allocate(1, 128));
}

TEST(RangeAllocator, MergesNeighboursOnBothSides)
{
    RangeAllocator ranges{90};
    ranges.Allocate(30, 1);
    ranges.Allocate(30, 1);
    ranges.Allocate(30, 1);
    ranges.Free(0, 30);
    ranges.Free(60, 30);
    ranges.Free(30, 30);
    EXPECT_EQ(0u, ranges.usedBytes());
    EXPECT_EQ(0u, ranges.Allocate(90, 1));
}

TEST(RangeAllocator, NeverHandsOutAByteTwice)
{
    constexpr std::size_t k_Size = 4096;
    RangeAllocator ranges{k_Size};
    std::vector<bool> taken(k_Size);
    struct Range
    {
        std::uint64_t offset;
        std::uint64_t size;
    };
    std::vector<Range> held;
    std::mt19937 random{7};
    for (int step = 0; step < 5000; ++step)
    {
        const std::uint64_t size = 1 + random() % 200;
        const std::uint64_t alignment = std::uint64_t{1} << (random() % 8);
        if (const auto offset = ranges.Allocate(size, alignment))
        {
            ASSERT_EQ(0u, *offset % alignment);
            ASSERT_LE(*offset + size, k_Size);
            for (std::uint64_t i = *offset; i < *offset + size; ++i)
            {
                ASSERT_FALSE(taken[i]);
                taken[i] = true;
            }
            held.push_back({*offset, size});
        }
        if (!held.empty() && random() % 3 != 0)
        {
            std::swap(held[random() % held.size()], held.back());
            ranges.Free(held.back().offset, held.back().size);
            for (std::uint64_t i = 0; i < held.back().size; ++i)
            {
                taken[held.back().offset + i] = false;
            }
            held.pop_back();
        }
    }
}

} // namespace limn::test
