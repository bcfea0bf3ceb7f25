#include "FuzzSupport.h"
#include "shader_graph/GraphShader.h"

using namespace limn;

/// Any bytes become ShaderLab or there is a complaint; a graph may have itself as sub graph.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.Write("a.shadergraph", test::FuzzText(data, size));
    test::OrSentence(
        [&]
        {
            const TranslatedGraph graph =
                TranslateGraph(path, [&](const std::string&) { return path; });
            ParseShaderLab(graph.shaderLab, "a.shadergraph").TakeDocument();
        });
    return 0;
}
