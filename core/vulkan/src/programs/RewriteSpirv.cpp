#include "programs/RewriteSpirv.h"

#include <algorithm>
#include <bit>
#include <limn/base/Diagnostic.h>
#include <string>
#include <utility>

namespace limn::vulkan
{

namespace
{

using Instruction = std::span<const std::uint32_t>;

class FormatWriter
{
public:
    FormatWriter(const Words& spirv, const ImageFormats& formats)
        : m_Spirv(spirv), m_Result(spirv.begin(), spirv.begin() + k_HeaderSize)
    {
        EachInstruction(m_Spirv,
                        [&](std::uint32_t op, Instruction words) { Learn(op, words, formats); });
    }

    Words Write()
    {
        Add({(2u << 16) | spv::OpCapability, spv::CapabilityStorageImageExtendedFormats});
        EachInstruction(m_Spirv, [this](std::uint32_t op, Instruction words) { Copy(op, words); });
        return std::move(m_Result);
    }

private:
    struct Types
    {
        std::uint32_t image = 0;
        std::uint32_t pointer = 0;
    };

    void Learn(std::uint32_t op, Instruction words, const ImageFormats& formats)
    {
        if (op == spv::OpDecorate && words[2] == spv::DecorationBinding &&
            formats.contains(words[3]))
        {
            m_Formats[words[1]] = formats.at(words[3]);
        }
        else if (op == spv::OpTypeImage)
        {
            m_Images[words[1]] = {words.begin(), words.end()};
        }
        else if (op == spv::OpTypePointer)
        {
            m_Pointers[words[1]] = {words.begin(), words.end()};
        }
    }

    void Copy(std::uint32_t op, Instruction words)
    {
        if (op == spv::OpCapability && words[1] == spv::CapabilityStorageImageReadWithoutFormat)
        {
            return; // the device may lack it, and each that is read has a format now
        }
        const std::size_t begin = m_Result.size();
        const bool isVariable = op == spv::OpVariable && m_Formats.contains(words[2]);
        const bool isLoad = op == spv::OpLoad && m_Formats.contains(words[3]);
        std::uint32_t type = 0;
        if (isVariable)
        {
            m_Types[words[2]] = TypesFor(words[1], m_Formats[words[2]]);
            type = m_Types[words[2]].pointer;
        }
        else if (isLoad)
        {
            type = m_Types[words[3]].image;
        }
        const std::size_t place = isVariable ? m_Result.size() : begin; // behind types made
        m_Result.insert(m_Result.end(), words.begin(), words.end());
        m_Result[place + 1] = type != 0 ? type : m_Result[place + 1];
    }

    /// Equal ones of several variables are one.
    const Types& TypesFor(std::uint32_t pointer, std::uint32_t format)
    {
        Words pointerWords = m_Pointers[pointer];
        Words imageWords = m_Images[pointerWords[3]];
        const auto [known, isNew] = m_Made.try_emplace({pointerWords[3], format});
        if (isNew && imageWords[8] == format) // of an atomic operation it is known
        {
            known->second = {pointerWords[3], pointer};
        }
        else if (isNew)
        {
            known->second = {m_Result[k_BoundWord], m_Result[k_BoundWord] + 1};
            m_Result[k_BoundWord] += 2;
            imageWords[1] = known->second.image;
            imageWords[8] = format;
            pointerWords[1] = known->second.pointer;
            pointerWords[3] = known->second.image;
            Add(imageWords);
            Add(pointerWords);
        }
        return known->second;
    }

    void Add(const Words& words) { m_Result.insert(m_Result.end(), words.begin(), words.end()); }

    const Words& m_Spirv;
    Words m_Result;
    std::map<std::uint32_t, std::uint32_t> m_Formats;                ///< by variable
    std::map<std::uint32_t, Words> m_Images;                         ///< types by id
    std::map<std::uint32_t, Words> m_Pointers;                       ///< types by id
    std::map<std::pair<std::uint32_t, std::uint32_t>, Types> m_Made; ///< by image type and format
    std::map<std::uint32_t, Types> m_Types;                          ///< by variable
};

class SizeWriter
{
public:
    SizeWriter(const Words& spirv, std::uint32_t floatType)
        : m_Spirv(spirv), m_Result(spirv.begin(), spirv.begin() + k_HeaderSize), m_Float(floatType)
    {
        m_Pointer = m_Result[k_BoundWord];
        m_One = m_Pointer + 1;
        m_Variable = m_Pointer + 2;
        m_Result[k_BoundWord] += 3;
    }

    Words Write()
    {
        EachInstruction(m_Spirv, [this](std::uint32_t op, Instruction words) { Copy(op, words); });
        return std::move(m_Result);
    }

private:
    void Copy(std::uint32_t op, Instruction words)
    {
        if (op >= spv::OpTypeVoid && op <= spv::OpTypeForwardPointer && !m_IsDecorated)
        {
            m_IsDecorated = true; // annotations come before all types
            Add(spv::OpDecorate, {m_Variable, spv::DecorationBuiltIn, spv::BuiltInPointSize});
        }
        if (op == spv::OpFunction)
        {
            Declare();
            m_IsEntry = words[2] == m_Entry;
        }
        const bool isAtTop = op == spv::OpVariable || op == spv::OpLine || op == spv::OpNoLine;
        if (m_IsInFirstBlock && !isAtTop)
        {
            m_IsInFirstBlock = false;
            Add(spv::OpStore, {m_Variable, m_One});
        }
        m_Result.insert(m_Result.end(), words.begin(), words.end());
        if (op == spv::OpEntryPoint)
        {
            m_Entry = words[2];
            m_Result[m_Result.size() - words.size()] += 1u << 16; // a word longer
            m_Result.push_back(m_Variable);
        }
        if (op == spv::OpLabel && m_IsEntry)
        {
            m_IsEntry = false;
            m_IsInFirstBlock = true;
        }
    }

    /// Before the first function.
    void Declare()
    {
        if (!std::exchange(m_IsDeclared, true))
        {
            Add(spv::OpTypePointer, {m_Pointer, spv::StorageClassOutput, m_Float});
            Add(spv::OpConstant, {m_Float, m_One, std::bit_cast<std::uint32_t>(1.0f)});
            Add(spv::OpVariable, {m_Pointer, m_Variable, spv::StorageClassOutput});
        }
    }

    void Add(std::uint32_t op, std::initializer_list<std::uint32_t> operands)
    {
        m_Result.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | op);
        m_Result.insert(m_Result.end(), operands);
    }

    const Words& m_Spirv;
    Words m_Result;
    std::uint32_t m_Float;
    std::uint32_t m_Pointer;
    std::uint32_t m_One;
    std::uint32_t m_Variable;
    std::uint32_t m_Entry = 0;
    bool m_IsDecorated = false;
    bool m_IsDeclared = false;
    bool m_IsEntry = false;        ///< in the entry function, before its first block
    bool m_IsInFirstBlock = false; ///< of it, where only variables were so far
};

} // namespace

std::uint32_t ToImageFormat(GraphicsFormat format)
{
    using enum GraphicsFormat;
    // In the order of their numbers, which count from 1.
    static constexpr GraphicsFormat k_Formats[] = {R32G32B32A32_SFloat,
                                                   R16G16B16A16_SFloat,
                                                   R32_SFloat,
                                                   R8G8B8A8_UNorm,
                                                   R8G8B8A8_SNorm,
                                                   R32G32_SFloat,
                                                   R16G16_SFloat,
                                                   B10G11R11_UFloatPack32,
                                                   R16_SFloat,
                                                   R16G16B16A16_UNorm,
                                                   A2B10G10R10_UNormPack32,
                                                   R16G16_UNorm,
                                                   R8G8_UNorm,
                                                   R16_UNorm,
                                                   R8_UNorm,
                                                   R16G16B16A16_SNorm,
                                                   R16G16_SNorm,
                                                   R8G8_SNorm,
                                                   R16_SNorm,
                                                   R8_SNorm,
                                                   R32G32B32A32_SInt,
                                                   R16G16B16A16_SInt,
                                                   R8G8B8A8_SInt,
                                                   R32_SInt,
                                                   R32G32_SInt,
                                                   R16G16_SInt,
                                                   R8G8_SInt,
                                                   R16_SInt,
                                                   R8_SInt,
                                                   R32G32B32A32_UInt,
                                                   R16G16B16A16_UInt,
                                                   R8G8B8A8_UInt,
                                                   R32_UInt,
                                                   A2B10G10R10_UIntPack32,
                                                   R32G32_UInt,
                                                   R16G16_UInt,
                                                   R8G8_UInt,
                                                   R16_UInt,
                                                   R8_UInt};
    const auto found = std::ranges::find(k_Formats, format);
    if (found == std::end(k_Formats))
    {
        throw ContractError(std::string("no kernel reads and writes a texture of format ") +
                            ToString(format));
    }
    return static_cast<std::uint32_t>(found - std::begin(k_Formats) + 1);
}

bool isExtended(std::uint32_t imageFormat)
{
    // The plain formats are the first ones of each of four kinds of components.
    const auto isPlain = [&](std::uint32_t first, std::uint32_t last)
    {
        return imageFormat >= first && imageFormat <= last;
    };
    return !isPlain(1, 5) && !isPlain(21, 24) && !isPlain(30, 33);
}

Words WithFormats(const Words& spirv, const ImageFormats& formats)
{
    return formats.empty() ? spirv : FormatWriter(spirv, formats).Write();
}

Words WithPointSize(const Words& vertexSpirv)
{
    std::uint32_t floatType = 0;
    EachInstruction(vertexSpirv,
                    [&](std::uint32_t op, Instruction words)
                    {
                        const bool isFloat = op == spv::OpTypeFloat && words[2] == 32;
                        floatType = isFloat ? words[1] : floatType;
                    });
    // A position is made of floats, so that there is the type.
    const bool isComplete = HasBuiltIn(vertexSpirv, spv::BuiltInPointSize) || floatType == 0;
    return isComplete ? vertexSpirv : SizeWriter(vertexSpirv, floatType).Write();
}

} // namespace limn::vulkan
