#pragma once

#include <limn/shaderlab/PassProgram.h>

#include "includes/IncludeResolver.h"
#include "tokens/Tokens.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The lines of a program and of the files that it includes, as their authors wrote them.
class ColumnFinder
{
public:
    /// @param program   outlives this, as does
    /// @param resolver  that has found the included files
    ColumnFinder(const PassProgram& program, IncludeResolver& resolver)
        : m_Program(program), m_Resolver(resolver)
    {
    }

    /// Nothing where the file has no such line, or where other things stand before the program in
    /// it. Lives as long as this.
    std::optional<std::string_view> Find(const std::string& file, int line);

    /// The column, from 1, of the token at the index of a preprocessed line; of what a macro made,
    /// that of the macro's name. 0 where it cannot be told.
    int Column(const HlslPlace& place, std::span<const HlslToken> preprocessed, std::size_t index);

    /// Gives what the preprocessor says of a line, for which it counts no columns, that of the word
    /// which it names, where the line holds it.
    void AddColumns(std::vector<Diagnostic>& diagnostics);

private:
    const PassProgram& m_Program;
    IncludeResolver& m_Resolver;
    std::map<std::string, std::string> m_Files; ///< by name
};

} // namespace limn
