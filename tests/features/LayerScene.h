#pragma once

#include "features/StencilModel.h"
#include "features/TranslucentScene.h"

#include <algorithm>
#include <random>

namespace limn::test
{

inline constexpr int k_Size = 64; // pixels, and metres of the orthographic view
inline constexpr double k_Width =
    0.125; // in this view the article's hull is k_Width * distance wide

inline const glm::dvec4 k_BandColor{0.0, 1.0, 0.0, 0.5};
inline const glm::dvec4 k_SolidColor{1.0, 0.0, 0.5, 0.5};
inline const glm::dvec4 k_OccluderColor{0.0, 0.0, 1.0, 1.0};
inline const glm::dvec4 k_BehindColor{0.0, 0.0, 1.0, 0.5};
inline const glm::dvec4 k_InFrontColor{1.0, 1.0, 0.0, 0.5};
inline constexpr double k_OccluderDistance = 19.25;

/// A flat convex shape with a front and a back, metres around the middle of the picture, y up; what
/// the hull moves its corners by for each metre of width.
struct Layer
{
    std::vector<glm::dvec2> corners; ///< counter-clockwise in this system
    std::vector<glm::dvec2> normals; ///< unit length, in the plane
    double front = 0.0;              ///< distance
    double back = 0.0;
};

inline Layer MakeLayer(int index, std::mt19937& random)
{
    const auto number = [&](int low, int high)
    {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    // Sixteenths of a pixel: many edges run through pixel centres.
    const glm::dvec2 middle(number(-80, 80) / 16.0, number(-80, 80) / 16.0);
    const glm::dvec2 half(number(40, 160) / 16.0, number(40, 160) / 16.0);
    Layer layer;
    layer.front = 16.0 + index;
    layer.back = 16.5 + index;
    if (index % 2 == 0)
    {
        layer.normals = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        layer.corners = {{half.x, 0}, {0, half.y}, {-half.x, 0}, {0, -half.y}};
    }
    else
    {
        layer.normals = {{0.6, 0.8}, {-0.6, 0.8}, {-0.6, -0.8}, {0.6, -0.8}};
        layer.corners = {half, {-half.x, half.y}, -half, {half.x, -half.y}};
    }
    for (glm::dvec2& corner : layer.corners)
    {
        corner += middle;
    }
    return layer;
}

/// The triangles of one side of a layer, as the picture shows them.
inline std::vector<FlatTriangle> Flat(const Layer& layer, double distance, double hullWidth)
{
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < layer.corners.size(); ++i)
    {
        const glm::dvec2 p = layer.corners[i] + hullWidth * layer.normals[i];
        points.emplace_back(k_Size / 2 + p.x, k_Size / 2 - p.y);
    }
    return {{{points[0], points[1], points[2]}, distance},
            {{points[0], points[2], points[3]}, distance}};
}

inline std::vector<FlatTriangle> Fronts(const Layer& layer)
{
    return Flat(layer, layer.front, 0.0);
}

inline std::vector<FlatTriangle> Hull(const Layer& layer)
{
    return Flat(layer, layer.back, k_Width * layer.back);
}

/// All layers as one mesh, its triangles in any order.
inline std::shared_ptr<const Mesh> MeshOf(const std::vector<Layer>& layers, std::mt19937& random)
{
    MeshData data;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Layer& layer : layers)
    {
        for (const bool isFront : {true, false})
        {
            const auto first = static_cast<std::uint32_t>(data.vertices.size());
            for (std::size_t i = 0; i < layer.corners.size(); ++i)
            {
                data.vertices.emplace_back(layer.corners[i].x, layer.corners[i].y,
                                           isFront ? layer.front : layer.back);
                data.normals.emplace_back(layer.normals[i].x, layer.normals[i].y, 0.0);
            }
            // Counter-clockwise corners seen from the camera are a back face.
            const std::uint32_t b = first + (isFront ? 2 : 1);
            const std::uint32_t c = first + (isFront ? 1 : 2);
            triangles.push_back({first, b, c});
            triangles.push_back({first, b + 1, c + 1});
        }
    }
    for (std::size_t i = triangles.size(); i > 1; --i)
    {
        std::swap(triangles[i - 1], triangles[random() % i]);
    }
    for (const auto& triangle : triangles)
    {
        data.triangles.insert(data.triangles.end(), triangle.begin(), triangle.end());
    }
    return std::make_shared<const Mesh>("layers", std::move(data));
}

/// A rectangle that faces the camera, in metres.
inline std::shared_ptr<const Mesh> Rectangle(const glm::dvec2& low, const glm::dvec2& high)
{
    MeshData data;
    data.vertices = {
        {low.x, low.y, 0}, {low.x, high.y, 0}, {high.x, high.y, 0}, {high.x, low.y, 0}};
    data.triangles = {0, 1, 2, 0, 2, 3};
    return std::make_shared<const Mesh>("rectangle", std::move(data));
}

inline std::vector<FlatTriangle> FlatRectangle(const glm::dvec2& low, const glm::dvec2& high,
                                               double distance)
{
    const double middle = k_Size / 2;
    const glm::dvec2 a(middle + low.x, middle - low.y);
    const glm::dvec2 b(middle + low.x, middle - high.y);
    const glm::dvec2 c(middle + high.x, middle - high.y);
    const glm::dvec2 d(middle + high.x, middle - low.y);
    return {{{a, b, c}, distance}, {{a, c, d}, distance}};
}

inline Color ToColor(const glm::dvec4& c)
{
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b),
            static_cast<float>(c.a)};
}

inline const glm::dvec2 k_OccluderLow{4.5, -20};
inline const glm::dvec2 k_OccluderHigh{31, 2.5};
inline const glm::dvec2 k_BehindLow{-28, -9};
inline const glm::dvec2 k_BehindHigh{3, 26.5};
inline const glm::dvec2 k_InFrontLow{-6.5, -27};
inline const glm::dvec2 k_InFrontHigh{17, -3};

/// The body of these layers between two other transparent rectangles, an opaque one through it.
struct LayerScene : TranslucentScene
{
    LayerScene(const EffectShaders& shaders, std::shared_ptr<const Mesh> mesh)
        : TranslucentScene(shaders)
    {
        camera.orthographic = true;
        camera.orthographicSize = k_Size / 2.0f;
        camera.nearClipPlane = 1.0f;
        camera.farClipPlane = 65.0f;
        outline->SetFloat(ShaderPropertyId("_OutlineWidth"), static_cast<float>(k_Width));
        outline->SetColor(ShaderPropertyId("_OutlineColor"), ToColor(k_BandColor));
        solid->SetColor(ShaderPropertyId("_Color"), ToColor(k_SolidColor));
        const auto opaque = TranslucentUnlit(ToColor(k_OccluderColor));
        opaque->SetFloat(ShaderPropertyId("_ZWrite"), 1);
        opaque->SetRenderQueue(2000);
        Add(Rectangle(k_InFrontLow, k_InFrontHigh), {0, 0, 2},
            {TranslucentUnlit(ToColor(k_InFrontColor))});
        body = &AddBody(std::move(mesh), {0, 0, 0});
        Add(Rectangle(k_BehindLow, k_BehindHigh), {0, 0, 60},
            {TranslucentUnlit(ToColor(k_BehindColor))});
        Add(Rectangle(k_OccluderLow, k_OccluderHigh),
            {0, 0, static_cast<float>(k_OccluderDistance)}, {opaque});
    }

    GameObject* body;
};

enum class Moment
{
    AfterMasks,
    AfterAll
};

inline StencilModel Predict(const std::vector<Layer>& layers, Moment moment)
{
    StencilModel model(k_Size, k_Size, glm::dvec4(0.0));
    const auto each = [](const std::vector<FlatTriangle>& triangles, auto&& draw)
    {
        std::for_each(triangles.begin(), triangles.end(), draw);
    };
    const auto forAll = [&](auto&& trianglesOf, auto&& draw)
    {
        for (const Layer& layer : layers)
        {
            each(trianglesOf(layer), draw);
        }
    };
    each(FlatRectangle(k_OccluderLow, k_OccluderHigh, k_OccluderDistance),
         [&](const FlatTriangle& t) { model.DrawOpaque(t, k_OccluderColor); });
    forAll(Hull, [&](const FlatTriangle& t) { model.MaskHull(t); });
    forAll(Fronts, [&](const FlatTriangle& t) { model.MaskSolid(t); });
    if (moment == Moment::AfterMasks)
    {
        return model;
    }
    each(FlatRectangle(k_BehindLow, k_BehindHigh, 60.0),
         [&](const FlatTriangle& t) { model.DrawTransparent(t, k_BehindColor); });
    forAll(Hull, [&](const FlatTriangle& t) { model.DrawBand(t, k_BandColor); });
    forAll(Fronts, [&](const FlatTriangle& t) { model.DrawSolid(t, k_SolidColor); });
    each(FlatRectangle(k_InFrontLow, k_InFrontHigh, 2.0),
         [&](const FlatTriangle& t) { model.DrawTransparent(t, k_InFrontColor); });
    return model;
}

} // namespace limn::test
