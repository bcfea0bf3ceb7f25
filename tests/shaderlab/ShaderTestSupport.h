#pragma once

#include "TemporaryFolder.h"

#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderLabParser.h>

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace limn::test
{

/// `Shader "T" { SubShader { Pass { … } } }` with everything on the line it is given on.
inline std::string WrapPass(const std::string& commands)
{
    return "Shader \"T\" { SubShader { Pass { " + commands + " } } }";
}

/// The diagnostics as text without the file name: "1:12: error: …".
inline std::vector<std::string> Messages(const std::vector<Diagnostic>& diagnostics)
{
    std::vector<std::string> messages;
    for (const Diagnostic& diagnostic : diagnostics)
    {
        const std::string text = ToString(diagnostic);
        messages.push_back(text.substr(diagnostic.file.size() + 1));
    }
    return messages;
}

inline std::vector<std::string> ParseMessages(const std::string& text)
{
    return Messages(ParseShaderLab(text, "t.shader").diagnostics);
}

/// The document of text that must be without a diagnostic.
inline ShaderLabDocument ParseGood(const std::string& text)
{
    ShaderLabParseResult result = ParseShaderLab(text, "t.shader");
    EXPECT_EQ(Messages(result.diagnostics), std::vector<std::string>{});
    return result.document;
}

/// The only pass of text that must be without a diagnostic.
inline ShaderLabPass ParsePass(const std::string& commands)
{
    const ShaderLabDocument document = ParseGood(WrapPass(commands));
    EXPECT_EQ(document.subShaders.size(), 1u);
    EXPECT_EQ(document.subShaders.at(0).passes.size(), 1u);
    return document.subShaders.at(0).passes.at(0);
}

/// The program of a pass whose HLSLPROGRAM holds `hlsl`.
inline PassProgram ProgramOf(const std::string& hlsl)
{
    return ParsePass("HLSLPROGRAM" + hlsl + "ENDHLSL").program.value();
}

/// Returns a line that includes the file.
inline std::string IncludeOf(const std::string& path)
{
    return "#include \"" + path + "\"\n";
}

/// A program of HLSL that starts on line 1 of "t.shader" and has the entry functions vert and frag.
inline PassProgram Program(const std::string& hlsl,
                           ProgramLanguage language = ProgramLanguage::Hlsl)
{
    PassProgram program;
    program.file = "t.shader";
    program.location = {1, 1};
    program.language = language;
    program.chunks = {{hlsl, 1}};
    program.vertex = {"vert", {1, 1}};
    program.fragment = {"frag", {1, 1}};
    return program;
}

inline std::shared_ptr<const ShaderProgram>
CompileHlsl(const std::string& hlsl, ProgramLanguage language = ProgramLanguage::Hlsl)
{
    ShaderCompiler compiler;
    return compiler.Compile(Program(hlsl, language));
}

/// What compiling complains about, as Messages(); fails the test if it does not.
inline std::vector<std::string> CompileMessages(const PassProgram& program)
{
    ShaderCompiler compiler;
    try
    {
        compiler.Compile(program);
    }
    catch (const AssetError& error)
    {
        std::vector<std::string> messages;
        for (const Diagnostic& diagnostic : error.diagnostics())
        {
            messages.push_back(ToString(diagnostic));
        }
        return messages;
    }
    ADD_FAILURE() << "compiling was expected to fail";
    return {};
}

} // namespace limn::test
