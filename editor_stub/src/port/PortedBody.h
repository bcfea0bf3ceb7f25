#pragma once

#include "port/PortedStatement.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// Writes the body of a method in C++, a line for each line of C#. A statement that cannot be
/// written becomes a TODO with the reason, and the C# below it as comments.
class PortedBody : private PortedStatement
{
public:
    PortedBody(PortedCode& code, const CSharpClass& one, const CSharpMethod& method);

    /// Writes the method's statements.
    void Write();

private:
    void WriteStatements(CSharpWords words);
    Word WriteStatement(Word at, Word end);
    Word WriteKeyword(Word at, Word end);
    Word WriteIf(Word at, Word end);
    Word WriteLoop(Word at, Word end);
    std::string StepText(CSharpWords step);
    Word WriteForEach(Word at, Word end);
    Word WriteSwitch(Word at, Word end);
    Word WriteUsing(Word at, Word end);
    Word WriteGraphPass(Word at, Word end);
    void WriteBlock(Word at, Word end);
    bool WriteReturn(CSharpWords words);
    bool WriteThrow(CSharpWords words);
    void WarnOfPass(CSharpWords words);
    bool WriteRenderFunction(CSharpWords words);
    void TrimThis(std::size_t begin);
    void WriteComments(std::size_t begin, std::size_t end);

    std::string m_Result;      ///< the C# type that the method returns
    int m_Depth = 0;           ///< of the statements that are being written
    int m_Scopes = 0;          ///< profiling scopes around them
    bool m_IsReturned = false; ///< true if the last statement was a return
    /// The data's type of each builder of a graph pass, and its context.
    std::map<std::string, std::pair<std::string, std::string>> m_Builders;
};

} // namespace limn
