#pragma once

#include <limn/core/Material.h>
#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/features/OutlinedObjects.h>
#include <unordered_map>
#include <vector>

namespace limn
{

class SelectionOutline;

/// How the selected objects get into the stencil texture.
enum class SelectionStencil
{
    DrawRenderer,  ///< one by one, as in the article
    HighlightLayer ///< by a second camera that sees a layer into which they are moved meanwhile
};

/// When, around what and with which shaders the outline is drawn.
struct SelectionOutlineSettings : OutlineSettings
{
    SelectionOutlineSettings();

    std::shared_ptr<const Shader> m_StencilShader;   ///< null: limn's own; so are the other two
    std::shared_ptr<const Shader> m_BlurShader;      ///< reads _MainTex, _OffsetScale
    std::shared_ptr<const Shader> m_CompositeShader; ///< reads _MainTex (the picture), _StencilTex,
                                                     ///< _BlurTex, _OutlineStrength
    /// What has an outline of its own where it stands before or beside other selected objects;
    /// Together is the article's, which melts there.
    OutlineGrouping m_Grouping = OutlineGrouping::Together;
    /// Seconds between the start of one object of the scene and that of the next, for those that
    /// have no start time.
    float m_PhaseStep = 0.0f;
    SelectionStencil m_Stencil = SelectionStencil::DrawRenderer;
    int m_HighlightingLayer = 7; ///< 0...31
    /// False: what is in that layer anyway is drawn in its own material and gets an edge of it, the
    /// flaw that the article describes.
    bool m_OnlySelected = true;

    /// Since when an object with all that hangs below it is selected, seconds; copies share it.
    std::shared_ptr<std::unordered_map<const Transform*, double>> startTimes;

    void Describe(Inspector& inspector);
};

/// The article's image effect, step by step. Its textures are as large as the picture:
/// R8G8B8A8_UNorm, which is what the article's project in gamma space gets.
/// @source OutlineEffect of the article on outlines of selected objects (Unity)
class OutlineEffect final : public ScriptableRenderPass
{
public:
    static constexpr const char* k_Shader = "Hidden/Limn/SelectionOutline";

    /// @throws ContractError if a layer is outside 0...31
    OutlineEffect(const std::string& featureName, const SelectionOutlineSettings& settings,
                  std::shared_ptr<const Shader> shader);

    /// @return why nothing is drawn, "" if something is
    std::string Setup(const SelectionOutline& volumeComponent, const RenderingData& renderingData);

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override;
    void OnCameraCleanup(CommandBuffer& cmd) override;

    /// Of the article's angle at t seconds, 2 t, the part that sines see, radians.
    static double Phase(double seconds);

private:
    /// A shader's pass with its values.
    struct Step
    {
        std::shared_ptr<Material> material;
        int pass = 0;
    };
    /// Objects with one silhouette.
    struct Group
    {
        std::span<const OutlinedObject> objects;
        double depth = 0.0; ///< of its nearest part, metres before the camera
    };

    Step MakeStep(const std::shared_ptr<const Shader>& given, int pass) const;
    void FindGroups(const RenderingData& renderingData);
    void RenderStencil(ScriptableRenderContext& context, const Group& group,
                       RenderingData& renderingData);
    void RenderBlur(CommandBuffer& cmd, RenderTexturePool& pool);
    void RenderComposite(CommandBuffer& cmd, const RTHandle& destination, RenderingData& data);
    void DrawStencils(CommandBuffer& cmd, std::span<const OutlinedObject> objects, double time);
    void DrawStencil(CommandBuffer& cmd, const RendererItem& item, double time);
    double StartTimeOf(const RendererItem& item) const;

    SelectionOutlineSettings m_Settings;
    std::shared_ptr<const Shader> m_Shader;
    Step m_StencilStep;
    Step m_BlurStep;
    Step m_CompositeStep;
    std::shared_ptr<const Material> m_CopyMaterial; ///< null: the composite blends in place
    int m_Width = 0;                                ///< of the picture, pixels
    int m_Height = 0;
    int m_BlurCount = 0;
    std::vector<OutlinedObject> m_Objects;
    std::vector<Group> m_Groups; ///< the farthest first
    MaterialPropertyBlock m_Properties;
    TemporaryTexture m_StencilTex;
    TemporaryTexture m_BlurTex;
};

} // namespace limn
