#include "Mentions.h"
#include "core/ThrownMessage.h"
#include <cstdlib>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>
#include <optional>

namespace limn::test
{

namespace
{

/// An environment variable set for the life of the object.
class EnvironmentVariable
{
public:
    EnvironmentVariable(const char* name, const char* value) : m_Name(name)
    {
        if (const char* old = std::getenv(name))
        {
            m_Old = old;
        }
        value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    }
    ~EnvironmentVariable() { m_Old ? setenv(m_Name, m_Old->c_str(), 1) : unsetenv(m_Name); }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

private:
    const char* m_Name;
    std::optional<std::string> m_Old;
};

/// The loader reads both at each instance; the newer one wins.
class WithoutDriver : public testing::Test
{
private:
    EnvironmentVariable m_New{"VK_DRIVER_FILES", "/nowhere/driver.json"};
    EnvironmentVariable m_Old{"VK_ICD_FILENAMES", nullptr};
};

} // namespace

TEST_F(WithoutDriver, ADeviceSaysWhatToInstall)
{
    EXPECT_THAT(ThrownMessage<VulkanError>([] { const VulkanDevice device; }),
                Mentions("no Vulkan device", "VK_DRIVER_FILES", "'/nowhere/driver.json'",
                         "mesa-vulkan-drivers"));
}

TEST_F(WithoutDriver, ThereAreNoDevices)
{
    EXPECT_TRUE(EnumerateVulkanDevices().empty());
}

} // namespace limn::test
