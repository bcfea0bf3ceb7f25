#include "unity/TextTexture.h"

#include "unity/UnityFields.h"

#include <algorithm>
#include <limn/core/GraphicsFormatUtility.h>
#include <limn/core/QualitySettings.h>
#include <limn/core/SystemInfo.h>

namespace limn
{

namespace
{

class TextTextureReader : public UnityFields
{
public:
    TextTextureReader(UnityClass classID, const UnityNode& fields, const std::string& file)
        : UnityFields(fields, file), m_Class(classID)
    {
    }

    std::shared_ptr<const Texture> Read()
    {
        m_Width = Number(m_Fields["m_Width"], k_MostTexels);
        m_Height = Number(m_Fields["m_Height"], k_MostTexels);
        m_Depth = m_Class == UnityClass::Texture2D ? 1 : Number(m_Fields["m_Depth"], k_MostSlices);
        m_Levels = std::max<std::size_t>(Number(m_Fields["m_MipCount"], 15), 1);
        ReadFormat();
        try
        {
            return Make();
        }
        catch (const ContractError& error)
        {
            Fail(m_Fields, error.what());
        }
    }

    std::shared_ptr<const RenderTexture> ReadTarget()
    {
        RenderTextureDescriptor target;
        target.width = static_cast<int>(Number(m_Fields["m_Width"], k_MostTexels));
        target.height = static_cast<int>(Number(m_Fields["m_Height"], k_MostTexels));
        // Every device draws with 1 and with 4 samples, and not every one with 2 or 8.
        target.msaaSamples = Number(m_Fields["m_AntiAliasing"], 8) > 1 ? 4 : 1;
        target.useMipMap = m_Fields["m_MipMap"].text() == "1";
        target.graphicsFormat = TargetFormat();
        if (const UnityNode dimension = m_Fields["m_Dimension"];
            dimension && Number(dimension, 5) != static_cast<std::size_t>(TextureDimension::Tex2D))
        {
            Fail(dimension, "limn has no render textures but 2D ones, whose m_Dimension is 2");
        }
        try
        {
            return std::make_shared<const RenderTexture>(std::string(m_Fields["m_Name"].text()),
                                                         target, ReadSampler());
        }
        catch (const ContractError& error)
        {
            Fail(m_Fields, error.what());
        }
    }

private:
    static constexpr std::size_t k_MostTexels = 16384;
    static constexpr std::size_t k_MostSlices = 2048;

    /// A Texture2D has saved a TextureFormat in all versions. The others have one in the first
    /// version, and a GraphicsFormat in those that have a number.
    void ReadFormat()
    {
        const bool isOld = !m_Fields["serializedVersion"];
        const bool isSRGB = m_Fields["m_ColorSpace"].text() == "1" &&
                            QualitySettings::activeColorSpace() == ColorSpace::Linear;
        const UnityNode node =
            m_Fields[m_Class == UnityClass::Texture2D ? "m_TextureFormat" : "m_Format"];
        const std::size_t number = Number(node, 1000);
        if (m_Class != UnityClass::Texture2D && !isOld)
        {
            m_Format = static_cast<GraphicsFormat>(number);
            return;
        }
        const auto format = static_cast<TextureFormat>(number);
        m_IsAlphaFirst = format == TextureFormat::ARGB32;
        if (format == TextureFormat::Alpha8)
        {
            Fail(node, "the format Alpha8 is one that limn does not read; R8 would do");
        }
        try
        {
            m_Format = GraphicsFormatUtility::GetGraphicsFormat(
                m_IsAlphaFirst ? TextureFormat::RGBA32 : format, isSRGB);
        }
        catch (const ContractError& error)
        {
            Fail(node, error.what());
        }
    }

    /// A render texture has saved a RenderTextureFormat before the third version, and a
    /// GraphicsFormat since.
    GraphicsFormat TargetFormat() const
    {
        const UnityNode node = m_Fields["m_ColorFormat"];
        const std::size_t number = Number(node, 1000);
        GraphicsFormat format = static_cast<GraphicsFormat>(number);
        if (Number(m_Fields["serializedVersion"], 1000) < 3)
        {
            const bool isSRGB = m_Fields["m_SRGB"].text() == "1" &&
                                QualitySettings::activeColorSpace() == ColorSpace::Linear;
            format = ToGraphicsFormat(static_cast<RenderTextureFormat>(number), isSRGB);
        }
        if (!SystemInfo::IsFormatSupported(format, FormatUsage::Render) || IsDepthFormat(format))
        {
            Fail(node, "the format " + std::to_string(number) +
                           " is no colour that the device can draw into");
        }
        return format;
    }

    std::shared_ptr<const Texture> Make()
    {
        const bool isVolume = m_Class == UnityClass::Texture3D;
        if (GraphicsFormatUtility::IsCompressedFormat(m_Format))
        {
            Fail(m_Fields, std::string("the format ") + ToString(m_Format) +
                               " is compressed, which limn does not read; set it to one that is "
                               "not in Unity and save it again");
        }
        const std::vector<std::byte> bytes = ReadBytes();
        const std::size_t slice = m_Width * m_Height * TexelBytes();
        const std::size_t stride = isVolume ? slice : LevelsOfSlice();
        std::vector<std::vector<std::byte>> slices;
        for (std::size_t i = 0; i < m_Depth; ++i)
        {
            slices.push_back(
                FourChannels({bytes.begin() + static_cast<std::ptrdiff_t>(i * stride),
                              bytes.begin() + static_cast<std::ptrdiff_t>(i * stride + slice)}));
        }
        return Make(std::move(slices));
    }

    /// Makes the texture of the first level of each slice.
    std::shared_ptr<const Texture> Make(std::vector<std::vector<std::byte>> slices) const
    {
        const std::string name(m_Fields["m_Name"].text());
        const int width = static_cast<int>(m_Width);
        const int height = static_cast<int>(m_Height);
        const GraphicsFormat format =
            m_Format == GraphicsFormat::R8G8B8_SRGB    ? GraphicsFormat::R8G8B8A8_SRGB
            : m_Format == GraphicsFormat::R8G8B8_UNorm ? GraphicsFormat::R8G8B8A8_UNorm
                                                       : m_Format;
        const SamplerState sampler = ReadSampler();
        const bool hasMips = m_Levels > 1;
        if (m_Class == UnityClass::Texture2DArray)
        {
            return std::make_shared<const Texture2DArray>(name, width, height, format,
                                                          std::move(slices), sampler, hasMips);
        }
        std::vector<std::byte> all;
        for (const std::vector<std::byte>& slice : slices)
        {
            all.insert(all.end(), slice.begin(), slice.end());
        }
        if (m_Class == UnityClass::Texture3D)
        {
            return std::make_shared<const Texture3D>(name, width, height, static_cast<int>(m_Depth),
                                                     format, std::move(all), sampler, hasMips);
        }
        return std::make_shared<const Texture2D>(name, width, height, format, std::move(all),
                                                 sampler, hasMips);
    }

    std::size_t TexelBytes() const { return static_cast<std::size_t>(BytesPerTexel(m_Format)); }

    /// Returns the bytes of all levels of an element.
    std::size_t LevelsOfSlice() const
    {
        std::size_t bytes = 0;
        for (std::size_t level = 0; level < m_Levels; ++level)
        {
            bytes += std::max<std::size_t>(m_Width >> level, 1) *
                     std::max<std::size_t>(m_Height >> level, 1) * TexelBytes();
        }
        return bytes;
    }

    std::vector<std::byte> ReadBytes()
    {
        const UnityNode node = m_Fields["_typelessdata"];
        if (!m_Fields["m_StreamData"]["path"].text().empty())
        {
            Fail(m_Fields["m_StreamData"],
                 "the texture's data lie in another file, which limn does not read");
        }
        std::vector<std::byte> bytes = Bytes(node);
        const bool isArray = m_Class == UnityClass::Texture2DArray;
        const std::size_t needed =
            m_Depth * (isArray ? LevelsOfSlice() : m_Width * m_Height * TexelBytes());
        if (bytes.size() < needed)
        {
            Fail(node, "the texture has " + std::to_string(bytes.size()) + " bytes; " +
                           std::to_string(m_Width) + "x" + std::to_string(m_Height) + "x" +
                           std::to_string(m_Depth) + " of " + ToString(m_Format) + " takes " +
                           std::to_string(needed));
        }
        return bytes;
    }

    /// Returns RGBA texels of RGB and ARGB ones, and others as they are.
    std::vector<std::byte> FourChannels(std::vector<std::byte> texels) const
    {
        if (m_IsAlphaFirst)
        {
            for (std::size_t i = 0; i + 4 <= texels.size(); i += 4)
            {
                std::rotate(texels.data() + i, texels.data() + i + 1, texels.data() + i + 4);
            }
        }
        if (m_Format != GraphicsFormat::R8G8B8_SRGB && m_Format != GraphicsFormat::R8G8B8_UNorm)
        {
            return texels;
        }
        std::vector<std::byte> opaque;
        for (std::size_t i = 0; i + 3 <= texels.size(); i += 3)
        {
            opaque.insert(opaque.end(), {texels[i], texels[i + 1], texels[i + 2], std::byte{255}});
        }
        return opaque;
    }

    SamplerState ReadSampler() const
    {
        const UnityNode settings = m_Fields["m_TextureSettings"];
        const auto read = [&](const char* key, auto last, auto& value)
        {
            if (settings[key])
            {
                value = static_cast<decltype(last)>(
                    Number(settings[key], static_cast<std::size_t>(last)));
            }
        };
        SamplerState sampler;
        read("m_FilterMode", FilterMode::Trilinear, sampler.filterMode);
        read("m_WrapU", TextureWrapMode::MirrorOnce, sampler.wrapModeU);
        read("m_WrapV", TextureWrapMode::MirrorOnce, sampler.wrapModeV);
        read("m_WrapW", TextureWrapMode::MirrorOnce, sampler.wrapModeW);
        read("m_Aniso", 16, sampler.anisoLevel);
        sampler.anisoLevel = std::max(sampler.anisoLevel, 1); // 0 is off
        return sampler;
    }

    const UnityClass m_Class;
    std::size_t m_Width = 0;
    std::size_t m_Height = 0;
    std::size_t m_Depth = 0;
    std::size_t m_Levels = 0;
    GraphicsFormat m_Format = GraphicsFormat::None; ///< as it is saved
    bool m_IsAlphaFirst = false;                    ///< of ARGB32
};

} // namespace

std::shared_ptr<const Texture> ReadTextTexture(UnityClass classID, const UnityNode& fields,
                                               const std::string& file)
{
    return TextTextureReader(classID, fields, file).Read();
}

std::shared_ptr<const RenderTexture> ReadRenderTexture(const UnityNode& fields,
                                                       const std::string& file)
{
    return TextTextureReader(UnityClass::RenderTexture, fields, file).ReadTarget();
}

} // namespace limn
