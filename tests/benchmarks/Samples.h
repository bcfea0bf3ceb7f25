#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace limn::benchmarks
{

/// Numbers of one kind.
class Samples
{
public:
    void Add(double value) { m_Values.push_back(value); }
    /// @param part  0 the least, 1 the greatest
    double Part(double part)
    {
        std::ranges::sort(m_Values);
        return m_Values.at(
            static_cast<std::size_t>(part * static_cast<double>(m_Values.size() - 1) + 0.5));
    }
    double Median() { return Part(0.5); }

private:
    std::vector<double> m_Values;
};

/// Two that take turns: the ratio of neighbours, as its median with the tenth and ninetieth part.
struct Comparison
{
    Samples first;
    Samples second;
    Samples ratio;

    void Add(double a, double b)
    {
        first.Add(a);
        second.Add(b);
        ratio.Add(a / b);
    }
    void Print(const char* name)
    {
        std::printf("%-44s %9.3f ms %9.3f ms   %6.2f [%.2f-%.2f]\n", name, first.Median(),
                    second.Median(), ratio.Median(), ratio.Part(0.1), ratio.Part(0.9));
    }
};

/// Milliseconds that a call takes.
template <typename Function>
double Time(const Function& function)
{
    const auto begin = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
        .count();
}

/// Memory that this process has.
inline double ResidentBytes()
{
    std::ifstream file("/proc/self/statm");
    double total = 0.0;
    double resident = 0.0;
    file >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace limn::benchmarks
