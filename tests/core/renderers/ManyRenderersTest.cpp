#include "renderers/ManyRenderers.h"

namespace limn
{
namespace
{

TEST_F(ManyRenderers, AreCulledAsTheyAreAfterEveryChange)
{
    for (int i = 0; i < 40; ++i)
    {
        Add();
    }
    for (int step = 0; step < 400; ++step)
    {
        SCOPED_TRACE("step " + std::to_string(step));
        for (int changes = Number(4); changes > 0; --changes)
        {
            Change();
        }
        m_Camera.cullingMask = LayerMask(Bits() | 1u);
        m_Camera.transform.localPosition = Vector(20.0f);
        m_Camera.transform.localRotation = EulerToRotation(Vector(180.0f));
        ExpectRight(Cull(m_Scene, m_Camera, 1.0f));
        if (HasFailure())
        {
            break;
        }
    }
}

TEST_F(ManyRenderers, AreKnownToAFrameThatOutlivesTheirScene)
{
    Add();
    m_Scene.objects()[0]->transform.localPosition = {3.0f, 0.0f, 0.0f};
    const auto objects = Cull(m_Scene, m_Camera, 1.0f).objects;
    m_Scene = Scene();
    EXPECT_EQ(objects->Get(0).objectToWorld[12], 3.0f);
}

TEST_F(ManyRenderers, HaveThePerDrawDataOfTheirPlace)
{
    for (int i = 0; i < 20; ++i)
    {
        Add();
    }
    std::uint64_t version = 0;
    for (int step = 0; step < 200; ++step)
    {
        const auto before = Cull(m_Scene, m_Camera, 1.0f).objects;
        std::vector<PerDrawData> old;
        for (std::uint32_t i = 0; i < before->count(); ++i)
        {
            old.push_back(before->Get(i));
        }
        version = before->version();
        Change();
        const auto objects = Cull(m_Scene, m_Camera, 1.0f).objects;
        const auto changed = objects->ChangedSince(version);
        ASSERT_TRUE(changed.has_value());
        for (std::uint32_t i = 0; i < objects->count(); ++i)
        {
            const GameObject& object = *m_Scene.objects()[i];
            const PerDrawData data = objects->Get(i);
            const glm::mat4 world = object.transform.localToWorldMatrix();
            for (int k = 0; k < 16; ++k)
            {
                ASSERT_EQ(data.objectToWorld[k], world[k / 4][k % 4]) << "step " << step;
            }
            if (object.renderer)
            {
                EXPECT_EQ(data.renderingLayer[0], object.renderer->renderingLayerMask.bits);
            }
            const bool isListed = std::ranges::count(*changed, i) == 1;
            const bool isOther = i >= old.size() || std::memcmp(&old[i], &data, sizeof data) != 0;
            EXPECT_TRUE(isListed || !isOther) << "object " << i << " of step " << step;
        }
    }
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).objects->ChangedSince(version + 1)->size(), 0u)
        << "nothing has changed";
    EXPECT_FALSE(Cull(m_Scene, m_Camera, 1.0f).objects->ChangedSince(0).has_value())
        << "that is too long ago to tell";
}

TEST_F(ManyRenderers, AreSmall)
{
    // A million lie in memory that each frame goes through; malloc adds 8 bytes and rounds to 16.
    EXPECT_LE(sizeof(GameObject), 152u);
}

TEST_F(ManyRenderers, NoticeWhenMaterialsFarApartChangePlaces)
{
    std::vector<std::shared_ptr<const Material>> materials(80, m_Materials[0]);
    materials[5] = m_Materials[1];
    GameObject& object = test::AddCube(m_Scene, "cube", {0, 0, 10}, materials);
    const auto place = [&]
    {
        const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
        std::size_t i = 0;
        while (i < results.items.size() && results.items.at(i).material != m_Materials[1])
        {
            ++i;
        }
        return i;
    };
    EXPECT_EQ(place(), 5u);
    std::size_t at = 5;
    for (const std::size_t next : {37u, 69u, 5u, 6u, 70u, 38u})
    {
        std::swap(object.renderer->sharedMaterials[at], object.renderer->sharedMaterials[next]);
        EXPECT_EQ(place(), next);
        at = next;
    }
}

TEST_F(ManyRenderers, LetGoOfWhatNoneOfThemHasAnyMore)
{
    GameObject& object = test::AddCube(m_Scene, "cube", {0, 0, 10}, {});
    auto material = std::make_shared<Material>(test::ShaderWithModes({"A"}));
    object.renderer->sharedMaterials = {material};
    object.renderer->mesh = Pair();
    const std::weak_ptr<const Mesh> mesh = object.renderer->mesh;
    const std::weak_ptr<const Material> old = material;
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 1u);
    material = nullptr;
    object.renderer->sharedMaterials = {m_Materials[0]};
    object.renderer->mesh = test::Cube();
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.at(0).material, m_Materials[0]);
    EXPECT_TRUE(mesh.expired());
    EXPECT_TRUE(old.expired());
}

TEST_F(ManyRenderers, AreRightAgainOnceParentsNoLongerGoRoundInACircle)
{
    GameObject& moved = test::AddCube(m_Scene, "moved", {0, 0, 10}, {m_Materials[0]});
    GameObject& object = test::AddCube(m_Scene, "cube", {0, 0, 10}, {m_Materials[0]});
    GameObject& other = test::AddCube(m_Scene, "other", {0, 0, 10}, {m_Materials[0]});
    EXPECT_EQ(Cull(m_Scene, m_Camera, 1.0f).items.size(), 3u);
    moved.transform.localPosition = {0, 0, -10}; // out of sight, while the frame fails
    object.transform.parent = &other.transform;
    other.transform.parent = &object.transform;
    for (int again = 0; again < 2; ++again)
    {
        EXPECT_THROW(Cull(m_Scene, m_Camera, 1.0f), ContractError);
    }
    object.transform.parent = nullptr;
    other.transform.parent = nullptr;
    const CullingResults results = Cull(m_Scene, m_Camera, 1.0f);
    ASSERT_EQ(results.items.size(), 2u);
    EXPECT_EQ(results.items.at(0).object, &object);
}

} // namespace
} // namespace limn
