#include "Mentions.h"
#include "Problems.h"

#include <gmock/gmock.h>
#include <limn/volume/YamlRead.h>

namespace limn
{

namespace
{

using test::Mentions;
using test::Texts;
using testing::ElementsAre;
using testing::IsEmpty;

/// The value of `key: <text>`, and what a reader said about it.
struct ValueReading
{
    explicit ValueReading(const std::string& text)
        : node(*ParseYaml("key: " + text + "\n", "x.yaml").front().Find("key"))
    {
    }

    std::vector<std::string> problems() const { return Texts(diagnostics.diagnostics()); }

    YamlNode node;
    AssetDiagnostics diagnostics{"x.yaml"};
};

std::vector<std::string> BoolProblems(const std::string& text)
{
    ValueReading reading(text);
    EXPECT_EQ(ReadBool(reading.node, "a.b", reading.diagnostics), std::nullopt);
    return reading.problems();
}

std::vector<std::string> FloatProblems(const std::string& text, ValueRange range = {})
{
    ValueReading reading(text);
    EXPECT_EQ(ReadFloat(reading.node, "a.b", reading.diagnostics, range), std::nullopt);
    return reading.problems();
}

std::vector<std::string> IntProblems(const std::string& text, ValueRange range = {})
{
    ValueReading reading(text);
    EXPECT_EQ(ReadInt(reading.node, "a.b", reading.diagnostics, range), std::nullopt);
    return reading.problems();
}

std::vector<std::string> ColorProblems(const std::string& text)
{
    ValueReading reading(text);
    EXPECT_EQ(ReadColor(reading.node, "a.b", reading.diagnostics), std::nullopt);
    return reading.problems();
}

std::vector<std::string> VectorProblems(const std::string& text)
{
    ValueReading reading(text);
    EXPECT_EQ(ReadVector(reading.node, 3, "a.b", reading.diagnostics), std::nullopt);
    return reading.problems();
}

TEST(ReadBool, TakesTrueFalseOneAndZero)
{
    for (const auto& [text, expected] :
         {std::pair("true", true), {"1", true}, {"false", false}, {"0", false}})
    {
        ValueReading reading(text);
        EXPECT_EQ(ReadBool(reading.node, "a.b", reading.diagnostics), expected) << text;
        EXPECT_THAT(reading.problems(), IsEmpty());
    }
}

TEST(ReadBool, RefusesWordsThatYamlVersionsReadDifferently)
{
    EXPECT_THAT(BoolProblems("yes"),
                ElementsAre(Mentions("1:6: a.b", "'yes'", "version of YAML", "true or false")));
    EXPECT_THAT(BoolProblems("Off"),
                ElementsAre(Mentions("1:6: a.b", "'Off'", "version of YAML", "true or false")));
}

TEST(ReadBool, RefusesEverythingElse)
{
    EXPECT_THAT(BoolProblems("2"), ElementsAre(Mentions("1:6: a.b", "'2'", "true or false")));
    EXPECT_THAT(BoolProblems(""), ElementsAre(Mentions("1:1: a.b", "nothing", "true or false")));
    EXPECT_THAT(BoolProblems("'true'"),
                ElementsAre(Mentions("1:6: a.b", "'true'", "quotes", "true or false")));
    EXPECT_THAT(BoolProblems("{}"), ElementsAre(Mentions("1:6: a.b", "map", "true or false")));
}

TEST(ReadInt, TakesDecimalDigits)
{
    for (const auto& [text, expected] :
         {std::pair("4", 4), {"-2147483648", -2147483647 - 1}, {"+7", 7}, {"010", 10}})
    {
        ValueReading reading(text);
        EXPECT_EQ(ReadInt(reading.node, "a.b", reading.diagnostics), expected) << text;
    }
}

TEST(ReadInt, RefusesFractionsOtherNotationsAndNumbersOutsideTheRange)
{
    EXPECT_THAT(IntProblems("4.5"),
                ElementsAre("1:6: a.b: found '4.5'; a whole number is expected"));
    EXPECT_THAT(IntProblems("0x10"),
                ElementsAre("1:6: a.b: found '0x10'; a whole number is expected"));
    EXPECT_THAT(IntProblems("32", {0, 31}), ElementsAre("1:6: a.b: 32 is outside [0, 31]"));
    EXPECT_THAT(IntProblems("2147483648"),
                ElementsAre("1:6: a.b: 2147483648 is outside [-2147483648, 2147483647]"));
    EXPECT_THAT(IntProblems("99999999999999999999"),
                ElementsAre("1:6: a.b: 99999999999999999999 does not fit in 64 bits"));
}

TEST(ReadFloat, TakesNumbersInEveryUsualNotation)
{
    for (const auto& [text, expected] : {std::pair("4", 4.0f),
                                         {"-0.25", -0.25f},
                                         {"+1.5", 1.5f},
                                         {"1e3", 1000.0f},
                                         {".5", 0.5f},
                                         {"5.", 5.0f},
                                         {"0.49606514", 0.49606514f}})
    {
        ValueReading reading(text);
        EXPECT_EQ(ReadFloat(reading.node, "a.b", reading.diagnostics), expected) << text;
    }
}

TEST(ReadFloat, RefusesNumbersThatAreNotFinite)
{
    for (const std::string text : {".nan", "NaN", "nan", ".inf", "-.Inf", "+inf", "Infinity"})
    {
        EXPECT_THAT(FloatProblems(text),
                    ElementsAre(Mentions("1:6: a.b", "'" + text + "'", "finite")));
    }
    EXPECT_THAT(FloatProblems("1e39"), ElementsAre("1:6: a.b: 1e39 does not fit in 32 bits"));
    EXPECT_THAT(FloatProblems("1e999"), ElementsAre("1:6: a.b: 1e999 does not fit in 32 bits"));
}

TEST(ReadFloat, RefusesWhatIsNoNumber)
{
    EXPECT_THAT(FloatProblems("wide"), ElementsAre("1:6: a.b: found 'wide'; a number is expected"));
    EXPECT_THAT(FloatProblems("3,5"), ElementsAre("1:6: a.b: found '3,5'; a number is expected"));
    EXPECT_THAT(FloatProblems("4px"), ElementsAre("1:6: a.b: found '4px'; a number is expected"));
    EXPECT_THAT(FloatProblems("++4"), ElementsAre("1:6: a.b: found '++4'; a number is expected"));
    EXPECT_THAT(FloatProblems("'4'"), ElementsAre(Mentions("1:6: a.b", "'4'", "quotes", "number")));
    EXPECT_THAT(FloatProblems("[4]"),
                ElementsAre("1:6: a.b: found a sequence; a number is expected"));
}

TEST(ReadFloat, StatesTheRangeANumberIsOutsideOf)
{
    EXPECT_THAT(FloatProblems("14", {1, 10}), ElementsAre("1:6: a.b: 14 is outside [1, 10]"));
    EXPECT_THAT(FloatProblems("0.999", {1, 10}), ElementsAre("1:6: a.b: 0.999 is outside [1, 10]"));
    EXPECT_THAT(FloatProblems("-1", {0, std::numeric_limits<double>::infinity()}),
                ElementsAre("1:6: a.b: -1 is outside [0, inf]"));
}

TEST(ReadFloat, AllowsTheLimitsThemselvesWhateverTheirPrecision)
{
    for (const ValueRange range :
         {ValueRange{0.1, 1.0}, ValueRange{static_cast<double>(0.1f), 1.0}, ValueRange{-1.0, 0.1}})
    {
        ValueReading reading("0.1");
        EXPECT_EQ(ReadFloat(reading.node, "a.b", reading.diagnostics, range), 0.1f);
    }
}

TEST(ReadString, TakesAnyScalar)
{
    for (const auto& [text, expected] :
         {std::pair("plain text", "plain text"), {"'quoted'", "quoted"}, {"42", "42"}, {"''", ""}})
    {
        ValueReading reading(text);
        EXPECT_EQ(ReadString(reading.node, "a.b", reading.diagnostics), expected);
    }
    ValueReading nothing("");
    EXPECT_EQ(ReadString(nothing.node, "a.b", nothing.diagnostics), std::nullopt);
    EXPECT_THAT(nothing.problems(), ElementsAre("1:1: a.b: found nothing; text is expected"));
}

TEST(ReadColor, TakesEveryForm)
{
    const Color orange{1.0f, 128.0f / 255.0f, 0.0f, 1.0f};
    const std::vector<std::pair<std::string, Color>> forms{
        {"{r: 0, g: 0.5, b: 2, a: 0.25}", {0.0f, 0.5f, 2.0f, 0.25f}},
        {"{r: 0, g: 0.5, b: 1}", {0.0f, 0.5f, 1.0f, 1.0f}},
        {"[0, 0.5, 1]", {0.0f, 0.5f, 1.0f, 1.0f}},
        {"[0, 0.5, 1, 0]", {0.0f, 0.5f, 1.0f, 0.0f}},
        {"'#FF8000'", orange},
        {"'#ff8000'", orange},
        {"\"#FF800000\"", {1.0f, 128.0f / 255.0f, 0.0f, 0.0f}}};
    for (const auto& [text, expected] : forms)
    {
        ValueReading reading(text);
        EXPECT_EQ(ReadColor(reading.node, "a.b", reading.diagnostics), expected) << text;
        EXPECT_THAT(reading.problems(), IsEmpty()) << text;
    }
}

TEST(ReadColor, ShowsTheFormsWhereNoneFits)
{
    const auto refusal = [](const char* place, const char* found)
    {
        return ElementsAre(Mentions(place, found, "colour", "{r: 1, g: 0.5, b: 0, a: 1}",
                                    "[1, 0.5, 0]", "\"#FF8000\"", "quotes"));
    };
    EXPECT_THAT(ColorProblems("#FF8000"), refusal("1:1: a.b", "nothing"));
    EXPECT_THAT(ColorProblems("'#FF80'"), refusal("1:6: a.b", "'#FF80'"));
    EXPECT_THAT(ColorProblems("'#FF80G0'"), refusal("1:6: a.b", "'#FF80G0'"));
    EXPECT_THAT(ColorProblems("'#-180+1'"), refusal("1:6: a.b", "'#-180+1'"));
    EXPECT_THAT(ColorProblems("red"), refusal("1:6: a.b", "'red'"));
    EXPECT_THAT(ColorProblems("[1, 2]"), refusal("1:6: a.b", "sequence of 2"));
}

TEST(ReadColor, ReportsEveryBadChannel)
{
    EXPECT_THAT(ColorProblems("{r: x, g: .nan, a: 1, alpha: 1}"),
                ElementsAre(Mentions("1:10: a.b.r", "'x'", "number"),
                            Mentions("1:16: a.b.g", "'.nan'", "finite"),
                            Mentions("1:6: a.b", "'b'", "missing"),
                            Mentions("1:28: a.b", "unknown key", "'alpha'", "r, g, b, a")));
    EXPECT_THAT(ColorProblems("[1, x, 0]"),
                ElementsAre("1:10: a.b[1]: found 'x'; a number is expected"));
}

TEST(ReadVector, TakesASequenceOrAMap)
{
    for (const char* text : {"[1, -2, 0.5]", "{x: 1, y: -2, z: 0.5}"})
    {
        ValueReading reading(text);
        EXPECT_EQ(ReadVector(reading.node, 3, "a.b", reading.diagnostics),
                  glm::vec4(1.0f, -2.0f, 0.5f, 0.0f));
    }
}

TEST(ReadVector, SaysHowManyNumbersItExpects)
{
    EXPECT_THAT(VectorProblems("[1, 2]"),
                ElementsAre(Mentions("1:6: a.b", "sequence of 2", "3 numbers")));
    EXPECT_THAT(VectorProblems("7"), ElementsAre(Mentions("1:6: a.b", "'7'", "3 numbers")));
    EXPECT_THAT(VectorProblems("{x: 1, z: 2}"), ElementsAre("1:6: a.b: key 'y' is missing"));
}

} // namespace

} // namespace limn
