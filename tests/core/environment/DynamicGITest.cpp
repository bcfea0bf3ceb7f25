#include "core/ThrownMessage.h"
#include "core/scene/TestScene.h"

#include <gtest/gtest.h>
#include <limn/core/DynamicGI.h>
#include <limn/core/RecordingDevice.h>

#include "Mentions.h"

namespace limn::test
{
namespace
{

TEST(DynamicGI, IsNeededWhereASkyLightsOrIsMirrored)
{
    RenderSettings settings;
    settings.ambientMode = AmbientMode::Skybox;
    EXPECT_FALSE(DynamicGI::NeedsEnvironment(settings)) << "there is no sky";
    settings.skybox = std::make_shared<Material>(
        ShaderOf("Shader \"Test/Sky\" { SubShader { Pass { HLSLPROGRAM ENDHLSL } } }"));
    EXPECT_TRUE(DynamicGI::NeedsEnvironment(settings));
    settings.ambientMode = AmbientMode::Flat;
    EXPECT_FALSE(DynamicGI::NeedsEnvironment(settings));
    settings.defaultReflectionMode = DefaultReflectionMode::Skybox;
    EXPECT_TRUE(DynamicGI::NeedsEnvironment(settings));
}

TEST(DynamicGI, KeepsTheLightWhereNothingIsDrawn)
{
    Scene scene;
    scene.skybox = std::make_shared<Material>(
        ShaderOf("Shader \"Test/Sky\" { SubShader { Pass { HLSLPROGRAM ENDHLSL } } }"));
    scene.ambientMode = AmbientMode::Skybox;
    scene.defaultReflectionMode = DefaultReflectionMode::Skybox;
    scene.ambientProbe.AddAmbientLight(Color::red);
    RecordingDevice device;
    DynamicGI::UpdateEnvironment(device, Compiler(), scene);
    EXPECT_TRUE(device.frames().empty());
    EXPECT_EQ(1.0f, scene.ambientProbe(0, 0));
    EXPECT_EQ(nullptr, scene.skyReflection);
}

TEST(DynamicGI, WantsAResolutionThatHalves)
{
    Scene scene;
    RecordingDevice device;
    for (const int resolution : {0, -4, 100, 4096})
    {
        scene.defaultReflectionResolution = resolution;
        EXPECT_THAT(ThrownMessage<ContractError>(
                        [&] { DynamicGI::UpdateEnvironment(device, Compiler(), scene); }),
                    Mentions("UpdateEnvironment", "defaultReflectionResolution",
                             std::to_string(resolution), "power of two", "1 to 2048"));
    }
}

} // namespace
} // namespace limn::test
