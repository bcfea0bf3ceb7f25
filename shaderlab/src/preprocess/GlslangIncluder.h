#pragma once

#include "includes/IncludeResolver.h"

#include <glslang/Public/ShaderLang.h>

#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// Returns the text of a file for glslang's preprocessor, with the same lines: Unity's directives
/// become glslang's or blanks, and `#warning x` becomes a pragma for ReadWarningPragma.
std::string TranslateDirectives(std::string_view text);

/// Returns the message of a `#warning` that went through the preprocessor, or nullopt for other
/// lines.
std::optional<std::string> ReadWarningPragma(std::string_view line);

/// Returns whether a text names a macro that is defined in only one stage.
bool NamesStages(std::string_view text);

/// Gives files to glslang and keeps them until it is done.
class GlslangIncluder final : public glslang::TShader::Includer
{
public:
    explicit GlslangIncluder(IncludeResolver& resolver) : m_Resolver(resolver) {}

    IncludeResult* includeLocal(const char* header, const char* includer,
                                std::size_t depth) override;
    IncludeResult* includeSystem(const char* header, const char* includer,
                                 std::size_t depth) override;
    void releaseInclude(IncludeResult*) override {}

    /// Returns whether files of the High Definition pipeline were asked for and not found.
    bool needsHighDefinition() const { return m_NeedsHighDefinition; }
    /// Returns whether an included file names a macro that depends on the stage.
    bool namesStages() const { return m_NamesStages; }
    /// Returns whether a file was not found; files that may not be read do not count.
    bool hasMissing() const { return m_HasMissing; }

private:
    struct Loaded
    {
        std::string text;
        std::unique_ptr<IncludeResult> result;
    };

    IncludeResult* Include(const std::string& header, const char* includer, std::size_t depth);
    IncludeResult* Keep(const std::string& name, std::string text);
    std::string ReasonToStop(std::size_t depth);
    std::string Circle() const; ///< "a -> b -> a" of m_Chain, outermost first; "" if there is none

    IncludeResolver& m_Resolver;
    std::list<Loaded> m_Loaded;
    std::set<std::string> m_Once;     ///< files with `#pragma once` that were included
    std::vector<std::string> m_Chain; ///< the files that are being read now, outermost first
    std::size_t m_TotalSize = 0;
    /// The last file that could not be read; glslang asks for `"x"` again as if it were `<x>`.
    std::string m_FailedHeader;
    std::size_t m_FailedDepth = 0;
    IncludeResult* m_FailedResult = nullptr;
    bool m_HasStopped = false;
    bool m_NeedsHighDefinition = false;
    bool m_HasMissing = false;
    bool m_NamesStages = false;
};

} // namespace limn
