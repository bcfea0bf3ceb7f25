#include "port/UsedMembers.h"

#include "port/UseScanner.h"

namespace limn
{

namespace
{

/// The parts of a class one by one.
class ClassScan
{
public:
    explicit ClassScan(UseScanner& scanner) : m_Scanner(scanner) {}

    void Scan(const CSharpClass& one)
    {
        m_Scanner.Enter(one);
        for (const std::string& base : one.bases)
        {
            m_Scanner.UseType(base, one.location);
        }
        for (const CSharpField& field : one.fields)
        {
            ScanField(field);
        }
        for (const CSharpEnumerator& enumerator : one.enumerators)
        {
            m_Scanner.ScanWords(enumerator.value);
        }
        for (const CSharpMethod& method : one.methods)
        {
            ScanMethod(one, method);
        }
        for (const CSharpClass& nested : one.classes)
        {
            Scan(nested);
        }
        m_Scanner.Leave();
    }

private:
    void ScanField(const CSharpField& field)
    {
        m_Scanner.UseType(field.type, field.location);
        for (const CSharpAttribute& attribute : field.attributes)
        {
            m_Scanner.UseAttribute(attribute.name, field.location);
        }
        m_Scanner.BeginMethod();
        m_Scanner.ScanWords(field.value);
    }

    void ScanMethod(const CSharpClass& one, const CSharpMethod& method)
    {
        m_Scanner.BeginMethod();
        m_Scanner.UseType(method.type, method.location);
        for (const CSharpParameter& parameter : method.parameters)
        {
            m_Scanner.UseType(parameter.type, method.location);
            m_Scanner.Declare(parameter.name, parameter.type);
        }
        if (method.isOverride)
        {
            m_Scanner.UseOverride(one, method);
        }
        m_Scanner.ScanWords(method.base);
        m_Scanner.ScanWords(method.body);
    }

    UseScanner& m_Scanner;
};

} // namespace

std::vector<UsedMember> UsedMembersOf(const CSharpFiles& files, const PortingTable& table)
{
    UseScanner scanner(files, table);
    for (const auto& file : files)
    {
        scanner.SetFile(*file);
        for (const CSharpClass& one : file->classes)
        {
            ClassScan(scanner).Scan(one);
        }
    }
    return scanner.TakeUses();
}

} // namespace limn
