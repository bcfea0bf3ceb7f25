#include "CachedCompiler.h"
#include "Paths.h"
#include "golden/GoldenImage.h"
#include "precision/DevicePrecision.h"

#include <gtest/gtest.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/Overrides.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeManager.h>

using namespace limn;
using namespace limn::test;

namespace
{

constexpr int k_FurnitureWidth = 480;
constexpr int k_FurnitureHeight = 270;

AssetContext& Assets()
{
    static AssetContext assets(test::CachedCompiler());
    return assets;
}

/// The furniture sample, to be changed before it is drawn once.
class Furniture
{
public:
    Furniture()
        : asset(LoadScene(test::SourcePath("samples/furniture/furniture.scene.yaml"), Assets()))
    {
    }

    void Use(const std::string& profile) { ReplaceProfile(asset, profile, Assets()); }

    Image Draw()
    {
        UniversalRenderer renderer(Assets().compiler());
        for (auto& feature : asset.renderer.features)
        {
            renderer.AddFeature(std::move(feature));
        }
        VolumeManager manager(Assets().volumeComponents());
        for (const Volume& volume : asset.volumes)
        {
            manager.Register(&volume);
        }
        VolumeStack stack = manager.CreateStack();
        manager.Update(stack, asset.camera.transform.position(), asset.camera.volumeLayerMask);

        UniversalRenderPipeline pipeline(SharedDevice());
        RenderRequest request;
        request.scene = &asset.scene;
        request.camera = &asset.camera;
        request.width = k_FurnitureWidth;
        request.height = k_FurnitureHeight;
        request.volumeStack = &stack;
        const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
        return SharedDevice().ReadBack(*result.output.rt());
    }

    /// Leaves only the opaque objects below the one of this name: its shadow is not outlined.
    void KeepOnly(const std::string& name)
    {
        const Transform* root = &asset.scene.Find(name)->transform;
        for (const auto& object : asset.scene.objects())
        {
            bool below = false;
            for (const Transform* t = &object->transform; t != nullptr; t = t->parent)
            {
                below = below || t == root;
            }
            const bool opaque = object->renderer && !object->renderer->sharedMaterials.empty() &&
                                object->renderer->sharedMaterials[0]->renderQueue() <= 2500;
            object->activeSelf = object->activeSelf && below && opaque;
        }
    }

    SceneAsset asset;
};

/// One value a pixel: whether it is set.
using Bits = std::vector<bool>;

Bits PixelsThatDiffer(const Image& a, const Image& b)
{
    Bits bits(static_cast<std::size_t>(k_FurnitureWidth * k_FurnitureHeight));
    for (std::size_t i = 0; i < bits.size(); ++i)
    {
        for (std::size_t channel = 0; channel < 3; ++channel)
        {
            bits[i] = bits[i] || a.texels[i * 4 + channel] != b.texels[i * 4 + channel];
        }
    }
    return bits;
}

/// The bits with everything within `radius` pixels of a set one set as well.
Bits Grown(const Bits& bits, int radius)
{
    Bits grown(bits.size());
    for (int y = 0; y < k_FurnitureHeight; ++y)
    {
        for (int x = 0; x < k_FurnitureWidth; ++x)
        {
            for (int dy = -radius; dy <= radius; ++dy)
            {
                for (int dx = -radius; dx <= radius; ++dx)
                {
                    const int nx = x + dx;
                    const int ny = y + dy;
                    if (nx >= 0 && nx < k_FurnitureWidth && ny >= 0 && ny < k_FurnitureHeight &&
                        bits[static_cast<std::size_t>(ny * k_FurnitureWidth + nx)])
                    {
                        grown[static_cast<std::size_t>(y * k_FurnitureWidth + x)] = true;
                    }
                }
            }
        }
    }
    return grown;
}

Image DrawWithoutOutline(Furniture& furniture)
{
    const std::string off[] = {"ScreenSpaceOutline.m_Enable=false"};
    ApplyOverrides(furniture.asset, off, Assets());
    return furniture.Draw();
}

/// Where the sofa is, hidden or not: drawn alone, against its empty background.
Bits SofaSilhouette()
{
    Furniture sofa;
    sofa.KeepOnly("Sofa");
    const Image alone = DrawWithoutOutline(sofa);
    Furniture nothing;
    for (const auto& object : nothing.asset.scene.objects())
    {
        object->activeSelf = false;
    }
    return PixelsThatDiffer(alone, DrawWithoutOutline(nothing));
}

class FurnitureGpu : public GpuTest
{
};

TEST_F(FurnitureGpu, LooksLikeTheGoldenWithTheCanPlaceProfile)
{
    ExpectGolden("furniture_can_place", Furniture().Draw(), HasCoarseCorners());
}

TEST_F(FurnitureGpu, LooksLikeTheGoldenWithTheCannotPlaceProfile)
{
    Furniture furniture;
    furniture.Use("cannot_place.profile.yaml");
    ExpectGolden("furniture_cannot_place", furniture.Draw(), HasCoarseCorners());
}

TEST_F(FurnitureGpu, OutlinesTheWholeSofaAlsoWhereItIsHiddenAndNothingElse)
{
    Furniture with;
    Furniture without;
    const Bits outlined = PixelsThatDiffer(with.Draw(), DrawWithoutOutline(without));
    const Bits sofa = SofaSilhouette();

    Bits outside(sofa.size());
    for (std::size_t i = 0; i < sofa.size(); ++i)
    {
        outside[i] = !sofa[i];
    }
    const Bits nearOutlined = Grown(outlined, 2);
    const Bits nearSofa = Grown(sofa, 5);
    const Bits nearOutside = Grown(outside, 5);
    const Bits beside = Grown(outside, 1);
    int edgePixels = 0;
    int uncovered = 0;
    int stray = 0;
    for (std::size_t i = 0; i < sofa.size(); ++i)
    {
        const bool edge = sofa[i] && beside[i];
        edgePixels += edge ? 1 : 0;
        uncovered += edge && !nearOutlined[i] ? 1 : 0;
        stray += outlined[i] && !(nearSofa[i] && nearOutside[i]) ? 1 : 0;
    }
    EXPECT_GT(edgePixels, 200);
    EXPECT_EQ(uncovered, 0) << "of " << edgePixels << " pixels of the sofa's border";
    EXPECT_EQ(stray, 0) << "pixels changed away from the sofa's border";
}

} // namespace
