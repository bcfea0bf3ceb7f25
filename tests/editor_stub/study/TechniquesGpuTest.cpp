#include "CachedCompiler.h"
#include "study/StudyPicture.h"
#include "study/StudyScene.h"
#include "study/Techniques.h"

#include <cctype>
#include <gtest/gtest.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/vulkan/VulkanDevice.h>
#include <numbers>

namespace limn::study
{
namespace
{

VulkanDevice& Device()
{
    static VulkanDevice device({"", true, {}});
    return device;
}

AssetContext& Assets()
{
    static AssetContext assets(test::CachedCompiler());
    return assets;
}

std::string NameOf(const testing::TestParamInfo<const Technique*>& info)
{
    std::string name;
    for (const char letter : info.param->info.name)
    {
        name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? std::string(1, letter) : "";
    }
    return name;
}

std::vector<const Technique*> AllTechniques()
{
    std::vector<const Technique*> all;
    for (const Technique& technique : Techniques())
    {
        all.push_back(&technique);
    }
    return all;
}

class EachTechniqueGpu : public testing::TestWithParam<const Technique*>
{
};

/// A ball, for techniques that look at normals, before a camera that sees a unit a pixel.
SceneAsset Ball()
{
    SceneAsset asset = EmptyPicture(96, 64);
    AddOutlined(asset, "ball", CreatePrimitive(PrimitiveType::Sphere), Assets())
        .transform.localScale = glm::vec3(36.0f);
    return asset;
}

TEST_P(EachTechniqueGpu, DrawsWhiteOnBlackAroundWhatIsOutlined)
{
    SceneAsset asset = Ball();
    UseTechnique(asset, *GetParam(), 4.0, Assets());
    StudyPicture picture(std::move(asset), Assets(), Device());
    const Coverage alpha = picture.Alpha();
    const double perimeter = 2.0 * std::numbers::pi * 18.0;
    EXPECT_EQ(alpha.At(2, 2), 0.0);
    EXPECT_LT(alpha.Sum(), 12.0 * perimeter);
    if (GetParam()->info.name == "Color edges")
    {
        EXPECT_EQ(alpha.Sum(), 0.0) << "nothing differs from anything in a black picture";
    }
    else
    {
        EXPECT_GT(alpha.Sum(), 2.0 * perimeter);
    }
}

TEST_P(EachTechniqueGpu, IsRefusedAWidthThatIsNoNumber)
{
    for (const char* width : {".nan", "nan", "wide"})
    {
        SceneAsset asset = Ball();
        EXPECT_THROW(UseTechnique(asset, *GetParam(), width, Assets()), AssetError) << width;
    }
}

INSTANTIATE_TEST_SUITE_P(Catalog, EachTechniqueGpu, testing::ValuesIn(AllTechniques()), NameOf);

} // namespace
} // namespace limn::study
