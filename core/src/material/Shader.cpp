#include <limn/core/BuiltinShaders.h>
#include <limn/core/Shader.h>

#include "material/CompileVariant.h"
#include "support/UniqueId.h"

#include <algorithm>
#include <charconv>
#include <limn/base/Case.h>
#include <limn/shaderlab/InitialKeywords.h>
#include <limn/shaderlab/ResolveShader.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn
{

namespace
{

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
        const auto it = std::ranges::find_if(k_Names, [&](const auto& n)
                                             { return EqualsIgnoringCase(n.first, name); });
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

/// Adds the program that Unity makes of a pass that has none and no fixed-function commands:
/// without them it draws in white.
/// @param file  what a message about the pass names
void AddFixedFunctionProgram(ShaderLabPass& pass, const std::string& file)
{
    if (pass.program || pass.kind != ShaderLabPassKind::Pass || !pass.legacyCommands.empty())
    {
        return;
    }
    pass.program =
        BuiltinShaders().Find("Hidden/Limn/FixedFunction")->subShaders[0].passes[0].program;
    pass.program->file = file;
    if (const std::string* lightMode = pass.tags.Find("LightMode"))
    {
        pass.program->lightMode = *lightMode;
    }
}

} // namespace

Shader::Shader(ShaderLabDocument document, std::shared_ptr<ShaderCompiler> compiler,
               const ShaderDatabase* database)
    : m_Id(NextUniqueId()),
      m_Document(std::move(document)),
      m_Compiler(std::move(compiler)),
      m_InitialKeywords(InitialKeywords(m_Document))
{
    ShaderCriteria criteria;
    if (m_Compiler)
    {
        criteria.missingFeatures = m_Compiler->options().missingFeatures;
    }
    ResolvedShader resolved = ResolveShader(m_Document, database, criteria);
    if (!resolved.errors.empty())
    {
        throw AssetError(std::move(resolved.errors));
    }
    m_SubShader = std::move(resolved.subShader);
    if (const std::string* queue = m_SubShader.tags.Find("Queue"))
    {
        const std::optional<int> number = ParseQueue(*queue);
        if (!number)
        {
            throw AssetError(m_Document.file, m_SubShader.location,
                             "Queue: '" + *queue +
                                 "' is no render queue; write Background, Geometry, AlphaTest, "
                                 "Transparent or Overlay, with +N or -N behind it if need be");
        }
        m_RenderQueue = *number;
    }
    for (ShaderLabPass& pass : m_SubShader.passes)
    {
        if (m_Compiler)
        {
            AddFixedFunctionProgram(pass, m_Document.file);
            if (pass.program)
            {
                pass.program = m_Compiler->ReadPragmas(*pass.program);
            }
        }
        m_LightModes.emplace_back(pass.lightMode());
        m_FullScreen.push_back(ReadFullScreenTag(pass, m_Document.file));
        m_StaysWithinMesh.push_back(StaysWithinMesh(pass));
    }
    m_Initial = std::vector<Variant>(m_SubShader.passes.size());
    m_LastChoices = std::vector<LastChoices>(m_SubShader.passes.size());
}

std::shared_ptr<const Shader> Shader::Load(const std::filesystem::path& path,
                                           std::shared_ptr<ShaderCompiler> compiler,
                                           const ShaderDatabase* database)
{
    return std::make_shared<const Shader>(LoadShaderLab(path), std::move(compiler), database);
}

std::shared_ptr<const Shader> Shader::Find(std::string_view name, const ShaderDatabase& database,
                                           std::shared_ptr<ShaderCompiler> compiler)
{
    const ShaderLabDocument* document = database.Find(name);
    return document ? std::make_shared<const Shader>(*document, std::move(compiler), &database)
                    : nullptr;
}

std::shared_ptr<const Shader> Shader::FromText(std::string_view text, std::string file,
                                               std::shared_ptr<ShaderCompiler> compiler)
{
    return std::make_shared<const Shader>(ParseShaderLab(text, std::move(file)).TakeDocument(),
                                          std::move(compiler));
}

int Shader::FindPassByLightMode(ShaderTagId lightMode) const
{
    const auto it = std::find(m_LightModes.begin(), m_LightModes.end(), lightMode);
    return it == m_LightModes.end() ? -1 : static_cast<int>(it - m_LightModes.begin());
}

int Shader::FindPassByName(std::string_view name) const
{
    const std::vector<ShaderLabPass>& passes = m_SubShader.passes;
    const auto it = std::ranges::find_if(passes, [&](const auto& pass)
                                         { return EqualsIgnoringCase(pass.name, name); });
    return it == passes.end() ? -1 : static_cast<int>(it - passes.begin());
}

const ShaderLabPass& Shader::PassAt(int passIndex) const
{
    if (passIndex < 0 || passIndex >= passCount())
    {
        throw ContractError("shader '" + name() + "' has no pass " + std::to_string(passIndex) +
                            "; it has " + std::to_string(passCount()));
    }
    return m_SubShader.passes[static_cast<std::size_t>(passIndex)];
}

const FullScreenTag* Shader::fullScreenTag(int passIndex) const
{
    PassAt(passIndex);
    const auto& tag = m_FullScreen.at(static_cast<std::size_t>(passIndex));
    return tag ? &*tag : nullptr;
}

bool Shader::HasKeyword(std::string_view keyword) const
{
    const auto has = [&](const KeywordSet& set)
    {
        return std::ranges::find(set.keywords, keyword) != set.keywords.end();
    };
    const auto declares = [&](const ShaderLabPass& pass)
    {
        return pass.program && std::ranges::any_of(pass.program->keywordSets, has);
    };
    return !keyword.empty() && std::ranges::any_of(m_SubShader.passes, declares);
}

int Shader::FindPropertyIndex(std::string_view propertyName) const
{
    const auto& properties = m_Document.properties;
    const auto found = std::ranges::find(properties, propertyName, &ShaderProperty::name);
    return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
}

std::vector<std::string> Shader::keywords(int passIndex, std::span<const std::string> enabled,
                                          std::span<const std::string> globalKeywords) const
{
    const ShaderLabPass& pass = PassAt(passIndex);
    // A fixed-function pass has no keywords.
    return pass.program ? SelectVariant(*pass.program, enabled, globalKeywords)
                        : std::vector<std::string>();
}

std::shared_ptr<const ShaderProgram>
Shader::CompileVariant(int passIndex, const std::vector<std::string>& variant) const
{
    const ShaderLabPass& pass = PassAt(passIndex);
    if (!pass.program)
    {
        const bool isPlain = pass.kind == ShaderLabPassKind::Pass;
        throw AssetError(m_Document.file, pass.location,
                         name() + (isPlain
                                       ? ": the pass has no program, and limn makes none of "
                                         "fixed-function commands; write an HLSLPROGRAM"
                                       : ": a GrabPass is not drawn; read _CameraOpaqueTexture"));
    }
    return limn::CompileVariant(*m_Compiler, *pass.program, variant);
}

template <typename Compilation>
std::shared_ptr<const ShaderProgram> Shader::Once(Variant& variant, const Compilation& compile)
{
    const std::lock_guard lock(variant.mutex);
    if (variant.failure)
    {
        std::rethrow_exception(variant.failure);
    }
    if (!variant.compiled)
    {
        try
        {
            variant.compiled = compile();
        }
        catch (const AssetError&) // others say nothing of the shader
        {
            variant.failure = std::current_exception();
            throw;
        }
    }
    return variant.compiled;
}

std::shared_ptr<const ShaderProgram> Shader::Compile(int passIndex) const
{
    PassAt(passIndex);
    Variant& variant = m_Initial[static_cast<std::size_t>(passIndex)];
    return Once(variant, [&] { return CompileVariant(passIndex, keywords(passIndex)); });
}

std::shared_ptr<const ShaderProgram>
Shader::Compile(int passIndex, std::span<const std::string> enabled,
                std::span<const std::string> globalKeywords) const
{
    PassAt(passIndex);
    constexpr std::size_t k_MostChoices = 16;
    LastChoices& last = m_LastChoices[static_cast<std::size_t>(passIndex)];
    std::unique_lock lock(last.mutex);
    for (const LastChoices::Choice& choice : last.choices)
    {
        if (std::ranges::equal(choice.enabled, enabled) &&
            std::ranges::equal(choice.globals, globalKeywords))
        {
            return choice.compiled;
        }
    }
    lock.unlock(); // others need not wait for the compiler
    LastChoices::Choice choice{{enabled.begin(), enabled.end()},
                               {globalKeywords.begin(), globalKeywords.end()},
                               Choose(passIndex, enabled, globalKeywords)};
    lock.lock();
    last.choices.resize(std::max(last.choices.size(), last.next + 1));
    LastChoices::Choice& place = last.choices[last.next];
    last.next = (last.next + 1) % k_MostChoices;
    place = std::move(choice);
    return place.compiled;
}

std::shared_ptr<const ShaderProgram>
Shader::Choose(int passIndex, std::span<const std::string> enabled,
               std::span<const std::string> globalKeywords) const
{
    std::vector<std::string> wanted = keywords(passIndex, enabled, globalKeywords);
    const auto isProcedural = [](const auto& names)
    {
        return std::ranges::find(names, k_ProceduralInstancing) != names.end();
    };
    if (isProcedural(globalKeywords) && !isProcedural(wanted)) // no program has to declare it
    {
        wanted.emplace_back(k_ProceduralInstancing);
    }
    if (wanted == keywords(passIndex))
    {
        return Compile(passIndex);
    }
    std::unique_lock mapLock(m_Mutex);
    Variant& variant = m_Others[{passIndex, wanted}]; // stays where it is
    mapLock.unlock();
    return Once(variant, [&] { return CompileVariant(passIndex, wanted); });
}

} // namespace limn
