#include "PluginRun.h"
#include "commands/WatchTest.h"

#include <gmock/gmock.h>
#include <limn/features/Version.h>

namespace limn::test
{

namespace
{

/// sRGB shows a light of s as 1.055 * s^(1 / 2.4) - 0.055: 0.75 as 224.6, 0.5 as 187.5 of 255.
enum class Shade
{
    Red,      ///< 0.75
    DarkRed,  ///< 0.5
    Green,    ///< 0.75
    DarkGreen ///< 0.5
};

/// `limn watch` of a scene that a plug-in paints all of, red.
class WatchPlugin : public WatchTest
{
protected:
    void SetUp() override
    {
        WatchTest::SetUp();
        folder.Write("p.profile.yaml", "Probe: {strength: 0.75}\n");
        WriteProbeScene(folder, "{type: ProbeFeature, name: Red}");
        folder.Write("probe.so", ReadText(BuiltPlugin("probe.so")));
    }

    void StartWithOption()
    {
        Start("'" + Path("s.scene.yaml") + "' --cache-dir '" + Path("cache") + "' -o '" +
              Path("out.png") + "' --plugin '" + Path("probe.so") + "'");
    }

    /// As a linker does: beside it, then in its place.
    void Build(const std::string& bytes) const
    {
        std::filesystem::rename(folder.Write("probe.tmp", bytes), folder / "probe.so");
    }

    bool WaitForShade(Shade shade) const
    {
        const bool isGreen = shade == Shade::Green || shade == Shade::DarkGreen;
        const bool isDark = shade == Shade::DarkRed || shade == Shade::DarkGreen;
        return WaitFor(
            [&]
            {
                if (!std::filesystem::exists(folder / "out.png"))
                {
                    return false;
                }
                const Image image = ReadPng(folder / "out.png");
                const double light = isDark ? 187.5 : 224.6;
                const double wanted[] = {isGreen ? 0.0 : light, isGreen ? light : 0.0, 0.0};
                for (std::size_t i = 0; i < image.texels.size(); ++i)
                {
                    if (i % 4 < 3 &&
                        std::abs(wanted[i % 4] - std::to_integer<int>(image.texels[i])) > 1.0)
                    {
                        return false;
                    }
                }
                return image.texels.size() == std::size_t{64} * 4;
            });
    }

    /// Waits until stderr ends with `lines`, "FILE" standing for the plug-in's path, and takes them
    /// from there.
    testing::AssertionResult Says(std::string lines)
    {
        for (std::size_t at = 0; (at = lines.find("FILE")) != std::string::npos;)
        {
            lines.replace(at, 4, Path("probe.so"));
        }
        const bool isSaid =
            WaitFor([&] { return ReadText(folder / "err").substr(m_Read) == lines; });
        const std::string said = ReadText(folder / "err").substr(m_Read);
        m_Read += said.size();
        return isSaid ? testing::AssertionSuccess() : testing::AssertionFailure() << said;
    }

    std::size_t Redraws() const
    {
        const std::string lines = ReadText(folder / "out");
        return static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
    }

    static constexpr const char* k_Stays = "FILE: note: the plug-in loaded before stays in use\n";

private:
    std::size_t m_Read = 0;
};

} // namespace

TEST_F(WatchPlugin, DrawsWithItsNewCodeAndShader)
{
    StartWithOption();
    ASSERT_TRUE(WaitForShade(Shade::Red)) << ReadText(folder / "err");
    Build(GreenProbe());
    EXPECT_TRUE(WaitForShade(Shade::Green)) << "renamed into its place";
    folder.Write("p.profile.yaml", "Probe: {strength: 0.5}\n");
    EXPECT_TRUE(WaitForShade(Shade::DarkGreen)) << "its component, in the profile";
    folder.Write("probe.so", ReadText(BuiltPlugin("probe.so")));
    EXPECT_TRUE(WaitForShade(Shade::DarkRed)) << "written over in place";
    EXPECT_EQ("", ReadText(folder / "err"));
    EXPECT_EQ(0, Stop(SIGTERM));
}

TEST_F(WatchPlugin, OfItsSceneIsFollowed)
{
    WriteProbeScene(folder, "{type: ProbeFeature}", "plugins: [probe.so]\n");
    Start();
    ASSERT_TRUE(WaitForShade(Shade::Red)) << ReadText(folder / "err");
    Build(GreenProbe());
    EXPECT_TRUE(WaitForShade(Shade::Green));
    EXPECT_EQ("", ReadText(folder / "err"));
}

TEST_F(WatchPlugin, GoesOnWithTheLastGoodOneWhileTheNewOneCannotBeLoaded)
{
    StartWithOption();
    ASSERT_TRUE(WaitForShade(Shade::Red)) << ReadText(folder / "err");
    const std::string good = ReadText(BuiltPlugin("probe.so"));
    const std::string cannot = "FILE: error: the file cannot be loaded as a plug-in: ";
    const std::string unusable = "FILE: error: this plug-in cannot be used: ";

    std::filesystem::remove(folder / "probe.so");
    EXPECT_TRUE(Says(cannot + "there is no such file\n" + k_Stays));
    folder.Write("p.profile.yaml", "Probe: {strength: 0.5}\n");
    EXPECT_TRUE(WaitForShade(Shade::DarkRed)) << "the profile is still followed";

    folder.Write("probe.so", good.substr(0, good.size() / 2)); // a linker that crashed
    EXPECT_TRUE(Says(cannot + "the file ends too early, after " + std::to_string(good.size() / 2) +
                     " bytes; is it being written, or was the linker stopped?\n" + k_Stays));
    WriteProbeScene(folder, "{type: ProbeFeature, name: Blue}");
    EXPECT_TRUE(WaitFor([&] { return Redraws() == 3; })) << "the scene is still followed";

    std::string other = LIMN_VERSION_TEXT;
    other.back() = other.back() == '9' ? '8' : '9';
    Build(Patched(good, LIMN_VERSION_TEXT, other));
    EXPECT_TRUE(Says(unusable + "it was built for limn " + other +
                     ", but this is limn " LIMN_VERSION_TEXT "; build it again with this one\n" +
                     k_Stays));
    Build(ReadText(BuiltPlugin("missing_symbol.so")));
    EXPECT_TRUE(Says(cannot +
                     "it uses probe::Paint(int), which neither it nor limn has; add the "
                     "source that defines it, or build it again with this limn\n" +
                     k_Stays));
    Build(FaultyProbe(probe::Fault::Registration));
    EXPECT_TRUE(Says(unusable + "its registration threw: nothing to sell\n" + k_Stays));
    EXPECT_EQ(3u, Redraws());

    Build(GreenProbe());
    EXPECT_TRUE(WaitForShade(Shade::DarkGreen));
    EXPECT_TRUE(Says(""));
    EXPECT_EQ(0, Stop(SIGTERM));
}

TEST_F(WatchPlugin, GoesOnWhileTheNewOneThrows)
{
    StartWithOption();
    ASSERT_TRUE(WaitForShade(Shade::Red)) << ReadText(folder / "err");
    const std::string before = ReadText(folder / "out.png");
    Build(FaultyProbe(probe::Fault::Execute));
    EXPECT_TRUE(Says("FILE: error: 'Red' threw in Execute of pass 'Paint': the brush is gone\n"));
    Build(FaultyProbe(probe::Fault::Create));
    EXPECT_TRUE(Says("FILE: error: 'Red' threw in Create: out of paint\n"));
    EXPECT_EQ(before, ReadText(folder / "out.png"));
    EXPECT_EQ(1u, Redraws());
    Build(GreenProbe());
    EXPECT_TRUE(WaitForShade(Shade::Green));
    EXPECT_TRUE(Says(""));
}

TEST_F(WatchPlugin, ThatIsBrokenAtFirstIsDrawnOnceItIsMended)
{
    folder.Write("probe.so", FaultyProbe(probe::Fault::Registration));
    StartWithOption();
    EXPECT_TRUE(Says("FILE: error: this plug-in cannot be used: its registration threw: nothing "
                     "to sell\n"));
    std::filesystem::remove(folder / "probe.so");
    EXPECT_TRUE(
        Says("FILE: error: the file cannot be loaded as a plug-in: there is no such file\n"));
    folder.Write("probe.so", ReadText(BuiltPlugin("probe.so")));
    EXPECT_TRUE(WaitForShade(Shade::Red)) << ReadText(folder / "err");
    Build(GreenProbe());
    EXPECT_TRUE(WaitForShade(Shade::Green));
}

} // namespace limn::test
