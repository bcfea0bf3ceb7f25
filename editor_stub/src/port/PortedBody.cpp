#include "port/PortedBody.h"

#include "port/PortMember.h"

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

/// Returns the first word outside of brackets that is one of these, or `end`.
const CSharpToken* FindOutside(const CSharpToken* at, const CSharpToken* end,
                               std::initializer_list<std::string_view> words)
{
    while (at < end && !(at->kind == CSharpTokenKind::Punctuation && IsIn(at->text, words)))
    {
        at = at->Behind();
    }
    return std::min(at, end);
}

/// Returns the type of a class's parameter, as it is called outside of the class.
std::string TypeIn(const PortModel& model, const CSharpClass& one, const CSharpParameter& parameter)
{
    const PortContext context(model, one);
    const CSharpClass* own = model.FindPlain(parameter.type);
    return Replaced(own ? model.QualifiedName(*own) : parameter.type, "::", ".");
}

/// Returns whether the argument must be a variable.
bool isMutableReference(const PortModel& model, const CSharpClass& one,
                        const CSharpParameter& parameter)
{
    const PortContext context(model, one);
    const auto type = model.CppParameter(parameter);
    return type && type->ends_with("&") && !type->starts_with("const ");
}

/// Returns the type of the builder that the call gives.
std::string BuilderOf(std::string_view call)
{
    return call == "AddRasterRenderPass" ? "IRasterRenderGraphBuilder"
           : call == "AddUnsafePass"     ? "IUnsafeRenderGraphBuilder"
                                         : "IComputeRenderGraphBuilder";
}

bool IsReferenceWord(const CSharpToken& word)
{
    return word.Is("ref") || word.Is("in") || word.Is("out");
}

} // namespace

std::optional<std::string> PortArgument(const PortPlace& place, const CSharpClass& owner,
                                        const CSharpParameter& parameter, CSharpWords words,
                                        std::string& problem)
{
    words = !words.empty() && IsReferenceWord(words[0]) ? words.subspan(1) : words;
    const auto value = Translate(place, words, TypeIn(place.model, owner, parameter), &problem);
    const bool isFit =
        value && (value->isVariable || !isMutableReference(place.model, owner, parameter) ||
                  value->cpp.starts_with("*"));
    return isFit ? std::optional(value->cpp) : std::nullopt;
}

std::optional<std::string> MakePass(const PortPlace& place, const CSharpClass& pass,
                                    const std::vector<CSharpWords>& arguments, std::string& problem)
{
    const PortModel& model = place.model;
    const auto fits = [&](const CSharpMethod& method)
    {
        return method.isConstructor() && !method.isStatic &&
               method.parameters.size() == arguments.size() && SignatureOf(model, pass, method);
    };
    const auto constructor = std::ranges::find_if(pass.methods, fits);
    const bool hasNone = std::ranges::none_of(pass.methods, &CSharpMethod::isConstructor);
    if (model.isLeftOut(pass) ||
        (constructor == pass.methods.end() && !(hasNone && arguments.empty())))
    {
        return std::nullopt;
    }
    std::string text = "std::make_unique<" + model.QualifiedName(pass) + ">(";
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
        const auto argument =
            PortArgument(place, pass, constructor->parameters[i], arguments[i], problem);
        if (!argument)
        {
            return std::nullopt;
        }
        text += (i == 0 ? "" : ", ") + *argument;
    }
    return text + ")";
}

PortedBody::PortedBody(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
    : m_Code(code),
      m_Model(code.model()),
      m_One(one),
      m_Method(method),
      m_Scope(ScopeOf(m_Model, one, method)),
      m_Result(method.isConstructor() ? "void" : method.type)
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

bool PortedBody::Fail(const std::string& problem)
{
    m_Problem = m_Problem.empty() ? problem : m_Problem;
    return false;
}

std::optional<PortValue> PortedBody::Value(CSharpWords words, const std::string& wanted)
{
    return Translate(Place(), words, wanted, &m_Problem);
}

void PortedBody::Todo(CSharpWords words, const std::string& otherwise)
{
    const std::string why = m_Problem.empty() ? otherwise : InComment(m_Problem);
    m_Code.Todo(why, m_Model.Place(m_One, words.front().location), TextOf(*m_One.file, words));
    m_Problem.clear();
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

/// Returns the word behind the statement that begins at `at`.
const CSharpToken* PortedBody::EndOf(Word at, Word end) const
{
    if (at >= end || at->Is("{"))
    {
        return at < end ? std::min(at->Behind(), end) : end;
    }
    const bool hasHead = IsIn(at->text, {"if", "for", "foreach", "while", "switch", "lock"}) ||
                         (at->Is("using") && at[1].Is("("));
    if (at->Is("else") || at->Is("do") || at->Is("try") || at->Is("finally"))
    {
        return EndOf(at + 1, end);
    }
    if (!hasHead || !at[1].Is("("))
    {
        return std::min(FindOutside(at, end, {";"}) + 1, end);
    }
    const Word behind = EndOf(at[1].Behind(), end);
    return at->Is("if") && behind < end && behind->Is("else") ? EndOf(behind + 1, end) : behind;
}

const CSharpToken* PortedBody::WriteStatement(Word at, Word end)
{
    if (at->Is(";"))
    {
        return at + 1;
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
               IsIn(word.text, {"if", "for", "foreach", "while", "do", "switch", "using", "return",
                                "break", "continue", "throw", "try", "lock", "goto", "yield",
                                "fixed", "unsafe", "checked", "unchecked"});
    };
    if (isKeyword(*at) && !at[1].Is("="))
    {
        return WriteKeyword(at, end);
    }
    const Word behind = EndOf(at, end);
    const CSharpWords words(at, behind[-1].Is(";") ? behind - 1 : behind);
    if (!WriteSimple(words))
    {
        Todo({at, behind});
    }
    return behind;
}

const CSharpToken* PortedBody::WriteKeyword(Word at, Word end)
{
    const Word behind = EndOf(at, end);
    if (at->Is("if"))
    {
        return WriteIf(at, end);
    }
    if (at->Is("for") || at->Is("while"))
    {
        return WriteLoop(at, end);
    }
    if (at->Is("foreach"))
    {
        return WriteForEach(at, end);
    }
    if (at->Is("switch") && at[1].Is("("))
    {
        return WriteSwitch(at, end);
    }
    if (at->Is("using"))
    {
        return WriteUsing(at, end);
    }
    if (at->Is("break") || at->Is("continue"))
    {
        m_Code.Line(std::string(at->text) + ";");
        return behind;
    }
    if (at->Is("return") ? !WriteReturn({at + 1, behind - 1})
                         : !Fail("'" + std::string(at->text) + "'"))
    {
        Todo({at, behind});
    }
    return behind;
}

/// Writes what stands between { and }, or one statement; its names end with it.
void PortedBody::WriteBlock(Word at, Word end)
{
    const PortScope outer = m_Scope;
    WriteStatements(at->Is("{") ? at->Inside() : CSharpWords(at, end));
    m_Scope = outer;
}

const CSharpToken* PortedBody::WriteIf(Word at, Word end)
{
    const Word behind = EndOf(at, end);
    const auto condition = Value(at[1].Inside(), "bool");
    if (!condition)
    {
        Todo({at, behind});
        return behind;
    }
    m_Code.Open("if (" + condition->cpp + ")");
    const Word first = at[1].Behind();
    Word next = EndOf(first, end);
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

const CSharpToken* PortedBody::WriteLoop(Word at, Word end)
{
    const Word behind = EndOf(at, end);
    const CSharpWords head = at[1].Inside();
    const Word headEnd = head.data() + head.size();
    const PortScope outer = m_Scope;
    std::string text = "while (";
    CSharpWords condition = head;
    CSharpWords step;
    if (at->Is("for"))
    {
        const Word first = FindOutside(head.data(), headEnd, {";"});
        const Word second = first < headEnd ? FindOutside(first + 1, headEnd, {";"}) : headEnd;
        Word name = head.data();
        const std::string type = ReadCSharpType(name);
        const bool isCounted = IsIn(type, {"int", "var", "uint"}) && name + 2 < first &&
                               name->isName() && name[1].Is("=") && second < headEnd;
        const std::string counter = type == "uint" ? "uint" : "int";
        const auto start = isCounted ? Value({name + 2, first}, counter) : std::nullopt;
        if (!start)
        {
            Fail("a loop of another kind");
            Todo({at, behind});
            return behind;
        }
        const PortValue& local = AddLocal(std::string(name->text), counter);
        text = "for (" + *m_Model.CppType(counter) + " " + local.cpp + " = " + start->cpp + "; ";
        condition = {first + 1, second};
        step = {second + 1, headEnd};
    }
    const auto test = Value(condition, "bool");
    std::string stepText;
    if (test && !step.empty())
    {
        const bool isBefore = step.front().Is("+") || step.front().Is("-");
        if (step.size() == 3 && (isBefore || step[1].text == step[2].text)) // ++i, i++
        {
            const auto value = Value(isBefore ? step.last(1) : step.first(1));
            const std::string sign(step[1].text);
            stepText = value ? sign + sign + value->cpp : "";
        }
        else if (step.size() > 2)
        {
            stepText = TranslateAssignment(Place(), step.first(1), step[1].text, step.subspan(2),
                                           m_Problem)
                           .value_or("");
        }
    }
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
    const Word behind = EndOf(at, end);
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
    local.isPointer = false;
    m_Code.Open("for ([[maybe_unused]] auto& " + local.cpp + " : " + list->cpp + ")");
    WriteBlock(at[1].Behind(), behind);
    m_Code.Close();
    m_Scope = outer;
    m_IsReturned = false;
    return behind;
}

const CSharpToken* PortedBody::WriteSwitch(Word at, Word end)
{
    const Word behind = EndOf(at, end);
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
            labels.emplace_back(word, FindOutside(word, last, {":"}));
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
        m_Code.Line(label->Is("case")
                        ? "case " + Value({label + 1, colon}, value->type)->cpp + ":"
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
    const Word behind = hasBlock ? EndOf(at, end) : end;
    const CSharpWords head = hasBlock ? at[1].Inside()
                                      : CSharpWords(at + 1, FindOutside(at, end, {";"}));
    if (std::ranges::any_of(head, [](const CSharpToken& word)
                            { return !GraphContextOf(word.text).empty(); }))
    {
        return WriteGraphPass(at, end);
    }
    const auto made = std::ranges::find(head, std::string_view("new"), &CSharpToken::text);
    const bool isScope = head.end() - made > 2 && made[1].Is("ProfilingScope") && made[2].Is("(");
    const auto arguments = isScope ? SplitArguments(made[2].Inside()) : std::vector<CSharpWords>();
    const auto cmd = arguments.size() == 2 ? Value(arguments[0]) : std::nullopt;
    const auto sampler = cmd ? Value(arguments[1], "ProfilingSampler") : std::nullopt;
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
    m_Code.Line("const ProfilingScope profilingScope{" + std::string(cmd->isPointer ? "*" : "") +
                cmd->cpp + ", " + sampler->cpp + "};");
    const PortScope outer = m_Scope;
    const Word body = hasBlock ? at[1].Behind() : head.data() + head.size() + 1;
    WriteStatements(hasBlock && body->Is("{") ? body->Inside() : CSharpWords(body, behind));
    m_Scope = outer;
    m_Code.Close();
    return behind;
}

/// using (var builder = graph.AddRasterRenderPass<PassData>("Name", out var data)) { ... }
const CSharpToken* PortedBody::WriteGraphPass(Word at, Word end)
{
    const bool hasBlock = at[1].Is("(");
    const CSharpWords head = hasBlock ? at[1].Inside()
                                      : CSharpWords(at + 1, FindOutside(at, end, {";"}));
    const Word headEnd = head.data() + head.size();
    const Word behind = hasBlock ? EndOf(at, end) : end;
    const auto call = std::ranges::find_if(head, [](const CSharpToken& word)
                                           { return !GraphContextOf(word.text).empty(); });
    Word open = &*call + 1;
    const std::string generics = open->Is("<") ? ReadCSharpGenerics(open) : "";
    const auto arguments =
        open < headEnd && open->Is("(") ? SplitArguments(open->Inside()) : std::vector<CSharpWords>();
    std::string data = generics.size() > 2 ? generics.substr(1, generics.size() - 2) : "";
    CSharpWords out = arguments.size() > 1 ? arguments[1] : CSharpWords();
    Word type = out.size() > 2 ? &out[1] : nullptr;
    const std::string declared = type && out[0].Is("out") ? ReadCSharpType(type) : "";
    data = data.empty() && declared != "var" ? declared : data;
    Word name = head.data();
    const bool isDeclared = !ReadCSharpType(name).empty() && name < headEnd && name->isName() &&
                            name[1].Is("=");
    const auto cpp = m_Model.CppType(data);
    const auto graph =
        isDeclared && &*call - name > 3 ? Value({name + 2, &*call - 1}) : std::nullopt;
    const auto title = graph ? Value(arguments[0], "string") : std::nullopt;
    const bool isGood = title && cpp && !declared.empty() && graph->type == "RenderGraph";
    m_Code.Done({"graph pass", m_One.name + "." + std::string(call->text),
                 arguments.empty() ? "" : m_Model.Text(m_One, arguments[0]),
                 m_Model.Place(m_One, call->location), isGood});
    if (!isGood)
    {
        Fail(cpp ? "'var builder = renderGraph." + std::string(call->text) +
                       "<PassData>(name, out var passData)' is expected"
                 : "the type '" + data + "' is none of the pass's or file's");
        Todo({at, behind});
        return behind;
    }
    const std::string owner = m_Model.QualifiedName(m_One) + "::";
    const std::string short_ = cpp->starts_with(owner) ? cpp->substr(owner.size()) : *cpp;
    const auto sampler = arguments.size() > 2 ? Value(arguments[2], "ProfilingSampler")
                                              : std::nullopt; // it changes no picture
    m_Problem.clear();
    const PortScope outer = m_Scope;
    m_Code.Open();
    PortValue& local = AddLocal(std::string(out.back().text), data);
    local.isPointer = true;
    m_Code.Line(short_ + "* " + local.cpp + " = nullptr;");
    const std::string localName = local.cpp;
    const PortValue& builder = AddLocal(std::string(name->text), BuilderOf(call->text));
    m_Code.Line("auto " + builder.cpp + " = " + graph->cpp + "." + std::string(call->text) + "<" +
                short_ + ">(" + title->cpp + ", " + localName + (sampler ? ", " + sampler->cpp : "") +
                ");");
    m_Builders[std::string(name->text)] = {data, GraphContextOf(call->text)};
    const Word body = hasBlock ? at[1].Behind() : headEnd + 1;
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

/// Writes a statement without its semicolon: a declaration, an assignment, a call.
bool PortedBody::WriteSimple(CSharpWords words)
{
    Word at = words.data();
    const Word end = at + words.size();
    if (at < end && at->Is("const"))
    {
        words = words.subspan(1);
        ++at;
    }
    const bool isReference = at < end && at->Is("ref");
    Word name = at + (isReference ? 1 : 0);
    const std::string type = ReadCSharpType(name);
    const bool isDeclaration = !type.empty() && name < end && name->isName() &&
                               !IsIn(name->text, {"is", "as", "in"}) &&
                               (name + 1 == end || name[1].Is("=") || name[1].Is(","));
    if (isDeclaration)
    {
        return WriteDeclaration(words);
    }
    const Word equals =
        FindOutside(at, end, {"=", "+=", "-=", "*=", "/=", "|=", "&=", "%="});
    const Word shift = FindOutside(at, end, {">="});
    if (shift < end && shift > at && shift[-1].Is(">") && equals == end) // a >>= b
    {
        const auto target = Value({at, shift - 1}, "int");
        const auto bits = target && target->isVariable ? Value({shift + 1, end}, "int") : std::nullopt;
        if (bits)
        {
            m_Code.Line(target->cpp + " >>= " + bits->cpp + ";");
        }
        return bits.has_value();
    }
    if (equals < end)
    {
        return WriteAssignment({at, equals}, equals->text, {equals + 1, end});
    }
    if (std::ranges::count(words, std::string_view("?."), &CSharpToken::text) > 0)
    {
        return WriteMaybe(words);
    }
    if (words.size() > 4 && words[1].Is(".") && words[2].Is("SetRenderFunc") &&
        m_Builders.contains(std::string(words[0].text)))
    {
        return WriteRenderFunction(words);
    }
    const bool isStep = words.size() > 2 && (words.back().Is("+") || words.back().Is("-"));
    if (isStep)
    {
        const auto value = Value(words.first(words.size() - 2));
        if (value)
        {
            m_Code.Line((words.back().text[0] == '+' ? "++" : "--") + value->cpp + ";");
        }
        return value.has_value();
    }
    const auto value = Value(words);
    if (!value)
    {
        return false;
    }
    // A pass that was not made would be called through nothing.
    if (value->cpp.find(".EnqueuePass(*") != std::string::npos)
    {
        const std::size_t open = value->cpp.find("(*") + 2;
        const std::string pass = value->cpp.substr(open, value->cpp.size() - open - 1);
        if (!m_Code.isMade(pass))
        {
            m_Code.Open("if (" + pass + ")");
            m_Code.Line(value->cpp + ";");
            m_Code.Close();
            m_Code.Open("else");
            m_Code.Line("Debug::LogWarning(\"" + m_One.name + ": '" + pass +
                        "' is not drawn, Create does not make it\");");
            m_Code.Close();
            return true;
        }
    }
    m_Code.Line(value->cpp + ";");
    return true;
}

bool PortedBody::WriteDeclaration(CSharpWords words)
{
    Word at = words.data();
    const Word end = at + words.size();
    const bool isReference = at->Is("ref");
    at += isReference ? 1 : 0;
    const std::string type = ReadCSharpType(at);
    while (at < end)
    {
        const std::string name(at->text);
        const Word comma = FindOutside(at, end, {","});
        Word value = at + (at + 1 < comma && at[1].Is("=") ? 2 : 1);
        value += value < comma && value->Is("ref") ? 1 : 0;
        if (!DeclareLocal(type, name, {value, comma}, isReference))
        {
            return false;
        }
        at = std::min(comma + 1, end);
    }
    return true;
}

PortValue& PortedBody::AddLocal(const std::string& name, const std::string& type)
{
    PortValue value{LocalName(m_Model, m_One, name), type};
    value.isVariable = true;
    return m_Scope[name] = value;
}

bool PortedBody::DeclareLocal(const std::string& type, const std::string& name, CSharpWords words,
                              bool isReference)
{
    const std::string wanted = type == "var" ? "" : type;
    if (words.empty())
    {
        const auto cpp = m_Model.CppType(wanted);
        if (!cpp || IsReferenceType(m_Model, wanted))
        {
            return Fail("'" + type + "' without a value");
        }
        m_Code.Line("[[maybe_unused]] " + *cpp + " " + AddLocal(name, wanted).cpp + PortModel::CppDefault(*cpp) + ";");
        return true;
    }
    // new T(...) { a = 1 }
    const auto braces = words.front().Is("new") && words.back().Is("}")
                            ? std::ranges::find(words, std::string_view("{"), &CSharpToken::text)
                            : words.end();
    const bool hasMembers = braces != words.end() && braces->Inside().size() > 2 &&
                            braces->Inside()[1].Is("=");
    const CSharpWords object(words.begin(), hasMembers ? braces : words.end());
    const bool isBare = hasMembers && !object.back().Is(")");
    Word bare = object.data() + 1;
    const std::string bareType = isBare ? ReadCSharpType(bare) : "";
    auto value = isBare ? PortMembers(Place(), m_Problem).Construct(bareType, {})
                        : Value(object, IsReferenceType(m_Model, wanted) ? "" : wanted);
    const bool isProperty = !value && wanted == "int" && !isBare;
    if (isProperty) // int id = Shader.PropertyToID("_X")
    {
        std::string problem;
        value = Translate(Place(), object, "", &problem);
        value = value && value->type == k_PropertyIdType ? value : std::nullopt;
        m_Problem = value ? "" : m_Problem;
    }
    if (!value || value->type == "void" || (value->type == "null" && wanted.empty()))
    {
        return false;
    }
    const bool isOther = isReference || (value->isVariable && IsReferenceType(m_Model, value->type));
    PortValue& local = AddLocal(name, value->type.empty() ? wanted : value->type);
    const auto cpp = wanted.empty() || isProperty || isOther || value->isPointer ? std::nullopt : m_Model.CppType(wanted);
    local.isPointer = value->isPointer;
    local.type = cpp && value->type == "null" ? wanted : local.type;
    if (!cpp && value->cpp.starts_with("{") && !m_Model.CppType(value->type))
    {
        return Fail("a list of '" + ElementTypeOf(value->type) + "'");
    }
    const auto listed = !cpp && value->cpp.starts_with("{") ? m_Model.CppType(value->type) : cpp;
    const std::string keyword = listed && !cpp ? *listed + " " : cpp && *cpp != "ShaderPropertyId" ? *cpp + " "
                                : isOther && !value->isPointer    ? "auto& "
                                                                  : "auto ";
    const bool isText = value->type == "string" && value->cpp.starts_with("\"");
    const std::string made = isText ? "std::string(" + value->cpp + ")" : value->cpp;
    m_Code.Line("[[maybe_unused]] " + std::string(isText && wanted.empty() ? "auto " : keyword) + local.cpp + " = " +
                (cpp && value->cpp == "{}" ? *cpp + "{}" : made) + ";");
    return !hasMembers || WriteMembers(local, braces->Inside());
}

/// a = 1, b = 2 of an object that was just made.
bool PortedBody::WriteMembers(const PortValue& object, CSharpWords members)
{
    const PortValue value = object;
    PortScope scope = m_Scope;
    for (const CSharpWords& member : SplitArguments(members))
    {
        if (member.size() < 3 || !member[1].Is("="))
        {
            return Fail("'new' with this in its braces");
        }
        std::string problem;
        const auto found = PortMembers(Place(), problem)
                               .MemberOf(value, {std::string(member[0].text), "", false, {}, true});
        const auto setter = PortMembers(Place(), problem)
                                .Setter(value, {std::string(member[0].text), "", false, {}, true},
                                        member.subspan(2));
        const auto assigned =
            setter || !found || !found->isVariable
                ? std::nullopt
                : AssignmentTo(Place(), *found, "=", member.subspan(2), m_Problem);
        if (setter || assigned)
        {
            const std::string text = setter ? *setter : *assigned;
            if (text != "-")
            {
                m_Code.Line(text + ";");
            }
        }
        else
        {
            m_Problem = m_Problem.empty() ? problem : m_Problem;
            Todo(member);
        }
    }
    return true;
}

bool PortedBody::WriteAssignment(CSharpWords target, std::string_view word, CSharpWords value)
{
    if (target.empty() || value.empty() || target.back().Is("?\?"))
    {
        return Fail("an assignment of this kind");
    }
    const auto name = target.back().text;
    const PassMember* member = FindPassMember(name);
    const CSharpField* field = target.size() == 1 ? m_One.FindField(name) : nullptr;
    const CSharpClass* own = field ? m_Model.FindPlain(field->type) : nullptr;
    const bool isPass = own && m_Model.RoleOf(*own) == PortRole::Pass && word == "=";
    // new P() { renderPassEvent = X }
    const bool hasMembers = value.front().Is("new") && value.back().Is("}") && value.size() > 3;
    const Word braces = hasMembers ? &value.back() + value.back().match : nullptr;
    const CSharpWords members = braces && braces->Is("{") ? braces->Inside() : CSharpWords();
    const bool isMade = members.size() > 2 && members[1].Is("=");
    const CSharpWords object = isMade ? CSharpWords(value.data(), braces) : value;
    auto text = TranslateAssignment(Place(), target, word, object, m_Problem);
    if (member)
    {
        const bool isOwn = target.size() < 3 || target[0].Is("this") || target[0].Is("base");
        const CSharpField* other = isOwn ? nullptr : m_One.FindField(target[0].text);
        m_Code.Done({member->what, (isOwn ? m_One.name : other ? other->type : "") + "." + member->name,
                     m_Model.Text(m_One, value), m_Model.Place(m_One, target.front().location),
                     text.has_value()});
    }
    if (isPass)
    {
        m_Code.Done({"made in " + m_Method.name, m_One.name + "." + field->name,
                     m_Model.Text(m_One, value), m_Model.Place(m_One, value.front().location),
                     text.has_value()});
    }
    if (!text)
    {
        return false;
    }
    if (!text->empty())
    {
        m_Code.Line(*text + ";");
    }
    if (isPass)
    {
        m_Code.Make(m_Model.CppName(field->name));
    }
    if (isMade)
    {
        const auto whole = Value(target);
        return whole && WriteMembers(*whole, members);
    }
    return true;
}

/// a?.b(c) as a statement.
bool PortedBody::WriteMaybe(CSharpWords words)
{
    const Word end = words.data() + words.size();
    const Word mark = FindOutside(words.data(), end, {"?."});
    const auto object = mark < end ? Value({words.data(), mark}) : std::nullopt;
    if (!object || mark + 1 == end || !mark[1].isName())
    {
        return Fail("'?.' within an expression");
    }
    PortName name;
    name.name = mark[1].text;
    name.isCall = mark + 2 < end && mark[2].Is("(");
    name.arguments = name.isCall ? SplitArguments(mark[2].Inside()) : name.arguments;
    const bool isWhole = name.isCall && mark[2].Behind() == end;
    const auto call = isWhole ? PortMembers(Place(), m_Problem).MemberOf(*object, name)
                              : std::nullopt;
    if (!call)
    {
        return Fail("'?.' of this");
    }
    const bool isPointer = object->isPointer || IsSharedType(m_Model, object->type);
    if (isPointer)
    {
        m_Code.Open("if (" + object->cpp + ")");
    }
    m_Code.Line(call->cpp + ";");
    if (isPointer)
    {
        m_Code.Close();
    }
    return true;
}

/// Returns what a function in place takes along: names of the method's, and members of its object.
std::string PortedBody::CaptureOf(CSharpWords body, const std::set<std::string>& own) const
{
    bool hasLocals = false;
    bool hasMembers = false;
    for (std::size_t i = 0; i < body.size(); ++i)
    {
        const std::string name(body[i].text);
        if (!body[i].isName() || (i > 0 && body[i - 1].Is(".") && !(i > 1 && body[i - 2].Is("this"))) ||
            own.contains(name))
        {
            continue;
        }
        const CSharpField* field = m_One.FindField(name);
        const CSharpMethod* method = m_One.FindMethod(name);
        hasMembers = hasMembers || (field && !field->isStatic) || (method && !method->isStatic) ||
                     name == "this";
        hasLocals = hasLocals || (!field && m_Scope.contains(name));
    }
    return hasLocals ? hasMembers ? "[=, this]" : "[=]" : hasMembers ? "[this]" : "[]";
}

/// builder.SetRenderFunc((PassData data, RasterGraphContext context) => ...)
bool PortedBody::WriteRenderFunction(CSharpWords words)
{
    const auto& [data, context] = m_Builders.at(std::string(words[0].text));
    Word open = &words[3];
    if (open->Is("<"))
    {
        ReadCSharpGenerics(open);
    }
    if (!open->Is("(") || open->Inside().empty())
    {
        return Fail("'SetRenderFunc' of this");
    }
    CSharpWords function = open->Inside();
    function = function.front().Is("static") ? function.subspan(1) : function;
    const bool isGroup = function.size() == 1;
    const Word arrow = isGroup ? nullptr : function.front().Behind();
    std::vector<std::string> names{"data", "context"};
    CSharpWords body;
    if (!isGroup)
    {
        const auto parameters = function.front().Is("(") ? SplitArguments(function.front().Inside())
                                                         : std::vector<CSharpWords>();
        if (parameters.size() != 2 || !arrow->Is("=>"))
        {
            return Fail("a function of two parameters is expected");
        }
        names = {std::string(parameters[0].back().text), std::string(parameters[1].back().text)};
        const Word end = function.data() + function.size();
        body = arrow[1].Is("{") ? arrow[1].Inside() : CSharpWords(arrow + 1, end);
    }
    const std::string builder = m_Scope.at(std::string(words[0].text)).cpp;
    const std::string capture = isGroup ? CaptureOf(function, {}) : CaptureOf(body, {names[0], names[1]});
    const PortScope outer = m_Scope;
    const auto add = [&](std::size_t i, const std::string& type)
    {
        PortValue& value = AddLocal(names[i] == "_" ? "unused" + std::to_string(i) : names[i], type);
        const bool isTaken = outer.contains(names[i]) && outer.at(names[i]).cpp == value.cpp;
        value.cpp += isTaken ? "_" : "";
        return value.cpp;
    };
    const std::string first = add(0, data);
    const std::string second = add(1, context);
    const std::string cpp = *m_Model.CppType(data);
    const std::string owner = m_Model.QualifiedName(m_One) + "::";
    m_Code.Open(builder + ".SetRenderFunc(" + capture + "([[maybe_unused]] " +
                (cpp.starts_with(owner) ? cpp.substr(owner.size()) : cpp) + "& " + first +
                ", [[maybe_unused]] " + context + "& " + second + ")");
    const std::string result = std::exchange(m_Result, "void");
    if (isGroup)
    {
        const CSharpMethod* method = m_One.FindMethod(function[0].text);
        if (method && SignatureOf(m_Model, m_One, *method))
        {
            m_Code.Line(m_Model.CppName(method->name) + "(" + first + ", " + second + ");");
        }
        else
        {
            Todo(function);
        }
    }
    else if (arrow[1].Is("{"))
    {
        WriteStatements(body);
    }
    else if (!WriteSimple(body))
    {
        Todo(body);
    }
    m_Result = result;
    m_IsReturned = false;
    m_Scope = outer;
    m_Code.Close("});");
    return true;
}

void NoteGraphPasses(PortedCode& code, const CSharpClass& one, const CSharpMethod& method)
{
    const PortModel& model = code.model();
    for (const CSharpToken& word : method.body)
    {
        if (!GraphContextOf(word.text).empty())
        {
            code.Done({"graph pass", one.name + "." + std::string(word.text), "",
                       model.Place(one, word.location), false});
        }
    }
}

} // namespace limn
