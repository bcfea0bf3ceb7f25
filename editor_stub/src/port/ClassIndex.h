#pragma once

#include "port/csharp/CSharpFile.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace limn
{

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
    const CSharpClass* OuterOf(const CSharpClass& one) const { return m_Outer.at(&one); }

    /// Returns the class that a type's name means in this context, or null if the files have none.
    /// @param context  the class in which the name is used; null = outside of all classes
    const CSharpClass* Find(std::string_view type, const CSharpClass* context) const;

private:
    void Add(const std::vector<CSharpClass>& classes, const CSharpClass* outer);
    bool isVisible(const CSharpClass& one, const CSharpClass* context) const;

    std::vector<const CSharpClass*> m_All;
    std::map<const CSharpClass*, const CSharpClass*> m_Outer;
    std::multimap<std::string, const CSharpClass*, std::less<>> m_ByName;
    std::function<bool(std::string_view)> m_IsOfUnity;
};

} // namespace limn
