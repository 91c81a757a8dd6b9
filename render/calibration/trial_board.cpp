#include "render/calibration/trial_board.h"

#include <string>
#include <string_view>
#include <utility>

#include "model/formats/common/archive.h"
#include "model/formats/odb/odb_reader.h"
#include "model/generate/job_text.h"

namespace render {
namespace {

using model::formats::Archive;

Archive jobInMemory(const model::generate::Layout& layout, const base::Progress& progress) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const model::generate::JobFile& file : model::generate::jobFiles(layout, progress)) {
        std::string& text = files.emplace_back(file.path, "").second;
        model::generate::TextSink sink([&text](std::string_view piece) { text += piece; });
        file.write(sink);
    }
    return Archive::of(std::move(files));
}

}  // namespace

base::Result<TrialBoard> makeTrialBoard(const model::generate::Wanted& wanted, base::Progress& progress) {
    const model::generate::Layout layout(wanted);
    const Archive job = jobInMemory(layout, progress);
    if (progress.isCancelled()) {  // then files may be incomplete
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    ASSIGN_OR_RETURN(const auto document, model::odb::readJob(job, "trial", {}, {}, progress));
    ASSIGN_OR_RETURN(BoardModel model, buildBoardModel(*document, {}, progress));
    return TrialBoard{std::move(model), defaultStyles(*document)};
}

}  // namespace render
