#include "port/HeaderWords.h"
#include "port/PortingTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/RenderTexture.h>
#include <limn/core/SystemInfo.h>

namespace limn::test
{

namespace
{

/// Members that are refused and in the headers all the same: what is written there instead of a
/// function that does something, and where it is.
struct Refusal
{
    const char* key;
    const char* header;
    const char* text;
};
constexpr Refusal k_Refusals[] = {{"ComputeShader.Dispatch",
                                   "core/include/limn/core/ComputeShader.h",
                                   "static_assert(sizeof(Kernel) == 0,\n                      "
                                   "\"ComputeShader::Dispatch: record it "
                                   "with CommandBuffer::DispatchCompute\""}};

/// Calls `check(type, member, entry)` for each entry of the table that is about one member of a
/// type of limn's.
template <typename Check>
int ForEachMember(const HeaderWords& headers, PortVerdict verdict, const Check& check)
{
    int count = 0;
    for (const auto& [key, entry] : UnityPortingTable().entries())
    {
        const std::size_t dot = key.rfind('.');
        if (entry.verdict != verdict || dot == std::string::npos || key.back() == '*')
        {
            continue;
        }
        const std::string owner = key.substr(0, dot);
        const std::string type = CppType(owner.substr(owner.rfind('.') + 1));
        if (headers.Has(type, ""))
        {
            ++count;
            check(key, type, key.substr(dot + 1), entry);
        }
    }
    return count;
}

/// Names of limn's in what a row says: what looks like code, and words of several humps. Of
/// `cmd->Clear()` the variable is nobody's.
std::vector<std::string> NamesIn(const std::string& words)
{
    static const std::regex k_Chain(R"([A-Za-z_]\w*((::|->|\.)[A-Za-z_]\w*)*(<\w*>)?\(?)");
    static const std::regex k_Name(R"([A-Za-z_]\w*)");
    static const std::regex k_Humps(R"(\w*[a-z]\w*[A-Z]\w*)");
    const std::string arrow = "→";
    const std::size_t at = words.rfind(arrow);
    const std::string here = at == std::string::npos ? words : words.substr(at + arrow.size());
    std::vector<std::string> names;
    using Iterator = std::sregex_iterator;
    for (Iterator chain(here.begin(), here.end(), k_Chain); chain != Iterator(); ++chain)
    {
        const std::string text = chain->str();
        const bool isOfVariable =
            text.find("->") != std::string::npos || text.find('.') != std::string::npos;
        const bool isCode = isOfVariable || text.find("::") != std::string::npos ||
                            text.back() == '(' || std::regex_match(text, k_Humps);
        Iterator name(text.begin(), text.end(), k_Name);
        name = isCode && isOfVariable ? std::next(name) : name;
        for (; isCode && name != Iterator(); ++name)
        {
            names.push_back(name->str());
        }
    }
    return names;
}

bool isOfTheLanguage(const std::string& name)
{
    return name == "std" || name == "glm" || name == "nullopt" || name == "vector" ||
           name == "shared_ptr" || name == "string" || name == "map" || name == "function";
}

} // namespace

TEST(PortVerdicts, WhatIsRefusedIsNotInTheHeaders)
{
    const HeaderWords headers;
    const int count = ForEachMember(
        headers, PortVerdict::Refused,
        [&](const std::string& key, const std::string& type, const std::string& member,
            const PortEntry& entry)
        {
            EXPECT_NE(entry.words, "") << key << ": nobody knows why";
            if (type == "GraphicsFormat" || type == "RenderTextureFormat" ||
                type == "TextureFormat" || type == "DefaultFormat" || type == "DepthBits")
            {
                return; // an exception says why, see AFormatThatIsRefusedThrows
            }
            const auto known = std::ranges::find(k_Refusals, key, &Refusal::key);
            if (known != std::end(k_Refusals))
            {
                EXPECT_THAT(ReadText(SourcePath(known->header)), testing::HasSubstr(known->text))
                    << key;
                return;
            }
            EXPECT_FALSE(headers.Has(type, member))
                << key << " is 'refused' in porting.txt, and in the headers";
        });
    EXPECT_GT(count, 250);
}

template <typename Format>
std::string ErrorOfFormat(Format format)
{
    try
    {
        if constexpr (std::is_same_v<Format, DefaultFormat>)
        {
            SystemInfo::GetGraphicsFormat(format);
        }
        else if constexpr (std::is_same_v<Format, GraphicsFormat>)
        {
            const RenderTexture texture("T", RenderTextureDescriptor(4, 4, format));
        }
        else if constexpr (std::is_same_v<Format, TextureFormat>)
        {
            const RenderTexture texture(
                "T", RenderTextureDescriptor(4, 4, ToGraphicsFormat(format, false)));
        }
        else
        {
            const RenderTexture texture("T",
                                        RenderTextureDescriptor(4, 4, ToGraphicsFormat(format)));
        }
    }
    catch (const ContractError& error)
    {
        return error.what();
    }
    return "";
}

/// Whether the rows of a type's numbers say "refused" of those that throw and of no other.
template <typename Format>
void ExpectRefusedAreThoseThatThrow(const char* type)
{
    const std::string header = ReadText(SourcePath("core/include/limn/core/GraphicsFormat.h")) +
                               ReadText(SourcePath("core/include/limn/core/SystemInfo.h"));
    const std::size_t begin = header.find("enum class " + std::string(type) + "\n");
    ASSERT_NE(begin, std::string::npos) << type;
    const std::string body = header.substr(begin, header.find("};", begin) - begin);
    static const std::regex k_Member(R"((\w+) = (\d+))");
    int count = 0;
    using Iterator = std::sregex_iterator;
    for (Iterator member(body.begin(), body.end(), k_Member); member != Iterator(); ++member)
    {
        const std::string name = (*member)[1];
        if (name == "None")
        {
            continue;
        }
        ++count;
        const PortEntry* entry = UnityPortingTable().Find(type, name);
        ASSERT_NE(entry, nullptr) << type << "." << name;
        const std::string error = ErrorOfFormat(static_cast<Format>(std::stoi((*member)[2])));
        EXPECT_EQ(entry->verdict == PortVerdict::Refused, error != "")
            << type << "." << name << ": " << error;
    }
    EXPECT_GT(count, 3) << type;
}

TEST(PortVerdicts, AFormatThatIsRefusedThrows)
{
    ExpectRefusedAreThoseThatThrow<GraphicsFormat>("GraphicsFormat");
    ExpectRefusedAreThoseThatThrow<RenderTextureFormat>("RenderTextureFormat");
    ExpectRefusedAreThoseThatThrow<TextureFormat>("TextureFormat");
    ExpectRefusedAreThoseThatThrow<DefaultFormat>("DefaultFormat");
}

// A member that differs is there, or else its row says what is.
TEST(PortVerdicts, WhatDiffersNamesWhatIsInTheHeaders)
{
    const HeaderWords headers;
    static const std::regex k_IsOfCpp("(leave it out|a constructor|a destructor|said when).*");
    const int count = ForEachMember(
        headers, PortVerdict::Differs,
        [&](const std::string& key, const std::string& type, const std::string& member,
            const PortEntry& entry)
        {
            const std::vector<std::string> names = NamesIn(entry.words);
            for (const std::string& name : names)
            {
                EXPECT_TRUE(headers.HasWord(name) || isOfTheLanguage(name))
                    << key << " differs: '" << entry.words << "', but limn has no '" << name << "'";
            }
            const bool isThere = headers.Has(type, member);
            EXPECT_TRUE(isThere || !names.empty() || std::regex_match(entry.words, k_IsOfCpp))
                << key << " differs: '" << entry.words << "' does not say what there is instead";
            if (isThere && entry.words.starts_with("a function"))
            {
                EXPECT_TRUE(headers.HasFunction(type, member)) << key << " is no function";
            }
        });
    EXPECT_GT(count, 200);
}

TEST(PortVerdicts, ReadNamesOutOfWhatARowSays)
{
    using testing::ElementsAre;
    EXPECT_THAT(NamesIn("`a.b` → `x->Member()`, a list"), ElementsAre("Member"));
    EXPECT_THAT(NamesIn("RTHandles::maxWidth(), rt()->descriptor()"),
                ElementsAre("RTHandles", "maxWidth", "rt", "descriptor"));
    EXPECT_THAT(NamesIn("a field of the MeshData that a Mesh is made of"), ElementsAre("MeshData"));
    EXPECT_THAT(NamesIn("leave it out"), ElementsAre());
}

} // namespace limn::test
