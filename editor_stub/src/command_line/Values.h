#pragma once

#include "selection/SceneSelection.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace limn
{

// Functions for Flag::store, which store a value and return what is wrong with it.

using StoreValue = std::function<std::string(const std::string&)>;
/// Returns what is wrong with a text, or "" if nothing is.
using CheckText = std::string (*)(const std::string& text);

/// Returns a function that stores the text; for a bool, that the flag is there; for a list, each
/// text.
template <typename Kept>
StoreValue Into(Kept& kept, CheckText check = nullptr)
{
    return [&kept, check](const std::string& text)
    {
        if constexpr (std::is_same_v<Kept, std::vector<std::string>>)
        {
            kept.push_back(text);
        }
        else if constexpr (std::is_same_v<Kept, bool>)
        {
            kept = true;
        }
        else
        {
            kept = text;
        }
        return check ? check(text) : std::string();
    };
}

StoreValue IntoNumber(int& number, int most); ///< from 1 to `most`
StoreValue IntoSize(int& width, int& height);
StoreValue IntoTime(double& seconds);                       ///< a time that a shader's float holds
StoreValue IntoBudget(std::optional<double>& milliseconds); ///< above 0
StoreValue IntoPart(int& index, int& count);                ///< "I/N"
StoreValue IntoWords(std::vector<std::string>& words);      ///< "A,B"
/// Stores folders by the names of packages: `NAME=DIR`, or a folder that is a package or holds
/// some.
StoreValue IntoPackages(std::map<std::string, std::string>& packages);
StoreValue IntoSelection(std::vector<SelectionStep>& steps, SelectionStep::Kind kind);

std::string CheckOutput(const std::string& text);         ///< the name of a file or folder
std::string CheckFolder(const std::string& text);         ///< not stdout
std::string CheckPicture(const std::string& text);        ///< a PNG
std::string CheckWatchedPicture(const std::string& text); ///< not stdout
std::string CheckGraph(const std::string& text);
std::string CheckPixel(const std::string& text);
std::string CheckAssignment(const std::string& text);

} // namespace limn
