#include "port/UseScanner.h"
#include "port/csharp/CSharpTokens.h"

#include <limn/base/WordList.h>

namespace limn
{

bool IsCSharpKeyword(std::string_view word)
{
    static const WordList keywords(
        "if else for foreach while do switch case default break continue return throw try catch "
        "finally using lock in out ref is as null true false typeof sizeof checked unchecked await "
        "yield goto fixed stackalloc params and or not when static const unsafe delegate _ async "
        "where with readonly value get set add remove init");
    return keywords.Has(word);
}

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

/// a: T { a = 1 } behind new T.
bool UseScanner::isInitializerMember(Word word, Word begin) const
{
    return word > begin && (word[-1].Is("{") || word[-1].Is(",")) && word[1].Is("=") &&
           !m_OpenBrackets.empty() && m_Initializers.contains(m_OpenBrackets.back());
}

UseScanner::Word UseScanner::ScanNew(Word word, Word end)
{
    Word at = word + 1;
    const std::string type = at < end && !at->Is("(") ? ReadCSharpType(at) : "";
    if (type.empty()) // new(...)
    {
        return word + 1;
    }
    UseType(type, word[1].location);
    Word braces = at;
    if (braces < end && braces->Is("(") && braces->match > 0)
    {
        braces += braces->match + 1;
    }
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
UseScanner::Word UseScanner::ScanDeclaration(Word word, Word begin, Word end)
{
    Word at = word;
    const std::string type = ReadCSharpType(at);
    const bool isAfterIs = word > begin && word[-1].Is("is");
    if (type.empty() || type.ends_with("*") || at + 1 >= end || !at->isName() ||
        IsCSharpKeyword(at->text) ||
        !(IsIn(at[1].text, {"=", ";", ",", ")", "in", "(", "}"}) || (isAfterIs && type != "not")))
    {
        return word;
    }
    const std::string name(at->text);
    if (at[1].Is("(")) // a local function
    {
        m_Locals[name] = type;
        UseType(type, word->location);
        return at + 1;
    }
    m_Locals[name] = type;
    if (type == "var" && at[1].Is("="))
    {
        m_Locals[name] = TypeOfValue(at + 2, end);
    }
    else if (type == "var" && at[1].Is("in"))
    {
        const std::string list = TypeOfValue(at + 2, end);
        m_Locals[name] = list == k_UnknownType ? list : ElementType(list);
    }
    else if (type == "var" && word > begin && word[-1].Is("out"))
    {
        m_Locals[name] = m_PassData.empty() ? k_UnknownType : m_PassData; // AddRasterRenderPass
    }
    UseType(type, word->location);
    return at + 1;
}

/// a =>, (a, b) =>
bool UseScanner::ScanLambda(Word word, Word end)
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
    const Word open = m_OpenBrackets.back();
    const Word close = open + open->match;
    if (close + 1 >= end || !close[1].Is("=>") || !(word[-1].Is("(") || word[-1].Is(",")) ||
        !(word[1].Is(",") || word[1].Is(")")))
    {
        return false;
    }
    const bool isFirst = word[-1].Is("(");
    const std::string& type = isFirst ? m_PassData : m_PassContext; // SetRenderFunc
    m_Locals[std::string(word->text)] = type.empty() ? k_UnknownType : type;
    return true;
}

UseScanner::Word UseScanner::ScanHead(Word word, Word end)
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

UseScanner::Word UseScanner::ScanName(Word word, Word begin, Word end)
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
    if (word->Is("nameof") && word + 1 < end && word[1].match > 0)
    {
        return word + 1 + word[1].match;
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

void UseScanner::ScanWords(CSharpWords words)
{
    const Word begin = words.data();
    const Word end = begin + words.size();
    const std::vector<Word> outer = std::move(m_OpenBrackets);
    m_OpenBrackets.clear();
    for (Word word = begin; word < end;)
    {
        if (word->match > 0)
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

} // namespace limn
