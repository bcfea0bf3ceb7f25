#include "renderers/SortEntries.h"

#include <array>
#include <cmath>
#include <compare>
#include <gtest/gtest.h>
#include <iostream>
#include <precision/ExactSum.h>
#include <precision/RandomFloats.h>
#include <set>
#include <sstream>

#include "scene/TestScene.h"
#include <limn/core/Judge.h>

namespace limn
{
namespace
{

using test::ExactSum;
using test::RandomFloats;

constexpr int k_PairCount = 1'000'000;

/// A renderer as sorting sees it.
struct SortedItem
{
    int queue = 2000;
    glm::vec3 offset{0.0f}; ///< from the camera
    std::uint16_t materialIndex = 0;
};

struct SortedPair
{
    SortedItem a;
    SortedItem b;
    SortingSettings sorting;
};

/// Equal and nearly equal ones, permutations of one another (which are exactly as far away), and
/// ones that have nothing to do with each other.
class RandomPairs
{
public:
    SortedPair Next()
    {
        constexpr std::array<SortingCriteria, 5> k_Criteria{
            SortingCriteria::CommonOpaque, SortingCriteria::CommonTransparent,
            SortingCriteria::BackToFront, SortingCriteria::QuantizedFrontToBack,
            SortingCriteria::None};
        SortedPair pair;
        pair.sorting.criteria = k_Criteria[static_cast<std::size_t>(m_Random.Below(5))];
        pair.sorting.distanceMetric =
            m_Random.Below(2) == 0 ? DistanceMetric::Perspective : DistanceMetric::Orthographic;
        pair.sorting.cameraForward = {m_Random.Between(-1, 1), m_Random.Between(-1, 1),
                                      m_Random.Between(-1, 1)};
        pair.a = {Queue(2000), Offset(), static_cast<std::uint16_t>(m_Random.Below(65536))};
        pair.b = {Queue(pair.a.queue), Beside(pair.a.offset),
                  static_cast<std::uint16_t>(m_Random.Below(65536))};
        return pair;
    }

private:
    int Queue(int before) { return m_Random.Below(2) == 0 ? before : m_Random.Below(5001); }

    glm::vec3 Offset()
    {
        return m_Random.Below(2) == 0
                   ? glm::vec3(m_Random.Any(), m_Random.Any(), m_Random.Any())
                   : glm::vec3(m_Random.Between(-50, 50), m_Random.Between(-50, 50),
                               m_Random.Between(-50, 50));
    }

    glm::vec3 Beside(const glm::vec3& offset)
    {
        switch (m_Random.Below(4))
        {
        case 0:
            return offset;
        case 1:
            return {-offset.z, offset.x, offset.y};
        case 2:
            return {std::nextafter(offset.x, m_Random.Between(-100, 100)), offset.y,
                    std::nextafter(offset.z, m_Random.Between(-100, 100))};
        default:
            return Offset();
        }
    }

    RandomFloats m_Random{41};
};

/// The exact difference of the two squared distances, or of the distances along the view where
/// those decide. Products of two floats are exact in double.
struct ExactDifference
{
    double value;
    double size; ///< of what it is a difference of

    explicit ExactDifference(const SortedPair& pair)
    {
        const bool isRound = pair.sorting.distanceMetric == DistanceMetric::Perspective;
        const glm::dvec3 forward(pair.sorting.cameraForward);
        const glm::dvec3 a(pair.a.offset);
        const glm::dvec3 b(pair.b.offset);
        const glm::dvec3 ofA = a * (isRound ? a : forward);
        const glm::dvec3 ofB = b * (isRound ? b : forward);
        value = ExactSum({ofA.x, ofA.y, ofA.z, -ofB.x, -ofB.y, -ofB.z});
        const glm::dvec3 sizes = glm::abs(ofA) + glm::abs(ofB);
        size = sizes.x + sizes.y + sizes.z;
    }
    /// Doubles cannot be trusted with less: two sums of three, each rounded twice.
    bool IsClear() const { return std::abs(value) > 0x1p-51 * size; }
};

int Sign(double value)
{
    return value < 0.0 ? -1 : value > 0.0 ? 1 : 0;
}

template <typename T>
int Order(T a, T b)
{
    return a < b ? -1 : b < a ? 1 : 0;
}

std::uint64_t KeyOf(const SortedItem& sorted, const SortingSettings& sorting)
{
    return SortKey(sorting.criteria, sorted.queue, SortDistance(sorted.offset, sorting),
                   sorted.materialIndex);
}

/// The order that the criteria ask for: the first that differs decides. 0 where they leave it open,
/// and where doubles cannot tell.
int WantedOrder(const SortedPair& pair)
{
    const SortingCriteria criteria = pair.sorting.criteria;
    if (criteria & SortingCriteria::RenderQueue && pair.a.queue != pair.b.queue)
    {
        return Order(pair.a.queue, pair.b.queue);
    }
    const ExactDifference difference(pair);
    const int further = difference.IsClear() ? Sign(difference.value) : 0;
    return criteria & SortingCriteria::BackToFront            ? -further
           : criteria & SortingCriteria::QuantizedFrontToBack ? further
                                                              : 0;
}

std::string TextOf(const SortedPair& pair)
{
    std::ostringstream text;
    text << std::hexfloat;
    for (const SortedItem& sorted : {pair.a, pair.b})
    {
        text << sorted.queue << " (" << sorted.offset.x << ", " << sorted.offset.y << ", "
             << sorted.offset.z << ") " << sorted.materialIndex << "; ";
    }
    const glm::vec3& forward = pair.sorting.cameraForward;
    text << "criteria " << static_cast<int>(pair.sorting.criteria) << ", metric "
         << static_cast<int>(pair.sorting.distanceMetric) << " along (" << forward.x << ", "
         << forward.y << ", " << forward.z << ")";
    return text.str();
}

TEST(SortPrecision, NoKeyReversesTheExactOrder)
{
    RandomPairs pairs;
    int ties = 0;
    int open = 0;
    for (int i = 0; i < k_PairCount; ++i)
    {
        const SortedPair pair = pairs.Next();
        const int wanted = WantedOrder(pair);
        const bool goesByIndex = pair.sorting.criteria & SortingCriteria::BackToFront;
        const int byKey =
            Order(KeyOf(pair.a, pair.sorting) >> 16, KeyOf(pair.b, pair.sorting) >> 16);
        ASSERT_TRUE(wanted == 0 || byKey != -wanted) << TextOf(pair);
        open += wanted == 0 ? 1 : 0;
        ties += wanted != 0 && byKey == 0 ? 1 : 0;
        if (byKey == 0) // then the material's index decides, from back to front only
        {
            ASSERT_EQ(goesByIndex ? Order(pair.a.materialIndex, pair.b.materialIndex) : 0,
                      Order(KeyOf(pair.a, pair.sorting), KeyOf(pair.b, pair.sorting)))
                << TextOf(pair);
        }
    }
    std::cout << k_PairCount << " pairs: none reversed, " << ties << " equal by their keys alone, "
              << open << " left open by the criteria or the last bits of a double\n";
}

TEST(SortPrecision, OnlyDistancesWhoseSquaresAreOneFloatAreEqualFromBackToFront)
{
    RandomPairs pairs;
    for (int i = 0; i < k_PairCount / 8; ++i)
    {
        SortedPair pair = pairs.Next();
        pair.sorting.criteria = SortingCriteria::BackToFront;
        pair.sorting.distanceMetric = DistanceMetric::Perspective;
        const glm::dvec3 a(pair.a.offset);
        const glm::dvec3 b(pair.b.offset);
        const double nearer = std::min(glm::dot(a, a), glm::dot(b, b));
        const bool isInRange = nearer > 1e-37 && glm::dot(a, a) + glm::dot(b, b) < 1e38;
        const double difference = std::abs(ExactDifference(pair).value);
        const bool isEqual = DistanceKey(pair.sorting.criteria, SortDistance(a, pair.sorting)) ==
                             DistanceKey(pair.sorting.criteria, SortDistance(b, pair.sorting));
        if (isInRange && difference > 0x1p-23 * nearer * (1.0 + 1e-6))
        {
            ASSERT_FALSE(isEqual) << TextOf(pair);
        }
        if (difference == 0.0) // permutations: sums of another order, which a float seldom sees
        {
            const auto keyA = OrderedBits(SortDistance(a, pair.sorting));
            const auto keyB = OrderedBits(SortDistance(b, pair.sorting));
            ASSERT_LE(std::max(keyA, keyB) - std::min(keyA, keyB), 1u) << TextOf(pair);
        }
    }
}

/// The eighth of an octave of the root of a square, by comparing its eighth power's integers: the
/// square's mantissa to the fourth power against powers of two.
std::uint32_t ExactEighth(float square)
{
    __extension__ using Wide = unsigned __int128;
    int exponent = 0;
    const auto mantissa =
        static_cast<Wide>(std::ldexp(std::frexp(static_cast<double>(square), &exponent), 24));
    const Wide power = mantissa * mantissa * mantissa * mantissa; // 2^92 up to 2^96
    const int quarter = static_cast<int>(power >> 93 != 0) + static_cast<int>(power >> 94 != 0) +
                        static_cast<int>(power >> 95 != 0);
    return static_cast<std::uint32_t>(1 + 4 * (exponent - 1 + 127) + quarter);
}

TEST(SortPrecision, EighthsOfOctavesBeginWhereTheirPowersDo)
{
    RandomFloats random(42);
    for (int i = 0; i < k_PairCount / 4; ++i)
    {
        const float square = std::abs(random.Any());
        if (square > 1e-6f)
        {
            ASSERT_EQ(ExactEighth(square), Quantised(square)) << std::hexfloat << square;
        }
    }
    for (int quarter = -70; quarter < 500; ++quarter) // beside each border
    {
        const auto border = static_cast<float>(std::exp2(quarter / 4.0));
        for (const float square :
             {std::nextafter(border, 0.0f), border, std::nextafter(border, 1e38f)})
        {
            ASSERT_EQ(ExactEighth(square), Quantised(square)) << std::hexfloat << square;
        }
    }
}

TEST(SortPrecision, PlacesBeyondNumbersAndZerosOfBothSignsAreInOrder)
{
    const float infinity = std::numeric_limits<float>::infinity();
    const float largest = std::numeric_limits<float>::max();
    const float least = std::numeric_limits<float>::denorm_min();
    SortingSettings sorting{SortingCriteria::BackToFront};
    const auto key = [&sorting](float x)
    {
        return DistanceKey(sorting.criteria, SortDistance(glm::dvec3(x, 0.0, 0.0), sorting));
    };
    EXPECT_EQ(key(0.0f), key(-0.0f));
    EXPECT_EQ(key(0.0f), key(least)); // its square is no float
    EXPECT_EQ(key(largest), key(infinity));
    EXPECT_EQ(key(largest), key(std::nanf("")));
    EXPECT_EQ(key(largest), key(2e19f));
    EXPECT_LT(key(1.8e19f), key(1.7e19f));
    EXPECT_LT(key(1e-22f), key(1e-23f));
    sorting.distanceMetric = DistanceMetric::Orthographic;
    sorting.cameraForward = {1.0f, 0.0f, 0.0f};
    EXPECT_EQ(key(0.0f), key(-0.0f));
    EXPECT_GT(key(-1e-22f), key(1e-22f)); // behind the camera is nearest
    EXPECT_GT(key(-1.8e19f), key(-1.7e19f));
}

/// Queues, layers and rendering layers as sets of numbers.
struct Sets
{
    std::set<int> queues;
    std::set<int> layers;
    std::set<int> renderingLayers;

    explicit Sets(const FilteringSettings& filtering)
        : layers(BitsOf(filtering.layerMask.bits)),
          renderingLayers(BitsOf(filtering.renderingLayerMask.bits))
    {
        for (int queue = filtering.renderQueueRange.lowerBound();
             queue <= filtering.renderQueueRange.upperBound(); ++queue)
        {
            queues.insert(queue);
        }
    }
    FilterVerdict Verdict(const FilterItem& item) const
    {
        const std::set<int> own = BitsOf(item.renderingLayerMask.bits);
        const bool meets =
            std::ranges::any_of(own, [this](int layer) { return renderingLayers.contains(layer); });
        return !queues.contains(item.renderQueue) ? FilterVerdict::QueueOutOfRange
               : !layers.contains(item.layer)     ? FilterVerdict::LayerMaskMiss
               : !meets                           ? FilterVerdict::RenderingLayerMaskMiss
                                                  : FilterVerdict::Drawn;
    }
    static std::set<int> BitsOf(std::uint32_t bits)
    {
        std::set<int> numbers;
        for (int i = 0; i < 32; ++i, bits /= 2)
        {
            if (bits % 2 == 1)
            {
                numbers.insert(i);
            }
        }
        return numbers;
    }
};

TEST(FilterPrecision, VerdictsAreThoseOfSets)
{
    RandomFloats random(43);
    const std::shared_ptr<const Shader> shader = test::ShaderWithModes({"UniversalForward"});
    DrawingSettings drawing;
    drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
    const auto mask = [&random]
    {
        const auto bits = static_cast<std::uint32_t>(random.Below(1 << 30)) * 5u;
        return bits >> random.Below(32) << random.Below(32);
    };
    std::array<int, k_FilterVerdictCount> counts{};
    for (int i = 0; i < 200; ++i)
    {
        const int lower = random.Below(5001);
        const int length = random.Below(3) == 0 ? random.Below(3) : random.Below(5001);
        const FilteringSettings filtering(RenderQueueRange(lower, std::min(lower + length, 5000)),
                                          LayerMask(mask() | mask()), RenderingLayerMask(mask()));
        const Sets sets(filtering);
        for (int k = 0; k < 100; ++k)
        {
            // Often just inside or just outside the range.
            const int queue =
                random.Below(2) == 0 ? lower - 1 + random.Below(length + 3) : random.Below(5001);
            const FilterItem item{std::clamp(queue, 0, 5000), random.Below(32),
                                  RenderingLayerMask(mask()), shader.get()};
            const FilterVerdict verdict = Judge(item, filtering, drawing);
            ASSERT_EQ(sets.Verdict(item), verdict)
                << item.renderQueue << " in " << lower << "...; layer " << item.layer << " in "
                << filtering.layerMask.bits << "; " << item.renderingLayerMask.bits << " in "
                << filtering.renderingLayerMask.bits;
            ++counts[static_cast<std::size_t>(verdict)];
        }
    }
    for (const FilterVerdict verdict :
         {FilterVerdict::Drawn, FilterVerdict::QueueOutOfRange, FilterVerdict::LayerMaskMiss,
          FilterVerdict::RenderingLayerMaskMiss})
    {
        EXPECT_GT(counts[static_cast<std::size_t>(verdict)], 500) << ToString(verdict);
    }
}

} // namespace
} // namespace limn
