#include "explain/pixel/PixelHistory.h"

#include "explain/TextLines.h"
#include "explain/pixel/PassProbe.h"

#include <algorithm>
#include <cstdio>
#include <map>

namespace limn
{

namespace
{

constexpr std::size_t k_NamedObjects = 4; ///< of one draw
constexpr std::size_t k_ShownLines = 12;

std::string ColorText(const std::array<int, 3>& color)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(color[0]),
                  static_cast<unsigned>(color[1]), static_cast<unsigned>(color[2]));
    return text.data();
}

std::string NamesText(const TextLines& names, std::size_t most)
{
    const std::size_t named = std::min(names.size(), most);
    return Joined(std::span(names).first(named), ", ") +
           (names.size() > named ? " and " + std::to_string(names.size() - named) + " more" : "");
}

bool IsRejected(const PixelEvent& event)
{
    return event.fate >= PixelFate::Scissor; // the first behind those that change something
}

/// "Piece", "the mesh 'Quad'" or "the full screen"
std::string SubjectText(const PixelEvent& event)
{
    return !event.objects.empty() ? NamesText(event.objects, k_NamedObjects)
           : !event.mesh.empty()  ? "the mesh '" + event.mesh + "'"
                                  : "without a mesh";
}

/// "Draw Opaque Objects draws Piece: material black, Universal Render Pipeline/Unlit 'Unlit'"
std::string HeadText(const PixelEvent& event, std::size_t number)
{
    const std::string pass =
        std::to_string(number) + " " + (event.pass.empty() ? "A pass without a name" : event.pass);
    if (event.fate == PixelFate::Cleared)
    {
        return pass + " clears";
    }
    const std::string shader =
        event.shader + (event.shaderPassName.empty() ? ", pass " + std::to_string(event.shaderPass)
                                                     : " '" + event.shaderPassName + "'");
    const bool isKernel = event.objects.empty() && event.mesh.empty() && !event.depth &&
                          event.fate == PixelFate::Dispatched;
    return pass + (isKernel ? " runs a kernel" : " draws " + SubjectText(event)) + ": " +
           (event.material.empty() ? "" : "material " + event.material + ", ") + shader;
}

/// Tells the texel of a texture that is not of the picture's size.
std::string ValueLine(const std::string& name, const PixelValue& value, const PixelHistory& history)
{
    const bool isOfPicture = value.width == history.width && value.height == history.height;
    const std::string place =
        isOfPicture ? ""
                    : " at " + std::to_string(value.x) + "," + std::to_string(value.y) + " of " +
                          std::to_string(value.width) + "x" + std::to_string(value.height);
    return "  " + name + place + " " +
           (value.before.empty() ? "" : NumbersText(value.before) + " → ") +
           NumbersText(value.after);
}

void AddEvent(const PixelHistory& history, std::size_t index, TextLines& lines)
{
    const PixelEvent& event = history.events[index];
    lines.push_back(HeadText(event, index + 1));
    if (!event.reason.empty())
    {
        lines.push_back("  " + event.reason);
    }
    const auto add = [&](const std::string& name, const PixelValue& value)
    {
        if (event.fate == PixelFate::Cleared || value.isChanged())
        {
            lines.push_back(ValueLine(name, value, history));
        }
    };
    for (const PixelValue& color : event.colors)
    {
        add(color.texture, color);
    }
    if (event.depth)
    {
        add("depth", *event.depth);
    }
    if (event.stencil)
    {
        add("stencil", *event.stencil);
    }
    if (!event.isRun && event.fate == PixelFate::Drawn)
    {
        lines.push_back("  the device does not run this draw, because the picture is the same "
                        "without it");
    }
}

TextLines EventLines(const PixelHistory& history, bool areRejected)
{
    TextLines lines;
    for (std::size_t i = 0; i < history.events.size(); ++i)
    {
        if (IsRejected(history.events[i]) == areRejected)
        {
            AddEvent(history, i, lines);
        }
    }
    return lines;
}

/// Lists what filters leave out, by pass and rule.
TextLines FilterLines(const PixelHistory& history, bool isLong)
{
    std::vector<std::pair<std::string, FilterVerdict>> order;
    std::map<std::pair<std::string, FilterVerdict>, TextLines> names;
    for (const PixelFiltered& filtered : history.filtered)
    {
        TextLines& those = names[{filtered.pass, filtered.verdict}];
        if (those.empty())
        {
            order.emplace_back(filtered.pass, filtered.verdict);
        }
        AddOnce(filtered.object, those);
    }
    TextLines lines;
    for (const auto& [pass, verdict] : order)
    {
        const TextLines& all = names[{pass, verdict}];
        lines.push_back(pass + " leaves out " +
                        NamesText(all, isLong ? all.size() : k_NamedObjects) + ": " +
                        ToString(verdict));
    }
    return lines;
}

TextLines AbsentLines(const PixelHistory& history, bool areHere)
{
    TextLines lines;
    for (const PixelAbsent& absent : history.absent)
    {
        if (absent.isHere == areHere)
        {
            lines.push_back(absent.object + ": " + absent.reason);
        }
    }
    return lines;
}

std::string IsOrAre(std::size_t count)
{
    return count == 1 ? " is" : " are";
}

/// "33 objects do not cover the pixel, nor do 4 draws of Strokes; ...: -v names them"
std::string RestSentence(const PixelHistory& history)
{
    const std::size_t objects = history.uncovered.size();
    std::string text =
        CountText(objects, "object") + (objects == 1 ? " does" : " do") + " not cover the pixel";
    for (const PixelUncovered& draws : history.uncoveredDraws)
    {
        const auto count = static_cast<std::size_t>(draws.count);
        text += (count == 1 ? ", nor does " : ", nor do ") + CountText(count, "draw") + " of " +
                draws.pass;
    }
    const auto absent =
        static_cast<std::size_t>(std::ranges::count(history.absent, false, &PixelAbsent::isHere));
    text +=
        absent > 0 ? "; " + CountText(absent, "object") + IsOrAre(absent) + " drawn nowhere" : "";
    const std::size_t elsewhere = history.elsewhere.size();
    text += elsewhere > 0 ? "; " + CountText(elsewhere, "target") + IsOrAre(elsewhere) +
                                " of another layout than the picture"
                          : "";
    return OneLine(text + ": -v names them") + "\n";
}

/// Names what has nothing to do with the pixel.
std::string RestText(const PixelHistory& history)
{
    const TextLines elsewhere =
        LinesOf(history.elsewhere, [](const PixelElsewhere& pass)
                { return pass.pass + ": " + pass.texture + " " + pass.size; });
    TextLines uncovered = history.uncovered;
    for (const PixelUncovered& draws : history.uncoveredDraws)
    {
        uncovered.push_back(
            CountText(static_cast<std::size_t>(draws.count), "draw") + " of " + draws.pass + ": " +
            draws.shader + (draws.shaderPassName.empty() ? "" : " '" + draws.shaderPassName + "'"));
    }
    return Section("drawn, but not over the pixel", uncovered) +
           Section("drawn nowhere, and not at the pixel", AbsentLines(history, false)) +
           Section("targets that are of another layout than the picture", elsewhere);
}

Json PixelValueJson(const PixelValue& value)
{
    return {{"texture", value.texture},
            {"x", value.x},
            {"y", value.y},
            {"width", value.width},
            {"height", value.height},
            {"before", value.before.empty() ? Json() : Json(value.before)},
            {"after", value.after}};
}

Json OptionalJson(const std::optional<PixelValue>& value)
{
    return value ? PixelValueJson(*value) : Json();
}

Json PixelEventJson(const PixelEvent& event)
{
    return {{"fate", ToString(event.fate)},
            {"reason", TextOrNull(event.reason)},
            {"pass", event.pass},
            {"objects", event.objects},
            {"mesh", TextOrNull(event.mesh)},
            {"material", TextOrNull(event.material)},
            {"shader", TextOrNull(event.shader)},
            {"shaderPass", event.shaderPass},
            {"shaderPassName", TextOrNull(event.shaderPassName)},
            {"run", event.isRun},
            {"colors", JsonList(event.colors, PixelValueJson)},
            {"depth", OptionalJson(event.depth)},
            {"stencil", OptionalJson(event.stencil)}};
}

} // namespace

std::string PixelText(const PixelHistory& history, bool isLong)
{
    const std::string head = "pixel " + std::to_string(history.x) + "," +
                             std::to_string(history.y) + " of " + std::to_string(history.width) +
                             "x" + std::to_string(history.height) + " is " +
                             ColorText(history.written) + ", linear " + NumbersText(history.color);
    const bool hasObject =
        std::ranges::any_of(history.events, [](const PixelEvent& event)
                            { return event.fate == PixelFate::Drawn && !event.objects.empty(); });
    const std::size_t most = isLong ? static_cast<std::size_t>(-1) : k_ShownLines;
    TextLines notes;
    for (const std::string& note : history.notes)
    {
        AddOnce(note, notes);
    }
    return OneLine(head) + "\n" + (hasObject ? "" : "no object is drawn there\n") +
           Section("done there, in this order", EventLines(history, false)) +
           Section("rejected there", EventLines(history, true)) +
           Section("left out there by a filter", FilterLines(history, isLong), most) +
           Section("would be there, but no pass draws it", AbsentLines(history, true)) +
           Section("odd", notes, most) + (isLong ? RestText(history) : RestSentence(history));
}

Json PixelJson(const PixelHistory& history)
{
    const auto filtered = [](const PixelFiltered& one) -> Json
    {
        return {{"object", one.object}, {"pass", one.pass}, {"rule", ToString(one.verdict)}};
    };
    const auto absent = [](const PixelAbsent& one) -> Json
    {
        return {{"object", one.object}, {"reason", one.reason}, {"here", one.isHere}};
    };
    const auto uncovered = [](const PixelUncovered& one) -> Json
    {
        return {{"pass", one.pass},
                {"shader", one.shader},
                {"shaderPassName", TextOrNull(one.shaderPassName)},
                {"count", one.count}};
    };
    const auto elsewhere = [](const PixelElsewhere& one) -> Json
    {
        return {{"pass", one.pass}, {"texture", one.texture}, {"size", one.size}};
    };
    return {{"x", history.x},
            {"y", history.y},
            {"width", history.width},
            {"height", history.height},
            {"color", history.color},
            {"written", ColorText(history.written)},
            {"events", JsonList(history.events, PixelEventJson)},
            {"filtered", JsonList(history.filtered, filtered)},
            {"absent", JsonList(history.absent, absent)},
            {"uncovered", history.uncovered},
            {"uncoveredDraws", JsonList(history.uncoveredDraws, uncovered)},
            {"elsewhere", JsonList(history.elsewhere, elsewhere)},
            {"notes", history.notes}};
}

} // namespace limn
