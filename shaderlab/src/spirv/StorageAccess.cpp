#include "spirv/StorageAccess.h"

#include <glslang/SPIRV/spirv.hpp>
#include <limn/base/Diagnostic.h>
#include <spirv-tools/optimizer.hpp>

#include <algorithm>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>

namespace limn
{

namespace
{

/// Works out where Direct3D has the members of structured buffers' elements.
class BufferPacker
{
public:
    explicit BufferPacker(SpirvWords& spirv) : m_Spirv(spirv)
    {
        ForEachDeclaration(std::as_const(spirv),
                           [this](std::uint32_t op, auto words) { Learn(op, words); });
    }

    void Pack()
    {
        for (const Id block : m_Blocks)
        {
            Measure(block);
        }
        if (!m_Blocks.empty())
        {
            ForEachDeclaration(m_Spirv, [this](std::uint32_t op, auto words) { Write(op, words); });
        }
    }

private:
    struct Type
    {
        std::uint32_t op = 0;
        std::vector<std::uint32_t> operands;
    };
    struct Extent
    {
        std::uint32_t size = 0;      ///< bytes
        std::uint32_t alignment = 1; ///< bytes
    };

    void Learn(std::uint32_t op, std::span<const std::uint32_t> words)
    {
        if (op == spv::OpDecorate && words[2] == spv::DecorationBufferBlock)
        {
            m_Blocks.push_back(words[1]);
        }
        else if (op == spv::OpMemberDecorate && words[3] == spv::DecorationRowMajor)
        {
            m_RowMajor.insert({words[1], words[2]});
        }
        else if (op == spv::OpConstant)
        {
            m_Constants[words[2]] = words[3];
        }
        else if (op >= spv::OpTypeVoid && op <= spv::OpTypeStruct)
        {
            m_Types[words[1]] = {op, {words.begin() + 2, words.end()}};
        }
    }

    /// Returns the extent of a type that lies in a buffer, and notes the places of its parts.
    Extent Measure(Id id)
    {
        const Type& type = m_Types[id];
        switch (type.op)
        {
        case spv::OpTypeFloat:
        case spv::OpTypeInt:
            return {type.operands[0] / 8, type.operands[0] / 8};
        case spv::OpTypeVector:
        case spv::OpTypeMatrix:
            return Times(Measure(type.operands[0]), type.operands[1]);
        case spv::OpTypeArray:
        case spv::OpTypeRuntimeArray:
        {
            const Extent element = Measure(type.operands[0]);
            m_Strides[id] = element.size;
            const bool isEndless = type.op == spv::OpTypeRuntimeArray;
            return Times(element, isEndless ? 0 : m_Constants[type.operands[1]]);
        }
        case spv::OpTypeStruct:
            return MeasureStruct(id, type);
        default:
            return {};
        }
    }

    Extent MeasureStruct(Id id, const Type& type)
    {
        Extent all;
        for (std::uint32_t i = 0; i < type.operands.size(); ++i)
        {
            const Extent member = Measure(type.operands[i]);
            all.alignment = std::max(all.alignment, member.alignment);
            all.size = RoundUp(all.size, member.alignment);
            m_Offsets[{id, i}] = all.size;
            m_MatrixStrides[{id, i}] = MatrixStride(type.operands[i], m_RowMajor.contains({id, i}));
            all.size += member.size;
        }
        all.size = RoundUp(all.size, all.alignment);
        return all;
    }

    /// From one row or column to the next, of a matrix or an array of them.
    std::uint32_t MatrixStride(Id id, bool isRowMajor)
    {
        const Type& type = m_Types[id];
        if (type.op == spv::OpTypeArray || type.op == spv::OpTypeRuntimeArray)
        {
            return MatrixStride(type.operands[0], isRowMajor);
        }
        if (type.op != spv::OpTypeMatrix)
        {
            return 0;
        }
        const Extent column = Measure(type.operands[0]);
        return isRowMajor ? column.alignment * type.operands[1] : column.size;
    }

    void Write(std::uint32_t op, std::span<std::uint32_t> words)
    {
        if (op == spv::OpDecorate && words.size() > 3 && words[2] == spv::DecorationArrayStride)
        {
            const auto stride = m_Strides.find(words[1]);
            words[3] = stride == m_Strides.end() ? words[3] : stride->second;
        }
        else if (op == spv::OpMemberDecorate && words.size() > 4)
        {
            const auto& places =
                words[3] == spv::DecorationMatrixStride ? m_MatrixStrides : m_Offsets;
            const bool isPlace =
                words[3] == spv::DecorationMatrixStride || words[3] == spv::DecorationOffset;
            const auto place = places.find({words[1], words[2]});
            words[4] = isPlace && place != places.end() ? place->second : words[4];
        }
    }

    static Extent Times(const Extent& part, std::uint32_t count)
    {
        return {part.size * count, part.alignment};
    }
    static std::uint32_t RoundUp(std::uint32_t size, std::uint32_t alignment)
    {
        return (size + alignment - 1) / alignment * alignment;
    }

    using Member = std::pair<Id, std::uint32_t>; ///< of a struct

    SpirvWords& m_Spirv;
    std::vector<Id> m_Blocks;
    std::unordered_map<Id, Type> m_Types;
    std::unordered_map<Id, std::uint32_t> m_Constants;
    std::set<Member> m_RowMajor;
    std::map<Member, std::uint32_t> m_Offsets;
    std::map<Member, std::uint32_t> m_MatrixStrides;
    std::unordered_map<Id, std::uint32_t> m_Strides; ///< of arrays
};

bool isAtomicWithValue(std::uint32_t op)
{
    return op == spv::OpAtomicExchange || op == spv::OpAtomicCompareExchange ||
           (op >= spv::OpAtomicIAdd && op <= spv::OpAtomicXor);
}

/// Types that are equal now become one.
void RemoveDuplicates(SpirvWords& spirv)
{
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    optimizer.RegisterPass(spvtools::CreateRemoveDuplicatesPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    SpirvWords result;
    if (!optimizer.Run(spirv.data(), spirv.size(), &result, options))
    {
        throw ContractError("the HLSL compiler's SPIR-V cannot be read");
    }
    spirv = std::move(result);
}

} // namespace

void PackStructuredBuffers(SpirvWords& spirv)
{
    BufferPacker(spirv).Pack();
}

void ConvertAtomicValues(SpirvWords& spirv)
{
    constexpr std::size_t k_FirstValue = 6; // word
    std::unordered_map<Id, Id> types;       // of results
    SpirvWords result(spirv.begin(), spirv.begin() + k_SpirvHeaderSize);
    for (SpirvInstruction& instruction : ParseSpirv(spirv))
    {
        types[instruction.result] = instruction.type;
        const std::size_t first =
            k_FirstValue + (instruction.op == spv::OpAtomicCompareExchange ? 1 : 0);
        for (std::size_t i = first;
             isAtomicWithValue(instruction.op) && i < instruction.words.size(); ++i)
        {
            Id& value = instruction.words[i];
            if (types[value] != instruction.type)
            {
                const Id converted = result[k_SpirvBoundWord]++;
                result.insert(result.end(),
                              {(4u << 16) | spv::OpBitcast, instruction.type, converted, value});
                value = converted;
            }
        }
        result.insert(result.end(), instruction.words.begin(), instruction.words.end());
    }
    spirv = std::move(result);
}

void LeaveImageFormatsOpen(SpirvWords& spirv)
{
    constexpr std::size_t k_Sampled = 7; // words
    constexpr std::size_t k_Format = 8;
    bool isAny = false;
    ForEachDeclaration(spirv,
                       [&](std::uint32_t op, std::span<std::uint32_t> words)
                       {
                           const bool isWritable = op == spv::OpTypeImage && words[k_Sampled] == 2;
                           if (isWritable && words[k_Format] != spv::ImageFormatR32i &&
                               words[k_Format] != spv::ImageFormatR32ui)
                           {
                               words[k_Format] = spv::ImageFormatUnknown;
                               isAny = true;
                           }
                           // No format is left that needs this capability.
                           const bool isExtended =
                               op == spv::OpCapability &&
                               words[1] == spv::CapabilityStorageImageExtendedFormats;
                           words[1] = isExtended ? std::uint32_t{spv::CapabilityShader} : words[1];
                       });
    if (!isAny)
    {
        return;
    }
    const std::uint32_t head = (2u << 16) | spv::OpCapability;
    SpirvWords added = {head, spv::CapabilityStorageImageWriteWithoutFormat};
    if (!FindReadImages(spirv).empty())
    {
        added.insert(added.end(), {head, spv::CapabilityStorageImageReadWithoutFormat});
    }
    spirv.insert(spirv.begin() + k_SpirvHeaderSize, added.begin(), added.end());
    RemoveDuplicates(spirv);
}

bool MergeComparedTextures(SpirvWords& spirv)
{
    constexpr std::size_t k_Depth = 4; // word
    std::set<SpirvWords> images;       // what each type is beside its depth
    bool hasTwo = false;
    ForEachDeclaration(spirv,
                       [&](std::uint32_t op, std::span<std::uint32_t> words)
                       {
                           if (op == spv::OpTypeImage)
                           {
                               words[k_Depth] = 0;
                               const auto rest = words.subspan(2);
                               hasTwo |= !images.insert({rest.begin(), rest.end()}).second;
                           }
                       });
    if (hasTwo)
    {
        RemoveDuplicates(spirv);
    }
    return hasTwo;
}

std::set<Id> FindReadImages(const SpirvWords& spirv)
{
    constexpr std::size_t k_Pointer = 3; // words
    constexpr std::size_t k_Image = 3;
    std::unordered_map<Id, Id> variables; // by what is loaded of them
    std::set<Id> read;
    for (const SpirvInstruction& instruction : ParseSpirv(spirv))
    {
        if (instruction.op == spv::OpLoad)
        {
            variables[instruction.result] = instruction.words[k_Pointer];
        }
        else if (instruction.op == spv::OpImageRead)
        {
            read.insert(variables[instruction.words[k_Image]]);
        }
    }
    return read;
}

} // namespace limn
