#pragma once

#include "shader_graph/GraphFile.h"

namespace limn
{

/// The target of a shader graph for URP: the kind of its surface, and its render state.
class GraphTarget
{
public:
    /// Reads the target of a graph.
    /// @throws AssetError if it has none for URP, or one that limn does not translate
    explicit GraphTarget(const GraphFile& file);

    bool IsLit() const { return m_Kind == "UniversalLitSubTarget"; }
    bool IsSprite() const { return m_Kind.starts_with("UniversalSprite"); }
    bool IsScreen() const { return m_Kind == "UniversalFullscreenSubTarget"; }
    bool IsTransparent() const { return IsSprite() || Setting("m_SurfaceType", 0) != 0; }
    /// Returns whether materials choose the render state.
    bool IsOverridden() const { return !IsScreen() && Setting("m_AllowMaterialOverride", 0) != 0; }
    bool CastsShadows() const
    {
        return !IsSprite() && !IsScreen() && (Setting("m_CastShadows", 1) != 0 || IsOverridden());
    }
    bool WritesDepth() const;

    /// Returns the tags of the SubShader.
    std::string TagsText() const;
    /// Returns the cull mode, and the rest of the state for a pass that draws colours.
    std::string CullText() const;
    std::string StateText() const;
    /// Returns the #define and #pragma lines that the settings ask for.
    std::string DefinesText() const;
    /// Returns the properties by which materials choose the render state, if they do.
    std::string PropertiesText() const;

private:
    int Setting(const char* name, int otherwise) const;
    int ScreenSetting(const char* name) const;
    int RenderFace() const;
    std::string BlendText() const;
    std::string ScreenBlendText() const;
    std::string StencilText() const;

    const Json* m_Target = nullptr;
    const Json* m_SubTarget = nullptr;
    const Json* m_Screen = nullptr; ///< the settings of a full-screen graph
    std::string m_Kind;
};

} // namespace limn
