#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace limn
{

inline constexpr std::size_t k_MostParts = 16;

/// How many parts a loop over `count` elements is worth: a thread takes some 30 us to start, and
/// longer on a busy machine.
inline std::size_t PartsOf(std::size_t count)
{
    constexpr std::size_t k_LeastElements = 200'000;
    static const std::size_t cores = // asking for it opens files
        std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, k_MostParts);
    return std::max<std::size_t>(std::min(count / k_LeastElements, cores), 1);
}

/// Runs function(part, begin, end) for each of `parts` runs of elements, k_MostParts at most, in
/// threads of their own but the last; where no thread can be started, in the caller's. An exception
/// of any of them goes on to the caller.
template <typename Thread = std::jthread, typename Function>
void ForEachPart(std::size_t count, std::size_t parts, const Function& function)
{
    if (parts == 1)
    {
        function(0, 0, count);
        return;
    }
    std::array<std::exception_ptr, k_MostParts> failures;
    const auto run = [&](std::size_t part)
    {
        try
        {
            function(part, count * part / parts, count * (part + 1) / parts);
        }
        catch (...)
        {
            failures[part] = std::current_exception();
        }
    };
    {
        std::vector<Thread> threads;
        threads.reserve(parts);
        std::size_t part = 0;
        try
        {
            for (; part + 1 < parts; ++part)
            {
                threads.emplace_back(run, part);
            }
        }
        catch (const std::system_error&)
        {
            // A limit of the machine is reached: it takes longer, that is all.
        }
        for (; part < parts; ++part)
        {
            run(part);
        }
    }
    for (const std::exception_ptr& failure : failures)
    {
        if (failure)
        {
            std::rethrow_exception(failure);
        }
    }
}

} // namespace limn
