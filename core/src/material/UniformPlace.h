#pragma once

#include <limn/core/ShaderId.h>
#include <limn/shaderlab/ShaderProgram.h>

namespace limn
{

/// A member of a uniform buffer as frames go through it: what writing it takes lies in few bytes,
/// and its name is looked up no more.
struct UniformPlace
{
    /// What it is where nobody has set it.
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
