#pragma once

#include "check/ObjectNames.h"

#include <limn/editor_stub/AssetContext.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeManager.h>
#include <optional>

namespace limn
{

/// The verdicts of one or several filters on the renderers of a scene.
struct DrawnFacts
{
    RendererSet drawn;
    std::vector<std::string> reasons; ///< why each renderer is not drawn; "" if it is
};

/// Everything that expectations ask about a scene's frame, found out without a Vulkan device.
class SceneFacts
{
public:
    /// @lifetime  keeps `assets` by reference
    /// @throws AssetError for a shader with errors
    SceneFacts(SceneAsset asset, AssetContext& assets);

    const Explanation& explanation() const { return m_Explanation; }
    const ObjectNames& objects() const { return m_Objects; }
    const std::vector<std::string>& features() const { return m_Features; }
    const LayerNames& layers() const { return m_Layers; }
    AssetContext& assets() const { return m_Assets; }

    /// Returns the names of the passes that run, in their order.
    std::vector<std::string> ExecutedPasses() const;

    /// Returns the passes that ask for renderers, each once: those of a feature, or those of the
    /// whole frame if no feature is given.
    std::vector<std::string> PassesOf(const std::optional<std::string>& feature) const;

    /// Returns the verdicts of a feature's filters, or of one of its passes.
    /// @param feature  if it is not given, any feature and the renderer's own passes
    /// @param pass     if it is not given, any pass of the feature
    DrawnFacts Drawn(const std::optional<std::string>& feature,
                     const std::optional<std::string>& pass) const;

    /// Returns the blended component, or null if the name is not registered.
    /// @param position  in world space, in metres; if it is not given, the point at which the
    ///     camera asks for volumes
    std::unique_ptr<VolumeComponent> Blend(const std::string& component,
                                           const std::optional<glm::vec3>& position);
    /// Returns the names of the volumes that set the value there, or "" if none does.
    std::string SourcesOf(const std::string& component, const std::string& parameter,
                          const std::optional<glm::vec3>& position);

private:
    std::string ReasonOf(const ExplainedObject& object, const std::optional<std::string>& feature,
                         const std::optional<std::string>& pass) const;

    AssetContext& m_Assets;
    std::vector<Volume> m_Volumes;
    LayerNames m_Layers;
    std::vector<std::string> m_Features; ///< names, in the renderer's order
    Explanation m_Explanation;
    ObjectNames m_Objects;
    VolumeManager m_Manager;
};

} // namespace limn
