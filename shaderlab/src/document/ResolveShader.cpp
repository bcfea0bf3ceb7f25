#include <limn/shaderlab/ResolveShader.h>

#include <limn/shaderlab/PackageRange.h>
#include <limn/shaderlab/ProgramRequirements.h>

#include <limn/base/Text.h>

#include <algorithm>
#include <optional>

namespace limn
{

namespace
{

/// "" if all hold.
std::string UnmetRequirement(const std::vector<PackageRequirement>& requirements,
                             const ShaderCriteria& criteria)
{
    static constexpr std::string_view k_Unity = "unity=";
    for (const PackageRequirement& requirement : requirements)
    {
        std::string_view package = requirement.package;
        std::string_view range = requirement.range;
        const bool isOfEditor = range.starts_with(k_Unity);
        const auto present = criteria.packages.find(package);
        const auto found = isOfEditor ? criteria.packages.find("unity") : present;
        if (present == criteria.packages.end() || found == criteria.packages.end())
        {
            return "it requires the package '" + requirement.package + "'";
        }
        const std::string& version = found->second;
        range.remove_prefix(isOfEditor ? k_Unity.size() : 0);
        if (!isInPackageRange(version, range))
        {
            return "it requires '" + requirement.package + "' " + requirement.range +
                   ", and limn stands for " + version;
        }
    }
    return {};
}

/// Why a SubShader is not drawn with.
struct Obstacle
{
    std::string reason;       ///< "" = none
    bool isByProgram = false; ///< only limn or the device cannot run its programs
};

/// "" if the SubShader is for URP or for any pipeline. The second name is that of URP's old manual.
std::string ForeignPipeline(const ShaderLabSubShader& subShader)
{
    static constexpr std::string_view k_Universal = "UniversalPipeline";
    const std::string* pipeline = subShader.tags.Find("RenderPipeline");
    if (pipeline == nullptr || pipeline->empty() || *pipeline == k_Universal ||
        *pipeline == "UniversalRenderPipeline")
    {
        return {};
    }
    return "its RenderPipeline is '" + *pipeline + "'" + DidYouMean(*pipeline, {k_Universal});
}

Obstacle FindObstacle(const ShaderLabSubShader& subShader, const ShaderCriteria& criteria)
{
    if (std::string foreign = ForeignPipeline(subShader); !foreign.empty())
    {
        return {std::move(foreign)};
    }
    if (subShader.passes.empty())
    {
        return {"it has no pass"};
    }
    if (subShader.lod > criteria.maximumLod)
    {
        return {"its LOD " + std::to_string(subShader.lod) + " is above the maximum, " +
                std::to_string(criteria.maximumLod)};
    }
    if (std::string unmet = UnmetRequirement(subShader.packageRequirements, criteria);
        !unmet.empty())
    {
        return {std::move(unmet)};
    }
    for (const ShaderLabPass& pass : subShader.passes)
    {
        const auto reason = pass.program
                                ? ReasonNotSupported(*pass.program, criteria.missingFeatures)
                                : std::nullopt;
        if (reason)
        {
            return {reason->message, true};
        }
    }
    return {};
}

/// "Some/Shader/PASS" as shader and pass.
std::pair<std::string_view, std::string_view> SplitUsePass(std::string_view text)
{
    const std::size_t slash = text.rfind('/');
    return slash == text.npos ? std::pair(text, std::string_view())
                              : std::pair(text.substr(0, slash), text.substr(slash + 1));
}

class Resolver
{
public:
    Resolver(const ShaderDatabase* database, const ShaderCriteria& criteria)
        : m_Database(database), m_Criteria(criteria)
    {
    }

    ResolvedShader Resolve(const ShaderLabDocument& document)
    {
        const std::optional<Choice> choice = Choose(document);
        if (!choice)
        {
            std::vector<Diagnostic> all = {
                {Severity::Error, document.file, document.location,
                 document.name + ": no SubShader that URP can draw with; add one whose "
                                 "\"RenderPipeline\" tag is absent or \"UniversalPipeline\""}};
            all.insert(all.end(), m_Notes.begin(), m_Notes.end());
            throw AssetError(std::move(all));
        }
        ResolvedShader result;
        result.fallback = choice->document == &document ? "" : choice->document->name;
        result.subShaderIndex = static_cast<int>(choice->index);
        result.subShader = Expand(*choice);
        for (const std::string_view lightMode : k_FallbackLightModes)
        {
            AddFallbackPass(*choice, lightMode, result.subShader.passes);
        }
        result.notes = std::move(m_Notes);
        result.errors = std::move(m_Errors);
        return result;
    }

    /// The pass that a UsePass names; nothing after an error.
    std::optional<ShaderLabPass> FindUsedPass(const ShaderLabDocument& user,
                                              const ShaderLabPass& use)
    {
        const auto [shader, name] = SplitUsePass(use.usePass);
        const ShaderLabDocument* source = FindUsedShader(user, use, std::string(shader));
        if (source == nullptr)
        {
            return std::nullopt;
        }
        // Faults of the source's other SubShaders do not matter here.
        const std::optional<Choice> choice = Resolver(m_Database, m_Criteria).Choose(*source);
        std::vector<std::string_view> names;
        const ShaderLabPass* found = nullptr;
        if (choice)
        {
            source = choice->document;
            for (const ShaderLabPass& pass : source->subShaders[choice->index].passes)
            {
                const bool isUse = pass.kind == ShaderLabPassKind::UsePass;
                names.push_back(isUse ? SplitUsePass(pass.usePass).second : pass.name);
                found = EqualsIgnoringCase(names.back(), name) ? &pass : found;
            }
        }
        if (found == nullptr)
        {
            std::erase(names, std::string_view());
            Error(user, use.location,
                  "UsePass: shader '" + std::string(shader) + "' has no pass named " +
                      UnknownName(name, names));
            return std::nullopt;
        }
        if (found->kind != ShaderLabPassKind::UsePass)
        {
            return *found;
        }
        m_Users.push_back(use.usePass);
        std::optional<ShaderLabPass> next = FindUsedPass(*source, *found);
        m_Users.pop_back();
        return next;
    }

    std::vector<Diagnostic> TakeErrors() { return std::move(m_Errors); }

private:
    struct Choice
    {
        const ShaderLabDocument* document = nullptr;
        std::size_t index = 0;
    };

    /// Notes say why what comes before the choice was left out.
    std::optional<Choice> Choose(const ShaderLabDocument& document)
    {
        std::optional<Choice> withoutPrograms;
        std::vector<const ShaderLabDocument*> seen;
        const ShaderLabDocument* current = &document;
        while (current != nullptr)
        {
            if (std::ranges::find(seen, current) != seen.end())
            {
                Note(*seen.back(), seen.back()->location,
                     "Fallback: '" + current->name + "' leads back to itself");
                break;
            }
            seen.push_back(current);
            for (std::size_t i = 0; i < current->subShaders.size(); ++i)
            {
                const Obstacle obstacle = FindObstacle(current->subShaders[i], m_Criteria);
                if (obstacle.reason.empty())
                {
                    return Choice{current, i};
                }
                if (obstacle.isByProgram && current == &document && !withoutPrograms)
                {
                    withoutPrograms = Choice{current, i};
                }
                Note(*current, current->subShaders[i].location,
                     "SubShader " + std::to_string(i) + " is passed over: " + obstacle.reason);
            }
            current = FindFallback(*current);
        }
        return withoutPrograms;
    }

    const ShaderLabDocument* FindFallback(const ShaderLabDocument& document)
    {
        if (document.fallback.empty())
        {
            return nullptr;
        }
        const ShaderLabDocument* fallback =
            m_Database != nullptr ? m_Database->Find(document.fallback) : nullptr;
        if (fallback == nullptr)
        {
            Note(document, document.fallbackLocation,
                 "Fallback: unknown shader " + (m_Database != nullptr
                                                    ? m_Database->UnknownShader(document.fallback)
                                                    : "'" + document.fallback + "'"));
        }
        return fallback;
    }

    ShaderLabSubShader Expand(const Choice& choice)
    {
        const ShaderLabDocument& document = *choice.document;
        ShaderLabSubShader result = document.subShaders[choice.index];
        std::vector<ShaderLabPass> passes;
        for (ShaderLabPass& pass : result.passes)
        {
            const std::string unmet = UnmetRequirement(pass.packageRequirements, m_Criteria);
            if (!unmet.empty())
            {
                Note(document, pass.location, "the pass is left out: " + unmet);
                continue;
            }
            if (pass.kind == ShaderLabPassKind::GrabPass)
            {
                Note(document, pass.location, "GrabPass: URP does not have it; it is not drawn");
            }
            std::optional<ShaderLabPass> used = pass.kind == ShaderLabPassKind::UsePass
                                                    ? FindUsedPass(document, pass)
                                                    : std::nullopt;
            passes.push_back(used ? std::move(*used) : std::move(pass));
        }
        result.passes = std::move(passes);
        return result;
    }

    /// Adds the first pass of this LightMode down the chain of fallbacks, unless one is there.
    void AddFallbackPass(const Choice& choice, std::string_view lightMode,
                         std::vector<ShaderLabPass>& passes)
    {
        std::vector<const ShaderLabDocument*> seen;
        const ShaderLabDocument* user = choice.document;
        while (std::ranges::find(passes, lightMode, &ShaderLabPass::lightMode) == passes.end())
        {
            const ShaderLabDocument* fallback =
                m_Database != nullptr ? m_Database->FindLender(user->fallback) : nullptr;
            if (fallback == nullptr || std::ranges::find(seen, fallback) != seen.end())
            {
                return;
            }
            seen.push_back(fallback);
            // Faults of the fallback itself do not matter here.
            Resolver other(m_Database, m_Criteria);
            const std::optional<Choice> next = other.Choose(*fallback);
            if (!next)
            {
                return;
            }
            const std::vector<ShaderLabPass> candidates = other.Expand(*next).passes;
            const auto found = std::ranges::find(candidates, lightMode, &ShaderLabPass::lightMode);
            if (found != candidates.end())
            {
                passes.push_back(*found);
            }
            user = next->document;
        }
    }

    /// The shader that a UsePass names; null after an error.
    const ShaderLabDocument* FindUsedShader(const ShaderLabDocument& user, const ShaderLabPass& use,
                                            const std::string& shader)
    {
        const ShaderLabDocument* source = user.name == shader     ? &user
                                          : m_Database != nullptr ? m_Database->FindLender(shader)
                                                                  : nullptr;
        if (source == nullptr)
        {
            Error(user, use.location,
                  "UsePass: unknown shader " + (m_Database != nullptr
                                                    ? m_Database->UnknownShader(shader)
                                                    : "'" + shader + "'; no folder was searched"));
            return nullptr;
        }
        if (std::ranges::find(m_Users, use.usePass) != m_Users.end())
        {
            Error(user, use.location,
                  "UsePass: '" + use.usePass +
                      "' leads back to itself; name a pass with a program");
            return nullptr;
        }
        return source;
    }

    void Note(const ShaderLabDocument& document, SourceLocation location, std::string message)
    {
        m_Notes.push_back({Severity::Note, document.file, location, std::move(message)});
    }

    void Error(const ShaderLabDocument& document, SourceLocation location, std::string message)
    {
        m_Errors.push_back({Severity::Error, document.file, location, std::move(message)});
    }

    const ShaderDatabase* m_Database;
    const ShaderCriteria& m_Criteria;
    std::vector<std::string> m_Users; ///< shaders whose UsePass is being followed
    std::vector<Diagnostic> m_Notes;
    std::vector<Diagnostic> m_Errors;
};

} // namespace

ResolvedShader ResolveShader(const ShaderLabDocument& document, const ShaderDatabase* database,
                             const ShaderCriteria& criteria)
{
    return Resolver(database, criteria).Resolve(document);
}

std::optional<ShaderLabPass> ResolveUsePass(const ShaderLabDocument& document,
                                            const ShaderLabPass& usePass,
                                            const ShaderDatabase* database,
                                            std::vector<Diagnostic>& errors,
                                            const ShaderCriteria& criteria)
{
    Resolver resolver(database, criteria);
    std::optional<ShaderLabPass> pass = resolver.FindUsedPass(document, usePass);
    const std::vector<Diagnostic> found = resolver.TakeErrors();
    errors.insert(errors.end(), found.begin(), found.end());
    return pass;
}

} // namespace limn
