#include "model/formats/odb/step/step.h"

#include <algorithm>
#include <atomic>
#include <functional>

#include "model/base/parallel.h"
#include "model/formats/odb/stackup/layer_facts.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

void readHeader(const JobContext& job, StepData& step) {
    Parsed<StepHeader>& header = step.header;
    if (const auto file = job.tree.read(step.folder + "/stephdr", header.diagnostics)) {
        header.path = file->path;
        header.value = parseStepHeader(file->text(), file->path, job.defaultUnit, header.diagnostics);
    }
}

}  // namespace

std::size_t findStep(const Steps& steps, std::string_view name) {
    const auto location =
        std::ranges::find_if(steps, [name](const StepData& s) { return equalsIgnoringCase(s.name, name); });
    return static_cast<std::size_t>(location - steps.begin());
}

Steps collectSteps(const JobContext& job, const std::string& name, Diagnostics& diagnostics) {
    Steps steps;
    std::vector<std::string> wanted{name};
    for (std::size_t next = 0; next < wanted.size(); ++next) {
        if (findStep(steps, wanted[next]) < steps.size()) {
            continue;
        }
        const std::string folder = "steps/" + wanted[next];
        if (!job.tree.hasFolder(folder)) {
            diagnostics.report(Severity::Error, folder, 0,
                               "step " + wanted[next] + " has no folder; its copies are missing");
            continue;
        }
        StepData step;
        step.name = wanted[next];
        step.folder = folder;
        step.layers.resize(job.matrix.layers.size());
        readHeader(job, step);
        for (const StepRepeat& repeat : step.header.value.repeats) {
            wanted.push_back(repeat.step);
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

namespace {

/// One file to parse, with its size so that the largest go first.
struct Task {
    std::uint64_t size = 0;
    std::function<void()> run;
};

class TaskList {
public:
    explicit TaskList(const JobContext& job) : m_job(job) {}

    /// Plans `parse(text, path, diagnostics)` for a file, if it exists.
    template <class T, class Parse>
    void add(const std::string& path, Parsed<T>& into, Parse parse) {
        if (!m_job.tree.has(path)) {
            return;
        }
        m_tasks.push_back({m_job.tree.storedSize(path), [this, path, &into, parse] {
                               if (const auto file = m_job.tree.read(path, into.diagnostics)) {
                                   into.path = file->path;
                                   into.value = parse(file->text(), file->path, into.diagnostics);
                               }
                           }});
    }

    void addStep(StepData& step) {
        const auto features = [unit = m_job.defaultUnit](std::string_view text, std::string_view path, Diagnostics& d) {
            return parseFeatures(text, path, unit, d);
        };
        add(step.folder + "/profile", step.profile, features);
        add(step.folder + "/zones", step.zones,
            [unit = m_job.defaultUnit](std::string_view text, std::string_view path, Diagnostics& d) {
                return parseZones(text, path, unit, d);
            });
        add(step.folder + "/eda/data", step.eda, [this](std::string_view text, std::string_view path, Diagnostics& d) {
            return parseEda(text, path, m_job.defaultUnit, m_layerNames, *m_job.attributeTypes, d);
        });
        addNetlists(step);
        for (std::size_t i = 0; i < step.layers.size(); ++i) {
            if (isFirstOfName(i)) {
                addLayer(step, i, features);
            }
        }
    }

    void setLayerNames() {
        for (const MatrixLayer& layer : m_job.matrix.layers) {
            m_layerNames.push_back(layer.name);
        }
    }

    bool run(base::Progress& progress) {
        std::ranges::stable_sort(m_tasks, std::greater<>(), &Task::size);
        std::uint64_t total = 1;
        for (const Task& task : m_tasks) {
            total += task.size;
        }
        std::atomic<std::uint64_t> done{0};
        base::parallelFor(m_tasks.size(), [&](std::size_t i) {
            if (!progress.isCancelled()) {
                m_tasks[i].run();
                done += m_tasks[i].size;
                progress.setFraction(static_cast<float>(static_cast<double>(done) / static_cast<double>(total)));
            }
        });
        return !progress.isCancelled();
    }

private:
    /// A name may be listed twice (a dielectric of two plies); its folder belongs to the first row.
    [[nodiscard]] bool isFirstOfName(std::size_t row) const {
        for (std::size_t i = 0; i < row; ++i) {
            if (equalsIgnoringCase(m_layerNames[i], m_layerNames[row])) {
                return false;
            }
        }
        return true;
    }

    void addNetlists(StepData& step) {
        constexpr const char* kFolders[] = {"cadnet", "refnet", "curcadnet"};
        for (std::size_t i = 0; i < step.netlists.size(); ++i) {
            add(step.folder + "/netlists/" + kFolders[i] + "/netlist", step.netlists[i],
                [unit = m_job.defaultUnit](std::string_view text, std::string_view path, Diagnostics& d) {
                    return parseNetlist(text, path, unit, d);
                });
        }
    }

    template <class Parse>
    void addLayer(StepData& step, std::size_t row, const Parse& features) {
        const MatrixLayer& layer = m_job.matrix.layers[row];
        const std::string folder = step.folder + "/layers/" + layer.name;
        StepLayer& into = step.layers[row];
        add(folder + "/features", into.features, features);
        add(folder + "/profile", into.profile, features);
        add(folder + "/attrlist", into.facts,
            [this, &layer](std::string_view text, std::string_view path, Diagnostics& d) {
                return factsOf(AttributeList(text, path, m_job.defaultUnit, d), layer, path, d);
            });
        if (layer.isHoles()) {
            add(folder + "/tools", into.tools,
                [](std::string_view text, std::string_view path, Diagnostics& d) { return parseTools(text, path, d); });
        }
        if (layer.type == LayerType::Component) {
            add(folder + "/components", into.components,
                [this](std::string_view text, std::string_view path, Diagnostics& d) {
                    return parseComponents(text, path, m_job.defaultUnit, *m_job.attributeTypes, d);
                });
        }
    }

    const JobContext& m_job;
    std::vector<Task> m_tasks;
    std::vector<std::string> m_layerNames;
};

}  // namespace

bool readSteps(const JobContext& job, Steps& steps, base::Progress& progress) {
    TaskList tasks(job);
    tasks.setLayerNames();
    for (StepData& step : steps) {
        tasks.addStep(step);
    }
    return tasks.run(progress);
}

}  // namespace model::odb
