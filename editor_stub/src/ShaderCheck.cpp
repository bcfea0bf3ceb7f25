#include "ShaderCheck.h"

#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

namespace
{

/// Runs `work` and keeps the errors of the AssetError it may throw.
template <typename Work>
void Try(ShaderCheck& check, Work&& work)
{
    try
    {
        work();
    }
    catch (const AssetError& error)
    {
        check.errors.insert(check.errors.end(), error.diagnostics().begin(),
                            error.diagnostics().end());
    }
}

void AddSubShaders(const ShaderLabDocument& document, ShaderCheck& check)
{
    for (const ShaderLabSubShader& subShader : document.subShaders)
    {
        CheckedSubShader& checked = check.subShaders.emplace_back();
        checked.subShader = &subShader;
        for (const ShaderLabPass& pass : subShader.passes)
        {
            checked.passes.push_back({&pass, nullptr});
        }
    }
}

void CompilePasses(const Shader& shader, ShaderCheck& check)
{
    for (CheckedSubShader& subShader : check.subShaders)
    {
        // Which SubShader is drawn with is Shader's to say; its states stand in the document.
        subShader.isUsed =
            !subShader.passes.empty() && &subShader.passes[0].pass->state == &shader.passState(0);
        for (std::size_t i = 0; subShader.isUsed && i < subShader.passes.size(); ++i)
        {
            Try(check, [&] { subShader.passes[i].compiled = shader.Compile(static_cast<int>(i)); });
        }
    }
}

} // namespace

ShaderCheck CheckShader(const std::filesystem::path& file, bool parseOnly,
                        const std::shared_ptr<ShaderCompiler>& compiler)
{
    ShaderCheck check;
    check.file = file;
    Try(check,
        [&]
        {
            ShaderLabDocument document = LoadShaderLab(file);
            if (parseOnly)
            {
                check.document = std::make_shared<const ShaderLabDocument>(std::move(document));
                AddSubShaders(*check.document, check);
                return;
            }
            const auto shader = std::make_shared<const Shader>(std::move(document), compiler);
            check.document = {shader, &shader->document()};
            AddSubShaders(*check.document, check);
            CompilePasses(*shader, check);
        });
    return check;
}

} // namespace limn
