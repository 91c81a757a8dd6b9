#include "model/formats/odb/odb_reader.h"

#include <algorithm>
#include <optional>

#include "model/formats/common/archive.h"
#include "model/formats/odb/elements/tool_units.h"
#include "model/formats/odb/job_builder.h"
#include "model/formats/odb/job_info.h"
#include "model/formats/odb/repeated_drills.h"
#include "model/formats/odb/stackup/layer_facts.h"
#include "model/formats/odb/text/job_tree.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

base::Error inJob(const std::filesystem::path& path, const std::string& text) {
    return {base::ErrorCode::BadInput, path.string() + ": " + text};
}

base::Error cancelled() {
    return {base::ErrorCode::Cancelled, "cancelled"};
}

MiscInfo readInfo(const formats::FileTree& tree, Diagnostics& diagnostics) {
    const auto file = tree.read("misc/info", diagnostics);
    return file ? parseInfo(file->text(), file->path, diagnostics) : MiscInfo{};
}

bool hasOwnFeatures(const formats::FileTree& tree, const Matrix& matrix, const std::string& step) {
    for (const MatrixLayer& layer : matrix.layers) {
        if (tree.storedSize("steps/" + step + "/layers/" + layer.name + "/features") > 0) {
            return true;
        }
    }
    return false;
}

/// The steps of the matrix that exist, or those that exist where the matrix names none.
std::vector<std::string> stepsOf(const formats::FileTree& tree, const Matrix& matrix, Diagnostics& diagnostics) {
    std::vector<std::string> steps;
    for (const std::string& step : matrix.steps) {
        if (tree.hasFolder("steps/" + step)) {
            steps.push_back(step);
        } else {
            diagnostics.report(Severity::Warning, "matrix/matrix", 0,
                               "step " + step + " is in the matrix, but has no folder");
        }
    }
    return steps.empty() ? tree.foldersIn("steps") : steps;
}

base::Result<std::string> chooseStep(const formats::FileTree& tree, const Matrix& matrix,
                                     const std::vector<std::string>& steps, const std::string& wanted) {
    std::string list;
    for (const std::string& step : steps) {
        if (!wanted.empty() && equalsIgnoringCase(step, wanted)) {
            return step;
        }
        list += (list.empty() ? "" : ", ") + step;
    }
    if (!wanted.empty()) {
        return base::Error{base::ErrorCode::BadUsage, "the job has no step \"" + wanted + "\"; it has: " + list};
    }
    for (const std::string& step : steps) {
        if (hasOwnFeatures(tree, matrix, step)) {
            return step;
        }
    }
    if (steps.empty()) {
        return base::Error{base::ErrorCode::BadInput, "the job has no steps"};
    }
    return steps.front();
}

/// The unit the job's files are mostly in, for display only.
std::string displayUnit(const MiscInfo& info, const Steps& steps) {
    std::optional<Unit> unit = info.unit;
    for (const StepLayer& layer : steps[0].layers) {
        if (!unit && layer.features.isPresent()) {
            unit = layer.features.value.unit;
        }
    }
    return unit.value_or(Unit::Inch) == Unit::Inch ? "INCH" : "MM";
}

std::string stem(const std::filesystem::path& path) {
    std::string name = path.filename().empty() ? path.parent_path().filename().string() : path.filename().string();
    for (const std::string_view ending : {".tgz", ".tar.gz", ".tar", ".zip"}) {
        if (name.size() > ending.size() &&
            equalsIgnoringCase(std::string_view(name).substr(name.size() - ending.size()), ending)) {
            return name.substr(0, name.size() - ending.size());
        }
    }
    return name;
}

void describe(JobInfo& job, const MiscInfo& info, const formats::FileTree& tree, const Steps& steps,
              const std::filesystem::path& path) {
    const std::string folder = tree.name();
    job.name = !info.jobName.empty() ? info.jobName : !folder.empty() && folder != "odb" ? folder : stem(path);
    job.generator = !info.generator.empty() ? info.generator : steps[0].eda.value.generator;
    job.version = info.version;
    job.units = displayUnit(info, steps);
    job.step = steps[0].name;
}

/// Two boards in one folder look like one.
void reportOthers(const formats::Archive& archive, const formats::FileTree& tree, Diagnostics& diagnostics) {
    std::string names;
    for (const std::string& other : otherJobs(archive)) {
        names += (names.empty() ? "" : ", ") + other;
    }
    if (!names.empty()) {
        diagnostics.report(Severity::Warning, {}, 0,
                           "several ODB++ jobs lie here; " + tree.name() + " is shown, and not: " + names);
    }
}

}  // namespace

std::vector<formats::FormPart> jobsIn(const formats::Archive& archive) {
    const base::Result<formats::FileTree> tree = findJob(archive);
    if (!tree) {
        return {};
    }
    Diagnostics ignored;  // reading the job reports them
    const auto file = tree->read("matrix/matrix", ignored);
    const Matrix matrix = file ? parseMatrix(file->text(), file->path, ignored) : Matrix{};
    const auto copper = std::ranges::count_if(matrix.layers, &MatrixLayer::isCopper);
    std::string contents = std::to_string(matrix.layers.size()) + " layers, " + std::to_string(copper) + " of copper";
    if (matrix.steps.size() > 1) {
        contents += ", " + std::to_string(matrix.steps.size()) + " steps";
    }
    return {{"", contents}};
}

base::Result<std::shared_ptr<const Document>> readJob(const formats::Archive& archive,
                                                      const std::filesystem::path& name,
                                                      const formats::ReadOptions& options, const Diagnostics& unpacking,
                                                      base::Progress& progress, const base::Stopwatch& reading) {
    DocumentBuilder builder;
    Diagnostics& diagnostics = builder.diagnostics();
    diagnostics.append(unpacking);
    const base::Result<formats::FileTree> tree = findJob(archive);
    if (!tree) {
        return inJob(name, tree.error().text);
    }
    reportOthers(archive, *tree, diagnostics);
    const MiscInfo info = readInfo(*tree, diagnostics);
    const auto matrixFile = tree->read("matrix/matrix", diagnostics);
    if (!matrixFile) {
        return inJob(name, "matrix/matrix cannot be read");
    }
    Matrix matrix = parseMatrix(matrixFile->text(), matrixFile->path, diagnostics);
    builder.job().steps = stepsOf(*tree, matrix, diagnostics);
    const base::Result<std::string> step = chooseStep(*tree, matrix, builder.job().steps, options.step);
    if (!step) {
        return base::Error{step.error().code, name.string() + ": " + step.error().text};
    }

    progress.beginPhase("Reading layers");
    const AttributeTypes attributeTypes(*tree, diagnostics);
    const JobContext job{*tree, matrix, info.unit.value_or(Unit::Inch), &attributeTypes};
    Steps steps = collectSteps(job, *step, diagnostics);
    if (!readSteps(job, steps, progress)) {
        return cancelled();
    }
    fitToolUnits(job, steps);
    setRepeatedDrillsAside(matrix, steps, diagnostics);
    describe(builder.job(), info, *tree, steps, name);
    builder.times().parseMs = reading.milliseconds();

    const base::Stopwatch creating;
    progress.beginPhase("Building the board");
    if (!buildJob(job, steps, boardThicknessIn(*tree, "misc/attrlist", job.defaultUnit, diagnostics), builder,
                  progress)) {
        return cancelled();
    }
    builder.times().createMs = creating.milliseconds();
    return builder.finish();
}

}  // namespace model::odb
