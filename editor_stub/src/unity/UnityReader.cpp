#include "unity/UnityReader.h"

#include <cmath>
#include <limn/base/ParseWhole.h>
#include <optional>

namespace limn
{

namespace
{

/// Takes "name" or "Array.data[3]" off the front of a path.
std::string_view TakeStep(std::string_view& path)
{
    const std::size_t end = path.find('.');
    const std::string_view step = path.substr(0, end);
    path.remove_prefix(end == std::string_view::npos ? path.size() : end + 1);
    return step;
}

/// The number in "data[3]".
std::optional<std::size_t> ElementIn(std::string_view step)
{
    if (!step.starts_with("data[") || !step.ends_with(']'))
    {
        return std::nullopt;
    }
    return ParseWhole<std::size_t>(step.substr(5, step.size() - 6));
}

} // namespace

void UnityNotes::Add(const std::string& file, int line, const std::string& message)
{
    if (m_Known.emplace(file, message).second)
    {
        m_Notes.push_back({Severity::Note, file, {line, line > 0 ? 1 : 0}, message});
    }
}

void UnityNotes::Add(std::span<const Diagnostic> notes)
{
    for (const Diagnostic& note : notes)
    {
        Add(note.file, note.location.line, note.message);
    }
}

std::vector<Diagnostic> UnityNotes::Finish(const std::string& file)
{
    for (const auto& [kind, count] : m_Counts)
    {
        Add(file, 0, kind + ": " + std::to_string(count) + " left out; limn does not draw them");
    }
    m_Counts.clear();
    return std::move(m_Notes);
}

UnityNode UnityReader::Find(const std::string& path) const
{
    UnityNode node = m_Object.fields;
    std::string_view rest = path;
    while (node && !rest.empty())
    {
        const std::string_view step = TakeStep(rest);
        if (step == "Array" && node.isList())
        {
            continue;
        }
        const auto element = ElementIn(step);
        node = element ? node.At(*element) : node[step];
    }
    return node;
}

const UnityOverride* UnityReader::FindOverride(std::string_view path) const
{
    for (auto at = m_Object.overrides.rbegin(); at != m_Object.overrides.rend(); ++at)
    {
        if (at->path == path)
        {
            return &*at;
        }
    }
    return nullptr;
}

std::optional<std::string_view> UnityReader::Text(const std::string& path) const
{
    if (const UnityOverride* override = FindOverride(path))
    {
        return override->value;
    }
    const UnityNode node = Find(path);
    return node ? std::optional(node.text()) : std::nullopt;
}

void UnityReader::Note(const std::string& path, const std::string& message) const
{
    const UnityOverride* override = FindOverride(path);
    const UnityNode node = Find(path);
    const UnityScope& scope = override != nullptr ? *override->scope : *m_Object.scope;
    const int line = override != nullptr ? override->line : node ? node.line() : m_Object.line;
    m_Notes.Add(scope.file->name(), line, m_Subject + "." + path + ": " + message);
}

void UnityReader::Read(const std::string& path, float& value) const
{
    if (const auto text = Text(path))
    {
        const auto number = ParseWhole<float>(*text);
        if (number && std::isfinite(*number))
        {
            value = *number;
            return;
        }
        Note(path, "'" + std::string(*text) + "' is no number, so it is left as it was");
    }
}

void UnityReader::ReadIn(const std::string& path, float least, float most, float& value) const
{
    float number = value;
    Read(path, number);
    if (number >= least && number <= most)
    {
        value = number;
        return;
    }
    const auto text = [](float bound)
    {
        char digits[40];
        const auto [end, error] = std::to_chars(digits, digits + sizeof(digits), bound);
        return std::string(digits, end);
    };
    Note(path, text(number) + " is not from " + text(least) + " to " + text(most) +
                   ", so it is left at " + text(value));
}

void UnityReader::Read(const std::string& path, int& value) const
{
    if (const auto text = Text(path))
    {
        if (const auto number = ParseWhole<std::int64_t>(*text))
        {
            value = static_cast<int>(*number); // masks of 32 bits are unsigned
            return;
        }
        Note(path, "'" + std::string(*text) + "' is no whole number, so it is left as it was");
    }
}

void UnityReader::Read(const std::string& path, bool& value) const
{
    int number = value ? 1 : 0;
    Read(path, number);
    value = number != 0;
}

void UnityReader::Read(const std::string& path, std::string& value) const
{
    if (const auto text = Text(path))
    {
        value = *text;
    }
}

void UnityReader::ReadParts(const std::string& path, const char* names, float* values) const
{
    for (; *names != '\0'; ++names, ++values)
    {
        Read(path + "." + *names, *values);
    }
}

void UnityReader::Read(const std::string& path, glm::vec3& value) const
{
    ReadParts(path, "xyz", &value.x);
}

void UnityReader::Read(const std::string& path, glm::quat& value) const
{
    float parts[] = {value.x, value.y, value.z, value.w};
    ReadParts(path, "xyzw", parts);
    const glm::quat read(parts[3], parts[0], parts[1], parts[2]);
    const float length = glm::length(read);
    if (length > 0.0f)
    {
        value = read / length;
    }
}

void UnityReader::Read(const std::string& path, Color& value) const
{
    ReadParts(path, "rgba", &value.r);
}

void UnityReader::Read(const std::string& path, LayerMask& value) const
{
    int bits = static_cast<int>(value.bits);
    Read(path + ".m_Bits", bits);
    value = LayerMask(static_cast<std::uint32_t>(bits));
}

void UnityReader::Read(const std::string& path, RenderingLayerMask& value) const
{
    int bits = static_cast<int>(value.bits);
    Read(path, bits);
    value = RenderingLayerMask{static_cast<std::uint32_t>(bits)};
}

UnityTarget UnityReader::Reference(const std::string& path) const
{
    const UnityOverride* override = FindOverride(path);
    const UnityReference reference =
        override != nullptr ? override->reference : ReadUnityReference(Find(path));
    if (reference.isNull())
    {
        return {};
    }
    if (!reference.guid.empty())
    {
        return {nullptr, reference};
    }
    const UnityScope& scope = override != nullptr ? *override->scope : *m_Object.scope;
    const UnityInstance* object = scope.Find(reference.fileID);
    return {object != nullptr && !object->isRemoved ? object : nullptr, {}};
}

std::size_t UnityReader::Count(const std::string& path) const
{
    std::size_t count = 0;
    for ([[maybe_unused]] const UnityNode item : Find(path))
    {
        ++count;
    }
    if (const UnityOverride* size = FindOverride(path + ".Array.size"))
    {
        constexpr std::size_t k_Most = 100'000;
        count = std::min(ParseWhole<std::size_t>(size->value).value_or(count), k_Most);
    }
    return count;
}

} // namespace limn
