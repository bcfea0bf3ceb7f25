#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The verdict on a member of Unity's in limn.
enum class PortVerdict
{
    Same,
    Differs,
    Refused,
    Missing
};

const char* ToString(PortVerdict verdict);

struct PortEntry
{
    PortVerdict verdict = PortVerdict::Same;
    /// The difference, the reason of a refusal or what to do instead; "" if there is nothing to
    /// say.
    std::string words;
    std::string result; ///< the type of the member's value; "T" = its type argument; "" = not given
    bool isPointer = false; ///< true if its value in C++ points to an object of that type
    /// The member in C++, as PortMember.h describes it; "" if it is not the same line of code.
    std::string cpp;
    std::string cppSet; ///< an assignment to the member, likewise; "" if it is assigned to
};

/// A parameter of a method of Unity's.
struct PortParameter
{
    std::string name;
    std::string otherwise; ///< the C++ of its value where none is given; "" if one must be given
};

/// The table editor_stub/src/port/porting.txt: the rows of samples/porting/DIFFERENCES.md, and the
/// verdict on each member.
class PortingTable
{
public:
    /// @throws ContractError naming the line that is neither row nor verdict, or that repeats an
    ///     entry
    explicit PortingTable(std::string_view text);

    const std::vector<std::string>& rows() const { return m_Rows; } ///< "| Unity | limn |"
    const std::map<std::string, PortEntry, std::less<>>& entries() const { return m_Entries; }

    /// @return null if the table does not know the key
    const PortEntry* Find(std::string_view key) const;
    /// Returns the entry of "Type.Member", else that of "Type.*".
    const PortEntry* Find(std::string_view type, std::string_view member) const;
    bool HasType(std::string_view type) const;
    /// Returns the type that has a member: this one or the nearest of its bases; "" if none has it.
    /// @param isExact  true if an entry for all members of a type does not count
    std::string OwnerOf(std::string_view type, std::string_view member, bool isExact = false) const;

    /// Returns the C++ of "new:T" or of a member with this number of arguments; "" if there is
    /// none.
    std::string CodeFor(const std::string& key, std::size_t arguments) const;

    /// Returns the parameters of a method or of "new:T" in their order, or nothing if the table
    /// does not name them.
    std::vector<PortParameter> ParametersOf(std::string_view key) const;

private:
    void ReadParameters(std::string_view line, int number);
    void ReadVerdict(std::string_view line, const std::string& rowWords, int number);
    void ReadCode(std::string_view line, int number);
    void Add(const std::string& key, const PortEntry& entry, int number);

    std::vector<std::string> m_Rows;
    std::map<std::string, PortEntry, std::less<>> m_Entries;
    std::map<std::string, std::string, std::less<>> m_Codes; ///< of constructors, of calls "KEY/2"
    std::map<std::string, std::vector<PortParameter>, std::less<>> m_Parameters;
};

/// Returns the table that is built into this program.
const PortingTable& UnityPortingTable();

} // namespace limn
