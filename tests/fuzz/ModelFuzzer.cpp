#include "FuzzSupport.h"
#include "models/ModelFile.h"

#include <limn/base/WorkerProcess.h>

using namespace limn;

namespace
{

Importer* s_Importer = nullptr;

} // namespace

/// A crash is a worker's, which its signal tells. The fuzzer itself catches its own.
extern "C" const char* __asan_default_options()
{
    return "handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigfpe=0:handle_sigill=0";
}

/// The process is forked off before the fuzzer takes the signals.
extern "C" int LLVMFuzzerInitialize(int*, char***)
{
    Importer::Options options;
    options.process = std::make_shared<WorkerProcess>();
    options.timeLimit = std::chrono::seconds(2);
    s_Importer = new Importer(options);
    return 0;
}

/// Any bytes are an FBX file, or there is a sentence, whatever assimp does with them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const test::TemporaryFolder folder;
    const std::filesystem::path file = folder.Write("a.fbx", test::FuzzText(data, size));
    test::OrSentence(
        [&]
        {
            const Model model = LoadModel(file, {}, *s_Importer);
            test::RequireInFuzzer(!model.nodes.empty(), "a model without a root");
            const UnityFile prefab(PrefabTextOf(model, std::string(32, 'a')), "a.fbx");
            for (const UnityHeader& header : prefab.headers())
            {
                prefab.Fields(header);
            }
        });
    return 0;
}
