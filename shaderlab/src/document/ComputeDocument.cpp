#include <limn/shaderlab/ComputeDocument.h>

#include <limn/base/ReadFile.h>

#include "keywords/PragmaScanner.h"
#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr int k_Target = 45; ///< the first shader model with kernels

/// `A B=2` as `#define`s.
std::string Defines(std::string_view words)
{
    std::string text;
    for (std::string_view word = TakeWord(words); !word.empty(); word = TakeWord(words))
    {
        const std::size_t name = std::min(word.find('='), word.size());
        const std::string_view value = name < word.size() ? word.substr(name + 1) : "1";
        text.append("#define ").append(word.substr(0, name)).append(" ");
        text.append(value).append("\n");
    }
    return text;
}

PassProgram WithKernel(const PassProgram& file, const ProgramPragma& pragma)
{
    std::string_view words = pragma.arguments;
    PassProgram kernel = file;
    kernel.location = pragma.location;
    kernel.kernel = {std::string(TakeWord(words)), pragma.location};
    if (std::string defines = Defines(words); !defines.empty())
    {
        kernel.chunks.insert(kernel.chunks.begin(), {std::move(defines), pragma.location.line});
    }
    return kernel;
}

bool Has(const std::vector<PassProgram>& kernels, const std::string& name)
{
    return std::ranges::any_of(kernels, [&](const PassProgram& kernel)
                               { return kernel.kernel.name == name; });
}

} // namespace

ComputeDocument ParseCompute(std::string_view text, std::string file)
{
    ComputeDocument document;
    document.name = std::filesystem::path(file).stem().string();
    document.file = std::move(file);
    PassProgram program;
    program.file = document.file;
    program.location = {1, 1};
    program.chunks = {{std::string(text), 1}};
    ScanPragmas(program);
    program.target = std::max(program.target, k_Target);
    std::vector<Diagnostic> errors;
    for (const ProgramPragma& pragma : program.pragmas)
    {
        if (pragma.name != "kernel")
        {
            continue;
        }
        PassProgram kernel = WithKernel(program, pragma);
        if (kernel.kernel.name.empty())
        {
            errors.push_back({Severity::Error, document.file, pragma.location,
                              "#pragma kernel: it names no function; write '#pragma kernel Name'"});
        }
        else if (Has(document.kernels, kernel.kernel.name))
        {
            errors.push_back({Severity::Error, document.file, pragma.location,
                              "#pragma kernel: there is a kernel '" + kernel.kernel.name +
                                  "' already; give each a function of its own"});
        }
        document.kernels.push_back(std::move(kernel));
    }
    if (document.kernels.empty())
    {
        errors.push_back({Severity::Error,
                          document.file,
                          {},
                          "file: it has no kernel; '#pragma kernel Name' names its function"});
    }
    if (!errors.empty())
    {
        throw AssetError(std::move(errors));
    }
    return document;
}

ComputeDocument LoadCompute(const std::filesystem::path& path)
{
    return ParseCompute(ReadFile(path), path.string());
}

} // namespace limn
