#pragma once

#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/editor_stub/AssetContext.h>

namespace limn::test
{

/// The settings of a C# feature with a field of its own and `public Settings settings`, a class
/// that has a class in it.
struct DescribedValues
{
    bool beside = false;
    float width = 1.0f;
    LayerMask layers;
    glm::vec2 tiling{1};
};

class DescribedFeature : public ScriptableRendererFeature
{
public:
    DescribedValues values;

    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
};

/// Describe with a group for each class.
class GroupedFeature final : public DescribedFeature
{
public:
    void Describe(Inspector& inspector) override
    {
        inspector.Field("beside", values.beside, "");
        inspector.BeginGroup("settings");
        inspector.Field("m_Width", values.width, {0, 10}, "");
        inspector.BeginGroup("filter");
        inspector.Field("m_Layers", values.layers, "");
        inspector.EndGroup();
        inspector.EndGroup();
    }
};

/// Describe of the same settings without a group.
class FlatFeature final : public DescribedFeature
{
public:
    void Describe(Inspector& inspector) override
    {
        inspector.Field("beside", values.beside, "");
        inspector.Field("m_Width", values.width, {0, 10}, "");
        inspector.Field("m_Layers", values.layers, "");
        inspector.Field("m_Tiling", values.tiling, "");
    }
};

inline void RegisterForms(AssetContext& assets)
{
    assets.features().Register<GroupedFeature>("GroupedFeature");
    assets.features().Register<FlatFeature>("FlatFeature");
}

/// A Unity renderer asset with one feature, `F`, of the class whose script has guid aa: below the
/// eight lines of a head, these.
inline std::string AssetOfFeature(const std::string& lines)
{
    return "%YAML 1.1\n"
           "%TAG !u! tag:unity3d.com,2011:\n"
           "--- !u!114 &5\n"
           "MonoBehaviour:\n"
           "  m_ObjectHideFlags: 0\n"
           "  m_Script: {fileID: 11500000, guid: aa, type: 3}\n"
           "  m_Name: F\n"
           "  m_Active: 1\n" +
           lines +
           "--- !u!114 &11400000\n"
           "MonoBehaviour:\n"
           "  m_Name: R\n"
           "  m_RendererFeatures:\n"
           "  - {fileID: 5}\n";
}

} // namespace limn::test
