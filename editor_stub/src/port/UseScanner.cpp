#include "port/UseScanner.h"

#include <algorithm>
#include <limn/base/WordList.h>
#include <map>
#include <optional>
#include <set>

namespace limn
{

namespace
{

constexpr int k_MaxBases = 20; ///< of classes that derive from each other

/// The name of a type that is not known.
constexpr const char* k_UnknownType = "?";

/// Returns whether a word is a keyword of the language other than a type, `new`, `this` or `base`.
bool IsCSharpKeyword(std::string_view word)
{
    static const WordList keywords(
        "if else for foreach while do switch case default break continue return throw try catch "
        "finally using lock in out ref is as null true false typeof sizeof checked unchecked await "
        "yield goto fixed stackalloc params and or not when static const unsafe delegate _ async "
        "where with readonly value get set add remove init");
    return keywords.Has(word);
}

/// Returns T for "<T>".
std::string Inside(const std::string& generics)
{
    return generics.substr(1, generics.size() - 2);
}

/// Returns the type of a member's value.
std::string ResultOf(const PortEntry& entry)
{
    return entry.result.empty() ? k_UnknownType : entry.result;
}

/// Returns the type of the elements: T for "T[]" and "List<T>".
std::string ElementType(const std::string& type)
{
    if (type.ends_with("[]"))
    {
        return type.substr(0, type.size() - 2);
    }
    const std::size_t open = type.find('<');
    const bool isList = open != std::string::npos && type.find(',') == std::string::npos;
    return isList ? type.substr(open + 1, type.rfind('>') - open - 1) : k_UnknownType;
}

bool IsBuiltinType(std::string_view word)
{
    static const WordList types("int uint float double bool string object void byte sbyte short "
                                "ushort long ulong char decimal var dynamic nint nuint");
    return types.Has(word);
}

bool IsGenericName(std::string_view word)
{
    return word == "T" || (word.size() > 1 && word[0] == 'T' && word[1] >= 'A' && word[1] <= 'Z' &&
                           word.size() < 12 && word.find("Handle") == std::string_view::npos);
}

/// Types and attributes that C# and its tools have, for whoever reads.
bool IsOfTools(std::string_view name)
{
    return IsIn(name, {"UsedImplicitly", "Obsolete", "Conditional", "MethodImpl", "NotNull",
                       "CanBeNull", "SuppressMessage", "EditorBrowsable", "Flags"});
}

/// Walks through words of C# and notes what they use. It follows types by name.
class UseScanner
{
public:
    /// @param files, table  must outlive this
    UseScanner(const CSharpFiles& files, const PortingTable& table)
        : m_Table(table),
          m_Own(files, [&table](std::string_view type) { return table.HasType(type); })
    {
        for (const CSharpClass* one : m_Own.all())
        {
            for (const auto& [name, index] : one->methodNames)
            {
                if (one->isStatic && !one->methods[index].parameters.empty())
                {
                    m_Extensions.emplace(name, &one->methods[index]);
                }
            }
        }
    }

    /// Returns the uses, sorted by name, with unknown ones behind the others.
    std::vector<UsedMember> Scan(const CSharpFiles& files)
    {
        for (const auto& file : files)
        {
            std::ranges::for_each(file->classes,
                                  [this](const CSharpClass& one) { ScanClass(one); });
        }
        std::vector<UsedMember> uses;
        std::ranges::transform(m_Uses, std::back_inserter(uses),
                               [](const auto& entry) { return entry.second; });
        return uses;
    }

private:
    using Word = const CSharpToken*;

    void ScanClass(const CSharpClass& one)
    {
        m_Classes.push_back(&one);
        for (const std::string& base : one.bases)
        {
            UseType(base, one.location);
        }
        for (const CSharpField& field : one.fields)
        {
            UseType(field.type, field.location);
            for (const CSharpAttribute& attribute : field.attributes)
            {
                UseAttribute(attribute.name, field.location);
            }
            m_Locals.clear();
            ScanWords(field.value);
        }
        for (const CSharpEnumerator& enumerator : one.enumerators)
        {
            ScanWords(enumerator.value);
        }
        for (const CSharpMethod& method : one.methods)
        {
            ScanMethod(one, method);
        }
        for (const CSharpClass& nested : one.classes)
        {
            ScanClass(nested);
        }
        m_Classes.pop_back();
    }

    void ScanMethod(const CSharpClass& one, const CSharpMethod& method)
    {
        m_Locals.clear();
        UseType(method.type, method.location);
        for (const CSharpParameter& parameter : method.parameters)
        {
            UseType(parameter.type, method.location);
            m_Locals[parameter.name] = parameter.type;
        }
        if (method.isOverride)
        {
            UseOverride(one, method);
        }
        ScanWords(method.base);
        ScanWords(method.body);
    }

    void UseType(std::string_view type, const SourceLocation& location)
    {
        for (std::size_t at = 0; at < type.size();)
        {
            const std::size_t end = std::min(type.find_first_of("<>,[]()*", at), type.size());
            const std::string_view name = type.substr(at, end - at);
            at = end + 1;
            const bool isOwn = FindClass(name) || FindClass(name.substr(0, name.find('.')));
            if (isOwn || name.empty() || name == "..." || IsBuiltinType(name) ||
                IsGenericName(name))
            {
                continue;
            }
            const std::string key(m_Table.Find(name) ? name : name.substr(name.rfind('.') + 1));
            Use(key, m_Table.Find(key), location, "a type that the table does not have");
        }
    }

    void UseAttribute(const std::string& name, const SourceLocation& location)
    {
        if (!IsOfTools(name))
        {
            const std::string key = "[" + name + "]";
            Use(key, m_Table.Find(key), location, "an attribute that the table does not have");
        }
    }

    void UseOverride(const CSharpClass& one, const CSharpMethod& method)
    {
        if (method.name == "ToString" || method.name == "Equals" || method.name == "GetHashCode")
        {
            return;
        }
        for (const std::string& base : one.bases)
        {
            if (FindClass(base) || // overrides what the files define
                UseInherited(PlainTypeName(base), method.name, method.location))
            {
                return;
            }
        }
        Use(one.name + "." + method.name, nullptr, method.location,
            "overrides what the table does not have");
    }

    void ScanWords(CSharpWords words)
    {
        const Word begin = words.data();
        const Word end = begin + words.size();
        const std::vector<Word> outer = std::move(m_OpenBrackets);
        m_OpenBrackets.clear();
        for (Word word = begin; word < end;)
        {
            if (word->isOpen())
            {
                m_OpenBrackets.push_back(word);
            }
            else if (word->match < 0 && !m_OpenBrackets.empty())
            {
                m_OpenBrackets.pop_back();
            }
            if (!word->hole.empty())
            {
                ScanWords(word->hole);
            }
            word = word->isName() ? ScanName(word, begin, end) : word + 1;
        }
        m_OpenBrackets = outer;
    }

    Word ScanName(Word word, Word begin, Word end)
    {
        const Word before = word > begin ? word - 1 : nullptr;
        if (before && (before->Is(".") || before->Is("?.") || before->Is("::")))
        {
            if (!m_Done.contains(word)) // behind a bracket or a text
            {
                const bool isText = before > begin && before[-1].kind == CSharpTokenKind::String;
                Word at = word + 1;
                FollowChain(MemberOf(isText ? "string" : k_UnknownType, word, ""), at, end);
            }
            return word + 1;
        }
        if (word->Is("new"))
        {
            return ScanNew(word, end);
        }
        if (word->Is("nameof") && word + 1 < end && word[1].isOpen())
        {
            return word[1].Behind() - 1;
        }
        if (word + 1 < end && word[1].Is(":") && before && (before->Is("(") || before->Is(",")))
        {
            return word + 1; // the name of an argument
        }
        if (IsCSharpKeyword(word->text))
        {
            return word + 1;
        }
        if (word + 1 < end && isInitializerMember(word, begin))
        {
            MemberOf(m_Initializers[m_OpenBrackets.back()], word, "");
            return word + 1;
        }
        const Word behind = ScanDeclaration(word, begin, end);
        if (behind != word)
        {
            return behind;
        }
        return ScanLambda(word, end) ? word + 1 : ScanHead(word, end);
    }

    Word ScanNew(Word word, Word end)
    {
        Word at = word + 1;
        const std::string type = at < end && !at->Is("(") ? ReadCSharpType(at) : "";
        if (type.empty()) // new(...)
        {
            return word + 1;
        }
        UseType(type, word[1].location);
        const Word braces = at < end && at->Is("(") ? at->Behind() : at;
        if (braces < end && braces->Is("{"))
        {
            m_Initializers[braces] = type;
        }
        Word behind = at;
        FollowChain(type, behind, end);
        return at;
    }

    /// T a = ..., T a;, out T a, foreach (T a in ...), is T a.
    /// @return behind the name, or `word` if it is none
    Word ScanDeclaration(Word word, Word begin, Word end)
    {
        Word at = word;
        const std::string type = ReadCSharpType(at);
        const bool isAfterIs = word > begin && word[-1].Is("is");
        if (type.empty() || type.ends_with("*") || at + 1 >= end || !at->isName() ||
            IsCSharpKeyword(at->text) ||
            !(IsIn(at[1].text, {"=", ";", ",", ")", "in", "(", "}"}) ||
              (isAfterIs && type != "not")))
        {
            return word;
        }
        std::string& known = m_Locals[std::string(at->text)];
        known = type;
        if (type == "var" && at[1].Is("="))
        {
            known = TypeOfValue(at + 2, end);
        }
        else if (type == "var" && at[1].Is("in"))
        {
            known = ElementType(TypeOfValue(at + 2, end));
        }
        else if (type == "var" && word > begin && word[-1].Is("out"))
        {
            known = m_PassData; // AddRasterRenderPass
        }
        UseType(type, word->location);
        return at + 1;
    }

    /// a =>, (a, b) =>
    bool ScanLambda(Word word, Word end)
    {
        if (word + 1 < end && word[1].Is("=>"))
        {
            m_Locals[std::string(word->text)] = k_UnknownType;
            return true;
        }
        if (m_OpenBrackets.empty() || !m_OpenBrackets.back()->Is("("))
        {
            return false;
        }
        const Word behind = m_OpenBrackets.back()->Behind();
        if (behind >= end || !behind->Is("=>") || !(word[-1].Is("(") || word[-1].Is(",")) ||
            !(word[1].Is(",") || word[1].Is(")")))
        {
            return false;
        }
        m_Locals[std::string(word->text)] =
            word[-1].Is("(") ? m_PassData : m_PassContext; // SetRenderFunc
        return true;
    }

    Word ScanHead(Word word, Word end)
    {
        Word head = word;
        if (IsIn(head->text, {"UnityEngine", "System", "Unity", "JetBrains", "UnityEditor"}))
        {
            while (head + 2 < end && head[1].Is(".") && head[2].isName() &&
                   !m_Table.HasType(head->text))
            {
                head += 2; // to the type
                m_Done.insert(head);
            }
        }
        const std::string type = TypeOfHead(head);
        Word at = head + 1;
        if (at < end && at->Is("<"))
        {
            const std::string generics = ReadCSharpGenerics(at);
            UseType(generics, head->location);
        }
        FollowChain(type, at, end);
        return head + 1; // what is in brackets is looked at on its own
    }

    /// a: T { a = 1 } behind new T.
    bool isInitializerMember(Word word, Word begin) const
    {
        return word > begin && (word[-1].Is("{") || word[-1].Is(",")) && word[1].Is("=") &&
               !m_OpenBrackets.empty() && m_Initializers.contains(m_OpenBrackets.back());
    }

    /// Returns the type of a name at the beginning of a chain.
    std::string TypeOfHead(Word word)
    {
        const std::string name(word->text);
        const auto local = m_Locals.find(name);
        if (local != m_Locals.end())
        {
            return local->second;
        }
        const CSharpClass& inner = *m_Classes.back();
        if (name == "this")
        {
            return inner.name;
        }
        if (name == "base" && !inner.bases.empty())
        {
            return inner.bases.front();
        }
        for (auto one = m_Classes.rbegin(); one != m_Classes.rend(); ++one)
        {
            if (const auto type = TypeOfMember(**one, name))
            {
                return *type;
            }
            for (const std::string& base : (*one)->bases)
            {
                if (const PortEntry* entry =
                        UseInherited(PlainTypeName(base), name, word->location, true))
                {
                    return ResultOf(*entry);
                }
            }
        }
        if (FindClass(name) || IsBuiltinType(name) || IsGenericName(name))
        {
            return name;
        }
        if (m_Table.HasType(name))
        {
            if (const PortEntry* entry = m_Table.Find(name))
            {
                Use(name, entry, word->location);
            }
            return name;
        }
        Use(name, nullptr, word->location, "a name that neither the files nor the table have");
        return k_UnknownType;
    }

    /// .a.b(c)[d] behind something of this type; `at` then stands behind it.
    std::string FollowChain(std::string type, Word& at, Word end)
    {
        while (at < end)
        {
            if (at->Is("(") || at->Is("["))
            {
                type = at->Is("(") || type == k_UnknownType ? type : ElementType(type);
                at = at->Behind();
            }
            else if (at->Is("!") && at + 1 < end && at[1].Is("."))
            {
                ++at;
            }
            else if ((at->Is(".") || at->Is("?.")) && at + 1 < end && at[1].isName())
            {
                const Word member = ++at;
                m_Done.insert(member);
                ++at;
                std::string generics;
                if (at < end && at->Is("<"))
                {
                    generics = ReadCSharpGenerics(at);
                    UseType(generics, member->location);
                }
                type = MemberOf(type, member, generics);
                if (std::string context = GraphContextOf(member->text); !context.empty())
                {
                    m_PassData = generics.size() < 3 ? k_UnknownType : Inside(generics);
                    m_PassContext = std::move(context);
                }
            }
            else
            {
                break;
            }
        }
        return type;
    }

    /// @return what the member gives
    std::string MemberOf(const std::string& type, Word member, const std::string& generics)
    {
        const std::string name(member->text);
        const std::string plain(PlainTypeName(type));
        const CSharpClass* own = FindClass(type);
        if (const auto result = own ? TypeOfMember(*own, name) : std::nullopt)
        {
            return *result;
        }
        for (const std::string& base :
             own ? BasesOf(*own) : std::vector{type.ends_with("[]") ? "[]" : plain})
        {
            if (const PortEntry* entry = UseInherited(base, name, member->location))
            {
                return entry->result == "T" && !generics.empty() ? Inside(generics)
                                                                 : ResultOf(*entry);
            }
        }
        if (const auto extension = m_Extensions.find(name); extension != m_Extensions.end())
        {
            return extension->second->type;
        }
        const bool isUnknown = type == k_UnknownType;
        Use((isUnknown ? "(...)" : plain) + "." + name, nullptr, member->location,
            isUnknown ? "a member of something whose type the scanner cannot tell"
                      : "a member that the table does not have");
        return k_UnknownType;
    }

    /// Returns the type of the value that begins there, if it can be known.
    std::string TypeOfValue(Word at, Word end)
    {
        const bool wasSilent = m_IsSilent;
        m_IsSilent = true;
        at += at < end && at->Is("ref") ? 1 : 0; // ref var a = ref b
        std::string type = k_UnknownType;
        if (at < end && at->Is("new"))
        {
            Word behind = at + 1;
            type = behind->Is("(") ? "" : ReadCSharpType(behind);
            type = type.empty() ? k_UnknownType : type;
        }
        else if (at < end && at->isName() && !IsCSharpKeyword(at->text))
        {
            type = TypeOfHead(at);
            Word behind = at + 1;
            type = FollowChain(type, behind, end);
            if (behind < end && behind->Is("as"))
            {
                type = ReadCSharpType(++behind);
            }
        }
        m_IsSilent = wasSilent;
        return type;
    }

    /// Returns the types from which a class derives in the end, through other classes of the files.
    std::vector<std::string> BasesOf(const CSharpClass& one, int depth = 0) const
    {
        std::vector<std::string> bases;
        for (const std::string& base : one.bases)
        {
            const CSharpClass* own = FindClass(base);
            if (own && own != &one && depth < k_MaxBases)
            {
                const auto inherited = BasesOf(*own, depth + 1);
                bases.insert(bases.end(), inherited.begin(), inherited.end());
            }
            else
            {
                bases.emplace_back(PlainTypeName(base));
            }
        }
        return bases;
    }

    const CSharpClass* FindClass(std::string_view type) const
    {
        return m_Own.Find(type, m_Classes.back());
    }

    /// Notes the use of a member that the table has for the type or one of its bases.
    /// @param isExact  true if an entry for all members of a type does not count
    /// @return its entry; null = there is none
    const PortEntry* UseInherited(std::string_view type, const std::string& member,
                                  const SourceLocation& location, bool isExact = false)
    {
        const std::string owner = m_Table.OwnerOf(type, member, isExact);
        const PortEntry* entry = owner.empty() ? nullptr : m_Table.Find(owner, member);
        if (entry)
        {
            Use(owner + "." + member, entry, location);
        }
        return entry;
    }

    /// Returns the type of a member of a class of the files, or nothing if it has no such member.
    std::optional<std::string> TypeOfMember(const CSharpClass& one, const std::string& name,
                                            int depth = 0) const
    {
        if (const CSharpField* field = one.FindField(name))
        {
            return field->type;
        }
        if (const CSharpMethod* method = one.FindMethod(name))
        {
            return method->type;
        }
        if (one.enumeratorNames.contains(name))
        {
            return one.name;
        }
        if (one.classNames.contains(name))
        {
            return one.name + "." + name;
        }
        std::optional<std::string> type;
        for (std::size_t i = 0; i < one.bases.size() && depth < k_MaxBases && !type; ++i)
        {
            const CSharpClass* own = FindClass(one.bases[i]);
            type = own && own != &one ? TypeOfMember(*own, name, depth + 1) : type;
        }
        return type;
    }

    void Use(const std::string& key, const PortEntry* entry, const SourceLocation& location,
             const std::string& problem = "")
    {
        if (m_IsSilent)
        {
            return;
        }
        UsedMember& use = m_Uses[(entry ? "0" : "1") + key];
        use.key = key;
        use.entry = entry;
        use.problem = entry || !use.problem.empty() ? use.problem : problem;
        const CSharpFile* file = m_Classes.back()->file;
        const bool isThere = !use.places.empty() && use.places.back().file == file &&
                             use.places.back().location == location;
        if (!isThere)
        {
            use.places.push_back({file, location});
        }
    }

    const PortingTable& m_Table;
    ClassIndex m_Own;
    /// Extension methods of static classes.
    std::map<std::string, const CSharpMethod*, std::less<>> m_Extensions;
    std::vector<const CSharpClass*> m_Classes; ///< the innermost last
    std::map<std::string, std::string> m_Locals;
    std::map<Word, std::string> m_Initializers; ///< by their {
    std::vector<Word> m_OpenBrackets;
    std::set<Word> m_Done; ///< words already seen as part of something
    std::string m_PassData = k_UnknownType;
    std::string m_PassContext = k_UnknownType;
    bool m_IsSilent = false; ///< true while it only looks for a type
    std::map<std::string, UsedMember> m_Uses;
};

} // namespace

std::string GraphContextOf(std::string_view call)
{
    return call == "AddRasterRenderPass" ? "RasterGraphContext"
           : call == "AddUnsafePass"     ? "UnsafeGraphContext"
           : call == "AddComputePass"    ? "ComputeGraphContext"
                                         : "";
}

std::vector<UsedMember> UsedMembersOf(const CSharpFiles& files, const PortingTable& table)
{
    return UseScanner(files, table).Scan(files);
}

} // namespace limn
