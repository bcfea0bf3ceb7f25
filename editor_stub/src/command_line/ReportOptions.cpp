#include "command_line/ReportOptions.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>

namespace limn
{

namespace
{

/// I and N of "I/N"; nothing if the text is no part.
std::optional<std::pair<int, int>> ParseShard(const std::string& text)
{
    constexpr int k_MostShards = 100000;
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
    {
        return std::nullopt;
    }
    const auto number = [](const std::string& part)
    {
        int value = 0;
        const char* end = part.data() + part.size();
        const auto [rest, error] = std::from_chars(part.data(), end, value);
        return error == std::errc{} && rest == end ? value : 0;
    };
    const int index = number(text.substr(0, slash));
    const int count = number(text.substr(slash + 1));
    const bool isGood = index >= 1 && index <= count && count <= k_MostShards;
    return isGood ? std::optional(std::pair(index, count)) : std::nullopt;
}

std::string CheckShard(const std::string& text)
{
    return ParseShard(text) ? std::string()
                            : "'" + text + "' is no part; I/N is expected, I from 1 to N: 2/8";
}

std::string CheckBudget(const std::string& text)
{
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool isGood = error == std::errc{} && rest == end && value > 0.0 && std::isfinite(value);
    return isGood ? std::string()
                  : "'" + text + "' is no time; milliseconds above 0 are expected: 2.5";
}

} // namespace

void AddReportOptions(CLI::App& verb, ReportCommandOptions& options)
{
    verb.add_option("paths", options.paths,
                    "A scene file, *.scene.yaml; for --merge and --compare folders of reports")
        ->type_name("SCENE|DIR")
        ->required();
    auto* output = verb.add_option("-o,--output", options.output,
                                   "The folder for the report; what an interrupted run left there "
                                   "is taken over")
                       ->type_name("DIR")
                       ->required();
    auto* quick = verb.add_flag("--quick", options.isQuick,
                                "Fewer widths, shapes and sizes: within a minute");
    auto* stability =
        verb.add_flag("--stability", options.hasStability,
                      "Put the techniques through extreme inputs, every two together, under the "
                      "Vulkan validation layer, in place of all else");
    verb.add_flag("--all-combinations", options.isFull, "Of extreme inputs; takes days")
        ->needs(stability)
        ->excludes(quick);
    verb.add_option("--technique", options.techniques, "Only this one")
        ->type_name("NAME")
        ->allow_extra_args(false);
    verb.add_option("--budget", options.budget,
                    "Say what to take if an outline may add so much GPU time to a frame")
        ->type_name("MS")
        ->check(CheckBudget);
    auto* shard = verb.add_option_function<std::string>(
                          "--shard",
                          [&options](const std::string& text) {
                              std::tie(options.shard, options.shards) =
                                  ParseShard(text).value_or(std::pair(1, 1));
                          },
                          "Measure the I-th of N parts, which --merge puts together")
                      ->type_name("I/N")
                      ->check(CheckShard);
    auto* merge = verb.add_flag("--merge", options.isMerge,
                                "Make one report of the folders of all parts; nothing is drawn")
                      ->excludes(shard);
    verb.add_flag_callback(
            "--compare",
            [&options, output]
            {
                options.isCompare = true;
                output->required(false);
            },
            "Say in which cells two folders differ, times apart; exit code 1 if they do")
        ->excludes(shard)
        ->excludes(merge);
}

} // namespace limn
