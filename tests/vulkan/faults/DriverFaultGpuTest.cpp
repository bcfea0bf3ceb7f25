#include "GpuTestDevice.h"
#include "GpuTestFrame.h"
#include "Paths.h"
#include "TemporaryFolder.h"
#include "core/ThrownMessage.h"
#include "faults/FaultyLoader.h"
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <regex>

namespace limn::test
{

namespace
{

using namespace faulty_loader;
using testing::StartsWith;

/// A textured cube in 8 x 8 pixels.
class SmallScene
{
public:
    SmallScene()
    {
        const auto compiler = std::make_shared<ShaderCompiler>();
        const auto material = std::make_shared<Material>(Shader::FromText(
            "Shader \"T\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n"
            "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n#include \"UnityCG.cginc\"\n"
            "sampler2D _MainTex; float4 _Tint;\n"
            "float4 V(float4 p : POSITION) : SV_POSITION { return UnityObjectToClipPos(p); }\n"
            "float4 F() : SV_Target { return tex2D(_MainTex, 0.5) * _Tint; }\n"
            "ENDHLSL } } }",
            "t.shader", compiler));
        material->SetTexture(ShaderPropertyId("_MainTex"),
                             std::make_shared<Texture2D>("Paint", 1, 1, GraphicsFormat::R8_UNorm,
                                                         std::vector<std::byte>(1, std::byte{99})));
        material->SetVector(ShaderPropertyId("_Tint"), {1, 1, 1, 1});
        GameObject& cube = m_Scene.Add("cube");
        cube.transform.localPosition = {0, 0, 3};
        cube.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Cube), {material}};
        m_Renderer = std::make_unique<UniversalRenderer>(compiler);
    }

    Image Draw(VulkanDevice& device, UniversalRenderPipeline& pipeline)
    {
        RenderRequest request;
        request.scene = &m_Scene;
        request.camera = &m_Camera;
        request.width = 8;
        request.height = 8;
        request.compile.leavesOut = false; // the more calls that can fail the better
        const RenderResult result = pipeline.RenderSingleCamera(*m_Renderer, request);
        return device.ReadBack(*result.output.rt());
    }

private:
    Scene m_Scene;
    Camera m_Camera;
    std::unique_ptr<UniversalRenderer> m_Renderer;
};

/// What a call returns in place of its success.
struct Failure
{
    VkResult result;
    std::string name;
};

/// Lets calls of a device fail that draws a small scene. Live objects are counted, so that a leak
/// of limn's shows; on a second device the scene must look as ever.
class DriverFaults : public GpuTest
{
protected:
    void SetUp() override
    {
        GpuTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure())
        {
            m_Options.device = SharedDevice().deviceName();
            VulkanDevice device{m_Options};
            UniversalRenderPipeline pipeline{device};
            m_Picture = m_Scene.Draw(device, pipeline).texels;
            // The cube's red is in the middle, the background's in the corner.
            ASSERT_NE(m_Picture.at((4 * 8 + 4) * 4), m_Picture.at(0));
        }
    }
    void TearDown() override
    {
        FailNothing();
        GpuTest::TearDown();
    }

    std::vector<std::byte> Draw() { return m_Scene.Draw(*m_Device, *m_Pipeline).texels; }

    /// A device draws two frames and dies.
    void Live()
    {
        m_Device.emplace(m_Options);
        m_Pipeline.emplace(*m_Device);
        EXPECT_EQ(m_Picture, Draw());
        EXPECT_EQ(m_Picture, Draw());
        m_Device->LastFrameTimings();
    }

    /// Lets one call in the life of a device fail.
    /// @return the function; "" where the life has fewer calls
    std::string FailOne(int number, const Failure& failure)
    {
        std::string message;
        FailCall(number, failure.result);
        try
        {
            Live();
        }
        catch (const std::exception& error) // ContractError where a format is what is lacking
        {
            message = error.what();
        }
        if (m_Device && !FailedFunction().empty())
        {
            ExpectStateOfTheDevice(failure.result == VK_ERROR_DEVICE_LOST);
        }
        if (m_Device)
        {
            EXPECT_EQ("", Text(m_Device->validationMessages()));
        }
        m_Device.reset();
        const std::string failed = FailedFunction();
        FailNothing();
        ExpectClear(message, failed, failure.name);
        ExpectPictureOfAnotherDevice();
        return failed;
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
            EXPECT_EQ(m_Picture, Draw()) << "on the same device";
        }
    }

    /// Lets each call in the life of a device fail in turn, with these results in turn.
    /// @return how many there are
    int FailEach(const std::vector<Failure>& failures)
    {
        const auto before = LiveObjects();
        for (int number = 1;; ++number)
        {
            const Failure& failure = failures[static_cast<std::size_t>(number) % failures.size()];
            SCOPED_TRACE(failure.name + ", call " + std::to_string(number));
            const std::string failed = FailOne(number, failure);
            SCOPED_TRACE(failed);
            EXPECT_EQ(before, LiveObjects());
            if (failed.empty() || HasFailure())
            {
                return number - 1;
            }
        }
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

    /// The message must name call and result, or say what it means.
    static void ExpectClear(const std::string& message, const std::string& function,
                            const std::string& resultName)
    {
        const std::string failure = function + ": " + resultName;
        if (function.empty() || function == "vkDeviceWaitIdle" ||
            function == "vkGetPipelineCacheData")
        {
            EXPECT_EQ("", message) << "it is no use to anybody where a device dies";
        }
        else if (message.empty())
        {
            EXPECT_EQ("vkAllocateDescriptorSets", function) << "only another pool mends anything";
        }
        else if (failure == "vkCreateInstance: VK_ERROR_INCOMPATIBLE_DRIVER" ||
                 failure == "vkEnumeratePhysicalDevices: VK_ERROR_INITIALIZATION_FAILED")
        {
            EXPECT_THAT(message, StartsWith("no Vulkan device: the loader found no driver"));
        }
        else if (resultName == "VK_ERROR_FORMAT_NOT_SUPPORTED")
        {
            EXPECT_THAT(message, StartsWith("texture '"));
            EXPECT_THAT(message, testing::HasSubstr("': the device cannot use format "));
        }
        else
        {
            EXPECT_THAT(message, StartsWith(failure));
        }
    }

    /// Under the pipeline of the one before, if it came to that.
    void ExpectPictureOfAnotherDevice()
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
        EXPECT_EQ(m_Picture, Draw()) << "on another device";
        m_Device.reset();
        m_Pipeline.reset();
    }

    VulkanDeviceOptions m_Options;
    SmallScene m_Scene;
    std::vector<std::byte> m_Picture;
    std::optional<VulkanDevice> m_Device;
    std::optional<UniversalRenderPipeline> m_Pipeline;
};

} // namespace

TEST_F(DriverFaults, AreTriedWithEveryCallThatCanFail)
{
    const std::regex checked(R"(Check\(\s*(vk\w+)\()");
    std::set<std::string> functions;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(SourcePath("core/vulkan/src")))
    {
        std::ifstream file(entry.is_regular_file() ? entry.path() : "/dev/null");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (std::sregex_iterator match(text.begin(), text.end(), checked), end; match != end;
             ++match)
        {
            functions.insert((*match)[1]);
        }
    }
    EXPECT_GT(functions.size(), 30u);
    for (const std::string& function : functions)
    {
        EXPECT_TRUE(Covers(function)) << function << ": give it to FaultyLoader";
    }
}

// limn tells the two errors of memory apart nowhere.
TEST_F(DriverFaults, OfMemoryLeaveNothingBehind)
{
    const TemporaryFolder folder;
    m_Options.cacheFolder = folder / "";
    m_Options.validation = true;
    EXPECT_GT(FailEach({{VK_ERROR_OUT_OF_HOST_MEMORY, "VK_ERROR_OUT_OF_HOST_MEMORY"},
                        {VK_ERROR_OUT_OF_DEVICE_MEMORY, "VK_ERROR_OUT_OF_DEVICE_MEMORY"}}),
              100);
}

TEST_F(DriverFaults, ThatLoseTheDeviceLeaveNothingBehind)
{
    EXPECT_GT(FailEach({{VK_ERROR_DEVICE_LOST, "VK_ERROR_DEVICE_LOST"}}), 10);
}

TEST_F(DriverFaults, OfFewCallsLeaveNothingBehind)
{
    const Failure failures[] = {{VK_ERROR_INITIALIZATION_FAILED, "VK_ERROR_INITIALIZATION_FAILED"},
                                {VK_ERROR_MEMORY_MAP_FAILED, "VK_ERROR_MEMORY_MAP_FAILED"},
                                {VK_ERROR_LAYER_NOT_PRESENT, "VK_ERROR_LAYER_NOT_PRESENT"},
                                {VK_ERROR_EXTENSION_NOT_PRESENT, "VK_ERROR_EXTENSION_NOT_PRESENT"},
                                {VK_ERROR_FEATURE_NOT_PRESENT, "VK_ERROR_FEATURE_NOT_PRESENT"},
                                {VK_ERROR_INCOMPATIBLE_DRIVER, "VK_ERROR_INCOMPATIBLE_DRIVER"},
                                {VK_ERROR_TOO_MANY_OBJECTS, "VK_ERROR_TOO_MANY_OBJECTS"},
                                {VK_ERROR_FORMAT_NOT_SUPPORTED, "VK_ERROR_FORMAT_NOT_SUPPORTED"},
                                {VK_ERROR_FRAGMENTED_POOL, "VK_ERROR_FRAGMENTED_POOL"},
                                {VK_ERROR_OUT_OF_POOL_MEMORY, "VK_ERROR_OUT_OF_POOL_MEMORY"}};
    for (const Failure& failure : failures)
    {
        EXPECT_GT(FailEach({failure}), 0) << failure.name;
    }
}

TEST_F(DriverFaults, NameWhatThereIsNoMemoryFor)
{
    FailFunction("vkBindImageMemory", VK_ERROR_OUT_OF_DEVICE_MEMORY);
    EXPECT_EQ("vkBindImageMemory: VK_ERROR_OUT_OF_DEVICE_MEMORY ('_CameraColorAttachmentA')",
              ThrownMessage<VulkanError>([&] { Live(); }));
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
    EXPECT_EQ("pass 'test pass': the viewport has the size 0x0; it must be positive",
              ThrownMessage<ContractError>([&] { device.Execute(wrong); }));
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
    EXPECT_EQ("vkQueueSubmit2: VK_ERROR_DEVICE_LOST", ThrownMessage<VulkanError>([&] { Draw(); }));
    FailNothing();
    EXPECT_EQ("VK_ERROR_DEVICE_LOST", ResultOf([&] { Draw(); }));
    m_Device.reset();
    ExpectPictureOfAnotherDevice();
}

} // namespace limn::test
