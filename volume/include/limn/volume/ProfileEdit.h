#pragma once

#include <filesystem>
#include <functional>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/YamlNode.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The parts of "NAME.group.value", the form in which `--set`, `limn set` and messages name a
/// value. NAME is a volume component's type, a feature's name or a feature's type; the keys lead to
/// the value in a file.
struct ValuePath
{
    std::string name;
    std::vector<std::string> keys; ///< never empty

    /// @param names  the known names, which may contain dots. The longest one that the text begins
    ///     with is its name; any other name ends at the first dot
    /// @throws ContractError if the text has no dot within it
    static ValuePath Split(std::string_view text, const std::vector<std::string_view>& names);

    std::string KeysText() const; ///< "group.value"
    /// Returns the keys and the value as a file would contain them: `group: {value: 3}`.
    YamlNode AsMap(YamlNode value) const;
};

/// "NAME.group.value=VALUE", as a person types it; "+=", "-=" and "*=" change a number.
struct ValueAssignment
{
    std::string path; ///< "NAME.group.value"
    /// YAML; the # of a colour needs no quotes, and nothing stands for empty text.
    std::string value;
    char sign = '='; ///< '+', '-' or '*' where the value is added, subtracted or multiplied

    /// Returns the new value of the setting that the path names, on one line.
    /// @param current  its present value, as VolumeParameter::ValueText returns it
    /// @param member   the channel or axis to change, for example "r"; "" changes the whole value
    /// @throws AssetError with `file` as its file if a sign stands before something that is no
    ///     number
    std::string NewValue(const std::string& current, const std::string& member,
                         const std::string& file) const;

    /// @throws AssetError with `file` as its file if the text has another form
    static ValueAssignment Parse(std::string_view text, const std::string& file);
    /// Returns what is wrong with the form of the text, or "" if nothing is. It does not look at
    /// whether the names exist.
    static std::string FormProblem(std::string_view text);

    std::string Text() const; ///< as it was typed
};

/// Returns the channels or axes of a value, "r", "g", "b", "a"; empty for any other value.
/// @param valueText  a value as VolumeParameter::ValueText returns it
std::vector<std::string> MembersOfValue(const std::string& valueText);

/// Parses a value that a person typed.
/// @throws AssetError as ParseYaml
YamlNode ParseTypedValue(const std::string& value, const std::string& file);

/// The change that one edit made; the values are written as VolumeParameter::ValueText does.
struct ScalarChange
{
    std::string subject; ///< "ScreenSpaceOutline.m_OutlineWidth"
    std::string before;  ///< "not set" where the file did not have the value
    std::string after;   ///< equal to `before` where the file stays as it is
};

/// A file's text before and after an edit; both are "" where the file stayed as it was.
struct FileEdit
{
    std::string before;
    std::string after;
};

/// Returns the text of a profile file, in limn's or in Unity's form, with new values. Only the
/// characters of changed scalars differ: a colour stays a map, a list or "#RRGGBB" as it was (but
/// is written as a map where eight bits do not hold it). A list or map in brackets on one line, for
/// example of a curve, is replaced whole if its length changes, and an empty value is filled in. If
/// a file of limn's form lacks the key, a line is added that is spelt and indented like the lines
/// beside it. In Unity's form m_OverrideState stays. A path leads to a component's `active`, to a
/// parameter or, by several keys, to one within ObjectParameters or to one number of a colour or
/// vector.
/// @throws AssetError with every problem: an unknown name, a value of the wrong type or outside its
///     range, a parameter that a file of Unity's does not have, a value written in a way that
///     cannot hold the new one or that an alias repeats, and whatever else is wrong with the file
/// @param changes  if given, receives what each edit did, behind what it already has
std::string EditVolumeProfile(std::string_view text, const std::string& file,
                              std::span<const ValueAssignment> edits,
                              const VolumeComponentRegistry& registry,
                              std::vector<ScalarChange>* changes = nullptr);

/// Applies EditVolumeProfile to a file, which is replaced whole or not at all. If several calls for
/// one file run at the same time, in this process or in others, each sees what the one before
/// wrote.
/// @param written  if given, it receives the file's text before and after
/// @return what each edit did
/// @throws AssetError as EditVolumeProfile and ReplaceContent do; the file is then as it was
std::vector<ScalarChange> SetScalars(const std::filesystem::path& path,
                                     std::span<const ValueAssignment> edits,
                                     const VolumeComponentRegistry& registry,
                                     FileEdit* written = nullptr);

/// Returns a file's text with one new value, and adds what was done to `changes`.
using TextEditor =
    std::function<std::string(const std::string& text, const std::string& file,
                              const ValueAssignment& edit, std::vector<ScalarChange>& changes)>;

/// Applies an editor to a file for each edit, as SetScalars does.
std::vector<ScalarChange> EditFile(const std::filesystem::path& path,
                                   std::span<const ValueAssignment> edits, const TextEditor& edit,
                                   FileEdit* written = nullptr);

/// Replaces the content of a file, or of the file behind a link, if it still is `expected`.
/// @throws AssetError if the content has changed since, or cannot be written; the file is then as
///     it was, and nothing is left beside it
void ReplaceContent(const std::filesystem::path& path, std::string_view expected,
                    std::string_view content);

} // namespace limn
