#pragma once

#include "port/PortExpression.h"
#include "port/PortModel.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// A thing of the C# and what it became.
struct PortedThing
{
    std::string what;    ///< "setting", "parameter", "pass", "event", "name of a pass"
    std::string name;    ///< "Settings.radius"
    std::string text;    ///< its type and default in the C#
    std::string place;   ///< "Blur.cs:12"
    bool isDone = false; ///< true if it is C++; else it is a TODO
};

/// The C++ text that is being written, and what each thing of the C# became.
class PortedCode
{
public:
    explicit PortedCode(PortModel& model) : m_Model(model) {}

    PortModel& model() { return m_Model; }
    std::string text; ///< the text written so far

    void Line(std::string_view line = {}); ///< indented by m_Indent
    void Open(std::string_view line = {}); ///< writes the line, if there is one, and a {
    void Close(std::string_view end = "}");
    /// Writes the line behind the class that is being written and those around it.
    void Behind(std::string line) { m_Behind.push_back(std::move(line)); }
    void Label(std::string_view line) { text.append(line).append("\n"); } ///< public:
    /// Writes `// TODO: why, place`, and the C# below it as comments.
    void Todo(const std::string& why, const std::string& place, std::string_view csharp);
    /// Writes the C# of a method like that.
    void TodoBody(const std::string& why, const CSharpClass& one, const CSharpMethod& method);
    /// Writes C# as comments, moved to the left as far as possible.
    void Comment(std::string_view csharp);

    /// Takes the [[maybe_unused]] away from what is used in the text from there on.
    void TrimUnused(std::size_t begin);
    /// Notes that the C++ makes the pass of this member.
    void Make(const std::string& pass) { m_Made.insert(pass); }
    bool isMade(const std::string& pass) const { return m_Made.contains(pass); }

    void Done(PortedThing thing) { m_Things.push_back(std::move(thing)); }
    const std::vector<PortedThing>& things() const { return m_Things; }

private:
    PortModel& m_Model;
    std::size_t m_Indent = 0;
    std::vector<std::string> m_Behind;
    std::vector<PortedThing> m_Things;
    std::set<std::string> m_Made;
};

// These write the contents of files and classes, in C++ that compiles. A part that they cannot
// write becomes a TODO.

/// Writes an enum. Enums, data and components, with the enums nested in them, come before
/// everything else.
void WriteEnum(PortedCode& code, const CSharpClass& one);
void WriteData(PortedCode& code, const CSharpClass& one);
void WriteComponent(PortedCode& code, const CSharpClass& one);
/// Returns the classes that are nested in this one.
std::vector<const CSharpClass*> NestedIn(const CSharpClass& one);
/// Writes the enums and data among these classes; those that others need come first.
void WriteTypes(PortedCode& code, const std::vector<const CSharpClass*>& classes);
/// Writes a method with its body as a comment. If its types are not known, the whole method becomes
/// a comment.
/// @param signatures  the signatures that the class already has
void WriteHelper(PortedCode& code, const CSharpClass& one, const CSharpMethod& method,
                 std::set<std::string>& signatures);
/// Writes one field: a member, a constant, or a TODO. Adds names that now have a value to the
/// scope.
void WriteField(PortedCode& code, const CSharpClass& one, const CSharpField& field,
                PortScope& scope);
/// Writes the Describe of a class, which describes its fields to an Inspector.
void WriteDescription(PortedCode& code, const CSharpClass& one);

void WritePass(PortedCode& code, const CSharpClass& one);
/// Writes the class of a feature. Its methods are defined behind the passes.
void WriteFeature(PortedCode& code, const CSharpClass& one);
void WriteFeatureMethods(PortedCode& code, const CSharpClass& one);
/// Writes using-declarations for the methods of the base class that overloads would hide.
void WriteUsing(PortedCode& code, const CSharpClass& one);

/// A method of a feature or a pass in C++.
struct PortedSignature
{
    std::string result;
    std::string name;
    std::string parameters; ///< with brackets; each parameter may be unused
    bool isOverride = false;

    std::string Text(const std::string& owner = "") const;
};
/// Returns the signature of a method in C++, or nothing if its types are not known or limn never
/// calls it.
std::optional<PortedSignature> SignatureOf(const PortModel& model, const CSharpClass& one,
                                           const CSharpMethod& method);
/// Returns whether a method of data or of a component is const in C++: it changes no field.
bool IsConst(const PortModel& model, const CSharpClass& one, const CSharpMethod& method);
/// Returns whether a body assigns to the name or to a member of it.
/// @param isField  true if `this.name` counts, too
bool IsChanged(CSharpWords body, std::string_view name, bool isField = false);
/// Returns whether the body of a method of Unity's changes its copy of a parameter that C++ does
/// not copy.
bool IsCopied(const std::string& cppType, const CSharpMethod& method, const std::string& parameter);
/// Writes the return statement of a method whose body is a comment.
void WriteResult(PortedCode& code, const PortedSignature& signature);
/// Returns the C++ values of the method's parameters and the class's fields.
PortScope ScopeOf(const PortModel& model, const CSharpClass& one, const CSharpMethod& method);
/// Returns the C++ name of a method's parameter or variable, which hides no member.
std::string LocalName(const PortModel& model, const CSharpClass& one, const std::string& name);
/// Notes the passes that a method adds to a render graph as ones that stay comments.
void NoteGraphPasses(PortedCode& code, const CSharpClass& one, const CSharpMethod& method);
/// Returns the C++ value of a field in the methods of its class.
PortValue VariableOf(const PortModel& model, const CSharpClass& one, const CSharpField& field);
/// Returns C# for a comment behind a line: without line ends and backslashes.
std::string InComment(std::string text);

/// Returns whether code of several lines reads a name: an assignment to it or its members does not.
/// @param orSets  true if an assignment counts, too
bool ReadsName(std::string_view code, std::string_view name, bool orSets = false);
/// Returns the text between the braces of a method.
std::string_view BodyText(const CSharpFile& file, const CSharpMethod& method);

/// A member of every pass that C# sets and C++ has.
struct PassMember
{
    std::string name;
    std::string type;
    std::string what; ///< of a PortedThing
};
/// Returns the member of this name, or null if there is none.
const PassMember* FindPassMember(std::string_view name);

/// Returns whether C++ has the method of a class, and the class that is being written comes behind
/// it.
bool IsCallable(const PortModel& model, const CSharpClass& one, const CSharpMethod& method);

/// Returns the header of a plug-in with the features; PortedSource returns its source.
std::string PortedHeader(PortedCode& code);
std::string PortedSource(PortedCode& code);
/// Returns the name by which limn knows a feature or component of the plug-in: the class's name,
/// with "Port" behind it if limn already has that name.
std::string RegisteredName(const CSharpClass& one);

} // namespace limn
