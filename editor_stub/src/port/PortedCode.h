#pragma once

#include "port/PortExpression.h"
#include "port/PortModel.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A thing of the C# and where it went.
struct PortedThing
{
    std::string what;    ///< "setting", "parameter", "pass", "event", "name of a pass"
    std::string name;    ///< "Settings.radius"
    std::string text;    ///< of the C#: type, default
    std::string place;   ///< "Blur.cs:12"
    bool isDone = false; ///< it is C++; else a TODO
};

/// The text of C++ as it is written, and what became of what.
class PortedCode
{
public:
    explicit PortedCode(PortModel& model) : m_Model(model) {}

    PortModel& model() { return m_Model; }
    std::string text; ///< what is written

    void Line(std::string_view line = {}); ///< indented by m_Indent
    void Open(std::string_view line = {}); ///< the line if there is one, {
    void Close(std::string_view end = "}");
    void Label(std::string_view line) { text.append(line).append("\n"); } ///< public:
    /// `// TODO: why, place`, and the C# below it as comments.
    void Todo(const std::string& why, const std::string& place, std::string_view csharp);
    /// C# as comments, moved to the left as far as it goes.
    void Comment(std::string_view csharp);

    void Done(PortedThing thing) { m_Things.push_back(std::move(thing)); }
    const std::vector<PortedThing>& things() const { return m_Things; }
    std::vector<PortedThing>& things() { return m_Things; }

private:
    PortModel& m_Model;
    std::size_t m_Indent = 0;
    std::vector<PortedThing> m_Things;
};

// What stands in classes. Each writes C++ that compiles, and what it cannot write as a TODO.

/// enums, settings, volume components and their enums nested in them; before everything else.
void WriteEnum(PortedCode& code, const CSharpClass& one);
void WriteData(PortedCode& code, const CSharpClass& one);
void WriteComponent(PortedCode& code, const CSharpClass& one);
/// The classes that stand in this one.
std::vector<const CSharpClass*> NestedIn(const CSharpClass& one);
/// The enums and data among these, those first that others need.
void WriteTypes(PortedCode& code, const std::vector<const CSharpClass*>& classes);
/// A method whose body is a comment; a comment as a whole where its types are not known.
/// @param signatures  those that the class has already
void WriteHelper(PortedCode& code, const CSharpClass& one, const CSharpMethod& method,
                 std::set<std::string>& signatures);
/// One field: a member, a constant, or a TODO. Names that now have a value go into the scope.
void WriteField(PortedCode& code, const CSharpClass& one, const CSharpField& field,
                PortScope& scope);
/// What an Inspector is told of the fields.
void WriteDescription(PortedCode& code, const CSharpClass& one);

void WritePass(PortedCode& code, const CSharpClass& one);
/// The class of a feature, whose methods are defined behind the passes.
void WriteFeature(PortedCode& code, const CSharpClass& one);
void WriteFeatureMethods(PortedCode& code, const CSharpClass& one);
/// The methods of the base class that others of their names would hide.
void WriteUsing(PortedCode& code, const CSharpClass& one);

/// A method of a feature or a pass in C++.
struct PortedSignature
{
    std::string result;
    std::string name;
    std::string parameters; ///< with their brackets; each may be unused
    bool isOverride = false;

    std::string Text(const std::string& owner = "") const;
};
/// Nothing where its types are not known, or limn never calls it.
std::optional<PortedSignature> SignatureOf(const PortModel& model, const CSharpClass& one,
                                           const CSharpMethod& method);
/// Returns something from a method whose body is a comment.
void WriteResult(PortedCode& code, const PortedSignature& signature);
/// What the method's parameters and the class's fields stand for.
PortScope ScopeOf(const PortModel& model, const CSharpClass& one, const CSharpMethod& method);
/// What a parameter or variable of a method is called in C++: nothing that hides a member.
std::string LocalName(const PortModel& model, const CSharpClass& one, const std::string& name);
/// The C# of a method that adds passes to a render graph, as comments, and the passes in C++.
/// @return false, and writes nothing, where it adds none
bool WriteGraphPasses(PortedCode& code, const CSharpClass& one, const CSharpMethod& method);
/// What a field of the class stands for, in its methods.
PortValue VariableOf(const PortModel& model, const CSharpClass& one, const CSharpField& field);
/// The text between the braces.
std::string_view BodyText(const CSharpFile& file, const CSharpMethod& method);

/// `a = b;` outside of brackets in a body.
struct PortedAssignment
{
    CSharpWords target;
    CSharpWords value;
};
std::vector<PortedAssignment> AssignmentsOf(CSharpWords body);
/// The assignment in C++; "" where it is none that is known to mean the same.
std::string AssignmentText(const PortModel& model, const PortScope& scope,
                           const PortedAssignment& assignment);

/// The header and the source of a plug-in with the features.
std::string PortedHeader(PortedCode& code, const std::vector<std::string>& sources);
std::string PortedSource(PortedCode& code);
/// The name by which limn knows a feature or component of the plug-in: the class's, and "Port"
/// behind it where limn has one of that name.
std::string RegisteredName(const CSharpClass& one);

} // namespace limn
