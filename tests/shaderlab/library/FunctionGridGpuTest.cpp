#include "library/FunctionGrid.h"

#include <cmath>
#include <gmock/gmock.h>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{

using FunctionGrids = GpuTest;

TEST_F(FunctionGrids, AgreeWithAnOracleThatIsRight)
{
    FunctionGrid grid("float4 _Scale; float4 Twice(float4 v) { return v + v; }");
    grid.SetGlobal("_Scale", {1, 2, 3, 4});
    const std::vector<GridInput> inputs = Combine({-2.0, 0.0, 1e30}, {0.5, 3.0});
    grid.Add("a.x * b.x", inputs, [](auto& a, auto& b, auto&) { return a.x * b.x; });
    grid.Add("Twice(float4(a.x, 0, b.x, 1)) * _Scale", inputs,
             [](auto& a, auto& b, auto&) { return glm::dvec4(2 * a.x, 0, 6 * b.x, 8); });
    grid.Add("a.x > 0", inputs, [](auto& a, auto&, auto&) { return a.x > 0 ? 1.0 : 0.0; });
    grid.Run();
}

TEST_F(FunctionGrids, MayReadNoInput)
{
    for (const double value : {0.0, 3.0})
    {
        FunctionGrid grid("");
        grid.Add(value > 0 ? "3.0" : "0.0", Combine({1.0, 2.0}),
                 [&](auto&, auto&, auto&) { return value; });
        grid.Run();
    }
}

TEST_F(FunctionGrids, NameTheInputThatIsFurthestOff)
{
    FunctionGrid grid("");
    grid.Add("a.x * a.x", Combine({1.0, 2.0, 3.0}),
             [](auto& a, auto&, auto&) { return a.x > 2.5 ? 8.0 : a.x * a.x; });
    grid.Add("a.xy", Combine({1.0}), [](auto& a, auto&, auto&) { return glm::dvec2(a.x, 0.25); });
    EXPECT_EQ("a.x * a.x at a=(3, 0, 0, 0) b=(0, 0, 0, 0) c=(0, 0, 0, 0): component 0 is 9 "
              "instead of 8\n"
              "a.xy at a=(1, 0, 0, 0) b=(0, 0, 0, 0) c=(0, 0, 0, 0): component 1 is 0 instead of "
              "0.25\n",
              grid.Mismatches());
}

} // namespace limn::test
