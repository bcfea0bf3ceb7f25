#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// What became of a member of Unity's here.
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
    std::string words;  ///< how it differs, why it is refused, what to do instead; "" = no word
    std::string result; ///< the type that a member gives; "T" = its type argument; "" = unsaid
};

/// editor_stub/src/port/porting.txt: rows of samples/porting/DIFFERENCES.md, and each member's
/// verdict.
class PortingTable
{
public:
    /// @param text  must outlive this
    /// @throws ContractError naming the line that is no row, no verdict, or said twice
    explicit PortingTable(std::string_view text);

    const std::vector<std::string>& rows() const { return m_Rows; } ///< "| Unity | limn |"
    const std::map<std::string, PortEntry, std::less<>>& entries() const { return m_Entries; }

    /// @return null where the table does not know it
    const PortEntry* Find(std::string_view key) const;
    /// The same of "Type.Member", else of "Type.*".
    const PortEntry* Find(std::string_view type, std::string_view member) const;
    bool HasType(std::string_view type) const;

private:
    void ReadVerdict(std::string_view line, const std::string& rowWords, int number);
    void Add(const std::string& key, const PortEntry& entry, int number);

    std::vector<std::string> m_Rows;
    std::map<std::string, PortEntry, std::less<>> m_Entries;
};

/// The one of this program.
const PortingTable& UnityPortingTable();

} // namespace limn
