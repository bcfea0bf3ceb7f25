#include "explain/Explanation.h"

#include "explain/TextLines.h"

#include <algorithm>
#include <limn/base/TerminalText.h>
#include <map>
#include <set>
#include <sstream>

namespace limn
{

namespace
{

constexpr std::size_t k_ListedLines = 12; ///< of a list in a short text
constexpr std::size_t k_ListedNames = 4;
constexpr std::size_t k_ListedObjects = 4; ///< that are explained one by one without being asked

/// "a, b, c, d, …"
std::string NameSome(const TextLines& names)
{
    return Joined(std::span(names).first(std::min(names.size(), k_ListedNames)), ", ") +
           (names.size() > k_ListedNames ? ", …" : "");
}

/// "13 of 370 drawn; left out: 221 rendering layer mask, 72 render queue", the largest first.
std::string CountsText(const FilterCounts& counts)
{
    int all = 0;
    std::vector<std::pair<int, std::string>> rules;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        all += counts[i];
        if (counts[i] > 0 && static_cast<FilterVerdict>(i) != FilterVerdict::Drawn)
        {
            rules.emplace_back(counts[i], ToString(static_cast<FilterVerdict>(i)));
        }
    }
    std::ranges::stable_sort(rules, [](const auto& a, const auto& b) { return a.first > b.first; });
    const std::string text = std::to_string(counts[0]) + " of " + std::to_string(all) + " drawn";
    return text + (rules.empty() ? "" : "; left out: ") +
           Joined(rules, ", ",
                  [](const auto& rule) { return std::to_string(rule.first) + " " + rule.second; });
}

/// Objects that culling left out, by reason, and those that no pass takes.
TextLines OddObjects(const Explanation& explanation)
{
    std::map<std::string, std::vector<std::string>> names;
    for (const ExplainedObject& object : explanation.objects)
    {
        const bool isDrawn = std::ranges::any_of(object.draws, &ExplainedDraw::isDrawn);
        if (!object.absence.empty() || !isDrawn)
        {
            names[object.absence.empty() ? "every pass leaves it out" : object.absence].push_back(
                object.name);
        }
    }
    TextLines lines;
    for (const auto& [reason, objects] : names)
    {
        lines.push_back(CountText(objects.size(), "object") + " of " +
                        std::to_string(explanation.objects.size()) +
                        (objects.size() == 1 ? " is" : " are") + " not drawn, " + reason + ": " +
                        NameSome(objects));
    }
    return lines;
}

TextLines OddThings(const Explanation& explanation)
{
    TextLines lines;
    for (const std::string& note : explanation.report.notes)
    {
        AddOnce(note, lines);
    }
    const TextLines objects = OddObjects(explanation);
    lines.insert(lines.end(), objects.begin(), objects.end());
    return lines;
}

std::string TriggerText(const ExplainedTrigger& trigger)
{
    std::ostringstream text;
    text << "(" << trigger.position.x << ", " << trigger.position.y << ", " << trigger.position.z
         << "), " << (trigger.isOwn ? "its volumeTrigger" : "its own position") << "; ";
    const LayerMask mask = trigger.volumeLayerMask;
    if (mask == LayerMask::Everything() || mask == LayerMask::Nothing())
    {
        text << (mask == LayerMask::Nothing() ? "no layer" : "every layer");
        return text.str();
    }
    text << "layers";
    for (int layer = 0; layer < 32; ++layer)
    {
        text << (mask.Intersects(LayerMask::FromIndex(layer)) ? " " + std::to_string(layer) : "");
    }
    return text.str();
}

/// "ScreenSpaceOutline.m_OutlineWidth 5.5 ← Placement, Corner"
std::string ValueText(const VolumeParameterTrace& parameter)
{
    return parameter.component + "." + parameter.parameter + " " + parameter.valueText() +
           (parameter.steps.empty() ? "" : " ← ") +
           Joined(parameter.steps, ", ", &VolumeTraceStep::volume);
}

/// "ScreenSpaceOutline.m_OutlineWidth ← Corner (factor 0.375, weight 0.5, distance 2 m) → 5.5"
std::string StepText(const VolumeParameterTrace& parameter, const VolumeTraceStep& step)
{
    std::ostringstream text;
    text << parameter.component << '.' << parameter.parameter << " ← " << step.volume << " (factor "
         << step.factor << ", weight " << step.weight << ", ";
    if (step.distance)
    {
        text << "distance " << *step.distance << " m";
    }
    else
    {
        text << "global";
    }
    text << ") → " << step.valueText;
    return text.str();
}

std::string VolumesText(const Explanation& explanation, bool isLong)
{
    TextLines lines;
    for (const VolumeParameterTrace& parameter : explanation.volumes.parameters)
    {
        if (!isLong)
        {
            lines.push_back(ValueText(parameter));
            continue;
        }
        std::ranges::transform(parameter.steps, std::back_inserter(lines),
                               [&](const auto& step) { return StepText(parameter, step); });
    }
    const TextLines idle = LinesOf(explanation.idleVolumes, [](const ExplainedIdle& volume)
                                   { return OneLine(volume.name) + ": " + volume.why; });
    return Section("the camera takes volumes at", {TriggerText(explanation.trigger)}) +
           Section("volumes that change nothing", idle, isLong ? idle.size() : k_ListedLines) +
           Section("volume values", lines, isLong ? lines.size() : k_ListedLines);
}

/// The counts of a pass's filters: of the feature's own where it told them.
TextLines CountsOf(const RenderReport& report, SampleName pass)
{
    TextLines counts;
    const auto add = [&](const DrawRenderersReport& filter)
    {
        if (filter.pass == pass)
        {
            counts.push_back(CountsText(filter.counts));
        }
    };
    std::ranges::for_each(report.filters, add);
    if (counts.empty())
    {
        std::ranges::for_each(report.draws, add);
    }
    return counts;
}

/// The passes with the counts of their filters, those of equal names with all of them.
TextLines PassLines(const RenderReport& report)
{
    TextLines lines;
    std::set<std::string> counted;
    for (const ExecutedPassReport& pass : report.passes)
    {
        std::string line = std::to_string(static_cast<int>(pass.renderPassEvent));
        line += std::string(line.size() < 4 ? 4 - line.size() : 0, ' ') + " " + pass.name.name();
        const bool isNew = counted.insert(pass.name.name()).second;
        const TextLines counts = isNew ? CountsOf(report, pass.name) : TextLines();
        for (const std::string& count : counts)
        {
            lines.push_back(line + ": " + count);
        }
        if (counts.empty())
        {
            lines.push_back(line);
        }
    }
    return lines;
}

std::string VariantText(const ExplainedVariant& variant)
{
    return variant.shader + ", pass " + std::to_string(variant.passIndex) +
           (variant.passName.empty() ? "" : " '" + variant.passName + "'") +
           (variant.isFullScreen ? ", full screen: " : ": ") +
           (variant.keywords.empty() ? "no keywords" : Joined(variant.keywords, " "));
}

/// "Cube: it is not drawn; inactive", or its name with a line for each pass and material.
std::string OneObject(const ExplainedObject& object, const std::string& indent)
{
    std::string text = indent + OneLine(object.name) +
                       (object.absence.empty() ? "" : ": it is not drawn; ") +
                       OneLine(object.absence) + "\n";
    for (const ExplainedDraw& draw : object.draws)
    {
        const bool isTaken = draw.verdict == FilterVerdict::Drawn;
        text += indent + "  " + OneLine(draw.pass + ", " + draw.material) + ": " +
                (draw.isDrawn() ? "drawn"
                 : isTaken      ? "taken, but " + OneLine(draw.obstacle)
                                : "left out, " + std::string(ToString(draw.verdict))) +
                "\n";
    }
    return text;
}

/// The features that draw nothing, but for those of which the objects' own lines tell it.
TextLines IdleFeatures(const Explanation& explanation)
{
    std::set<std::string> told;
    for (const ExplainedObject& object : explanation.objects)
    {
        for (const ExplainedDraw& draw : object.draws)
        {
            told.insert(draw.pass);
        }
    }
    TextLines lines;
    for (const ExplainedIdle& feature : explanation.idleFeatures)
    {
        if (!told.contains(feature.name))
        {
            lines.push_back(feature.name + ": " +
                            (feature.why.empty() ? "it adds no pass" : feature.why));
        }
    }
    return lines;
}

std::string Objects(const std::vector<ExplainedObject>& objects, const std::string& indent)
{
    return Joined(objects, "",
                  [&indent](const ExplainedObject& object) { return OneObject(object, indent); });
}

/// "1 Opaque + Sky, 640x360: 298 → 172 draws; _Color (clear, store); samples _Mask; 2 barriers", or
/// "2 Blur: 1 dispatch; _Result (load, store); samples _Mask; 2 barriers"
std::string RunText(const ExplainedFrame& frame, const ExplainedPass& pass)
{
    const auto number = &pass - frame.passes.data() + 1;
    const std::string size = ", " + std::to_string(pass.width) + "x" + std::to_string(pass.height);
    std::string text = std::to_string(number) + " " + pass.name +
                       (pass.dispatches > 0 ? "" : size) + ": " + DrawsText(pass);
    for (const ExplainedAttachment& target : pass.targets)
    {
        text += (&target == &pass.targets.front() ? "; " : ", ") +
                frame.textures[target.texture].name + " (" + target.load + ", " + target.store +
                ")";
    }
    std::string sampled;
    for (const std::size_t texture : pass.reads)
    {
        sampled += frame.textures[texture].isDrawn
                       ? (sampled.empty() ? "; samples " : ", ") + frame.textures[texture].name
                       : "";
    }
    const std::size_t barriers =
        pass.barriers.size() + static_cast<std::size_t>(pass.bufferBarriers);
    return text + sampled + "; " + CountText(barriers, "barrier");
}

/// ", shares memory with _Depth and _Mask", or nothing.
std::string SharedText(const ExplainedTexture& texture)
{
    return texture.sharedWith.empty()
               ? ""
               : ", shares memory with " + Joined(texture.sharedWith, " and ");
}

/// "_Color 640x360 R8G8B8A8_SRGB, 900.0 KiB, pass 1 to 3"
/// @param isLong  those that come from files, too
TextLines TextureLines(const ExplainedFrame& frame, bool isLong)
{
    TextLines lines;
    for (const ExplainedTexture& texture : frame.textures)
    {
        if (isLong || texture.isDrawn)
        {
            lines.push_back(
                texture.name + " " + texture.size + " " + texture.format +
                (texture.samples > 1 ? " of " + std::to_string(texture.samples) + " samples" : "") +
                ", " + BytesText(texture.bytes) + ", pass " + std::to_string(texture.first) +
                (texture.last > texture.first ? " to " + std::to_string(texture.last) : "") +
                (texture.isOutput ? " and after" : "") + SharedText(texture));
        }
    }
    return lines;
}

std::string TexturesText(const ExplainedFrame& frame)
{
    std::uint64_t bytes = 0;
    for (const ExplainedTexture& texture : frame.textures)
    {
        bytes += texture.bytes;
    }
    return CountText(frame.textures.size(), "texture") + " of " + BytesText(bytes);
}

std::string LeftOutText(const LeftOut& item)
{
    return (item.pass.empty() ? "" : item.pass + ": ") + item.reason;
}

/// The parts that both texts have.
std::string FrameText(const Explanation& explanation, bool isLong)
{
    const std::size_t most = isLong ? static_cast<std::size_t>(-1) : k_ListedLines;
    const auto run = [&explanation](const ExplainedPass& pass)
    {
        return RunText(explanation.frame, pass);
    };
    return Section("odd", OddThings(explanation), most) + VolumesText(explanation, isLong) +
           Section("chosen", {explanation.report.choices.begin(), explanation.report.choices.end()},
                   most) +
           Section("passes", PassLines(explanation.report), most) +
           Section("the device runs", LinesOf(explanation.frame.passes, run), most) +
           Section("left out", LinesOf(explanation.frame.leftOut, LeftOutText), most) +
           Section(isLong ? "textures" : "textures drawn into",
                   TextureLines(explanation.frame, isLong), most);
}

} // namespace

std::string ShortText(const Explanation& explanation)
{
    return FrameText(explanation, false) + CountText(explanation.objects.size(), "object") + ", " +
           TexturesText(explanation.frame) + ", " +
           CountText(explanation.variants.size(), "shader variant") + " of " +
           std::to_string(explanation.builtVariants) +
           " built: -v lists them, --object NAME and --pixel X,Y explain one\n";
}

std::string LongText(const Explanation& explanation)
{
    const std::string objects = Objects(explanation.objects, "  ");
    return FrameText(explanation, true) +
           Section("variants", LinesOf(explanation.variants, VariantText)) +
           (objects.empty() ? "" : "objects:\n" + objects);
}

std::string ObjectText(const Explanation& explanation, const std::string& name, bool isLong)
{
    const std::vector<ExplainedObject>& objects = explanation.objects;
    const std::string idle = Section("features that draw nothing", IdleFeatures(explanation));
    if (objects.size() <= k_ListedObjects)
    {
        return Objects(objects, "") + idle;
    }
    std::vector<std::string> passes;
    std::map<std::string, FilterCounts> counts;
    for (const ExplainedObject& object : objects)
    {
        for (const ExplainedDraw& draw : object.draws)
        {
            AddOnce(draw.pass, passes);
            ++counts[draw.pass][static_cast<std::size_t>(draw.verdict)];
        }
    }
    TextLines lines = OddObjects(explanation);
    for (const std::string& pass : passes)
    {
        lines.push_back(pass + ": " + CountsText(counts[pass]));
    }
    return Section(OneLine(name) + ", " + CountText(objects.size(), "object"), lines) + idle +
           (isLong ? Objects(objects, "  ") : "-v lists the objects\n");
}

} // namespace limn
