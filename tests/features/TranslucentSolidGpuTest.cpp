#include "features/LayerScene.h"

using namespace limn;
using namespace limn::test;

namespace
{

int CountStencil(const EffectPicture& picture, int value)
{
    return static_cast<int>(
        std::count(picture.stencil.texels.begin(), picture.stencil.texels.end(), std::byte(value)));
}

void ExpectStencil(const EffectPicture& picture, const StencilModel& model)
{
    int wrong = 0;
    for (int y = 0; y < k_Size; ++y)
    {
        for (int x = 0; x < k_Size; ++x)
        {
            wrong += picture.StencilAt(x, y) == model.StencilAt(x, y) ? 0 : 1;
        }
    }
    EXPECT_EQ(wrong, 0) << "pixels with another stencil value";
}

void ExpectColor(const EffectPicture& picture, const StencilModel& model)
{
    ASSERT_EQ(picture.color.values.size(), model.color().values.size());
    int wrong = 0;
    for (std::size_t i = 0; i < picture.color.values.size(); ++i)
    {
        if (picture.color.values[i] != model.color().values[i] && wrong++ == 0)
        {
            ADD_FAILURE() << "channel " << i % 4 << " of pixel " << i / 4 % k_Size << ", "
                          << i / 4 / k_Size << " is " << picture.color.values[i] << ", not "
                          << model.color().values[i] << "; stencil "
                          << std::to_integer<int>(picture.stencil.texels[i / 4]);
        }
    }
    EXPECT_EQ(wrong, 0) << "values of another colour";
}

void ExpectPrediction(const EffectShaders& shaders, int layerCount)
{
    SCOPED_TRACE(std::to_string(layerCount) + " layers");
    std::mt19937 random(static_cast<unsigned>(layerCount));
    std::vector<Layer> layers;
    for (int i = 0; i < layerCount; ++i)
    {
        layers.push_back(MakeLayer(i, random));
    }
    LayerScene content(shaders, MeshOf(layers, random));

    content.renderer.transparentLayerMask = LayerMask::Nothing();
    const EffectPicture masked = content.Draw(k_Size, k_Size);
    ExpectStencil(masked, Predict(layers, Moment::AfterMasks));
    EXPECT_GT(CountStencil(masked, 255), 50);
    EXPECT_GT(CountStencil(masked, 254), 50);

    content.renderer.transparentLayerMask = LayerMask::Everything();
    const EffectPicture drawn = content.Draw(k_Size, k_Size);
    const StencilModel model = Predict(layers, Moment::AfterAll);
    ExpectStencil(drawn, model);
    EXPECT_EQ(CountStencil(drawn, 254), 0);
    EXPECT_EQ(CountStencil(drawn, 253), CountStencil(masked, 254));
    ExpectColor(drawn, model);
}

class TranslucentSolidGpu : public GpuTest
{
};

TEST_F(TranslucentSolidGpu, HasTheStencilAndColoursThatTheModelPredictsForOneToEightLayers)
{
    for (int count = 1; count <= 8; ++count)
    {
        ExpectPrediction(LimnEffectShaders(), count);
    }
}

TEST_F(TranslucentSolidGpu, HasThemWithTheArticlesShaders)
{
    const EffectShaders article = ArticleShaders();
    if (!article.outline)
    {
        GTEST_SKIP() << "LIMN_CORPUS_DIR names no folder with the article's shaders";
    }
    for (int count = 1; count <= 8; ++count)
    {
        ExpectPrediction(article, count);
    }
}

TEST_F(TranslucentSolidGpu, GivesTheSamePixelsWithTheArticlesShadersInAPerspectiveView)
{
    const EffectShaders article = ArticleShaders();
    if (!article.outline)
    {
        GTEST_SKIP() << "LIMN_CORPUS_DIR names no folder with the article's shaders";
    }
    const auto draw = [](const EffectShaders& shaders)
    {
        TranslucentScene content(shaders);
        content.camera.fieldOfView = 50.0f;
        content.AddBody(CreatePrimitive(PrimitiveType::Torus), {-0.3f, 0.1f, 2.0f})
            .transform.localRotation = EulerToRotation({60, 20, 10});
        content.AddBody(CreatePrimitive(PrimitiveType::Cube), {0.6f, -0.2f, 2.5f});
        content.Add(Rectangle({-1, -1}, {1, 1}), {0, 0, 4}, {TranslucentUnlit(Color::red)});
        return content.Draw(160, 120);
    };
    const EffectPicture ours = draw(LimnEffectShaders());
    const EffectPicture theirs = draw(article);
    EXPECT_GT(CountStencil(ours, 253), 1000);
    EXPECT_EQ(ours.stencil, theirs.stencil);
    EXPECT_EQ(ours.color.values, theirs.color.values);
}

TEST_F(TranslucentSolidGpu, IsTheSameInWhateverOrderItsLayersAreDrawn)
{
    std::mt19937 random(7);
    std::vector<Layer> layers;
    for (int i = 0; i < 8; ++i)
    {
        layers.push_back(MakeLayer(i, random));
    }
    LayerScene content(LimnEffectShaders(), MeshOf(layers, random));
    const EffectPicture first = content.Draw(k_Size, k_Size);
    for (int i = 0; i < 5; ++i)
    {
        content.body->renderer->mesh = MeshOf(layers, random);
        const EffectPicture shuffled = content.Draw(k_Size, k_Size);
        EXPECT_EQ(shuffled.color.values, first.color.values);
        EXPECT_EQ(shuffled.stencil, first.stencil);
    }
}

TEST_F(TranslucentSolidGpu, OfSeveralMeshesIsOneWhereTheSolidsMaskIsRepeated)
{
    std::mt19937 random(11);
    std::vector<Layer> layers;
    for (int i = 0; i < 6; ++i)
    {
        layers.push_back(MakeLayer(i, random));
    }
    const EffectPicture one =
        LayerScene(LimnEffectShaders(), MeshOf(layers, random)).Draw(k_Size, k_Size);

    LayerScene parts(LimnEffectShaders(), MeshOf({layers.begin(), layers.begin() + 3}, random));
    parts.AddBody(MeshOf({layers.begin() + 3, layers.end()}, random), {0, 0, 0});
    // The hull of the part that is masked last runs over the other one.
    EXPECT_NE(parts.Draw(k_Size, k_Size).stencil, one.stencil);

    RenderObjectsSettings again;
    again.filterSettings.RenderQueueType = RenderQueueType::Transparent;
    again.filterSettings.LayerMask = LayerMask::FromIndex(k_BodyLayer);
    again.filterSettings.PassNames = {"StencilMask"};
    again.overrideMaterial = parts.solid;
    again.overrideMaterialPassIndex = parts.solid->FindPass("StencilMask");
    parts.renderer.AddFeature(std::make_unique<RenderObjects>(again));
    const EffectPicture repeated = parts.Draw(k_Size, k_Size);
    EXPECT_EQ(repeated.stencil, one.stencil);
    EXPECT_EQ(repeated.color.values, one.color.values);
}

TEST_F(TranslucentSolidGpu, LeavesOtherTransparentsAsTheyAreOutsideItsHull)
{
    std::mt19937 random(3);
    std::vector<Layer> layers;
    for (int i = 0; i < 4; ++i)
    {
        layers.push_back(MakeLayer(i, random));
    }
    LayerScene content(LimnEffectShaders(), MeshOf(layers, random));
    const EffectPicture with = content.Draw(k_Size, k_Size);
    content.body->activeSelf = false;
    const EffectPicture without = content.Draw(k_Size, k_Size);
    int outside = 0;
    int changed = 0;
    for (int y = 0; y < k_Size; ++y)
    {
        for (int x = 0; x < k_Size; ++x)
        {
            bool same = true;
            for (int channel = 0; channel < 4; ++channel)
            {
                same = same && with.color.At(x, y, channel) == without.color.At(x, y, channel);
            }
            outside += with.StencilAt(x, y) == 0 ? 1 : 0;
            changed += same ? 0 : 1;
            EXPECT_TRUE(same || with.StencilAt(x, y) != 0) << x << ", " << y;
        }
    }
    EXPECT_GT(outside, 2000);
    EXPECT_GT(changed, 200);
}

} // namespace
