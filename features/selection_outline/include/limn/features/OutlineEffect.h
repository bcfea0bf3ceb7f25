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

/// The way in which the selected objects are drawn into the stencil texture.
enum class SelectionStencil
{
    DrawRenderer,  ///< one by one, as in the article
    HighlightLayer ///< by a second camera that sees one layer, into which they are moved meanwhile
};

/// The settings for when, around which objects and with which shaders the outline is drawn.
struct SelectionOutlineSettings : OutlineSettings
{
    SelectionOutlineSettings();

    /// The shader that draws the stencil; null stands for limn's own, also in the other two
    /// members.
    std::shared_ptr<const Shader> m_StencilShader;
    std::shared_ptr<const Shader> m_BlurShader;      ///< reads _MainTex, _OffsetScale
    std::shared_ptr<const Shader> m_CompositeShader; ///< reads _MainTex (the picture), _StencilTex,
                                                     ///< _BlurTex, _OutlineStrength
    /// The grouping of selected objects. A group has an outline of its own where it stands before
    /// or beside other groups. Together is the article's; its outlines merge there.
    OutlineGrouping m_Grouping = OutlineGrouping::Together;
    /// The time between the start of one object of the scene and that of the next, in seconds, for
    /// objects without a start time.
    float m_PhaseStep = 0.0f;
    SelectionStencil m_Stencil = SelectionStencil::DrawRenderer;
    int m_HighlightingLayer = 7; ///< 0...31
    /// Draws only selected objects. If false, other objects of that layer are drawn with their own
    /// material and get an edge of it, which is the flaw that the article describes.
    bool m_OnlySelected = true;

    /// The time since which an object and everything below it is selected, in seconds. Copies of
    /// the settings share it.
    std::shared_ptr<std::unordered_map<const Transform*, double>> startTimes;

    void Describe(Inspector& inspector);
};

/// Performs the article's image effect step by step. Its textures are as large as the picture and
/// R8G8B8A8_UNorm, as in the article's project, which is in gamma space.
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

    /// Returns the article's angle at t seconds, 2 t, reduced to the part that matters to sines, in
    /// radians.
    static double Phase(double seconds);

private:
    /// A pass of a shader, with the values of its properties.
    struct Step
    {
        std::shared_ptr<Material> material;
        int pass = 0;
    };

    Step MakeStep(const std::shared_ptr<const Shader>& given, int pass) const;
    void RenderStencil(ScriptableRenderContext& context, const OutlinedGroup& group,
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
    int m_Width = 0;                                ///< the width of the picture in pixels
    int m_Height = 0;
    int m_BlurCount = 0;
    OutlinedObjects m_Found;             ///< of this frame, kept for its memory
    std::vector<OutlinedGroup> m_Groups; ///< the farthest first
    MaterialPropertyBlock m_Properties;
    TemporaryTexture m_StencilTex;
    TemporaryTexture m_BlurTex;
};

} // namespace limn
