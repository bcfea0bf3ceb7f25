#pragma once

#include "commands/Commands.h"

#include <string>
#include <vector>

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

} // namespace limn
