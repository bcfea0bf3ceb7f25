#include "Mentions.h"
#include "Problems.h"
#include "parameters/AllParameters.h"

#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/volume/VolumeProfileLoader.h>

namespace limn
{

namespace
{

using test::Mentions;
using testing::ElementsAre;

struct References : VolumeComponent
{
    Texture2DParameter ramp{this, "m_Ramp", {}};
    CubemapParameter sky{this, "m_Sky", {}};
    RenderTextureParameter target{this, "m_Target", {}};
    MaterialParameter material{this, "m_Material", {}};
    LayerMaskParameter layers{this, "m_Layers", {}};
    struct Inner : VolumeComponent
    {
        TextureParameter noise{this, "noise", {}};
    };
    ObjectParameter<Inner> inner{this, "m_Inner", nullptr};
};

struct Registry : VolumeComponentRegistry
{
    Registry() { Register<References>("References"); }
};

const Registry k_Registry;

/// Knows a layer and the texture "white.png"; everything else is missing.
struct Scene : ProfileContext
{
    std::optional<int> FindLayer(std::string_view name) const override
    {
        return name == "Furniture" ? std::optional(6) : std::nullopt;
    }
    std::vector<std::string_view> layerNames() const override { return {"Furniture"}; }
    bool loadsAssets() const override { return true; }
    LoadedAsset<Texture> LoadTexture(const AssetLocation& location) const override
    {
        if (!location.guid.empty())
        {
            return {nullptr, "stays without a texture, nobody knows the guid"};
        }
        if (location.path != "white.png")
        {
            throw AssetError(location.path, {}, "there is no such file");
        }
        return {DefaultTexture("white"), {}};
    }
    LoadedAsset<Material> LoadMaterial(const AssetLocation& location) const override
    {
        throw AssetError({{Severity::Error, location.path, {3, 4}, "bad"},
                          {Severity::Error, location.path, {5, 6}, "worse"}});
    }
};

const References& In(const VolumeProfileLoadResult& result)
{
    return *result.profile->TryGet<References>();
}

TEST(ProfileContext, LoadsTheTexturesAProfileNames)
{
    const Scene scene;
    const auto result = ParseVolumeProfile(
        "References: {ramp: white.png, inner: {noise: white.png}}\n", "x.yaml", k_Registry, scene);
    EXPECT_EQ(DefaultTexture("white"), In(result).ramp.value().asset);
    EXPECT_EQ("white.png", In(result).ramp.value().location.path);
    EXPECT_EQ(DefaultTexture("white"), In(result).inner.value()->noise.value().asset);
    EXPECT_EQ(nullptr, In(result).sky.value().asset);
    EXPECT_TRUE(result.notes.empty());
}

TEST(ProfileContext, OfAProfileOnItsOwnLoadsNothing)
{
    const auto result =
        ParseVolumeProfile("References: {ramp: none.png, sky: none.png}\n", "x.yaml", k_Registry);
    EXPECT_EQ("none.png", In(result).ramp.value().location.path);
    EXPECT_EQ(nullptr, In(result).ramp.value().asset);
    EXPECT_TRUE(result.notes.empty());
}

TEST(ProfileContext, MakesEveryProblemOfAReferenceAnErrorWhereItStands)
{
    const Scene scene;
    EXPECT_THAT(test::Problems(
                    [&]
                    {
                        ParseVolumeProfile("References:\n  ramp: none.png\n  material: a.mat\n",
                                           "x.yaml", k_Registry, scene);
                    }),
                ElementsAre("2:9: References.m_Ramp: none.png: there is no such file",
                            "3:13: References.m_Material: a.mat:3:4: bad",
                            "3:13: References.m_Material: a.mat:5:6: worse"));
}

TEST(ProfileContext, NotesAReferenceThatStaysUnloaded)
{
    const Scene scene;
    const auto result =
        ParseVolumeProfile("References:\n  ramp: {fileID: 1, guid: ab, type: 3}\n  sky: a.png\n"
                           "  target: b.png\n",
                           "x.yaml", k_Registry, scene);
    EXPECT_THAT(
        test::Texts(result.notes),
        ElementsAre(
            Mentions("2:9: References.m_Ramp", "nobody knows the guid"),
            Mentions("3:8: References.m_Sky", "without a texture", "Cubemap", "flat"),
            Mentions("4:11: References.m_Target", "without a texture", "RenderTexture", "flat")));
    EXPECT_EQ("a.png", In(result).sky.value().location.path);
}

TEST(ProfileContext, IsNotAskedForWhatAUnityProfileDoesNotOverride)
{
    const Scene scene;
    const auto load = [&](const std::string& state)
    {
        return ParseVolumeProfile("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"
                                  "--- !u!114 &2\nMonoBehaviour:\n  m_Name: References\n"
                                  "  active: 1\n  m_Ramp:\n    m_OverrideState: " +
                                      state +
                                      "\n    m_Value: {fileID: 1, guid: ab, type: 3}\n"
                                      "--- !u!114 &1\nMonoBehaviour:\n  m_Name: P\n"
                                      "  components:\n  - {fileID: 2}\n",
                                  "x.asset", k_Registry, scene);
    };
    EXPECT_EQ(0u, load("0").notes.size());
    EXPECT_EQ(1u, load("1").notes.size());
    EXPECT_EQ("ab", In(load("0")).ramp.value().location.guid);
}

TEST(ProfileContext, SaysWhatTheNamesOfLayersMean)
{
    const Scene scene;
    const auto read = [&](const std::string& layers, const ProfileContext& context)
    {
        return In(ParseVolumeProfile("References: {layers: " + layers + "}\n", "x.yaml", k_Registry,
                                     context))
            .layers.value();
    };
    EXPECT_EQ(LayerMask(64 | 2), read("[Furniture, 1]", scene));
    EXPECT_EQ(LayerMask(64), read("Furniture", scene));
    EXPECT_EQ(LayerMask(32), read("UI", {}));
    EXPECT_THAT(test::Problems([&] { read("[1, Furnitur]", scene); }),
                ElementsAre(Mentions("1:26: References.m_Layers", "unknown layer", "'Furnitur'",
                                     "'Furniture'")));
    EXPECT_THAT(test::Problems([&] { read("Furniture", {}); }),
                ElementsAre(Mentions("1:22: References.m_Layers", "unknown layer", "'Furniture'",
                                     "Default, TransparentFX, Ignore Raycast, Water, UI")));
}

} // namespace

} // namespace limn
