#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace limn::test
{

/// A light as it arrives at a point.
struct ArrivingLight
{
    glm::dvec3 toLight;
    glm::dvec3 color; ///< linear, with whatever weakens it on its way
};

/// A point of a surface of URP's Lit.
struct LitSurface
{
    glm::dvec3 albedo{1.0};
    double metallic = 0.0;
    glm::dvec3 specular{0.0}; ///< of the specular workflow
    bool isSpecular = false;
    double smoothness = 0.5;
    double alpha = 1.0;
    bool isPremultiplied = false;
    glm::dvec3 normal{0.0, 0.0, -1.0};
};

/// The least and the largest value that arithmetic in floats may give.
struct ValueRange3
{
    glm::dvec3 low;
    glm::dvec3 high;
};

/// The names of the microfacet model that URP uses: "Optimizing PBR for Mobile" (SIGGRAPH 2015).
struct LitTerms
{
    glm::dvec3 diffuse;
    glm::dvec3 specular;
    double roughness;
    double roughness2;
};

inline LitTerms TermsOf(const LitSurface& surface)
{
    constexpr double k_HalfMin = 6.103515625e-5; // 2^-14, the least normal half
    LitTerms terms{};
    const double perceptual = 1.0 - surface.smoothness;
    terms.roughness = std::max(perceptual * perceptual, std::sqrt(k_HalfMin));
    terms.roughness2 = std::max(terms.roughness * terms.roughness, k_HalfMin);
    if (surface.isSpecular)
    {
        const glm::dvec3& s = surface.specular;
        terms.specular = s;
        terms.diffuse = surface.albedo * (1.0 - std::max({s.r, s.g, s.b}));
    }
    else // a dielectric reflects 4 %
    {
        terms.specular = glm::mix(glm::dvec3(0.04), surface.albedo, surface.metallic);
        terms.diffuse = surface.albedo * 0.96 * (1.0 - surface.metallic);
    }
    terms.diffuse *= surface.isPremultiplied ? surface.alpha : 1.0;
    return terms;
}

/// What a surface sends to the camera of one light.
/// @param error  added to the cosine of normal and half vector
inline glm::dvec3 LitByFormula(const LitSurface& surface, const ArrivingLight& light,
                               const glm::dvec3& toCamera, double error)
{
    const LitTerms terms = TermsOf(surface);
    const glm::dvec3 sum = light.toLight + toCamera;
    const double length = glm::length(sum);
    const glm::dvec3 halfway = length > 1e-15 ? sum / length : glm::dvec3(0.0);
    const double nh = std::clamp(glm::dot(surface.normal, halfway) + error, 0.0, 1.0);
    const double lh = std::clamp(glm::dot(light.toLight, halfway), 0.0, 1.0);
    const double nl = std::clamp(glm::dot(surface.normal, light.toLight), 0.0, 1.0);
    const double d = nh * nh * (terms.roughness2 - 1.0) + 1.00001;
    const double highlight =
        terms.roughness2 / (d * d * std::max(0.1, lh * lh) * (4.0 * terms.roughness + 2.0));
    return (terms.diffuse + highlight * terms.specular) * light.color * nl;
}

/// The same of Simple Lit: Lambert, and Blinn-Phong of the specular colour.
inline glm::dvec3 SimpleLitByFormula(const LitSurface& surface, const ArrivingLight& light,
                                     const glm::dvec3& toCamera, double error)
{
    const glm::dvec3 halfway = glm::normalize(light.toLight + toCamera);
    const double nh = std::clamp(glm::dot(surface.normal, halfway) + error, 0.0, 1.0);
    const double nl = std::clamp(glm::dot(surface.normal, light.toLight), 0.0, 1.0);
    const double exponent = std::exp2(10.0 * surface.smoothness + 1.0);
    return light.color * (surface.albedo * nl + surface.specular * std::pow(nh, exponent));
}

/// Sums lights up. The cosine of normal and half vector, which decides how bright a highlight is,
/// has the error of a few operations in floats.
template <typename Formula>
ValueRange3 SumOfLights(const Formula& formula, const LitSurface& surface,
                        const std::vector<ArrivingLight>& lights, const glm::dvec3& toCamera)
{
    constexpr double k_Error = 4.0 * 1.1920929e-7;
    ValueRange3 sum{glm::dvec3(0.0), glm::dvec3(0.0)};
    for (const ArrivingLight& light : lights)
    {
        ValueRange3 one{glm::dvec3(1e300), glm::dvec3(-1e300)};
        for (const double error : {-k_Error, 0.0, k_Error})
        {
            const glm::dvec3 value = formula(surface, light, toCamera, error);
            one.low = glm::min(one.low, value);
            one.high = glm::max(one.high, value);
        }
        sum.low += one.low;
        sum.high += one.high;
    }
    return sum;
}

} // namespace limn::test
