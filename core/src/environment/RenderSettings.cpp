#include <limn/core/RenderSettings.h>

namespace limn
{

namespace
{

/// Returns equator + (up - down) / 2 * y + ((up + down) / 2 - equator) * y^2.
SphericalHarmonicsL2 Trilight(const glm::vec4& up, const glm::vec4& equator, const glm::vec4& down)
{
    SphericalHarmonicsL2 light;
    for (int rgb = 0; rgb < SphericalHarmonicsL2::k_Channels; ++rgb)
    {
        // y^2 = 1/3 - (3z^2 - 1)/6 - (x^2 - y^2)/2 on the unit sphere.
        const float bend = (up[rgb] + down[rgb]) / 2.0f - equator[rgb];
        light(rgb, 0) = equator[rgb] + bend / 3.0f;
        light(rgb, 1) = (up[rgb] - down[rgb]) / 2.0f;
        light(rgb, 6) = -bend / 6.0f;
        light(rgb, 8) = -bend / 2.0f;
    }
    return light;
}

} // namespace

SphericalHarmonicsL2 RenderSettings::AmbientLight() const
{
    SphericalHarmonicsL2 light;
    switch (ambientMode)
    {
    case AmbientMode::Skybox:
        light = ambientProbe;
        return light *= ambientIntensity;
    case AmbientMode::Custom:
        return ambientProbe;
    case AmbientMode::Trilight:
        return Trilight(ambientSkyColor.linear().vector(), ambientEquatorColor.linear().vector(),
                        ambientGroundColor.linear().vector());
    case AmbientMode::Flat:
        break;
    }
    light.AddAmbientLight(ambientLight.linear());
    return light;
}

} // namespace limn
