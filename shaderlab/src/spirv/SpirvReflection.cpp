#include "spirv/SpirvReflection.h"

#include "spirv/StorageAccess.h"

#include <algorithm>
#include <map>
#include <spirv_cross/spirv_cross.hpp>

namespace limn
{

namespace
{

using spirv_cross::SPIRType;

UniformType ScalarOf(const SPIRType& type)
{
    switch (type.basetype)
    {
    case SPIRType::Int:
        return UniformType::Int;
    case SPIRType::UInt:
    case SPIRType::Boolean:
        return UniformType::UInt;
    default:
        return UniformType::Float;
    }
}

constexpr std::uint64_t k_MaxUniformBytes = 65536; ///< Direct3D's limit, and so Unity's

/// Reads one stage into the layout that all stages share.
class StageReflector
{
public:
    StageReflector(std::vector<std::uint32_t>& spirv, ShaderStage stage, PropertyLayout& layout,
                   const std::vector<HlslVariable>& objects, std::vector<std::string>& messages)
        : m_Spirv(spirv),
          m_Compiler(spirv),
          m_Stage(stage),
          m_Layout(layout),
          m_Objects(objects),
          m_Messages(messages)
    {
    }

    void ReadResources(std::uint32_t& nextBinding)
    {
        const auto resources =
            m_Compiler.get_shader_resources(m_Compiler.get_active_interface_variables());
        for (const auto& resource : resources.uniform_buffers)
        {
            Bind(resource.id, m_Layout.buffers, ReadBuffer(resource), nextBinding);
        }
        for (const auto& resource : resources.separate_images)
        {
            Bind(resource.id, m_Layout.textures, ReadTexture(resource, false), nextBinding);
        }
        for (const auto& resource : resources.sampled_images)
        {
            Bind(resource.id, m_Layout.textures, ReadTexture(resource, true), nextBinding);
        }
        for (const auto& resource : resources.separate_samplers)
        {
            Bind(resource.id, m_Layout.samplers, ReadSampler(resource), nextBinding);
        }
        for (const auto& resource : resources.storage_buffers)
        {
            Bind(resource.id, m_Layout.storageBuffers, ReadStorageBuffer(resource), nextBinding);
        }
        if (!resources.storage_images.empty())
        {
            m_ReadImages = FindReadImages(m_Spirv);
        }
        for (const auto& resource : resources.storage_images)
        {
            Bind(resource.id, m_Layout.storageTextures, ReadStorageTexture(resource), nextBinding);
        }
        if (!resources.push_constant_buffers.empty())
        {
            m_Layout.pushStages = m_Layout.pushStages | m_Stage;
        }
        if (m_Stage == ShaderStage::Fragment)
        {
            m_Layout.fragmentHasInputs =
                !resources.stage_inputs.empty() || !resources.builtin_inputs.empty();
        }
        WriteBindings();
    }

    std::array<std::uint32_t, 3> ThreadGroupSize() const
    {
        const auto size = [&](std::uint32_t dimension)
        {
            return m_Compiler.get_execution_mode_argument(spv::ExecutionModeLocalSize, dimension);
        };
        return {size(0), size(1), size(2)};
    }

    void ReadVertexInputs(const std::vector<VertexInput>& declared)
    {
        const auto active = m_Compiler.get_active_interface_variables();
        for (const auto& resource : m_Compiler.get_shader_resources(active).stage_inputs)
        {
            const std::uint32_t location =
                m_Compiler.get_decoration(resource.id, spv::DecorationLocation);
            const auto input = std::find_if(declared.begin(), declared.end(),
                                            [&](const VertexInput& candidate)
                                            { return candidate.location == location; });
            m_Layout.vertexInputs.push_back(*input);
        }
        std::sort(m_Layout.vertexInputs.begin(), m_Layout.vertexInputs.end(),
                  [](const VertexInput& a, const VertexInput& b)
                  { return a.location < b.location; });
    }

    /// Reads the types of the fragment function's outputs.
    void ReadOutputTypes(int count)
    {
        m_Layout.outputTypes.assign(static_cast<std::size_t>(count), UniformType::Float);
        for (const auto& output : m_Compiler.get_shader_resources().stage_outputs)
        {
            const std::uint32_t location =
                m_Compiler.get_decoration(output.id, spv::DecorationLocation);
            if (location < m_Layout.outputTypes.size())
            {
                m_Layout.outputTypes[location] = ScalarOf(m_Compiler.get_type(output.base_type_id));
            }
        }
    }

private:
    /// Takes the entry of another stage where it is the same resource, else adds one.
    template <typename T>
    void Bind(std::uint32_t id, std::vector<T>& list, T item, std::uint32_t& nextBinding)
    {
        for (T& known : list)
        {
            item.binding = known.binding;
            item.stages = known.stages;
            if (item == known)
            {
                known.stages = known.stages | m_Stage;
                m_Bindings[id] = known.binding;
                return;
            }
        }
        item.binding = nextBinding++;
        item.stages = m_Stage;
        m_Bindings[id] = item.binding;
        list.push_back(std::move(item));
    }

    UniformBuffer ReadBuffer(const spirv_cross::Resource& resource)
    {
        UniformBuffer buffer;
        buffer.name = m_Compiler.get_name(resource.base_type_id);
        const SPIRType& type = m_Compiler.get_type(resource.base_type_id);
        const std::uint64_t size = LeastBytes(type) > k_MaxUniformBytes
                                       ? k_MaxUniformBytes + 1
                                       : m_Compiler.get_declared_struct_size(type);
        if (size > k_MaxUniformBytes)
        {
            m_Messages.push_back("constant buffer '" + buffer.name + "' has more than " +
                                 std::to_string(k_MaxUniformBytes) +
                                 " bytes, which are the most that it may have; make it smaller, or "
                                 "use a StructuredBuffer");
            return buffer;
        }
        buffer.size = (static_cast<std::uint32_t>(size) + 15u) & ~15u;
        ReadMembers(type, "", 0, buffer);
        return buffer;
    }

    /// The least that the members take, counted to the first byte too many: SPIRV-Cross counts in
    /// 32 bits, in which an array of 268435457 vectors takes 16 bytes.
    std::uint64_t LeastBytes(const SPIRType& type)
    {
        std::uint64_t sum = 0;
        for (const auto id : type.member_types)
        {
            const SPIRType& member = m_Compiler.get_type(id);
            const bool isStruct = member.basetype == SPIRType::Struct;
            std::uint64_t bytes = isStruct ? LeastBytes(m_Compiler.get_type(member.self))
                                  : member.array.empty() ? 4
                                                         : 16;
            for (const std::uint32_t count : member.array)
            {
                bytes = std::min(bytes * count, k_MaxUniformBytes + 1);
            }
            sum = std::min(sum + bytes, k_MaxUniformBytes + 1);
        }
        return sum;
    }

    void ReadMembers(const SPIRType& type, const std::string& prefix, std::uint32_t base,
                     UniformBuffer& buffer)
    {
        for (std::uint32_t i = 0; i < type.member_types.size(); ++i)
        {
            const SPIRType& member = m_Compiler.get_type(type.member_types[i]);
            const std::string name = prefix + m_Compiler.get_member_name(type.self, i);
            const std::uint32_t offset = base + m_Compiler.type_struct_member_offset(type, i);
            if (member.basetype != SPIRType::Struct)
            {
                buffer.members.push_back(ReadMember(type, i, name, offset, buffer.name));
                continue;
            }
            const std::uint32_t count = member.array.empty() ? 1 : member.array[0];
            const std::uint32_t stride =
                member.array.empty() ? 0 : m_Compiler.type_struct_member_array_stride(type, i);
            for (std::uint32_t element = 0; element < count; ++element)
            {
                const std::string index =
                    member.array.empty() ? "" : "[" + std::to_string(element) + "]";
                ReadMembers(m_Compiler.get_type(member.self), name + index + ".",
                            offset + element * stride, buffer);
            }
        }
    }

    UniformMember ReadMember(const SPIRType& parent, std::uint32_t index, const std::string& name,
                             std::uint32_t offset, const std::string& bufferName)
    {
        const SPIRType& type = m_Compiler.get_type(parent.member_types[index]);
        UniformMember member;
        member.name = name;
        member.offset = offset;
        member.size =
            static_cast<std::uint32_t>(m_Compiler.get_declared_struct_member_size(parent, index));
        member.type = ScalarOf(type);
        member.components = static_cast<int>(type.vecsize);
        if (!type.array.empty())
        {
            member.arraySize = 1;
            for (const std::uint32_t size : type.array)
            {
                member.arraySize *= static_cast<int>(size);
            }
            member.arrayStride = m_Compiler.type_struct_member_array_stride(parent, index);
        }
        if (type.columns > 1)
        {
            ReadMatrix(parent, index, type, member, bufferName);
        }
        return member;
    }

    /// SPIR-V sees HLSL's matrices transposed: RowMajor there is column-major here.
    void ReadMatrix(const SPIRType& parent, std::uint32_t index, const SPIRType& type,
                    UniformMember& member, const std::string& bufferName)
    {
        if (!m_Compiler.has_member_decoration(parent.self, index, spv::DecorationRowMajor))
        {
            m_Messages.push_back(bufferName + ": '" + member.name +
                                 "' is row_major; limn uploads column-major matrices only");
        }
        if (type.columns == 4 && type.vecsize == 4)
        {
            member.type = UniformType::Matrix4x4;
            return;
        }
        // A smaller matrix is the array of its columns.
        member.components = static_cast<int>(type.columns);
        member.arraySize = static_cast<int>(type.vecsize) * std::max(member.arraySize, 1);
        member.arrayStride = 16;
    }

    TextureBinding ReadTexture(const spirv_cross::Resource& resource, bool combined)
    {
        TextureBinding texture;
        texture.name = m_Compiler.get_name(resource.id);
        texture.combinedSampler = combined;
        const SPIRType::ImageType& image = m_Compiler.get_type(resource.base_type_id).image;
        texture.multisampled = image.ms;
        texture.dimension = DimensionOf(image, texture.name);
        texture.type = ScalarOf(m_Compiler.get_type(image.type));
        return texture;
    }

    StorageTextureBinding ReadStorageTexture(const spirv_cross::Resource& resource)
    {
        StorageTextureBinding texture;
        texture.name = m_Compiler.get_name(resource.id);
        const SPIRType& type = m_Compiler.get_type(resource.base_type_id);
        texture.dimension = DimensionOf(type.image, texture.name);
        texture.type = ScalarOf(m_Compiler.get_type(type.image.type));
        texture.isRead = m_ReadImages.contains(resource.id);
        return texture;
    }

    TextureDimension DimensionOf(const SPIRType::ImageType& image, const std::string& name)
    {
        switch (image.dim)
        {
        case spv::Dim2D:
            return image.arrayed ? TextureDimension::Tex2DArray : TextureDimension::Tex2D;
        case spv::Dim3D:
            return TextureDimension::Tex3D;
        case spv::DimCube:
            return image.arrayed ? TextureDimension::CubeArray : TextureDimension::Cube;
        default:
            m_Messages.push_back("'" + name +
                                 "': only textures of 2D, 3D and cube kind, "
                                 "and arrays of them, are supported");
            return TextureDimension::Tex2D;
        }
    }

    SamplerBinding ReadSampler(const spirv_cross::Resource& resource)
    {
        SamplerBinding sampler;
        sampler.name = m_Compiler.get_name(resource.id);
        // SPIR-V has one sampler type for both kinds; only the declaration tells.
        sampler.comparison = std::any_of(m_Objects.begin(), m_Objects.end(),
                                         [&](const HlslVariable& object) {
                                             return object.name == sampler.name &&
                                                    object.type == "SamplerComparisonState";
                                         });
        return sampler;
    }

    StorageBufferBinding ReadStorageBuffer(const spirv_cross::Resource& resource)
    {
        StorageBufferBinding buffer;
        buffer.name = m_Compiler.get_name(resource.id);
        buffer.isWritten =
            !m_Compiler.get_buffer_block_flags(resource.id).get(spv::DecorationNonWritable);
        constexpr std::string_view k_Counter = "@count"; // glslang's
        if (buffer.name.ends_with(k_Counter))
        {
            buffer.name.resize(buffer.name.size() - k_Counter.size());
            buffer.isCounter = true;
            return buffer;
        }
        const bool isOfBytes = std::ranges::any_of(
            m_Objects, [&](const HlslVariable& object)
            { return object.name == buffer.name && object.type.ends_with("ByteAddressBuffer"); });
        const SPIRType& type = m_Compiler.get_type(resource.base_type_id);
        buffer.stride = isOfBytes ? 0 : m_Compiler.type_struct_member_array_stride(type, 0);
        return buffer;
    }

    /// glslang has given every resource a binding; this puts ours in its place.
    void WriteBindings()
    {
        constexpr std::size_t k_HeaderWords = 5;
        for (std::size_t i = k_HeaderWords; i < m_Spirv.size(); i += m_Spirv[i] >> 16)
        {
            if ((m_Spirv[i] & 0xffffu) != spv::OpDecorate)
            {
                continue;
            }
            const auto binding = m_Bindings.find(m_Spirv[i + 1]);
            if (binding == m_Bindings.end())
            {
                continue;
            }
            if (m_Spirv[i + 2] == spv::DecorationBinding)
            {
                m_Spirv[i + 3] = binding->second;
            }
            else if (m_Spirv[i + 2] == spv::DecorationDescriptorSet)
            {
                m_Spirv[i + 3] = 0;
            }
        }
    }

    std::vector<std::uint32_t>& m_Spirv;
    spirv_cross::Compiler m_Compiler;
    ShaderStage m_Stage;
    PropertyLayout& m_Layout;
    const std::vector<HlslVariable>& m_Objects;
    std::vector<std::string>& m_Messages;
    std::map<std::uint32_t, std::uint32_t> m_Bindings;
    std::set<std::uint32_t> m_ReadImages; ///< of writable textures
};

} // namespace

void ReflectLayout(ShaderProgram& pass, const StageLinkage& linkage,
                   const std::vector<HlslVariable>& objects, std::vector<std::string>& messages)
{
    std::uint32_t nextBinding = 0;
    pass.layout = {};
    pass.layout.colorOutputs = linkage.colorOutputs;
    StageReflector vertex(pass.vertexSpirv, ShaderStage::Vertex, pass.layout, objects, messages);
    vertex.ReadResources(nextBinding);
    vertex.ReadVertexInputs(linkage.vertexInputs);
    if (!pass.geometrySpirv.empty())
    {
        StageReflector geometry(pass.geometrySpirv, ShaderStage::Geometry, pass.layout, objects,
                                messages);
        geometry.ReadResources(nextBinding);
    }
    StageReflector fragment(pass.fragmentSpirv, ShaderStage::Fragment, pass.layout, objects,
                            messages);
    fragment.ReadResources(nextBinding);
    fragment.ReadOutputTypes(linkage.colorOutputs);
}

void ReflectKernel(ShaderProgram& kernel, const std::vector<HlslVariable>& objects,
                   std::vector<std::string>& messages)
{
    std::uint32_t nextBinding = 0;
    kernel.layout = {};
    StageReflector reflector(kernel.computeSpirv, ShaderStage::Compute, kernel.layout, objects,
                             messages);
    kernel.threadGroupSize = reflector.ThreadGroupSize();
    reflector.ReadResources(nextBinding);
}

} // namespace limn
