#pragma once

#include <limn/core/Material.h>
#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Features.h>
#include <limn/features/OutlineComponent.h>
#include <limn/features/OutlinedObjects.h>
#include <limn/volume/VolumeStack.h>

namespace limn
{

/// Returns a shader that comes with limn.
/// @throws ContractError if the renderer has no compiler, or there is no such shader
std::shared_ptr<const Shader> FindTechniqueShader(const ScriptableRenderer& renderer,
                                                  std::string_view name);

/// The pass of a technique that draws with one material.
class OutlineTechniquePass : public ScriptableRenderPass
{
protected:
    OutlineTechniquePass(const std::string& featureName, const OutlineSettings& settings,
                         std::shared_ptr<const Shader> shader);

    /// Draws the objects that pass the filter with a pass of the material in place of their own.
    void DrawFiltered(ScriptableRenderContext& context, const RenderingData& renderingData,
                      const FilteringSettings& filtering, int shaderPass) const;
    /// Enables the material's keyword of a choice, and disables those of the other choices.
    /// @param setting  "RimOutline.m_Variant"
    /// @param choices  "Soft 0, Threshold 1 or Pixels 2"
    /// @throws ContractError if there is no keyword of that number
    void EnableOneOf(std::span<const char* const> keywords, std::size_t chosen,
                     std::string_view setting, std::string_view choices) const;

    std::shared_ptr<Material> m_Material;
    OutlinedObjects m_Found; ///< of this frame, kept for its memory
};

/// The feature of a technique. It draws while a volume switches its component on, and otherwise
/// reports why it does not draw.
/// @tparam ItsComponent  derives from OutlineComponent; registered under the name of its class,
///     which the feature's default name begins with
/// @tparam ItsSettings   derives from OutlineSettings
template <typename ItsComponent, typename ItsSettings>
class OutlineTechniqueFeature : public ScriptableRendererFeature
{
public:
    using Component = ItsComponent;
    using Settings = ItsSettings;

    explicit OutlineTechniqueFeature(Settings settings = {}) : m_Settings(std::move(settings))
    {
        name = ComponentName() + "RendererFeature";
    }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        const auto* component = renderingData.volumeStack->template GetComponent<Component>();
        std::string why = WhyInactive(component, ComponentName());
        if (why.empty())
        {
            why = AddTechnique(*component, renderer, renderingData);
        }
        if (!why.empty())
        {
            renderingData.report->notes.push_back(name + ": it is not drawn; " + why);
        }
    }

    float cullingMargin(const VolumeStackPointer& volumeStack) const override
    {
        const auto* component = volumeStack->template GetComponent<Component>();
        return WhyInactive(component, "").empty() ? component->reach() : 0.0f;
    }

    void Describe(Inspector& inspector) override { m_Settings.Describe(inspector); }

    const Settings& settings() const { return m_Settings; }

protected:
    /// Enqueues what draws. @return why nothing is drawn; "" = something is
    virtual std::string AddTechnique(const Component& component, ScriptableRenderer& renderer,
                                     RenderingData& renderingData) = 0;

private:
    static const std::string& ComponentName()
    {
        static const std::string type = TypeName(typeid(Component));
        return type;
    }

    Settings m_Settings;
};

/// The feature of a technique that draws with one pass.
/// @tparam Pass       a ScriptableRenderPass with
///                    static constexpr const char* k_Shader: the name of its shader;
///                    Pass(const std::string& featureName, const Settings&,
///                         std::shared_ptr<const Shader>);
///                    std::string Setup(const Component&, RenderingData&): why nothing is drawn, or
///                    "" after which the pass is enqueued
template <typename ItsComponent, typename ItsSettings, typename Pass>
class OutlineRendererFeature : public OutlineTechniqueFeature<ItsComponent, ItsSettings>
{
public:
    using OutlineTechniqueFeature<ItsComponent, ItsSettings>::OutlineTechniqueFeature;

    void Create() override { m_Pass.reset(); }

    /// Returns the pass, or null before the first frame in which it draws; for tests and dumps.
    const Pass* pass() const { return m_Pass.get(); }

private:
    std::string AddTechnique(const ItsComponent& component, ScriptableRenderer& renderer,
                             RenderingData& renderingData) override
    {
        if (!m_Pass)
        {
            m_Pass = std::make_unique<Pass>(this->name, this->settings(),
                                            FindTechniqueShader(renderer, Pass::k_Shader));
        }
        std::string why = m_Pass->Setup(component, renderingData);
        if (why.empty())
        {
            renderer.EnqueuePass(*m_Pass);
        }
        return why;
    }

    std::unique_ptr<Pass> m_Pass;
};

} // namespace limn
