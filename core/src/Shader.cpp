#include <algorithm>
#include <atomic>
#include <cctype>
#include <charconv>
#include <limn/core/Shader.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

namespace
{

bool EqualIgnoringCase(std::string_view a, std::string_view b)
{
    const auto lower = [](char c)
    {
        return std::tolower(static_cast<unsigned char>(c));
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

/// "Transparent", "Geometry+1", "2450" as a queue number.
std::optional<int> ParseQueue(std::string_view text)
{
    static constexpr std::pair<std::string_view, int> k_Names[] = {{"Background", 1000},
                                                                   {"Geometry", 2000},
                                                                   {"AlphaTest", 2450},
                                                                   {"Transparent", 3000},
                                                                   {"Overlay", 4000}};
    std::string compact(text);
    std::erase(compact, ' ');
    const std::size_t split = std::min(compact.find_first_of("+-"), compact.size());
    int queue = 0;
    std::string_view offset = compact;
    if (split > 0)
    {
        const std::string_view name = std::string_view(compact).substr(0, split);
        const auto it =
            std::find_if(std::begin(k_Names), std::end(k_Names),
                         [&](const auto& n) { return EqualIgnoringCase(n.first, name); });
        if (it != std::end(k_Names))
        {
            queue = it->second;
            offset.remove_prefix(split);
            if (offset.empty())
            {
                return queue;
            }
        }
    }
    if (offset.starts_with('+'))
    {
        offset.remove_prefix(1);
    }
    int number = 0;
    const auto [end, error] = std::from_chars(offset.data(), offset.data() + offset.size(), number);
    if (error != std::errc() || end != offset.data() + offset.size())
    {
        return std::nullopt;
    }
    return std::clamp(queue + std::clamp(number, -5000, 5000), 0, 5000);
}

const ShaderLabSubShader& FirstUsableSubShader(const ShaderLabDocument& document)
{
    for (const ShaderLabSubShader& subShader : document.subShaders)
    {
        const std::string* pipeline = subShader.tags.Find("RenderPipeline");
        const bool ours = pipeline == nullptr || pipeline->starts_with("Universal");
        if (ours && !subShader.passes.empty())
        {
            return subShader;
        }
    }
    throw AssetError(document.file, document.location,
                     document.name + ": no SubShader with a pass for URP; add one whose "
                                     "\"RenderPipeline\" tag is absent or \"UniversalPipeline\"");
}

std::uint64_t NextId()
{
    static std::atomic<std::uint64_t> next{1};
    return next++;
}

} // namespace

Shader::Shader(ShaderLabDocument document, std::shared_ptr<ShaderCompiler> compiler)
    : m_Id(NextId()), m_Document(std::move(document)), m_Compiler(std::move(compiler))
{
    const ShaderLabSubShader& subShader = FirstUsableSubShader(m_Document);
    if (const std::string* queue = subShader.tags.Find("Queue"))
    {
        const std::optional<int> number = ParseQueue(*queue);
        if (!number)
        {
            throw AssetError(m_Document.file, subShader.location,
                             "Queue: '" + *queue +
                                 "' is no render queue; write Background, Geometry, AlphaTest, "
                                 "Transparent or Overlay, with +N or -N behind it if need be");
        }
        m_RenderQueue = *number;
    }
    for (const ShaderLabPass& pass : subShader.passes)
    {
        m_Passes.push_back({&pass, ShaderTagId(pass.lightMode())});
    }
    m_Compiled.resize(m_Passes.size());
}

std::shared_ptr<const Shader> Shader::Load(const std::filesystem::path& path,
                                           std::shared_ptr<ShaderCompiler> compiler)
{
    return std::make_shared<const Shader>(LoadShaderLab(path), std::move(compiler));
}

std::shared_ptr<const Shader> Shader::FromText(std::string_view text, std::string file,
                                               std::shared_ptr<ShaderCompiler> compiler)
{
    ShaderLabParseResult result = ParseShaderLab(text, std::move(file));
    if (result.hasErrors())
    {
        throw AssetError(std::move(result.diagnostics));
    }
    return std::make_shared<const Shader>(std::move(result.document), std::move(compiler));
}

int Shader::FindPassByLightMode(ShaderTagId lightMode) const
{
    const auto it = std::find_if(m_Passes.begin(), m_Passes.end(),
                                 [&](const Pass& pass) { return pass.lightMode == lightMode; });
    return it == m_Passes.end() ? -1 : static_cast<int>(it - m_Passes.begin());
}

int Shader::FindPassByName(std::string_view name) const
{
    const auto it = std::find_if(m_Passes.begin(), m_Passes.end(),
                                 [&](const Pass& pass)
                                 { return EqualIgnoringCase(pass.declaration->name, name); });
    return it == m_Passes.end() ? -1 : static_cast<int>(it - m_Passes.begin());
}

const Shader::Pass& Shader::PassAt(int passIndex) const
{
    if (passIndex < 0 || passIndex >= passCount())
    {
        throw ContractError("shader '" + name() + "' has no pass " + std::to_string(passIndex) +
                            "; it has " + std::to_string(passCount()));
    }
    return m_Passes[static_cast<std::size_t>(passIndex)];
}

const RenderState& Shader::passState(int passIndex) const
{
    return PassAt(passIndex).declaration->state;
}

std::string_view Shader::passLightMode(int passIndex) const
{
    return PassAt(passIndex).declaration->lightMode();
}

const std::string& Shader::passName(int passIndex) const
{
    return PassAt(passIndex).declaration->name;
}

std::shared_ptr<const CompiledPass> Shader::Compile(int passIndex) const
{
    const ShaderLabPass& pass = *PassAt(passIndex).declaration;
    const std::lock_guard lock(m_Mutex);
    std::shared_ptr<const CompiledPass>& compiled = m_Compiled[static_cast<std::size_t>(passIndex)];
    if (!compiled)
    {
        if (!pass.program)
        {
            throw AssetError(m_Document.file, pass.location,
                             name() + ": the pass has no program; fixed-function passes are not "
                                      "drawn, write an HLSLPROGRAM");
        }
        std::vector<std::string> keywords;
        for (const KeywordSet& set : pass.program->keywordSets)
        {
            if (!set.keywords.empty() && !set.keywords.front().empty())
            {
                keywords.push_back(set.keywords.front());
            }
        }
        compiled = m_Compiler->Compile(*pass.program, keywords);
    }
    return compiled;
}

} // namespace limn
