#include <gtest/gtest.h>
#include <programs/PipelineCacheFile.h>

namespace limn::test
{

using vulkan::UnwrapCacheFile;
using vulkan::WrapCacheFile;

TEST(PipelineCacheFile, ComesBackAsItWas)
{
    const std::vector<char> payload = {1, 2, 3, 0, -1};
    EXPECT_EQ(payload, UnwrapCacheFile(WrapCacheFile(payload)));
}

TEST(PipelineCacheFile, IsNothingWhereAnyByteDiffers)
{
    const std::vector<char> file = WrapCacheFile({1, 2, 3, 4});
    for (std::size_t i = 0; i < file.size(); ++i)
    {
        std::vector<char> damaged = file;
        damaged[i] = static_cast<char>(damaged[i] ^ 1);
        EXPECT_TRUE(UnwrapCacheFile(damaged).empty()) << "byte " << i;
    }
}

TEST(PipelineCacheFile, IsNothingWhereItIsCutShort)
{
    const std::vector<char> file = WrapCacheFile({1, 2, 3, 4});
    for (std::size_t length = 0; length < file.size(); ++length)
    {
        const std::vector<char> cut(file.begin(),
                                    file.begin() + static_cast<std::ptrdiff_t>(length));
        EXPECT_TRUE(UnwrapCacheFile(cut).empty()) << length << " bytes";
    }
}

TEST(PipelineCacheFile, IsNothingWhereBytesFollow)
{
    std::vector<char> file = WrapCacheFile({1, 2, 3, 4});
    file.push_back(0);
    EXPECT_TRUE(UnwrapCacheFile(file).empty());
}

} // namespace limn::test
