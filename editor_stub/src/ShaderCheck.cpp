#include "ShaderCheck.h"

#include <algorithm>
#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/ResolveShader.h>
#include <limn/shaderlab/ShaderLabParser.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

namespace limn
{

namespace
{

void Add(std::vector<Diagnostic>& diagnostics, const std::vector<Diagnostic>& more)
{
    for (const Diagnostic& diagnostic : more)
    {
        if (std::find(diagnostics.begin(), diagnostics.end(), diagnostic) == diagnostics.end())
        {
            diagnostics.push_back(diagnostic);
        }
    }
}

/// The first property of the material that stands in no buffer of the name the batcher looks for.
/// Unity: the SRP Batcher wants all of them in UnityPerMaterial.
std::string FindSrpBatcherProblem(const ShaderLabDocument& document, const PropertyLayout& layout)
{
    for (const UniformBuffer& buffer : layout.buffers)
    {
        for (const UniformMember& member : buffer.members)
        {
            const bool isProperty =
                std::any_of(document.properties.begin(), document.properties.end(),
                            [&](const ShaderProperty& p) { return p.name == member.name; });
            if (isProperty && buffer.name != "UnityPerMaterial")
            {
                return "the property " + member.name + " is in " + buffer.name +
                       ", not in the cbuffer UnityPerMaterial";
            }
        }
    }
    return {};
}

class Checker
{
public:
    Checker(ShaderCheck& check, const ShaderCheckOptions& options, ShaderCompiler& compiler)
        : m_Check(check),
          m_Compiler(compiler),
          m_Compiles(options.compile),
          m_Keywords(options.keywords ? *options.keywords : InitialKeywords(*check.document))
    {
    }

    void CheckSubShaders()
    {
        const std::optional<int> used = FindUsed();
        for (const ShaderLabSubShader& subShader : m_Check.document->subShaders)
        {
            CheckedSubShader& checked = m_Check.subShaders.emplace_back();
            checked.subShader = &subShader;
            checked.isUsed = used == static_cast<int>(m_Check.subShaders.size()) - 1;
            for (const ShaderLabPass& pass : subShader.passes)
            {
                checked.passes.push_back(CheckPass(subShader, pass));
            }
        }
    }

private:
    /// The SubShader that limn draws with; none where a Fallback has to help.
    std::optional<int> FindUsed() const
    {
        try
        {
            const ResolvedShader resolved = ResolveShader(*m_Check.document, nullptr);
            return resolved.fallback.empty() ? std::optional(resolved.subShaderIndex)
                                             : std::nullopt;
        }
        catch (const AssetError&)
        {
            return std::nullopt; // each pass says for itself why it cannot be drawn
        }
    }

    CheckedPass CheckPass(const ShaderLabSubShader& subShader, const ShaderLabPass& pass)
    {
        CheckedPass checked;
        checked.pass = &pass;
        if (!pass.program)
        {
            return checked;
        }
        const PassProgram program = m_Compiler.ReadPragmas(*pass.program);
        checked.variants = CountVariants(program);
        checked.keywords = SelectVariant(program, m_Keywords);
        if (m_Compiles)
        {
            Compile(subShader, program, checked);
        }
        return checked;
    }

    void Compile(const ShaderLabSubShader& subShader, const PassProgram& program,
                 CheckedPass& checked)
    {
        const std::string* pipeline = subShader.tags.Find("RenderPipeline");
        if (pipeline && (*pipeline == "HDRenderPipeline" || *pipeline == "HighDefinitionPipeline"))
        {
            Refuse(checked, {Severity::Note, program.file, program.location,
                             "program: its SubShader is for the " + *pipeline +
                                 ", which limn does not stand in for"});
            return;
        }
        try
        {
            checked.compiled = m_Compiler.Compile(program, checked.keywords);
            checked.outcome = PassOutcome::Compiled;
            checked.srpBatcherProblem =
                FindSrpBatcherProblem(*m_Check.document, checked.compiled->layout);
            Add(m_Check.diagnostics, checked.compiled->diagnostics);
        }
        catch (const UnsupportedProgramError& error)
        {
            Refuse(checked, error.diagnostics().front());
        }
        catch (const MissingIncludeError& error)
        {
            Fail(checked, PassOutcome::MissingInclude, error);
        }
        catch (const AssetError& error)
        {
            Fail(checked, PassOutcome::Failed, error);
        }
    }

    void Refuse(CheckedPass& checked, Diagnostic reason)
    {
        reason.severity = Severity::Note;
        checked.outcome = PassOutcome::Refused;
        checked.reason = reason.message;
        Add(m_Check.diagnostics, {std::move(reason)});
    }

    void Fail(CheckedPass& checked, PassOutcome outcome, const AssetError& error)
    {
        checked.outcome = outcome;
        checked.reason = error.diagnostics().front().message;
        Add(m_Check.diagnostics, error.diagnostics());
    }

    ShaderCheck& m_Check;
    ShaderCompiler& m_Compiler;
    bool m_Compiles;
    std::vector<std::string> m_Keywords;
};

} // namespace

bool ShaderCheck::hasErrors() const
{
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

ShaderCheck CheckShader(const std::filesystem::path& file, const ShaderCheckOptions& options,
                        ShaderCompiler& compiler)
{
    ShaderCheck check;
    check.file = file;
    try
    {
        ShaderLabParseResult parsed = LoadShaderLabWithDiagnostics(file);
        check.isParsed = !parsed.hasErrors();
        check.diagnostics = std::move(parsed.diagnostics);
        check.document = std::make_shared<const ShaderLabDocument>(std::move(parsed.document));
    }
    catch (const AssetError& error)
    {
        check.diagnostics = error.diagnostics();
        return check;
    }
    if (check.isParsed)
    {
        Checker(check, options, compiler).CheckSubShaders();
    }
    return check;
}

} // namespace limn
