#include "model/formats/gerber/assigned_files.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "model/formats/gerber/layer_map.h"

namespace model::gerber {

namespace {

namespace fs = std::filesystem;

/// An image alone that nothing tells the layer of is shown as copper, so that there is a board to look at.
void takeAsCopper(std::vector<ReadFile>& files) {
    const bool isAlone = std::ranges::count_if(files, &ReadFile::isImage) == 1;
    const auto image = std::ranges::find_if(files, &ReadFile::isImage);
    if (isAlone && image->kind == ReadFile::Kind::Gerber && !image->role.isKnown()) {
        image->role.kind = FileRole::Kind::Copper;
        image->role.side = LayerSide::Top;
        image->role.source = RoleSource::Content;
    }
}

/// What all job files say.
JobFileFacts factsOf(const std::vector<ReadFile>& files) {
    JobFileFacts job;
    for (const ReadFile& file : files) {
        if (file.kind == ReadFile::Kind::Job) {
            job.functions.insert(file.job.functions.begin(), file.job.functions.end());
            job.polarities.insert(file.job.polarities.begin(), file.job.polarities.end());
        }
    }
    return job;
}

void apply(const LayerMap& map, const std::string& mapName, AssignedFiles& job) {
    std::set<std::string> used;
    for (ReadFile& file : job.files) {
        const LayerMap::Row* row = map.find(file.path);
        if (row == nullptr) {
            continue;
        }
        used.insert(row->file);
        const bool isIgnored = row->role.kind == FileRole::Kind::Ignored;
        if (!isIgnored && !file.isImage()) {
            job.diagnostics.report(Severity::Warning, mapName, row->line,
                                   "the file of this row of the layer map holds neither an image nor drills");
            continue;
        }
        file.role = row->role;
        if (isIgnored) {
            file.diagnostics = {};
            file.diagnostics.report(Severity::Info, file.path, 0, "left out, as the layer map says");
        }
    }
    for (const LayerMap::Row& row : map.rows()) {
        if (!used.contains(row.file)) {
            job.diagnostics.report(Severity::Warning, mapName, row.line,
                                   "the layer map names \"" + row.file + "\", but the job has no such file");
        }
    }
}

base::Status applyMap(const fs::path& path, const formats::ReadOptions& options, AssignedFiles& job) {
    const fs::path beside = layerMapBeside(path);
    std::error_code error;
    const bool isTold = !options.layerMap.empty();
    if (!isTold && !fs::is_regular_file(beside, error)) {
        return base::Done{};
    }
    const fs::path file = isTold ? options.layerMap : beside;
    const std::string name = file.filename().string();
    const base::Result<LayerMap> map = readLayerMap(file, job.diagnostics);
    if (!map && isTold) {
        return map.error();
    }
    if (!map) {
        job.diagnostics.report(Severity::Warning, name, 0, "the layer map beside the job cannot be read");
        return base::Done{};
    }
    job.diagnostics.report(Severity::Info, name, 0, "what files draw is as this layer map says");
    apply(*map, name, job);
    return base::Done{};
}

/// Why there is no image. What is neither image nor netlist is not parsed: an error of such a file is that it cannot be
/// read.
base::Error noImage(const std::vector<ReadFile>& files, const fs::path& path) {
    bool hasJobFile = false;
    for (const ReadFile& file : files) {
        if (file.kind == ReadFile::Kind::Other && file.diagnostics.count(Severity::Error) > 0) {
            return {base::ErrorCode::BadInput, file.diagnostics.entries().front().text};
        }
        hasJobFile = hasJobFile || file.kind == ReadFile::Kind::Job;
    }
    return {base::ErrorCode::BadInput, path.string() + ": " +
                                           (hasJobFile ? "the job file lists images, but none of them is beside it"
                                                       : "there is no Gerber image and no drill file in it")};
}

/// `options`: none if no layer map counts.
base::Result<AssignedFiles> assign(std::vector<ReadFile> files, const fs::path& path,
                                   const formats::ReadOptions* options) {
    AssignedFiles job{std::move(files), {}, {}};
    if (std::ranges::none_of(job.files, &ReadFile::isImage)) {
        return noImage(job.files, path);
    }
    moveFarJob(job.files);
    assignRoles(job.files, factsOf(job.files));
    if (options != nullptr) {
        RETURN_IF_ERROR(applyMap(path, *options, job));
    }
    if (std::ranges::none_of(job.files, &ReadFile::isImage)) {
        return base::Error{base::ErrorCode::BadInput, path.string() + ": the layer map leaves out all files"};
    }
    takeAsCopper(job.files);
    job.boards = boardsOf(job.files);
    return job;
}

}  // namespace

base::Result<AssignedFiles> assignFiles(std::vector<ReadFile> files, const fs::path& path,
                                        const formats::ReadOptions& options) {
    return assign(std::move(files), path, &options);
}

base::Result<AssignedFiles> assignWithoutMap(std::vector<ReadFile> files, const fs::path& path) {
    return assign(std::move(files), path, nullptr);
}

}  // namespace model::gerber
