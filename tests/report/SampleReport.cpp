// Writes the report of a study that is made up: SampleReport FOLDER

#include "../editor_stub/report/pages/SampleStudy.h"
#include "report/pages/WriteReport.h"

#include <iostream>
#include <limn/core/Image.h>

namespace
{

/// As `limn report` leaves them: of each cell that is pictured, three files.
void AddPictures(limn::study::Study& sample, const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder / "pictures");
    for (limn::study::CellResult& cell : sample.cells)
    {
        if (cell.id.kind == limn::study::CellKind::Geometry && cell.id.subject == "disc" &&
            cell.id.width == 8.0 && cell.id.variant.empty())
        {
            for (const char* kind : {"picture", "reference", "difference"})
            {
                limn::Image image{64, 64, limn::GraphicsFormat::R8G8B8A8_SRGB, {}};
                image.texels.assign(64 * 64 * 4, std::byte{200});
                const std::string name =
                    "pictures/" + std::to_string(&cell - sample.cells.data()) + "." + kind + ".png";
                limn::WritePng(folder / name, image);
                cell.pictures[kind] = name;
            }
        }
    }
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 2)
    {
        std::cerr << "which folder?\n";
        return 2;
    }
    std::filesystem::create_directories(arguments[1]);
    limn::study::Study sample = limn::test::FullSample();
    AddPictures(sample, arguments[1]);
    limn::study::ReportOptions options;
    options.budgetMilliseconds = 2.0;
    options.remarks = {"It is <made up>."};
    const limn::study::ReportFiles files = limn::study::WriteReport(sample, arguments[1], options);
    std::cout << files.recommendation << '\n';
    return 0;
}
