#include <gtest/gtest.h>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>
#include <map>

namespace limn
{
namespace
{

/// Gives settings what a file would.
class Giver final : public Inspector
{
public:
    explicit Giver(std::shared_ptr<const Material> material) : m_Material(std::move(material)) {}
    void Field(const FieldInfo& field, FieldValue value) override
    {
        tooltip = field.tooltip;
        if (auto* material = std::get_if<std::shared_ptr<const Material>*>(&value))
        {
            **material = m_Material;
        }
    }

    std::string tooltip;

private:
    std::shared_ptr<const Material> m_Material;
};

} // namespace

TEST(Inspector, GivesMaterialsWhosePropertiesAFeatureSets)
{
    const auto shader = Shader::FromText(
        "Shader \"Test/Tint\" { Properties { _Width(\"\", Float) = 2 } SubShader { Pass { "
        "HLSLPROGRAM\n#pragma vertex v\n#pragma fragment f\nfloat4 v() : SV_Position { return 0; "
        "}\nfloat4 f() : SV_Target { return 0; }\nENDHLSL } } }",
        "Tint.shader", std::make_shared<ShaderCompiler>());
    const auto asset = std::make_shared<Material>(shader);
    Giver giver(asset);
    Inspector& inspector = giver;
    std::shared_ptr<Material> outlineMaterial;
    inspector.Field("outlineMaterial", outlineMaterial, "Draws the outline");
    EXPECT_EQ(giver.tooltip, "Draws the outline");
    ASSERT_EQ(outlineMaterial, asset);
    outlineMaterial->SetFloat("_Width", 3);
    EXPECT_EQ(asset->GetFloat("_Width"), 3.0f) << "for all that draw with it, as in Unity";
}

TEST(Inspector, TakesTooltipsThatAreNoLiterals)
{
    Giver giver(nullptr);
    Inspector& inspector = giver;
    std::shared_ptr<const Shader> shader;
    const std::string tooltip = "Hidden/Blur"; // nobody knows before it runs
    inspector.Field("shader", shader, tooltip);
    EXPECT_EQ(giver.tooltip, "Hidden/Blur");
}

// Values of Unity's documentation (2022.3).
TEST(Inspector, KnowsTheMembersOfUnitysEnums)
{
    using Members = std::map<std::string_view, int>;
    const auto members = [](std::span<const EnumEntry> entries)
    {
        Members result;
        for (const EnumEntry& entry : entries)
        {
            EXPECT_TRUE(result.emplace(entry.name, entry.value).second) << entry.name;
        }
        return result;
    };
    EXPECT_EQ(members(FilterModeEntries()),
              (Members{{"Point", 0}, {"Bilinear", 1}, {"Trilinear", 2}}));
    EXPECT_EQ(members(TextureWrapModeEntries()),
              (Members{{"Repeat", 0}, {"Clamp", 1}, {"Mirror", 2}, {"MirrorOnce", 3}}));
    EXPECT_EQ(members(CullModeEntries()), (Members{{"Off", 0}, {"Front", 1}, {"Back", 2}}));
    EXPECT_EQ(members(CameraTypeEntries()), (Members{{"Game", 1},
                                                     {"SceneView", 2},
                                                     {"Preview", 4},
                                                     {"Reflection", 16},
                                                     {"Everything", -1}}));
    const Members blends = members(BlendModeEntries());
    EXPECT_EQ(blends.size(), 11u);
    EXPECT_EQ(blends.at("SrcAlpha"), 5);
    EXPECT_EQ(blends.at("OneMinusSrcAlpha"), 10);
    const Members formats = members(RenderTextureFormatEntries());
    EXPECT_EQ(formats.size(), 26u) << "all but the two of XR";
    EXPECT_EQ(formats.at("RGB111110Float"), 22);
    EXPECT_EQ(formats.at("R16"), 28);
}

} // namespace limn
