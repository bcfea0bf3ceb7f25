#pragma once

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <limn/core/Image.h>
#include <limn/core/RenderTexture.h>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>

namespace limn::test
{

/// Makes the process's device before the first test and frees it after the last one, before static
/// objects of the driver go.
class DeviceEnvironment final : public testing::Environment
{
public:
    void SetUp() override
    {
        VulkanDeviceOptions options;
        options.validation = true;
        if (const char* device = std::getenv("LIMN_TEST_DEVICE"))
        {
            options.device = device;
        }
        try
        {
            device_ = std::make_unique<VulkanDevice>(options);
        }
        catch (const VulkanError& error)
        {
            reason_ = error.what();
        }
    }
    void TearDown() override { device_.reset(); }

    VulkanDevice* device() { return device_.get(); }
    const std::string& reason() const { return reason_; }

    /// The messages since the last call.
    std::vector<ValidationMessage> NewMessages()
    {
        std::vector<ValidationMessage> messages = device_->validationMessages();
        messages.erase(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(seen_));
        seen_ += messages.size();
        return messages;
    }

private:
    std::unique_ptr<VulkanDevice> device_;
    std::string reason_;
    std::size_t seen_ = 0;
};

inline DeviceEnvironment& Environment()
{
    static auto* const environment = static_cast<DeviceEnvironment*>(
        testing::AddGlobalTestEnvironment(new DeviceEnvironment)); // GoogleTest owns it
    return *environment;
}
inline DeviceEnvironment& k_RegisteredBeforeMain = Environment();

/// The device that all tests of the process share; validation is on.
/// LIMN_TEST_DEVICE chooses it as VulkanDeviceOptions::device does.
inline VulkanDevice& SharedDevice()
{
    if (Environment().device() == nullptr)
    {
        throw VulkanError(Environment().reason());
    }
    return *Environment().device();
}

/// Returns the texels as the texture stores them: the row of clip space's y = 1 first.
inline Image ReadRows(const RenderTexture& texture, VulkanDevice& device = SharedDevice())
{
    Image image = device.ReadBack(texture);
    image.texels = FlipRows(image.texels, image.height);
    return image;
}
/// The same of the stencil.
inline Image ReadStencilRows(const RenderTexture& texture)
{
    Image image = SharedDevice().ReadBackStencil(texture);
    image.texels = FlipRows(image.texels, image.height);
    return image;
}

inline std::string Text(const std::vector<ValidationMessage>& messages)
{
    std::string text;
    for (const ValidationMessage& message : messages)
    {
        text += message.id + ": " + message.text + "\n";
    }
    return text;
}

/// Fails the test if the validation layer objected to anything since the last call.
inline void ExpectNoValidationMessages()
{
    EXPECT_EQ("", Text(Environment().NewMessages()));
}

/// Says whether the device lacks what limn refuses to draw without, by Unity's name for it.
inline bool Lacks(const char* shaderFeature)
{
    const auto& missing = SharedDevice().missingShaderFeatures();
    return std::find(missing.begin(), missing.end(), shaderFeature) != missing.end();
}

/// Skips a test that draws with geometry functions where the device has none.
#define LIMN_NEEDS_GEOMETRY()                                                                      \
    if (Lacks("geometry"))                                                                         \
    GTEST_SKIP() << "the device reports no geometryShader"

/// Base of tests that draw: skipped with the reason where there is no device, failed instead where
/// LIMN_REQUIRE_DEVICE=1; afterwards the validation layer must have been silent.
class GpuTest : public testing::Test
{
protected:
    void SetUp() override
    {
        if (Environment().device() != nullptr)
        {
            return;
        }
        const char* required = std::getenv("LIMN_REQUIRE_DEVICE");
        if (required != nullptr && std::string(required) == "1")
        {
            FAIL() << "LIMN_REQUIRE_DEVICE=1 and " << Environment().reason();
        }
        GTEST_SKIP() << Environment().reason();
    }

    void TearDown() override
    {
        if (Environment().device() != nullptr)
        {
            ExpectNoValidationMessages();
        }
    }
};

} // namespace limn::test
