#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "TemporaryFolder.h"
#include "core/ThrownMessage.h"

namespace limn::test
{

namespace
{

/// Draws one quad in red with a new device that caches pipelines in `folder`.
Rgba8 DrawWithCache(const std::filesystem::path& folder)
{
    VulkanDeviceOptions options;
    options.device = SharedDevice().deviceName();
    options.cacheFolder = folder;
    VulkanDevice device{options};
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.passes[0].commands.emplace_back(MakeColorDraw(frame, MakeQuad(), Color::red));
    device.Execute(frame);
    return Texel8(device.ReadBack(*target), 0, 0);
}

std::filesystem::path OnlyFileIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        files.push_back(entry.path());
    }
    EXPECT_EQ(1u, files.size());
    return files.empty() ? std::filesystem::path{} : files.front();
}

/// Vulkan's header of the pipelines in a cache file, behind the file's own. Drivers do not promise
/// the same pipelines in the same bytes.
std::string HeaderOf(const std::filesystem::path& file)
{
    constexpr std::streamoff k_OwnHeader = 24; // bytes
    constexpr std::size_t k_VulkanHeader = 32; // bytes
    std::string bytes(k_VulkanHeader, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(k_OwnHeader);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    EXPECT_TRUE(stream) << file;
    return bytes;
}

} // namespace

using Device = GpuTest;

TEST_F(Device, IsAmongTheEnumeratedOnes)
{
    std::vector<std::string> names;
    for (const VulkanDeviceInfo& info : EnumerateVulkanDevices())
    {
        if (info.isUsable())
        {
            names.push_back(info.name);
        }
    }
    EXPECT_NE(names.end(), std::find(names.begin(), names.end(), SharedDevice().deviceName()));
}

TEST_F(Device, SaysWhichItIs)
{
    EXPECT_NE(std::string::npos,
              SharedDevice().ChoiceSentence().find("'" + SharedDevice().deviceName() + "'"));
    EXPECT_EQ(std::string::npos, SharedDevice().ChoiceSentence().find('\n'));
}

TEST_F(Device, RefusesANameThatNoDeviceHas)
{
    VulkanDeviceOptions options;
    options.device = "Voodoo 2";
    EXPECT_THAT(ThrownMessage<VulkanError>([&] { const VulkanDevice device{options}; }),
                Mentions("no usable", "'Voodoo 2'", "there are", "\n  0: '"));
}

TEST_F(Device, ReportsNoMessagesWithoutValidation)
{
    VulkanDeviceOptions options;
    options.device = SharedDevice().deviceName();
    const VulkanDevice device{options};
    EXPECT_TRUE(device.validationMessages().empty());
}

TEST_F(Device, HasNoTimingsBeforeTheFirstFrame)
{
    VulkanDeviceOptions options;
    options.device = SharedDevice().deviceName();
    VulkanDevice device{options};
    EXPECT_TRUE(device.LastFrameTimings().empty());
}

TEST_F(Device, KeepsPipelinesInTheCacheFolder)
{
    const TemporaryFolder folder;
    EXPECT_EQ(k_Red, DrawWithCache(folder / "made/on/first/use"));
    const std::filesystem::path file = OnlyFileIn(folder / "made/on/first/use");
    EXPECT_EQ(".bin", file.extension());
    EXPECT_EQ(k_Red, DrawWithCache(folder / "made/on/first/use"));
    OnlyFileIn(folder / "made/on/first/use");
}

TEST_F(Device, IgnoresADamagedCacheFileAndReplacesIt)
{
    const TemporaryFolder folder;
    DrawWithCache(folder / "");
    const std::filesystem::path file = OnlyFileIn(folder / "");
    const std::string header = HeaderOf(file);
    for (const std::string& content :
         {std::string(), std::string("no cache"), std::string(4096, '\xFF')})
    {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
        EXPECT_EQ(k_Red, DrawWithCache(folder / ""));
        EXPECT_EQ(header, HeaderOf(OnlyFileIn(folder / "")));
    }
}

TEST_F(Device, RefusesACacheFolderThatIsAFile)
{
    const TemporaryFolder folder;
    VulkanDeviceOptions options;
    options.device = SharedDevice().deviceName();
    options.cacheFolder = folder.Write("file", "x") / "sub";
    EXPECT_THAT(ThrownMessage<VulkanError>([&] { const VulkanDevice device{options}; }),
                Mentions("cache folder '" + options.cacheFolder.string() + "'", "Not a directory"));
}

} // namespace limn::test
