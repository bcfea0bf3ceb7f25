#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace limn
{

namespace
{

/// A base camera that is enabled.
struct BaseCamera
{
    const UnityGameObject* object;
    UnityReference texture; ///< what it draws into; null for the screen
    float depth = 0.0f;
    bool isMain = false; ///< true if it is tagged MainCamera
};

std::vector<BaseCamera> FindCameras(UnitySceneLoader& loader)
{
    std::vector<BaseCamera> found;
    for (const UnityGameObject* object : loader.hierarchy.objects())
    {
        const UnityInstance* camera = object->Find(UnityClass::Camera);
        if (camera == nullptr || !object->isActive)
        {
            continue;
        }
        const UnityReader reader = loader.ReaderOf(*object, *camera);
        BaseCamera base{object, reader.Reference("m_TargetTexture").asset};
        bool isEnabled = true;
        reader.Read("m_Enabled", isEnabled);
        reader.Read("m_Depth", base.depth);
        int type = 0;
        if (const UnityInstance* data = object->FindScript(k_CameraData))
        {
            loader.ReaderOf(*object, *data).Read("m_CameraType", type);
        }
        std::string tag;
        UnityReader(*object->object, object->path, loader.notes).Read("m_TagString", tag);
        base.isMain = tag == "MainCamera";
        if (isEnabled && type == 0)
        {
            found.push_back(base);
        }
    }
    return found;
}

/// Returns the camera that the picture is of: one tagged MainCamera, or else the one of the least
/// depth. One that draws into a texture is taken only if none draws onto the screen.
const BaseCamera* ChooseCamera(std::span<const BaseCamera> cameras)
{
    const auto rank = [](const BaseCamera& camera)
    {
        return std::tuple(!camera.texture.isNull(), !camera.isMain, camera.depth);
    };
    const auto chosen = std::ranges::min_element(cameras, {}, rank);
    return chosen == cameras.end() ? nullptr : &*chosen;
}

/// Notes what the choice of a camera leaves out, and has the textures made that others draw into.
void NoteOthers(UnitySceneLoader& loader, std::span<const BaseCamera> cameras,
                const BaseCamera& chosen)
{
    if (!chosen.texture.isNull())
    {
        loader.notes.Add(loader.path.generic_string(), 0,
                         "no camera draws onto the screen, so the picture is that of '" +
                             chosen.object->path + "', which draws into a texture");
    }
    for (const BaseCamera& camera : cameras)
    {
        if (!camera.texture.isNull())
        {
            loader.materials.textures().AddTarget(camera.texture);
        }
        else if (&camera != &chosen)
        {
            loader.notes.Count("cameras besides the main one");
        }
    }
}

/// @param renderer  set to the index of the renderer that the camera asks for, if it does
void ReadView(UnitySceneLoader& loader, const UnityGameObject& object, Camera& camera,
              int& renderer)
{
    const UnityReader reader = loader.ReaderOf(object, *object.Find(UnityClass::Camera));
    camera.transform = object.drawn->transform;
    int clear = 1;
    reader.Read("m_ClearFlags", clear);
    camera.clearFlags = clear == 1   ? CameraClearFlags::Skybox
                        : clear == 2 ? CameraClearFlags::SolidColor
                                     : CameraClearFlags::Depth;
    reader.Read("m_BackGroundColor", camera.backgroundColor);
    reader.Read("orthographic", camera.orthographic);
    reader.ReadIn("orthographic size", 1e-3f, 1e9f, camera.orthographicSize);
    reader.ReadIn("field of view", 0.01f, 179.0f, camera.fieldOfView);
    reader.ReadIn("far clip plane", 0.02f, 1e9f, camera.farClipPlane);
    camera.nearClipPlane = std::min(camera.nearClipPlane, camera.farClipPlane * 0.5f);
    reader.ReadIn("near clip plane", camera.orthographic ? -1e9f : 1e-4f,
                  camera.farClipPlane * 0.999f, camera.nearClipPlane);
    reader.Read("m_CullingMask", camera.cullingMask);
    reader.Read("m_Depth", camera.depth);
    reader.Read("m_HDR", camera.allowHDR);
    reader.Read("m_AllowMSAA", camera.allowMSAA);
    camera.renderPostProcessing = false;
    if (const UnityInstance* data = object.FindScript(k_CameraData))
    {
        const UnityReader own = loader.ReaderOf(object, *data);
        own.Read("m_RenderPostProcessing", camera.renderPostProcessing);
        own.Read("m_VolumeLayerMask", camera.volumeLayerMask);
        own.Read("m_ClearDepth", camera.clearDepth);
        own.Read("m_RendererIndex", renderer);
        int antialiasing = 0;
        own.Read("m_Antialiasing", antialiasing);
        if (antialiasing == static_cast<int>(AntialiasingMode::FastApproximateAntialiasing))
        {
            camera.antialiasing = AntialiasingMode::FastApproximateAntialiasing;
        }
        else if (antialiasing != 0)
        {
            loader.notes.Count("antialiasing of cameras in post-processing (SMAA or TAA)");
        }
    }
}

void ReadStack(UnitySceneLoader& loader, const UnityReader& data, Camera& camera)
{
    const std::size_t count = data.Count("m_Cameras");
    for (std::size_t i = 0; i < count; ++i)
    {
        const UnityTarget target =
            data.Reference("m_Cameras.Array.data[" + std::to_string(i) + "]");
        const UnityGameObject* object = loader.hierarchy.Find(target.object);
        if (object != nullptr && object->isActive && object->Find(UnityClass::Camera) != nullptr)
        {
            auto overlay = std::make_shared<Camera>();
            int unused = 0;
            ReadView(loader, *object, *overlay, unused);
            overlay->renderType = CameraRenderType::Overlay;
            camera.cameraStack.push_back(std::move(overlay));
        }
    }
}

/// Reads a base camera with its stack.
/// @return the index of the renderer that the camera asks for; -1 for the pipeline's first one
int ReadBase(UnitySceneLoader& loader, const UnityGameObject& object, Camera& camera)
{
    int renderer = -1;
    ReadView(loader, object, camera, renderer);
    if (const UnityInstance* data = object.FindScript(k_CameraData))
    {
        ReadStack(loader, loader.ReaderOf(object, *data), camera);
    }
    return renderer;
}

} // namespace

int ReadUnityCamera(UnitySceneLoader& loader)
{
    const std::vector<BaseCamera> cameras = FindCameras(loader);
    const BaseCamera* chosen = ChooseCamera(cameras);
    if (chosen == nullptr)
    {
        throw AssetError(loader.path.generic_string(), {},
                         "no camera draws a picture: none is active and enabled; switch one on in "
                         "Unity, or name another scene with --scene");
    }
    NoteOthers(loader, cameras, *chosen);
    return ReadBase(loader, *chosen->object, loader.asset.camera);
}

void ReadUnityTextureCameras(UnitySceneLoader& loader, int renderer)
{
    const auto indexOf = [&loader](int asked)
    {
        return asked < 0 ? loader.defaultRenderer : asked;
    };
    for (const BaseCamera& base : FindCameras(loader))
    {
        const auto target =
            base.texture.isNull() ? nullptr : loader.materials.textures().FindTarget(base.texture);
        if (!target)
        {
            continue; // it draws onto the screen, or no material reads what it draws
        }
        Camera& camera = loader.asset.textureCameras.emplace_back();
        camera.targetTexture = target;
        const int asked = ReadBase(loader, *base.object, camera);
        if (indexOf(asked) != indexOf(renderer))
        {
            loader.notes.Add(loader.path.generic_string(), 0,
                             "the camera '" + base.object->path +
                                 "' asks for another renderer than the main camera, whose renderer "
                                 "draws its texture");
        }
    }
}

} // namespace limn
