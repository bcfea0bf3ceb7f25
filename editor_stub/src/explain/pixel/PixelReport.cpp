#include "explain/pixel/PixelHistory.h"

#include "console/Json.h"
#include "console/Texts.h"
#include "explain/pixel/PassProbe.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

namespace limn
{

namespace
{

constexpr std::size_t k_NamedObjects = 4; ///< of one draw
constexpr std::size_t k_ShownLines = 12;

std::string TextLine(const std::string& words, std::size_t begin)
{
    return std::string(begin, ' ') + OneLine(words) + "\n";
}

std::string ColorText(const std::array<int, 3>& color)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(color[0]),
                  static_cast<unsigned>(color[1]), static_cast<unsigned>(color[2]));
    return text.data();
}

std::string NamesText(const std::vector<std::string>& names, std::size_t most)
{
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more"
                               : text;
}

std::string MoreText(std::size_t count)
{
    return count > 0 ? "  … and " + std::to_string(count) + " more; -v lists them\n" : "";
}

bool IsRejected(const PixelEvent& event)
{
    return event.fate != PixelFate::Cleared && event.fate != PixelFate::Drawn &&
           event.fate != PixelFate::Dispatched;
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
    return TextLine(name + place + " " +
                        (value.before.empty() ? "" : NumbersText(value.before) + " → ") +
                        NumbersText(value.after),
                    4);
}

std::string EventText(const PixelHistory& history, std::size_t index)
{
    const PixelEvent& event = history.events[index];

    std::string text = TextLine(HeadText(event, index + 1), 2);
    text += event.reason.empty() ? "" : TextLine(event.reason, 4);
    const auto add = [&](const std::string& name, const PixelValue& value)
    {
        const bool isShown = event.fate == PixelFate::Cleared || value.isChanged();
        text += isShown ? ValueLine(name, value, history) : "";
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
    const bool isLeftOut = !event.isRun && event.fate == PixelFate::Drawn;
    return text + (isLeftOut ? TextLine("the device does not run this draw, because the picture is "
                                        "the same without it",
                                        4)
                             : "");
}

std::string EventsText(const PixelHistory& history, bool areRejected)
{
    std::string text;
    for (std::size_t i = 0; i < history.events.size(); ++i)
    {
        const PixelEvent& event = history.events[i];
        text += IsRejected(event) == areRejected ? EventText(history, i) : "";
    }
    return text;
}

/// Lists what filters leave out, by pass and rule.
std::string FiltersText(const PixelHistory& history, bool isLong)
{
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, std::vector<std::string>> names;
    for (const PixelFiltered& filtered : history.filtered)
    {
        const std::pair key(filtered.pass, std::string(ToString(filtered.verdict)));
        if (names[key].empty())
        {
            order.push_back(key);
        }
        if (std::ranges::find(names[key], filtered.object) == names[key].end())
        {
            names[key].push_back(filtered.object);
        }
    }
    std::string text;
    const std::size_t shown = isLong ? order.size() : std::min(order.size(), k_ShownLines);
    for (std::size_t i = 0; i < shown; ++i)
    {
        const std::vector<std::string>& all = names[order[i]];
        text += TextLine(order[i].first + " leaves out " +
                             NamesText(all, isLong ? all.size() : k_NamedObjects) + ": " +
                             order[i].second,
                         2);
    }
    return text + MoreText(order.size() - shown);
}

std::string AbsentText(const PixelHistory& history, bool areHere)
{
    std::string text;
    for (const PixelAbsent& absent : history.absent)
    {
        text += absent.isHere == areHere ? TextLine(absent.object + ": " + absent.reason, 2) : "";
    }
    return text;
}

std::string SectionText(const std::string& title, const std::string& lines)
{
    return lines.empty() ? "" : title + ":\n" + lines;
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
        Count(objects, "object") + (objects == 1 ? " does" : " do") + " not cover the pixel";
    for (const PixelUncovered& draws : history.uncoveredDraws)
    {
        const auto count = static_cast<std::size_t>(draws.count);
        text +=
            (count == 1 ? ", nor does " : ", nor do ") + Count(count, "draw") + " of " + draws.pass;
    }
    const auto absent =
        static_cast<std::size_t>(std::ranges::count(history.absent, false, &PixelAbsent::isHere));
    text += absent > 0 ? "; " + Count(absent, "object") + IsOrAre(absent) + " drawn nowhere" : "";
    const std::size_t elsewhere = history.elsewhere.size();
    text += elsewhere > 0 ? "; " + Count(elsewhere, "target") + IsOrAre(elsewhere) +
                                " of another layout than the picture"
                          : "";
    return TextLine(text + ": -v names them", 0);
}

/// Names what has nothing to do with the pixel.
std::string RestText(const PixelHistory& history)
{
    std::string elsewhere;
    for (const PixelElsewhere& pass : history.elsewhere)
    {
        elsewhere += TextLine(pass.pass + ": " + pass.texture + " " + pass.size, 2);
    }
    std::string uncovered;
    for (const std::string& name : history.uncovered)
    {
        uncovered += TextLine(name, 2);
    }
    for (const PixelUncovered& draws : history.uncoveredDraws)
    {
        uncovered +=
            TextLine(Count(static_cast<std::size_t>(draws.count), "draw") + " of " + draws.pass +
                         ": " + draws.shader +
                         (draws.shaderPassName.empty() ? "" : " '" + draws.shaderPassName + "'"),
                     2);
    }
    return SectionText("drawn, but not over the pixel", uncovered) +
           SectionText("drawn nowhere, and not at the pixel", AbsentText(history, false)) +
           SectionText("targets that are of another layout than the picture", elsewhere);
}

std::string NotesText(const PixelHistory& history, bool isLong)
{
    std::vector<std::string> notes;
    for (const std::string& note : history.notes)
    {
        if (std::ranges::find(notes, note) == notes.end())
        {
            notes.push_back(note);
        }
    }
    std::string text;
    const std::size_t shown = isLong ? notes.size() : std::min(notes.size(), k_ShownLines);
    for (std::size_t i = 0; i < shown; ++i)
    {
        text += TextLine(notes[i], 2);
    }
    return text + MoreText(notes.size() - shown);
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
    return TextLine(head, 0) + (hasObject ? "" : "no object is drawn there\n") +
           SectionText("done there, in this order", EventsText(history, false)) +
           SectionText("rejected there", EventsText(history, true)) +
           SectionText("left out there by a filter", FiltersText(history, isLong)) +
           SectionText("would be there, but no pass draws it", AbsentText(history, true)) +
           SectionText("odd", NotesText(history, isLong)) +
           (isLong ? RestText(history) : RestSentence(history));
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
