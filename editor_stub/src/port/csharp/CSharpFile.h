#pragma once

#include "port/csharp/CSharpTokens.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// An attribute: [Range(0, 1)].
struct CSharpAttribute
{
    std::string name; ///< without "Attribute" and namespaces
    CSharpWords arguments;
};

struct CSharpField
{
    std::vector<CSharpAttribute> attributes;
    bool isPublic = false;
    bool isStatic = false; ///< also true for const
    bool isConst = false;
    bool isReadonly = false;
    bool isProperty = false; ///< { get; set; }
    std::string type;        ///< its type without spaces, '?' and namespaces: "List<ShaderTagId>"
    std::string name;
    SourceLocation location; ///< of the name
    CSharpWords value;       ///< its initial value; empty if there is none

    const CSharpAttribute* Find(std::string_view attribute) const;
};

struct CSharpParameter
{
    std::string type;
    std::string name;
    bool isReference = false; ///< ref or out
    CSharpWords value = {};   ///< its default; empty if it has none
};

/// A method, a constructor or a property that computes something.
/// The types of variables by their names.
using CSharpLocals = std::map<std::string, std::string, std::less<>>;

struct CSharpMethod
{
    std::string name;
    std::string type; ///< the type that it returns; "" for a constructor
    bool isOverride = false;
    bool isStatic = false;
    bool isProperty = false;   ///< true for `get` of a property
    bool isSetter = false;     ///< true for `set` of a property X, which is called SetX
    bool isUnread = false;     ///< true if its body is a get and set that are not told apart
    bool isExpression = false; ///< => instead of { }
    std::vector<CSharpParameter> parameters;
    SourceLocation location; ///< of the name
    CSharpWords base;        ///< the arguments of `: base(...)`
    CSharpWords body;        ///< without the braces, or without => and ;
    CSharpLocals intLocals;  ///< int, int[] and what MarkPropertyIds makes of them

    /// Returns whether a call may give this many arguments; the others have defaults.
    bool Takes(std::size_t arguments) const
    {
        return arguments == parameters.size() ||
               (arguments < parameters.size() && !parameters[arguments].value.empty());
    }
    bool isConstructor() const { return type.empty(); }
};

struct CSharpEnumerator
{
    std::string name;
    CSharpWords value;
};

/// Maps a name to the index of the first member that has it. A class may have tens of thousands of
/// members.
using CSharpNames = std::map<std::string, std::size_t, std::less<>>;

struct CSharpFile;

struct CSharpClass
{
    std::string keyword; ///< class, struct, interface, enum, record
    std::string name;
    std::vector<std::string> bases;
    bool isStatic = false;
    bool isGeneric = false;
    bool isPartial = false;
    SourceLocation location; ///< of the name
    CSharpWords words;       ///< the whole class, from its keyword to its }
    std::vector<CSharpField> fields;
    std::vector<CSharpMethod> methods;
    std::vector<CSharpClass> classes;
    std::vector<CSharpEnumerator> enumerators;
    // ParseCSharp fills these when all members are there.
    const CSharpFile* file = nullptr;
    const CSharpClass* outer = nullptr; ///< the class around it; null if there is none
    CSharpNames fieldNames;
    CSharpNames methodNames;
    CSharpNames classNames;
    CSharpNames enumeratorNames;

    bool Derives(std::string_view base) const;
    const CSharpField* FindField(std::string_view field) const;
    const CSharpMethod* FindMethod(std::string_view method) const;
};

/// A C# file as far as a render feature needs it.
struct CSharpFile
{
    std::string path;
    std::string text;
    CSharpTokens tokens; ///< of text
    std::vector<CSharpClass> classes;

    std::string name() const { return std::filesystem::path(path).filename().string(); }

    CSharpFile() = default;
    CSharpFile(const CSharpFile&) = delete;
    CSharpFile& operator=(const CSharpFile&) = delete;
    ~CSharpFile() = default;
};

/// Reads the classes of a file with their members. Bodies stay words. Text that #if leaves out
/// becomes spaces.
/// @param file  must already have its path and text
/// @throws AssetError with line and column if it is no C#, or nested too deeply to be read
void ParseCSharp(CSharpFile& file, const CSharpTarget& target = {});

/// Returns the text of the words, as the file has it.
std::string_view TextOf(const CSharpFile& file, CSharpWords words);

/// Reads the type at `at` and moves `at` behind it. Returns the type without namespaces, '?' and
/// spaces, or "" if there is none.
std::string ReadCSharpType(const CSharpToken*& at);

/// Reads the "<A, B>" at `at` and moves `at` behind it. Returns it without spaces, or "" if the <
/// is no bracket.
std::string ReadCSharpGenerics(const CSharpToken*& at);

/// Cuts words at the commas outside of brackets.
std::vector<CSharpWords> SplitArguments(CSharpWords words);

/// Returns the name of a type without its arguments and brackets: "List" for "List<int>[]".
std::string_view PlainTypeName(std::string_view type);

using CSharpFiles = std::vector<std::unique_ptr<CSharpFile>>;

/// The classes of C# files by name, as C# finds them: outside of a class, its nested classes need
/// its name in front.
class ClassIndex
{
public:
    /// @param files      must outlive this
    /// @param isOfUnity  returns whether Unity has a type of this name
    ClassIndex(const CSharpFiles& files, std::function<bool(std::string_view)> isOfUnity);

    /// Returns all classes, nested ones behind the class that they are in.
    const std::vector<const CSharpClass*>& all() const { return m_All; }

    /// Returns the class that a type's name means in this context, or null if the files have none.
    /// @param context  the class in which the name is used; null = outside of all classes
    const CSharpClass* Find(std::string_view type, const CSharpClass* context) const;

private:
    void Add(const std::vector<CSharpClass>& classes);

    std::vector<const CSharpClass*> m_All;
    std::multimap<std::string, const CSharpClass*, std::less<>> m_ByName;
    std::function<bool(std::string_view)> m_IsOfUnity;
};

} // namespace limn
