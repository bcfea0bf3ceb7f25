#pragma once

#include "console/Json.h"

#include <array>
#include <functional>
#include <limn/core/Image.h>
#include <limn/core/Judge.h>
#include <limn/editor_stub/SceneFile.h>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

class VulkanDevice;

/// The fate of one thing that a pass did at a pixel. Those from Scissor to Depth are in the order
/// in which a device tries them.
enum class PixelFate
{
    Cleared,
    Drawn,      ///< it changed the colour, or the depth of a pass without colours
    Dispatched, ///< a kernel changed the texel
    Scissor,
    Culled,
    Discarded, ///< discarded by the shader, or by AlphaToMask
    Stencil,
    Depth,
    ColorMask,
    OutOfReach, ///< for a full-screen pass: all that it reads there is empty
    Blend,      ///< blending left the old value as it was
    Same        ///< it wrote the value that was there
};

/// Returns the fate as a word for programs: "drawn", "depth" ...
const char* ToString(PixelFate fate);

/// A texture's texel at the pixel's place.
struct PixelValue
{
    std::string texture;
    int x = 0; ///< the texel, from the top left of the picture
    int y = 0;
    int width = 0; ///< of the texture
    int height = 0;
    std::vector<float> before; ///< components as shaders see them; empty = nothing yet
    std::vector<float> after;

    bool isChanged() const;
};

/// A clear, draw or dispatch that reaches the pixel.
struct PixelEvent
{
    PixelFate fate = PixelFate::Drawn;
    std::string pass; ///< the innermost sample that it was recorded in
    /// The drawn objects; none if it draws no object of the scene.
    std::vector<std::string> objects;
    std::string mesh;           ///< "" = none
    std::string material;       ///< "" = not known
    std::string shader;         ///< "" for a clear
    int shaderPass = 0;         ///< index of the pass or the kernel
    std::string shaderPassName; ///< "" if it has none
    std::string reason;         ///< why it was rejected, a clause: "it is behind what is there"
    bool isRun = true; ///< false if the frame leaves it out, which does not change the picture
    std::vector<PixelValue> colors;
    std::optional<PixelValue> depth;   ///< one component, 1 = near
    std::optional<PixelValue> stencil; ///< one component
};

/// An object that a pass's filter leaves out, though it covers the pixel.
struct PixelFiltered
{
    std::string object;
    std::string pass;
    FilterVerdict verdict = FilterVerdict::Drawn;
};

/// An object that no pass draws.
struct PixelAbsent
{
    std::string object;
    std::string reason;
    bool isHere = false; ///< true if it would be seen at the pixel, or behind what is seen there
};

/// Draws without an object, all of one kind, that do not cover the pixel.
struct PixelUncovered
{
    std::string pass;
    std::string shader;
    std::string shaderPassName; ///< "" if it has none
    int count = 0;
};

/// A pass into a texture whose layout is not that of the picture: it has another shape, or is seen
/// from a light.
struct PixelElsewhere
{
    std::string pass;
    std::string texture;
    std::string size;
};

/// Everything that passes do at one pixel of the picture, and everything that they leave out there.
struct PixelHistory
{
    int x = 0; ///< from the top left of the picture
    int y = 0;
    int width = 0; ///< of the picture
    int height = 0;
    std::vector<float> color;       ///< the final colour, linear
    std::array<int, 3> written{};   ///< red, green and blue of the PNG
    std::vector<PixelEvent> events; ///< in the order of the frame
    std::vector<PixelFiltered> filtered;
    std::vector<PixelAbsent> absent;
    std::vector<std::string> uncovered; ///< objects that are drawn, but not over the pixel
    std::vector<PixelUncovered> uncoveredDraws;
    std::vector<PixelElsewhere> elsewhere;
    std::vector<std::string> notes; ///< notes of rendering, for the user
};

/// Draws the scene and finds out what became of each draw at one of its pixels. For this it draws
/// parts of the frame again, at that pixel, with one test at a time switched off.
/// @param x, y      the pixel, from the top left of the picture
/// @param progress  receives what is being looked at: a pass, its number and how many there are
/// @throws AssetError for a shader with errors
/// @throws VulkanError
/// @pre the pixel lies in the picture
PixelHistory TracePixel(SceneAsset asset, const AssetContext& assets, VulkanDevice& device, int x,
                        int y, const std::function<void(const std::string&)>& progress = nullptr);

/// Returns the components of a texel as shaders see them, red first: linear, integers as they are.
/// Depth is one component.
/// @param texel  BytesPerTexel(format) bytes
std::vector<float> TexelValue(std::span<const std::byte> texel, GraphicsFormat format);

/// Returns the bytes of one texel of an image.
/// @param x, y      from the top left
std::vector<std::byte> TexelAt(const Image& image, int x, int y);

/// Returns the history as text for a person, in lines of about 80 columns.
/// @param isLong  also names what does not cover the pixel
std::string PixelText(const PixelHistory& history, bool isLong);

/// Returns the whole history as JSON for programs.
Json PixelJson(const PixelHistory& history);

} // namespace limn
