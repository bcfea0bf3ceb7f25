#include "report/measure/Statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>

namespace limn::study
{
namespace
{

using testing::Each;

TEST(Spread, IsBetweenNeighboursAndOfFiniteValuesOnly)
{
    const Spread spread = SpreadOf({4.0, 1.0, 2.0, 3.0, std::numeric_limits<double>::quiet_NaN()});
    EXPECT_DOUBLE_EQ(1.75, spread.lower);
    EXPECT_DOUBLE_EQ(2.5, spread.median);
    EXPECT_DOUBLE_EQ(3.25, spread.upper);
    EXPECT_TRUE(std::isnan(SpreadOf({}).median));
    EXPECT_DOUBLE_EQ(7.0, SpreadOf({7.0}).upper);
}

/// 1...count, small and large ones in turn, so that neighbours have nothing in common.
std::vector<double> Independent(std::size_t count)
{
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
    {
        values.push_back(static_cast<double>(i % 2 == 0 ? 1 + i / 2 : count - i / 2));
    }
    return values;
}

/// The probability that `low` to `high` of the sorted values, ranks from 1, hold the median: the
/// number of values below it is that of heads in as many throws of a coin.
double Confidence(std::size_t count, double low, double high)
{
    const auto n = static_cast<double>(count);
    double sum = 0.0;
    for (double heads = low; heads < high; ++heads)
    {
        sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(heads + 1.0) -
                        std::lgamma(n - heads + 1.0) - n * std::log(2.0));
    }
    return sum;
}

TEST(BoundOfMedian, HoldsTheMedianWith95PercentByTheBinomialDistribution)
{
    for (std::size_t count = 6; count < 300; ++count)
    {
        const Bound bound = BoundOfMedian(Independent(count));
        EXPECT_GE(Confidence(count, bound.low, bound.high), 0.949) << count;
        EXPECT_LE(Confidence(count, bound.low, bound.high), 0.995) << count;
        EXPECT_EQ(bound.low + bound.high, static_cast<double>(count) + 1.0) << "both ends alike";
    }
}

TEST(BoundOfMedian, IsUnknownOfFewerThanSixValues)
{
    for (std::size_t count = 0; count < 6; ++count)
    {
        EXPECT_TRUE(std::isnan(BoundOfMedian(Independent(count)).low)) << count;
        EXPECT_TRUE(std::isnan(BoundOfMedian(Independent(count)).high)) << count;
    }
}

TEST(BoundOfMedian, IsAsWideForRepeatedValuesAsForTheirNumber)
{
    std::vector<double> repeated;
    for (const double value : Independent(16))
    {
        repeated.insert(repeated.end(), 8, value);
    }
    const Bound once = BoundOfMedian(Independent(16));
    const Bound bound = BoundOfMedian(repeated);
    EXPECT_NEAR(bound.low, once.low, 1.0);
    EXPECT_NEAR(bound.high, once.high, 1.0);
    std::ranges::sort(repeated); // all that is left of time is a trend
    EXPECT_LT(BoundOfMedian(repeated).low, bound.low);
}

TEST(BoundOfMedian, ReachesDownAsFarAsValuesMayBeRaised)
{
    const Bound bound = BoundOfMedian(Independent(101));
    const Bound disturbed = BoundOfMedian(Independent(101), 0.2);
    EXPECT_NEAR(disturbed.low, bound.low - 10.0, 1.0) << "half of a fifth of 101 ranks";
    EXPECT_EQ(disturbed.high, bound.high);
    EXPECT_TRUE(std::isnan(BoundOfMedian(Independent(101), 1.0).low));
}

TEST(TurnsOf, DrawsEachTechniqueOnceARoundInAnotherOrderBetweenFramesWithoutAnOutline)
{
    constexpr std::size_t k_Techniques = 5;
    const std::vector<std::size_t> turns = TurnsOf(k_Techniques, 20);
    ASSERT_EQ(turns.size(), 2 * k_Techniques * 20 + 1);
    std::set<std::vector<std::size_t>> orders;
    for (std::size_t round = 0; round < 20; ++round)
    {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < k_Techniques; ++i)
        {
            const std::size_t turn = 2 * (round * k_Techniques + i);
            EXPECT_EQ(turns[turn], 0u);
            order.push_back(turns[turn + 1]);
        }
        orders.insert(order);
        EXPECT_THAT(order, testing::UnorderedElementsAre(1, 2, 3, 4, 5));
    }
    EXPECT_EQ(turns.back(), 0u);
    EXPECT_GT(orders.size(), 10u);
    EXPECT_EQ(TurnsOf(k_Techniques, 20), turns) << "another run draws the same";
}

/// A machine whose speed others change: a clock that work moves on.
class Machine
{
public:
    explicit Machine(unsigned seed) : m_Random(seed) {}

    double scatter = 0.03; ///< of equal frames, relative
    /// Another program runs and rests in turn, so many milliseconds on the average, and makes this
    /// one 1 to 6 times slower while it runs; 0 for none.
    double runs = 0.0;
    double rests = 0.0;
    double spikes = 0.0; ///< a millisecond: what makes one frame 1.5 to 6 times longer
    std::function<double(double)> drift = [](double)
    {
        return 1.0;
    }; ///< of the time

    double Uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(m_Random);
    }

    /// Draws a frame that takes so long when nothing else happens.
    /// @return how long it took
    double Draw(double milliseconds)
    {
        double left =
            milliseconds * std::exp(std::normal_distribution<double>(0, scatter)(m_Random));
        left *= Uniform(0, 1) < spikes * milliseconds ? Uniform(1.5, 6) : 1.0;
        const double begin = m_Now;
        while (left > 0.0)
        {
            SwitchLoad();
            const double factor = m_Factor * drift(m_Now);
            const double done = std::min(left, (m_NextSwitch - m_Now) / factor);
            m_Now = done < left ? m_NextSwitch : m_Now + done * factor;
            left -= done;
        }
        return m_Now - begin;
    }

private:
    void SwitchLoad()
    {
        if (runs == 0.0)
        {
            m_NextSwitch = std::numeric_limits<double>::infinity();
        }
        else if (m_Now >= m_NextSwitch)
        {
            m_IsLoaded = m_Now == 0.0 ? Uniform(0, runs + rests) < runs : !m_IsLoaded;
            m_Factor = m_IsLoaded ? Uniform(1, 6) : 1.0;
            m_NextSwitch = m_Now + std::exponential_distribution<double>(
                                       1.0 / (m_IsLoaded ? runs : rests))(m_Random);
        }
    }

    std::mt19937 m_Random;
    double m_Now = 0.0;
    double m_NextSwitch = 0.0;
    double m_Factor = 1.0;
    bool m_IsLoaded = false;
};

constexpr double k_Plain = 10.0;                         ///< ms of a frame without an outline
constexpr double k_Added[] = {0.0, 0.2, 1.0, 3.0, 10.0}; ///< ms, that techniques truly add
constexpr std::size_t k_Techniques = std::size(k_Added);

/// What happens on a machine during a run.
struct LoadModel
{
    const char* name;
    /// Changes a machine for a run that takes so many milliseconds if nothing happens.
    void (*begin)(Machine& machine, double run);
    /// Of 100 runs of 101 rounds, those whose bound must be known, of each technique.
    int leastKnown;
    /// Of 100 runs of 101 rounds, those in which a change of load is seen.
    int leastChanged;
    int mostChanged;
};

void PrintTo(const LoadModel& model, std::ostream* stream)
{
    *stream << model.name;
}

/// Rises from 1 to 1 + rise after a fifth of the run.
std::function<double(double)> Drift(double rise, double run)
{
    return [rise, run](double now)
    {
        return 1.0 + rise * std::clamp(now / run - 0.2, 0.0, 0.8) / 0.8;
    };
}

const LoadModel k_LoadModels[] = {
    {"Quiet", [](Machine&, double) {}, 100, 0, 2},
    {"Noisy", [](Machine& machine, double) { machine.scatter = 0.15; }, 100, 0, 5},
    {"LongLoads",
     [](Machine& machine, double run)
     {
         machine.runs = run * machine.Uniform(0.02, 0.15);
         machine.rests = run * machine.Uniform(0.02, 0.15);
     },
     95, 80, 100},
    {"LoadsOfManyFrames",
     [](Machine& machine, double)
     {
         machine.runs = k_Plain * machine.Uniform(10, 100);
         machine.rests = k_Plain * machine.Uniform(10, 100);
     },
     95, 90, 100},
    {"LoadsOfFewFrames",
     [](Machine& machine, double)
     {
         machine.runs = k_Plain * machine.Uniform(2, 12);
         machine.rests = k_Plain * machine.Uniform(2, 12);
     },
     95, 95, 100},
    {"LoadsWithinAFrame",
     [](Machine& machine, double)
     {
         machine.runs = k_Plain * machine.Uniform(0.3, 2);
         machine.rests = k_Plain * machine.Uniform(1, 4);
     },
     95, 95, 100},
    {"MostlyBusy",
     [](Machine& machine, double run)
     {
         machine.rests = run * machine.Uniform(0.01, 0.05);
         machine.runs = 3.0 * machine.rests;
     },
     95, 95, 100},
    {"Spikes",
     [](Machine& machine, double) { machine.spikes = machine.Uniform(0.02, 0.15) / k_Plain; }, 95,
     0, 100},
    {"Drift",
     [](Machine& machine, double run) { machine.drift = Drift(machine.Uniform(0.1, 1.0), run); },
     95, 70, 100},
    {"Waves",
     [](Machine& machine, double run)
     {
         const double height = machine.Uniform(0.1, 1.0);
         const double waves = machine.Uniform(1, std::min(10.0, run / (20.0 * k_Plain)));
         machine.drift = [=](double now)
         {
             return 1.0 + height * (0.5 - 0.5 * std::cos(2.0 * 3.14159265 * waves * now / run));
         };
     },
     95, 60, 100},
    {"AllAtOnce",
     [](Machine& machine, double run)
     {
         machine.runs = run * machine.Uniform(0.01, 0.1);
         machine.rests = run * machine.Uniform(0.01, 0.1);
         machine.spikes = machine.Uniform(0.01, 0.05) / k_Plain;
         machine.drift = Drift(machine.Uniform(0.0, 0.4), run);
     },
     95, 95, 100}};

/// What came of 100 runs.
struct Outcome
{
    int known[k_Techniques] = {};    ///< runs whose bound is known
    int missed[k_Techniques] = {};   ///< of these, those whose bound is beside the true time
    double width[k_Techniques] = {}; ///< the mean of the known ±, ms
    int changed = 0;                 ///< runs in which a change of load was seen
};

Outcome Simulate(const LoadModel& model, int rounds)
{
    Outcome outcome;
    const std::vector<std::size_t> turns = TurnsOf(k_Techniques, rounds);
    for (unsigned run = 0; run < 100; ++run)
    {
        Machine machine(run);
        const double added = std::accumulate(std::begin(k_Added), std::end(k_Added), 0.0);
        model.begin(machine, rounds * (2.0 * k_Plain * k_Techniques + added));
        std::vector<double> times;
        for (const std::size_t turn : turns)
        {
            times.push_back(machine.Draw(k_Plain + (turn == 0 ? 0.0 : k_Added[turn - 1])));
        }
        const TimesInTurn measured(turns, times);
        outcome.changed += HasLoadChanged(measured.quietPart()) ? 1 : 0;
        for (std::size_t i = 0; i < k_Techniques; ++i)
        {
            const TimeAdded time = measured.AddedBy(i + 1);
            if (!std::isnan(time.uncertainty))
            {
                const bool isIn = std::abs(time.added.median - k_Added[i]) <= time.uncertainty;
                outcome.missed[i] += isIn ? 0 : 1;
                outcome.width[i] += time.uncertainty;
                ++outcome.known[i];
            }
        }
    }
    return outcome;
}

class SimulatedLoad : public testing::TestWithParam<LoadModel>
{
};

TEST_P(SimulatedLoad, IsSeenAndLeavesTheTrueTimeWithinTheBound)
{
    const LoadModel& model = GetParam();
    Outcome outcome;
    for (const int rounds : {9, 31, 101}) // of StudyOptions::RoundsOf
    {
        outcome = Simulate(model, rounds);
        for (std::size_t i = 0; i < k_Techniques; ++i)
        {
            EXPECT_LE(outcome.missed[i] * 100, outcome.known[i] * 5)
                << rounds << " rounds, " << k_Added[i] << " ms";
        }
    }
    EXPECT_THAT(outcome.known, Each(testing::Ge(model.leastKnown)));
    EXPECT_GE(outcome.changed, model.leastChanged);
    EXPECT_LE(outcome.changed, model.mostChanged);
}

/// Of n normal values the bound of the median that is narrowest: 1.96 of its standard deviations.
TEST(QuietMachine, HasABoundLittleWiderThanTheNarrowestThereIs)
{
    constexpr int k_Rounds = 101;
    const LoadModel& quiet = k_LoadModels[0];
    const Outcome outcome = Simulate(quiet, k_Rounds);
    for (std::size_t i = 0; i < k_Techniques; ++i)
    {
        const double outlined = k_Plain + k_Added[i];
        const double scatter =
            Machine(0).scatter * std::sqrt(outlined * outlined + k_Plain * k_Plain / 2.0);
        const double narrowest = 1.96 * std::sqrt(3.14159265 / 2.0 / k_Rounds) * scatter;
        const double drift = Machine(0).scatter * k_Added[i]; // is not told from scatter
        EXPECT_LT(outcome.width[i] / outcome.known[i], 1.5 * narrowest + drift) << k_Added[i];
    }
}

INSTANTIATE_TEST_SUITE_P(Models, SimulatedLoad, testing::ValuesIn(k_LoadModels),
                         [](const auto& model) { return model.param.name; });

} // namespace
} // namespace limn::study
