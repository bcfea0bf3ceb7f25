#include "FuzzSupport.h"
#include "models/ModelFile.h"
#include "unity/TextureImporter.h"

#include <cmath>
#include <limn/core/Image.h>

using namespace limn;

/// Any bytes are the .meta file of a texture and of a model, or there is a complaint.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const test::TemporaryFolder folder;
    static const bool isWritten = (WritePng(folder / "a.png", {3, 2, GraphicsFormat::R8G8B8A8_SRGB,
                                                               std::vector<std::byte>(3 * 2 * 4)}),
                                   true);
    test::RequireInFuzzer(isWritten, "no picture");
    const std::string text(test::FuzzText(data, size));
    folder.Write("a.png.meta", text);
    test::OrSentence(
        [&]
        {
            const auto texture = ImportTexture(folder / "a.png");
            test::RequireInFuzzer(texture->width() >= 1 && texture->width() <= 3, "another size");
        });
    test::OrSentence(
        [&]
        {
            const ModelImport import = ReadModelImport(UnityTree(text, "a.meta", 1).root());
            test::RequireInFuzzer(std::isfinite(import.globalScale), "a scale that is no number");
        });
    return 0;
}
