#include "FuzzSupport.h"
#include "assets/PictureFile.h"
#include "assets/PictureSettings.h"

using namespace limn;

/// Any bytes are a picture of any kind, or there is a complaint. The first byte tells the kind, the
/// second how it is imported.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static constexpr const char* k_Names[] = {"a.png", "a.tif", "a.tga", "a.exr",
                                              "a.hdr", "a.psd", "a.jpg", "a.bmp"};
    if (size < 2)
    {
        return 0;
    }
    PictureSettings settings;
    settings.sRGB = (data[1] & 1) != 0;
    settings.isNormalMap = (data[1] & 2) != 0;
    settings.convertToNormalMap = (data[1] & 4) != 0;
    settings.maxTextureSize = (data[1] & 8) != 0 ? 3 : 0;
    settings.swizzle[0] = static_cast<PictureSwizzle>(data[1] >> 4 & 7);
    test::OrSentence(
        [&]
        {
            const Image image = DecodePicture(k_Names[data[0] % std::size(k_Names)],
                                              test::FuzzText(data + 2, size - 2));
            const auto texels =
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
            test::RequireInFuzzer(image.texels.size() == texels * static_cast<std::size_t>(
                                                                      BytesPerTexel(image.format)),
                                  "bytes that do not fit the size");
            if (texels <= 1 << 16)
            {
                ApplyPictureSettings(image, settings);
            }
        });
    return 0;
}
