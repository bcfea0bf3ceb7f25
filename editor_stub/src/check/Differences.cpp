#include "check/Differences.h"

#include "check/Expectations.h"
#include "console/Texts.h"

#include <charconv>
#include <cmath>
#include <limn/base/Diagnostic.h>
#include <limn/base/Text.h>

namespace limn
{

namespace
{

/// Adds a line for each group of renderers that are missing for the same reason.
void AddMissing(const ObjectNames& objects, const RendererSet& missing, const RendererSet& asked,
                const DrawnFacts& facts, std::vector<std::string>& lines)
{
    std::vector<std::string> reasons;
    for (std::size_t i = 0; i < missing.size(); ++i)
    {
        if (missing[i])
        {
            AddOnce(facts.reasons[i], reasons);
        }
    }
    for (const std::string& reason : reasons)
    {
        RendererSet members(missing.size());
        RendererSet others(missing.size());
        for (std::size_t i = 0; i < missing.size(); ++i)
        {
            members[i] = missing[i] && facts.reasons[i] == reason;
            others[i] = !missing[i] && (asked[i] || facts.drawn[i]);
        }
        for (const std::string& name : objects.Describe(members, others))
        {
            lines.push_back("- " + name + "  expected, but left out: " + reason);
        }
    }
}

/// Returns how many names both lists have in one order, from each pair of places on.
std::vector<std::vector<std::size_t>> CommonLengths(const std::vector<std::string>& a,
                                                    const std::vector<std::string>& b)
{
    std::vector<std::vector<std::size_t>> length(a.size() + 1,
                                                 std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = a.size(); i-- > 0;)
    {
        for (std::size_t j = b.size(); j-- > 0;)
        {
            length[i][j] = a[i] == b[j] ? length[i + 1][j + 1] + 1
                                        : std::max(length[i + 1][j], length[i][j + 1]);
        }
    }
    return length;
}

bool IsAbout(const std::string& item, const LeftOut& one)
{
    return !item.empty() &&
           (item == one.pass || item == one.reason || item == one.pass + ": " + one.reason);
}

} // namespace

NameDifference CompareRenderers(const ObjectNames& objects, const std::vector<std::string>& items,
                                const DrawnFacts& facts, ListKind kind)
{
    NameDifference result;
    const RendererSet asked = objects.Evaluate(items);
    const bool isExact = kind == ListKind::Exact;
    const bool isNone = kind == ListKind::None;
    RendererSet missing(asked.size());
    RendererSet extra(asked.size());
    RendererSet wanted(asked.size());
    RendererSet others(asked.size()); // which are no part of what is extra
    for (std::size_t i = 0; i < asked.size(); ++i)
    {
        const bool isDrawn = facts.drawn[i];
        missing[i] = !isNone && asked[i] && !isDrawn;
        extra[i] = isDrawn && ((isExact && !asked[i]) || (isNone && asked[i]));
        wanted[i] = isExact ? isDrawn : asked[i] && isDrawn != isNone;
        others[i] = !extra[i] && (isNone ? isDrawn : asked[i]);
    }
    for (const std::string& item : items)
    {
        if (objects.Find(item).empty())
        {
            result.lines.push_back("- " + item + "  no object has this name");
        }
    }
    AddMissing(objects, missing, asked, facts, result.lines);
    for (const std::string& name : objects.Describe(extra, others))
    {
        result.lines.push_back("+ " + name + "  drawn, but not expected");
    }
    result.truth = result.lines.empty() ? items : objects.Fix(items, wanted);
    return result;
}

NameDifference CompareNames(const std::vector<std::string>& items,
                            const std::vector<std::string>& actual, const NameWords& words)
{
    NameDifference result;
    const auto common = CommonLengths(items, actual);
    for (std::size_t i = 0, j = 0; i < items.size() || j < actual.size();)
    {
        if (i < items.size() && j < actual.size() && items[i] == actual[j])
        {
            result.truth.push_back(items[i]);
            ++i;
            ++j;
        }
        else if (j == actual.size() || (i < items.size() && common[i + 1][j] >= common[i][j + 1]))
        {
            const std::string hint = std::ranges::count(actual, items[i]) > 0
                                         ? ""
                                         : DidYouMean(items[i], {actual.begin(), actual.end()});
            result.lines.push_back("- " + items[i++] + "  " + words.missing + hint);
        }
        else
        {
            if (words.kind == ListKind::Exact)
            {
                result.lines.push_back("+ " + actual[j] + "  " + words.extra);
            }
            ++j;
        }
    }
    result.truth = words.kind == ListKind::Exact ? actual : result.truth;
    return result;
}

NameDifference CompareLeftOut(const std::vector<std::string>& items,
                              const std::vector<LeftOut>& actual, ListKind kind)
{
    NameDifference result;
    std::vector<std::string> passes;
    for (const LeftOut& one : actual)
    {
        AddOnce(one.pass, passes);
    }
    for (const std::string& item : items)
    {
        const auto found =
            std::ranges::find_if(actual, [&](const LeftOut& one) { return IsAbout(item, one); });
        const bool isFound = found != actual.end();
        if (isFound == (kind == ListKind::None))
        {
            result.lines.push_back(
                isFound ? "+ " + item + "  left out, but not expected: " + found->reason
                        : "- " + item + "  expected to be left out, but it is not" +
                              DidYouMean(item, {passes.begin(), passes.end()}));
        }
        else
        {
            result.truth.push_back(item);
        }
    }
    std::vector<std::string> named; // several things of one pass are one item
    for (const LeftOut& one : actual)
    {
        const bool isExpected =
            std::ranges::any_of(items, [&](const std::string& item) { return IsAbout(item, one); });
        if (kind == ListKind::Exact && !isExpected)
        {
            result.lines.push_back("+ " + one.pass + (one.pass.empty() ? "" : ": ") + one.reason +
                                   "  left out, but not expected");
            AddOnce(one.pass.empty() ? one.reason : one.pass, named);
        }
    }
    result.truth.insert(result.truth.end(), named.begin(), named.end());
    return result;
}

bool IsSameValue(std::string_view a, std::string_view b, std::optional<double> tolerance)
{
    const auto takeNumber = [](std::string_view& text)
    {
        double number = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool isNumber =
            !text.empty() && (isDigit(text[0]) || text[0] == '-' || text[0] == '.');
        if (!isNumber || error != std::errc())
        {
            return std::optional<double>();
        }
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        return std::optional(number);
    };
    bool isInWord = false;
    while (!a.empty() && !b.empty())
    {
        const auto one = isInWord ? std::nullopt : takeNumber(a);
        const auto other = isInWord ? std::nullopt : takeNumber(b);
        if (one && other)
        {
            const double most =
                tolerance.value_or(1e-6 * std::max(std::abs(*one), std::abs(*other)));
            if (!(std::abs(*one - *other) <= most))
            {
                return false;
            }
            continue;
        }
        if (one || other || a.front() != b.front())
        {
            return false;
        }
        isInWord = isLetter(a.front()) || isDigit(a.front());
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    return a.empty() && b.empty();
}

} // namespace limn
