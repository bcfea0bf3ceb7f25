#include "EverythingScene.h"
#include "GpuTestFrame.h"
#include "Mentions.h"
#include "core/ThrownMessage.h"
#include "faults/FaultyLoader.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <iterator>
#include <limn/core/DrawError.h>
#include <regex>

namespace limn::test
{

namespace
{

using namespace faulty_loader;

/// What a call returns in place of its success, with its name.
struct Failure
{
    VkResult result;
    std::string name;
};
#define LIMN_FAILURE(result)                                                                       \
    {                                                                                              \
        result, #result                                                                            \
    }

const Failure k_Memory LIMN_FAILURE(VK_ERROR_OUT_OF_DEVICE_MEMORY);
const Failure k_Lost LIMN_FAILURE(VK_ERROR_DEVICE_LOST);

/// Returns N where every N-th call is to fail of all that can, by LIMN_FAULTS_ALL=N: with 1 that
/// takes an hour. It is 0 where a sample is to.
int StepOfAll()
{
    const char* all = std::getenv("LIMN_FAULTS_ALL");
    return all != nullptr ? std::atoi(all) : 0;
}
bool TakesAll()
{
    return StepOfAll() > 0;
}

/// Chooses which of these calls are to fail: the last one of each function, unless all are. Of
/// functions a third will do with sanitizers, which are slow.
/// @return numbers counted from 1
std::set<int> Sample(const std::vector<std::string>& calls)
{
    std::map<std::string, int> last;
    std::set<int> all;
    for (const std::string& call : calls)
    {
        const auto number = static_cast<int>(all.size() + 1);
        last[call] = number;
        all.insert(number);
    }
    std::set<int> sample;
    const std::size_t step = LimnHasSanitizers() ? 3 : 1;
    std::size_t index = 0;
    for (const auto& [function, number] : last)
    {
        if (index++ % step == 0)
        {
            sample.insert(number);
        }
    }
    std::erase_if(all, [](int number) { return TakesAll() && number % StepOfAll() != 0; });
    return TakesAll() ? all : sample;
}

/// Returns what the first group of an expression matches in a file, or in all files of a folder.
std::set<std::string> Matches(const std::filesystem::path& path, const std::string& expression)
{
    const std::regex regex(expression);
    std::set<std::string> matches;
    if (std::filesystem::is_directory(path))
    {
        for (const auto& entry : std::filesystem::directory_iterator(path))
        {
            matches.merge(Matches(entry.path(), expression));
        }
        return matches;
    }
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    {
        matches.insert((*match)[1]);
    }
    return matches;
}

/// Says whether a message tells of a call that failed; "" does where limn gets over it.
/// @param message  an error, or the notes of frames that were drawn
bool TellsOf(const std::string& message, const std::string& function, const std::string& result)
{
    if (result == "VK_INCOMPLETE" || result == "VK_TIMEOUT")
    {
        return message.empty(); // it is asked again
    }
    if (function == "vkDeviceWaitIdle" || function == "vkGetPipelineCacheData")
    {
        return message.empty(); // it is no use to anybody where a device dies
    }
    if (function == "vkGetPhysicalDeviceToolProperties")
    {
        return message.empty(); // there are no names for tools then
    }
    if (function == "vkAllocateDescriptorSets" && message.empty())
    {
        return result == "VK_ERROR_FRAGMENTED_POOL" || result == "VK_ERROR_OUT_OF_POOL_MEMORY";
    }
    if ((function == "vkCreateInstance" && result == "VK_ERROR_INCOMPATIBLE_DRIVER") ||
        (function == "vkEnumeratePhysicalDevices" && result == "VK_ERROR_INITIALIZATION_FAILED"))
    {
        return message.starts_with("no Vulkan device");
    }
    if (result == "VK_ERROR_FORMAT_NOT_SUPPORTED")
    {
        return (message.starts_with("texture '") &&
                message.find("': the device cannot use format ") != std::string::npos) ||
               testing::Value(message, Mentions("1 sample", "place of 4"));
    }
    return message.starts_with(function + " failed") &&
           message.find(": " + result) != std::string::npos;
}

/// Lets calls of a device fail that draws a scene with everything on. Live objects are counted, so
/// that a leak of limn's shows; on another device the scene must look as ever.
class DriverFaults : public GpuTest
{
protected:
    static void SetUpTestSuite()
    {
        if (Environment().device() == nullptr)
        {
            return;
        }
        s_Scene = std::make_unique<EverythingScene>();
        VulkanDeviceOptions options;
        options.device = SharedDevice().deviceName();
        VulkanDevice device{options};
        UniversalRenderPipeline pipeline{device};
        s_Picture = s_Scene->Draw(device, pipeline, false).texels;
        std::set<std::vector<std::byte>> colors;
        for (auto texel = s_Picture.begin(); texel != s_Picture.end(); texel += 4)
        {
            colors.insert({texel, texel + 4});
        }
        EXPECT_GT(colors.size(), 50u);
        EXPECT_EQ("", Notes()) << "every feature draws";
    }
    static void TearDownTestSuite() { s_Scene.reset(); }

    void SetUp() override
    {
        GpuTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure())
        {
            m_Options.device = SharedDevice().deviceName();
            m_Options.cacheFolder = m_Folder / "";
        }
    }
    void TearDown() override
    {
        FailNothing();
        SetTool(false);
        GpuTest::TearDown();
    }

    /// Returns what is to be said of the last frame.
    static std::string Notes()
    {
        std::string notes;
        for (const std::string& note : s_Scene->report.notes)
        {
            notes += note + "\n";
        }
        return notes;
    }

    /// Draws what looks as ever, unless a note says why it does not.
    void Draw(bool isLast = false)
    {
        const Image image = s_Scene->Draw(*m_Device, *m_Pipeline, isLast);
        m_Notes += Notes();
        EXPECT_TRUE(image.texels == s_Picture || !Notes().empty());
    }

    void MakeDevice()
    {
        m_Device.emplace(m_Options);
        if (m_Pipeline)
        {
            m_Pipeline->SetDevice(*m_Device);
        }
        else
        {
            m_Pipeline.emplace(*m_Device);
        }
    }

    /// A device, unless there is one, draws three frames, so that the memory of the first comes
    /// again.
    void Live()
    {
        if (!m_Device)
        {
            MakeDevice();
        }
        Draw();
        Draw();
        Draw(true);
        for (const PassTiming& timing : m_Device->LastFrameTimings())
        {
            EXPECT_GE(timing.milliseconds, 0.0) << timing.name;
            EXPECT_LT(timing.milliseconds, 60000.0) << timing.name;
        }
    }

    /// Returns what the error says that ends a life, or the notes if none does.
    std::string MessageOfALife()
    {
        m_Notes.clear();
        try
        {
            Live();
        }
        catch (const VulkanError& error)
        {
            return error.what();
        }
        catch (const DrawError& error) // a format is what is lacking
        {
            return error.what();
        }
        return m_Notes;
    }

    /// Lives without a failure.
    /// @return the calls that may return each of the results, one after the other
    std::vector<std::vector<std::string>> CallsOfALife(const std::vector<Failure>& failures)
    {
        FailNothing();
        Live();
        m_Device.reset();
        std::vector<std::vector<std::string>> calls;
        for (const Failure& failure : failures)
        {
            calls.push_back(CallsThatMay(failure.result));
        }
        return calls;
    }

    /// Lets calls fail in the life of a device, which goes on behind the first ones.
    /// @return the functions, one for each failure
    std::vector<std::string> Fail(const std::vector<std::pair<int, Failure>>& failures)
    {
        const auto before = LiveObjects();
        std::vector<Fault> faults;
        for (const auto& [number, failure] : failures)
        {
            faults.push_back({number, failure.result});
        }
        FailCalls(faults);
        std::vector<std::string> functions;
        for (std::size_t life = 1; life <= failures.size() && functions.size() < failures.size();
             ++life)
        {
            const std::string message = MessageOfALife();
            const bool isOver = life == failures.size() || FailedCalls().size() == failures.size();
            if (m_Device && FailedCalls().size() == failures.size())
            {
                ExpectStateOfTheDevice(failures.back().second.result == VK_ERROR_DEVICE_LOST);
            }
            if (m_Device)
            {
                EXPECT_EQ("", Text(m_Device->validationMessages()));
            }
            if (isOver || FailedCalls().size() == functions.size())
            {
                m_Device.reset();
            }
            ExpectToTell(message, failures, functions);
        }
        FailNothing();
        if (TakesAll()) // else what comes next draws with another device, too
        {
            ExpectPictureOfAnotherDevice();
        }
        EXPECT_EQ(before, LiveObjects());
        return functions;
    }

    /// A message tells of one of the calls that failed in the meantime, which `functions` gets.
    static void ExpectToTell(const std::string& message,
                             const std::vector<std::pair<int, Failure>>& failures,
                             std::vector<std::string>& functions)
    {
        bool isTold = functions.size() == FailedCalls().size() && message.empty();
        std::string all;
        for (std::size_t i = functions.size(); i < FailedCalls().size(); ++i)
        {
            const std::string& function = FailedCalls()[i].function;
            const std::string& result = failures.at(i).second.name;
            functions.push_back(function);
            // Where a device has several types of memory, another one is taken, and the picture is
            // as it was: there is nothing to tell.
            isTold = isTold || TellsOf(message, function, result) ||
                     (message.empty() && function == "vkAllocateMemory" && MemoryTypeCount() > 1);
            // A lost device fails each call from then on. While limn clears up after an earlier
            // fault it passes over the first, and tells of the next.
            isTold =
                isTold || (i > 0 && result == "VK_ERROR_DEVICE_LOST" &&
                           message.ends_with(": VK_ERROR_DEVICE_LOST, the device has stopped"));
            all += function + ": " + result + "; ";
        }
        EXPECT_TRUE(isTold) << "failed: " << all << "said: " << message;
    }

    /// Of one that a call has failed of.
    void ExpectStateOfTheDevice(bool isLost)
    {
        if (isLost)
        {
            EXPECT_EQ("VK_ERROR_DEVICE_LOST", ResultOf([&] { Draw(); })) << "lost for ever";
        }
        else
        {
            SCOPED_TRACE("on the same device");
            Draw();
            EXPECT_EQ("", Notes());
        }
    }

    /// Lets calls fail one after the other, each in a life of its own and with each result that it
    /// may return.
    /// @return how many calls may return each
    std::vector<std::size_t> FailEach(const std::vector<Failure>& failures)
    {
        const std::vector<std::vector<std::string>> calls = CallsOfALife(failures);
        std::vector<std::size_t> counts;
        for (std::size_t i = 0; i < failures.size(); ++i)
        {
            FailEach(failures[i], calls[i]);
            counts.push_back(calls[i].size());
        }
        ExpectPictureOfAnotherDevice();
        return counts;
    }

    void FailEach(const Failure& failure, const std::vector<std::string>& calls)
    {
        std::map<std::string, int> failed;
        for (const int number : Sample(calls))
        {
            const std::string& call = calls.at(static_cast<std::size_t>(number - 1));
            SCOPED_TRACE(failure.name + ", call " + std::to_string(number) + ", " + call);
            EXPECT_EQ(std::vector{call}, Fail({{number, failure}}));
            ++failed[call];
            if (HasFailure() && !TakesAll())
            {
                break;
            }
        }
        Print(failure, calls.size(), failed);
    }

    static void Print(const Failure& failure, std::size_t calls,
                      const std::map<std::string, int>& failed)
    {
        std::cout << failure.name << ": of " << calls << " calls failed";
        for (const auto& [function, count] : failed)
        {
            std::cout << ' ' << count << ' ' << function;
        }
        std::cout << std::endl;
    }

    /// The result that an action's VulkanError holds.
    template <typename Action>
    static std::string ResultOf(Action&& action)
    {
        try
        {
            action();
        }
        catch (const VulkanError& error)
        {
            EXPECT_EQ(error.isDeviceLost(), error.result() == "VK_ERROR_DEVICE_LOST");
            return error.result();
        }
        return "none";
    }

    /// Under the pipeline of the one before, if it came to that.
    void ExpectPictureOfAnotherDevice()
    {
        SCOPED_TRACE("on another device");
        MakeDevice();
        Draw();
        EXPECT_EQ("", Notes());
        m_Device.reset();
    }

    static inline std::unique_ptr<EverythingScene> s_Scene;
    static inline std::vector<std::byte> s_Picture;

    std::string m_Notes; ///< of the frames of a life
    TemporaryFolder m_Folder;
    VulkanDeviceOptions m_Options;
    std::optional<VulkanDevice> m_Device;
    std::optional<UniversalRenderPipeline> m_Pipeline;
};

} // namespace

TEST_F(DriverFaults, AreTriedWithEveryCallThatCanFail)
{
    const std::set<std::string> functions =
        Matches(LIMN_VULKAN_HEADER, R"(VkResult VKAPI_CALL (\w+)\()");
    const std::set<std::string> used = Matches(SourcePath("core/vulkan/src"), R"((vk[A-Z]\w+))");
    std::set<std::string> calls;
    std::set_intersection(functions.begin(), functions.end(), used.begin(), used.end(),
                          std::inserter(calls, calls.end()));
    EXPECT_GT(calls.size(), 35u);
    for (const std::string& call : calls)
    {
        EXPECT_TRUE(Covers(call)) << call << ": give it to FaultyLoader";
    }
    m_Options.validation = true;
    SetTool(true);
    const std::vector<std::string> made = CallsOfALife({k_Memory}).front();
    for (const std::string& call : calls)
    {
        EXPECT_GT(std::count(made.begin(), made.end(), call), 0)
            << call << ": let the scene call it";
    }
}

// limn tells this error of memory from that of the host nowhere.
TEST_F(DriverFaults, OfMemoryLeaveNothingBehind)
{
    m_Options.validation = true;
    SetTool(true);
    EXPECT_GT(FailEach({k_Memory}).front(), 500u);
}

TEST_F(DriverFaults, ThatLoseTheDeviceLeaveNothingBehind)
{
    EXPECT_GT(FailEach({k_Lost}).front(), 20u);
}

TEST_F(DriverFaults, OfFewCallsLeaveNothingBehind)
{
    const std::vector<Failure> failures = {
        LIMN_FAILURE(VK_ERROR_INITIALIZATION_FAILED), LIMN_FAILURE(VK_ERROR_MEMORY_MAP_FAILED),
        LIMN_FAILURE(VK_ERROR_LAYER_NOT_PRESENT),     LIMN_FAILURE(VK_ERROR_EXTENSION_NOT_PRESENT),
        LIMN_FAILURE(VK_ERROR_FEATURE_NOT_PRESENT),   LIMN_FAILURE(VK_ERROR_INCOMPATIBLE_DRIVER),
        LIMN_FAILURE(VK_ERROR_TOO_MANY_OBJECTS),      LIMN_FAILURE(VK_ERROR_FORMAT_NOT_SUPPORTED),
        LIMN_FAILURE(VK_ERROR_FRAGMENTED_POOL),       LIMN_FAILURE(VK_ERROR_OUT_OF_POOL_MEMORY)};
    for (const std::size_t count : FailEach(failures))
    {
        EXPECT_GT(count, 0u);
    }
}

TEST_F(DriverFaults, ThatAreNoErrorsAreGotOver)
{
    m_Options.validation = true;
    const std::vector<std::size_t> counts = FailEach(
        {LIMN_FAILURE(VK_INCOMPLETE), LIMN_FAILURE(VK_TIMEOUT), LIMN_FAILURE(VK_NOT_READY)});
    EXPECT_GT(counts[0], 3u);
    EXPECT_GT(counts[1], 5u);
    EXPECT_EQ(counts[2], 0u) << "limn waits for times";
}

TEST_F(DriverFaults, OfTwoKindsInOneLifeLeaveNothingBehind)
{
    const Failure first LIMN_FAILURE(VK_ERROR_OUT_OF_HOST_MEMORY);
    const Failure seconds[] = {k_Lost, k_Memory, LIMN_FAILURE(VK_TIMEOUT),
                               LIMN_FAILURE(VK_ERROR_OUT_OF_POOL_MEMORY)};
    const auto count = static_cast<int>(CallsOfALife({first}).front().size());
    const int step = TakesAll() ? 7 * StepOfAll() : count / 3;
    std::size_t chosen = 0;
    for (int number = step / 2; number <= count && !HasFailure(); number += step)
    {
        const Failure& second = seconds[chosen++ % std::size(seconds)];
        SCOPED_TRACE(first.name + ", call " + std::to_string(number) + ", and " + second.name);
        EXPECT_EQ(2u, Fail({{number, first}, {1 + number % 2, second}}).size());
    }
    ExpectPictureOfAnotherDevice();
}

TEST_F(DriverFaults, NameWhatThereIsNoMemoryFor)
{
    FailFunction("vkBindImageMemory", VK_ERROR_OUT_OF_DEVICE_MEMORY);
    EXPECT_THAT(ThrownMessage<VulkanError>([&] { Live(); }),
                Mentions("vkBindImageMemory failed", "'_MainLightShadowmapTexture'",
                         "VK_ERROR_OUT_OF_DEVICE_MEMORY", "smaller picture"));
}

TEST_F(DriverFaults, DoNotHideWhatIsWrongWithAFrame)
{
    VulkanDevice device{m_Options};
    const TargetPtr target = MakeTarget(1, 1);
    CompiledFrame wrong = FrameOf({ClearPass(target)}, target);
    wrong.passes[0].commands.emplace_back(MakeColorDraw(wrong, MakeQuad(), Color::red));
    wrong.passes[0].commands.emplace_back(SetViewportCommand{{0, 0, 0, 0}});
    const std::map<std::string, int> before = LiveObjects();
    FailFunction("vkResetCommandPool", VK_ERROR_OUT_OF_HOST_MEMORY, 1);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { device.Execute(wrong); }),
                Mentions("'test pass'", "viewport", "0x0", "positive"));
    FailNothing();
    EXPECT_EQ(0u, device.statistics().images);
    EXPECT_EQ(0u, device.statistics().meshes);
    EXPECT_EQ(before.at("Buffer") + 1, LiveObjects().at("Buffer")) << "a slot keeps its memory";
    wrong.passes[0].commands.pop_back();
    device.Execute(wrong);
    EXPECT_EQ((Rgba8{255, 0, 0, 255}), Texel8(device.ReadBack(*target), 0, 0));
}

TEST_F(DriverFaults, ALostDeviceIsReplacedUnderItsPipeline)
{
    Live();
    FailFunction("vkQueueSubmit2", VK_ERROR_DEVICE_LOST);
    EXPECT_THAT(ThrownMessage<VulkanError>([&] { Draw(); }),
                Mentions("vkQueueSubmit2 failed", "VK_ERROR_DEVICE_LOST"));
    FailNothing();
    EXPECT_EQ("VK_ERROR_DEVICE_LOST", ResultOf([&] { Draw(); }));
    m_Device.reset();
    ExpectPictureOfAnotherDevice();
}

} // namespace limn::test
