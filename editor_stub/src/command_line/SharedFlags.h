#pragma once

#include "command_line/FlagTable.h"
#include "command_line/Values.h"
#include "commands/Commands.h"

namespace limn
{

// The words that can complete the word that a person has begun to type. The lists are empty where
// nothing is known; a shell then offers the names of files.

using Candidates = std::vector<std::string>;

/// Returns the files whose names begin as the word does and end in one of the endings, and the
/// folders, with '/' behind their names. Returns none for a word that begins with '~'.
/// @param endings  ".scene.yaml", ".unity"
Candidates FileCandidates(const std::string& word, const std::vector<std::string>& endings);

/// Returns names of components or features, with '.' behind them, or where the word has one of
/// them, its parameters or settings, with '=' behind them. Those of the file come first; where none
/// of them begins as the word does, all volume components that exist are offered.
/// @param file  a scene, a profile or a renderer, whose mistakes are passed over
Candidates SettingCandidates(const std::string& word, const InspectOptions& file);

/// Returns the names of the scene's objects, once each.
/// @throws AssetError
Candidates ObjectCandidates(const RenderOptions& scene);

/// Returns the names of the techniques that draw outlines.
/// @throws AssetError if a plug-in cannot be used
Candidates TechniqueCandidates(const std::vector<std::string>& plugins);

/// Returns the names of volume components, features and shaders, without those of plug-ins.
Candidates NameCandidates();

Candidates ComponentCandidates(); ///< the names of volume components

// Flags and arguments that several verbs have. They store into what they are given, which must
// outlive them.

using GetCandidates = decltype(Flag::candidates);

GetCandidates Files(std::vector<std::string> endings); ///< offers files with these endings
/// Offers files with these endings, and names that are no files'.
GetCandidates FilesOr(std::vector<std::string> endings, Candidates (*names)());
GetCandidates Objects(const RenderOptions& scene); ///< offers the names of the scene's objects

Flag Argument(const char* value, const char* help, StoreValue store, Times times = Times::Once,
              GetCandidates candidates = {});
Flag WithLetter(char letter, Flag flag); ///< the flag with a short spelling
Flag Switch(const char* name, const char* help, bool& isGiven, char letter = '\0');

Flag SceneArgument(std::string& scene);
Flag SceneFlag(RenderOptions& options);
Flag SizeFlag(RenderOptions& options);
Flag ProfileFlag(std::string& profile);
Flag SetFlag(RenderOptions& options);
Flag SelectFlag(RenderOptions& options);
Flag DeviceFlag(std::string& device);
Flag PluginFlag(std::vector<std::string>& plugins);
Flag PackageFlag(std::map<std::string, std::string>& packages);
Flag RootFlag(std::vector<std::string>& roots);
Flag NewFolderFlag(std::string& folder);

} // namespace limn
