#include "app/commands/verify_command.h"

#include <cstdio>

#include "app/common/console_progress.h"
#include "app/common/interrupt.h"
#include "app/common/temporary_folder.h"
#include "app/verify/step_file.h"
#include "app/verify/verify_report.h"
#include "model/export/solids/step_export.h"

namespace app {

using base::Result;
using model::Document;
using model::SolidPlan;

namespace {

Result<SolidPlan> planFor(const Document& board, const VerifyArguments& arguments, base::Progress& progress) {
    model::SolidChoice choice;
    for (const std::string& name : arguments.layers) {
        ASSIGN_OR_RETURN(const model::LayerId layer, findLayer(board, name));
        choice.layers.push_back(layer);
    }
    choice.isAsDesigned = true;  // figures know nothing of milling
    ASSIGN_OR_RETURN(SolidPlan plan, model::planSolids(board, choice, progress));
    if (arguments.sample > 0) {
        thinOut(plan, arguments.sample);
    }
    return plan;
}

/// Those of the file that is named, or of one that is written for it and goes once it is read, or when a signal comes.
Result<std::unique_ptr<StepFile>> readSolids(const SolidPlan& plan, const VerifyArguments& arguments,
                                             base::Progress& progress) {
    const Interrupt interrupt(progress);
    if (!arguments.step.empty()) {
        return StepFile::read(arguments.step, arguments.isStrict, progress);
    }
    ASSIGN_OR_RETURN(const TemporaryFolder folder, TemporaryFolder::make());
    const std::filesystem::path path = folder.path() / "board.step";
    model::StepOptions options;
    options.hasPolylines = arguments.hasPolylines;
    ASSIGN_OR_RETURN(const model::SolidReport written, model::exportStep(plan, options, path, progress));
    std::fprintf(stderr, "%.1f MB written\n", static_cast<double>(written.bytes) / 1e6);
    return StepFile::read(path, arguments.isStrict, progress);
}

Result<VerifyReport> verify(const Document& board, const VerifyArguments& arguments, base::Progress& progress) {
    ASSIGN_OR_RETURN(const SolidPlan plan, planFor(board, arguments, progress));
    ASSIGN_OR_RETURN(const std::unique_ptr<StepFile> read, readSolids(plan, arguments, progress));
    if (progress.isCancelled()) {  // by a signal at the last moment; from here on it ends the program itself
        return base::Error{base::ErrorCode::Cancelled, "verifying was cancelled"};
    }
    VerifyReport report;
    compareSolids(*read, expectedSolids(plan, model::StepOptions().limits), report);
    progress.beginPhase("Comparing points");
    report.points = comparePoints(plan, *read, arguments.points, 1);
    if (!arguments.noPictures) {
        ASSIGN_OR_RETURN(report.pictures, comparePictures(board, discretisationOf(arguments.board), progress));
    }
    return report;
}

}  // namespace

Outcome runVerify(const VerifyArguments& arguments) {
    RETURN_IF_ERROR(StepFile::checkReader());
    ConsoleProgress console;
    ASSIGN_OR_RETURN(const auto board, openDocument(arguments.board, console.progress()));
    ASSIGN_OR_RETURN(const VerifyReport report, verify(*board, arguments, console.progress()));
    const std::string text = arguments.asJson ? verifyJson(report) : verifyText(report);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return int{report.isPassed() ? kDone : kTooClose};
}

}  // namespace app
