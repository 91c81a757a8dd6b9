#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/generate/layout.h"
#include "model/generate/text_sink.h"

namespace model::generate {

/// A file of the job: its path inside, and what writes its text. Writing twice gives the same bytes, so that a file's
/// size can be known before it is written without keeping it.
struct JobFile {
    std::string path;
    std::function<void(TextSink&)> write;
};

/// All files of an ODB++ 8.1 job that shows `layout`: matrix, features by layer, tools, nets, profile, thicknesses. The
/// layout must outlive them. Writers return early when `progress` is cancelled.
[[nodiscard]] std::vector<JobFile> jobFiles(const Layout& layout, const base::Progress& progress);

}  // namespace model::generate
