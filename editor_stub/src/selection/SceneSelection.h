#pragma once

#include <limn/editor_stub/SceneFile.h>
#include <optional>
#include <span>
#include <string>

namespace limn
{

/// One of --select, --click and --ctrl-click.
struct SelectionStep
{
    enum class Kind
    {
        Select,
        Click,
        CtrlClick
    };

    Kind kind = Kind::Select;
    std::string text; ///< names of objects, or as ParseClick takes it
};

/// "X,Y" or "X,Y@SECONDS".
struct ClickText
{
    int x = 0; ///< from the left of the picture
    int y = 0; ///< from its top
    double time = 0.0;
};

/// Nothing if the text is no click.
std::optional<ClickText> ParseClick(const std::string& text);
/// What is wrong with the place in a picture of this size; "" if nothing.
std::string PixelProblem(const ClickText& click, int width, int height);

/// Does the steps one after another: what is selected at the end is in the rendering layers by
/// which the scene's features know selected objects, and in `asset.selected`. A click that hits
/// nothing that can be selected becomes a note, with the reason.
/// @throws AssetError if no object has a name, a pixel lies outside of the picture, or no feature
///     would show a selection
void ApplySelection(SceneAsset& asset, std::span<const SelectionStep> steps);

} // namespace limn
