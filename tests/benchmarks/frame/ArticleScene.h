#pragma once

#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeStack.h>

namespace limn::benchmarks
{

/// What a row of the table draws.
struct ArticleSettings
{
    int width = 1280;
    int height = 720;
    int objects = 1;
    int meshes = 10;   ///< the objects take them in turn
    int materials = 1; ///< likewise, once all meshes have been taken
    float size = 0.0f; ///< of the first object in parts of the screen's height; 0 = as many fit
    /// Of this shape, seen from the front; none = boxes and quads by turns, turned each its way.
    std::optional<PrimitiveType> shape;
    bool hasOutline = true;
    bool limitsRegions = false;
    bool leavesOut = true; ///< see FrameCompilerOptions
};

/// Tells what has another place in each frame.
enum class Movement
{
    None,
    Camera,
    Some, ///< a hundredth of the objects, and one at least
    All
};

inline constexpr float k_CameraDistance = 10.0f;    ///< metres, along z
inline constexpr float k_CameraFieldOfView = 60.0f; ///< degrees, vertical
inline constexpr float k_Step = 0.01f;              ///< metres
inline constexpr int k_OutlinedLayer = 8;           ///< rendering layer
inline constexpr RenderingLayerMask k_OutlinedLayers =
    RenderingLayerMask::FromIndex(k_OutlinedLayer);

/// Returns how many of the first objects move.
inline std::size_t MovedCount(Movement what, std::size_t objects)
{
    return what == Movement::All ? objects : what == Movement::Some ? objects / 100 + 1 : 0;
}

/// The article's frame: lit objects of which every tenth is outlined, all of them in the picture.
class ArticleScene
{
public:
    ArticleScene(const ArticleSettings& settings, GraphicsDevice& device);
    ArticleScene(const ArticleScene&) = delete;
    ArticleScene& operator=(const ArticleScene&) = delete;

    /// Moves to one side in odd steps and back in even ones.
    void Move(Movement what, int step);

    const Scene& scene() const { return m_Scene; }

    /// Until the next call.
    const RenderResult& Render()
    {
        m_Pipeline.RenderSingleCamera(m_Renderer, m_Request, m_Result);
        return m_Result;
    }

private:
    void AddObjects(const ArticleSettings& settings);
    void AddOutline();

    std::shared_ptr<ShaderCompiler> m_Compiler = std::make_shared<ShaderCompiler>();
    Scene m_Scene;
    Camera m_Camera;
    VolumeComponentRegistry m_Components;
    std::unique_ptr<VolumeManager> m_Volumes;
    std::unique_ptr<VolumeStack> m_Stack;
    Volume m_Volume;
    UniversalRenderPipeline m_Pipeline;
    UniversalRenderer m_Renderer{m_Compiler};
    RenderRequest m_Request;
    RenderResult m_Result; ///< of the last frame
};

/// Objects of one material and mesh, the outlined ones first.
struct ArticleGroup
{
    std::shared_ptr<const Mesh> mesh;
    std::size_t material = 0; ///< of ArticleNumbers::materials
    std::uint32_t first = 0;  ///< of those in sight
    std::uint32_t count = 0;
    std::uint32_t outlined = 0;

    bool operator==(const ArticleGroup&) const = default;
};

struct ArticleObject
{
    Transform transform;
    RenderingLayerMask renderingLayers;
    std::size_t group = 0; ///< of ArticleNumbers::groups
};

/// A full-screen draw of the frame.
struct ArticleBlit
{
    std::shared_ptr<const ShaderProgram> program;
    std::shared_ptr<const DrawBindings> bindings;
};

/// All numbers and shaders that a frame of the same picture needs: taken from a frame of limn's,
/// but sorted as somebody would sort them who knows the scene.
struct ArticleNumbers
{
    int width = 0;
    int height = 0;
    Color background; ///< linear
    std::shared_ptr<const ShaderProgram> lit;
    std::shared_ptr<const ShaderProgram> mask;
    std::vector<std::shared_ptr<const DrawBindings>> materials; ///< of lit objects
    std::shared_ptr<const DrawBindings> maskBindings;
    ArticleBlit edge;
    ArticleBlit composite;
    ArticleBlit final;
    std::vector<ArticleGroup> groups;   ///< all of them, without numbers of objects
    std::vector<ArticleObject> objects; ///< in the scene's order
    std::vector<std::byte> uniforms;    ///< DrawBindings point into these
    std::vector<std::byte> uniformsOfMovedCamera;
};

/// @param scene  with the outline and without regions
ArticleNumbers NumbersOf(ArticleScene& scene);

} // namespace limn::benchmarks
