#include "features/sky/AirTwin.h"
#include "features/sky/SkyScene.h"

namespace limn::test
{
namespace
{

class ProceduralSkyGpu : public SkyGpu
{
protected:
    AirTwin Twin() const
    {
        AirTwin twin;
        twin.toSun = -glm::dvec3(m_Scene.mainLight.direction);
        twin.light = glm::dvec3(glm::vec3(m_Scene.mainLight.color.linear().vector()));
        return twin;
    }
    void ExpectAir(const AirTwin& twin, const std::string& sun)
    {
        // A half has 11 bits, and exp of up to -20 of rounded numbers loses a few of a float's 24.
        // The formula bends at the horizon, so that what is around it is no range of what it says:
        // nothing is compared where the device may take a ray for one of the other side. A pixel is
        // less than 0.1 of a ray's length wide and high together.
        const double bend = 0.1 * SubPixel();
        ExpectSky([&](const glm::dvec3& ray)
                  { return std::abs(ray.y) < bend ? std::nullopt : std::optional(twin(ray, sun)); },
                  1.5e-3, 2e-5);
    }
};

TEST_F(ProceduralSkyGpu, ScattersLightAsTheFormulaSaysAllAround)
{
    Sky("Skybox/Procedural").DisableKeyword("_SUNDISK_HIGH_QUALITY");
    for (const glm::vec3& degrees : {glm::vec3(0, 0, 0), glm::vec3(-60, 20, 10),
                                     glm::vec3(50, 100, 0), glm::vec3(-10, 200, -30)})
    {
        Look(degrees);
        ExpectAir(Twin(), "_SUNDISK_NONE");
    }
}

TEST_F(ProceduralSkyGpu, FollowsItsProperties)
{
    Material& sky = Sky("Skybox/Procedural");
    sky.DisableKeyword("_SUNDISK_HIGH_QUALITY");
    sky.SetFloat(ShaderPropertyId("_AtmosphereThickness"), 0.53f);
    sky.SetColor(ShaderPropertyId("_SkyTint"), {0.9f, 0.4f, 0.1f, 1.0f});
    sky.SetColor(ShaderPropertyId("_GroundColor"), {0.2f, 0.6f, 0.9f, 1.0f});
    sky.SetFloat(ShaderPropertyId("_Exposure"), 0.7f);
    AirTwin twin = Twin();
    twin.thickness = 0.53;
    twin.tint = {0.9, 0.4, 0.1};
    twin.ground = {0.2, 0.6, 0.9};
    twin.exposure = 0.7;
    ExpectAir(twin, "_SUNDISK_NONE");
}

TEST_F(ProceduralSkyGpu, HasADiscWhereTheLightComesFrom)
{
    Material& sky = Sky("Skybox/Procedural");
    sky.SetFloat(ShaderPropertyId("_SunSize"), 0.3f);
    sky.SetFloat(ShaderPropertyId("_SunSizeConvergence"), 3.0f);
    Look({-30.0f, 22.0f, 0.0f});
    AirTwin twin = Twin();
    twin.sunSize = 0.3;
    twin.convergence = 3.0;
    ExpectAir(twin, "_SUNDISK_HIGH_QUALITY");
    sky.DisableKeyword("_SUNDISK_HIGH_QUALITY");
    sky.EnableKeyword("_SUNDISK_SIMPLE");
    ExpectAir(twin, "_SUNDISK_SIMPLE");
    PictureRun run(m_Scene, m_Camera, k_Width, k_Height);
    const Field simple = run.Color(nullptr);
    sky.DisableKeyword("_SUNDISK_SIMPLE");
    EXPECT_GT(CountDifferent(simple, run.Color(nullptr)), 50) << "no sun in the picture";
}

TEST_F(ProceduralSkyGpu, IsSeenByAnOrthographicCameraAsItsFarPlaneLies)
{
    Sky("Skybox/Procedural").DisableKeyword("_SUNDISK_HIGH_QUALITY");
    m_Camera.orthographic = true;
    m_Camera.orthographicSize = 6.0f;
    m_Camera.farClipPlane = 20.0f;
    Look({-8.0f, 40.0f, 5.0f});
    ExpectAir(Twin(), "_SUNDISK_NONE");
}

} // namespace
} // namespace limn::test
