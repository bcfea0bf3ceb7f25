#include <gtest/gtest.h>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>

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

} // namespace limn
