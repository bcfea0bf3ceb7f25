#include <benchmark/benchmark.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeManager.h>

namespace limn
{

namespace
{

class EightNumbers : public VolumeComponent
{
public:
    FloatParameter a{this, "a", 0.0f};
    FloatParameter b{this, "b", 0.0f};
    FloatParameter c{this, "c", 0.0f};
    FloatParameter d{this, "d", 0.0f};
    FloatParameter e{this, "e", 0.0f};
    FloatParameter f{this, "f", 0.0f};
    FloatParameter g{this, "g", 0.0f};
    FloatParameter h{this, "h", 0.0f};
};

/// Local volumes with a box each, all within reach of the trigger, each with a profile of its own.
void UpdateLocalVolumes(benchmark::State& state)
{
    VolumeComponentRegistry registry;
    registry.Register<EightNumbers>("EightNumbers");
    VolumeManager manager(registry);
    std::vector<Volume> volumes(static_cast<std::size_t>(state.range(0)));
    for (Volume& volume : volumes)
    {
        auto profile = std::make_shared<VolumeProfile>();
        profile->Add<EightNumbers>(true);
        volume.sharedProfile = profile;
        volume.isGlobal = false;
        volume.blendDistance = 4.0f;
        volume.colliders = {BoxCollider{}};
        manager.Register(&volume);
    }
    VolumeStack stack = manager.CreateStack();
    for ([[maybe_unused]] const auto iteration : state)
    {
        manager.Update(stack, glm::vec3(2.0f, 0.0f, 0.0f), LayerMask::FromIndex(0));
        benchmark::DoNotOptimize(stack.GetComponent<EightNumbers>()->a.value());
    }
    state.counters["time per volume"] = benchmark::Counter(
        static_cast<double>(volumes.size()),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(UpdateLocalVolumes)->Arg(1)->Arg(100)->Arg(10000);

} // namespace

} // namespace limn
