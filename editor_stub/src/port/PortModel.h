#pragma once

#include "port/ClassIndex.h"
#include "port/UseScanner.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// What a class of the C# becomes.
enum class PortRole
{
    Enum,
    Data,      ///< settings, what a pass hands over, static members
    Context,   ///< a ContextItem
    Component, ///< a VolumeComponent
    Parameter, ///< class XParameter : VolumeParameter<X>
    Pass,
    Feature,
    Other ///< a comment
};

/// The classes of C# files and what they are called in C++.
class PortModel
{
public:
    /// @param files  not empty; they and the table must outlive this
    /// @throws AssetError naming the first file if none of them has a feature
    PortModel(const CSharpFiles& files, const PortingTable& table);

    const CSharpFiles& files() const { return m_Files; }
    const PortingTable& table() const { return m_Table; }
    const std::string& name() const { return m_Name; } ///< of the feature, without "...Feature"
    const std::vector<const CSharpClass*>& classes() const { return m_Index.all(); }
    std::vector<const CSharpClass*> Of(PortRole role) const;

    PortRole RoleOf(const CSharpClass& one) const { return m_Places.at(&one).role; }
    const CSharpFile& FileOf(const CSharpClass& one) const { return *m_Places.at(&one).file; }
    const CSharpClass* OuterOf(const CSharpClass& one) const { return m_Index.OuterOf(one); }
    /// Whether it is a comment, as it or what it is in is of the kind that limn cannot have.
    bool isLeftOut(const CSharpClass& one) const;
    /// As the class that a PortContext is about calls it; null where the files have none.
    const CSharpClass* Find(std::string_view type) const { return m_Index.Find(type, m_Context); }
    static std::string ClassName(const CSharpClass& one);    ///< "Settings"; none of C++'s words
    std::string QualifiedName(const CSharpClass& one) const; ///< "Feature::Settings"
    std::string Place(const CSharpClass& one, const SourceLocation& location) const; ///< "A.cs:12"

    /// What C++ calls a type of C#; nothing where that is not known.
    std::optional<std::string> CppType(const std::string& type) const;
    /// Gives the type that a pointer to a shared object of this type points to: const Bloom.
    std::optional<std::string> CppPointed(const std::string& type) const;
    /// The value that a variable of C++'s type begins with where C# does not say one: "{}".
    static std::string CppDefault(const std::string& cppType);
    /// As a parameter: const std::string&.
    std::optional<std::string> CppParameter(const std::string& type) const;
    std::optional<std::string> CppParameter(const CSharpParameter& parameter) const;
    /// Whether an Inspector takes a field of this type.
    bool isSetting(const std::string& type) const;
    /// Whether Unity stores the field.
    bool isSerialized(const CSharpField& field) const;

    /// Returns whether the field becomes a pointer in C++: a pass or its data keep an object of
    /// somebody else's in it, or anybody keeps a component of the volume stack.
    bool isShared(const CSharpClass& one, const CSharpField& field) const;

    /// Classes of the files may be used as types from here on; fields, which C++ has or not, and
    /// the methods in a class's definition, likewise.
    template <typename Member>
    void Declare(const Member& one)
    {
        m_Declared.insert(&one);
    }
    template <typename Member>
    bool isDeclared(const Member& one) const
    {
        return m_Declared.contains(&one);
    }
    /// A name that is none of C++'s words and none of a type.
    std::string CppName(const std::string& name) const;

private:
    struct ClassPlace
    {
        const CSharpFile* file = nullptr;
        PortRole role = PortRole::Other;
    };

    friend class PortContext;

    void Place(const CSharpFile& file, const CSharpClass& one);
    static bool isAssigned(const CSharpClass& one, std::string_view field);
    PortRole ChooseRole(const CSharpClass& one, int depth = 0) const;

    const CSharpFiles& m_Files;
    const PortingTable& m_Table;
    std::string m_Name;
    ClassIndex m_Index;
    mutable const CSharpClass* m_Context = nullptr; ///< in which types are called
    std::map<const CSharpClass*, ClassPlace> m_Places;
    std::set<std::pair<const CSharpClass*, std::string_view>> m_PlacedNames; ///< and what is around
    std::set<const void*> m_Declared; ///< classes, fields, methods
};

/// While it is there, types are what they are called in this class.
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

/// What C++ calls an int that holds a property's number.
inline constexpr const char* k_PropertyIdType = "ShaderPropertyId";

/// Gives the fields and parameters of type int that hold what Shader.PropertyToID gives, or are
/// taken for a property's number, the type ShaderPropertyId, and lists and arrays of such ints that
/// of their elements.
void MarkPropertyIds(const CSharpFiles& files);

} // namespace limn
