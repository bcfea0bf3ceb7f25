#pragma once

#include "port/csharp/CSharpTokens.h"

#include <map>
#include <string>
#include <vector>

namespace limn
{

/// The #if, #elif, #else, #endif, #define and #undef of a C# file, line by line.
class CSharpConditions
{
public:
    /// @param file  the file's name in messages; must outlive this
    CSharpConditions(const std::string& file, const CSharpTarget& target)
        : m_File(file), m_Target(target)
    {
    }

    /// Handles a directive. Other directives than those above have no effect.
    /// @param line  the line from the # on
    /// @throws AssetError if the directive is not allowed there, or if its condition is none
    void Take(std::string_view line, const SourceLocation& location);
    /// @throws AssetError if an #if has no #endif
    void Finish() const;

    /// Returns whether the lines that follow count.
    bool isTaken() const { return m_Open.empty() || m_Open.back().isTaken; }
    const std::vector<CSharpCondition>& answered() const { return m_Answered; }

private:
    struct Branch
    {
        SourceLocation location;
        bool isOuterTaken = true;
        bool wasTaken = false; ///< true if an earlier branch was taken
        bool isTaken = false;
    };

    bool Answer(std::string_view condition, const SourceLocation& location);
    [[noreturn]] void Fail(const SourceLocation& location, const std::string& message) const;

    const std::string& m_File;
    CSharpTarget m_Target;
    std::map<std::string, bool, std::less<>> m_Defined; ///< false for what #undef names
    std::vector<Branch> m_Open;
    std::vector<CSharpCondition> m_Answered;
};

} // namespace limn
