#include "Mentions.h"
#include "core/scene/TestScene.h"

#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/features/OutlinedObjects.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;

/// Two hierarchies of two parts each, and a lone object, all in sight; one part is not selected.
class OutlinedObjectsOf : public testing::Test
{
protected:
    OutlinedObjectsOf()
    {
        const Transform& lamp = Add("lamp", nullptr, 3).transform;
        const Transform& sofa = Add("sofa", nullptr, 3).transform;
        Add("shade", &lamp, 3);
        Add("cushion", &sofa, 0);
        Add("leg", &sofa, 3);
        Add("cat", nullptr, 3);
        camera.transform.localPosition = {0.0f, 0.0f, -10.0f};
        settings.m_RenderingLayerMask = 3;
    }

    GameObject& Add(const char* name, const Transform* parent, int renderingLayer)
    {
        GameObject& object = scene.Add(name);
        object.transform.parent = parent;
        object.renderer = MeshRenderer{
            CreatePrimitive(PrimitiveType::Cube),
            {std::make_shared<Material>(FindBuiltinShader("Limn/Half Lambert", Compiler()))},
            RenderingLayerMask::FromIndex(renderingLayer)};
        return object;
    }

    std::vector<std::string> Find(OutlineGrouping grouping)
    {
        RenderingData data;
        data.cullResults = Cull(scene, camera, 1.0f);
        FindOutlinedObjects(data, settings, grouping, found);
        why = found.why;
        std::vector<std::string> texts;
        for (const OutlinedObject& object : found.objects)
        {
            texts.push_back(object.item.object->name + " " + std::to_string(object.group));
        }
        return texts;
    }

    Scene scene;
    Camera camera;
    OutlineSettings settings;
    std::string why;
    OutlinedObjects found;
};

TEST_F(OutlinedObjectsOf, OneGroupStandInTheScenesOrder)
{
    EXPECT_THAT(Find(OutlineGrouping::Together),
                ElementsAre("lamp 0", "sofa 0", "shade 0", "leg 0", "cat 0"));
}

TEST_F(OutlinedObjectsOf, HierarchiesAreTogether)
{
    EXPECT_THAT(Find(OutlineGrouping::PerGroup),
                ElementsAre("lamp 0", "shade 0", "sofa 1", "leg 1", "cat 2"));
}

TEST_F(OutlinedObjectsOf, EachItsOwnAreApart)
{
    EXPECT_THAT(Find(OutlineGrouping::PerObject),
                ElementsAre("lamp 0", "sofa 1", "shade 2", "leg 3", "cat 4"));
}

TEST_F(OutlinedObjectsOf, ANonexistentSelectionSayWhatBecameOfTheRenderers)
{
    settings.m_RenderingLayerMask = 5;
    EXPECT_THAT(Find(OutlineGrouping::Together), ElementsAre());
    EXPECT_THAT(why, Mentions("0 of 6", "rendering layer mask leaves out 6"));
}

TEST_F(OutlinedObjectsOf, ACameraWithAMarginAreFoundBesideThePicture)
{
    for (const auto& object : scene.objects())
    {
        object->transform.localPosition.x += 6.8f; // the picture ends at 5.8
    }
    settings.m_RenderingLayerMask = 3;
    RenderingData data;
    data.cullResults = Cull(scene, camera, 1.0f);
    EXPECT_THAT(data.cullResults.items, testing::IsEmpty());
    data.cullResults = Cull(scene, camera, 1.0f, {0.2f, 0.0f});
    FindOutlinedObjects(data, settings, OutlineGrouping::Together, found);
    EXPECT_THAT(found.objects, testing::Not(testing::IsEmpty()));
}

} // namespace
} // namespace limn::test
