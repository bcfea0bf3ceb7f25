#pragma once

#include "features/color_edges/PictureRun.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace limn::test
{

/// Nothing but a sky, seen by a turned camera in small pictures.
class SkyGpu : public GpuTest
{
protected:
    static constexpr int k_Width = 48;
    static constexpr int k_Height = 32;

    SkyGpu()
    {
        m_Camera.clearFlags = CameraClearFlags::Skybox;
        m_Camera.fieldOfView = 70.0f;
        m_Camera.transform.localPosition = {3.0f, 2.0f, -5.0f};
        m_Scene.mainLight.direction =
            glm::vec3(EulerToRotation({35.0f, -160.0f, 0.0f}) * glm::vec3(0.0f, 0.0f, 1.0f));
        m_Scene.mainLight.color = {1.0f, 0.95f, 0.8f, 1.0f};
    }

    Material& Sky(const char* shader)
    {
        const auto sky = std::make_shared<Material>(FindBuiltinShader(shader, Compiler()));
        m_Scene.skybox = sky;
        return *sky;
    }

    void Look(const glm::vec3& degrees)
    {
        m_Camera.transform.localRotation = EulerToRotation(degrees);
    }

    /// Where a place of the picture looks, in double.
    glm::dvec3 Direction(const glm::dvec2& place) const
    {
        const double right = (2.0 * place.x / k_Width - 1.0) * k_Width / k_Height;
        const double up = 1.0 - 2.0 * place.y / k_Height;
        const double half =
            m_Camera.orthographic
                ? static_cast<double>(m_Camera.orthographicSize) /
                      static_cast<double>(m_Camera.farClipPlane)
                : std::tan(glm::radians(static_cast<double>(m_Camera.fieldOfView) / 2));
        const glm::dquat rotation(glm::normalize(glm::dquat(m_Camera.transform.localRotation)));
        return glm::normalize(rotation * glm::dvec3(right * half, up * half, 1.0));
    }

    /// @return nothing where the reference cannot tell what floats make of it
    using Reference = std::function<std::optional<glm::dvec3>(const glm::dvec3&)>;

    /// The least and the largest that a reference says of the places that the device may take for
    /// a pixel's middle; nothing where it says nothing of one.
    std::optional<std::pair<glm::dvec3, glm::dvec3>> RangeAt(const Reference& reference, int x,
                                                             int y) const
    {
        std::optional<std::pair<glm::dvec3, glm::dvec3>> range;
        for (const glm::dvec2& place : MovedPlaces({x + 0.5, y + 0.5}))
        {
            const std::optional<glm::dvec3> value = reference(Direction(place));
            if (!value)
            {
                return std::nullopt;
            }
            range = range
                        ? std::pair(glm::min(range->first, *value), glm::max(range->second, *value))
                        : std::pair(*value, *value);
        }
        return range;
    }

    /// The picture against a function of the direction.
    void ExpectSky(const Reference& reference, double relative, double absolute)
    {
        PictureRun run(m_Scene, m_Camera, k_Width, k_Height);
        const Field picture = run.Color(nullptr);
        int compared = 0;
        for (int y = 0; y < k_Height; ++y)
        {
            for (int x = 0; x < k_Width; ++x)
            {
                const auto range = RangeAt(reference, x, y);
                compared += range ? 1 : 0;
                for (int channel = 0; range && channel < 3; ++channel)
                {
                    const double seen = picture.At(x, y, channel);
                    const double wanted =
                        std::clamp(seen, range->first[channel], range->second[channel]);
                    ASSERT_NEAR(seen, wanted, relative * wanted + absolute)
                        << x << ", " << y << ", channel " << channel;
                }
            }
        }
        EXPECT_GT(compared, k_Width * k_Height * 9 / 10) << "too little was compared";
    }

    Scene m_Scene;
    Camera m_Camera;
};

} // namespace limn::test
