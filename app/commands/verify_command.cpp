#include "app/commands/verify_command.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "app/common/console_progress.h"
#include "app/verify/step_file.h"
#include "app/verify/verify_report.h"
#include "model/export/solids/step_export.h"

namespace app {

namespace fs = std::filesystem;
using base::Result;
using model::Document;
using model::SolidPlan;

namespace {

/// The file to read back: the user's, or one of ours that goes when this does.
class VerifiedFile {
public:
    explicit VerifiedFile(const std::string& named)
        : m_isOurs(named.empty()),
          m_path(m_isOurs ? fs::temp_directory_path() / ("copperscope-verify-" + std::to_string(::getpid()) + ".step")
                          : fs::path(named)) {}
    ~VerifiedFile() {
        std::error_code error;
        if (m_isOurs) {
            fs::remove(m_path, error);
        }
    }
    VerifiedFile(const VerifiedFile&) = delete;
    VerifiedFile& operator=(const VerifiedFile&) = delete;

    [[nodiscard]] const fs::path& path() const { return m_path; }
    [[nodiscard]] bool isOurs() const { return m_isOurs; }

private:
    bool m_isOurs;
    fs::path m_path;
};

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

Result<VerifyReport> verify(const Document& board, const VerifyArguments& arguments, base::Progress& progress) {
    ASSIGN_OR_RETURN(const SolidPlan plan, planFor(board, arguments, progress));
    const VerifiedFile file(arguments.step);
    model::StepOptions options;
    options.hasPolylines = arguments.hasPolylines;
    if (file.isOurs()) {
        ASSIGN_OR_RETURN(const model::SolidReport written, model::exportStep(plan, options, file.path(), progress));
        std::fprintf(stderr, "%.1f MB written\n", static_cast<double>(written.bytes) / 1e6);
    }
    progress.beginPhase("Reading solids");
    ASSIGN_OR_RETURN(const std::unique_ptr<StepFile> read, StepFile::read(file.path(), arguments.isStrict));
    VerifyReport report;
    compareSolids(*read, expectedSolids(plan, options.limits), report);
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
