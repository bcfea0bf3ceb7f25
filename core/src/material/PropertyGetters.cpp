#include "material/PropertyValues.h"

#include <limn/core/Mathf.h>
#include <limn/core/Shader.h>

#include "material/ShaderGlobals.h"

namespace limn
{

namespace
{

// The getters that property blocks and the globals of the process have in common.

float FloatIn(const ShaderPropertyValue* value)
{
    const int* number = As<int>(value);
    return number != nullptr ? static_cast<float>(*number) : CopyOf<float>(value);
}

int IntIn(const ShaderPropertyValue* value)
{
    const float* number = As<float>(value);
    return number != nullptr ? Mathf::ToInt(*number) : CopyOf<int>(value);
}

glm::vec4 VectorIn(const ShaderPropertyValue* value)
{
    const Color* color = As<Color>(value);
    return color != nullptr ? color->linear().vector() : CopyOf<glm::vec4>(value);
}

Color ColorIn(const ShaderPropertyValue* value)
{
    if (const auto* vector = As<glm::vec4>(value))
    {
        return Color(vector->x, vector->y, vector->z, vector->w).gamma();
    }
    const Color* color = As<Color>(value);
    return color != nullptr ? *color : Color::clear;
}

const ShaderPropertyValue* Pointer(const std::optional<ShaderPropertyValue>& value)
{
    return value ? &*value : nullptr;
}

using TexturePtr = std::shared_ptr<const Texture>;

} // namespace

float MaterialPropertyBlock::GetFloat(ShaderPropertyId id) const
{
    return FloatIn(Find(id));
}

int MaterialPropertyBlock::GetInt(ShaderPropertyId id) const
{
    return IntIn(Find(id));
}

glm::vec4 MaterialPropertyBlock::GetVector(ShaderPropertyId id) const
{
    return VectorIn(Find(id));
}

Color MaterialPropertyBlock::GetColor(ShaderPropertyId id) const
{
    return ColorIn(Find(id));
}

glm::mat4 MaterialPropertyBlock::GetMatrix(ShaderPropertyId id) const
{
    return CopyOf<glm::mat4>(Find(id));
}

TexturePtr MaterialPropertyBlock::GetTexture(ShaderPropertyId id) const
{
    return CopyOf<TexturePtr>(Find(id));
}

std::vector<float> MaterialPropertyBlock::GetFloatArray(ShaderPropertyId id) const
{
    return ArrayIn<float>(Find(id));
}

std::vector<glm::vec4> MaterialPropertyBlock::GetVectorArray(ShaderPropertyId id) const
{
    return ArrayIn<glm::vec4>(Find(id));
}

std::vector<glm::mat4> MaterialPropertyBlock::GetMatrixArray(ShaderPropertyId id) const
{
    return ArrayIn<glm::mat4>(Find(id));
}

bool MaterialPropertyBlock::HasFloat(ShaderPropertyId id) const
{
    return As<float>(Find(id)) != nullptr;
}

bool MaterialPropertyBlock::HasInt(ShaderPropertyId id) const
{
    return As<int>(Find(id)) != nullptr;
}

bool MaterialPropertyBlock::HasVector(ShaderPropertyId id) const
{
    return As<glm::vec4>(Find(id)) != nullptr;
}

bool MaterialPropertyBlock::HasColor(ShaderPropertyId id) const
{
    return As<Color>(Find(id)) != nullptr;
}

bool MaterialPropertyBlock::HasMatrix(ShaderPropertyId id) const
{
    return As<glm::mat4>(Find(id)) != nullptr;
}

bool MaterialPropertyBlock::HasTexture(ShaderPropertyId id) const
{
    return As<TexturePtr>(Find(id)) != nullptr;
}

std::shared_ptr<const GraphicsBuffer> MaterialPropertyBlock::GetBuffer(ShaderPropertyId id) const
{
    const auto* range = As<BufferRange>(Find(id));
    return range != nullptr ? range->buffer : nullptr;
}

bool MaterialPropertyBlock::HasConstantBuffer(ShaderPropertyId id) const
{
    const std::shared_ptr<const GraphicsBuffer> buffer = GetBuffer(id);
    return buffer && buffer->Has(GraphicsBuffer::Target::Constant);
}

bool MaterialPropertyBlock::HasBuffer(ShaderPropertyId id) const
{
    return As<BufferRange>(Find(id)) != nullptr;
}

float Shader::GetGlobalFloat(ShaderPropertyId id)
{
    return FloatIn(Pointer(ShaderGlobals::Find(id)));
}

int Shader::GetGlobalInt(ShaderPropertyId id)
{
    return IntIn(Pointer(ShaderGlobals::Find(id)));
}

glm::vec4 Shader::GetGlobalVector(ShaderPropertyId id)
{
    return VectorIn(Pointer(ShaderGlobals::Find(id)));
}

Color Shader::GetGlobalColor(ShaderPropertyId id)
{
    const glm::vec4 value = GetGlobalVector(id);
    return {value.x, value.y, value.z, value.w};
}

glm::mat4 Shader::GetGlobalMatrix(ShaderPropertyId id)
{
    return CopyOf<glm::mat4>(Pointer(ShaderGlobals::Find(id)));
}

TexturePtr Shader::GetGlobalTexture(ShaderPropertyId id)
{
    return CopyOf<TexturePtr>(Pointer(ShaderGlobals::Find(id)));
}

std::vector<float> Shader::GetGlobalFloatArray(ShaderPropertyId id)
{
    return ArrayIn<float>(Pointer(ShaderGlobals::Find(id)));
}

std::vector<glm::vec4> Shader::GetGlobalVectorArray(ShaderPropertyId id)
{
    return ArrayIn<glm::vec4>(Pointer(ShaderGlobals::Find(id)));
}

std::vector<glm::mat4> Shader::GetGlobalMatrixArray(ShaderPropertyId id)
{
    return ArrayIn<glm::mat4>(Pointer(ShaderGlobals::Find(id)));
}

} // namespace limn
