#include "port/Differs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;

/// At the origin, along +z, 90 degrees: at a distance d it sees d metres up and down.
Camera RightAngledCamera()
{
    Camera camera;
    camera.fieldOfView = 90.0f;
    return camera;
}

void ExpectNear(const glm::vec3& value, const glm::vec3& expected)
{
    EXPECT_LT(glm::length(value - expected), 1e-4f) << value.x << " " << value.y << " " << value.z;
}

void ExpectPlacesInThePictureThatIsGiven()
{
    const Camera camera = RightAngledCamera();
    const glm::vec3 world(2, 5, 10); // of a picture twice as wide as high
    ExpectNear(camera.WorldToViewportPoint(world, 2.0f), {0.55f, 0.75f, 10});
    ExpectNear(camera.ViewportToWorldPoint({0.55f, 0.75f, 10}, 2.0f), world);
    const glm::ivec2 size(200, 100);
    ExpectNear(camera.WorldToScreenPoint(world, size), {110, 75, 10});
    ExpectNear(camera.ScreenToWorldPoint({110, 75, 10}, size), world);
    ExpectNear(Camera::ScreenToViewportPoint({110, 75, 10}, size), {0.55f, 0.75f, 10});
    ExpectNear(Camera::ViewportToScreenPoint({0.55f, 0.75f, 10}, size), {110, 75, 10});
    ExpectNear(camera.ViewportPointToRay({0.5f, 0.5f}, 2.0f).direction, {0, 0, 1});
    ExpectNear(camera.ScreenPointToRay({100, 50}, size).direction, {0, 0, 1});
}

void ExpectTheFrustumsCorners()
{
    const auto corners = RightAngledCamera().CalculateFrustumCorners({0, 0, 1, 1}, 10.0f, 2.0f);
    for (const glm::vec3& corner : corners)
    {
        ExpectNear(glm::abs(corner), {20, 10, 10});
    }
}

void ExpectAProjectionOfItsOwnOrTheLens()
{
    Camera camera = RightAngledCamera();
    EXPECT_FALSE(camera.projectionMatrix.has_value());
    const glm::dmat4 lens = camera.projectionMatrixFor(2.0f);
    EXPECT_NEAR(lens[1][1], 1.0, 1e-6);
    EXPECT_NEAR(lens[0][0], 0.5, 1e-6);
    glm::dmat4 own = lens;
    own[0][0] = 3.0;
    camera.projectionMatrix = own;
    EXPECT_EQ(camera.projectionMatrixFor(2.0f), own);
    EXPECT_EQ(camera.cullingMatrix(2.0f), own * camera.viewMatrix());
    camera.projectionMatrix = std::nullopt;
    EXPECT_EQ(camera.projectionMatrixFor(2.0f), lens);
}

void ExpectAProjectionForShaders()
{
    Camera camera = RightAngledCamera();
    const glm::dmat4 lens = camera.projectionMatrixFor(1.0f);
    for (const bool isTexture : {false, true})
    {
        const glm::vec4 nearest = GpuProjection(lens, true, isTexture) *
                                  glm::vec4(0, camera.nearClipPlane, -camera.nearClipPlane, 1);
        EXPECT_NEAR(nearest.z / nearest.w, 1.0f, 1e-6f);
        EXPECT_NEAR(nearest.y / nearest.w, isTexture ? -1.0f : 1.0f, 1e-6f);
        const glm::vec4 farthest =
            GpuProjection(lens, true, isTexture) * glm::vec4(0, 0, -camera.farClipPlane, 1);
        EXPECT_NEAR(farthest.z / farthest.w, 0.0f, 1e-6f);
    }
}

void ExpectATransform()
{
    Camera camera;
    camera.transform.localPosition = {1, 2, 3};
    EXPECT_EQ(camera.transform.position(), glm::vec3(1, 2, 3));
    ExpectNear(camera.transform.forward(), {0, 0, 1});
    const glm::vec4 seen = camera.worldToCameraMatrix() * glm::vec4(1, 2, 4, 1);
    ExpectNear(glm::vec3(seen), {0, 0, -1});
    ExpectNear(glm::vec3(camera.cameraToWorldMatrix() * seen), {1, 2, 4});
}

template <typename Data>
void ExpectCameraDataOf()
{
    Camera camera;
    camera.volumeTrigger = glm::vec3(7, 8, 9);
    Data data;
    data.camera = &camera;
    EXPECT_EQ(data.camera->volumeTrigger, glm::vec3(7, 8, 9));
    EXPECT_FALSE(data.isSceneViewCamera());
    data.cameraType = CameraType::SceneView;
    EXPECT_TRUE(data.isSceneViewCamera());
    EXPECT_FALSE(data.isPreviewCamera());
}

void ExpectCameraData()
{
    ExpectCameraDataOf<CameraData>();
    ExpectCameraDataOf<UniversalCameraData>();
}

void ExpectScaledSizes()
{
    UniversalCameraData data;
    data.cameraTargetDescriptor = {8, 4, GraphicsFormat::R8G8B8A8_UNorm};
    EXPECT_EQ(data.scaledWidth(), 8);
    EXPECT_EQ(data.scaledHeight(), 4);
}

void ExpectLightsAndShadowsByFunctions()
{
    Scene scene;
    scene.mainLight.intensity = 2.0f;
    Light spot;
    spot.type = LightType::Spot;
    const Light* lights[] = {&spot};
    LightData data;
    EXPECT_TRUE(data.visibleLights().empty());
    data.scene = &scene;
    data.mainLightIndex = 0;
    data.additionalLights = lights;
    const std::vector<VisibleLight> visible = data.visibleLights();
    ASSERT_EQ(visible.size(), 2u);
    EXPECT_EQ(visible[0].light, nullptr) << "the main one";
    EXPECT_EQ(visible[1].light, &spot);
    EXPECT_EQ(visible[1].lightType, LightType::Spot);
    const ShadowData shadows(ShadowSettings(), data);
    EXPECT_EQ(shadows.bias().size(), 2u);
    EXPECT_EQ(shadows.resolution().size(), 2u);
    EXPECT_EQ(shadows.shadowmapDepthBufferBits, 32);
}

void ExpectThingsOfARenderersMesh()
{
    GameObject object;
    object.transform.localPosition = {1, 2, 3};
    const auto material = std::make_shared<const Material>(DiffersShader());
    object.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Cube), {material}};
    EXPECT_EQ(object.renderer->mesh->bounds().center, glm::vec3(0)) << "in the object's space";
    EXPECT_EQ(object.renderer->mesh->bounds().extents, glm::vec3(0.5f));
    EXPECT_EQ(glm::vec3(object.transform.worldMatrix()[3]), glm::vec3(1, 2, 3));
    EXPECT_EQ(object.renderer->sharedMaterial(), material);
    const auto other = std::make_shared<const Material>(DiffersShader());
    object.renderer->sharedMaterials = {other};
    EXPECT_EQ(object.renderer->sharedMaterial(), other);
    EXPECT_EQ(object.renderer->sharedMaterials.front(), other);
}

void ExpectAMeshOfItsData()
{
    MeshData data;
    data.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
    data.normals.assign(3, {0, 0, -1});
    data.tangents.assign(3, {1, 0, 0, 1});
    data.uv = {{0, 0}, {1, 0}, {0, 1}};
    data.SetColors({Color32{255, 0, 0, 255}, Color32{0, 255, 0, 255}, Color32{0, 0, 255, 255}});
    data.triangles = {0, 2, 1};
    data.subMeshes = {{0, 3}};
    const Mesh mesh("Own", data);
    EXPECT_EQ(mesh.data().vertices.size(), 3u);
    EXPECT_EQ(mesh.data().normals[2], glm::vec3(0, 0, -1));
    EXPECT_EQ(mesh.data().tangents[0], glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(mesh.data().uv[1], glm::vec2(1, 0));
    EXPECT_EQ(mesh.data().colors[1], glm::vec4(0, 1, 0, 1));
    EXPECT_THAT(mesh.data().triangles, ElementsAre(0u, 2u, 1u));
    EXPECT_EQ(mesh.bounds().center, glm::vec3(1, 2, 0)) << "worked out";
    EXPECT_EQ(mesh.bounds().extents, glm::vec3(1, 2, 0));
    EXPECT_EQ(mesh.subMeshCount(), 1);
    EXPECT_EQ(mesh.subMesh(0), (SubMesh{0, 3}));
    EXPECT_EQ(mesh.indexFormat(), IndexFormat::UInt32);
    EXPECT_EQ(mesh.GetTopology(0), MeshTopology::Triangles);
}

} // namespace

DiffersChecks CameraDiffers()
{
    return {{Members("Camera", {"WorldToViewportPoint", "ViewportToWorldPoint",
                                "WorldToScreenPoint", "ScreenToWorldPoint", "ScreenToViewportPoint",
                                "ViewportToScreenPoint", "ViewportPointToRay", "ScreenPointToRay"}),
             ExpectPlacesInThePictureThatIsGiven},
            {{"Camera.CalculateFrustumCorners"}, ExpectTheFrustumsCorners},
            {Members("Camera", {"projectionMatrix", "ResetProjectionMatrix",
                                "nonJitteredProjectionMatrix", "cullingMatrix"}),
             ExpectAProjectionOfItsOwnOrTheLens},
            {{"GL.GetGPUProjectionMatrix"}, ExpectAProjectionForShaders},
            {Members("Camera", {"transform", "cameraToWorldMatrix", "worldToCameraMatrix"}),
             ExpectATransform},
            {OfEach({"CameraData", "UniversalCameraData"},
                    {"isPreviewCamera", "isSceneViewCamera", "volumeTrigger"}),
             ExpectCameraData},
            {Members("UniversalCameraData", {"scaledWidth", "scaledHeight"}), ExpectScaledSizes},
            {{"LightData.visibleLights", "UniversalLightData.visibleLights", "ShadowData.bias",
              "ShadowData.resolution", "ShadowData.shadowmapDepthBufferBits",
              "UniversalShadowData.bias", "UniversalShadowData.resolution",
              "UniversalShadowData.shadowmapDepthBufferBits"},
             ExpectLightsAndShadowsByFunctions},
            {Members("Renderer", {"bounds", "localBounds", "localToWorldMatrix",
                                  "worldToLocalMatrix", "material", "sharedMaterial"}),
             ExpectThingsOfARenderersMesh},
            {Members("Mesh", {"vertices",    "normals",           "tangents",     "uv",
                              "colors",      "colors32",          "triangles",    "SetVertices",
                              "SetNormals",  "SetTangents",       "SetUVs",       "SetColors",
                              "SetIndices",  "SetTriangles",      "SetSubMesh",   "vertexCount",
                              "bounds",      "RecalculateBounds", "subMeshCount", "GetSubMesh",
                              "indexFormat", "GetTopology"}),
             ExpectAMeshOfItsData}};
}

} // namespace limn::test
