#include "FuzzSupport.h"
#include "unity/UnityObjects.h"

using namespace limn;

namespace
{

std::size_t CountNodes(const UnityNode& node)
{
    if (!node) // an object that holds nothing
    {
        return 1;
    }
    std::size_t count = 1;
    test::RequireInFuzzer(node.line() >= 1, "a node without a line");
    for (const UnityNode child : node)
    {
        count += CountNodes(child);
    }
    if (node.isMap() && node.begin() != node.end())
    {
        test::RequireInFuzzer(static_cast<bool>(node[(*node.begin()).key()]),
                              "a key that is not found");
    }
    ReadUnityReference(node);
    return count;
}

} // namespace

/// Any bytes are a text Unity asset, or there is a complaint: all objects are read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(test::FuzzText(data, size));
    test::OrSentence(
        [&]
        {
            const UnityTree tree(text, "fuzz.meta", 1);
            test::RequireInFuzzer(CountNodes(tree.root()) <= 2 * size + 1, "more nodes than text");
        });
    test::OrSentence(
        [&]
        {
            const UnityFile file(text, "fuzz.unity");
            for (const UnityHeader& header : file.headers())
            {
                test::OrSentence([&] { CountNodes(file.Fields(header)); });
            }
        });
    return 0;
}
