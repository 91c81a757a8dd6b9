#include "app/bench/bench_tables.h"

#include <cmath>

#include "app/common/commit.h"
#include "model/text/formatting.h"

namespace app {

using nlohmann::ordered_json;

namespace {

constexpr double kMegabyte = 1e6;

ordered_json elementsJson(const BoardResult& board) {
    ordered_json json;
    for (std::size_t kind = 0; kind < board.elements.size(); ++kind) {
        json[model::toString(static_cast<model::ElementKind>(kind))] = board.elements[kind];
    }
    json["total"] = board.elementCount();
    return json;
}

ordered_json framesJson(const std::vector<FrameResult>& frames) {
    ordered_json json = ordered_json::array();
    for (const FrameResult& frame : frames) {
        ordered_json& entry = json.emplace_back(ordered_json{{"view", frame.view},
                                                             {"backend", frame.backend},
                                                             {"is_auto", frame.isAuto},
                                                             {"culling", frame.isCulled},
                                                             {"ms", frame.ms},
                                                             {"triangles", frame.triangles}});
        if (frame.greyMse >= 0.0) {
            entry["grey_mse"] = frame.greyMse;
        }
        if (!frame.stageMs.empty()) {
            entry["stages_ms"] = frame.stageMs;
        }
    }
    return json;
}

ordered_json pipelineJson(const PipelineResult& pipeline) {
    return {{"parse_ms", pipeline.parseMs},           {"create_ms", pipeline.createMs},
            {"discretise_ms", pipeline.discretiseMs}, {"triangulate_ms", pipeline.triangulateMs},
            {"upload_ms", pipeline.uploadMs},         {"gpu_bytes", pipeline.gpuBytes},
            {"cpu_bytes", pipeline.cpuBytes},         {"triangles", pipeline.triangles},
            {"frames", framesJson(pipeline.frames)}};
}

/// The exponent of cost ~ elements^exponent by least squares over several boards; 0 for fewer than two different sizes
/// or a cost of 0.
double growthExponent(const std::vector<std::pair<double, double>>& elementsAndCost) {
    double n = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const auto& [elements, cost] : elementsAndCost) {
        if (elements > 0.0 && cost > 0.0) {
            n += 1.0;
            x += std::log(elements);
            y += std::log(cost);
            xx += std::log(elements) * std::log(elements);
            xy += std::log(elements) * std::log(cost);
        }
    }
    const double spread = n * xx - x * x;
    return spread > 1e-9 ? (n * xy - x * y) / spread : 0.0;
}

/// A cost of one pipeline over all boards that were measured with it.
template <class Cost>
double exponentOf(const BenchReport& report, const std::string& pipeline, const Cost& cost) {
    std::vector<std::pair<double, double>> points;
    for (const BoardResult& board : report.boards) {
        for (const PipelineResult& result : board.pipelines) {
            if (result.name == pipeline) {
                points.emplace_back(static_cast<double>(board.elementCount()), cost(result));
            }
        }
    }
    return growthExponent(points);
}

double modellingExponent(const BenchReport& report, const std::string& pipeline) {
    return exponentOf(report, pipeline, [](const PipelineResult& result) { return result.modellingMs(); });
}

double memoryExponent(const BenchReport& report, const std::string& pipeline) {
    return exponentOf(report, pipeline,
                      [](const PipelineResult& result) { return static_cast<double>(result.gpuBytes); });
}

std::string modellingTable(const BenchReport& report) {
    std::string text = "\nModelling, ms (Table 4), stored triangles and memory (Table 2)\n";
    text += model::formatted("%-32s %9s %-9s %8s %8s %8s %8s %8s %11s %9s %9s\n", "board", "elements", "pipeline",
                             "parse", "create", "discret.", "triang.", "upload", "triangles", "GPU MB", "CPU MB");
    for (const BoardResult& board : report.boards) {
        for (const PipelineResult& p : board.pipelines) {
            text += model::formatted(
                "%-32s %9llu %-9s %8.1f %8.1f %8.1f %8.1f %8.1f %11llu %9.1f %9.1f\n", board.name.c_str(),
                static_cast<unsigned long long>(board.elementCount()), p.name.c_str(), p.parseMs, p.createMs,
                p.discretiseMs, p.triangulateMs, p.uploadMs, static_cast<unsigned long long>(p.triangles),
                static_cast<double>(p.gpuBytes) / kMegabyte, static_cast<double>(p.cpuBytes) / kMegabyte);
        }
    }
    return text;
}

/// Nothing where none were timed.
std::string stagesLine(const FrameResult& frame) {
    std::string text;
    for (const auto& [name, ms] : frame.stageMs) {
        text += model::formatted("%s%s %.3f", text.empty() ? "    " : ", ", name.c_str(), ms);
    }
    return text.empty() ? text : text + "\n";
}

std::string frameTable(const BenchReport& report) {
    std::string text = "\nFrames of 1920x1080, median ms (Table 5); * is what auto takes\n";
    text += model::formatted("%-32s %-6s %-10s %-8s %10s %12s %10s\n", "board", "view", "back end", "culling", "ms",
                             "triangles", "grey MSE");
    for (const BoardResult& board : report.boards) {
        for (const PipelineResult& pipeline : board.pipelines) {
            for (const FrameResult& f : pipeline.frames) {
                text += model::formatted("%-32s %-6s %-10s %-8s %10.2f %12llu", board.name.c_str(), f.view.c_str(),
                                         (f.backend + (f.isAuto ? " *" : "")).c_str(), f.isCulled ? "yes" : "no", f.ms,
                                         static_cast<unsigned long long>(f.triangles));
                text += f.greyMse >= 0.0 ? model::formatted(" %10.6f\n", f.greyMse) : "\n";
                text += stagesLine(f);
            }
        }
    }
    return text;
}

}  // namespace

ordered_json benchJson(const BenchReport& report) {
    ordered_json boards = ordered_json::array();
    for (const BoardResult& board : report.boards) {
        ordered_json pipelines = ordered_json::object();
        for (const PipelineResult& pipeline : board.pipelines) {
            pipelines[pipeline.name] = pipelineJson(pipeline);
        }
        boards.push_back({{"name", board.name}, {"elements", elementsJson(board)}, {"pipelines", pipelines}});
    }
    ordered_json growth;
    for (const char* pipeline : {"hybrid", "standard"}) {
        growth[pipeline] = {{"modelling_exponent", modellingExponent(report, pipeline)},
                            {"gpu_bytes_exponent", memoryExponent(report, pipeline)}};
    }
    return {{"device", report.device}, {"commit", kCommit}, {"boards", boards}, {"growth", growth}};
}

std::string benchTable(const BenchReport& report) {
    std::string text = report.device + "; commit " + kCommit + "\n";
    text += modellingTable(report) + frameTable(report);
    for (const char* pipeline : {"hybrid", "standard"}) {
        if (const double exponent = modellingExponent(report, pipeline); exponent != 0.0) {
            text += model::formatted("\n%s: modelling grows with elements^%.3f, GPU memory with elements^%.3f",
                                     pipeline, exponent, memoryExponent(report, pipeline));
        }
    }
    return text + "\n";
}

}  // namespace app
