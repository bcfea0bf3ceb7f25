#pragma once

#include <filesystem>
#include <limn/volume/VolumeComponentRegistry.h>
#include <limn/volume/YamlNode.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// "NAME.group.value" taken apart: the one form of `--set`, `limn set` and what messages call a
/// value. NAME is a volume component's type, a feature's name or a feature's type; the keys are
/// those that lead to the value in a file.
struct ValuePath
{
    std::string name;
    std::vector<std::string> keys; ///< never empty

    /// @param names  those that there are, which may have dots themselves: the longest that the
    ///     text begins with is its name; the first dot ends any other
    /// @throws ContractError if the text has no dot within it
    static ValuePath Split(std::string_view text, const std::vector<std::string_view>& names);

    std::string KeysText() const; ///< "group.value"
    /// The keys with a value behind them, as if they stood in a file: `group: {value: 3}`.
    YamlNode AsMap(YamlNode value) const;
};

/// "NAME.group.value=VALUE", as a person types it; "+=", "-=" and "*=" change a number.
struct ValueAssignment
{
    std::string path;  ///< "NAME.group.value"
    std::string value; ///< YAML; a colour's # needs no quotes, nothing is empty text
    char sign = '=';   ///< '+', '-' or '*' where the value is added, subtracted or multiplied

    /// Returns the new value of what the path names, on one line.
    /// @param current  what it is now, as VolumeParameter::ValueText
    /// @param member   the channel or axis that changes alone, "r"; "" for the whole value
    /// @throws AssetError about the assignment as `file` where a sign stands before what is no
    ///     number
    std::string NewValue(const std::string& current, const std::string& member,
                         const std::string& file) const;

    /// @throws AssetError about the text as `file` if it has another form
    static ValueAssignment Parse(std::string_view text, const std::string& file);
    /// What is wrong with the form of the text, whatever there is of these names; "" if nothing.
    static std::string FormProblem(std::string_view text);

    std::string Text() const; ///< as it was typed
};

/// Returns the channels or axes of a value, "r", "g", "b", "a"; empty for any other value.
/// @param valueText  as VolumeParameter::ValueText
std::vector<std::string> MembersOfValue(const std::string& valueText);

/// A value that a person typed.
/// @throws AssetError as ParseYaml
YamlNode ParseTypedValue(const std::string& value, const std::string& file);

/// What an edit did, values as VolumeParameter::ValueText.
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

/// The text of a profile file, of limn's or of Unity's form, with new values. Only the characters
/// of scalars that change are others: a colour stays a map, a list or "#RRGGBB" as it was
/// (written as a map where eight bits do not hold it). A list or map in brackets on one line, as of
/// a curve, is replaced whole where it changes its length, and a value left empty is filled in.
/// What a file of limn's form lacks is added as a line, spelt and indented as the lines beside it.
/// In Unity's form m_OverrideState stays. A path leads to a component's `active`, to a parameter
/// or, by several keys, to one within ObjectParameters or to one number of a colour or vector.
/// @throws AssetError with every problem: an unknown name, a value of the wrong type or outside its
///     range, a parameter that a file of Unity's does not have, a value written in a way that
///     cannot hold the new one or that an alias repeats, and whatever else is wrong with the file
/// @param changes  if given, what each edit did is added to it
std::string EditVolumeProfile(std::string_view text, const std::string& file,
                              std::span<const ValueAssignment> edits,
                              const VolumeComponentRegistry& registry,
                              std::vector<ScalarChange>* changes = nullptr);

/// EditVolumeProfile of a file, which is replaced whole or not at all. Of calls for one file at the
/// same time, in this process or in others, each sees what the one before wrote.
/// @param written  if given, it receives the file's text before and after
/// @return what each edit did
/// @throws AssetError as EditVolumeProfile and ReplaceContent do; the file is then as it was
std::vector<ScalarChange> SetScalars(const std::filesystem::path& path,
                                     std::span<const ValueAssignment> edits,
                                     const VolumeComponentRegistry& registry,
                                     FileEdit* written = nullptr);

/// Replaces a file's content, through a link the file behind it, if it still is `expected`.
/// @throws AssetError if it is something else by now, or cannot be written; the file is then as it
///     was, and nothing is left beside it
void ReplaceContent(const std::filesystem::path& path, std::string_view expected,
                    std::string_view content);

} // namespace limn
