#include "Mentions.h"
#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/core/ComputeShader.h>
#include <limn/core/Image.h>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>
#include <limn/core/RenderTexture.h>
#include <limn/editor_stub/UnityRendererData.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

class HaloFeature final : public ScriptableRendererFeature
{
public:
    float m_Radius = 1.0f;
    int m_Rings = 1;

    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_Radius", m_Radius, {0, 5}, "Metres");
        inspector.Field("m_Rings", m_Rings, "How many"); // any number
    }
};

/// A feature with settings of Unity's enums.
class EnumsFeature final : public ScriptableRendererFeature
{
public:
    CameraType m_Cameras = CameraType::Game;
    FilterMode m_Filter = FilterMode::Point;
    RenderTextureFormat m_Format = RenderTextureFormat::ARGB32;

    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_Cameras", m_Cameras, CameraTypeEntries(), "");
        inspector.Field("m_Filter", m_Filter, FilterModeEntries(), "");
        inspector.Field("m_Format", m_Format, RenderTextureFormatEntries(), "");
    }
};

/// Finds its shader by name and sets a material of its settings.
class FindingFeature final : public ScriptableRendererFeature
{
public:
    std::shared_ptr<const Shader> found;
    std::shared_ptr<Material> m_Material;

    void Create() override
    {
        found = Shader::Find("Hidden/ScreenSpaceOutline");
        if (m_Material)
        {
            m_Material->SetFloat("_Width", 7);
        }
    }
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_Material", m_Material, "Drawn with");
    }
};

/// A feature with a setting of each type that is a file or a vector.
class AssetsFeature final : public ScriptableRendererFeature
{
public:
    glm::vec2 m_Tiling{1};
    glm::vec3 m_Wind{0};
    std::shared_ptr<const Texture> m_Noise;
    std::shared_ptr<const RenderTexture> m_Target;
    std::shared_ptr<ComputeShader> m_Compute;

    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_Tiling", m_Tiling, "");
        inspector.Field("m_Wind", m_Wind, "");
        inspector.Field("m_Noise", m_Noise, "");
        inspector.Field("m_Target", m_Target, "");
        inspector.Field("m_Compute", m_Compute, "");
    }
};

constexpr const char* k_Kernel = "#pragma kernel Fill\nRWTexture2D<float> _Result;\n"
                                 "[numthreads(8, 8, 1)] void Fill(uint3 id : SV_DispatchThreadID) "
                                 "{ _Result[id.xy] = 1; }\n";

const AssetsFeature& AssetsOf(const RendererAsset& renderer)
{
    return dynamic_cast<const AssetsFeature&>(*renderer.features.at(0));
}

/// Expects the values of the two tests below.
void ExpectAssets(const AssetsFeature& feature)
{
    EXPECT_EQ(glm::vec2(2, 3), feature.m_Tiling);
    EXPECT_EQ(glm::vec3(0, 0.5f, -1), feature.m_Wind);
    ASSERT_NE(nullptr, feature.m_Noise);
    EXPECT_EQ(TextureDimension::Tex2D, feature.m_Noise->dimension());
    EXPECT_EQ(3, feature.m_Noise->width());
    ASSERT_NE(nullptr, feature.m_Compute);
    EXPECT_TRUE(feature.m_Compute->HasKernel("Fill"));
}

void WriteAssets(const SceneFolder& folder, const std::string& below)
{
    folder.Write(below + "Fill.compute", k_Kernel);
    WritePng(folder / (below + "noise.png"),
             {3, 2, GraphicsFormat::R8G8B8A8_UNorm, std::vector<std::byte>(24)});
}

} // namespace

TEST(OwnFeature, ReadsVectorsTexturesAndComputeShadersFromAScene)
{
    SceneFolder folder;
    folder.assets.features().Register<AssetsFeature>("AssetsFeature");
    WriteAssets(folder, "");
    const std::string begin = "renderer: {features: [{type: AssetsFeature, ";
    const SceneAsset scene =
        folder.LoadWithCamera(begin + "tiling: [2, 3], wind: {x: 0, y: 0.5, z: -1}, "
                                      "noise: noise.png, compute: Fill.compute}]}\n");
    ExpectAssets(AssetsOf(scene.renderer));
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n" + begin +
                                  "tiling: 2, noise: nois.png, compute: noise.png}]}\n"),
                ElementsAre(Mentions("m_Tiling: found '2'", "2 numbers"),
                            Mentions("m_Noise: there is no file 'nois.png'", "'noise.png'"),
                            Mentions("m_Compute: 'noise.png' cannot be used"),
                            Mentions("it has no kernel")));
}

// A file names no type, so that a texture of another kind is none.
TEST(OwnFeature, HasNoRenderTextureWhereAPictureIsNamed)
{
    SceneFolder folder;
    folder.assets.features().Register<AssetsFeature>("AssetsFeature");
    WriteAssets(folder, "");
    const SceneAsset scene = folder.LoadWithCamera(
        "renderer: {features: [{type: AssetsFeature, m_Target: noise.png}]}\n");
    EXPECT_EQ(nullptr, AssetsOf(scene.renderer).m_Target);
}

TEST(OwnFeature, ReadsVectorsTexturesAndComputeShadersFromAUnityRenderer)
{
    SceneFolder folder;
    folder.assets.features().Register<AssetsFeature>("AssetsFeature");
    std::filesystem::create_directories(folder / "Assets");
    WriteAssets(folder, "Assets/");
    folder.Write("Assets/noise.png.meta", "guid: a1\n");
    folder.Write("Assets/Fill.compute.meta", "guid: a2\n");
    folder.Write("Assets/AssetsFeature.cs.meta", "guid: a3\n");
    const std::string begin = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"
                              "--- !u!114 &11400000\nMonoBehaviour:\n  m_Name: R\n"
                              "  m_RendererFeatures:\n  - {fileID: 5}\n"
                              "--- !u!114 &5\nMonoBehaviour:\n"
                              "  m_Script: {fileID: 11500000, guid: a3, type: 3}\n"
                              "  m_Name: A\n  m_Active: 1\n";
    const auto path =
        folder.Write("Assets/r.asset", begin + "  m_Tiling: {x: 2, y: 3}\n"
                                               "  m_Wind: {x: 0, y: 0.5, z: -1}\n"
                                               "  m_Noise: {fileID: 2800000, guid: a1, type: 3}\n"
                                               "  m_Compute: {fileID: 7200000, guid: a2, type: 3}\n"
                                               "  m_Target: {fileID: 0}\n");
    const UnityRendererDataLoadResult result = LoadUnityRendererData(path, folder.assets);
    ExpectAssets(AssetsOf(result.renderer));
    EXPECT_THAT(result.notes, testing::IsEmpty());
    folder.Write("Assets/r.asset", begin + "  m_Noise: {fileID: 2800000, guid: a2, type: 3}\n"
                                           "  m_Target: {fileID: 8400000, guid: a9, type: 2}\n"
                                           "  m_Compute: {fileID: 7200000, guid: a8, type: 3}\n");
    const UnityRendererDataLoadResult other = LoadUnityRendererData(path, folder.assets);
    EXPECT_EQ(nullptr, AssetsOf(other.renderer).m_Compute);
    EXPECT_THAT(Texts(other.notes),
                ElementsAre(Mentions("A.m_Noise: it is left out", "Fill.compute is no picture"),
                            Mentions("A.m_Target: it is left out", "guid 'a9'"),
                            Mentions("A.m_Compute: it is left out", "guid 'a8'")));
}

TEST(OwnFeature, ReadsUnitysEnumsByNameAndByNumber)
{
    SceneFolder folder;
    folder.assets.features().Register<EnumsFeature>("EnumsFeature");
    const auto read = [&folder](const std::string& settings)
    {
        const SceneAsset scene = folder.LoadWithCamera(
            "renderer: {features: [{type: EnumsFeature, " + settings + "}]}\n");
        const auto& enums = dynamic_cast<const EnumsFeature&>(*scene.renderer.features.at(0));
        return std::tuple(static_cast<int>(enums.m_Cameras), enums.m_Filter, enums.m_Format);
    };
    EXPECT_EQ(read("cameras: [Game, SceneView], filter: Trilinear, format: ARGBHalf"),
              std::tuple(3, FilterMode::Trilinear, RenderTextureFormat::ARGBHalf));
    EXPECT_EQ(read("cameras: 17, filter: 1, format: 9"),
              std::tuple(17, FilterMode::Bilinear, RenderTextureFormat::DefaultHDR));
}

TEST(OwnFeature, FindsShadersByNameAndSetsTheMaterialOfItsSettings)
{
    SceneFolder folder;
    folder.assets.features().Register<FindingFeature>("FindingFeature");
    const SceneAsset scene =
        folder.LoadWithCamera("materials: {flat: {shader: Universal Render Pipeline/Unlit}}\n"
                              "renderer: {features: [{type: FindingFeature, m_Material: flat}]}\n");
    ASSERT_EQ(1u, scene.renderer.features.size());
    const auto* feature = dynamic_cast<const FindingFeature*>(scene.renderer.features[0].get());
    ASSERT_NE(nullptr, feature);
    ASSERT_NE(nullptr, feature->found);
    EXPECT_EQ(feature->found, folder.assets.FindShader("Hidden/ScreenSpaceOutline"));
    ASSERT_NE(nullptr, feature->m_Material);
    EXPECT_EQ("flat", feature->m_Material->name());
    EXPECT_NE(nullptr, feature->m_Material->Find("_Width"));
}

TEST(OwnFeature, OfAProgramIsReadFromAScene)
{
    SceneFolder folder;
    folder.assets.features().Register<HaloFeature>("HaloFeature");
    const SceneAsset scene = folder.LoadWithCamera(
        "renderer: {features: [{type: HaloFeature, radius: 2.5, m_Rings: -70000}]}\n");
    ASSERT_EQ(1u, scene.renderer.features.size());
    const auto* halo = dynamic_cast<const HaloFeature*>(scene.renderer.features[0].get());
    ASSERT_NE(nullptr, halo);
    EXPECT_EQ(2.5f, halo->m_Radius);
    EXPECT_EQ(-70000, halo->m_Rings);
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "renderer: {features: [{type: HaloFeature, m_Radius: 6}]}\n"),
                ElementsAre("2:53: renderer.features[0].m_Radius: 6 is outside [0, 5]"));
}

TEST(OwnFeature, IsUnknownToOtherPrograms)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nrenderer: {features: [{type: HaloFeature}]}\n"),
                ElementsAre(testing::HasSubstr("unknown feature 'HaloFeature'")));
}

} // namespace limn::test
