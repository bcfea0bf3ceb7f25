#include "Mentions.h"
#include "commands/CommandRun.h"
#include "core/ThrownMessage.h"

#include <console/CacheFolder.h>
#include <gmock/gmock.h>
#include <limn/base/Diagnostic.h>

namespace limn::test
{

namespace
{

/// LIMN_CACHE_LIMIT for as long as the object lives.
class LimitVariable
{
public:
    explicit LimitVariable(const char* value) { setenv("LIMN_CACHE_LIMIT", value, 1); }
    ~LimitVariable() { unsetenv("LIMN_CACHE_LIMIT"); }
    LimitVariable(const LimitVariable&) = delete;
    LimitVariable& operator=(const LimitVariable&) = delete;
};

constexpr const char* k_Shader = "Shader \"S\" { SubShader { Pass {\nHLSLPROGRAM\n"
                                 "#pragma vertex V\n#pragma fragment F\n"
                                 "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                                 "float4 F() : SV_Target { return 0.0625; }\nENDHLSL\n} } }\n";

} // namespace

TEST(CacheLimit, IsTheDefaultWithoutTheVariable)
{
    unsetenv("LIMN_CACHE_LIMIT");
    EXPECT_EQ(12345u, CacheLimit(12345));
}

TEST(CacheLimit, CountsBytesKibibytesAndSoOn)
{
    const std::pair<const char*, std::uintmax_t> cases[] = {
        {"0", 0},           {"1", 1},
        {"200000", 200000}, {"512K", 524288},
        {"64M", 67108864},  {"2G", 2147483648u},
        {"0M", 0},          {"17179869183G", 18446744072635809792u}};
    for (const auto& [text, bytes] : cases)
    {
        const LimitVariable variable(text);
        EXPECT_EQ(bytes, CacheLimit(12345)) << text;
    }
}

TEST(CacheLimit, RefusesAnythingElseAndSaysWhatIsRight)
{
    for (const std::string text : {"", "K", "12Q", "12KB", "-1", "+1", " 1", "1 ", "1.5M", "0x10",
                                   "12m", "18446744073709551616", "17179869184G"})
    {
        const LimitVariable variable(text.c_str());
        EXPECT_THAT(ThrownMessage<AssetError>([] { CacheLimit(12345); }),
                    Mentions("LIMN_CACHE_LIMIT:", "'" + text + "'", "K, M or G", "512M"));
    }
}

TEST(CacheLimit, IsWhatTheCommandsGoBy)
{
    const TemporaryFolder folder;
    const std::string path = folder.Write("s.shader", k_Shader).string();
    {
        const LimitVariable variable("many");
        const CommandRun run = RunCommand({"shader", path});
        EXPECT_EQ(1, run.exitCode);
        EXPECT_THAT(run.err, testing::StartsWith("LIMN_CACHE_LIMIT: error: 'many' is no size"));
    }
    const auto entries = []
    {
        int count = 0;
        for (const auto& file : std::filesystem::directory_iterator(DefaultCacheFolder()))
        {
            count += file.path().extension() == ".limnpass" ? 1 : 0;
        }
        return count;
    };
    {
        const LimitVariable variable("1");
        EXPECT_EQ(0, RunCommand({"shader", path}).exitCode);
        EXPECT_EQ(0, entries()) << "no entry fits into one byte";
    }
    const LimitVariable variable("1M");
    EXPECT_EQ(0, RunCommand({"shader", path}).exitCode);
    EXPECT_EQ(1, entries());
}

} // namespace limn::test
