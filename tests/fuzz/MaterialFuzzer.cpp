#include "FuzzSupport.h"
#include "unity_scene/UnityMaterials.h"

using namespace limn;

namespace
{

constexpr const char* k_FuzzGuid = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";

} // namespace

/// Any bytes are a material of a project, or it is magenta with a note.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const test::TemporaryFolder folder;
    static AssetContext assets;
    folder.Write("Assets/a.asset", test::FuzzText(data, size));
    folder.Write("Assets/a.asset.meta", std::string("guid: ") + k_FuzzGuid + "\n");
    static const bool isRoot = (assets.AddRootsAround(folder / "Assets/a.asset"), true);
    test::RequireInFuzzer(isRoot, "no root");
    UnityNotes notes;
    UnityDatabase database(folder.path() / "Assets", assets, notes);
    UnityMaterials materials(database, assets, notes);
    const UnityInstance user{};
    test::RequireInFuzzer(materials.Load({nullptr, {2100000, k_FuzzGuid}},
                                         UnityReader(user, "object", notes),
                                         "m_Materials") != nullptr,
                          "no material");
    for (const Diagnostic& note : notes.Finish("fuzz.unity"))
    {
        test::RequireInFuzzer(!note.message.empty(), "an empty note");
    }
    return 0;
}
