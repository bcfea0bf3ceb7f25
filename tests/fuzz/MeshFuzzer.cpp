#include "FuzzSupport.h"
#include "models/MikkTangents.h"
#include "models/TextMesh.h"

#include <algorithm>

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
            const SkinnableMesh read = ReadTextMesh(tree.root(), "fuzz.asset");
            for (const BoneWeights& weights : read.skin.weights)
            {
                test::RequireInFuzzer(
                    std::ranges::all_of(weights, [&](const BoneWeight& each)
                                        { return each.bone < read.skin.bindPoses.size(); }),
                    "a vertex that follows a bone that is none");
            }
            MeshData copy = read.mesh->data();
            ComputeMikkTangents(copy);
            test::RequireInFuzzer(copy.tangents.empty() ||
                                      copy.tangents.size() == copy.vertices.size(),
                                  "a vertex without a tangent");
            Mesh("with tangents", std::move(copy)); // throws where a number is none
        });
    return 0;
}
