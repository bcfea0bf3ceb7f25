#include "ShaderCommand.h"

#include "CacheFolder.h"
#include "ShaderDescription.h"
#include "ShaderEmit.h"

#include <algorithm>
#include <limn/editor_stub/RunLimn.h>

namespace limn
{

namespace
{

std::vector<std::filesystem::path> FilesBelow(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, options))
    {
        if (entry.path().extension() == ".shader" && entry.is_regular_file())
        {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::filesystem::path> FindFiles(const std::vector<std::string>& paths)
{
    std::vector<std::filesystem::path> files;
    for (const std::string& path : paths)
    {
        if (!std::filesystem::is_directory(path))
        {
            files.emplace_back(path);
            continue;
        }
        const std::vector<std::filesystem::path> found = FilesBelow(path);
        if (found.empty())
        {
            throw AssetError(path, {}, "the folder has no .shader file in it");
        }
        files.insert(files.end(), found.begin(), found.end());
    }
    return files;
}

std::shared_ptr<ShaderCompiler> MakeCompiler(const ShaderOptions& options)
{
    ShaderCompilerOptions compilerOptions;
    const std::filesystem::path cacheFolder = DefaultCacheFolder();
    if (!cacheFolder.empty() && MakeFolder(cacheFolder).empty())
    {
        compilerOptions.cacheFolder = cacheFolder;
    }
    compilerOptions.packages.insert(options.packages.begin(), options.packages.end());
    return std::make_shared<ShaderCompiler>(std::move(compilerOptions));
}

std::string Count(std::size_t number, const char* noun)
{
    return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

/// "12 files: 11 good, 1 with 3 errors; 30 passes compiled"
std::string Summary(const std::vector<ShaderCheck>& checks)
{
    std::size_t bad = 0;
    std::size_t errors = 0;
    std::size_t compiled = 0;
    for (const ShaderCheck& check : checks)
    {
        bad += check.errors.empty() ? 0 : 1;
        errors += check.errors.size();
        for (const CheckedSubShader& subShader : check.subShaders)
        {
            for (const CheckedPass& pass : subShader.passes)
            {
                compiled += pass.compiled ? 1 : 0;
            }
        }
    }
    const std::string badText =
        bad == 0 ? std::string() : ", " + std::to_string(bad) + " with " + Count(errors, "error");
    return Count(checks.size(), "file") + ": " + std::to_string(checks.size() - bad) + " good" +
           badText + "; " + std::to_string(compiled) + (compiled == 1 ? " pass" : " passes") +
           " compiled";
}

} // namespace

int RunShader(const ShaderOptions& options, Console& console)
{
    const std::vector<std::filesystem::path> files = FindFiles(options.paths);
    const std::shared_ptr<ShaderCompiler> compiler = MakeCompiler(options);
    std::vector<ShaderCheck> checks;
    bool hasErrors = false;
    for (const std::filesystem::path& file : files)
    {
        console.Progress(std::to_string(checks.size() + 1) + " of " + std::to_string(files.size()) +
                         ": " + file.string());
        ShaderCheck check = CheckShader(file, options.parseOnly, compiler);
        hasErrors = hasErrors || !check.errors.empty();
        console.Print(check.errors);
        if (!options.emit.empty())
        {
            for (const auto& written : EmitShader(check, options.emit, options.outputFolder))
            {
                console.out() << written.string() << '\n';
            }
        }
        checks.push_back(std::move(check));
    }
    console.Progress("");
    if (options.json)
    {
        console.out() << ShadersAsJson(checks) << '\n';
    }
    else if (checks.size() == 1 && options.emit.empty())
    {
        console.out() << DescribeShader(checks.front());
    }
    else if (options.emit.empty())
    {
        console.out() << Summary(checks) << '\n';
    }
    return static_cast<int>(hasErrors ? ExitCode::BadInput : ExitCode::Done);
}

} // namespace limn
