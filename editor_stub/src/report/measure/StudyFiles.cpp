#include "report/measure/StudyFiles.h"

#include "console/CacheFolder.h"

#include <algorithm>
#include <array>
#include <limn/base/FileRoots.h>
#include <limn/base/ReadFile.h>
#include <limn/volume/AssetDiagnostics.h>

namespace limn::study
{

namespace
{

constexpr const char* k_Header = "study.json";
constexpr const char* k_Cells = "cells.jsonl";

/// Returns the facts in which all parts of one study agree.
std::vector<std::pair<const char*, std::string>> IdentityOf(const Study& study)
{
    return {{"scene", study.sceneHash},
            {"device", study.device},
            {"options", study.options},
            {"limn", study.limnVersion}};
}

Study ReadHeader(const std::filesystem::path& folder)
{
    const std::filesystem::path file = FileOfStudy(folder, k_Header);
    return StudyFromJson(ReadFile(file), file.string());
}

/// The cells whose lines are whole; `length` becomes that of these lines.
std::vector<CellResult> ReadCells(const std::filesystem::path& folder, std::size_t& length)
{
    length = 0;
    std::vector<CellResult> cells;
    const std::filesystem::path file = FileOfStudy(folder, k_Cells);
    if (!std::filesystem::exists(file))
    {
        return cells;
    }
    const std::string text = ReadFile(file);
    AssetDiagnostics diagnostics(file.string());
    int line = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', length))
    {
        try
        {
            const std::string_view whole = std::string_view(text).substr(length, end - length);
            cells.push_back(CellFromJson(whole, file.string(), ++line));
            for (const auto& [what, name] : cells.back().pictures)
            {
                FileOfStudy(folder, name);
            }
        }
        catch (const AssetError& error)
        {
            diagnostics.Add(error);
        }
        length = end + 1;
    }
    diagnostics.ThrowIfErrors();
    return cells;
}

std::string LineOf(const CellResult& cell)
{
    return ToJson(cell).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Copies a picture from the first part that has it.
void CopyPicture(std::span<const std::string> parts, const std::string& name,
                 const std::filesystem::path& folder)
{
    for (const std::filesystem::path part : parts)
    {
        const std::filesystem::path from = FileOfStudy(part, name);
        const std::filesystem::path to = FileOfStudy(folder, name);
        if (!std::filesystem::exists(from))
        {
            continue;
        }
        const std::string bytes = ReadFile(from, k_MaxDataBytes);
        if (!std::filesystem::exists(to))
        {
            std::filesystem::create_directories(to.parent_path());
            WriteFile(to, bytes);
        }
        else if (ReadFile(to, k_MaxDataBytes) != bytes)
        {
            throw AssetError(to.string(), {},
                             "the file is another picture than " + from.string() +
                                 " and is not overwritten; merge into a new folder");
        }
        return;
    }
}

/// Puts the cells in the order they were planned; unplanned ones last.
void Sort(Study& study)
{
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < study.planned.size(); ++i)
    {
        places.emplace(study.planned[i].Name(), i);
    }
    const auto place = [&places](const CellResult& cell)
    {
        const auto found = places.find(cell.id.Name());
        return found == places.end() ? places.size() : found->second;
    };
    std::ranges::stable_sort(study.cells, {}, place);
}

void RequireSameStudy(const std::filesystem::path& folder, const Study& there, const Study& wanted)
{
    const auto found = IdentityOf(there);
    const auto asked = IdentityOf(wanted);
    const auto [is, wish] = std::ranges::mismatch(
        found, asked, {}, [](const auto& fact) { return fact.second; },
        [](const auto& fact) { return fact.second; });
    if (is != found.end())
    {
        throw AssetError(FileOfStudy(folder, k_Header).string(), {},
                         std::string("the folder holds a study with another ") + wish->first +
                             " ('" + is->second + "', not '" + wish->second +
                             "'); name another folder, or remove this one");
    }
}

/// Makes the folder that a study is written into.
std::filesystem::path MakeStudyFolder(std::filesystem::path folder)
{
    if (const std::string problem = MakeFolder(folder); !problem.empty())
    {
        throw AssetError(folder.string(), {}, "the folder cannot be made: " + problem);
    }
    return folder;
}

void RequireNoPart(const std::filesystem::path& folder, std::span<const std::string> parts)
{
    for (const std::string& part : parts)
    {
        if (std::error_code ignored; std::filesystem::equivalent(part, folder, ignored))
        {
            throw AssetError(folder.string(), {},
                             "this is one of the folders that are merged; name a new folder");
        }
    }
}

/// Refuses a folder whose cells would be lost.
void RequireNoOtherCells(const std::filesystem::path& folder, const Study& there,
                         const Study& merged)
{
    const std::set<std::string> names = merged.MeasuredCells();
    for (const CellResult& cell : there.cells)
    {
        if (const std::string name = cell.id.Name(); !names.contains(name))
        {
            throw AssetError(folder.string(), {},
                             "the folder holds the cell " + name +
                                 ", which no folder that is merged has; name a new folder");
        }
    }
}

} // namespace

std::filesystem::path FileOfStudy(const std::filesystem::path& folder, const std::string& name)
{
    FileRoots roots;
    roots.Add(folder);
    if (!roots.Contains(folder / name))
    {
        throw AssetError((folder / name).string(), {},
                         "this is a link that leads out of the study's folder; put the file itself "
                         "there");
    }
    return folder / name;
}

Study ReadStudy(const std::filesystem::path& folder)
{
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored))
    {
        const bool isThere = std::filesystem::exists(folder, ignored);
        throw AssetError(folder.string(), {},
                         isThere ? "this is no folder; one that 'limn report' wrote is expected"
                                 : "there is no such folder");
    }
    Study study = ReadHeader(folder);
    std::size_t length = 0;
    study.cells = ReadCells(folder, length);
    Sort(study);
    return study;
}

StudyFolder::StudyFolder(std::filesystem::path folder, Study& study)
    : m_Path(MakeStudyFolder(std::move(folder))),
      m_Lock(m_Path / k_Header, std::try_to_lock),
      m_Study(study)
{
    if (m_Lock.isHeldElsewhere())
    {
        throw AssetError(
            m_Path.string(), {},
            "the folder is written by another limn now; wait until it has ended, or name "
            "another folder");
    }
    if (std::filesystem::exists(FileOfStudy(m_Path, k_Header)))
    {
        const Study there = ReadHeader(m_Path);
        RequireSameStudy(m_Path, there, study);
        study.started = there.started;
        study.loadAverage = there.loadAverage;
        study.copyBandwidth = there.copyBandwidth;
    }
    std::size_t length = 0;
    study.cells = ReadCells(m_Path, length);
    m_Names = study.MeasuredCells();
    if (std::filesystem::exists(FileOfStudy(m_Path, k_Cells)))
    {
        std::filesystem::resize_file(FileOfStudy(m_Path, k_Cells),
                                     length); // half a line of a killed run
    }
    Update();
}

void StudyFolder::Add(CellResult cell)
{
    AppendToFile(FileOfStudy(m_Path, k_Cells), LineOf(cell));
    m_Names.insert(cell.id.Name());
    m_Study.cells.push_back(std::move(cell));
}

void StudyFolder::Update()
{
    WriteFile(FileOfStudy(m_Path, k_Header), JsonText(ToJson(m_Study)));
    Sort(m_Study);
}

std::vector<MergedStudy> MergeStudies(std::span<const Study> parts)
{
    std::vector<MergedStudy> merged;
    std::vector<std::set<std::string>> names; // of the cells of each
    for (const Study& part : parts)
    {
        auto found = std::ranges::find_if(merged, [&part](const MergedStudy& other)
                                          { return IdentityOf(other.study) == IdentityOf(part); });
        if (found == merged.end())
        {
            found = merged.insert(merged.end(), {part, {}, {}});
            found->study.cells.clear();
            names.emplace_back();
        }
        std::set<std::string>& known = names[static_cast<std::size_t>(found - merged.begin())];
        Study& whole = found->study;
        whole.started = std::min(whole.started, part.started);
        whole.loadAverage = std::max(whole.loadAverage, part.loadAverage);
        whole.copyBandwidth = std::max(whole.copyBandwidth, part.copyBandwidth);
        for (const CellResult& cell : part.cells)
        {
            if (const auto [name, isNew] = known.insert(cell.id.Name()); isNew)
            {
                whole.cells.push_back(cell);
            }
            else
            {
                found->doubled.push_back(*name);
            }
        }
    }
    for (MergedStudy& whole : merged)
    {
        Sort(whole.study);
        whole.missing = whole.study.MissingCells();
    }
    return merged;
}

void WriteMerged(const std::filesystem::path& folder, const Study& study,
                 std::span<const std::string> parts)
{
    RequireNoPart(folder, parts);
    Study header = study;
    header.cells.clear();
    StudyFolder target(folder, header);
    RequireNoOtherCells(folder, header, study);
    std::string lines;
    for (const CellResult& cell : study.cells)
    {
        lines += LineOf(cell);
        for (const auto& [what, name] : cell.pictures)
        {
            CopyPicture(parts, name, folder);
        }
    }
    WriteFile(FileOfStudy(folder, k_Cells), lines);
}

std::vector<std::string> CompareStudies(const Study& first, const Study& second)
{
    const auto isMeasured = [](const auto& entry)
    {
        return std::ranges::any_of(Metrics(), [&entry](const Metric& metric)
                                   { return metric.key == entry.first && metric.isMeasured; });
    };
    std::map<std::string, std::array<Json, 2>> cells; // by name, of either study
    for (const Study* study : {&first, &second})
    {
        for (CellResult cell : study->cells)
        {
            std::erase_if(cell.values, isMeasured);
            std::erase_if(cell.quartiles, isMeasured);
            cells[cell.id.Name()][study == &first ? 0 : 1] = ToJson(cell);
        }
    }
    std::vector<std::string> differences;
    std::vector<std::string> onlyInSecond;
    for (const auto& [name, sides] : cells)
    {
        const auto& [a, b] = sides;
        if (a.is_null())
        {
            onlyInSecond.push_back(name + ": only in the second");
        }
        else if (b.is_null())
        {
            differences.push_back(name + ": only in the first");
        }
        else if (a != b)
        {
            differences.push_back(name + ": " + a.dump() + " against " + b.dump());
        }
    }
    differences.insert(differences.end(), onlyInSecond.begin(), onlyInSecond.end());
    return differences;
}

} // namespace limn::study
