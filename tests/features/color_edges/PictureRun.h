#pragma once

#include "features/OutlineGpuReference.h"
#include "features/color_edges/FlatPicture.h"
#include "precision/DevicePrecision.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace limn::test
{

/// Draws a scene with one feature and gives the textures of the frame by name.
class PictureRun
{
public:
    PictureRun(const Scene& scene, const Camera& camera, int width, int height)
        : m_Pipeline(SharedDevice())
    {
        m_Request.scene = &scene;
        m_Request.camera = &camera;
        m_Request.width = width;
        m_Request.height = height;
    }

    template <typename Feature>
    Feature& Add(std::unique_ptr<Feature> feature)
    {
        return static_cast<Feature&>(m_Renderer.AddFeature(std::move(feature)));
    }
    void SetSamples(int count) { m_Pipeline.msaaSampleCount = count; }
    void SetLightLimit(int count) { m_Pipeline.maxAdditionalLightsCount = count; }
    void SetShadows(const ShadowSettings& shadows) { m_Pipeline.shadows = shadows; }

    /// @param leavesOut  whether the frame compiler may leave things out
    void Render(const VolumeStack* stack, bool leavesOut = false)
    {
        m_Request.volumeStack = stack;
        m_Request.alsoReadBack.clear();
        m_Request.compile.leavesOut = leavesOut;
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
        // The textures are known only now; the second frame keeps them readable.
        for (const CompiledRenderPass& pass : m_Result.frame->passes)
        {
            for (const auto& color : pass.colors)
            {
                const RTHandle handle(color.texture);
                const bool isKnown = std::ranges::count(m_Request.alsoReadBack, handle) > 0;
                if (handle != m_Result.output && !isKnown)
                {
                    m_Request.alsoReadBack.push_back(handle);
                }
            }
        }
        m_Result = m_Pipeline.RenderSingleCamera(m_Renderer, m_Request);
    }

    /// The camera's colour, linear, as the last Render left it.
    Field Color() { return Texture("_CameraColorAttachmentA"); }
    Field Color(const VolumeStack* stack)
    {
        Render(stack);
        return Color();
    }

    /// The same with the rows as the texture stores them, for references that go by texture
    /// coordinates.
    Field ColorRows(const VolumeStack* stack)
    {
        Render(stack);
        return Rows("_CameraColorAttachmentA");
    }
    Field Rows(const std::string& name)
    {
        Image image = Read(name);
        image.texels = FlipRows(image.texels, image.height);
        return ToField(image);
    }

    Field Texture(const std::string& name) { return ToField(Read(name)); }
    Image Read(const std::string& name)
    {
        for (const RTHandle& handle : m_Request.alsoReadBack)
        {
            if (handle.rt()->name() == name)
            {
                return SharedDevice().ReadBack(*handle.rt());
            }
        }
        throw std::runtime_error("no texture " + name + " in the frame");
    }

    const RenderResult& result() const { return m_Result; }

private:
    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{Compiler()};
    RenderRequest m_Request;
    RenderResult m_Result;
};

/// The share of pixels of which every component is within 2/255 of what a reference says.
inline double ShareWithinTwo(const Field& picture, const Field& reference)
{
    if (picture.values.size() != reference.values.size() || picture.values.empty())
    {
        throw std::invalid_argument("ShareWithinTwo: the fields have different sizes or none");
    }
    int within = 0;
    for (int y = 0; y < picture.height; ++y)
    {
        for (int x = 0; x < picture.width; ++x)
        {
            bool isNear = true;
            for (int channel = 0; channel < picture.channels; ++channel)
            {
                const double distance =
                    std::abs(picture.At(x, y, channel) - reference.At(x, y, channel));
                isNear = isNear && distance <= 2.0 / 255.0;
            }
            within += isNear ? 1 : 0;
        }
    }
    return static_cast<double>(within) / (picture.width * picture.height);
}

/// The least and the largest that a reference says of each pixel, wherever the device's rounding of
/// corners (SubPixel()) puts what it draws.
struct FieldRange
{
    Field low;
    Field high;
};

/// @param reference  the picture if all that is drawn is moved so far, in pixels
inline FieldRange RangeOf(const std::function<Field(const glm::dvec2& move)>& reference)
{
    FieldRange range;
    for (const glm::dvec2& move : MovedPlaces())
    {
        const Field field = reference(move);
        if (range.low.values.empty())
        {
            range = {field, field};
        }
        for (std::size_t i = 0; i < field.values.size(); ++i)
        {
            range.low.values[i] = std::min(range.low.values[i], field.values[i]);
            range.high.values[i] = std::max(range.high.values[i], field.values[i]);
        }
    }
    return range;
}

/// A picture's values, each where it lies outside of a range moved to the range's nearer end.
inline Field MovedInto(const FieldRange& range, Field picture)
{
    for (std::size_t i = 0; i < picture.values.size(); ++i)
    {
        picture.values[i] =
            std::clamp(picture.values[i], range.low.values.at(i), range.high.values.at(i));
    }
    return picture;
}

/// The share of pixels of which every component is within 2/255 of a range.
inline double ShareWithinTwo(const Field& picture, const FieldRange& range)
{
    return ShareWithinTwo(picture, MovedInto(range, picture));
}

/// How many pixels differ at all.
inline int CountDifferent(const Field& a, const Field& b)
{
    int count = 0;
    for (int y = 0; y < a.height; ++y)
    {
        for (int x = 0; x < a.width; ++x)
        {
            bool differs = false;
            for (int channel = 0; channel < a.channels; ++channel)
            {
                differs = differs || a.At(x, y, channel) != b.At(x, y, channel);
            }
            count += differs ? 1 : 0;
        }
    }
    return count;
}

/// The largest difference of two pictures of 16-bit floats, in steps of such a float at the larger
/// of the two values.
inline double LargestDifferenceInHalfSteps(const Field& a, const Field& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
    {
        const double value = std::max(std::abs(a.values[i]), std::abs(b.values[i]));
        const double step = std::exp2(std::max(std::floor(std::log2(value)), -14.0) - 10.0);
        largest = std::max(largest, std::abs(a.values[i] - b.values[i]) / step);
    }
    return largest;
}

} // namespace limn::test
