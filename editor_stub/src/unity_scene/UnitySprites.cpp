#include "assets/PictureFile.h"
#include "unity/TextureImporter.h"
#include "unity/UnityTree.h"
#include "unity_scene/UnitySceneLoader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <limn/base/ReadFile.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Image.h>
#include <limn/core/MaterialPropertyBlock.h>
#include <span>

namespace limn
{

namespace
{

constexpr float k_DefaultSpriteUnit = 256.0f; ///< texels a metre

/// A shape holds all that lies within `radius` of a convex polygon, a line or a point. Its places
/// are in texels from the middle of the picture, y upwards.
struct Shape
{
    std::string_view guid;
    const char* name;
    glm::ivec2 size; ///< of the picture
    float radius;
    std::array<glm::vec2, 6> corners; ///< counterclockwise
    std::size_t cornerCount;
};

constexpr Shape k_Shapes[] = {
    {"311925a002f4447b3a28927169b83ea6",
     "Square",
     {256, 256},
     0,
     {{{-128, -128}, {128, -128}, {128, 128}, {-128, 128}}},
     4},
    {"a86470a33a6bf42c4b3595704624658b", "Circle", {256, 256}, 128, {{{0, 0}}}, 1},
    {"207ee8102dd4143d288186ef0be518ee", "Capsule", {256, 512}, 128, {{{0, -128}, {0, 128}}}, 2},
    {"19fb86013d8c24d6cb8410c0aadf30fa",
     "Isometric Diamond",
     {256, 128},
     0,
     {{{-128, 0}, {0, -64}, {128, 0}, {0, 64}}},
     4},
    {"b670ab75dde984907b8570040daa08c5",
     "Hexagon Flat-Top",
     {256, 226},
     0,
     {{{-128, 0}, {-64, -111}, {64, -111}, {128, 0}, {64, 111}, {-64, 111}}},
     6},
    {"5aa8b770bc43046bc8d993d0d5b7f4a5",
     "Hexagon Pointed-Top",
     {226, 256},
     0,
     {{{-111, -64}, {0, -128}, {111, -64}, {111, 64}, {0, 128}, {-111, 64}}},
     6},
    {"8884154dfe85442a3a3578be807dbcdf",
     "9-Sliced",
     {256, 256},
     64,
     {{{-64, -64}, {64, -64}, {64, 64}, {-64, 64}}},
     4},
};

/// Returns the distance to the shape's rim in texels, below 0 inside.
float DistanceTo(const Shape& shape, const glm::vec2& place)
{
    const std::span corners(shape.corners.data(), shape.cornerCount);
    float nearest = std::numeric_limits<float>::max();
    bool isInside = corners.size() > 2;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const glm::vec2 side = corners[(i + 1) % corners.size()] - corners[i];
        const glm::vec2 toPlace = place - corners[i];
        const float length = std::max(glm::dot(side, side), 1.0f); // a point has no side
        const float along = glm::clamp(glm::dot(toPlace, side) / length, 0.0f, 1.0f);
        nearest = std::min(nearest, glm::distance(toPlace, along * side));
        isInside = isInside && side.x * toPlace.y > side.y * toPlace.x;
    }
    return (isInside ? -nearest : nearest) - shape.radius;
}

/// Draws the picture of one of the shapes of Unity's menu "2D Object > Sprites": white, with the
/// shape as its alpha, and no larger than it. They lie in Unity's own package, so that projects
/// name them and do not have them. Returns null for every other guid.
/// Unity: com.unity.2d.sprite 1.0 (2021.1), without the triangle.
std::shared_ptr<const Texture2D> MakeDefaultSprite(std::string_view guid)
{
    const auto* const shape = std::ranges::find(k_Shapes, guid, &Shape::guid);
    if (shape == std::end(k_Shapes))
    {
        return nullptr;
    }
    SamplerState sampler;
    sampler.wrapModeU = sampler.wrapModeV = TextureWrapMode::Clamp;
    std::vector<std::byte> texels;
    for (int y = 0; y < shape->size.y; ++y)
    {
        for (int x = 0; x < shape->size.x; ++x)
        {
            const glm::vec2 place = glm::vec2(x, y) + 0.5f - 0.5f * glm::vec2(shape->size);
            const float covered = glm::clamp(0.5f - DistanceTo(*shape, place), 0.0f, 1.0f);
            texels.insert(texels.end(), 3, std::byte{255});
            texels.push_back(static_cast<std::byte>(covered * 255.0f + 0.5f));
        }
    }
    return std::make_shared<const Texture2D>(shape->name, shape->size.x, shape->size.y,
                                             GraphicsFormat::R8G8B8A8_SRGB, std::move(texels),
                                             sampler);
}

/// A part of a picture, as the TextureImporter of its .meta file cuts it out.
struct Sprite
{
    std::shared_ptr<const Texture2D> texture;
    glm::vec2 picture{0.0f}; ///< the size of the picture in its file, texels
    glm::vec2 low{0.0f};     ///< its bottom left corner, texels from the picture's
    glm::vec2 size{0.0f};    ///< texels
    glm::vec2 pivot{0.5f};   ///< the place of the object, as parts of the size
    float pixelsPerUnit = 100.0f;
};

/// @param own  what has "alignment": SpriteAlignment (2022.3), of which 9 is a place of its own
glm::vec2 PivotOf(const UnityNode& own, const UnityNode& custom)
{
    constexpr glm::vec2 k_Pivots[] = {{0.5f, 0.5f}, {0.0f, 1.0f}, {0.5f, 1.0f},
                                      {1.0f, 1.0f}, {0.0f, 0.5f}, {1.0f, 0.5f},
                                      {0.0f, 0.0f}, {0.5f, 0.0f}, {1.0f, 0.0f}};
    const std::size_t alignment = NumberOf(own["alignment"], std::size_t{0});
    return alignment < std::size(k_Pivots)
               ? k_Pivots[alignment]
               : glm::vec2(NumberOf(custom["x"], 0.5f), NumberOf(custom["y"], 0.5f));
}

/// Cuts a sprite out of the whole picture.
/// @param fileID  which of the file's sprites
/// @return false if the file has no such sprite
bool CutOut(const UnityNode& importer, std::int64_t fileID, Sprite& sprite)
{
    constexpr int k_Multiple = 2;              // a SpriteImportMode
    constexpr std::int64_t k_First = 21300000; // of ids, two apart, before Unity 2019
    sprite.pivot = PivotOf(importer, importer["spritePivot"]);
    sprite.pixelsPerUnit = NumberOf(importer["spritePixelsToUnits"], 100.0f);
    if (NumberOf(importer["spriteMode"], 1) != k_Multiple)
    {
        return true;
    }
    std::int64_t index = 0;
    for (const UnityNode part : importer["spriteSheet"]["sprites"])
    {
        const auto id = NumberOf(part["internalID"], std::int64_t{0});
        if (fileID == (id != 0 ? id : k_First + 2 * index))
        {
            const UnityNode rect = part["rect"];
            sprite.low = {NumberOf(rect["x"], 0.0f), NumberOf(rect["y"], 0.0f)};
            sprite.size = {NumberOf(rect["width"], 0.0f), NumberOf(rect["height"], 0.0f)};
            sprite.pivot = PivotOf(part, part["pivot"]);
            return true;
        }
        ++index;
    }
    return false;
}

/// @param size  metres
std::shared_ptr<const Mesh> QuadOf(const Sprite& sprite, const glm::vec2& size, const Color& color)
{
    MeshData data;
    for (const glm::vec2 corner :
         {glm::vec2(0, 0), glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)})
    {
        data.vertices.emplace_back((corner - sprite.pivot) * size, 0.0f);
        data.normals.emplace_back(0.0f, 0.0f, -1.0f);
        data.uv.push_back((sprite.low + corner * sprite.size) / sprite.picture);
        data.colors.push_back(CoreUtils::ConvertSRGBToActiveColorSpace(color).vector());
    }
    data.triangles = {0, 1, 2, 0, 2, 3};
    return std::make_shared<const Mesh>(sprite.texture->name(), std::move(data));
}

/// Those of a lower layer or order are drawn before. limn sorts by queue first, and so by these.
std::shared_ptr<const Material> InOrder(std::shared_ptr<const Material> material, int order)
{
    if (order == 0)
    {
        return material;
    }
    constexpr int k_FirstTransparent = 2501;
    constexpr int k_Last = 5000;
    auto copy = std::make_shared<Material>(*material, material->shader());
    copy->SetRenderQueue(std::clamp(material->renderQueue() + order, k_FirstTransparent, k_Last));
    return copy;
}

/// Returns the size of the file's picture, to which the sprites' places refer. The texture may be a
/// smaller one; of a PNG the header tells.
glm::vec2 SizeOfPicture(const std::filesystem::path& path, const Texture2D& texture)
{
    const glm::vec2 size(texture.width(), texture.height());
    const auto texels = static_cast<float>(PngTexelBytes(path) / 4);
    return texels > 0.0f ? glm::round(size * std::sqrt(texels / (size.x * size.y))) : size;
}

/// @return nothing, with a note, if the file has no such sprite
/// @throws AssetError  if the picture or its .meta file cannot be read
std::optional<Sprite> LoadSprite(UnitySceneLoader& loader, const UnityReader& reader,
                                 const std::filesystem::path& path, std::int64_t fileID)
{
    Sprite sprite;
    sprite.texture = loader.assets.LoadTexture(path);
    sprite.picture = SizeOfPicture(path, *sprite.texture);
    sprite.size = sprite.picture;
    const std::string text = ReadFile(MetaFileOf(path));
    const UnityTree meta(text, MetaFileOf(path).generic_string(), 1);
    if (!CutOut(meta.root()["TextureImporter"], fileID, sprite))
    {
        reader.Note("m_Sprite", path.filename().string() + " has no sprite with the id " +
                                    std::to_string(fileID) + ", so nothing is drawn");
        return std::nullopt;
    }
    return sprite;
}

/// @return nothing, with a note, if there is no such picture
/// @throws AssetError  if the picture or its .meta file cannot be read
std::optional<Sprite> FindSprite(UnitySceneLoader& loader, const UnityReader& reader,
                                 const UnityReference& asset)
{
    const std::filesystem::path* path = loader.database.Find(asset.guid);
    if (path != nullptr && IsPictureFile(*path))
    {
        return LoadSprite(loader, reader, *path, asset.fileID);
    }
    std::shared_ptr<const Texture2D>& known = loader.defaultSprites[asset.guid];
    known = known || path != nullptr ? known : MakeDefaultSprite(asset.guid);
    if (known)
    {
        const glm::vec2 size(known->width(), known->height());
        return Sprite{
            .texture = known, .picture = size, .size = size, .pixelsPerUnit = k_DefaultSpriteUnit};
    }
    reader.Note("m_Sprite", (path == nullptr ? loader.database.WhyNotFound(asset)
                                             : path->filename().string() + " is no picture") +
                                ", so nothing is drawn");
    return std::nullopt;
}

/// @throws ContractError  if the sprite's numbers make no quad
void SetQuad(const UnityReader& reader, const Sprite& sprite, MeshRenderer& renderer)
{
    Color color = Color::white;
    reader.Read("m_Color", color);
    bool flipX = false;
    bool flipY = false;
    reader.Read("m_FlipX", flipX);
    reader.Read("m_FlipY", flipY);
    glm::vec2 size = sprite.size / sprite.pixelsPerUnit;
    int drawMode = 0;
    reader.Read("m_DrawMode", drawMode);
    if (drawMode != 0)
    {
        reader.Read("m_Size.x", size.x);
        reader.Read("m_Size.y", size.y);
        reader.Note("m_DrawMode", "limn stretches the sprite; it neither slices nor tiles it");
    }
    renderer.mesh = QuadOf(sprite, size * glm::vec2(flipX ? -1 : 1, flipY ? -1 : 1), color);
    MaterialPropertyBlock block;
    block.SetTexture(ShaderPropertyId("_MainTex"), sprite.texture);
    renderer.SetPropertyBlock(block);
}

} // namespace

void AddUnitySprite(UnitySceneLoader& loader, const UnityGameObject& object,
                    const UnityInstance& renderer)
{
    const UnityReader reader = loader.ReaderOf(object, renderer);
    const UnityTarget target = reader.Reference("m_Sprite");
    MeshRenderer made;
    reader.Read("m_Enabled", made.enabled);
    if (target.isNull() || !object.isActive || !made.enabled)
    {
        return;
    }
    try
    {
        if (const auto sprite = FindSprite(loader, reader, target.asset))
        {
            SetQuad(reader, *sprite, made);
        }
    }
    catch (const AssetError& error)
    {
        loader.notes.Add(error.diagnostics());
    }
    catch (const ContractError&)
    {
        const std::filesystem::path& path = *loader.database.Find(target.asset.guid);
        reader.Note("m_Sprite", "a number in " + MetaFileOf(path).filename().string() +
                                    " is no size or place, so nothing is drawn");
    }
    if (!made.mesh)
    {
        return;
    }
    int layer = 0;
    int order = 0;
    reader.Read("m_SortingLayer", layer);
    reader.Read("m_SortingOrder", order);
    const std::string first = "m_Materials.Array.data[0]";
    made.sharedMaterials = {InOrder(loader.materials.Load(reader.Reference(first), reader, first),
                                    100 * layer + order)};
    reader.Read("m_RenderingLayerMask", made.renderingLayerMask);
    object.drawn->renderer = std::move(made);
}

} // namespace limn
