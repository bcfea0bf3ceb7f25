#include "features/sky/SkyScene.h"

namespace limn::test
{
namespace
{

/// O'Neil's single scattering in double, written from the paper and the table of numbers.
struct AirTwin
{
    double thickness = 1.0;
    glm::dvec3 tint{0.5}; ///< sRGB
    glm::dvec3 ground{0.369, 0.349, 0.341};
    double sunSize = 0.04;
    double convergence = 5.0;
    double exposure = 1.3;
    glm::dvec3 toSun{0.0, 1.0, 0.0};
    glm::dvec3 light{1.0}; ///< linear

    static constexpr double k_Pi = 3.141592653589793;
    static constexpr double k_Mie = 0.001;
    static constexpr double k_Sun = 20.0;
    static constexpr double k_Eye = 0.0001;
    static constexpr double k_Air = 0.025;

    static double Linear(double s)
    {
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    double Strength(int channel) const
    {
        const double middle[] = {0.65, 0.57, 0.475};
        const double wavelength = middle[channel] + 0.15 * (1.0 - 2.0 * tint[channel]);
        return 0.0025 * std::pow(thickness, 2.5) / std::pow(wavelength, 4);
    }
    static double AllAir(double cosine)
    {
        const double coefficients[] = {5.25, -6.80, 3.83, 0.459, -0.00287};
        double sum = 0.0;
        for (const double coefficient : coefficients)
        {
            sum = sum * (1.0 - cosine) + coefficient;
        }
        return 0.25 * std::exp(sum);
    }
    static double Density(const glm::dvec3& place)
    {
        return std::exp((1.0 - glm::length(place)) / (0.25 * k_Air));
    }
    static double Left(double depth, double strength)
    {
        return std::exp(-std::clamp(depth, 0.0, 50.0) * 4.0 * k_Pi * (strength + k_Mie));
    }

    /// Scattered towards the eye, for each unit of strength.
    double Air(const glm::dvec3& ray, double strength) const
    {
        const glm::dvec3 eye(0.0, 1.0 + k_Eye, 0.0);
        const double way = std::sqrt(std::pow(1.0 + k_Air, 2) - 1.0 + ray.y * ray.y) - ray.y;
        const double before = std::exp(-k_Eye / (0.25 * k_Air)) * AllAir(ray.y);
        double sum = 0.0;
        for (const double part : {0.25, 0.75})
        {
            const glm::dvec3 place = eye + ray * (way * part);
            const glm::dvec3 up = glm::normalize(place);
            const double depth =
                before + Density(place) * (AllAir(glm::dot(toSun, up)) - AllAir(glm::dot(ray, up)));
            sum += Left(depth, strength) * Density(place) * way / 2.0 / k_Air;
        }
        return sum * k_Sun;
    }
    double Ground(const glm::dvec3& ray, int channel) const
    {
        const double strength = Strength(channel);
        const glm::dvec3 eye(0.0, 1.0 + k_Eye, 0.0);
        const double way = k_Eye / std::max(0.001, -ray.y);
        const glm::dvec3 place = eye + ray * way;
        const double toEye = AllAir(glm::dot(-ray, place));
        const double toLight = AllAir(glm::dot(toSun, place));
        const double density = Density(eye + ray * (way / 4.0));
        const double left =
            Left(density * (toEye + toLight) - std::exp(-k_Eye / 0.25) * toEye, strength);
        return left * density * way / 2.0 / k_Air * (strength + k_Mie) * k_Sun +
               Linear(ground[channel]) * left;
    }
    double Disc(const glm::dvec3& ray, const std::string& kind) const
    {
        if (kind == "_SUNDISK_SIMPLE")
        {
            const double x = std::min(glm::length(toSun - ray) / sunSize, 1.0);
            return 27.0 * std::pow(1.0 - x * x * (3.0 - 2.0 * x), 2);
        }
        if (kind == "_SUNDISK_HIGH_QUALITY")
        {
            const double cosine = std::pow(std::max(glm::dot(toSun, ray), 0.0), convergence);
            const double g = -0.99;
            const double spread =
                std::pow(1.0 + g * g + 2.0 * g * cosine, 10.0 * std::pow(sunSize, 0.65));
            return 15.0 * 1.5 * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cosine * cosine) /
                   std::max(spread, 1e-4);
        }
        return 0.0;
    }

    glm::dvec3 operator()(const glm::dvec3& ray, const std::string& sun) const
    {
        const double phase = 0.75 * (1.0 + std::pow(glm::dot(toSun, ray), 2));
        const double brightness = std::clamp(glm::length(light), 0.25, 1.0);
        glm::dvec3 color;
        for (int channel = 0; channel < 3; ++channel)
        {
            const double strength = Strength(channel);
            const double air =
                Air(ray.y >= 0.0 ? ray : glm::normalize(glm::dvec3(ray.x, 0.0, ray.z)), strength);
            color[channel] = air * strength * phase;
            if (ray.y >= 0.0)
            {
                color[channel] +=
                    std::min(air * k_Mie, 1.0) * light[channel] / brightness * Disc(ray, sun);
            }
            else
            {
                const double part = std::min(-ray.y / 0.02, 1.0);
                color[channel] += part * (Ground(ray, channel) - color[channel]);
            }
        }
        return color * exposure;
    }
};

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
