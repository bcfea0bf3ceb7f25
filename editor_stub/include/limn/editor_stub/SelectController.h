#pragma once

#include <limn/editor_stub/Raycast.h>
#include <span>
#include <vector>

namespace limn
{

/// An object that a person chose, with all that hangs below it.
struct Selected
{
    GameObject* object = nullptr; ///< never null
    double time = 0.0;            ///< when, seconds

    bool operator==(const Selected&) const = default;
};

/// What a click on a part of a whole selects.
enum class SelectUnit
{
    Whole, ///< the topmost object that the part hangs below
    Part   ///< the part itself
};

struct SelectSettings
{
    /// Marks the selected: their renderers are in these rendering layers, all others are not.
    RenderingLayerMask renderingLayers;
    SelectUnit unit = SelectUnit::Whole;
    /// What a click can hit and what hides what is behind it; objects outside of the camera's
    /// culling mask or its clip planes are not hit whatever it says.
    RaycastSettings raycast;
    /// A click on an object in no such layer is one on nothing, as on the article's ground, though
    /// the object hides what is behind it.
    LayerMask selectableLayers = LayerMask::Everything();
};

/// What is selected in a scene, by clicks as in Unity's editor: one selects what is seen there and
/// nothing else, one with Ctrl adds it or takes it away, one on nothing, with Ctrl as well, leaves
/// nothing selected.
/// @source SelectController of the article on outlines of selected objects (Unity)
class SelectController
{
public:
    /// What the scene has in the rendering layers already is selected, since time 0: the topmost
    /// objects all of whose renderers are.
    /// @lifetime  keeps `scene` by reference
    SelectController(Scene& scene, SelectSettings settings);

    /// A mouse button goes up over a pixel.
    /// @param x, y  column and row from the top left of the picture
    /// @throws ContractError as PixelToRay
    void Click(const Camera& camera, int width, int height, int x, int y, bool isCtrl, double time);
    /// The same for what GetHitObj gave; null is nothing.
    void Click(GameObject* hit, bool isCtrl, double time);
    /// What a click on this pixel would select; null for nothing.
    GameObject* GetHitObj(const Camera& camera, int width, int height, int x, int y);
    /// What is seen there, whether it can be selected or not.
    std::optional<RaycastHit> Raycast(const Camera& camera, int width, int height, int x, int y);

    /// Selects exactly these, each once. Those that were selected remember since when.
    void Select(std::span<GameObject* const> objects, double time);

    /// In the order in which they were selected. One that a click without Ctrl selects again keeps
    /// its time; one that was not selected meanwhile has a new one.
    const std::vector<Selected>& selected() const { return m_Targets; }

private:
    GameObject* WholeOf(GameObject& part) const;
    void AdoptMarked();
    void DrawOutline();

    Scene& m_Scene;
    SelectSettings m_Settings;
    Raycaster m_Raycaster;
    std::vector<Selected> m_Targets;
};

} // namespace limn
