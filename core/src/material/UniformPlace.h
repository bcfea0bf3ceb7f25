#pragma once

#include <limn/core/ShaderId.h>
#include <limn/shaderlab/ShaderProgram.h>

namespace limn
{

/// A member of a uniform buffer in a form that frames can go through: the data for writing it takes
/// few bytes, and its name is not looked up any more.
struct UniformPlace
{
    /// Selects the value if it has not been set.
    enum class Unset : std::uint8_t
    {
        Zero,
        OneOneZeroZero,
        TexelSize ///< 1/width, 1/height, width, height of `texture`
    };

    explicit UniformPlace(const UniformMember& member);

    ShaderPropertyId id;
    ShaderPropertyId texture;
    std::uint32_t offset = 0; ///< bytes from the start of the buffer
    std::uint32_t size = 0;   ///< bytes, arrays included
    std::uint32_t arrayStride = 0;
    int arraySize = 0; ///< 0 = not an array
    UniformType type = UniformType::Float;
    std::uint8_t components = 1; ///< of the vector; 4 for Matrix4x4
    Unset unset = Unset::Zero;
};

} // namespace limn
