#include "model/formats/drawing/assembly.h"

#include "model/base/stopwatch.h"
#include "model/formats/drawing/copy_plan.h"
#include "model/formats/drawing/step_assembly.h"

namespace model::formats {

namespace {

void describe(JobInfo& info, const DrawnJob& job) {
    info = job.info;
    info.steps.clear();
    for (const DrawnStep& step : job.steps) {
        info.steps.push_back(step.name);
    }
    info.step = job.steps[0].name;
}

/// The document of a step that others hold copies of.
std::shared_ptr<const Document> assembleCopied(const AssemblyParts& parts, std::size_t step, const JobInfo& info) {
    DocumentBuilder builder;
    builder.job() = info;
    builder.job().step = parts.job.steps[step].name;
    parts.layers.copyTo(builder, step);
    return assembleStep(parts, step, builder) ? builder.finish() : nullptr;
}

bool assembleAll(const DrawnJob& job, DocumentBuilder& builder, base::Progress& progress) {
    LayerRows layers(job, builder);
    layers.add();
    const std::vector<CopyPlan> plans = planCopies(job, builder.diagnostics());
    StepDocuments documents(job.steps.size());
    StepProgress stepProgress(progress, job.steps.size() * layers.order().size());
    const AssemblyParts parts{job, layers, plans, documents, stepProgress};
    const auto build = [&](std::size_t step) { return assembleCopied(parts, step, builder.job()); };
    if (!buildCopiedSteps(plans, documents, build) || !assembleStep(parts, 0, builder)) {
        return false;
    }
    for (const auto& document : documents) {
        if (document != nullptr) {
            builder.diagnostics().append(messagesOfCopies(*document, builder.soFar()));
        }
    }
    return true;
}

}  // namespace

base::Result<std::shared_ptr<const Document>> assemble(DrawnJob job, double parseMs, base::Progress& progress) {
    const base::Stopwatch creating;
    progress.beginPhase("Building the board");
    if (job.steps.empty()) {
        job.steps.emplace_back();
    }
    DocumentBuilder builder;
    describe(builder.job(), job);
    builder.diagnostics().append(job.diagnostics);
    if (!assembleAll(job, builder, progress)) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    builder.times().parseMs = parseMs;
    builder.times().createMs = creating.milliseconds();
    return builder.finish();
}

}  // namespace model::formats
