#pragma once

#include "features/color_edges/PictureRun.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn::test
{

/// A material whose picture is what GetMainLight says of shadows, and which throws them.
/// @param light     HLSL of a Light from positionWS
/// @param fallback  the shader whose ShadowCaster it has; "" = that of URP's Lit
inline std::shared_ptr<Material>
Attenuation(const std::string& light = "GetMainLight(TransformWorldToShadowCoord(positionWS))",
            const std::shared_ptr<ShaderCompiler>& compiler = Compiler(),
            const std::string& fallback = "")
{
    const std::string text =
        "Shader \"Test/Attenuation\" { Properties { _Cull (\"Culled\", Float) = 2 } SubShader {\n" +
        std::string(fallback.empty() ? "UsePass \"Universal Render Pipeline/Lit/SHADOWCASTER\"\n"
                                     : "") +
        "Pass { Tags { \"LightMode\" = \"UniversalForward\" }\n"
        "HLSLPROGRAM\n"
        "#pragma vertex Vert\n#pragma fragment Frag\n"
        "#pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE\n"
        "#pragma multi_compile _ _ADDITIONAL_LIGHT_SHADOWS\n"
        "#pragma multi_compile _ _SHADOWS_SOFT\n"
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl\"\n"
        "struct V { float4 p : SV_POSITION; float3 world : TEXCOORD0; };\n"
        "V Vert(float4 p : POSITION) { V o; o.world = TransformObjectToWorld(p.xyz);\n"
        "o.p = TransformObjectToHClip(p.xyz); return o; }\n"
        "float4 Frag(V i) : SV_Target { float3 positionWS = i.world; Light light = " +
        light +
        ";\nreturn float4(light.shadowAttenuation.xxx, 1); }\n"
        "ENDHLSL\n} }\n" +
        (fallback.empty() ? "" : "Fallback \"" + fallback + "\"\n") + "}";
    return std::make_shared<Material>(std::make_shared<const Shader>(
        ParseShaderLab(text, "test.shader").document, compiler, &BuiltinShaders()));
}

/// Boxes over a floor, and the light's rays among them in double.
class ShadowScene
{
public:
    struct Box
    {
        glm::dvec3 low;
        glm::dvec3 high;
    };
    struct Hit
    {
        double distance = 1e30;
        int box = -1; ///< -1: the floor
        glm::dvec3 normal{0.0, 1.0, 0.0};
    };

    Scene scene;
    Camera camera;
    std::vector<Box> boxes;
    int width;
    int height;

    ShadowScene(int pictureWidth, int pictureHeight, std::shared_ptr<const Material> material)
        : width(pictureWidth), height(pictureHeight), m_Material(std::move(material))
    {
        camera.transform.localPosition = {0.5f, 4.0f, -6.0f};
        camera.transform.localRotation = EulerToRotation({28.0f, -4.0f, 0.0f});
        camera.farClipPlane = 60.0f;
        camera.backgroundColor = Color::black;
        scene.mainLight.shadows = LightShadows::Hard;
        scene.mainLight.direction = EulerToRotation({48.0f, 60.0f, 0.0f}) * glm::vec3(0, 0, 1);
        GameObject& floor = scene.Add("floor");
        floor.transform.localScale = {20.0f, 1.0f, 20.0f}; // 200 m
        floor.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Plane), {m_Material}};
    }

    GameObject& Add(const glm::vec3& center, const glm::vec3& size)
    {
        GameObject& object = scene.Add("box " + std::to_string(boxes.size()));
        object.transform.localPosition = center;
        object.transform.localScale = size;
        object.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Cube), {m_Material}};
        boxes.push_back({glm::dvec3(center) - glm::dvec3(size) / 2.0,
                         glm::dvec3(center) + glm::dvec3(size) / 2.0});
        return object;
    }
    void AddBoxes()
    {
        Add({-2.5f, 1.0f, 1.0f}, {1.5f, 2.0f, 2.0f});
        Add({0.5f, 2.2f, 2.5f}, {2.5f, 0.4f, 2.0f}); // floats
        Add({4.0f, 0.75f, 4.0f}, {1.5f, 1.5f, 3.0f});
        Add({-5.0f, 2.5f, 8.0f}, {4.0f, 5.0f, 1.0f});
    }

    struct Ray
    {
        glm::dvec3 origin;
        glm::dvec3 direction;
    };
    /// Through a place of the picture, pixels from its top left.
    Ray RayThrough(double x, double y) const
    {
        const glm::dquat rotation(glm::normalize(glm::dquat(camera.transform.localRotation)));
        const double right = (2.0 * x / width - 1.0) * width / height;
        const double up = 1.0 - 2.0 * y / height;
        const glm::dvec3 position(camera.transform.localPosition);
        if (camera.orthographic)
        {
            const double half = static_cast<double>(camera.orthographicSize);
            return {position + rotation * glm::dvec3(right * half, up * half, 0.0),
                    rotation * glm::dvec3(0, 0, 1)};
        }
        const double half = std::tan(glm::radians(static_cast<double>(camera.fieldOfView) / 2));
        return {position, rotation * glm::normalize(glm::dvec3(right * half, up * half, 1.0))};
    }
    std::optional<Hit> Cast(const Ray& ray) const
    {
        Hit hit;
        if (ray.direction.y < 0.0 && ray.origin.y > 0.0)
        {
            hit.distance = -ray.origin.y / ray.direction.y;
        }
        for (std::size_t i = 0; i < boxes.size(); ++i)
        {
            double enters = 0.0;
            double leaves = 1e30;
            int side = 0;
            for (int axis = 0; axis < 3; ++axis)
            {
                const double a = (boxes[i].low[axis] - ray.origin[axis]) / ray.direction[axis];
                const double b = (boxes[i].high[axis] - ray.origin[axis]) / ray.direction[axis];
                side = std::min(a, b) > enters ? axis : side;
                enters = std::max(enters, std::min(a, b));
                leaves = std::min(leaves, std::max(a, b));
            }
            if (enters < leaves && leaves > 1e-4 && enters < hit.distance)
            {
                hit = {enters, static_cast<int>(i), glm::dvec3(0.0)};
                hit.normal[side] = ray.direction[side] < 0.0 ? 1.0 : -1.0;
            }
        }
        return hit.distance < 1e30 ? std::optional(hit) : std::nullopt;
    }
    glm::dvec3 toLight() const { return -glm::normalize(glm::dvec3(scene.mainLight.direction)); }
    bool IsLit(const glm::dvec3& place) const { return !Cast({place, toLight()}).has_value(); }

private:
    std::shared_ptr<const Material> m_Material;
};

/// How far shadows of a distance of 20 m have faded at a pixel: the least and the most of the
/// places that the device may take for its middle.
inline std::pair<double, double> FadeAt(const ShadowScene& shadows, int x, int y)
{
    std::pair<double, double> range{1.0, 0.0};
    for (const glm::dvec2& place : MovedPlaces({x + 0.5, y + 0.5}))
    {
        const auto hit = shadows.Cast(shadows.RayThrough(place.x, place.y));
        const double distance = hit ? hit->distance : 1e30;
        const double begin = 400.0 * 0.8 * 0.8;
        const double fade = std::clamp((distance * distance - begin) / (400.0 - begin), 0.0, 1.0);
        range = {std::min(range.first, fade), std::max(range.second, fade)};
    }
    return range;
}

} // namespace limn::test
