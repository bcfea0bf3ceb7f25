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
    /// @param program   must outlive this
    /// @param resolver  the one that has found the included files; must outlive this
    ColumnFinder(const PassProgram& program, IncludeResolver& resolver)
        : m_Program(program), m_Resolver(resolver)
    {
    }

    /// Returns a line of a file, or nullopt if the file has no such line or has other text before
    /// the program in it. The line lives as long as this.
    std::optional<std::string_view> Find(const std::string& file, int line);

    /// Returns the column, from 1, of the token at the index of a preprocessed line. For the text
    /// of a macro it is the column of the macro's name; it is 0 if it is not known.
    int Column(const HlslPlace& place, std::span<const HlslToken> preprocessed, std::size_t index);

    /// Adds columns to the preprocessor's diagnostics, which have only lines: the column of the
    /// word that a message names, if the line contains it.
    void AddColumns(std::vector<Diagnostic>& diagnostics);

    /// Returns whether a file is one of limn's own library.
    bool isOfLibrary(const std::string& file);

private:
    const PassProgram& m_Program;
    IncludeResolver& m_Resolver;
    std::map<std::string, std::string> m_Files; ///< by name
};

} // namespace limn
