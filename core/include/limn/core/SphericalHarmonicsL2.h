#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/core/Color.h>

namespace limn
{

/// Light from all around, as a white matt surface shows it: for each of red, green and blue the
/// weights of nine functions of the surface's normal (x, y, z), linear:
///
///     0  1  2  3  4   5   6         7   8
///     1  y  z  x  xy  yz  3z^2 - 1  xz  x^2 - y^2
///
/// The cosine of the surface and the constants of the harmonics are in the weights already, so that
/// light of one colour from all sides has that colour as weight 0 and nothing else.
/// Unity: UnityEngine.Rendering.SphericalHarmonicsL2 (2022.3), where `sh[rgb, coefficient]` is
/// `sh(rgb, coefficient)` here.
struct SphericalHarmonicsL2
{
    static constexpr int k_Channels = 3;
    static constexpr int k_Coefficients = 9;

    /// @param rgb          0 ... 2
    /// @param coefficient  0 ... 8
    float& operator()(int rgb, int coefficient) { return weights[Index(rgb, coefficient)]; }
    float operator()(int rgb, int coefficient) const { return weights[Index(rgb, coefficient)]; }

    void Clear() { weights.fill(0.0f); }
    /// Adds light of this linear colour from all sides.
    void AddAmbientLight(const Color& color);

    /// Returns the linear colour of a white matt surface, which can be below 0, since so few
    /// functions swing below it.
    /// @param normal  unit length. Unity: Evaluate, of one direction.
    glm::vec3 Evaluate(const glm::vec3& normal) const;

    /// Returns its constants in shaders: unity_SHAr, unity_SHAg, unity_SHAb, unity_SHBr,
    /// unity_SHBg, unity_SHBb, unity_SHC.
    std::array<glm::vec4, 7> shaderConstants() const;

    SphericalHarmonicsL2& operator*=(float scale);
    bool operator==(const SphericalHarmonicsL2&) const = default;

    /// The nine of red come first.
    std::array<float, std::size_t{k_Channels} * k_Coefficients> weights{};

private:
    static constexpr std::size_t Index(int rgb, int coefficient)
    {
        return static_cast<std::size_t>(rgb * k_Coefficients + coefficient);
    }
};

} // namespace limn
