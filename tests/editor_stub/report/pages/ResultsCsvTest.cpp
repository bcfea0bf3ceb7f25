#include "report/pages/SampleStudy.h"
#include "report/pages/WriteReport.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limn::test
{

namespace
{

/// As RFC 4180 says.
std::vector<std::vector<std::string>> ReadCsv(const std::string& text)
{
    std::vector<std::vector<std::string>> rows(1, {""});
    bool isQuoted = false;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        if (isQuoted && c == '"' && text[i + 1] == '"')
        {
            rows.back().back() += text[++i];
        }
        else if (c == '"')
        {
            isQuoted = !isQuoted;
        }
        else if (c == ',' && !isQuoted)
        {
            rows.back().emplace_back();
        }
        else if (c == '\n' && !isQuoted)
        {
            rows.push_back({""});
        }
        else
        {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

class CsvTable
{
public:
    explicit CsvTable(const study::Study& sample) : m_Rows(ReadCsv(study::ResultsCsv(sample))) {}

    std::size_t size() const { return m_Rows.size() - 1; }
    bool isRectangle() const
    {
        return std::ranges::all_of(m_Rows, [this](const auto& row)
                                   { return row.size() == m_Rows[0].size(); });
    }
    std::string At(std::size_t row, const std::string& column) const
    {
        const auto found = std::ranges::find(m_Rows[0], column);
        return found == m_Rows[0].end() ? "no column " + column
                                        : m_Rows[row + 1][std::size_t(found - m_Rows[0].begin())];
    }

private:
    std::vector<std::vector<std::string>> m_Rows;
};

TEST(ResultsCsvFile, HasARowForEachCellAndAColumnForEachMetric)
{
    study::Study sample = EmptySample();
    AddCell(sample, {study::CellKind::Geometry, "A", "disc", 0.25, 320, 200, ""},
            {{"meanAbsoluteError", 0.1}});
    AddCell(sample, {study::CellKind::Cost, "A", "scene", 8.0, 640, 360, "100 objects"},
            {{"gpuAddedMilliseconds", 1.5}})
        .quartiles["gpuAddedMilliseconds"] = {1.25, 2.0};
    const CsvTable table(sample);
    ASSERT_EQ(2u, table.size());
    EXPECT_TRUE(table.isRectangle());
    EXPECT_EQ("geometry", table.At(0, "kind"));
    EXPECT_EQ("disc", table.At(0, "subject"));
    EXPECT_EQ("0.25", table.At(0, "width"));
    EXPECT_EQ("0.1", table.At(0, "meanAbsoluteError"));
    EXPECT_EQ("", table.At(0, "gpuAddedMilliseconds"));
    EXPECT_EQ("", table.At(0, "gpuAddedMillisecondsLower"));
    EXPECT_EQ("cost", table.At(1, "kind"));
    EXPECT_EQ("640", table.At(1, "pictureWidth"));
    EXPECT_EQ("360", table.At(1, "pictureHeight"));
    EXPECT_EQ("100 objects", table.At(1, "variant"));
    EXPECT_EQ("1.5", table.At(1, "gpuAddedMilliseconds"));
    EXPECT_EQ("1.25", table.At(1, "gpuAddedMillisecondsLower"));
    EXPECT_EQ("2", table.At(1, "gpuAddedMillisecondsUpper"));
    for (const study::Metric& metric : study::Metrics())
    {
        EXPECT_NE("no column " + std::string(metric.key), table.At(0, metric.key));
    }
}

TEST(ResultsCsvFile, KeepsNamesAndNotesAsTheyAre)
{
    const std::string name = "a, \"b\"\nc\r=1+1 \xE2\x82\xAC";
    study::Study sample = EmptySample();
    AddCell(sample, {study::CellKind::Stability, name, name, 1.0, 1, 1, name}, {}).notes = {
        "It failed.", "Twice, even."};
    const CsvTable table(sample);
    ASSERT_EQ(1u, table.size());
    EXPECT_EQ(name, table.At(0, "technique"));
    EXPECT_EQ(name, table.At(0, "subject"));
    EXPECT_EQ(name, table.At(0, "variant"));
    EXPECT_EQ("It failed. Twice, even.", table.At(0, "notes"));
}

TEST(ResultsCsvFile, KeepsFiguresToTheLastBit)
{
    const double third = 1.0 / 3.0;
    study::Study sample = EmptySample();
    AddCell(
        sample,
        {study::CellKind::Geometry, "A", "disc", std::numeric_limits<double>::infinity(), 1, 1, ""},
        {{"largest", third}, {"hausdorff", std::numeric_limits<double>::quiet_NaN()}});
    const CsvTable table(sample);
    EXPECT_EQ(third, std::stod(table.At(0, "largest")));
    EXPECT_EQ("nan", table.At(0, "hausdorff"));
    EXPECT_EQ("inf", table.At(0, "width"));
}

} // namespace

} // namespace limn::test
