#include <limn/volume/YamlMapReader.h>

#include <array>
#include <charconv>

namespace limn
{

namespace
{

using Channels = std::array<float, 4>;

constexpr std::string_view k_ColorForms =
    "a colour is expected: {r: 1, g: 0.5, b: 0, a: 1}, [1, 0.5, 0] or \"#FF8000\" (in quotes: # "
    "begins a comment)";

/// "tint: found a sequence of 2; a colour is expected"
bool RefuseShape(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                 std::string_view expectation)
{
    std::string found = node.Describe();
    if (node.isSequence())
    {
        found += " of " + std::to_string(node.items().size());
    }
    diagnostics.Error(node.location(),
                      std::string(subject) + ": found " + found + "; " + std::string(expectation));
    return false;
}

bool ReadFromSequence(const YamlNode& node, std::string_view subject, AssetDiagnostics& diagnostics,
                      ValueRange range, Channels& channels)
{
    bool isGood = true;
    for (std::size_t i = 0; i < node.items().size(); ++i)
    {
        const std::string item = std::string(subject) + "[" + std::to_string(i) + "]";
        const std::optional<float> value = ReadFloat(node.items()[i], item, diagnostics, range);
        channels[i] = value.value_or(channels[i]);
        isGood = isGood && value.has_value();
    }
    return isGood;
}

/// Reads the one-letter keys `names`; the first `required` of them must be there.
bool ReadFromMap(const YamlNode& node, std::string_view names, std::size_t required,
                 std::string_view subject, AssetDiagnostics& diagnostics, ValueRange range,
                 Channels& channels)
{
    const std::size_t before = diagnostics.diagnostics().size();
    YamlMapReader map(node, std::string(subject), diagnostics);
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        const std::string_view name = names.substr(i, 1);
        if (i >= required || map.Require(name))
        {
            map.Read(name, channels[i], range);
        }
    }
    map.Finish();
    return diagnostics.diagnostics().size() == before;
}

bool ReadHex(std::string_view text, Channels& channels)
{
    if ((text.size() != 7 && text.size() != 9) || text.front() != '#')
    {
        return false;
    }
    for (std::size_t i = 0; 1 + 2 * i < text.size(); ++i)
    {
        const char* begin = text.data() + 1 + 2 * i;
        unsigned byte = 0;
        const auto [rest, error] = std::from_chars(begin, begin + 2, byte, 16);
        if (error != std::errc{} || rest != begin + 2)
        {
            return false;
        }
        channels[i] = static_cast<float>(byte) / 255.0f;
    }
    return true;
}

} // namespace

std::optional<glm::vec4> ReadVector(const YamlNode& node, int count, std::string_view subject,
                                    AssetDiagnostics& diagnostics, ValueRange range)
{
    Channels channels{};
    const auto size = static_cast<std::size_t>(count);
    bool isGood = false;
    if (node.isMap())
    {
        const std::string_view names = std::string_view("xyzw").substr(0, size);
        isGood = ReadFromMap(node, names, size, subject, diagnostics, range, channels);
    }
    else if (node.isSequence() && node.items().size() == size)
    {
        isGood = ReadFromSequence(node, subject, diagnostics, range, channels);
    }
    else
    {
        RefuseShape(node, subject, diagnostics,
                    std::to_string(count) + " numbers are expected: [" +
                        std::string("1, 2, 3, 4").substr(0, 3 * size - 2) + "]");
    }
    return isGood ? std::optional(glm::vec4(channels[0], channels[1], channels[2], channels[3]))
                  : std::nullopt;
}

/// Returns whether a colour looks as if it was written in numbers from 0 to 255.
static bool AreBytes(const Channels& channels)
{
    float most = 0.0f;
    for (const float channel : {channels[0], channels[1], channels[2]})
    {
        if (channel != std::floor(channel) || channel > 255.0f || channel < 0.0f)
        {
            return false;
        }
        most = std::max(most, channel);
    }
    return most > 32.0f;
}

std::optional<Color> ReadColor(const YamlNode& node, std::string_view subject,
                               AssetDiagnostics& diagnostics, ValueRange range)
{
    Channels channels{0.0f, 0.0f, 0.0f, 1.0f};
    const std::size_t size = node.items().size();
    bool isGood = false;
    if (node.isMap())
    {
        isGood = ReadFromMap(node, "rgba", 3, subject, diagnostics, range, channels);
    }
    else if (size == 3 || size == 4)
    {
        isGood = ReadFromSequence(node, subject, diagnostics, range, channels);
    }
    else
    {
        isGood = ReadHex(node.scalar(), channels) ||
                 RefuseShape(node, subject, diagnostics, k_ColorForms);
    }
    if (isGood && AreBytes(channels))
    {
        diagnostics.Note(node.location(), std::string(subject) +
                                              ": the numbers of a colour go from 0 to 1, and more "
                                              "is light beyond white; if these are from 0 to 255, "
                                              "divide them or write \"#RRGGBB\"");
    }
    return isGood ? std::optional(Color{channels[0], channels[1], channels[2], channels[3]})
                  : std::nullopt;
}

} // namespace limn
