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

private:
    void ReadVerdict(std::string_view line, const std::string& rowWords, int number);
    void Add(const std::string& key, const PortEntry& entry, int number);

    std::vector<std::string> m_Rows;
    std::map<std::string, PortEntry, std::less<>> m_Entries;
};

/// Returns the table that is built into this program.
const PortingTable& UnityPortingTable();

} // namespace limn
