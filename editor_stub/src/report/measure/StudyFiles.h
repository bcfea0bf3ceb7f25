#pragma once

#include "console/Json.h"
#include "report/measure/Study.h"

#include <filesystem>
#include <limn/base/WriteFile.h>
#include <set>
#include <span>

namespace limn::study
{

// A study's folder holds study.json, which describes the study, and cells.jsonl, with a line for
// each measured cell, which is written as soon as the cell is measured. Whatever ends the program,
// at most the last line is lost.

/// Returns the path of a file below a study's folder, which somebody else may have made. The file
/// may be missing.
/// @throws AssetError if a link leads out of the folder
std::filesystem::path FileOfStudy(const std::filesystem::path& folder, const std::string& name);

/// @throws AssetError with line and column if a file is missing, belongs to no study, or has values
///     that cannot be
Study ReadStudy(const std::filesystem::path& folder);

/// The folder of a study that is being measured.
class StudyFolder
{
public:
    /// Makes the folder, or continues the study that is in it.
    /// @param study  must have no cells; those that the folder has already are added to it
    /// @throws AssetError if the folder has another study's files, if another StudyFolder holds it,
    ///     in whatever process, or if it cannot be written
    StudyFolder(std::filesystem::path folder, Study& study);

    bool Has(const CellId& id) const { return m_Names.contains(id.Name()); }
    /// Writes the cell. When this returns, the cell is on disk, whatever happens afterwards.
    /// @throws AssetError if it cannot be written
    void Add(CellResult cell);
    /// Writes study.json again, with what was found out about the machine since.
    void Update();

private:
    std::filesystem::path m_Path;
    FileLock m_Lock;
    Study& m_Study;
    std::set<std::string> m_Names; ///< the names of the cells that are there
};

/// A study put together from parts with the same scene, options, limn and device.
struct MergedStudy
{
    Study study;
    std::vector<std::string> missing; ///< planned cells that no part has
    /// Cells that several parts have; the first one's result is kept.
    std::vector<std::string> doubled;
};

/// Returns one study for each scene, device, options and version of limn, in the order of the
/// parts.
std::vector<MergedStudy> MergeStudies(std::span<const Study> parts);

/// Writes a merged study with its pictures into a folder of its own.
/// @param parts  the folders from which the pictures are copied
/// @throws AssetError if the folder is a part, if it holds another study, cells that this one lacks
///     or another picture of the same name, or if something cannot be written
void WriteMerged(const std::filesystem::path& folder, const Study& study,
                 std::span<const std::string> parts);

/// Returns the differences between two studies of the same cells, a line each. Measured figures
/// (Metric::isMeasured) are not compared.
std::vector<std::string> CompareStudies(const Study& first, const Study& second);

/// Returns everything but the cells.
Json ToJson(const Study& study);
/// Returns the cell's result. NaN and infinities are the strings "nan", "inf" and "-inf", since
/// JSON has no such numbers.
Json ToJson(const CellResult& cell);

/// @param file  the file's name in errors
/// @throws AssetError with the line and the column of every problem
Study StudyFromJson(std::string_view text, const std::string& file);
/// @param lineNumber  the line's number in the file
/// @throws AssetError with the line and the column of every problem
CellResult CellFromJson(std::string_view line, const std::string& file, int lineNumber);

} // namespace limn::study
