#include "commands/Commands.h"

#include "assets/FileKind.h"
#include "shader_graph/GraphShader.h"
#include "shader_reports/ShaderDescription.h"
#include "shader_reports/ShaderEmit.h"
#include "shaders/ShaderFolders.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <limn/base/Lists.h>
#include <limn/base/TerminalText.h>
#include <limn/shaderlab/ComputeDocument.h>
#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/PrintShaderLab.h>
#include <limn/shaderlab/ShaderDatabase.h>
#include <limn/shaderlab/ShaderLabParser.h>
#include <set>
#include <thread>

namespace limn
{

namespace
{

/// Without those that hide behind an #include_with_pragmas.
std::set<std::string> DeclaredKeywords(const std::vector<ShaderCheck>& checks)
{
    std::set<std::string> declared;
    for (const ShaderCheck& check : checks)
    {
        for (const CheckedSubShader& subShader : check.subShaders)
        {
            for (const CheckedPass& pass : subShader.passes)
            {
                declared.insert(pass.keywords.begin(), pass.keywords.end());
                if (pass.pass->program)
                {
                    for (const KeywordSet& set : pass.pass->program->keywordSets)
                    {
                        declared.insert(set.keywords.begin(), set.keywords.end());
                    }
                }
            }
        }
    }
    declared.erase("");
    return declared;
}

/// Warns of keywords that no pass of the shaders declares, with those that there are.
void PrintUnknownKeywords(const std::vector<ShaderCheck>& checks,
                          const std::vector<std::string>& keywords, Console& console)
{
    const std::set<std::string> declared =
        keywords.empty() ? std::set<std::string>() : DeclaredKeywords(checks);
    for (const std::string& keyword : keywords)
    {
        if (declared.count(keyword) == 0)
        {
            console.Warning("--keywords: no pass declares the keyword " +
                            UnknownName(keyword, {declared.begin(), declared.end()}));
        }
    }
}

/// Returns whether the path is a folder. It is false for a path that cannot be examined, too; the
/// reader of that file reports why.
bool isFolder(const std::filesystem::path& path)
{
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

std::vector<std::filesystem::path> FindFiles(const std::vector<std::string>& paths)
{
    std::vector<std::filesystem::path> files;
    for (const std::string& path : paths)
    {
        if (!isFolder(path))
        {
            files.emplace_back(path);
            continue;
        }
        const std::vector<std::filesystem::path> found = FindShaderFiles(path);
        if (found.empty())
        {
            throw AssetError(path, {}, "the folder has no .shader file in it");
        }
        files.insert(files.end(), found.begin(), found.end());
    }
    return files;
}

/// The folders to look for other shaders in, each once; those of files that are not there are none.
std::vector<std::filesystem::path> FindFolders(const std::vector<std::string>& paths)
{
    std::vector<std::filesystem::path> folders;
    for (const std::string& path : paths)
    {
        std::filesystem::path folder(path);
        folder = isFolder(folder) ? folder : FolderOfShaders(folder);
        if (isFolder(folder))
        {
            AddOnce(folder, folders);
        }
    }
    return folders;
}

std::shared_ptr<ShaderCompiler> MakeCompiler(const ShaderOptions& options)
{
    ShaderCompilerOptions compilerOptions = DefaultCompilerOptions();
    compilerOptions.packages.insert(options.packages.begin(), options.packages.end());
    compilerOptions.includeFolders.assign(options.roots.begin(), options.roots.end());
    std::ranges::copy_if(options.paths, std::back_inserter(compilerOptions.includeFolders),
                         isFolder);
    return std::make_shared<ShaderCompiler>(std::move(compilerOptions));
}

/// Checks files on several threads; results are taken in the order of the files.
class ParallelCheck
{
public:
    ParallelCheck(std::vector<std::filesystem::path> files, const ShaderOptions& options)
        : m_Files(std::move(files)),
          m_Folders(FindFolders(options.paths)),
          m_Compiler(MakeCompiler(options))
    {
        m_Options.compile = !options.parseOnly && !options.variants;
        // Read when it is needed first: that takes its time in a large project.
        m_Shaders = std::async(std::launch::deferred, [this] { return FindShaders(m_Folders); });
        m_Options.shaders = [this]() -> const ShaderDatabase&
        {
            return m_Shaders.get();
        };
        if (!options.keywords.empty())
        {
            m_Options.keywords = options.keywords;
        }
        for (const std::filesystem::path& file : m_Files)
        {
            m_Tasks.emplace_back([this, &file]
                                 { return CheckShader(file, m_Options, *m_Compiler); });
            m_Checks.push_back(m_Tasks.back().get_future());
        }
        const std::size_t wanted = options.jobs > 0 ? static_cast<std::size_t>(options.jobs)
                                                    : std::thread::hardware_concurrency();
        const std::size_t count = std::clamp<std::size_t>(wanted, 1, m_Files.size());
        for (std::size_t i = 0; i < count; ++i)
        {
            m_Threads.push_back(std::async(std::launch::async, [this] { Work(); }));
        }
    }

    /// Waits for the files begun; those not begun are left out.
    ~ParallelCheck() { m_Next = m_Files.size(); }
    ParallelCheck(const ParallelCheck&) = delete;
    ParallelCheck& operator=(const ParallelCheck&) = delete;

    std::size_t size() const { return m_Files.size(); }
    const std::filesystem::path& file(std::size_t index) const { return m_Files[index]; }

    /// Once for each index.
    ShaderCheck Take(std::size_t index) { return m_Checks[index].get(); }

private:
    void Work()
    {
        for (std::size_t i = m_Next++; i < m_Tasks.size(); i = m_Next++)
        {
            m_Tasks[i]();
        }
    }

    std::vector<std::filesystem::path> m_Files;
    std::vector<std::filesystem::path> m_Folders; ///< that UsePass and Fallback look in
    std::shared_future<ShaderDatabase> m_Shaders;
    std::shared_ptr<ShaderCompiler> m_Compiler;
    ShaderCheckOptions m_Options;
    std::vector<std::packaged_task<ShaderCheck()>> m_Tasks; ///< one for each file
    std::vector<std::future<ShaderCheck>> m_Checks;         ///< their results
    std::atomic<std::size_t> m_Next{0};
    std::vector<std::future<void>> m_Threads; ///< last, so that they end first
};

/// Writes the files of one shader; what cannot be written is told and counts as the shader's error.
void Emit(ShaderCheck& check, const ShaderOptions& options, EmittedStems& stems, Console& console)
{
    if (!check.document)
    {
        return; // it was not read
    }
    try
    {
        const std::string stem = stems.Take(check.document->name);
        for (const auto& written : EmitShader(check, options.emit, options.outputFolder, stem))
        {
            console.Result(written.string());
        }
    }
    catch (const AssetError& error)
    {
        console.PrintWithSource(error.diagnostics());
        check.diagnostics.insert(check.diagnostics.end(), error.diagnostics().begin(),
                                 error.diagnostics().end());
    }
}

/// Prints what is found in a file. A note on a whole file, without a place, which other files have
/// as well, is said of the first one.
/// @param files  counts the files with each note
void PrintFindings(std::vector<Diagnostic> diagnostics, std::map<std::string, int>& files,
                   Console& console)
{
    const auto isSaid = [&files](const Diagnostic& diagnostic)
    {
        const bool isOfFile =
            diagnostic.severity == Severity::Note && diagnostic.location.line == 0;
        return isOfFile && ++files[diagnostic.message] > 1;
    };
    std::erase_if(diagnostics, isSaid);
    console.PrintWithSource(diagnostics);
}

std::vector<ShaderCheck> CheckAll(ParallelCheck& running, const ShaderOptions& options,
                                  Console& console)
{
    std::vector<ShaderCheck> checks;
    std::map<std::string, int> notes;
    EmittedStems stems;
    for (std::size_t i = 0; i < running.size(); ++i)
    {
        console.Progress(std::to_string(i + 1) + " of " + std::to_string(running.size()) + ": " +
                         running.file(i).string());
        ShaderCheck check = running.Take(i);
        PrintFindings(check.diagnostics, notes, console);
        if (!options.emit.empty())
        {
            Emit(check, options, stems, console);
        }
        checks.push_back(std::move(check));
    }
    console.Progress("");
    for (const auto& [message, count] : notes)
    {
        if (count > 1)
        {
            console.Note("in " + std::to_string(count - 1) + " more file" +
                         (count == 2 ? ": " : "s: ") + message);
        }
    }
    return checks;
}

/// A file as canonical text; "", with what is wrong on the console, if it does not parse.
std::string CanonicalText(const std::filesystem::path& file, Console& console)
{
    try
    {
        const ShaderLabParseResult result = LoadShaderFile(file);
        console.PrintWithSource(result.diagnostics);
        if (result.hasErrors())
        {
            return {};
        }
        std::string text = PrintShaderLab(result.document);
        const ShaderLabParseResult again = ParseShaderLab(text, file.string());
        if (again.hasErrors() || !SameContent(result.document, again.document))
        {
            throw ContractError(file.string() + ": its canonical text has another meaning");
        }
        return text;
    }
    catch (const AssetError& error)
    {
        console.PrintWithSource(error.diagnostics());
        return {};
    }
}

ExitCode PrintFiles(const ShaderOptions& options, Console& console)
{
    bool hasErrors = false;
    for (const std::filesystem::path& file : FindFiles(options.paths))
    {
        const std::string text = CanonicalText(file, console);
        hasErrors = hasErrors || text.empty();
        // A file of its own where it goes into one, and text for people on a terminal.
        console.out() << (console.isOutTerminal() ? SeveralLines(text) : text);
    }
    return hasErrors ? ExitCode::BadInput : ExitCode::Done;
}

bool isCompute(const std::string& path)
{
    return path.ends_with(".compute");
}

/// Compiles a kernel; a line says that it did, errors why it did not.
/// @return whether it did
bool CheckKernel(const PassProgram& kernel, const ShaderOptions& options, ShaderCompiler& compiler,
                 Console& console)
{
    try
    {
        const PassProgram program = compiler.ReadPragmas(kernel);
        const std::string name = "kernel " + program.kernel.name;
        if (options.parseOnly)
        {
            console.Result(name);
            return true;
        }
        const auto compiled = compiler.Compile(program, SelectVariant(program, options.keywords));
        console.PrintWithSource(compiled->diagnostics);
        const auto& size = compiled->threadGroupSize;
        console.Result(name + ": groups of " + std::to_string(size[0]) + " x " +
                       std::to_string(size[1]) + " x " + std::to_string(size[2]) + " threads");
        return true;
    }
    catch (const AssetError& error)
    {
        console.PrintWithSource(error.diagnostics());
        return false;
    }
}

ExitCode CheckComputeFiles(const ShaderOptions& options, Console& console)
{
    const bool isForShaders =
        options.json || options.print || options.variants || !options.emit.empty();
    if (isForShaders || !std::ranges::all_of(options.paths, isCompute))
    {
        console.Error("shader: .compute files are checked on their own; --emit, --json, --print "
                      "and --variants, and other files beside them, are not for them");
        return ExitCode::WrongUsage;
    }
    const std::shared_ptr<ShaderCompiler> compiler = MakeCompiler(options);
    bool isGood = true;
    for (const std::string& path : options.paths)
    {
        for (const PassProgram& kernel : LoadCompute(path).kernels)
        {
            isGood = CheckKernel(kernel, options, *compiler, console) && isGood;
        }
    }
    return isGood ? ExitCode::Done : ExitCode::BadInput;
}

/// Returns the exit code for the checks, and prints a sentence if no error explains it.
ExitCode PrintVerdict(const std::vector<ShaderCheck>& checks, Console& console)
{
    const ShaderSummary summary = Summarize(checks);
    const int refused = summary.passesOf(PassOutcome::Refused);
    const bool isAllRefused = summary.passesTried() == 0 && refused > 0;
    if (isAllRefused && summary.errors == 0)
    {
        console.Error("nothing was compiled: limn refuses " + std::to_string(refused) +
                      (refused == 1 ? " pass" : " passes") + ", for the reasons above");
    }
    return summary.errors > 0 || isAllRefused ? ExitCode::BadInput : ExitCode::Done;
}

} // namespace

ExitCode RunShader(const ShaderOptions& options, Console& console)
{
    if (std::ranges::any_of(options.paths, isCompute))
    {
        return CheckComputeFiles(options, console);
    }
    for (const std::string& path : options.paths)
    {
        RequireKind(path, {FileKind::Shader}, "shader");
    }
    if (options.print)
    {
        return PrintFiles(options, console);
    }
    ParallelCheck running(FindFiles(options.paths), options);
    const std::vector<ShaderCheck> checks = CheckAll(running, options, console);
    const bool isOneFile = options.paths.size() == 1 && !isFolder(options.paths.front());
    if (options.json)
    {
        console.Data(ShadersAsJson(checks));
    }
    else if (options.variants)
    {
        console.Results(DescribeVariants(checks));
    }
    else if (options.emit.empty())
    {
        isOneFile ? console.Results(DescribeShader(checks.front()))
                  : console.Result(ToString(Summarize(checks)));
    }
    PrintUnknownKeywords(checks, options.keywords, console);
    return PrintVerdict(checks, console);
}

} // namespace limn
