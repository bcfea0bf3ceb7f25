#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace limn::test
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

} // namespace limn::test
