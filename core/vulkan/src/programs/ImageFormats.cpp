#include "programs/ImageFormats.h"

#include "device/Spirv.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <string>
#include <utility>

namespace limn::vulkan
{

namespace
{

// These numbers are from the SPIR-V specification.
constexpr std::uint32_t k_ExtendedFormats = 49; // capabilities
constexpr std::uint32_t k_ReadWithoutFormat = 55;
constexpr std::uint32_t k_Binding = 33; // a decoration

struct FormatNumber
{
    GraphicsFormat format;
    std::uint32_t imageFormat;
};
constexpr FormatNumber k_ImageFormats[] = {
    {GraphicsFormat::R32G32B32A32_SFloat, 1},
    {GraphicsFormat::R16G16B16A16_SFloat, 2},
    {GraphicsFormat::R32_SFloat, 3},
    {GraphicsFormat::R8G8B8A8_UNorm, 4},
    {GraphicsFormat::R8G8B8A8_SNorm, 5},
    {GraphicsFormat::R32G32_SFloat, 6},
    {GraphicsFormat::R16G16_SFloat, 7},
    {GraphicsFormat::B10G11R11_UFloatPack32, 8},
    {GraphicsFormat::R16_SFloat, 9},
    {GraphicsFormat::R16G16B16A16_UNorm, 10},
    {GraphicsFormat::A2B10G10R10_UNormPack32, 11},
    {GraphicsFormat::R16G16_UNorm, 12},
    {GraphicsFormat::R8G8_UNorm, 13},
    {GraphicsFormat::R16_UNorm, 14},
    {GraphicsFormat::R8_UNorm, 15},
    {GraphicsFormat::R16G16B16A16_SNorm, 16},
    {GraphicsFormat::R16G16_SNorm, 17},
    {GraphicsFormat::R8G8_SNorm, 18},
    {GraphicsFormat::R16_SNorm, 19},
    {GraphicsFormat::R8_SNorm, 20},
    {GraphicsFormat::R32G32B32A32_SInt, 21},
    {GraphicsFormat::R16G16B16A16_SInt, 22},
    {GraphicsFormat::R8G8B8A8_SInt, 23},
    {GraphicsFormat::R32_SInt, 24},
    {GraphicsFormat::R32G32_SInt, 25},
    {GraphicsFormat::R16G16_SInt, 26},
    {GraphicsFormat::R8G8_SInt, 27},
    {GraphicsFormat::R16_SInt, 28},
    {GraphicsFormat::R8_SInt, 29},
    {GraphicsFormat::R32G32B32A32_UInt, 30},
    {GraphicsFormat::R16G16B16A16_UInt, 31},
    {GraphicsFormat::R8G8B8A8_UInt, 32},
    {GraphicsFormat::R32_UInt, 33},
    {GraphicsFormat::A2B10G10R10_UIntPack32, 34},
    {GraphicsFormat::R32G32_UInt, 35},
    {GraphicsFormat::R16G16_UInt, 36},
    {GraphicsFormat::R8G8_UInt, 37},
    {GraphicsFormat::R16_UInt, 38},
    {GraphicsFormat::R8_UInt, 39},
};

class FormatWriter
{
public:
    FormatWriter(const Words& spirv, const std::map<std::uint32_t, std::uint32_t>& formats)
        : m_Spirv(spirv), m_Result(spirv.begin(), spirv.begin() + k_HeaderSize)
    {
        EachInstruction(m_Spirv, [&](std::uint32_t op, std::span<const std::uint32_t> words)
                        { Learn(op, words, formats); });
    }

    Words Write()
    {
        Add({(2u << 16) | OpCapability, k_ExtendedFormats});
        EachInstruction(m_Spirv, [this](std::uint32_t op, std::span<const std::uint32_t> words)
                        { Copy(op, words); });
        return std::move(m_Result);
    }

private:
    struct Types
    {
        std::uint32_t image = 0;
        std::uint32_t pointer = 0;
    };

    void Learn(std::uint32_t op, std::span<const std::uint32_t> words,
               const std::map<std::uint32_t, std::uint32_t>& formats)
    {
        if (op == OpDecorate && words[2] == k_Binding && formats.contains(words[3]))
        {
            m_Formats[words[1]] = formats.at(words[3]);
        }
        else if (op == OpTypeImage)
        {
            m_Images[words[1]] = {words.begin(), words.end()};
        }
        else if (op == OpTypePointer)
        {
            m_Pointers[words[1]] = {words.begin(), words.end()};
        }
    }

    void Copy(std::uint32_t op, std::span<const std::uint32_t> words)
    {
        if (op == OpCapability && words[1] == k_ReadWithoutFormat)
        {
            return; // the device may lack it, and each that is read has a format now
        }
        const std::size_t begin = m_Result.size();
        const bool isVariable = op == OpVariable && m_Formats.contains(words[2]);
        const bool isLoad = op == OpLoad && m_Formats.contains(words[3]);
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

} // namespace

std::uint32_t ToImageFormat(GraphicsFormat format)
{
    const auto found = std::ranges::find(k_ImageFormats, format, &FormatNumber::format);
    if (found == std::end(k_ImageFormats))
    {
        throw ContractError(std::string("no kernel reads and writes a texture of format ") +
                            ToString(format));
    }
    return found->imageFormat;
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

std::vector<std::uint32_t> WithFormats(const std::vector<std::uint32_t>& spirv,
                                       const std::map<std::uint32_t, std::uint32_t>& formats)
{
    return formats.empty() ? spirv : FormatWriter(spirv, formats).Write();
}

} // namespace limn::vulkan
