#pragma once

#include "port/PortedCode.h"

#include <optional>
#include <string>

namespace limn
{

/// Writes statements that have no statements in them, and knows the names of the method.
class PortedStatement
{
protected:
    using Word = const CSharpToken*;

    PortedStatement(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
        : m_Code(code),
          m_Model(code.model()),
          m_One(one),
          m_Method(method),
          m_Scope(ScopeOf(m_Model, one, method))
    {
    }
    ~PortedStatement() = default;

    /// Writes a declaration, an assignment or a call, which comes without its semicolon.
    /// @return false, with the reason in m_Problem, if it is not known to mean the same
    bool WriteSimple(CSharpWords words);
    /// Writes the words as comments below a TODO with the reason.
    void Todo(CSharpWords words, const std::string& otherwise = "port");
    bool Fail(const std::string& problem);
    /// Returns "a >>= b" or "a <<= b" of an int, or nothing if the words are something else.
    std::optional<std::string> ShiftText(CSharpWords words);

    std::optional<PortValue> Value(CSharpWords words, const std::string& wanted = "");
    PortValue& AddLocal(const std::string& name, const std::string& type);
    PortPlace Place() const { return {m_Model, m_Scope, true}; }

    PortedCode& m_Code;
    const PortModel& m_Model;
    const CSharpClass& m_One;
    const CSharpMethod& m_Method;
    PortScope m_Scope;
    std::string m_Problem;

private:
    void DeclareOutputs(CSharpWords words);
    bool WriteDeclaration(CSharpWords words);
    bool DeclareLocal(const std::string& type, const std::string& name, CSharpWords value,
                      bool isReference);
    bool WriteMembers(const PortValue& object, CSharpWords members);
    bool WriteAssignment(CSharpWords target, std::string_view word, CSharpWords value);
    bool WriteIfNull(CSharpWords target, CSharpWords value);
    bool WriteSwap(const std::vector<CSharpWords>& targets, CSharpWords values);
    bool WriteMaybe(CSharpWords words);
};

} // namespace limn
