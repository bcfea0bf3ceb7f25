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
                   std::uint32_t& nextBinding, const std::vector<HlslVariable>& objects,
                   std::vector<std::string>& messages)
        : m_Spirv(spirv),
          m_Compiler(spirv),
          m_Stage(stage),
          m_Layout(layout),
          m_NextBinding(nextBinding),
          m_Objects(objects),
          m_Messages(messages)
    {
    }

    void ReadResources()
    {
        const auto resources =
            m_Compiler.get_shader_resources(m_Compiler.get_active_interface_variables());
        if (!resources.storage_images.empty())
        {
            m_ReadImages = FindReadImages(m_Spirv);
        }
        Bind(resources.uniform_buffers, m_Layout.buffers, &StageReflector::ReadBuffer);
        Bind(resources.separate_images, m_Layout.textures, &StageReflector::ReadTexture);
        Bind(resources.sampled_images, m_Layout.textures, &StageReflector::ReadTexture);
        Bind(resources.separate_samplers, m_Layout.samplers, &StageReflector::ReadSampler);
        Bind(resources.storage_buffers, m_Layout.storageBuffers,
             &StageReflector::ReadStorageBuffer);
        Bind(resources.storage_images, m_Layout.storageTextures,
             &StageReflector::ReadStorageTexture);
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
            m_Layout.vertexInputs.push_back(
                *std::ranges::find(declared, location, &VertexInput::location));
        }
        std::ranges::sort(m_Layout.vertexInputs, {}, &VertexInput::location);
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
    void Bind(const spirv_cross::SmallVector<spirv_cross::Resource>& resources,
              std::vector<T>& list, T (StageReflector::*read)(const spirv_cross::Resource&))
    {
        for (const spirv_cross::Resource& resource : resources)
        {
            T item = (this->*read)(resource);
            const auto isSame = [&](const T& other)
            {
                item.binding = other.binding;
                item.stages = other.stages;
                return item == other;
            };
            auto known = std::find_if(list.begin(), list.end(), isSame);
            if (known == list.end())
            {
                item.binding = m_NextBinding++;
                item.stages = ShaderStage::None;
                known = list.insert(known, std::move(item));
            }
            known->stages = known->stages | m_Stage;
            m_Bindings[resource.id] = known->binding;
        }
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

    TextureBinding ReadTexture(const spirv_cross::Resource& resource)
    {
        TextureBinding texture;
        texture.name = m_Compiler.get_name(resource.id);
        const SPIRType& type = m_Compiler.get_type(resource.base_type_id);
        texture.combinedSampler = type.basetype == SPIRType::SampledImage;
        texture.multisampled = type.image.ms;
        texture.dimension = DimensionOf(type.image, texture.name);
        texture.type = ScalarOf(m_Compiler.get_type(type.image.type));
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
        sampler.comparison = std::ranges::any_of(
            m_Objects, [&](const HlslVariable& object)
            { return object.name == sampler.name && object.type == "SamplerComparisonState"; });
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
        ForEachDeclaration(m_Spirv,
                           [this](std::uint32_t op, std::span<std::uint32_t> words)
                           {
                               const auto binding = op == spv::OpDecorate
                                                        ? m_Bindings.find(words[1])
                                                        : m_Bindings.end();
                               if (binding == m_Bindings.end())
                               {
                                   return;
                               }
                               if (words[2] == spv::DecorationBinding)
                               {
                                   words[3] = binding->second;
                               }
                               else if (words[2] == spv::DecorationDescriptorSet)
                               {
                                   words[3] = 0;
                               }
                           });
    }

    std::vector<std::uint32_t>& m_Spirv;
    spirv_cross::Compiler m_Compiler;
    ShaderStage m_Stage;
    PropertyLayout& m_Layout;
    std::uint32_t& m_NextBinding;
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
    const std::pair<ShaderStage, SpirvWords&> stages[] = {
        {ShaderStage::Vertex, pass.vertexSpirv},
        {ShaderStage::Geometry, pass.geometrySpirv},
        {ShaderStage::Fragment, pass.fragmentSpirv},
        {ShaderStage::Compute, pass.computeSpirv}};
    for (const auto& [stage, spirv] : stages)
    {
        if (spirv.empty())
        {
            continue;
        }
        StageReflector reflector(spirv, stage, pass.layout, nextBinding, objects, messages);
        reflector.ReadResources();
        if (stage == ShaderStage::Vertex)
        {
            reflector.ReadVertexInputs(linkage.vertexInputs);
        }
        else if (stage == ShaderStage::Fragment)
        {
            reflector.ReadOutputTypes(linkage.colorOutputs);
        }
        else if (stage == ShaderStage::Compute)
        {
            pass.threadGroupSize = reflector.ThreadGroupSize();
        }
    }
}

} // namespace limn
