// How fast STEP files are written, beside OpenCASCADE's own writer: step_bench BOARD [SOLIDS [alone [polylines]]].
// About so many distinct solids of the board's copper (2,000 when not said; every pad written out) are written, the
// best of three runs, then read back, and the shapes that were read handed to STEPControl_Writer, once; reading is not
// counted. With `alone` only the first is done, for more solids than OpenCASCADE has time for; with `polylines` as
// StepOptions::hasPolylines. Processor time.

#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <limits>

#include "app/verify/expected_solids.h"
#include "model/export/solids/step_export.h"
#include "model/formats/registry.h"

namespace {

namespace fs = std::filesystem;

template <class Call>
double secondsOf(const Call& call) {
    const std::clock_t start = std::clock();
    call();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void print(const char* who, std::size_t solids, double seconds, const fs::path& path) {
    std::printf("%-14s %7zu solids %8.3f s %9.0f solids/s %8.1f MB\n", who, solids, seconds,
                static_cast<double>(solids) / seconds, static_cast<double>(fs::file_size(path)) / 1e6);
}

/// What of the board is written.
model::SolidPlan planOf(const model::Document& board, std::size_t solids) {
    base::Progress progress;
    model::SolidChoice choice;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        if (board.layers[row].isCopper()) {
            choice.layers.emplace_back(static_cast<std::uint32_t>(row));
        }
    }
    model::SolidPlan plan = *model::planSolids(board, choice, progress);
    app::thinOut(plan, solids);
    return plan;
}

/// The shape of a file.
TopoDS_Shape read(const fs::path& path) {
    STEPControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
        std::fprintf(stderr, "the file cannot be read back\n");
        std::exit(1);
    }
    reader.TransferRoots();
    return reader.OneShape();
}

std::size_t solidsIn(const TopoDS_Shape& shape) {
    std::size_t count = 0;
    for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next()) {
        ++count;
    }
    return count;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: step_bench BOARD [SOLIDS [alone [polylines]]]\n");
        return 1;
    }
    Message::DefaultMessenger()->ChangePrinters().Clear();
    base::Progress progress;
    const auto board = model::readBoard(argv[1], {}, progress);
    if (!board) {
        std::fprintf(stderr, "%s\n", board.error().text.c_str());
        return 2;
    }
    const model::SolidPlan plan =
        planOf(**board, argc > 2 ? static_cast<std::size_t>(std::max(std::atol(argv[2]), 1L)) : 2000);
    const fs::path ours = fs::temp_directory_path() / "step_bench_ours.step";
    const fs::path theirs = fs::temp_directory_path() / "step_bench_theirs.step";
    model::StepOptions options;
    options.isWrittenOut = true;
    options.hasPolylines = argc > 4;
    std::size_t written = 0;
    double seconds = std::numeric_limits<double>::max();
    for (int run = 0; run < 3; ++run) {
        seconds =
            std::min(seconds, secondsOf([&] { written = model::exportStep(plan, options, ours, progress)->solids; }));
    }
    print("Copperscope", written, seconds, ours);
    if (argc > 3) {
        fs::remove(ours);
        return 0;
    }

    const TopoDS_Shape shape = read(ours);
    STEPControl_Writer writer;
    const double theirSeconds = secondsOf([&] {
        writer.Transfer(shape, STEPControl_AsIs);
        writer.Write(theirs.c_str());
    });
    print("OpenCASCADE", solidsIn(shape), theirSeconds, theirs);
    std::printf("ratio %.1f\n",
                theirSeconds / seconds * static_cast<double>(written) / static_cast<double>(solidsIn(shape)));
    fs::remove(ours);
    fs::remove(theirs);
    return 0;
}
