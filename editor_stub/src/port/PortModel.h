#pragma once

#include "port/UseScanner.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// The kind of thing that a class of the C# becomes.
enum class PortRole
{
    Enum,
    Data,      ///< settings, the data of a pass, static members
    Context,   ///< a ContextItem
    Component, ///< a VolumeComponent
    Parameter, ///< class XParameter : VolumeParameter<X>
    Pass,
    Feature,
    Other ///< a comment
};

/// The classes of C# files and their names in C++.
class PortModel
{
public:
    /// @param files  must not be empty; they and the table must outlive this
    /// @throws AssetError naming the first file, if no file has a feature
    PortModel(const CSharpFiles& files, const PortingTable& table);

    const CSharpFiles& files() const { return m_Files; }
    const PortingTable& table() const { return m_Table; }
    const std::string& name() const { return m_Name; } ///< the feature's name without "...Feature"
    const std::vector<const CSharpClass*>& classes() const { return m_Index.all(); }
    std::vector<const CSharpClass*> Of(PortRole role) const;
    /// Returns those of the role that are in no other class.
    std::vector<const CSharpClass*> TopLevel(PortRole role) const;

    PortRole RoleOf(const CSharpClass& one) const { return m_Roles.at(&one); }
    /// Returns whether the class becomes a comment, since it or a class around it is of a kind that
    /// limn cannot have.
    bool isLeftOut(const CSharpClass& one) const;
    /// Returns the class that a type's name means in the class of the PortContext, or null if the
    /// files have none.
    const CSharpClass* Find(std::string_view type) const { return m_Index.Find(type, m_Context); }
    /// Returns it like Find if the type has neither type arguments nor brackets.
    const CSharpClass* FindPlain(const std::string& type) const
    {
        return PlainTypeName(type).size() == type.size() ? Find(type) : nullptr;
    }
    static std::string ClassName(const CSharpClass& one);    ///< "Settings"; never a keyword of C++
    std::string QualifiedName(const CSharpClass& one) const; ///< "Feature::Settings"
    std::string Place(const CSharpClass& one, const SourceLocation& location) const; ///< "A.cs:12"
    /// Returns the text of words of the class, as its file has it.
    std::string Text(const CSharpClass& one, CSharpWords words) const
    {
        return std::string(TextOf(*one.file, words));
    }

    /// Returns the C++ type for a type of C#, or nothing if it is not known.
    std::optional<std::string> CppType(const std::string& type) const;
    /// Returns the type that a pointer to a shared object of this type points to: const Bloom.
    std::optional<std::string> CppPointed(const std::string& type) const;
    /// Returns the initial value of a C++ variable of this type if C# gives none: "{}".
    static std::string CppDefault(const std::string& cppType);
    /// Returns the C++ type of a parameter: const std::string&.
    std::optional<std::string> CppParameter(const std::string& type) const;
    std::optional<std::string> CppParameter(const CSharpParameter& parameter) const;
    /// Returns X of VolumeParameter<X>, or of a class that derives from it; "" for other types.
    std::string HeldType(const std::string& type) const;
    /// Returns whether it is an enum of Unity's with a function of its members: StencilOpEntries.
    static bool hasEntries(std::string_view type);
    /// Returns whether an Inspector takes a field of this type.
    bool isSetting(const std::string& type) const;
    /// Returns whether Unity stores the field.
    bool isSerialized(const CSharpField& field) const;

    /// Returns whether the field becomes a pointer in C++. It does if a pass or its data keep
    /// another owner's object in it, or if any class keeps a component of the volume stack in it.
    bool isShared(const CSharpClass& one, const CSharpField& field) const;

    /// Returns whether a field that becomes a pointer has an object of its own, too: one that the
    /// class makes.
    bool hasOwn(const CSharpClass& one, const CSharpField& field) const;

    /// Returns the class of the PortContext, or null if there is none.
    const CSharpClass* context() const { return m_Context; }

    /// Marks a class as declared in the C++, so that it may be used as a type from here on. Fields,
    /// which the C++ may lack, and the methods in a class's definition are marked likewise.
    template <typename Member>
    void Declare(const Member& one)
    {
        m_Declared.insert(&one);
    }
    /// Takes that back: the C++ has the member, but nothing that it could be used with.
    void Withdraw(const CSharpField& field) { m_Declared.erase(&field); }
    template <typename Member>
    bool isDeclared(const Member& one) const
    {
        return m_Declared.contains(&one);
    }
    /// Returns a name that is neither a keyword of C++ nor the name of a type.
    std::string CppName(const std::string& name) const;

private:
    friend class PortContext;

    PortRole ChooseRole(const CSharpClass& one, int depth = 0) const;

    const CSharpFiles& m_Files;
    const PortingTable& m_Table;
    std::string m_Name;
    ClassIndex m_Index;
    mutable const CSharpClass* m_Context = nullptr; ///< the class in which types are named
    std::map<const CSharpClass*, PortRole> m_Roles;
    std::set<const void*> m_Declared; ///< classes, fields, methods
};

/// While it exists, the model finds types by their names in this class.
class PortContext
{
public:
    PortContext(const PortModel& model, const CSharpClass& one)
        : m_Model(model), m_Before(model.m_Context)
    {
        model.m_Context = &one;
    }
    ~PortContext() { m_Model.m_Context = m_Before; }
    PortContext(const PortContext&) = delete;
    PortContext& operator=(const PortContext&) = delete;

private:
    const PortModel& m_Model;
    const CSharpClass* m_Before;
};

/// The C++ type of an int that holds a property's number.
inline constexpr const char* k_PropertyIdType = "ShaderPropertyId";

/// Returns which argument of a method of Unity's is a property's number, or nothing if none is.
/// @param owner  the method's type; "" if it is not known
std::optional<std::size_t> PropertyArgument(std::string_view owner, std::string_view method,
                                            std::size_t arguments);

/// Changes the type of ints that are property numbers to ShaderPropertyId: fields and parameters
/// that hold a result of Shader.PropertyToID or are used as a property's number. In lists and
/// arrays of such ints the type of the elements is changed.
void MarkPropertyIds(const CSharpFiles& files);

} // namespace limn
