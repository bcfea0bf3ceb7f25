#include "shader_reports/ShaderCheck.h"

#include "console/Texts.h"
#include "shader_graph/GraphShader.h"
#include "shaders/ShaderFolders.h"

#include <algorithm>
#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/ResolveShader.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

namespace limn
{

namespace
{

void Add(std::vector<Diagnostic>& diagnostics, const std::vector<Diagnostic>& more)
{
    for (const Diagnostic& diagnostic : more)
    {
        AddOnce(diagnostic, diagnostics);
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
            const auto isProperty =
                std::ranges::count(document.properties, member.name, &ShaderProperty::name);
            if (isProperty && buffer.name != "UnityPerMaterial")
            {
                return "the property " + member.name + " is in " + buffer.name +
                       ", not in the cbuffer UnityPerMaterial";
            }
        }
    }
    return {};
}

/// Returns whether resolving the shader takes other shaders.
bool needsOthers(const ShaderLabDocument& document)
{
    const auto hasUse = [](const ShaderLabSubShader& subShader)
    {
        return std::ranges::count(subShader.passes, ShaderLabPassKind::UsePass,
                                  &ShaderLabPass::kind) > 0;
    };
    return !document.fallback.empty() || std::ranges::any_of(document.subShaders, hasUse);
}

std::string UnityShaderNote(std::string_view command, std::string_view name)
{
    return std::string(command) + ": '" + std::string(name) +
           "' is one of Unity's own shaders, which limn does not have";
}

class Checker
{
public:
    Checker(ShaderCheck& check, const ShaderCheckOptions& options, ShaderCompiler& compiler)
        : m_Check(check),
          m_Compiler(compiler),
          m_Shaders(options.shaders && needsOthers(*check.document) ? &options.shaders() : nullptr),
          m_Compiles(options.compile),
          m_Keywords(options.keywords ? *options.keywords : InitialKeywords(*check.document))
    {
        m_Criteria.missingFeatures = compiler.options().missingFeatures;
    }

    void CheckSubShaders()
    {
        CheckFallback();
        const std::optional<int> used = FindUsed();
        for (const ShaderLabSubShader& subShader : m_Check.document->subShaders)
        {
            CheckedSubShader& checked = m_Check.subShaders.emplace_back();
            checked.subShader = &subShader;
            checked.isUsed = used == static_cast<int>(m_Check.subShaders.size()) - 1;
            for (const ShaderLabPass& pass : subShader.passes)
            {
                checked.passes.push_back(
                    CheckPass(subShader, {m_Check.document, &pass}, m_Check.diagnostics));
                if (checked.isUsed && m_Shaders && pass.kind == ShaderLabPassKind::UsePass)
                {
                    checked.passes.back().use = CheckUse(subShader, pass);
                }
            }
        }
    }

private:
    void CheckFallback()
    {
        const ShaderLabDocument& document = *m_Check.document;
        const std::string& name = document.fallback;
        // Magenta, as limn draws what has no SubShader for it.
        const bool isErrorShader =
            name == "Hidden/InternalErrorShader" || name.ends_with("/FallbackError");
        if (!m_Shaders || name.empty() || isErrorShader || m_Shaders->FindLender(name))
        {
            return;
        }
        const bool isUnitys = isUnityShader(name);
        Add(m_Check.diagnostics,
            {{isUnitys ? Severity::Note : Severity::Warning, document.file,
              document.fallbackLocation,
              isUnitys ? UnityShaderNote("Fallback", name)
                       : "Fallback: unknown shader " + m_Shaders->UnknownShader(name)}});
    }

    /// The SubShader that limn draws with; none where a Fallback has to help.
    std::optional<int> FindUsed()
    {
        try
        {
            const ResolvedShader resolved = ResolveShader(*m_Check.document, m_Shaders, m_Criteria);
            m_Check.drawnFallback = resolved.fallback;
            return resolved.fallback.empty() ? std::optional(resolved.subShaderIndex)
                                             : std::nullopt;
        }
        catch (const AssetError&)
        {
            return std::nullopt; // each pass says for itself why it cannot be drawn
        }
    }

    /// Returns the pass that is used, or null after a diagnostic. A fault of that pass is an error
    /// of its own file; here it is a warning.
    std::shared_ptr<const CheckedPass> CheckUse(const ShaderLabSubShader& subShader,
                                                const ShaderLabPass& usePass)
    {
        std::vector<Diagnostic> errors;
        std::optional<ShaderLabPass> pass =
            ResolveUsePass(*m_Check.document, usePass, m_Shaders, errors, m_Criteria);
        if (!pass)
        {
            const std::string shader = usePass.usePass.substr(0, usePass.usePass.rfind('/'));
            if (isUnityShader(shader) && !m_Shaders->Find(shader))
            {
                errors = {{Severity::Note, m_Check.document->file, usePass.location,
                           UnityShaderNote("UsePass", shader)}};
            }
            Add(m_Check.diagnostics, errors);
            return nullptr;
        }
        std::vector<Diagnostic> diagnostics;
        auto use = std::make_shared<const CheckedPass>(CheckPass(
            subShader, std::make_shared<const ShaderLabPass>(std::move(*pass)), diagnostics));
        if (!use->reason.empty())
        {
            Add(m_Check.diagnostics,
                {{use->outcome == PassOutcome::Refused ? Severity::Note : Severity::Warning,
                  m_Check.document->file, usePass.location,
                  "UsePass: the pass at " + use->pass->program->file + ":" +
                      std::to_string(use->pass->location.line) +
                      " cannot be drawn: " + use->reason}});
        }
        return use;
    }

    CheckedPass CheckPass(const ShaderLabSubShader& subShader,
                          std::shared_ptr<const ShaderLabPass> shared,
                          std::vector<Diagnostic>& diagnostics)
    {
        CheckedPass checked;
        checked.pass = std::move(shared);
        const ShaderLabPass& pass = *checked.pass;
        if (pass.kind == ShaderLabPassKind::GrabPass)
        {
            Refuse(checked,
                   {Severity::Note, m_Check.document->file, pass.location,
                    "GrabPass: it is not supported, as in URP; read _CameraOpaqueTexture instead"},
                   diagnostics);
        }
        if (!pass.program)
        {
            return checked;
        }
        const PassProgram program = m_Compiler.ReadPragmas(*pass.program);
        checked.variants = CountVariants(program);
        checked.keywords = SelectVariant(program, m_Keywords);
        if (m_Compiles)
        {
            Compile(subShader, program, checked, diagnostics);
        }
        return checked;
    }

    void Compile(const ShaderLabSubShader& subShader, const PassProgram& program,
                 CheckedPass& checked, std::vector<Diagnostic>& diagnostics) const
    {
        const std::string* pipeline = subShader.tags.Find("RenderPipeline");
        if (pipeline && (*pipeline == "HDRenderPipeline" || *pipeline == "HighDefinitionPipeline"))
        {
            Refuse(checked,
                   {Severity::Note, program.file, program.location,
                    "program: its SubShader is for the " + *pipeline +
                        ", which limn does not stand in for"},
                   diagnostics);
            return;
        }
        try
        {
            checked.compiled = m_Compiler.Compile(program, checked.keywords);
            checked.outcome = PassOutcome::Compiled;
            checked.srpBatcherProblem =
                FindSrpBatcherProblem(*m_Check.document, checked.compiled->layout);
            Add(diagnostics, checked.compiled->diagnostics);
        }
        catch (const UnsupportedProgramError& error)
        {
            Refuse(checked, error.diagnostics().front(), diagnostics);
        }
        catch (const MissingIncludeError& error)
        {
            Fail(checked, PassOutcome::MissingInclude, error, diagnostics);
        }
        catch (const AssetError& error)
        {
            Fail(checked, PassOutcome::Failed, error, diagnostics);
        }
    }

    static void Refuse(CheckedPass& checked, Diagnostic reason,
                       std::vector<Diagnostic>& diagnostics)
    {
        reason.severity = Severity::Note;
        checked.outcome = PassOutcome::Refused;
        checked.reason = reason.message;
        Add(diagnostics, {std::move(reason)});
    }

    static void Fail(CheckedPass& checked, PassOutcome outcome, const AssetError& error,
                     std::vector<Diagnostic>& diagnostics)
    {
        checked.outcome = outcome;
        // The messages before it may be warnings.
        const std::vector<Diagnostic>& all = error.diagnostics();
        const auto first = std::ranges::find(all, Severity::Error, &Diagnostic::severity);
        checked.reason = (first == all.end() ? all.front() : *first).message;
        Add(diagnostics, error.diagnostics());
    }

    ShaderCheck& m_Check;
    ShaderCompiler& m_Compiler;
    const ShaderDatabase* m_Shaders; ///< null where none is needed
    ShaderCriteria m_Criteria;
    bool m_Compiles;
    std::vector<std::string> m_Keywords;
};

} // namespace

ShaderCheck CheckShader(const std::filesystem::path& file, const ShaderCheckOptions& options,
                        ShaderCompiler& compiler)
{
    ShaderCheck check;
    check.file = file;
    try
    {
        ShaderLabParseResult parsed = LoadShaderFile(file);
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
