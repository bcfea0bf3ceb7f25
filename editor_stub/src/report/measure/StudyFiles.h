#pragma once

#include "console/Json.h"
#include "report/measure/Study.h"

#include <filesystem>
#include <limn/base/WriteFile.h>
#include <set>
#include <span>

namespace limn::study
{

// A study's folder holds study.json, what it is about, and cells.jsonl, a line for each cell that
// is measured, written as soon as it is. Whatever ends the program, at most the last line is lost.

/// A file below a study's folder, which somebody else may have made: it need not be there.
/// @throws AssetError if a link leads out of the folder
std::filesystem::path FileOfStudy(const std::filesystem::path& folder, const std::string& name);

/// @throws AssetError with line and column if a file is missing, no study's, or says what cannot be
Study ReadStudy(const std::filesystem::path& folder);

/// The folder of a study that is being made.
class StudyFolder
{
public:
    /// Makes the folder, or goes on with what is in it.
    /// @param study  without cells; those that are there already are added
    /// @throws AssetError if the folder has another study's files, if another StudyFolder holds it,
    ///     in whatever process, or if it cannot be written
    StudyFolder(std::filesystem::path folder, Study& study);

    const std::filesystem::path& path() const { return m_Path; }
    bool Has(const CellId& id) const { return m_Names.contains(id.Name()); }
    /// Writes the cell; it is there, whatever happens afterwards, when this returns.
    /// @throws AssetError if it cannot be written
    void Add(CellResult cell);
    /// Writes study.json again: what was found out about the machine since.
    void Update();

private:
    std::filesystem::path m_Path;
    FileLock m_Lock;
    Study& m_Study;
    std::set<std::string> m_Names; ///< of the cells that are there
};

/// Parts of one study, put together: same scene, options, limn and device.
struct MergedStudy
{
    Study study;
    std::vector<std::string> missing; ///< planned cells that no part has
    std::vector<std::string> doubled; ///< cells that several parts have; the first one's stands
};

/// One for each scene, device, options and version of limn, in the order of the parts.
std::vector<MergedStudy> MergeStudies(std::span<const Study> parts);

/// Writes a merged study with its pictures into a folder of its own.
/// @param parts  folders that the pictures are copied from
/// @throws AssetError if the folder is a part, if it holds another study, cells that are not in
///     this one, or another picture of the same name, or if something cannot be written
void WriteMerged(const std::filesystem::path& folder, const Study& study,
                 std::span<const std::string> parts);

/// What two studies of the same cells say differently, a line each, what is measured apart
/// (Metric::isMeasured).
std::vector<std::string> CompareStudies(const Study& first, const Study& second);

/// All but the cells.
Json ToJson(const Study& study);
/// NaN and infinities are the strings "nan", "inf" and "-inf", which JSON has no numbers for.
Json ToJson(const CellResult& cell);

/// @param file  what errors call it
/// @throws AssetError with the line and the column of every problem
Study StudyFromJson(std::string_view text, const std::string& file);
/// @param lineNumber  of the line in the file
/// @throws AssetError with the line and the column of every problem
CellResult CellFromJson(std::string_view line, const std::string& file, int lineNumber);

} // namespace limn::study
