#include "app/commands/generate_command.h"

#include <algorithm>
#include <cmath>

#include "app/common/console_progress.h"
#include "app/common/interrupt.h"
#include "model/generate/job_writer.h"
#include "model/generate/model_writer.h"

namespace app {

namespace {

base::Result<model::generate::Wanted> wantedBy(const GenerateArguments& arguments) {
    const model::generate::PaperModel* model = model::generate::findPaperModel(arguments.like);
    if (model == nullptr) {
        return base::Error{base::ErrorCode::BadUsage, "the paper has no model " + arguments.like};
    }
    if (arguments.isNurbs && !arguments.output.ends_with(".txt")) {
        return base::Error{base::ErrorCode::BadUsage,
                           arguments.output + ": ODB++ has no NURBS; boards with them are written as .txt"};
    }
    if (!arguments.isNurbs && !arguments.output.ends_with(".tgz") && !arguments.output.ends_with(".tar.gz")) {
        return base::Error{base::ErrorCode::BadUsage, arguments.output + ": jobs are written as .tgz"};
    }
    model::generate::Wanted wanted{{}, model->tracksPerTrail, arguments.seed};
    std::ranges::transform(model->counts, wanted.counts.begin(), [&](std::uint64_t count) {
        return static_cast<std::uint64_t>(std::llround(static_cast<double>(count) * arguments.scale));
    });
    return wanted;
}

}  // namespace

Outcome runGenerate(const GenerateArguments& arguments) {
    ASSIGN_OR_RETURN(const model::generate::Wanted wanted, wantedBy(arguments));
    ConsoleProgress console;
    const Interrupt interrupt(console.progress());
    const auto write = arguments.isNurbs ? model::generate::writeModel : model::generate::writeJob;
    RETURN_IF_ERROR(write(wanted, arguments.output, console.progress()));
    return int{kDone};
}

}  // namespace app
