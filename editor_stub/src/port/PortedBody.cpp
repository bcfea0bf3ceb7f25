#include "port/PortedBody.h"

#include "port/PortMember.h"
#include "port/PortedGraph.h"
#include "port/csharp/CSharpStatements.h"

#include <algorithm>
#include <utility>

namespace limn
{

PortedBody::PortedBody(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
    : PortedStatement(code, one, method), m_Result(method.isConstructor() ? "void" : method.type)
{
}

void PortedBody::Write()
{
    const PortContext context(m_Model, m_One);
    for (const CSharpParameter& parameter : m_Method.parameters)
    {
        if (IsCopied("const " + parameter.type + "&", m_Method, parameter.name))
        {
            const std::string name = LocalName(m_Model, m_One, parameter.name);
            m_Code.Line(parameter.type + " " + name + " = " + name + "Given;");
        }
    }
    if (!m_Method.isExpression)
    {
        WriteStatements(m_Method.body);
    }
    else if (m_Result == "void" ? !WriteSimple(m_Method.body) : !WriteReturn(m_Method.body))
    {
        Todo(m_Method.body);
    }
    const auto signature = SignatureOf(m_Model, m_One, m_Method);
    if (!m_IsReturned && signature && !m_Method.isConstructor())
    {
        WriteResult(m_Code, *signature);
    }
}

void PortedBody::WriteComments(std::size_t begin, std::size_t end)
{
    const std::string_view text = std::string_view(m_One.file->text).substr(begin, end - begin);
    for (const std::string& line : SplitText(std::string(text), '\n'))
    {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first != std::string::npos && line.compare(first, 2, "//") == 0)
        {
            const std::size_t words = line.find_first_not_of("/ ", first);
            m_Code.Comment(words == std::string::npos ? "" : line.substr(words));
        }
    }
}

void PortedBody::WriteStatements(CSharpWords words)
{
    Word at = words.data();
    const Word end = at + words.size();
    std::size_t text = at == end || at->offset == 0 ? 0 : at[-1].offset + at[-1].text.size();
    while (at < end)
    {
        WriteComments(text, at->offset);
        m_IsReturned = false;
        const Word behind = WriteStatement(at, end);
        at = std::max(behind, at + 1);
        text = at[-1].offset + at[-1].text.size();
    }
}

const CSharpToken* PortedBody::WriteStatement(Word at, Word end)
{
    if (at->Is(";"))
    {
        return at + 1;
    }
    if (m_Depth > k_MostStatements)
    {
        Todo({at, EndOfStatement(at, end)}, "statements in statements, too many of them");
        return EndOfStatement(at, end);
    }
    if (at->Is("{"))
    {
        m_Code.Open();
        WriteBlock(at, at->Behind());
        m_Code.Close();
        return at->Behind();
    }
    static const auto isKeyword = [](const CSharpToken& word)
    {
        return word.isName() &&
               IsIn(word.text,
                    {"if",     "for",   "foreach",  "while",   "do",        "switch", "using",
                     "return", "break", "continue", "throw",   "try",       "lock",   "goto",
                     "yield",  "fixed", "unsafe",   "checked", "unchecked", "catch",  "finally"});
    };
    if (isKeyword(*at) && !at[1].Is("="))
    {
        return WriteKeyword(at, end);
    }
    const Word behind = EndOfStatement(at, end);
    const CSharpWords words(at, behind[-1].Is(";") ? behind - 1 : behind);
    const bool isFunction = words.size() > 4 && words[1].Is(".") && words[2].Is("SetRenderFunc") &&
                            m_Builders.contains(std::string(words[0].text));
    if (isFunction ? !WriteRenderFunction(words) : !WriteSimple(words))
    {
        Todo({at, behind});
        WarnOfPass(words);
    }
    return behind;
}

/// Writes a line that says of a pass that it is not drawn, where its EnqueuePass is a comment.
void PortedBody::WarnOfPass(CSharpWords words)
{
    for (std::size_t i = 0; i + 2 < words.size(); ++i)
    {
        if (words[i].Is("EnqueuePass") && words[i + 1].Is("("))
        {
            m_Code.Line("Debug::LogWarning(\"" + m_One.name + ": '" +
                        std::string(TextOf(*m_One.file, words[i + 1].Inside())) +
                        "' is not drawn; the C++ does not make it\");");
        }
    }
}

const CSharpToken* PortedBody::WriteKeyword(Word at, Word end)
{
    const Word behind = EndOfStatement(at, end);
    const bool hasHead = at + 1 < end && at[1].Is("(") && at[1].Behind() < end;
    if (at->Is("if") && hasHead)
    {
        return WriteIf(at, end);
    }
    if ((at->Is("for") || at->Is("while")) && hasHead)
    {
        return WriteLoop(at, end);
    }
    if (at->Is("foreach") && hasHead)
    {
        return WriteForEach(at, end);
    }
    if (at->Is("switch") && hasHead && at[1].Behind()->Is("{"))
    {
        return WriteSwitch(at, end);
    }
    const bool hasStatement =
        hasHead || FindOutsideOfBrackets(at, end, {";"}) < end; // using var a = b;
    if (at->Is("using") && hasStatement)
    {
        return WriteUsing(at, end);
    }
    if (at->Is("break") || at->Is("continue"))
    {
        m_Code.Line(std::string(at->text) + ";");
        return behind;
    }
    if (at->Is("throw") && behind[-1].Is(";") && WriteThrow({at + 1, behind - 1}))
    {
        return behind;
    }
    const bool isReturn = at->Is("return") && behind[-1].Is(";");
    if (isReturn ? !WriteReturn({at + 1, behind - 1}) : !Fail("'" + std::string(at->text) + "'"))
    {
        Todo({at, behind});
    }
    return behind;
}

/// Writes what stands between { and }, or one statement; its names end with it.
void PortedBody::WriteBlock(Word at, Word end)
{
    const PortScope outer = m_Scope;
    ++m_Depth;
    WriteStatements(at->Is("{") ? at->Inside() : CSharpWords(at, end));
    --m_Depth;
    m_Scope = outer;
}

const CSharpToken* PortedBody::WriteIf(Word at, Word end)
{
    const Word behind = EndOfStatement(at, end);
    const auto condition = Value(at[1].Inside(), "bool");
    if (!condition)
    {
        Todo({at, behind});
        return behind;
    }
    m_Code.Open("if (" + condition->cpp + ")");
    const Word first = at[1].Behind();
    Word next = EndOfStatement(first, end);
    WriteBlock(first, next);
    m_Code.Close();
    bool isReturned = m_IsReturned;
    if (next < end && next->Is("else"))
    {
        m_Code.Open("else");
        WriteBlock(next + 1, behind);
        m_Code.Close();
        isReturned = isReturned && m_IsReturned;
    }
    else
    {
        isReturned = false;
    }
    m_IsReturned = isReturned;
    return behind;
}

/// Returns what a loop does behind each round, or "" if it is not known.
std::string PortedBody::StepText(CSharpWords step)
{
    const bool isBefore = step.front().Is("+") || step.front().Is("-");
    if (step.size() == 3 && (isBefore || step[1].text == step[2].text)) // ++i, i++
    {
        const auto value = Value(isBefore ? step.last(1) : step.first(1));
        const std::string sign(step[1].text == step[2].text ? step[1].text : step[0].text);
        return value ? sign + sign + value->cpp : "";
    }
    if (const auto shifted = ShiftText(step))
    {
        return *shifted;
    }
    return step.size() > 2 ? TranslateAssignment(Place(), step.first(1), step[1].text,
                                                 step.subspan(2), m_Problem)
                                 .value_or("")
                           : "";
}

const CSharpToken* PortedBody::WriteLoop(Word at, Word end)
{
    const Word behind = EndOfStatement(at, end);
    const CSharpWords head = at[1].Inside();
    const Word headEnd = head.data() + head.size();
    const PortScope outer = m_Scope;
    std::string text = "while (";
    CSharpWords condition = head;
    CSharpWords step;
    if (at->Is("for"))
    {
        const Word first = FindOutsideOfBrackets(head.data(), headEnd, {";"});
        const Word second =
            first < headEnd ? FindOutsideOfBrackets(first + 1, headEnd, {";"}) : headEnd;
        Word name = head.data();
        const std::string type = ReadCSharpType(name);
        const bool isCounted = IsIn(type, {"int", "var", "uint"}) && name + 2 < first &&
                               name->isName() && name[1].Is("=") && second < headEnd;
        const std::string counter = type == "uint" ? "uint" : "int";
        const auto start = isCounted ? Value({name + 2, first}, counter) : std::nullopt;
        const bool isBare = first == head.data() && second < headEnd; // for (; a > 1; a >>= 1)
        if (!start && !isBare)
        {
            Fail("a loop of another kind");
            Todo({at, behind});
            return behind;
        }
        text = "for (";
        if (start)
        {
            const PortValue& local = AddLocal(std::string(name->text), counter);
            text += *m_Model.CppType(counter) + " " + local.cpp + " = " + start->cpp;
        }
        text += "; ";
        condition = {first + 1, second};
        step = {second + 1, headEnd};
    }
    const auto test = Value(condition, "bool");
    const std::string stepText = test && !step.empty() ? StepText(step) : "";
    if (!test || (at->Is("for") && stepText.empty()))
    {
        m_Scope = outer;
        Todo({at, behind});
        return behind;
    }
    m_Code.Open(text + test->cpp + (at->Is("for") ? "; " + stepText : "") + ")");
    WriteBlock(at[1].Behind(), behind);
    m_Code.Close();
    m_Scope = outer;
    m_IsReturned = false;
    return behind;
}

const CSharpToken* PortedBody::WriteForEach(Word at, Word end)
{
    const Word behind = EndOfStatement(at, end);
    const CSharpWords head = at[1].Inside();
    const Word headEnd = head.data() + head.size();
    Word name = head.data();
    const std::string type = ReadCSharpType(name);
    const bool isGood = !type.empty() && name + 2 < headEnd && name[1].Is("in");
    const auto list = isGood ? Value({name + 2, headEnd}) : std::nullopt;
    const std::string element = list ? ElementTypeOf(list->type) : "";
    if (element.empty())
    {
        Fail("a loop over something that is neither a list nor an array");
        Todo({at, behind});
        return behind;
    }
    const PortScope outer = m_Scope;
    PortValue& local = AddLocal(std::string(name->text), element);
    local.isLocal = false;
    m_Code.Open("for ([[maybe_unused]] auto& " + local.cpp + " : " + list->cpp + ")");
    WriteBlock(at[1].Behind(), behind);
    m_Code.Close();
    m_Scope = outer;
    m_IsReturned = false;
    return behind;
}

const CSharpToken* PortedBody::WriteSwitch(Word at, Word end)
{
    const Word behind = EndOfStatement(at, end);
    const auto value = Value(at[1].Inside());
    const Word body = at[1].Behind();
    const CSharpClass* own = value ? m_Model.Find(value->type) : nullptr;
    const bool isEnum = own && m_Model.RoleOf(*own) == PortRole::Enum;
    if (!value || !(isEnum || value->type == "int" || m_Model.CppType(value->type) == value->type))
    {
        Fail("'switch' over a '" + (value ? value->type : "") + "'");
        Todo({at, behind});
        return behind;
    }
    std::vector<std::pair<Word, Word>> labels; // `case X:` or `default:`
    const Word last = body->Behind() - 1;
    for (Word word = body + 1; word < last; word = word->Behind())
    {
        if (word->Is("case") || (word->Is("default") && word[1].Is(":")))
        {
            labels.emplace_back(word, FindOutsideOfBrackets(word, last, {":"}));
        }
    }
    for (const auto& [label, colon] : labels)
    {
        if (label->Is("case") && !Value({label + 1, colon}, value->type))
        {
            Todo({at, behind});
            return behind;
        }
    }
    m_Code.Open("switch (" + value->cpp + ")");
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
        const auto& [label, colon] = labels[i];
        const Word next = i + 1 < labels.size() ? labels[i + 1].first : last;
        m_Code.Line(label->Is("case") ? "case " + Value({label + 1, colon}, value->type)->cpp + ":"
                                      : std::string("default:"));
        if (colon + 1 < next)
        {
            m_Code.Open();
            WriteBlock(colon + 1, next);
            m_Code.Close();
        }
    }
    m_Code.Close();
    m_IsReturned = false;
    return behind;
}

const CSharpToken* PortedBody::WriteUsing(Word at, Word end)
{
    const bool hasBlock = at[1].Is("(");
    const Word behind = hasBlock ? EndOfStatement(at, end) : end;
    const CSharpWords head =
        hasBlock ? at[1].Inside() : CSharpWords(at + 1, FindOutsideOfBrackets(at, end, {";"}));
    if (std::ranges::any_of(head, [](const CSharpToken& word)
                            { return !GraphContextOf(word.text).empty(); }))
    {
        return WriteGraphPass(at, end);
    }
    const auto made = std::ranges::find(head, std::string_view("new"), &CSharpToken::text);
    const bool isScope = head.end() - made > 2 && made[2].Is("(") &&
                         IsIn(made[1].text, {"ProfilingScope", "ProfilingSample"});
    const auto arguments = isScope ? SplitArguments(made[2].Inside()) : std::vector<CSharpWords>();
    const auto cmd = arguments.size() == 2 ? Value(arguments[0]) : std::nullopt;
    auto sampler = cmd ? Value(arguments[1]) : std::nullopt;
    if (sampler && sampler->type == "string") // of URP 7
    {
        sampler = PortValue{"ProfilingSampler(" + sampler->cpp + ")", "ProfilingSampler"};
    }
    sampler = sampler ? Converted(m_Model, *sampler, "ProfilingSampler") : sampler;
    if (!sampler || cmd->type == "null")
    {
        const bool isSkipped = cmd && cmd->type == "null"; // a scope on the processor only
        if (!isSkipped)
        {
            Fail("'using' of this");
            Todo({at, hasBlock ? behind : head.data() + head.size() + 1});
        }
        return isSkipped && hasBlock ? at[1].Behind()
               : hasBlock            ? behind
                                     : head.data() + head.size() + 1;
    }
    m_Code.Open();
    const std::string number = m_Scopes == 0 ? "" : std::to_string(m_Scopes + 1);
    m_Code.Line("const ProfilingScope profilingScope" + number + "{" +
                std::string(cmd->isPointer ? "*" : "") + cmd->cpp + ", " + sampler->cpp + "};");
    const PortScope outer = m_Scope;
    const Word body = hasBlock ? at[1].Behind() : head.data() + head.size() + 1;
    ++m_Scopes;
    WriteStatements(hasBlock && body->Is("{") ? body->Inside() : CSharpWords(body, behind));
    --m_Scopes;
    m_Scope = outer;
    m_Code.Close();
    return behind;
}

/// Writes using (var builder = graph.AddRasterRenderPass<PassData>("Name", out var data)) { ... }
const CSharpToken* PortedBody::WriteGraphPass(Word at, Word end)
{
    const bool hasBlock = at[1].Is("(");
    const CSharpWords head =
        hasBlock ? at[1].Inside() : CSharpWords(at + 1, FindOutsideOfBrackets(at, end, {";"}));
    const Word behind = hasBlock ? EndOfStatement(at, end) : end;
    const GraphPassCall call = ReadGraphPass(head);
    const auto cpp = m_Model.CppType(call.data);
    const auto graph = call.isWhole ? Value(call.graph) : std::nullopt;
    const auto title = graph ? Value(call.arguments[0], "string") : std::nullopt;
    const bool isGood = title && cpp && graph->type == "RenderGraph";
    m_Code.Done({"graph pass", m_One.name + "." + call.name,
                 call.arguments.empty() ? "" : m_Model.Text(m_One, call.arguments[0]),
                 m_Model.Place(m_One, call.location), isGood});
    if (!isGood)
    {
        Fail(cpp || call.data.empty()
                 ? "'var builder = renderGraph." + call.name +
                       "<PassData>(name, out var passData)' is expected"
                 : "the type '" + call.data + "' is none of the pass's or file's");
        Todo({at, behind});
        return behind;
    }
    const std::string owner = m_Model.QualifiedName(m_One) + "::";
    const std::string short_ = cpp->starts_with(owner) ? cpp->substr(owner.size()) : *cpp;
    const auto sampler = call.arguments.size() > 2 ? Value(call.arguments[2], "ProfilingSampler")
                                                   : std::nullopt; // it changes no picture
    m_Problem.clear();
    const PortScope outer = m_Scope;
    m_Code.Open();
    PortValue& local = AddLocal(call.dataName, call.data);
    local.isPointer = true;
    local.isLocal = false;
    m_Code.Line(short_ + "* " + local.cpp + " = nullptr;");
    const std::string localName = local.cpp;
    const PortValue& builder = AddLocal(call.builder, BuilderTypeOf(call.name));
    m_Code.Line("auto " + builder.cpp + " = " + graph->cpp + "." + call.name + "<" + short_ + ">(" +
                title->cpp + ", " + localName + (sampler ? ", " + sampler->cpp : "") + ");");
    m_Builders[call.builder] = {call.data, GraphContextOf(call.name)};
    const Word body = hasBlock ? at[1].Behind() : head.data() + head.size() + 1;
    WriteStatements(hasBlock && body->Is("{") ? body->Inside() : CSharpWords(body, behind));
    m_Scope = outer;
    m_Code.Close();
    return behind;
}

bool PortedBody::WriteReturn(CSharpWords words)
{
    if (words.empty())
    {
        m_Code.Line("return;");
        m_IsReturned = true;
        return true;
    }
    const auto value = m_Result == "void" ? std::nullopt : Value(words, m_Result);
    if (value)
    {
        m_Code.Line("return " + value->cpp + ";");
        m_IsReturned = true;
    }
    return value.has_value();
}

/// Writes new Exception("text"), of which the text remains.
bool PortedBody::WriteThrow(CSharpWords words)
{
    if (words.size() < 3 || !words[0].Is("new") || !words.back().Is(")"))
    {
        return false;
    }
    const Word bracket = &words.back() + words.back().match;
    const auto arguments = SplitArguments(bracket->Inside());
    const auto text = arguments.empty() ? std::nullopt : Value(arguments[0], "string");
    m_Problem.clear();
    m_Code.Line("throw ContractError(" +
                (text ? text->cpp : "\"" + m_One.name + ": " + std::string(words[1].text) + "\"") +
                ");");
    m_IsReturned = true;
    return true;
}

/// Takes `this` out of the capture of a function that was written there, if a line that needs it
/// has become a comment.
void PortedBody::TrimThis(std::size_t begin)
{
    const std::size_t open = m_Code.text.find('[', begin);
    const std::size_t close = m_Code.text.find(']', begin);
    const std::string capture = m_Code.text.substr(open, close + 1 - open);
    const std::string_view body = std::string_view(m_Code.text).substr(close);
    const auto isRead = [&](const auto& member)
    {
        return !member.isStatic && ReadsName(body, m_Model.CppName(member.name), true);
    };
    const bool needsThis = ReadsName(body, "this") || std::ranges::any_of(m_One.fields, isRead) ||
                           std::ranges::any_of(m_One.methods, isRead);
    if (!needsThis && capture.find("this") != std::string::npos)
    {
        m_Code.text.replace(open, capture.size(), capture == "[this]" ? "[]" : "[=]");
    }
}

/// Writes builder.SetRenderFunc((PassData data, RasterGraphContext context) => ...)
bool PortedBody::WriteRenderFunction(CSharpWords words)
{
    const auto& [data, context] = m_Builders.at(std::string(words[0].text));
    const RenderFunction function = ReadRenderFunction(words.subspan(3));
    if (!function.problem.empty())
    {
        return Fail(function.problem);
    }
    const std::vector<std::string>& names = function.parameters;
    const std::string builder = m_Scope.at(std::string(words[0].text)).cpp;
    const std::string capture =
        CaptureOf(m_One, m_Scope, function.body, {names.begin(), names.end()});
    const PortScope outer = m_Scope;
    const auto add = [&](std::size_t i, const std::string& type)
    {
        PortValue& value =
            AddLocal(names[i] == "_" ? "unused" + std::to_string(i) : names[i], type);
        const bool isTaken = outer.contains(names[i]) && outer.at(names[i]).cpp == value.cpp;
        value.cpp += isTaken ? "_" : "";
        return value.cpp;
    };
    const std::string first = add(0, data);
    const std::string second = add(1, context);
    const std::string cpp = *m_Model.CppType(data);
    const std::string owner = m_Model.QualifiedName(m_One) + "::";
    const std::size_t begin = m_Code.text.size();
    m_Code.Open(builder + ".SetRenderFunc(" + capture + "([[maybe_unused]] " +
                (cpp.starts_with(owner) ? cpp.substr(owner.size()) : cpp) + "& " + first +
                ", [[maybe_unused]] " + context + "& " + second + ")");
    const std::string result = std::exchange(m_Result, "void");
    const CSharpMethod* method =
        function.isGroup ? m_One.FindMethod(function.body[0].text) : nullptr;
    if (method && SignatureOf(m_Model, m_One, *method))
    {
        m_Code.Line(m_Model.CppName(method->name) + "(" + first + ", " + second + ");");
    }
    else if (function.isBlock)
    {
        WriteStatements(function.body);
    }
    else if (function.isGroup || !WriteSimple(function.body))
    {
        Todo(function.body);
    }
    m_Result = result;
    m_IsReturned = false;
    m_Scope = outer;
    m_Code.Close("});");
    TrimThis(begin);
    return true;
}

} // namespace limn
