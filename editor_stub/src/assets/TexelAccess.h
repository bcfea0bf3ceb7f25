#pragma once

#include <glm/vec4.hpp>
#include <limn/core/Image.h>

namespace limn
{

/// The texels of an R8G8B8A8 or R16G16B16A16_SFloat image as numbers, by their index.
class TexelAccess
{
public:
    /// @param image   must outlive this
    /// @param isSrgb  true if bytes of colours are to be read and written as linear light
    TexelAccess(Image& image, bool isSrgb);

    glm::vec4 Get(std::size_t index) const;
    /// Bytes are limited to 0...1.
    void Set(std::size_t index, const glm::vec4& value) const;

private:
    Image& m_Image;
    bool m_IsHalf;
    bool m_IsSrgb;
};

inline std::size_t TexelCount(const Image& image)
{
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

} // namespace limn
