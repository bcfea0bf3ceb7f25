#include "Mentions.h"
#include "commands/CommandRun.h"
#include "commands/WatchedAssets.h"
#include "faults/FaultyLoader.h"
#include "view/Redrawer.h"
#include "vulkan/GpuTestDevice.h"

#include <gmock/gmock.h>
#include <sstream>

namespace limn::test
{

namespace
{

class RedrawerTest : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        WriteAssets(folder);
        options.scene = (folder / "s.scene.yaml").string();
        options.output = (folder / "out.png").string();
        options.cacheFolder = (folder / "cache").string();
        if (const char* device = std::getenv("LIMN_TEST_DEVICE"))
        {
            options.device = device;
        }
    }

    TemporaryFolder folder;
    RenderOptions options;
    std::ostringstream out;
    std::ostringstream err;
    Console console{out, err};
};

/// What drawing took so far.
struct Work
{
    explicit Work(const Redrawer& redrawer)
        : compiled(redrawer.assets().compiler()->statistics().compiled),
          loadedFromCache(redrawer.assets().compiler()->statistics().loadedFromCache),
          uploads(redrawer.device().statistics().meshUploads)
    {
    }

    int compiled = 0;
    int loadedFromCache = 0;
    std::uint64_t uploads = 0;
};

} // namespace

TEST_F(RedrawerTest, CompilesNoShaderAndUploadsNoMeshForAProfile)
{
    Redrawer redrawer(options, console);
    redrawer.Redraw({});
    ASSERT_EQ("#ffffff", ColorAt(folder / "out.png")) << err.str();
    const Work before(redrawer);
    EXPECT_GT(before.compiled, 0);
    EXPECT_GT(before.uploads, 0u);
    std::filesystem::remove(folder / "out.png");
    redrawer.Redraw({folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 5}\n")});
    EXPECT_EQ("#ffffff", ColorAt(folder / "out.png")) << err.str();
    EXPECT_EQ(before.compiled, Work(redrawer).compiled);
    EXPECT_EQ(before.loadedFromCache, Work(redrawer).loadedFromCache);
    EXPECT_EQ(before.uploads, Work(redrawer).uploads);
}

TEST_F(RedrawerTest, UploadsAChangedMeshAloneAndCompilesAChangedShaderAlone)
{
    Redrawer redrawer(options, console);
    redrawer.Redraw({});
    const Work first(redrawer);
    redrawer.Redraw({folder.Write("m.bin", CornerBytes(1.0f))});
    const Work second(redrawer);
    EXPECT_EQ(first.compiled, second.compiled);
    EXPECT_EQ(first.uploads + 1, second.uploads);
    redrawer.Redraw({folder.Write("own.shader", ShaderText("0.0"))});
    const Work third(redrawer);
    EXPECT_EQ(second.compiled + 1, third.compiled);
    EXPECT_EQ(second.uploads, third.uploads);
    EXPECT_EQ("#000000", ColorAt(folder / "out.png")) << err.str();
}

TEST_F(RedrawerTest, GoesOnWithANewDeviceWhenOneIsLost)
{
    Redrawer redrawer(options, console);
    redrawer.Redraw({});
    ASSERT_EQ("#ffffff", ColorAt(folder / "out.png")) << err.str();
    const auto profile = folder / "p.profile.yaml";
    for (const std::string name : {"first", "second"})
    {
        err.str("");
        std::filesystem::remove(folder / "out.png");
        faulty_loader::FailCall(1, VK_ERROR_DEVICE_LOST);
        redrawer.Redraw({profile});
        EXPECT_THAT(err.str(),
                    testing::StartsWith("warning: " + faulty_loader::FailedFunction() + " failed"));
        EXPECT_THAT(err.str(), testing::HasSubstr(": VK_ERROR_DEVICE_LOST"));
        EXPECT_THAT(err.str(), testing::EndsWith("; drawing goes on with a new device\n")) << name;
        faulty_loader::FailNothing();
        EXPECT_EQ("#ffffff", ColorAt(folder / "out.png")) << name;
    }
    err.str("");
    std::filesystem::remove(folder / "out.png");
    redrawer.Redraw({folder.Write("p.profile.yaml", "ScreenSpaceOutline: {m_OutlineWidth: 5}\n")});
    EXPECT_EQ("#ffffff", ColorAt(folder / "out.png"));
    EXPECT_EQ("", err.str());
}

TEST_F(RedrawerTest, EndsWhenEveryDeviceIsLost)
{
    Redrawer redrawer(options, console);
    redrawer.Redraw({});
    faulty_loader::FailFunction("vkQueueSubmit2", VK_ERROR_DEVICE_LOST);
    EXPECT_THROW(redrawer.Redraw({folder / "p.profile.yaml"}), VulkanError);
    faulty_loader::FailNothing();
    const auto line = Mentions("warning:", "vkQueueSubmit2", "VK_ERROR_DEVICE_LOST", "new device");
    EXPECT_THAT(LinesOf(err.str()), testing::ElementsAre(line, line, line));
}

} // namespace limn::test
