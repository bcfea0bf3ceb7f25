#include "unity/FilesOfProject.h"

#include <gtest/gtest.h>

namespace limn::test
{

TEST(UnityExpansion, RefusesMoreThanItTakes)
{
    FilesOfProject files;
    files.Add("0", ObjectText(5, "Leaf"));
    for (int i = 1; i < 40; ++i) // each holds the one before twice
    {
        const std::string before = std::to_string(i - 1);
        files.Add(std::to_string(i),
                  InstanceText(2 * i, before, "") + InstanceText(2 * i + 1, before, ""));
    }
    EXPECT_THROW(files.Expand("39"), AssetError);
    FilesOfProject chain;
    chain.Add("0", ObjectText(5, "Leaf"));
    for (int i = 1; i < 100; ++i)
    {
        chain.Add(std::to_string(i), InstanceText(i, std::to_string(i - 1), ""));
    }
    EXPECT_THROW(chain.Expand("99"), AssetError);
}

} // namespace limn::test
