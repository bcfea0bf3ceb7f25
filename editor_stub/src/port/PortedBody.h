#pragma once

#include "port/PortedCode.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// Writes the body of a method in C++, a line for each line of C#. A statement that cannot be
/// written becomes a TODO with the reason, and the C# below it as comments.
class PortedBody
{
public:
    PortedBody(PortedCode& code, const CSharpClass& one, const CSharpMethod& method);

    /// Writes the method's statements.
    void Write();

private:
    using Word = const CSharpToken*;

    void WriteStatements(CSharpWords words);
    Word WriteStatement(Word at, Word end);
    Word EndOf(Word at, Word end) const;
    Word WriteKeyword(Word at, Word end);
    Word WriteIf(Word at, Word end);
    Word WriteLoop(Word at, Word end);
    Word WriteForEach(Word at, Word end);
    Word WriteSwitch(Word at, Word end);
    Word WriteUsing(Word at, Word end);
    Word WriteGraphPass(Word at, Word end);
    void WriteBlock(Word at, Word end);
    bool WriteReturn(CSharpWords words);
    bool WriteSimple(CSharpWords words);
    bool WriteDeclaration(CSharpWords words);
    bool DeclareLocal(const std::string& type, const std::string& name, CSharpWords value,
                      bool isReference);
    bool WriteMembers(const PortValue& object, CSharpWords members);
    bool WriteAssignment(CSharpWords target, std::string_view word, CSharpWords value);
    bool WriteMaybe(CSharpWords words);
    bool WriteRenderFunction(CSharpWords words);
    std::string CaptureOf(CSharpWords body, const std::set<std::string>& own) const;
    void WriteComments(std::size_t begin, std::size_t end);
    void Todo(CSharpWords words, const std::string& otherwise = "port");
    bool Fail(const std::string& problem);

    std::optional<PortValue> Value(CSharpWords words, const std::string& wanted = "");
    PortValue& AddLocal(const std::string& name, const std::string& type);
    PortPlace Place() const { return {m_Model, m_Scope, true}; }

    PortedCode& m_Code;
    const PortModel& m_Model;
    const CSharpClass& m_One;
    const CSharpMethod& m_Method;
    PortScope m_Scope;
    std::string m_Result; ///< the C# type that the method returns
    std::string m_Problem;
    bool m_IsReturned = false; ///< true if the last statement was a return
    /// The data's type of each builder of a graph pass, and its context.
    std::map<std::string, std::pair<std::string, std::string>> m_Builders;
};

/// Returns an argument of one of the files' own methods in C++, or nothing if it is not known.
std::optional<std::string> PortArgument(const PortPlace& place, const CSharpClass& owner,
                                        const CSharpParameter& parameter, CSharpWords words,
                                        std::string& problem);
/// Returns "std::make_unique<P>(a, b)" of `new P(a, b)`, or nothing if it is not known.
std::optional<std::string> MakePass(const PortPlace& place, const CSharpClass& pass,
                                    const std::vector<CSharpWords>& arguments,
                                    std::string& problem);

} // namespace limn
