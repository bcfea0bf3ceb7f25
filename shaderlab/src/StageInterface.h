#pragma once

#include <limn/shaderlab/CompiledPass.h>

#include "HlslDeclarations.h"

#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A scalar or vector that crosses the border of a stage: one value of an entry function's
/// parameter, structs, arrays and matrices taken apart.
struct StageValue
{
    std::string expression; ///< where the author's function has it: "limn_a0.uvs[1]"
    std::string semantic;   ///< upper case, without index
    int index = 0;
    std::string scalar; ///< "float", "int", "uint" or "bool"
    int components = 1;
    std::string interpolation;  ///< modifiers, "" or with a blank at the end
    bool isSystemValue = false; ///< made or taken by the pipeline: no attribute and no varying

    std::string semanticName() const; ///< "TEXCOORD0", "POSITION", "COLOR1"
};

/// Everything the author's entry function takes and gives.
struct StageInterface
{
    const HlslFunction* function = nullptr;
    std::vector<StageValue> inputs;
    std::vector<StageValue> outputs;
};

/// One line of complaint about the interface of a function; the caller adds the place.
struct StageInterfaceError
{
    std::string message;
};

/// Takes the signature of an entry function apart. Old semantics get their modern names here:
/// a vertex function's POSITION output is SV_POSITION, a fragment function's COLOR output is
/// SV_TARGET, VPOS is SV_POSITION, VFACE is SV_ISFRONTFACE.
///
/// @throws StageInterfaceError
StageInterface ReadStageInterface(const HlslDeclarations& declarations,
                                  const HlslFunction& function, ShaderStage stage);

/// Name of the local variable that the generated code keeps parameter `index` in.
std::string ArgumentName(std::size_t index);
inline constexpr std::string_view k_ResultName = "limn_result";

/// "float" and 3: "float3".
std::string TypeName(const std::string& scalar, int components);

} // namespace limn
