#pragma once

#include "port/PortedCode.h"

#include <set>
#include <string>
#include <vector>

namespace limn
{

/// `var builder = graph.AddRasterRenderPass<PassData>("Name", out var data, sampler)`, and without
/// the <PassData> where a type stands behind `out`.
struct GraphPassCall
{
    std::string name; ///< "AddRasterRenderPass"
    SourceLocation location;
    std::vector<CSharpWords> arguments;
    std::string data;     ///< the type of the pass's data
    std::string dataName; ///< the name behind `out`
    std::string builder;  ///< the builder's name
    CSharpWords graph;
    bool isWhole = false; ///< false if it is written in another way
};

/// Reads what stands in a `using`, which must have one of these calls.
GraphPassCall ReadGraphPass(CSharpWords head);

/// The argument of SetRenderFunc: `(data, context) => ...`, or a method's name.
struct RenderFunction
{
    std::string problem; ///< why it is not known; "" if it is known
    std::vector<std::string> parameters;
    CSharpWords body;
    bool isBlock = false; ///< true for { ... }, which the body is without
    bool isGroup = false; ///< true for a method's name
};

/// Reads what stands behind `builder.SetRenderFunc`.
RenderFunction ReadRenderFunction(CSharpWords words);

/// Returns the type of the builder that a call gives: "IRasterRenderGraphBuilder".
std::string BuilderTypeOf(std::string_view call);

/// Returns what a function in place takes along: "[=]" for names of the method around it, "[this]"
/// for members of its object, "[]" for nothing.
/// @param own  the function's parameters
std::string CaptureOf(const CSharpClass& one, const PortScope& scope, CSharpWords body,
                      const std::set<std::string>& own);

} // namespace limn
