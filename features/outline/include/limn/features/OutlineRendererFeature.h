#pragma once

#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Features.h>
#include <limn/features/OutlineComponent.h>
#include <limn/features/OutlineSettings.h>
#include <limn/volume/VolumeStack.h>

namespace limn
{

/// Returns a shader that comes with limn.
/// @throws ContractError if the renderer has no compiler, or there is no such shader
std::shared_ptr<const Shader> FindTechniqueShader(const ScriptableRenderer& renderer,
                                                  std::string_view name);

/// The feature of a technique. It draws with its pass while a volume switches its component on, and
/// otherwise reports why it does not draw.
/// @tparam ItsComponent  derives from OutlineComponent; registered under the name of its class
/// @tparam ItsSettings   derives from OutlineSettings
/// @tparam Pass       a ScriptableRenderPass with
///                    static constexpr const char* k_Shader: the name of its shader;
///                    Pass(const std::string& featureName, const Settings&,
///                         std::shared_ptr<const Shader>);
///                    std::string Setup(const Component&, RenderingData&): why nothing is drawn, or
///                    "" after which the pass is enqueued
template <typename ItsComponent, typename ItsSettings, typename Pass>
class OutlineRendererFeature : public ScriptableRendererFeature
{
public:
    using Component = ItsComponent;
    using Settings = ItsSettings;

    OutlineRendererFeature() = default;
    explicit OutlineRendererFeature(Settings settings) : m_Settings(std::move(settings)) {}

    void Create() override { m_Pass.reset(); }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        const auto* component = renderingData.volumeStack->template GetComponent<Component>();
        static const std::string type = TypeName(typeid(Component));
        std::string why = WhyInactive(component, type);
        if (why.empty())
        {
            if (!m_Pass)
            {
                m_Pass = std::make_unique<Pass>(name, m_Settings,
                                                FindTechniqueShader(renderer, Pass::k_Shader));
            }
            why = m_Pass->Setup(*component, renderingData);
        }
        if (!why.empty())
        {
            renderingData.report->notes.push_back(name + ": it is not drawn; " + why);
            return;
        }
        renderer.EnqueuePass(*m_Pass);
    }

    float cullingMargin(const VolumeStackPointer& volumeStack) const override
    {
        const auto* component = volumeStack->template GetComponent<Component>();
        return WhyInactive(component, "").empty() ? component->reach() : 0.0f;
    }

    void Describe(Inspector& inspector) override { m_Settings.Describe(inspector); }

    const Settings& settings() const { return m_Settings; }
    /// Returns the pass, or null before the first frame in which it draws; for tests and dumps.
    const Pass* pass() const { return m_Pass.get(); }

private:
    Settings m_Settings;
    std::unique_ptr<Pass> m_Pass;
};

} // namespace limn
