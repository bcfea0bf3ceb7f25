#include "FuzzSupport.h"
#include "models/MikkTangents.h"
#include "models/TextMesh.h"

using namespace limn;

/// Any bytes are a mesh that Unity saved as text, or there is a complaint. Tangents can be made for
/// what is read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(test::FuzzText(data, size));
    test::OrSentence(
        [&]
        {
            const UnityTree tree(text, "fuzz.asset", 1);
            const auto mesh = ReadTextMesh(tree.root(), "fuzz.asset");
            MeshData copy = mesh->data();
            ComputeMikkTangents(copy);
            test::RequireInFuzzer(copy.tangents.empty() ||
                                      copy.tangents.size() == copy.vertices.size(),
                                  "a vertex without a tangent");
            Mesh("with tangents", std::move(copy)); // throws where a number is none
        });
    return 0;
}
