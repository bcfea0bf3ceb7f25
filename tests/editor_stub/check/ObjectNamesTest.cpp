#include "check/ObjectNames.h"

#include "Mentions.h"
#include <gmock/gmock.h>
#include <random>

namespace limn::test
{

namespace
{

using Items = std::vector<std::string>;

/// An object by its path from the top down.
ExplainedObject Object(Items path)
{
    ExplainedObject object;
    object.name = path.back();
    path.pop_back();
    object.parents.assign(path.rbegin(), path.rend());
    return object;
}

/// The positions of a set's renderers.
std::vector<std::size_t> Places(const RendererSet& set)
{
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < set.size(); ++i)
    {
        if (set[i])
        {
            places.push_back(i);
        }
    }
    return places;
}

std::vector<std::size_t> Found(const ObjectNames& names, const std::string& item)
{
    return names.Find(item);
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ObjectNamesOfAScene, AreFoundByNamePathTopAndNumber)
{
    const ObjectNames names({Object({"Room", "Sofa", "Leg"}), Object({"Room", "Sofa", "Leg"}),
                             Object({"Room", "Lamp"}), Object({"Lamp"}), Object({"not all"}),
                             Object({"A/B"})});
    EXPECT_THAT(Found(names, "Sofa"), ElementsAre(0u, 1u));
    EXPECT_THAT(Found(names, "Sofa/Leg"), ElementsAre(0u, 1u));
    EXPECT_THAT(Found(names, "Leg/#2"), ElementsAre(1u));
    EXPECT_THAT(Found(names, "Lamp"), ElementsAre(2u, 3u));
    EXPECT_THAT(Found(names, "/Lamp"), ElementsAre(3u));
    EXPECT_THAT(Found(names, "Room"), ElementsAre(0u, 1u, 2u));
    EXPECT_THAT(Found(names, "A/B"), ElementsAre(5u));
    EXPECT_THAT(Found(names, "Roo"), IsEmpty());
    EXPECT_THAT(Found(names, ""), IsEmpty());
    EXPECT_THAT(Places(names.Evaluate({"Room", "not Sofa"})), ElementsAre(2u));
    EXPECT_THAT(Places(names.Evaluate({"not all"})), ElementsAre(4u)); // it is called so
    EXPECT_THAT(Places(names.Evaluate({"Sofa", "not Sofa", "Leg/#1"})), ElementsAre(0u));
}

TEST(ObjectNamesOfAScene, AreFixedWithTheShortestNamesThatAreClear)
{
    const ObjectNames names({Object({"Sofa", "Seat"}), Object({"Sofa", "Back"}),
                             Object({"Sofa", "Shadow"}), Object({"Lamp", "Shadow"}),
                             Object({"Lamp", "Bulb"})});
    EXPECT_THAT(names.Fix({}, {true, true, true, false, false}), ElementsAre("Sofa"));
    EXPECT_THAT(names.Fix({}, {true, true, false, false, true}),
                ElementsAre("Seat", "Back", "Bulb"));
    EXPECT_THAT(names.Fix({"Sofa", "Gone"}, {true, true, false, false, false}),
                ElementsAre("Sofa", "not Sofa/Shadow"));
    EXPECT_THAT(names.Fix({"Back", "Seat"}, {true, true, false, false, false}),
                ElementsAre("Back", "Seat")); // as somebody has written it
    EXPECT_THAT(names.Fix({"Sofa", "Bulb"}, {false, false, true, false, true}),
                ElementsAre("Bulb", "Sofa/Shadow")); // less than half of the Sofa
    EXPECT_THAT(names.Fix({"Sofa", "not Sofa/Shadow"}, {false, false, false, false, false}),
                IsEmpty());
}

TEST(ObjectNamesOfAScene, ExpressEverySetOfEveryScene)
{
    std::mt19937 random(7);
    const auto number = [&random](unsigned end)
    {
        return static_cast<std::size_t>(random() % end);
    };
    for (int round = 0; round < 300; ++round)
    {
        std::vector<Items> paths;
        std::vector<ExplainedObject> objects;
        for (std::size_t i = 0; i < 12; ++i)
        {
            Items path = paths.empty() || number(3) == 0
                             ? Items()
                             : paths[number(static_cast<unsigned>(paths.size()))];
            path.push_back(std::string(1, static_cast<char>('A' + number(4))));
            paths.push_back(path);
            objects.push_back(Object(path));
        }
        const ObjectNames names(objects);
        RendererSet wanted(objects.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
        {
            wanted[i] = number(2) == 0;
        }
        const Items before{"A", "not B", "C/D"};
        EXPECT_EQ(wanted, names.Evaluate(names.Fix({}, wanted))) << round;
        EXPECT_EQ(wanted, names.Evaluate(names.Fix(before, wanted))) << round;
    }
}

TEST(ObjectNamesOfAScene, AreDescribedInGroups)
{
    const ObjectNames names({Object({"Sofa", "Seat"}), Object({"Sofa", "Back"}),
                             Object({"Sofa", "Shadow"}), Object({"Room", "Rug"}),
                             Object({"Room", "Wall"}), Object({"Room", "Floor"})});
    const RendererSet none(6);
    EXPECT_THAT(names.Describe({true, true, true, true, false, false}, none),
                ElementsAre("Sofa", "Rug"));
    EXPECT_THAT(names.Describe({true, true, false, false, false, false}, none),
                ElementsAre("Sofa (2 of 3 renderers)"));
    EXPECT_THAT(names.Describe({true, true, false, false, false, false},
                               {false, false, true, false, false, false}),
                ElementsAre("Seat", "Back"));
}

TEST(ObjectNamesOfAScene, AreSuggestedForMisspeltOnes)
{
    const ObjectNames names({Object({"Room", "Sofa", "Seat"}), Object({"Lamp"})});
    EXPECT_THAT(names.UnknownSentence("Sofaa"), Mentions("'Sofaa'", "'Sofa'"));
    EXPECT_THAT(names.UnknownSentence("not Sofa/Saet"), Mentions("'Sofa/Saet'", "'Sofa/Seat'"));
    EXPECT_THAT(names.UnknownSentence("Xylophone"), Mentions("'Xylophone'", "Lamp, Room"));
}

} // namespace

} // namespace limn::test
