#include "spirv/ScalarLayout.h"

#include <algorithm>
#include <spirv_cross/spirv_cross.hpp>

namespace limn
{

namespace
{

using spirv_cross::SPIRType;

/// Vulkan's rules for storage buffers without scalarBlockLayout (15.8.4, "Offset and Stride
/// Assignment"): those of std430, but that vectors may lie at any multiple of their component's
/// size as long as they do not straddle 16 bytes.
class StandardLayout
{
public:
    explicit StandardLayout(const spirv_cross::Compiler& compiler) : m_Compiler(compiler) {}

    /// @param offset  of the struct within the element
    bool Fits(const SPIRType& type, std::uint32_t offset) const
    {
        for (std::uint32_t i = 0; i < type.member_types.size(); ++i)
        {
            const SPIRType& member = m_Compiler.get_type(type.member_types[i]);
            const std::uint32_t at = offset + m_Compiler.type_struct_member_offset(type, i);
            const std::uint32_t stride =
                member.array.empty() ? 0 : m_Compiler.type_struct_member_array_stride(type, i);
            if (!FitsMember(member, at, stride))
            {
                return false;
            }
        }
        return true;
    }

    bool FitsMember(const SPIRType& type, std::uint32_t at, std::uint32_t stride) const
    {
        const std::uint32_t alignment = AlignmentOf(type);
        if (stride % alignment != 0)
        {
            return false;
        }
        if (type.basetype == SPIRType::Struct)
        {
            return at % alignment == 0 && Fits(type, at);
        }
        const bool isVector = type.columns == 1 && type.array.empty();
        const std::uint32_t size = type.vecsize * SizeOf(type);
        const bool isStraddling =
            size > k_Row ? at % k_Row != 0 : at / k_Row != (at + size - 1) / k_Row;
        return isVector ? at % SizeOf(type) == 0 && !isStraddling : at % alignment == 0;
    }

private:
    static constexpr std::uint32_t k_Row = 16; // bytes

    static std::uint32_t SizeOf(const SPIRType& type) { return std::max(type.width / 8u, 1u); }

    std::uint32_t AlignmentOf(const SPIRType& type) const
    {
        if (type.basetype != SPIRType::Struct)
        {
            return SizeOf(type) * (type.vecsize == 1 ? 1u : type.vecsize == 2 ? 2u : 4u);
        }
        std::uint32_t alignment = 1;
        for (const auto& member : type.member_types)
        {
            alignment = std::max(alignment, AlignmentOf(m_Compiler.get_type(member)));
        }
        return alignment;
    }

    const spirv_cross::Compiler& m_Compiler;
};

} // namespace

std::string ScalarBuffers(const std::vector<std::uint32_t>& spirv)
{
    if (spirv.empty())
    {
        return {};
    }
    const spirv_cross::Compiler compiler(spirv);
    const StandardLayout layout(compiler);
    std::string names;
    for (const auto& resource : compiler.get_shader_resources().storage_buffers)
    {
        if (!layout.Fits(compiler.get_type(resource.base_type_id), 0))
        {
            const std::string name = compiler.get_name(resource.id);
            names += (names.empty() ? "" : ", ") + (name.empty() ? resource.name : name);
        }
    }
    return names;
}

} // namespace limn
