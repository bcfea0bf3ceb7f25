#pragma once

// Tests of what a renderer feature draws, without a GPU: put renderers into a TestScene, render it
// and ask the frame. The checks work with any test framework; EXPECT_TRUE of GoogleTest prints
// their sentences.

#include <limn/core/Culling.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/volume/VolumeManager.h>
#include <ostream>

namespace limn
{

/// The result of a check, and a sentence with its reason: "Outline must draw Lamp, but the filter's
/// layer mask leaves it out".
class CheckResult
{
public:
    CheckResult(bool holds, std::string sentence) : m_Holds(holds), m_Sentence(std::move(sentence))
    {
    }

    explicit operator bool() const { return m_Holds; }
    const std::string& sentence() const { return m_Sentence; }

    /// Converts to testing::AssertionResult, so that EXPECT_TRUE and EXPECT_FALSE print the
    /// sentence.
    template <typename Result>
    requires requires(const Result& result) { result.failure_message(); }
    operator Result() const { return Result(m_Holds) << m_Sentence; }
    friend std::ostream& operator<<(std::ostream& stream, const CheckResult& result)
    {
        return stream << result.m_Sentence;
    }

private:
    bool m_Holds;
    std::string m_Sentence;
};

/// The description of a renderer. By default it is a cube at the origin, in layer 0 and rendering
/// layer 0, with an opaque material.
struct ARenderer
{
    explicit ARenderer(std::string rendererName) : name(std::move(rendererName)) {}

    /// @throws ContractError if the index is outside 0...31
    ARenderer& OnLayer(int index);
    /// Adds a rendering layer to those that it has.
    /// @throws ContractError if the index is outside 0...31
    ARenderer& WithRenderingLayer(int index);
    /// @param renderQueue  the queue of its material, 0...5000
    ARenderer& WithQueue(int renderQueue) { return queue = renderQueue, *this; }
    /// @param worldPosition  its position in the world, in metres
    ARenderer& At(const glm::vec3& worldPosition) { return position = worldPosition, *this; }

    std::string name;
    int layer = 0;
    RenderingLayerMask renderingLayerMask{1};
    int queue = 2000;
    glm::vec3 position{0.0f};
};

/// Returns whether a filter takes a renderer by its queue, layer and rendering layers.
CheckResult Takes(const FilteringSettings& filter, const ARenderer& renderer);

/// A frame of a TestScene. It is valid as long as the scene is neither changed nor destroyed.
struct TestFrame
{
    RenderResult result;
    const Scene* scene = nullptr; ///< never null
    CullingResults seen;          ///< the objects that the camera sees
};

/// A scene with a camera that looks along z from 10 m away, the renderer that draws it, the volume
/// components that come with limn, and a device that draws nothing.
class TestScene
{
public:
    TestScene();

    GameObject& Add(const ARenderer& renderer);
    /// Adds a global volume whose profile is this YAML text.
    /// @throws AssetError if the profile is wrong
    void AddVolume(std::string_view profile);
    /// Returns a shader that comes with limn, or null if the name is unknown.
    std::shared_ptr<const Shader> FindShader(std::string_view name) const;

    /// Renders a frame.
    /// @throws ContractError, AssetError as UniversalRenderPipeline::RenderSingleCamera does
    TestFrame Render();

    VolumeComponentRegistry components; ///< more may be registered before the first AddVolume
    Scene scene;
    Camera camera;
    UniversalRenderer renderer; ///< features are added to it
    glm::ivec2 size{256, 256};  ///< the size of the picture in pixels

private:
    VolumeManager m_Volumes;
    std::vector<std::unique_ptr<Volume>> m_OwnVolumes;
    RecordingDevice m_Device;
    UniversalRenderPipeline m_Pipeline;
};

/// Returns whether a feature, or a pass of this name, draws every renderer of that name.
/// @throws ContractError if the scene has no such renderer, or the frame no such feature or pass
CheckResult DrawnBy(const TestFrame& frame, std::string_view feature, std::string_view renderer);

} // namespace limn
